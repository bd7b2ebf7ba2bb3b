// Devices of the TP03, and which of them may stand where. Numbers and sizes: 2.2-2.10; latch ranges: 2.4-2.9 and the parameter table.

defvar SR = "TP03SR";
// The models that have what the smallest ones lack.
defvar LargeModels = ["TP03H", "TP03M"];

let section = "2.2-2.3" in {
def DevX : Device<"X", "input", Bit, 8, 256> {
  let externalInput = 1;
  let beginHook = "watch_inputs";
  let watched = 8;
  let behaviour = "Image of the input terminals, read before the scan (and by REF) and constant within it. No coil may drive it. X0-X5 "
                  "also feed high-speed counters, SPD and input interrupts.";
}
def DevY : Device<"Y", "output", Bit, 8, 256> {
  let externalOutput = 1;
  let behaviour = "Image of the output terminals, sent out at END. Cleared when the switch goes to STOP unless M8033 is ON. M8034 "
                  "disables the terminals, not the image.";
}
}
let section = "2.4" in {
def DevM : Device<"M", "auxiliary relay", Bit, 10, 7680> {
  let modelPoints = [Points<SR, 1536>];
  let latched = [Numbers<500, 7679>];
  let behaviour = "One bit for the program's own use. M0-M499 are cleared at power-off and RUN to STOP, M500-M1023 are latched by "
                  "parameter, M1024 on always.";
}
def DevMS : Device<"M", "special relay", Bit, 10, 512> {
  let first = 8000;
  let image = "sys.M";
  let behaviour = "State of the controller and switches for it, see the list of special devices.";
}
}
let section = "2.5" in
def DevS : Device<"S", "step relay", Bit, 10, 4096> {
  let endHook = "show_states";
  let modelPoints = [Points<SR, 1024>];
  let latched = [Numbers<500, 4095>];
  let behaviour = "State of a step sequence, or an ordinary relay where no STL names it. S0-S9 are initial states, S10-S19 serve IST, "
                  "S500 on are latched, S900-S999 annunciators.";
}
let section = "2.6" in
def DevT : Device<"T", "timer", TimerDevice, 10, 512> {
  let container = "tp03::Timers";
  let beginHook = "begin_timers";
  let endHook = "end_timers";
  let modelPoints = [Points<SR, 256>];
  let missing = [Numbers<40, 195, SR>];
  let latched = [Numbers<246, 255>];
  let behaviour = "Contact, coil and 16-bit current value. T0-T199 count 100 ms (T192-T199 also in routines), T200-T245 10 ms, "
                  "T246-T249 accumulate 1 ms, T250-T255 accumulate 100 ms, T256 on count 1 ms.";
}
let section = "2.7" in {
def DevC : Device<"C", "counter", CounterDevice, 10, 200> {
  let container = "tp03::Counters";
  let modelPoints = [Points<SR, 100>];
  let latched = [Numbers<100, 199>, Numbers<90, 99, SR>];
  let behaviour = "Contact and 16-bit current value; counts up to its set value.";
}
def DevCL : Device<"C", "32-bit counter", LongCounterDevice, 10, 56> {
  let container = "tp03::LongCounters";
  let first = 200;
  let image = "C32";
  let missing = [Numbers<250, 250>, Numbers<255, 255>, Numbers<200, 219, SR>, Numbers<239, 240, SR>, Numbers<243, 245, SR>,
                 Numbers<248, 249, SR>, Numbers<254, 254, SR>];
  let latched = [Numbers<200, 255>];
  let terminals = [Terminals<235, 235, 0b000001>, Terminals<236, 236, 0b000010>, Terminals<237, 237, 0b000100>,
                   Terminals<238, 238, 0b001000>, Terminals<239, 239, 0b010000>, Terminals<240, 240, 0b100000>,
                   Terminals<241, 241, 0b000011>, Terminals<242, 242, 0b001100>, Terminals<243, 243, 0b110000>,
                   Terminals<244, 244, 0b010011>, Terminals<245, 245, 0b101100>, Terminals<246, 246, 0b000011>,
                   Terminals<247, 247, 0b000111>, Terminals<248, 248, 0b111000>, Terminals<249, 249, 0b100111>,
                   Terminals<251, 251, 0b000011>, Terminals<252, 252, 0b000111>, Terminals<253, 253, 0b011100>,
                   Terminals<254, 254, 0b100111>];
  let behaviour = "Contact and 32-bit current value. C200-C234 count edges of their condition up or down, C235-C254 pulses of fixed "
                  "inputs. As a word operand in 32-bit instructions only.";
}
}
let section = "2.9" in {
def DevD : Device<"D", "data register", Word, 10, 8000> {
  let modelPoints = [Points<SR, 512>];
  let latched = [Numbers<200, 7999>, Numbers<400, 511, SR>];
  let behaviour = "16 bits for the program's own use; 32-bit data take two, the lower number is the low word. D200 on (SR: D400 on) "
                  "are latched.";
}
def DevDS : Device<"D", "special register", Word, 10, 512> {
  let first = 8000;
  let image = "sys.D";
  let behaviour = "Data of the controller and settings for it, see the list of special devices.";
}
def DevV : Device<"V", "index register", Word, 10, 16> {
  let survivesStop = 1;
  let behaviour = "16 bits that modify the number of an operand (D20V0), or data. High word of the pair (Vn, Zn), which 32-bit "
                  "instructions name by Zn.";
}
def DevZ : Device<"Z", "index register", Word, 10, 16> {
  let survivesStop = 1;
  let highWords = "V";
  let behaviour = "As V; low word of the pair (Vn, Zn), and the index of 32-bit instructions.";
}
}
let section = "3.9" in
def DevN : Device<"N", "nesting level", Nesting, 10, 8> { let behaviour = "Level of a master control region; no memory."; }
let section = "2.10" in {
def DevP : Device<"P", "branch pointer", LabelDevice, 10, 256> {
  let modelPoints = [Points<SR, 128>];
  let behaviour = "Target of CJ or head of a subroutine. P63 means END and is nowhere placed.";
}
def DevI : Device<"I", "interrupt pointer", LabelDevice, 10, 900> {
  let nameDigits = 3;
  // I<n>00 and I<n>01; I010 to I060; the timer interrupts from 10 ms on.
  let missing = [Numbers<2, 9>, Numbers<11, 19>, Numbers<21, 29>, Numbers<31, 39>, Numbers<41, 49>, Numbers<51, 59>, Numbers<61, 99>,
                 Numbers<102, 199>, Numbers<202, 299>, Numbers<302, 399>, Numbers<402, 499>, Numbers<502, 609>, Numbers<700, 709>,
                 Numbers<800, 809>, Numbers<400, 401, SR>, Numbers<500, 501, SR>];
  let exclusive = [Numbers<0, 1>, Numbers<100, 101>, Numbers<200, 201>, Numbers<300, 301>, Numbers<400, 401>, Numbers<500, 501>,
                   Numbers<600, 699>, Numbers<700, 799>, Numbers<800, 899>];
  let terminals = [Terminals<0, 1, 0b000001>, Terminals<100, 101, 0b000010>, Terminals<200, 201, 0b000100>,
                   Terminals<300, 301, 0b001000>, Terminals<400, 401, 0b010000>, Terminals<500, 501, 0b100000>];
  let behaviour = "Head of an interrupt routine. I<n>0<e>: input Xn, e is 1 for the rising and 0 for the falling edge; I6xx, I7xx, "
                  "I8xx: every xx ms (10-99); I010-I060: high-speed counter comparison.";
}
}

