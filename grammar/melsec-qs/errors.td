// Error codes of the QS001CPU, as SD0 shows them. Most name faults of hardware or parameters that a compiled program never has;
// they are here so that a code read from a controller can be looked up.

class Stop<int c, string n, string why, string what, string sec> : ErrorCode<c, n, why, what, 1, sec>;
class GoesOn<int c, string n, string why, string what, string sec> : ErrorCode<c, n, why, what, 0, sec>;

defvar CheckNoise = "Look for sources of noise and reset the CPU. Replace the CPU if the error comes back.";
defvar ReplaceCpu = "Replace the CPU.";
defvar CheckNetwork = "Compare the network parameters with the modules and write them again. Replace the module if the error comes "
                      "back.";
defvar CheckStation = "Look at the remote station. The parameters say whether the CPU stops; by default it does.";

// ---------------------------------------------------------------------------------------------- CPU and modules
foreach c = [1000, 1001, 1002, 1003, 1004, 1006] in
def : Stop<c, "MAIN CPU DOWN", "The CPU ran out of control, through noise or a fault of its hardware.", CheckNoise, "9.1.3">;
def : Stop<1009, "MAIN CPU DOWN", "Power supply, CPU or base unit is faulty.", CheckNoise, "9.1.3">;
def : Stop<1010, "END NOT EXECUTE", "The program ran past its END, which the CPU read as something else.", CheckNoise, "9.1.3">;
foreach c = [1030, 1031] in
def : Stop<c, "MAIN CPU DOWN", "The CPU ran out of control or is faulty.", CheckNoise, "9.1.3">;
foreach c = [1131, 1132, 1133, 1136, 1137, 1141, 1142, 1143] in
def : Stop<c, "RAM ERROR", "The check at power-on found a fault in the CPU's memory.", ReplaceCpu, "9.1.3">;
def : Stop<1146, "RAM ERROR", "A fault in the CPU's memory was found while it was running.", ReplaceCpu, "9.1.3">;
def : Stop<1210, "OPERATION CIRCUIT ERROR", "The circuit that executes programs does not work.", ReplaceCpu, "9.1.3">;
def : Stop<1311, "I/O INTERRUPT ERROR", "A module asked for an interrupt; this CPU has no interrupt programs.",
           "Replace module, CPU or base.", "9.1.3">;
def : Stop<1401, "INTELLIGENT FUNCTION MODULE DOWN", "A module did not answer at initialization or reports an impossible buffer "
                                                     "size.",
           "Replace module, CPU or base.", "9.1.3">;
def : Stop<1403, "INTELLIGENT FUNCTION MODULE DOWN", "A module failed its own test or did not answer at END.",
           "Look at the module.", "9.1.3">;
def : Stop<1411, "CONTROL-BUS ERROR", "A module could not be reached during the I/O assignment.",
           "Reset the CPU. Replace module, CPU or base if the error comes back.", "9.1.3">;
foreach c = [1413, 1414] in
def : Stop<c, "CONTROL-BUS ERROR", "The system bus is faulty.", "Replace module, CPU or base.", "9.1.3">;
def : Stop<1415, "CONTROL-BUS ERROR", "The base unit is faulty.", "Replace the base unit.", "9.1.3">;
def : GoesOn<1500, "AC/DC DOWN", "The supply failed for a moment or was switched off.", "Look at the power supply.", "9.1.3">;
def : GoesOn<1600, "BATTERY ERROR", "The battery is low or not connected.", "Connect or replace the battery.", "9.1.3">;
def : GoesOn<1610, "EXCEED MAX FLASH ROM REWRIT. ERR.", "The flash memory has been written more than 100,000 times.", ReplaceCpu,
             "9.1.3">;

def : Stop<2000, "MODULE VERIFY ERROR", "A module was taken out, exchanged or came loose after power-on.",
           "Look at the module whose number SD5 and SD6 show.", "9.1.4">;
defvar CorrectAssignment = "Correct the I/O assignment.";
def : Stop<2100, "MODULE LAYOUT ERROR", "The I/O assignment expects another kind of module in a slot, or fewer points than the "
                                        "module has.",
           CorrectAssignment, "9.1.4">;
def : Stop<2106, "MODULE LAYOUT ERROR", "More than one MELSECNET/H module or more than two CC-Link Safety masters are mounted.",
           "Take the surplus modules out.", "9.1.4">;
def : Stop<2107, "MODULE LAYOUT ERROR", "Two modules have the same I/O numbers.", CorrectAssignment, "9.1.4">;
def : Stop<2124, "MODULE LAYOUT ERROR", "A module lies beyond the I/O points that the CPU has.", CorrectAssignment, "9.1.4">;
def : Stop<2125, "MODULE LAYOUT ERROR", "The CPU does not know a module, or gets no answer from it.", "Replace the module.",
           "9.1.4">;
