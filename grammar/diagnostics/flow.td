// Messages about program flow: labels, routines, loops, skipped ranges, the step ladder.
//
// What may stand inside of what is the controller's nesting table: one message for each range that is around.

class FlowError<string id, string text> : Error<id, text> { let family = "tp03"; }
class FlowWarning<string id, string text> : Warning<id, text> { let family = "tp03"; }

// ---------------------------------------------------------------------------------------------- labels
def LabelTwice : FlowError<"label-twice", "{label} is placed a second time"> {
  let explanation = [{A label is one place of the program, so each number can be placed once.}];
  let wrong = "LD X0\nCJ P8\nLD X1\nOUT Y1\nP8\nLD X2\nOUT Y2\nP8\nLD X3\nOUT Y3\nEND\n";
  let right = "LD X0\nCJ P8\nLD X1\nOUT Y1\nP8\nLD X2\nOUT Y2\nEND\n";
  let references = [TP<"2.10", "6504">];
}
def LabelUndefined : FlowError<"label-undefined", "{mnemonic} names {label}, which is nowhere placed"> {
  let explanation = [{A jump goes to a label, a call to the label at the head of a subroutine. The label stands on a line of its own, before END.}];
  let wrong = "LD X0\nCJ P8\nLD X1\nOUT Y1\nEND\n";
  let right = "LD X0\nCJ P8\nLD X1\nOUT Y1\nP8\nLD X2\nOUT Y2\nEND\n";
  let references = [TP<"2.10", "6606">, TP<"7.2", "6701">];
}
def NoSuchLabel : FlowError<"no-such-label", "{model} has no label {operand}; it has {numbers}"> {
  let explanation = [{Types of a controller differ in how many labels they have.}];
  let wrong = "LD X0\nCJ P256\nLD X1\nOUT Y0\nP256\nEND\n";
  let right = "LD X0\nCJ P255\nLD X1\nOUT Y0\nP255\nEND\n";
  let references = [TP<"2.10", "6507">];
}
def NoSuchInterrupt : FlowError<"no-such-interrupt", "{model} has no interrupt pointer {operand}; it has {numbers}"> {
  let explanation = [{The number of an interrupt pointer says what interrupts: I<n>00 and I<n>01 the edges of input Xn, I6xx to I8xx a time
of xx milliseconds from 10 on, I010 to I060 the comparison of a high-speed counter.}];
  let wrong = "EI\nFEND\nI605\nLD M8000\nINC D0\nIRET\nEND\n";
  let right = "EI\nFEND\nI610\nLD M8000\nINC D0\nIRET\nEND\n";
  let references = [TP<"2.10", "6508">];
}
def EndLabel : FlowError<"end-label", "{label} means END; {what}"> {
  let explanation = [{This label stands for the END of the program. CJ can jump to it without its being placed; a subroutine cannot begin there.}];
  let wrong = "LD X0\nCJ P63\nLD X1\nOUT Y0\nP63\nEND\n";
  let right = "LD X0\nCJ P63\nLD X1\nOUT Y0\nEND\n";
  let references = [TP<"2.10", "6507">];
}
def LabelJumpAndCall : FlowError<"label-jump-and-call", "{mnemonic} names {label}, which {other} names as well; a label serves jumps or calls"> {
  let explanation = [{A jump goes on at its label and never comes back, a call comes back at SRET. One label cannot be both.}];
  let wrong = "LD X0\nCALL P10\nLD X1\nCJ P10\nFEND\nP10\nLD M8000\nINC D0\nSRET\nEND\n";
  let right = "LD X0\nCALL P10\nLD X1\nCJ P11\nLD X2\nOUT Y0\nP11\nFEND\nP10\nLD M8000\nINC D0\nSRET\nEND\n";
  let references = [TP<"2.10", "6507">];
}
def LabelUnused : FlowWarning<"label-unused", "nothing jumps to {label} and nothing calls it"> {
  let explanation = [{A label without a jump or call does nothing; a subroutine that nothing calls is never executed.}];
  let wrong = "LD X0\nOUT Y0\nP5\nLD X1\nOUT Y1\nEND\n";
  let right = "LD X0\nOUT Y0\nLD X1\nOUT Y1\nEND\n";
  let references = [TP<"2.10">];
}
def InterruptTwice : FlowError<"interrupt-twice", "{label} and {other} are routines of one source; a program has one of them"> {
  let explanation = [{An input interrupts on its rising or its falling edge, and each of the timer interrupts has one period.}];
  let wrong = "EI\nFEND\nI100\nLD M8000\nINC D0\nIRET\nI101\nLD M8000\nINC D1\nIRET\nEND\n";
  let right = "EI\nFEND\nI100\nLD M8000\nINC D0\nIRET\nI201\nLD M8000\nINC D1\nIRET\nEND\n";
  let references = [TP<"2.10", "6504">];
}

