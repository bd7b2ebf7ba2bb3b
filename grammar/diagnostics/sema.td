// Messages about what the instruction tables and the rung structure ask of a list.
//
// In this order: operands, blocks and rungs, branches, master control, END, suspicious but legal lists, notes. Those about program flow
// are in flow.td.

class QS<string sec, string c = ""> : Ref<"melsec-qs", sec, c>;

// ---------------------------------------------------------------------------------------------- operands
def OperandCount : Error<"operand-count", "{mnemonic} has {count} here; it is written {shapes}"> {
  let explanation = [{The number of operands chooses the form of an instruction (+ S D adds to D, + S1 S2 D writes the sum to D). No form of
this mnemonic has as many operands as the line. Timers and counters take their set value as second operand.}];
  let wrong = "LD X0\nMOV D0\nEND\n";
  let right = "LD X0\nMOV D0 D1\nEND\n";
  let references = [QS<"2.4", "4003">, TP<"3.1", "6501">];
}
def OperandClass : Error<"operand-class", "{mnemonic} takes {allowed} as {name}, '{operand}' stands there"> {
  let explanation = [{The instruction tables say for every operand position which devices may stand there, whether one bit of a word (D0.5) or
digits of bit devices (K4X0) may, and whether constants may. This operand is none of them.}];
  let wrong = "LD X0\nBMOV K5 D0 K2\nEND\n";
  let right = "LD X0\nFMOV K5 D0 K2\nEND\n";
  let references = [QS<"4", "4004">, TP<"7.4", "6501">];
}
def ConstantDestination : Error<"constant-destination",
    "'{operand}' is a constant; {mnemonic} writes its {name}, so a device has to stand there"> {
  let explanation = [{An instruction cannot write to a constant. Mostly the operands are in the wrong order: the source comes first, the
destination last.}];
  let wrong = "LD X0\nMOV D0 K5\nEND\n";
  let right = "LD X0\nMOV K5 D0\nEND\n";
  let references = [QS<"4", "4004">, TP<"7.4", "6501">];
}
def HexConstant : Error<"hex-constant", "'{operand}' is hexadecimal; the {name} of {mnemonic} is a decimal constant, here {decimal}"> {
  let explanation = [{This position takes K constants only. Set values of timers and counters and page numbers are such positions.}];
  let wrong = "LD X0\nOUT T0 H64\nEND\n";
  let right = "LD X0\nOUT T0 K100\nEND\n";
  let references = [QS<"5.3.2", "4004">, QS<"5.3.3", "4004">];
}
def SetValue : Error<"set-value", "'{operand}' as the set value of {device}; a set value is {allowed}"> {
  let explanation = [{A timer or counter is preset by a decimal constant or by a word device that holds the value. The current value of
another timer or counter has to be moved to a register first.}];
  let wrong = "LD X0\nOUT T0 T1\nEND\n";
  let right = "LD X0\nMOV T1 D0\nLD X0\nOUT T0 D0\nEND\n";
  let references = [QS<"5.3.2", "4004">, QS<"5.3.3", "4004">, TP<"3.13", "6501">];
}
def TimerCounterBit : Error<"timer-counter-bit", "'{operand}' is a bit of a timer's or counter's value; only registers have bits: {allowed}"> {
  let explanation = [{Single bits can be named in data and link registers. The current value of a timer or counter is a word too, but its bits
have no names: move it to a register and take the bit there.}];
  let wrong = "LD T0.5\nOUT Y0\nEND\n";
  let right = "LD SM400\nMOV T0 D0\nLD D0.5\nOUT Y0\nEND\n";
  let references = [QS<"3.2.1", "4004">];
}
def TimerCounterOutput : Error<"timer-counter-output",
    "'{operand}' is a timer or counter, which contacts, OUT and RST can name; {mnemonic} takes {allowed}"> {
  let explanation = [{The contact of a timer or counter follows its value. It can be read by contacts, the whole device is driven by OUT and
cleared by RST; no other bit instruction may act on it.}];
  let wrong = "LD X0\nPLS C0\nEND\n";
  let right = "LD X0\nPLS M0\nLD M0\nOUT C0 K5\nEND\n";
  let references = [QS<"4", "4004">, QS<"5.3.8", "4004">, TP<"3.12", "6501">];
}
def WordForBit : Error<"word-for-bit", "'{operand}' is a word and {mnemonic} acts on a bit; a bit of it is written {operand}.0 to {operand}.F"> {
  let explanation = [{A bit instruction names one bit of a register with a full stop and a hexadecimal digit.}];
  let wrong = "LD X0\nFF D0\nEND\n";
  let right = "LD X0\nFF D0.5\nEND\n";
  let references = [QS<"3.2.1", "4004">];
}
def BitForWord : Error<"bit-for-word",
    "'{operand}' is one bit and {mnemonic} takes words; 4 to {bits} bits from there on are written K1{operand} to K{digits}{operand}"> {
  let explanation = [{Bit devices take part in word instructions in groups of four points, called digits: K2X0 is X0 to X7 as a number of
eight bits.}];
  let wrong = "LD SM400\nMOV X0 D0\nEND\n";
  let right = "LD SM400\nMOV K4X0 D0\nEND\n";
  let references = [QS<"3.2.2", "4004">, TP<"5.2", "6501">];
}
def IndexRegister : Error<"index-register", "'{operand}' is modified by an index register; {family} has none"> {
  let explanation = [{Other controllers of the maker add the content of an index register to a device number. This one always works on the
device that is written.}];
  let wrong = "LD X0\nMOV D0Z1 D1\nEND\n";
  let right = "LD X0\nMOV D0 D1\nEND\n";
  let references = [QS<"3.2", "4000">];
}
def DeviceOutOfRange : Error<"device-out-of-range", "'{operand}' lies behind {last}, the last {prefix} that the parameters allocate"> {
  let explanation = [{Numbers run from 0 to the allocated points less one. Either the number is wrong, or the parameters of the program must
allocate more points (device_points).}];
  let wrong = "LD X0\nMOV K1 D6144\nEND\n";
  let right = "LD X0\nMOV K1 D6143\nEND\n";
  let references = [QS<"3.4", "2500">];
}
def DeviceNotAllocated : Error<"device-not-allocated", "'{operand}': the parameters allocate no {prefix}"> {
  let explanation = [{Some device classes have no points until the parameters give them some. Retentive timers are the usual case: ST_points in
the parameter file allocates them.}];
  let wrong = "LD X0\nOUT ST0 K10\nEND\n";
  let right = "LD X0\nOUT T0 K10\nEND\n";
  let references = [QS<"3.4", "2500">];
}
def NoSuchDevice : Error<"no-such-device", "{model} has no {operand}; it has {numbers}"> {
  let explanation = [{Types of a controller differ in how many devices they have, and some numbers are left out.}];
  let family = "tp03";
  let wrong = "LD X0\nOUT C250 K10\nEND\n";
  let right = "LD X0\nOUT C249 K10\nEND\n";
  let references = [TP<"2.2", "6505">];
}
def OperandNumber : Error<"operand-number", "{mnemonic} takes {allowed} as {name}, '{operand}' stands there"> {
  let explanation = [{The device is of the right kind, but this position takes some of its numbers only: an instruction of one sort of timer does
not work on the others, and pulses come out of certain terminals.}];
  let family = "tp03";
  let wrong = "LD X0\nPLSY K100 K5 Y2\nEND\n";
  let right = "LD X0\nPLSY K100 K5 Y0\nEND\n";
  let references = [TP<"7.4", "6501">];
}
def LongCounterInWord : Error<"long-counter-in-word", "'{operand}' is 32 bits wide, the {name} of {mnemonic} 16"> {
  let explanation = [{A 32-bit counter is one device of 32 bits and can be read and written by 32-bit instructions only, the ones that begin
with D.}];
  let family = "tp03";
  let wrong = "LD X0\nMOV C200 D0\nEND\n";
  let right = "LD X0\nDMOV C200 D0\nEND\n";
  let references = [TP<"2.7", "6501">];
}
def NotIndexable : Error<"not-indexable", "'{operand}' is modified by an index register, the {name} of {mnemonic} cannot be"> {
  let explanation = [{Index registers modify operands of application instructions, and of those the ones that the manual marks with a dot.
Contacts, coils and step-ladder instructions always work on the device that is written.}];
  let family = "tp03";
  let wrong = "LD X0Z1\nOUT Y0\nEND\n";
  let right = "LD X0\nMOV K1X0Z1 D0\nEND\n";
  let references = [TP<"5.3", "6501">];
}
def IndexNotPair : Error<"index-not-pair", "'{operand}' is modified by {index}; {mnemonic} has 32 bits, for which {pair} is written"> {
  let explanation = [{A 32-bit instruction takes a 32-bit index, the pair of a V and the Z of the same number. Z names it. Write both words of it,
with a 32-bit instruction: DMOV K5 Z0.}];
  let family = "tp03";
  let wrong = "LD X0\nDMOV D0V1 D10\nEND\n";
  let right = "LD X0\nDMOV D0Z1 D10\nEND\n";
  let references = [TP<"5.3", "6501">];
}
def NotOnModel : Error<"not-on-model", "{model} has no {mnemonic}; {models} have it"> {
  let explanation = [{Some instructions need hardware that not all types of the controller have.}];
  let family = "tp03";
  let references = [TP<"6", "6506">];
}
def TextLength : Error<"text-length", "'{operand}' has {count} characters; {mnemonic} takes 1 to {max}"> {
  let explanation = [{The text is part of the instruction and has a place for a fixed number of characters. Fewer are filled up with zeros.}];
  let family = "tp03";
  let wrong = "LD X0\nASC ABCDEFGHI D0\nEND\n";
  let right = "LD X0\nASC ABCDEFGH D0\nEND\n";
  let references = [TP<"F76", "6501">];
}
def TextCharacter : Error<"text-character", "'{operand}' holds a character that is not of the ASCII code"> {
  let explanation = [{The controller keeps texts as 7-bit characters: letters without accents, digits and the signs of the ASCII table.}];
  let family = "tp03";
  let wrong = "LD X0\nASC \"5 °C\" D0\nEND\n";
  let right = "LD X0\nASC \"5 C\" D0\nEND\n";
  let references = [TP<"7.3", "6501">];
}
def MaxUses : Error<"max-uses", "{mnemonic} stands here for the {count} time; a program may have {max}"> {
  let explanation = [{Some instructions exist once or twice in the controller, whatever their operands. To use one for several purposes, let an
index register choose its operands.}];
  let family = "tp03";
  let wrong = "LD X0\nTKY X20 D0 M10\nLD X1\nTKY X30 D2 M30\nEND\n";
  let right = "LD X0\nTKY X20 D0 M10\nEND\n";
  let references = [TP<"5.1", "6621">];
}
def TerminalShared : Error<"terminal-shared", "{user} needs {terminal}, which {other} has already"> {
  let explanation = [{A terminal with a fast input serves one high-speed counter, one input interrupt or one pulse measurement of a program. What
is not used by any of them is an ordinary input.}];
  let family = "tp03";
  let wrong = "LD M8000\nOUT C235 K10\nOUT C241 K20\nEND\n";
  let right = "LD M8000\nOUT C235 K10\nOUT C242 K20\nEND\n";
  let references = [TP<"2.8", "6621">];
}
def DigitCount : Error<"digit-count", "'{operand}' has {count} digits of four bits; {mnemonic} takes K1 to K{max} as {name}"> {
  let explanation = [{K1 to K4 in front of a bit device make 4 to 16 bits, which is all that a 16-bit instruction can take; 32-bit instructions
take K1 to K8.}];
  let wrong = "LD X0\nMOV K5X0 D0\nEND\n";
  let right = "LD X0\nDMOV K5X0 D0\nEND\n";
  let references = [QS<"3.2.2", "4004">, QS<"3.2.3", "4004">, TP<"5.2", "6501">];
}
def DigitsUnequal : Error<"digits-unequal", "'{operand}' has another number of digits than '{other}'; {mnemonic} moves digits one to one"> {
  let explanation = [{When source and destination of a block transfer both are bit devices, each group of digits is copied as it is, so both
must have the same number of digits.}];
  let wrong = "LD X0\nBMOV K1X0 K2Y0 K2\nEND\n";
  let right = "LD X0\nBMOV K1X0 K1Y0 K2\nEND\n";
  let references = [QS<"6.4.3", "4004">, TP<"F15", "6501">];
}
def ConstantRange : Error<"constant-range", "'{operand}' is outside {min} to {max}, which {mnemonic} takes as {name}"> {
  let explanation = [{A 16-bit operand holds K-32768 to K32767 or H0 to HFFFF, a 32-bit operand K-2147483648 to K2147483647 or H0 to HFFFFFFFF.
Some positions take less: set values of timers and counters are not negative.}];
  let wrong = "LD X0\nMOV K32768 D0\nEND\n";
  let right = "LD X0\nDMOV K32768 D0\nEND\n";
  let references = [QS<"3.2.2", "4004">, QS<"3.2.3", "4004">, TP<"2.1", "6501">];
}
def RunsOffMemory : Error<"runs-off-memory", "'{operand}' is {count} {unit} long and runs past {last}, where no further {unit} lie"> {
  let explanation = [{A pair of words or a run of digits may go on in the next device of the memory, but behind this device lies nothing that it
could use: the memory ends, has a gap, or goes on with timers and counters.}];
  let wrong = "LD X0\nDMOV K1 SD5119\nEND\n";
  let right = "LD X0\nDMOV K1 SD5118\nEND\n";
  let references = [QS<"3.4">, TP<"7.4", "6706">];
}