def : Stop<2200, "MISSING PARAMETER", "The program memory has no parameter file.", "Write the parameters.", "9.1.4">;
def : Stop<2210, "BOOT ERROR", "The contents of the boot file make no sense.", "Correct the boot settings.", "9.1.4">;
def : Stop<2500, "CAN'T EXECUTE PROGRAM", "The program names a device beyond the points that the parameters allocate.",
           "Allocate more points or change the program.", "9.1.4">;
def : Stop<2501, "CAN'T EXECUTE PROGRAM", "There are too many program files, or a file does not have the name of its program.",
           "Delete what is not needed.", "9.1.4">;
def : Stop<2502, "CAN'T EXECUTE PROGRAM", "The file is no sequence program.", "Write the program again.", "9.1.4">;
def : Stop<2503, "CAN'T EXECUTE PROGRAM", "There is no program file.", "Write the program.", "9.1.4">;

// ---------------------------------------------------------------------------------------------- parameters
def : Stop<3000, "PARAMETER ERROR", "Timer units, RUN contact or empty slots are set to what the CPU does not have.",
           "Correct the parameter whose number SD16 shows.", "9.1.5">;
def : Stop<3001, "PARAMETER ERROR", "The parameter file is damaged.", "Write the parameters again.", "9.1.5">;
def : Stop<3003, "PARAMETER ERROR", "More device points are allocated than the CPU has.", "Correct the allocation.", "9.1.5">;
def : Stop<3004, "PARAMETER ERROR", "The file is no parameter file.", "Write the parameters again.", "9.1.5">;
def : Stop<3008, "PARAMETER ERROR", "New parameters were written and neither the power switched nor the CPU reset since.",
           "Switch the power off and on, or reset.", "9.1.5">;
def : Stop<3100, "NETWORK PARAMETER ERROR", "MELSECNET/H modules differ from the parameters in number, address or station type.",
           CheckNetwork, "9.1.5">;
def : Stop<3101, "NETWORK PARAMETER ERROR", "The address of a MELSECNET/H module or its refresh area is wrong.", CheckNetwork,
           "9.1.5">;
def : Stop<3102, "NETWORK PARAMETER ERROR", "A network module refuses its parameters.", CheckNetwork, "9.1.5">;
def : Stop<3104, "NETWORK PARAMETER ERROR", "A network, station, group or I/O number is out of range.", CheckNetwork, "9.1.5">;
def : Stop<3105, "CC-LINK PARAMETER ERROR", "A CC-Link module of the parameters is missing or has another address or station type.",
           CheckNetwork, "9.1.5">;
def : Stop<3106, "CC-LINK PARAMETER ERROR", "The CC-Link refresh area is out of range.", CheckNetwork, "9.1.5">;
def : Stop<3107, "CC-LINK PARAMETER ERROR", "The CC-Link parameters are wrong.", CheckNetwork, "9.1.5">;

// ---------------------------------------------------------------------------------------------- program
defvar LookAtStep = "Look at the step that SD14 and SD15 show.";
def : Stop<4000, "INSTRUCTION CODE ERROR", "The program has an instruction that this CPU does not have.", LookAtStep, "9.1.6">;
def : Stop<4002, "INSTRUCTION CODE ERROR", "The name of an extended instruction is unknown to the CPU or to the module.",
           LookAtStep, "9.1.6">;
def : Stop<4003, "INSTRUCTION CODE ERROR", "An extended instruction has too many or too few operands.", LookAtStep, "9.1.6">;
def : Stop<4004, "INSTRUCTION CODE ERROR", "An extended instruction has an operand that it cannot use.", LookAtStep, "9.1.6">;
def : Stop<4010, "MISSING END INSTRUCTION", "The program does not end with END.", "Add END.", "9.1.6">;
def : Stop<4100, "OPERATION ERROR", "An instruction met data that it cannot work on: a divisor of 0, a BCD digit above 9, a number "
                                    "with too many digits.", LookAtStep, "9.1.6">;
def : Stop<4101, "OPERATION ERROR", "A block of devices crosses the end of its device class, or a count is out of range.",
           LookAtStep, "9.1.6">;
def : Stop<4700, "PROGRAM ABORT EXECUTED", "The program executed S.QSABORT.", "SD16 is the abort code: remove what it stands for.",
           "9.1.6">;

def : Stop<5001, "WDT ERROR", "A scan took longer than the watchdog time.", "Make the scan shorter or the watchdog time longer.",
           "9.1.7">;
