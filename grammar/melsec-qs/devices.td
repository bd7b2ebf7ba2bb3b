// Devices of the QS001CPU, and which of them may stand where.
//
// The manual names one allocation only (6K data registers); the other default counts are those known of the family and can be
// changed by parameters. Special relays and registers are kept by the runtime's System, hence their image.

let section = "3.2, 3.4, 4" in {
def DevX : Device<"X", "input", Bit, 16, 6144> {
  let externalInput = 1;
  let memoryOrder = 2;
  let pointsRegister = 290;
  let behaviour = "Image of the input terminals, refreshed once a scan and constant within it. A program may write it, but the "
                  "next refresh overwrites the points that have a terminal.";
}
def DevY : Device<"Y", "output", Bit, 16, 6144> {
  let externalOutput = 1;
  let memoryOrder = 3;
  let pointsRegister = 291;
  let behaviour = "Image of the output terminals. What the last write of a scan left is sent out at END.";
}
def DevM : Device<"M", "internal relay", Bit, 10, 6144> {
  let memoryOrder = 4;
  let pointsRegister = 292;
  let behaviour = "One bit for the program's own use.";
}
def DevB : Device<"B", "link relay", Bit, 16, 2048> {
  let memoryOrder = 5;
  let pointsRegister = 294;
  let behaviour = "One bit that a network module may refresh; otherwise as M.";
}
def DevF : Device<"F", "annunciator", Bit, 10, 1024> {
  let memoryOrder = 6;
  let pointsRegister = 295;
  let behaviour = "A fault message of the program. OUT F and SET F also enter its number in SD62-SD79 and light the USER LED, RST "
                  "F takes it out; other instructions change the bit only.";
}
def DevSB : Device<"SB", "link special relay", Bit, 16, 1536> {
  let memoryOrder = 7;
  let pointsRegister = 296;
  let behaviour = "One bit of network state.";
}
def DevV : Device<"V", "edge relay", Bit, 10, 1024> {
  let memoryOrder = 8;
  let pointsRegister = 297;
  let behaviour = "Memory of one EGP or EGF: the result that the instruction saw last. Not usable as a contact.";
}
def DevSM : Device<"SM", "special relay", Bit, 10, 5120> {
  let memoryOrder = 1;
  let image = "sys.SM";
  let behaviour = "State of the CPU and switches for it, see the list of special devices. Only SM1000-SM1299 may serve safety "
                  "functions.";
}
def DevT : Device<"T", "timer", TimerDevice, 10, 512> {
  let memoryOrder = 9;
  let pointsRegister = 299;
  let behaviour = "Contact, coil and current value of a timer. It is a low-speed or a high-speed one by the instruction that "
                  "drives it (OUT T or OUTH T). As a bit it is the contact, as a word the current value; bits of the value cannot "
                  "be named.";
}
def DevST : Device<"ST", "retentive timer", TimerDevice, 10, 0> {
  let memoryOrder = 10;
  let pointsRegister = 300;
  let behaviour = "A timer that keeps contact and current value while its condition is OFF; RST ST clears it. There are none until "
                  "the parameters allocate some.";
}
def DevC : Device<"C", "counter", CounterDevice, 10, 512> {
  let memoryOrder = 11;
  let pointsRegister = 301;
  let behaviour = "Contact, coil and current value of a counter. As a bit it is the contact, as a word the current value; bits of "
                  "the value cannot be named.";
}
def DevD : Device<"D", "data register", Word, 10, 6144> {
  let memoryOrder = 12;
  let pointsRegister = 302;
  let bitOfWord = 1;
  let behaviour = "16 bits for the program's own use; 32-bit data take two, the lower number is the low word.";
}
def DevW : Device<"W", "link register", Word, 16, 2048> {
  let memoryOrder = 13;
  let pointsRegister = 303;
  let bitOfWord = 1;
  let behaviour = "16 bits that a network module may refresh; otherwise as D.";
}
def DevSW : Device<"SW", "link special register", Word, 16, 1536> {
  let memoryOrder = 15;  // an empty area lies behind W
  let pointsRegister = 304;
  let bitOfWord = 1;
  let behaviour = "16 bits of network state.";
}
def DevSD : Device<"SD", "special register", Word, 10, 5120> {
  let memoryOrder = 16;
  let bitOfWord = 1;
  let image = "sys.SD";
  let behaviour = "Data of the CPU, see the list of special devices. Only SD1000-SD1299 may serve safety functions.";
}
def DevN : Device<"N", "nesting level", Nesting, 10, 15> {
  let behaviour = "Level of a master control region; no memory.";
}
}

// Which devices the operands of melsec/operands.td take. T, ST and C are contacts where a bit is read and current values where a
// word is meant.
def ContactBits : Classes<[DevX, DevY, DevM, DevSM, DevF, DevB, DevSB, DevT, DevST, DevC], [DevD, DevW, DevSD, DevSW]>;
def CoilBits : Classes<[DevX, DevY, DevM, DevSM, DevB, DevSB], [DevD, DevW, DevSD, DevSW]>;
def PulseBits : Classes<[DevX, DevY, DevM, DevSM, DevF, DevB, DevSB], [DevD, DevW, DevSD, DevSW]>;
def EdgeRelays : Classes<[DevV]>;
def Annunciators : Classes<[DevF]>;
def PlainTimers : Classes<[DevT]>;
def RetentiveTimers : Classes<[DevST]>;
def AllTimers : Classes<[DevT, DevST]>;
def AllCounters : Classes<[DevC]>;
def DataWords : Classes<[DevT, DevST, DevC, DevD, DevW, DevSD, DevSW], [], [DevX, DevY, DevM, DevSM, DevF, DevB, DevSB]>;
def PlainWords : Classes<[DevD, DevW, DevSD, DevSW]>;
def Levels : Classes<[DevN]>;
def NoDevices : Classes<[]>;