// ---------------------------------------------------------------------------------------------- blocks and rungs
def NoOpenBlock : Error<"no-open-block", "{mnemonic} goes on from a contact, and none stands before it in this rung"> {
  let explanation = [{AND and OR contacts extend a block that an LD-type contact has opened. The first contact of the program and the first one
behind MCR is always of the LD type.}];
  let wrong = "AND X0\nOUT Y0\nEND\n";
  let right = "LD X0\nOUT Y0\nEND\n";
  let references = [QS<"5.1.1">, TP<"3.2", "6621">];
}
def NeedsCondition : Error<"needs-condition", "{mnemonic} needs a contact before it"> {
  let explanation = [{Outputs, INV, the edge operations on the result and MPS work on the result of contacts. At the head of the program and
behind MCR there is none yet. For an output that always acts, put the always-ON relay before it.}];
  let wrong = "MEP\nOUT Y10\nEND\n";
  let right = "LD X0\nMEP\nOUT Y10\nEND\n";
  let references = [QS<"5.2.3">, QS<"5.2.4">, QS<"5.2.5">, QS<"5.3.1">, TP<"3.10", "6501">];
}
def ContactExpected : Error<"contact-expected", "{mnemonic} stands directly behind {before}; a contact of the LD type goes before it"> {
  let explanation = [{What SMCS or JCS begins does not hand its condition on to the next instruction as a result. A new rung begins behind it, with
an LD-type contact.}];
  let family = "tp03";
  let wrong = "LD X0\nSMCS\nOUT Y0\nSMCR\nEND\n";
  let right = "LD X0\nSMCS\nLD X1\nOUT Y0\nSMCR\nEND\n";
  let references = [TP<"3.15", "6501">];
}
def JoinWithoutBlocks : Error<"join-without-blocks", "{mnemonic} joins two blocks, {count} is open"> {
  let explanation = [{ANB and ORB combine the two blocks that LD-type contacts have opened last. An LD-type contact after an output opens a new
rung. Only a block of several contacts goes on from the output with ANB; a single contact does so with AND.}];
  let wrong = "LD X0\nAND X1\nANB\nOUT Y0\nEND\n";
  let right = "LD X0\nLD X1\nANB\nOUT Y0\nEND\n";
  let references = [QS<"5.2.1">, TP<"3.6", "6621">];
}
def BlockNotJoined : Error<"block-not-joined", "{mnemonic} opens a block that no ANB or ORB joins before {user} in this rung"> {
  let explanation = [{Every LD-type contact inside a rung opens a block, and before an output all blocks must have been folded into one by ANB
(in series) or ORB (in parallel). Either the join is missing, or the LD was meant to be an AND or OR.}];
  let wrong = "LD X0\nLD X1\nOUT Y0\nEND\n";
  let right = "LD X0\nLD X1\nORB\nOUT Y0\nEND\n";
  let references = [QS<"5.2.1">, TP<"3.6", "6621">];
}
def RungWithoutOutput : Error<"rung-without-output", "nothing uses the result that begins with this {mnemonic}"> {
  let explanation = [{A rung ends with an output-type instruction. These contacts are followed by the end of the program instead.}];
  let wrong = "LD X0\nOUT Y0\nLD X1\nAND X2\nEND\n";
  let right = "LD X0\nOUT Y0\nLD X1\nAND X2\nOUT Y1\nEND\n";
  let references = [QS<"2.2">, TP<"3.2", "6621">];
}