def : GoesOn<5010, "PROGRAM SCAN TIME OVER", "A scan took longer than the constant scan time.", "Set a longer constant scan time.",
             "9.1.7">;

// ---------------------------------------------------------------------------------------------- safety functions
def : Stop<8000, "INTERNAL REGISTER ERROR", "The test of the CPU's registers failed.", ReplaceCpu, "9.1.8">;
def : Stop<8010, "INTERNAL BUS ERROR", "The CPU's internal bus is faulty.", ReplaceCpu, "9.1.8">;
def : Stop<8020, "CPU A & B CAN'T BE SYNCHRONIZED", "CPU A and CPU B are not at the same point of execution.", CheckNoise, "9.1.8">;
def : Stop<8021, "CPU A & B CAN'T BE SYNCHRONIZED", "CPU A and CPU B took different times for the program.", CheckNoise, "9.1.8">;
foreach c = [8031, 8032] in
def : Stop<c, "INCORRECT FILE", "A file of the program memory or of the ROM is damaged.",
           "Write the file that SD16 to SD22 name again and switch the power off and on.", "9.1.8">;
def : Stop<8050, "SAFETY OUTPUT VERIFY ERROR", "CPU A and CPU B want different states of a safety output.",
           "Check what drives the safety outputs; look for sources of noise.", "9.1.8">;
def : Stop<8060, "INCORRECT FIRMWARE", "The CPU's firmware is damaged.", CheckNoise, "9.1.8">;
foreach c = [8070, 8071, 8072, 8073, 8074] in
def : Stop<c, "INTERNAL CPU COMMUNICATION ERROR",
           !cond(!eq(c, 8070): "CPU A and CPU B could not begin to talk to each other.",
                 !or(!eq(c, 8071), !eq(c, 8073)): "CPU A and CPU B lost contact while sending.",
                 true: "CPU A and CPU B lost contact while receiving."),
           CheckNoise, "9.1.8">;
def : Stop<8080, "POWER SUPPLY ERROR", "The voltage inside the CPU is out of range.", CheckNoise, "9.1.8">;
def : Stop<8090, "VOLTAGE DIAGNOSIS ERROR", "The circuit that watches the voltage is faulty.", CheckNoise, "9.1.8">;
def : GoesOn<8100, "TEST MODE TIME EXCEEDED", "The CPU has been in TEST MODE for longer than the parameters allow.",
             "Go back to SAFETY MODE.", "9.1.8">;
def : Stop<8120, "WDT CLOCK CHECK ERROR", "The clock of the watchdog has stopped.", CheckNoise, "9.1.8">;
def : Stop<8300, "CC-LINK REMOTE DETECTION ERROR", "A CC-Link Safety remote station reports an error.", CheckStation, "9.1.8">;
def : Stop<8310, "CC-LINK PRODUCT INFO. MISMATCH", "A remote station is another product than the network parameters say.",
           CheckStation, "9.1.8">;
def : Stop<8320, "CC-LINK DATA RECEPTION TIMEOUT", "A remote station did not answer while it was initialized.", CheckStation,
           "9.1.8">;
def : Stop<8321, "CC-LINK DATA RECEPTION TIMEOUT", "A remote station stopped answering.", CheckStation, "9.1.8">;
def : Stop<8322, "CC-LINK DATA RECEPTION TIMEOUT", "A remote station did not answer when its error data were read.", CheckStation,
           "9.1.8">;
def : Stop<8330, "CC-LINK RECEIVED DATA ERROR", "A remote station sent another command than was due.", CheckStation, "9.1.8">;
def : Stop<8331, "CC-LINK RECEIVED DATA ERROR", "Part of a message from a remote station is missing.", CheckStation, "9.1.8">;
def : Stop<8332, "CC-LINK RECEIVED DATA ERROR", "A message came with another link ID.", CheckStation, "9.1.8">;
def : Stop<8333, "CC-LINK RECEIVED DATA ERROR", "A message came out of order.", CheckStation, "9.1.8">;
def : Stop<8334, "CC-LINK RECEIVED DATA ERROR", "The parts of a message cannot be put together.", CheckStation, "9.1.8">;

def : GoesOn<9000, "F****", "The program turned an annunciator ON; **** is its number.", "Look up what the annunciator means; SD16 "
                                                                                         "is its number.", "9.1.8">;

// 4000H to 4FFFH go back to the partner whose request failed and never reach SD0; one record stands for all.
def : GoesOn<0x4000, "(communication error, 4000H-4FFFH)", "A request from a programming tool, a module or the network could not "
                                                           "be served.", "See the hardware manual.", "9.1">;
