// Error codes of the TP03, as D8060-D8069 show them.
//
// A compiled program itself meets 6105 and the operation errors 67xx. 64xx, 65xx and 66xx are what ladderc reports when it
// compiles; the rest are faults of hardware, here so that a code read from a controller can be looked up.

class Stop<int c, string n, string why, string what, string sec = "7.4"> : ErrorCode<c, n, why, what, 1, sec>;
class GoesOn<int c, string n, string why, string what, string sec = "7.4"> : ErrorCode<c, n, why, what, 0, sec>;

defvar ReplaceUnit = "Replace the base unit.";

// ------------------------------------------------------------------------- M8060: communication cards
class WrongCard<int card, string type>
    : GoesOn<!add(2000, card), "expansion card mismatch",
             "The card that is mounted is a " # type # "; the settings ask for another one.",
             "Mount the right card, or change the settings.">;
def : WrongCard<1, "6AV">;
def : WrongCard<2, "485RS">;
def : WrongCard<3, "232RS">;
def : WrongCard<4, "2AI">;
def : WrongCard<5, "2TI">;
def : WrongCard<6, "1OP">;
def : GoesOn<6006, "no communication card", "The settings ask for a communication card, none is mounted.", "Mount the card.">;

// ------------------------------------------------------------------------- M8061: hardware
def : Stop<6101, "RAM error", "The check of the memory failed.", ReplaceUnit>;
def : Stop<6102, "ROM error", "The check of the read-only memory failed.", ReplaceUnit>;
def : Stop<6103, "I/O bus error", "The bus of the base unit does not answer.", ReplaceUnit>;
def : Stop<6104, "user program error", "The program memory does not hold what was written.", "Write the program again.">;
def : Stop<6105, "watchdog", "A scan took longer than D8000 tells, or the program jumps backwards without end.",
           "Shorten the scan, divide it by WDT, or enlarge D8000. Look for a loop of jumps.">;
def : Stop<6106, "RAM address line error", "The memory cannot be addressed.", ReplaceUnit>;

// ------------------------------------------------------------------------- M8063: communication
def : GoesOn<6301, "data link error", "DTLK could not talk to a station.", "Look at wiring, station numbers and timeouts.">;
def : GoesOn<6302, "remote I/O error", "RMIO could not talk to a station.", "Look at wiring, station numbers and timeouts.">;

// ------------------------------------------------------------------------- M8064: parameters
def : Stop<6401, "program and parameters differ", "The parameters belong to another program.", "Write both again.">;
def : Stop<6402, "memory capacity", "The capacity that is set does not exist.", "Correct the parameter.">;
def : Stop<6403, "latch range", "A latched range does not exist.", "Correct the parameter.">;
def : Stop<6409, "other parameter error", "A parameter is wrong in another way.", "Correct the parameter.">;

// ------------------------------------------------------------------------- M8065: syntax
def : Stop<6501, "instruction and operand", "An instruction has an operand that it does not take, too many or too few.",
           "Write operands that the instruction takes.">;
def : Stop<6504, "label twice", "A P or I number is placed twice.", "Give each label a number of its own.">;
def : Stop<6505, "device number", "A device number does not exist on the model.", "Use a number that exists.">;
def : Stop<6506, "unknown instruction", "The CPU does not know the instruction.", "Use an instruction of the model.">;
def : Stop<6507, "label P", "A branch label stands where it cannot stand, or has a number that it cannot have.",
           "P63 is END and is not placed.">;
def : Stop<6508, "label I", "An interrupt pointer stands where it cannot stand, or has a number that it cannot have.",
           "Write I<n>0<e>, I6xx to I8xx with 10 to 99 ms, or I010 to I060.">;
def : Stop<6509, "other syntax error", "A line cannot be read in another way.", "Correct the line.">;

// ------------------------------------------------------------------------- M8066: circuit
def : Stop<6603, "too many MPS", "More results are remembered than there are places.", "Divide the rung.">;
def : Stop<6604, "MPS, MRD, MPP", "MRD or MPP without MPS, or MPS without MPP.", "Pair them.">;
def : Stop<6605, "too many STL in succession", "More states merge than there may be; or a step ladder stands where none may be.",
           "Merge in two steps; move the step ladder out.">;