// ---------------------------------------------------------------------------------------------- branches
def BranchTooDeep : Error<"branch-too-deep", "{mnemonic} number {count} without MPP in between; at most {max} results are kept at a time"> {
  let explanation = [{MPS keeps the result of the contacts until MPP takes it back. The memory for it has a limited number of places; each MPP
frees one.}];
  let wrong = "LD X0\n"
              "MPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\n"
              "OUT Y0\n"
              "MPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\n"
              "OUT Y1\nEND\n";
  let right = "LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nOUT Y1\nEND\n";
  let references = [QS<"5.2.2">, TP<"3.8", "6603">];
}
def BranchDeep : Warning<"branch-deep", "{mnemonic} number {count} without MPP in between; the manual asks for fewer than {count}"> {
  let explanation = [{The memory for kept results has eight places, but the manual allows fewer than eight MPS in one another in one place and
counts the eighth as an error in another. The controller may refuse the program.}];
  let family = "tp03";
  let wrong = "LD X0\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nOUT Y0\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nMPP\nOUT Y1\nEND\n";
  let right = "LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nOUT Y1\nEND\n";
  let references = [TP<"3.8", "6603">];
}
def MpsWithoutMpp : Error<"mps-without-mpp", "no MPP of this rung takes back the result of this {mnemonic}"> {
  let explanation = [{Every MPS needs one MPP, before its last branch. MRD reads the kept result and leaves it.}];
  let wrong = "LD X0\nMPS\nAND X1\nOUT Y10\nEND\n";
  let right = "LD X0\nMPS\nAND X1\nOUT Y10\nMPP\nOUT Y11\nEND\n";
  let references = [QS<"5.2.2">, TP<"3.8", "6604">];
}
def NoOpenBranch : Error<"no-open-branch", "{mnemonic} without an open MPS in this rung"> {
  let explanation = [{MRD and MPP read a result that an MPS of the same rung has kept. Here none has been kept, or an earlier MPP has taken it
back already: between the first and the last branch stands MRD.}];
  let wrong = "LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nAND X2\nOUT Y1\nMPP\nOUT Y2\nEND\n";
  let right = "LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nAND X2\nOUT Y1\nMPP\nOUT Y2\nEND\n";
  let references = [QS<"5.2.2">, TP<"3.8", "6604">];
}