// ---------------------------------------------------------------------------------------------- jumps and calls
def JumpNotFollowed : FlowError<"jump-not-followed", "the jump to {label} {crosses} {range}; it cannot be compiled"> {
  let explanation = [{A jump stays inside of its routine and of its state, and may leave loops but not enter them. The controller does not forbid
other jumps but discourages them, because what they do depends on what was executed before; this compiler does not follow them.}];
  let wrong = "LD M8002\nSET S0\nSTL S0\nLD X0\nCJ P8\nLD X1\nOUT Y0\nRET\nP8\nLD X2\nOUT Y1\nEND\n";
  let right = "LD M8002\nSET S0\nSTL S0\nLD X0\nCJ P8\nLD X1\nOUT Y0\nP8\nLD X2\nOUT Y1\nRET\nEND\n";
  let references = [TP<"7.2">];
}
def JumpCrossesMaster : FlowWarning<"jump-crosses-master", "the jump to {label} crosses the border of the region of {region}"> {
  let explanation = [{A jump into the region of an MC or SMCS finds it switched on, whatever its condition is. A jump out of it goes on without that
condition. The manual discourages both.}];
  let wrong = "LD X0\nCJ P1\nLD X1\nMC N0 M100\nLD X2\nOUT Y0\nP1\nLD X3\nOUT Y1\nMCR N0\nEND\n";
  let right = "LD X1\nMC N0 M100\nLD X0\nCJ P1\nLD X2\nOUT Y0\nP1\nLD X3\nOUT Y1\nMCR N0\nEND\n";
  let references = [TP<"7.2">];
}
def CallTooDeep : FlowError<"call-too-deep", "this {mnemonic} can be number {count} inside each other; at most {max} are followed"> {
  let explanation = [{The controller remembers a limited number of places to return to.}];
  let references = [TP<"7.2", "6609">];
}
def CallRecursive : FlowError<"call-recursive", "{label} calls itself, directly or through others"> {
  let explanation = [{A subroutine that is called while it is running would nest without end.}];
  let wrong = "LD X0\nCALL P1\nFEND\nP1\nLD X1\nCALL P1\nSRET\nEND\n";
  let right = "LD X0\nCALL P1\nFEND\nP1\nLD X1\nCALL P2\nSRET\nP2\nLD X2\nOUT Y0\nSRET\nEND\n";
  let references = [TP<"7.2", "6609">];
}

