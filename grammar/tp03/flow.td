// Program flow: step ladder, jumps, subroutines, interrupts, loops.

class FlowForm<string m, Placement where, Lowering how, int s, string what> : Instruction<m, m> {
  let category = what;
  let placement = where;
  let lowering = how;
  let steps = s;
}

// ---------------------------------------------------------------------------------------------- step ladder
let section = "4.2" in {
def STL : FlowForm<"STL", AtAlone, LowerState, 1, "stage"> {
  let operands = [Operand<"S", "In", OpBit, StepBits>];
  let title = "A state of a step ladder";
  let description = "What follows, up to the next STL or RET, belongs to state S. It is executed while S is ON, once more with a dead bus when "
                    "S has gone OFF (coils OFF, timers cleared), and otherwise skipped. Outputs at the head, without a contact, are driven "
                    "by the state itself. Several STL in succession are the merge of parallel branches: all states must be ON, and a "
                    "transfer resets them all.";
  let example = Rung<"LD M8002\nSET S0\nSTL S0\nOUT Y0\nLD X0\nSET S20\nSTL S20\nOUT Y1\nRET">.text;
}
def RET : FlowForm<"RET", AtAlone, LowerStateEnd, 1, "stage"> {
  let title = "End of a step ladder";
  let description = "What follows belongs to the main program again.";
  let example = Rung<"LD M8002\nSET S0\nSTL S0\nOUT Y0\nRET">.text;
}
}

// ---------------------------------------------------------------------------------------------- skipping
let section = "3.16", category = "program-control" in {
def JCS : FlowForm<"JCS", AtOutput, LowerSkip, 1, "program-control"> {
  let title = "Skip";
  let description = "With the result ON, nothing is executed up to JCR: contents, timers, counters and edge memories stay. Several JCS may be "
                    "open; one JCR ends them all.";
  let example = Rung<"LD X0\nJCS\nLD X1\nOUT Y0\nJCR">.text;
}
def JCR : FlowForm<"JCR", AtAlone, LowerSkipEnd, 1, "program-control"> {
  let title = "End of the skipped range";
  let description = "Where every open JCS goes on.";
  let example = Rung<"LD X0\nJCS\nLD X1\nOUT Y0\nJCR">.text;
}
}

// ---------------------------------------------------------------------------------------------- labels
class LabelOperand<Classes c> : Operand<"P", "In", OpLabel, c>;
let section = "2.10" in {
def P : FlowForm<"P", AtLabel, LowerLabel, 1, "program-control"> {
  let operands = [LabelOperand<Labels>];
  let title = "Label";
  let description = "Where CJ goes on, or the head of a subroutine behind FEND. P63 means END and is nowhere placed.";
  let example = Rung<"LD X0\nCJ P8\nLD X1\nOUT Y0\nP8\nLD X2\nOUT Y1">.text;
}
def I : FlowForm<"I", AtLabel, LowerInterruptLabel, 1, "interrupt"> {
  let operands = [LabelOperand<Interrupts>];
  let title = "Head of an interrupt routine";
  let description = "I<n>0<e>: input Xn turned ON (e is 1) or OFF (e is 0). I6xx, I7xx, I8xx: every xx ms. I010-I060: raised by DHSCS. "
                    "Routines run between EI and DI, one after the other; M8050-M8059 inhibit them by kind.";
  let example = Rung<"EI\nFEND\nI001\nLD M8000\nOUT Y0\nIRET">.text;
}
}