// ---------------------------------------------------------------------------------------------- master control
def LevelRange : Error<"level-range", "'{operand}' is no nesting level; they are N{min} to N{max}"> {
  let explanation = [{Master control has a fixed number of nesting levels. The same level can be used again for regions that do not overlap.}];
  let wrong = "LD X0\nMC N15 M100\nLD X1\nOUT Y10\nMCR N15\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X1\nOUT Y10\nMCR N0\nEND\n";
  let references = [QS<"5.4.1">, TP<"3.9", "6505">];
}
def LevelOrder : Error<"level-order", "{operand} inside of the region of {outer}; levels ascend from the outer region to the inner one"> {
  let explanation = [{A region inside of a region has a higher level than the one around it, because MCR closes its level and all higher ones.}];
  let wrong = "LD X0\nMC N1 M100\nLD X1\nMC N0 M101\nLD X2\nOUT Y0\nMCR N0\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X1\nMC N1 M101\nLD X2\nOUT Y0\nMCR N1\nMCR N0\nEND\n";
  let references = [QS<"5.4.1">, TP<"3.9", "6613">];
}
def McWithoutMcr : Error<"mc-without-mcr", "no MCR closes the region of {operand}"> {
  let explanation = [{The region of an MC reaches up to the MCR of its level or of a lower one. This one is still open at the end of the program.}];
  let wrong = "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nEND\n";
  let references = [QS<"5.4.1">, TP<"3.9", "6613">];
}
def McrWithoutMc : Error<"mcr-without-mc", "{mnemonic} {operand}, but no region of that level is open"> {
  let explanation = [{MCR closes the region that an MC of the same level has opened, together with all regions inside. No such MC stands before
it, or its region has been closed already.}];
  let wrong = "LD X0\nOUT Y10\nMCR N0\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X0\nOUT Y10\nMCR N0\nEND\n";
  let references = [QS<"5.4.1">, TP<"3.9", "6613">];
}
def McrAfterContact : Error<"mcr-after-contact", "{mnemonic} stands without a condition, and a contact comes before it"> {
  let explanation = [{The end of a master control region does not depend on anything: MCR stands alone, between two rungs. So do labels and
the instructions that begin and end loops, states, routines and skipped ranges.}];
  let wrong = "LD X0\nMC N0 M100\nLD X1\nOUT Y10\nLD X2\nMCR N0\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X1\nOUT Y10\nMCR N0\nEND\n";
  let references = [QS<"5.4.1">, TP<"7.4", "6621">];
}