// ---------------------------------------------------------------------------------------------- routines
def RoutineInMain : FlowError<"routine-in-main", "{label} is a routine and stands in the main program; routines stand between the last FEND and END"> {
  let explanation = [{Subroutines and interrupt routines lie behind the main program, which FEND ends, so that it does not run into them.}];
  let wrong = "I001\nLD X0\nOUT Y0\nIRET\nEND\n";
  let right = "EI\nFEND\nI001\nLD X0\nOUT Y0\nIRET\nEND\n";
  let references = [TP<"7.4", "6607">];
}
def ReturnInMain : FlowError<"return-in-main", "{mnemonic}, but no subroutine has begun here"> {
  let explanation = [{SRET ends a subroutine, which a label behind FEND begins.}];
  let wrong = "LD X0\nOUT Y0\nSRET\nEND\n";
  let right = "LD X0\nCALL P1\nFEND\nP1\nLD X0\nOUT Y0\nSRET\nEND\n";
  let references = [TP<"7.4", "6607">];
}
def InterruptNotBegun : FlowError<"interrupt-not-begun", "{mnemonic}, but no interrupt routine has begun here"> {
  let explanation = [{IRET ends an interrupt routine, which its pointer behind FEND begins.}];
  let wrong = "LD X0\nOUT Y0\nIRET\nEND\n";
  let right = "EI\nFEND\nI001\nLD X0\nOUT Y0\nIRET\nEND\n";
  let references = [TP<"7.4", "6615">];
}
def SubroutineNotEnded : FlowError<"subroutine-not-ended", "no SRET ends the subroutine {label}"> {
  let explanation = [{A subroutine goes from its label to SRET, which returns to the instruction behind the call.}];
  let wrong = "LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nEND\n";
  let right = "LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y0\nSRET\nEND\n";
  let references = [TP<"7.2", "6709">];
}
def InterruptNotEnded : FlowError<"interrupt-not-ended", "no IRET ends the interrupt routine {label}"> {
  let explanation = [{An interrupt routine goes from its pointer to IRET, which returns to where the interrupt came.}];
  let wrong = "EI\nFEND\nI001\nLD X1\nOUT Y0\nEND\n";
  let right = "EI\nFEND\nI001\nLD X1\nOUT Y0\nIRET\nEND\n";
  let references = [TP<"7.4", "6615">];
}
def Unreachable : FlowWarning<"unreachable", "nothing leads to this {mnemonic}"> {
  let explanation = [{Behind FEND, SRET and IRET the program goes on at a label only.}];
  let wrong = "LD X0\nOUT Y0\nFEND\nLD X1\nOUT Y1\nEND\n";
  let right = "LD X0\nOUT Y0\nLD X1\nOUT Y1\nFEND\nEND\n";
  let references = [TP<"F06">];
}