def : Stop<6606, "no such label", "CJ or CALL names a label that is not placed; or a routine stands where none may be.",
           "Place the label behind FEND.">;
def : Stop<6607, "I or SRET in the main program", "A routine's head or end stands in front of FEND; or FOR-NEXT is torn apart.",
           "Routines stand behind FEND.">;
def : Stop<6608, "MC-MCR", "A master control range overlaps a routine or a loop.", "End it where it began.", "7.2">;
def : Stop<6609, "too many CALL inside each other", "More than 16 calls lie inside each other.", "Call fewer levels.">;
def : Stop<6610, "FOR and NEXT", "Their numbers differ.", "Pair them.">;
def : Stop<6611, "JCS without JCR", "The skipped range has no end.", "Write JCR.">;
def : Stop<6612, "STL without RET", "The step ladder has no end.", "Write RET.">;
def : Stop<6613, "MC without MCR", "The master control range has no end.", "Write MCR.">;
def : Stop<6614, "SMCS without SMCR", "The range has no end.", "Write SMCR.">;
def : Stop<6615, "I and IRET", "An interrupt routine has no end, or an end no routine.", "Pair them.">;
def : Stop<6616, "in a step ladder", "MC, MCR, SMCS, SMCR or SRET stand between STL and RET.", "Move them out.">;
def : Stop<6617, "too many FOR inside each other", "More than 16 loops lie inside each other.", "Use fewer levels.">;
def : Stop<6618, "no END", "The program has no END.", "Write END.">;
def : Stop<6621, "other circuit error", "The circuit is wrong in another way.", "Correct it.">;

// ------------------------------------------------------------------------- M8067: operation
def : Stop<6701, "no jump destination", "CJ or CALL has no label that it may go to.", "Place the label.", "7.2">;
def : GoesOn<6705, "operand", "An operand is a device that the instruction does not take, or operands contradict each other.",
             "Correct the operands. The instruction was not executed.">;
def : GoesOn<6706, "number or value",
             "A device number, with its index or with the devices that follow it, does not exist; or a value is outside of its "
             "range: divisor 0, a digit above 9, the square root of a negative number.",
             "Correct index or value. The instruction was not executed.">;
def : Stop<6709, "routine or loop torn apart", "IRET or SRET is missing, or a loop overlaps a routine.", "Pair them.", "7.2">;
class Pid<int c, string n, string why> : GoesOn<c, "PID: " # n, why, "Correct the parameters of PID.">;
def : Pid<6730, "sampling time", "The sampling time is negative.">;
def : Pid<6732, "input filter", "The filter constant is outside of its range.">;
def : Pid<6733, "proportional gain", "The proportional gain is outside of its range.">;
def : Pid<6734, "integral time", "The integral time is outside of its range.">;
def : Pid<6735, "derivative gain", "The derivative gain is outside of its range.">;
def : Pid<6736, "derivative time", "The derivative time is outside of its range.">;
def : Pid<6740, "sampling and scan time", "The sampling time is not longer than the scan.">;
def : Pid<6742, "change of the measured value", "The measured value changed by more than a word holds.">;
def : Pid<6743, "deviation", "Set value less measured value is more than a word holds.">;
def : Pid<6744, "integral", "The integral part is more than a word holds.">;
def : Pid<6745, "derivative with its gain", "The derivative gain makes the derivative part more than a word holds.">;
def : Pid<6746, "derivative", "The derivative part is more than a word holds.">;
def : Pid<6747, "result", "The manipulated value is more than a word holds.">;
def : Pid<6750, "auto-tuning result", "Auto-tuning ended without usable values.">;
def : Pid<6751, "auto-tuning direction", "The measured value moves against the direction of action.">;
def : Pid<6752, "auto-tuning", "Auto-tuning could not be carried out.">;

// ------------------------------------------------------------------------- M8069: expansion
def : GoesOn<6903, "expansion I/O", "An expansion unit does not answer.", "Look at the expansion units.">;
def : GoesOn<6904, "AD/DA setting", "An analogue unit is set in a way that it does not have.", "Correct the setting.">;
def : GoesOn<6905, "AD without power", "An analogue unit has no supply.", "Connect its supply.">;