// What "D" means where an instruction has a list of its own: with special registers, and without.
defvar DataRegisters = [DevD, DevDS];
defvar PlainRegisters = [DevD];
def ContactBits : Classes<[DevX, DevY, DevM, DevMS, DevS, DevT, DevC, DevCL]>;
def CoilBits : Classes<[DevY, DevM, DevMS]>;
def StepBits : Classes<[DevS]>;
def PulseBits : Classes<[DevY, DevM]>;
def InputBits : Classes<[DevX]>;
def OutputBits : Classes<[DevY]>;
def ReadBits : Classes<[DevX, DevY, DevM, DevMS, DevS]>;
def WrittenBits : Classes<[DevY, DevM, DevMS, DevS]>;
def TimerClass : Classes<[DevT]>;
def CounterClass : Classes<[DevC]>;
def LongCounterClass : Classes<[DevCL]>;
// Words that can be read, and those that can be written: 16 bits, and 32 (C200 on is 32 bits wide, a pair is named by Z).
def ReadWords : Classes<[DevT, DevC, DevD, DevDS, DevV, DevZ], [], [DevX, DevY, DevM, DevMS, DevS]>;
def ReadPairs : Classes<[DevT, DevC, DevCL, DevD, DevDS, DevZ], [], [DevX, DevY, DevM, DevMS, DevS]>;
def WrittenWords : Classes<[DevT, DevC, DevD, DevDS, DevV, DevZ], [], [DevY, DevM, DevMS, DevS]>;
def WrittenPairs : Classes<[DevT, DevC, DevCL, DevD, DevDS, DevZ], [], [DevY, DevM, DevMS, DevS]>;
def ReadBlocks : Classes<[DevT, DevC, DevD, DevDS], [], [DevX, DevY, DevM, DevMS, DevS]>;
def WrittenBlocks : Classes<[DevT, DevC, DevD, DevDS], [], [DevY, DevM, DevMS, DevS]>;
def ValueWords : Classes<[DevT, DevC, DevD, DevDS]>;               // T, C, D without digits
def ValueOrIndexWords : Classes<[DevT, DevC, DevD, DevDS, DevV, DevZ]>;
def Registers : Classes<[DevD, DevDS]>;
def RegistersOrIndex : Classes<[DevD, DevDS, DevV, DevZ]>;
def Levels : Classes<[DevN]>;
def Labels : Classes<[DevP]>;
def Interrupts : Classes<[DevI]>;
def NoDevices : Classes<[]>;