// ---------------------------------------------------------------------------------------------- F00-F09
def JumpOperand : Operand<"P", "In", OpLabel, Labels> { let indexable = 1; }
let section = "F00", number = 0, operands = [JumpOperand], title = "Conditional jump",
    description = "With the result ON, the program goes on behind the label; what lies between is not executed: coils keep their state, timers "
                  "stand still except T192-T199 and T246-T249, counters do not count except high-speed ones, edge memories stay. CJ P63 goes "
                  "to END. A jump backwards repeats a part of the scan; one without end stops the CPU as the watchdog does." in {
def CJ : FlowForm<"CJ", AtOutput, LowerJump, 3, "program-control"> {
  let execution = WhileOn;
  let example = Rung<"LD X0\nCJ P8\nLD X1\nOUT Y0\nP8\nLD X2\nOUT Y1">.text;
}
def CJP : FlowForm<"CJP", AtOutput, LowerJump, 3, "program-control"> {
  let mnemonic = "CJ";
  let execution = RisingEdge;
  let example = Rung<"LD X0\nCJP P8\nLD X1\nOUT Y0\nP8\nLD X2\nOUT Y1">.text;
}
}
let section = "F01", number = 1, operands = [JumpOperand], title = "Subroutine call",
    description = "With the result ON, runs the subroutine at the label up to its SRET. Sixteen calls may lie inside each other. With the result "
                  "OFF the subroutine is not executed at all and everything in it keeps its state." in {
def CALL : FlowForm<"CALL", AtOutput, LowerCallRoutine, 3, "program-control"> {
  let execution = WhileOn;
  let example = Rung<"LD X0\nCALL P10\nFEND\nP10\nLD X1\nOUT Y0\nSRET">.text;
}
def CALLP : FlowForm<"CALLP", AtOutput, LowerCallRoutine, 3, "program-control"> {
  let mnemonic = "CALL";
  let execution = RisingEdge;
  let example = Rung<"LD X0\nCALLP P10\nFEND\nP10\nLD X1\nOUT Y0\nSRET">.text;
}
}
let section = "F02", number = 2 in
def SRET : FlowForm<"SRET", AtAlone, LowerReturn, 1, "program-control"> {
  let title = "End of a subroutine";
  let description = "Goes on behind the CALL.";
  let example = Rung<"LD X0\nCALL P10\nFEND\nP10\nLD X1\nOUT Y0\nSRET">.text;
}
let section = "F03", number = 3 in
def IRET : FlowForm<"IRET", AtAlone, LowerInterruptReturn, 1, "interrupt"> {
  let title = "End of an interrupt routine";
  let description = "Goes on where the interrupt came.";
  let example = Rung<"EI\nFEND\nI001\nLD M8000\nOUT Y0\nIRET">.text;
}
let style = StyleSystem, example = Rung<"EI\nLD X0\nOUT Y0\nDI\nFEND\nI001\nLD M8000\nOUT Y1\nIRET">.text in {
let section = "F04", number = 4 in
def EI : FlowForm<"EI", AtAlone, LowerCall, 1, "interrupt"> {
  let function = "enable_interrupts";
  let title = "Enable interrupts";
  let description = "Interrupts are accepted from here on; those held meanwhile (up to eight) follow at once. Disabled after the start.";
}
let section = "F05", number = 5 in
def DI : FlowForm<"DI", AtAlone, LowerCall, 1, "interrupt"> {
  let function = "disable_interrupts";
  let title = "Disable interrupts";
  let description = "Interrupts are held from here on, up to eight.";
}
}
let section = "F06", number = 6 in
def FEND : FlowForm<"FEND", AtAlone, LowerMainEnd, 1, "program-control"> {
  let title = "End of the main program";
  let description = "Ends the scan as END does. Subroutines and interrupt routines stand between the last FEND and END.";
  let example = Rung<"LD X0\nCALL P10\nFEND\nP10\nLD X1\nOUT Y0\nSRET">.text;
}
let section = "F07", number = 7, style = StyleSystem, function = "reset_watchdog", title = "Refresh the watchdog",
    description = "Starts the watchdog time anew. Compiled programs are watched from scan to scan by their host, so nothing is to be done." in {
def WDT : FlowForm<"WDT", AtOutput, LowerCall, 1, "program-control"> {
  let execution = WhileOn;
  let example = Rung<"LD X0\nWDT">.text;
}
def WDTP : FlowForm<"WDTP", AtOutput, LowerCall, 1, "program-control"> {
  let mnemonic = "WDT";
  let execution = RisingEdge;
  let example = Rung<"LD X0\nWDTP">.text;
}
}
let section = "F08", number = 8 in
def FOR : FlowForm<"FOR", AtAlone, LowerLoop, 3, "program-control"> {
  let operands = [Source<"S", OpWord>];
  let title = "Repeat";
  let description = "Executes what follows, up to its NEXT, S times in this scan: 1 to 32767; 0 and negative numbers count as 1. Sixteen may lie "
                    "inside each other.";
  let example = Rung<"FOR K3\nLD M8000\nINC D0\nNEXT">.text;
}
let section = "F09", number = 9 in
def NEXT : FlowForm<"NEXT", AtAlone, LowerLoopEnd, 1, "program-control"> {
  let title = "End of the repeated range";
  let description = "Closes the FOR opened last.";
  let example = Rung<"FOR K3\nLD M8000\nINC D0\nNEXT">.text;
}