// ---------------------------------------------------------------------------------------------- what stands inside of what
def InLoop : FlowError<"in-loop", "{mnemonic} stands between FOR and NEXT"> {
  let explanation = [{Loops hold rungs, other loops, jumps and calls. Master control, step ladders, routines and the ends of programs cannot stand
inside of them.}];
  let wrong = "FOR K2\nLD M8000\nINC D0\nFEND\nNEXT\nEND\n";
  let right = "FOR K2\nLD M8000\nINC D0\nNEXT\nFEND\nEND\n";
  let references = [TP<"7.2", "6607">];
}
def InState : FlowError<"in-state", "{mnemonic} stands inside of a state of the step ladder, which goes up to RET"> {
  let explanation = [{A state switches its rungs by itself: MC, SMCS and their ends cannot stand between STL and RET, and neither can SRET.}];
  let wrong = "LD M8002\nSET S0\nSTL S0\nLD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nRET\nEND\n";
  let right = "LD M8002\nSET S0\nSTL S0\nLD X0\nAND X1\nOUT Y0\nRET\nEND\n";
  let references = [TP<"7.4", "6616">];
}
def RoutineInState : FlowError<"routine-in-state", "{mnemonic} stands inside of a state of the step ladder, which goes up to RET"> {
  let explanation = [{Routines and the ends of programs cannot stand between STL and RET.}];
  let wrong = "LD M8002\nSET S0\nSTL S0\nLD X0\nOUT Y0\nFEND\nRET\nEND\n";
  let right = "LD M8002\nSET S0\nSTL S0\nLD X0\nOUT Y0\nRET\nFEND\nEND\n";
  let references = [TP<"7.2", "6605">];
}
def InRoutine : FlowError<"in-routine", "{mnemonic} stands inside of the routine {label}"> {
  let explanation = [{Subroutines and interrupt routines hold rungs, loops, jumps and calls. Master control, step ladders and other routines cannot
stand inside of them.}];
  let wrong = "LD X0\nCALL P0\nFEND\nP0\nSTL S20\nOUT Y0\nRET\nSRET\nEND\n";
  let right = "LD X0\nCALL P0\nFEND\nP0\nLD X1\nOUT Y0\nSRET\nEND\n";
  let references = [TP<"7.2", "6606">];
}
def EndInRoutine : FlowError<"end-in-routine", "{mnemonic} stands inside of the routine {label}"> {
  let explanation = [{A subroutine ends with SRET and an interrupt routine with IRET. The end of the program cannot stand before it.}];
  let wrong = "LD X0\nCALL P1\nFEND\nP1\nLD M8000\nINC D0\nFEND\nSRET\nEND\n";
  let right = "LD X0\nCALL P1\nFEND\nP1\nLD M8000\nINC D0\nSRET\nEND\n";
  let references = [TP<"7.2", "6709">];
}
def InMaster : FlowError<"in-master", "{mnemonic} stands inside of the region of {region}"> {
  let explanation = [{A region that a condition switches lies on one side of the ends of programs and routines.}];
  let wrong = "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nFEND\nMCR N0\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nFEND\nEND\n";
  let references = [TP<"7.2", "6608">];
}
def RangesCross : FlowError<"ranges-cross", "{mnemonic} ends a range that begins outside of {range}"> {
  let explanation = [{A range lies inside of another one or outside; it cannot end inside of a loop, a state or a routine that began behind it.}];
  let wrong = "LD X0\nJCS\nFOR K2\nLD X1\nINC D0\nJCR\nNEXT\nEND\n";
  let right = "LD X0\nJCS\nFOR K2\nLD X1\nINC D0\nNEXT\nJCR\nEND\n";
  let references = [TP<"7.2", "6607">];
}

// ---------------------------------------------------------------------------------------------- loops
def LoopNotClosed : FlowError<"loop-not-closed", "no NEXT closes this {mnemonic}"> {
  let explanation = [{Every FOR has its NEXT, on the same side of FEND, in the same state and the same routine.}];
  let wrong = "FOR K2\nLD M8000\nINC D0\nEND\n";
  let right = "FOR K2\nLD M8000\nINC D0\nNEXT\nEND\n";
  let references = [TP<"F08", "6610">];
}
def LoopNotOpen : FlowError<"loop-not-open", "{mnemonic}, but no loop is open here"> {
  let explanation = [{NEXT closes the FOR that stands last before it in the same state and the same routine.}];
  let wrong = "LD X0\nOUT Y0\nNEXT\nEND\n";
  let right = "FOR K2\nLD X0\nINC D0\nNEXT\nEND\n";
  let references = [TP<"F08", "6610">];
}
def LoopTooDeep : FlowError<"loop-too-deep", "{mnemonic} number {count} inside each other; at most {max} are followed"> {
  let explanation = [{The controller counts a limited number of loops at a time.}];
  let references = [TP<"F08", "6617">];
}