// ---------------------------------------------------------------------------------------------- END
def MissingEnd : Error<"missing-end", "the program stops here without END"> {
  let explanation = [{The last instruction of a program is END, exactly once.}];
  let wrong = "LD X0\nOUT Y0\n";
  let right = "LD X0\nOUT Y0\nEND\n";
  let references = [QS<"5.5.1", "4010">, TP<"3.14", "6618">];
}
def AfterEnd : Warning<"after-end", "the controller never comes to this {mnemonic}: END stands before it"> {
  let explanation = [{A scan goes from the first instruction to END. What follows is not compiled. NOPs behind END get no message.}];
  let wrong = "LD X0\nOUT Y0\nEND\nLD X1\nOUT Y1\nEND\n";
  let right = "LD X0\nOUT Y0\nLD X1\nOUT Y1\nEND\n";
  let references = [QS<"5.5.1">, TP<"3.14">];
}

// ---------------------------------------------------------------------------------------------- suspicious
def CrossesDeviceEnd : Warning<"crosses-device-end", "'{operand}' is {count} {unit} long: it goes on behind {last} with {next}"> {
  let explanation = [{Pairs of words and runs of digits are not checked against the end of their device. They go on in the device that follows in
the controller's memory, which mostly is not what the program wants.}];
  let wrong = "LD X0\nDMOV K1 D6143\nEND\n";
  let right = "LD X0\nDMOV K1 D6142\nEND\n";
  let references = [QS<"3.4">];
}
def BlockBeyondEnd : Warning<"block-beyond-end", "'{operand}' with {count} {unit} runs past {last}; executing this {mnemonic} is an operation error"> {
  let explanation = [{Block instructions check the range when they are executed, and stop the CPU where the block does not fit into its device.}];
  let wrong = "LD X0\nFMOVP K1 D6142 K3\nEND\n";
  let right = "LD X0\nFMOVP K1 D6141 K3\nEND\n";
  let references = [QS<"3.4", "4101">, QS<"6.4.3", "4101">, QS<"6.4.4", "4101">];
}
def DoubleCoil : Warning<"double-coil", "{device} is driven by another instruction before this {mnemonic}; the one executed last in a scan wins"> {
  let explanation = [{OUT, PLS and PLF write their device in every scan, whether their condition is ON or OFF. With two of them on one device the
first has an effect only on the rungs in between. Timers and counters advance at each of them.}];
  let wrong = "LD X0\nOUT Y5\nLD X1\nOUT Y5\nEND\n";
  let right = "LD X0\nOR X1\nOUT Y5\nEND\n";
  let references = [QS<"3.7">, TP<"1.4">, TP<"4.3">];
}
def McDeviceDriven : Warning<"mc-device-driven", "{device} is the device of an MC and is written by another instruction too"> {
  let explanation = [{MC writes the state of its region to its device. Another instruction that writes the same device makes it tell something
else than whether the region is ON.}];
  let wrong = "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nLD X2\nOUT M100\nEND\n";
  let right = "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\nLD X2\nOUT M101\nEND\n";
  let references = [QS<"5.4.1">, TP<"3.9">];
}
def TimerSpeedMixed : Warning<"timer-speed-mixed", "{device} is driven by {mnemonic} here and by {other} before; the two count in different units"> {
  let explanation = [{The instruction that drives a timer decides whether it counts in low-speed or high-speed units. A timer that both drive counts
a mixture.}];
  let wrong = "LD X0\nOUT T0 K10\nLD X1\nOUTH T0 K10\nEND\n";
  let right = "LD X0\nOUT T0 K10\nLD X1\nOUTH T1 K10\nEND\n";
  let references = [QS<"5.3.2">];
}
def EdgeRelayShared : Warning<"edge-relay-shared", "{device} already keeps the result of another instruction"> {
  let explanation = [{An edge relay remembers the result of one place of the program from scan to scan. Two places that share it see each
other's results as edges.}];
  let wrong = "LD X0\nEGP V0\nOUT Y0\nLD X1\nEGP V0\nOUT Y1\nEND\n";
  let right = "LD X0\nEGP V0\nOUT Y0\nLD X1\nEGP V1\nOUT Y1\nEND\n";
  let references = [QS<"5.2.5">];
}
def EdgeRelayInParallel : Error<"edge-relay-in-parallel", "the result of {mnemonic} becomes one of several parallel branches"> {
  let explanation = [{EGP and EGF stand where AND stands, on the line that leads to the output. They cannot stand in a branch that is
joined to others by OR or ORB. Put them behind the parallel block, or use the edge contacts LDP, ORP and so on inside of it.}];
  let wrong = "LD X0\nEGP V0\nOR X1\nOUT Y0\nEND\n";
  let right = "LD X0\nOR X1\nEGP V0\nOUT Y0\nEND\n";
  let references = [QS<"5.2.5">];
}
def ParallelHere : Note<"parallel-here", "it is joined to the other branch here">;
def SpecialReadOnly : Warning<"special-read-only", "{mnemonic} writes {device} ({title}), which the system sets"> {
  let explanation = [{The system sets this special relay or register; what the program writes there is lost or misleads whoever reads it.}];
  let wrong = "LD X0\nOUT SM400\nEND\n";
  let right = "LD SM400\nOUT Y0\nEND\n";
  let references = [QS<"app. 2">, QS<"app. 3">, TP<"7.1">];
}
def NoplfInRung : Warning<"noplf-in-rung", "{mnemonic} stands inside of a rung"> {
  let explanation = [{A page feed belongs between two rungs. Inside of one it still does nothing, but the engineering tool cannot draw the
ladder.}];
  let wrong = "LD X0\nNOPLF\nAND X1\nOUT Y0\nEND\n";
  let right = "LD X0\nAND X1\nOUT Y0\nNOPLF\nLD X2\nOUT Y1\nEND\n";
  let references = [QS<"5.6.1">];
}

// ---------------------------------------------------------------------------------------------- notes
def EarlierInstruction : Note<"earlier-instruction", "the earlier {mnemonic} {device}">;
def OuterBlock : Note<"outer-block", "the block that it would be joined to begins here">;
def OuterRegion : Note<"outer-region", "the region of {outer} begins here">;
def TakenBack : Note<"taken-back", "this {mnemonic} has already taken the last result back">;
def NextRung : Note<"next-rung", "the next rung begins here">;
def OpenBranchSince : Note<"open-branch-since", "the first MPS that is still open">;