// ---------------------------------------------------------------------------------------------- skipped ranges, common conditions
def SkipNotClosed : FlowError<"skip-not-closed", "no JCR ends the range of this {mnemonic}"> {
  let explanation = [{JCS skips up to JCR, which stands in the same loop, state and routine.}];
  let wrong = "LD X0\nJCS\nLD X1\nOUT Y0\nEND\n";
  let right = "LD X0\nJCS\nLD X1\nOUT Y0\nJCR\nEND\n";
  let references = [TP<"3.16", "6611">];
}
def SkipNotOpen : FlowError<"skip-not-open", "{mnemonic}, but no JCS is open here"> {
  let explanation = [{JCR ends all JCS that stand before it.}];
  let wrong = "LD X1\nOUT Y0\nJCR\nEND\n";
  let right = "LD X0\nJCS\nLD X1\nOUT Y0\nJCR\nEND\n";
  let references = [TP<"3.16", "6611">];
}
def BusNotClosed : FlowError<"bus-not-closed", "no SMCR ends the range of this {mnemonic}"> {
  let explanation = [{The condition of SMCS holds up to SMCR, which stands in the same loop and routine.}];
  let wrong = "LD X0\nSMCS\nLD X1\nOUT Y0\nEND\n";
  let right = "LD X0\nSMCS\nLD X1\nOUT Y0\nSMCR\nEND\n";
  let references = [TP<"3.15", "6614">];
}
def BusNotOpen : FlowError<"bus-not-open", "{mnemonic}, but no SMCS is open here"> {
  let explanation = [{SMCR ends all SMCS that stand before it.}];
  let wrong = "LD X1\nOUT Y0\nSMCR\nEND\n";
  let right = "LD X0\nSMCS\nLD X1\nOUT Y0\nSMCR\nEND\n";
  let references = [TP<"3.15", "6614">];
}

// ---------------------------------------------------------------------------------------------- step ladder
def StateNotClosed : FlowError<"state-not-closed", "no RET ends the step ladder that this {mnemonic} belongs to"> {
  let explanation = [{The states of a step ladder go up to RET, behind which the main program goes on. Programming software appends a missing RET;
the controller refuses a program without it.}];
  let wrong = "LD M8002\nSET S0\nSTL S0\nOUT Y0\nEND\n";
  let right = "LD M8002\nSET S0\nSTL S0\nOUT Y0\nRET\nEND\n";
  let references = [TP<"4.2", "6612">];
}
def StateNotOpen : FlowError<"state-not-open", "{mnemonic}, but no STL is open here"> {
  let explanation = [{RET ends the step ladder that STL begins.}];
  let wrong = "LD X0\nOUT Y0\nRET\nEND\n";
  let right = "LD M8002\nSET S0\nSTL S0\nOUT Y0\nRET\nEND\n";
  let references = [TP<"4.2", "6605">];
}
def MergeTooWide : FlowError<"merge-too-wide", "{mnemonic} number {count} in succession; at most {max} states merge"> {
  let explanation = [{STL in succession are the ends of parallel branches that a transfer leaves together. Their number is limited.}];
  let references = [TP<"4.9.2", "6605">];
}
def MergeWide : FlowWarning<"merge-wide", "{count} {mnemonic} in succession; the manual counts up to {max} branches in one place"> {
  let explanation = [{One section of the manual allows ten branches and another eight.}];
  let references = [TP<"4.9.2">, TP<"4.5">];
}
def TimerInAdjacentStates : FlowWarning<"timer-in-adjacent-states", "{device} is driven in {state}, which a transfer enters from {source}, where it is driven too"> {
  let explanation = [{During the scan of the transfer both states are active, so that the timer's coil does not turn OFF between them and its value
goes on. States that do not follow each other can share a timer.}];
  let wrong = "LD M8002\nSET S0\nSTL S0\nOUT T0 K10\nLD T0\nSET S20\nSTL S20\nOUT T0 K20\nLD T0\nSET S0\nRET\nEND\n";
  let right = "LD M8002\nSET S0\nSTL S0\nOUT T0 K10\nLD T0\nSET S20\nSTL S20\nOUT T1 K20\nLD T1\nSET S0\nRET\nEND\n";
  let references = [TP<"4.3">];
}

// ---------------------------------------------------------------------------------------------- notes
def FirstPlace : Note<"first-place", "{label} stands here first">;
def LabelHere : Note<"label-here", "{label} stands here">;
def RangeHere : Note<"range-here", "{range} begins here">;
def UsedHere : Note<"used-here", "{other} stands here">;
