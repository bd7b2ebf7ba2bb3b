// Special relays and registers of the QS001CPU.
//
// A record is one device, or a run of them where all have the same meaning. "Simulated" ones are kept by the runtime; the others
// are memory that a host may fill with what its hardware knows.

class SystemRelay<int n, string name, string b, bit simulated, string sec> : Special<"SM" # n, name, b, 0, simulated, sec>;
class UserRelay<int n, string name, string b, bit simulated, string sec> : Special<"SM" # n, name, b, 1, simulated, sec>;
class SystemRegister<int n, string name, string b, bit simulated, string sec> : Special<"SD" # n, name, b, 0, simulated, sec>;
class UserRegister<int n, string name, string b, bit simulated, string sec> : Special<"SD" # n, name, b, 1, simulated, sec>;
class RegisterRun<int first, int last, string name, string b, bit w, string sec>
    : Special<"SD" # first # "-SD" # last, name, b, w, 0, sec>;

// ---------------------------------------------------------------------------------------------- relays: diagnosis
defvar DiagnosisRelays = "app. 2(1)";
def : SystemRelay<0, "diagnosis error", "ON after any error, an annunciator and S.QSABORT included. Stays ON when the cause has "
                                        "gone.", 1,
                  DiagnosisRelays>;
def : SystemRelay<1, "self-diagnosis error", "ON after an error that the CPU found itself; annunciators and S.QSABORT leave it "
                                             "OFF. Stays ON when the cause has gone.", 1, DiagnosisRelays>;
def : SystemRelay<5, "common error information", "ON while SM0 is ON and SD5-SD15 say more about the error.", 1, DiagnosisRelays>;
def : SystemRelay<16, "individual error information", "ON while SM0 is ON and SD16-SD26 say more about the error.", 1,
                  DiagnosisRelays>;
def : UserRelay<50, "error reset", "Turning it ON clears the error whose code stands in SD50, if the CPU can go on with it.", 1,
                DiagnosisRelays>;
def : SystemRelay<51, "battery low, latched", "ON when the battery voltage fell too low; stays ON after the battery is replaced.",
                  0, DiagnosisRelays>;
def : SystemRelay<52, "battery low", "ON while the battery voltage is too low.", 0, DiagnosisRelays>;
def : SystemRelay<53, "momentary power failure", "ON after an AC supply failed for up to 20 ms, until the power is switched off "
                                                 "and on.", 0,
                  DiagnosisRelays>;
def : SystemRelay<56, "operation error", "ON after error 4100 or 4101. Stays ON.", 1, DiagnosisRelays>;
def : SystemRelay<61, "I/O module verify error", "ON after an I/O module was found to differ from what was mounted at power-on.", 0,
                  DiagnosisRelays>;
def : SystemRelay<62, "annunciator detected", "ON while an annunciator is entered in SD64-SD79.", 1, DiagnosisRelays>;

// ---------------------------------------------------------------------------------------------- relays: system and clocks
def : SystemRelay<203, "STOP", "ON while the CPU is in STOP.", 1, "app. 2(2)">;
def : UserRelay<213, "clock read request", "While ON, the CPU's clock is shown in SD210-SD213.", 1, "app. 2(2)">;
def : SystemRelay<232, "ROM write count", "ON when the ROM has been written more than 100,000 times.", 0, "app. 2(2)">;
defvar ClockRelays = "app. 2(3)";
let constant = 1 in
def : SystemRelay<400, "always ON", "ON in every scan.", 1, ClockRelays>;
let constant = 0 in
def : SystemRelay<401, "always OFF", "OFF in every scan.", 1, ClockRelays>;
def : SystemRelay<402, "first scan ON", "ON in the first scan after the change to RUN only.", 1, ClockRelays>;
def : SystemRelay<403, "first scan OFF", "OFF in the first scan after the change to RUN only.", 1, ClockRelays>;
class ClockRelay<int n, string period, string half>
    : SystemRelay<n, period # " clock", "Half of the period (" # half # ") OFF, half of it ON; begins OFF at power-on and reset.",
                  1, ClockRelays>;
def : ClockRelay<410, "0.1 second", "0.05 s">;
def : ClockRelay<411, "0.2 second", "0.1 s">;
def : ClockRelay<412, "1 second", "0.5 s">;
def : ClockRelay<413, "2 second", "1 s">;
def : SystemRelay<414, "2n second clock", "n seconds OFF, n seconds ON; n stands in SD414. Begins OFF at power-on and reset.", 1,
                  ClockRelays>;

// ---------------------------------------------------------------------------------------------- relays: safety
def : SystemRelay<560, "TEST MODE", "ON in TEST MODE, OFF in both SAFETY MODEs.", 1, "app. 2(4)">;
def : SystemRelay<561, "TEST MODE too long", "ON when TEST MODE has lasted longer than the parameters allow.", 0, "app. 2(4)">;
def : SystemRelay<660, "boot operation", "ON in SAFETY MODE; in TEST MODE ON while the program is copied from ROM.", 1,
                  "app. 2(5)">;
def : UserRelay<722, "BIN and DBIN without error", "While ON, BIN and DBIN do not report a digit above 9; they do nothing instead.",
                1, "app. 2(6)">;
foreach master = [1, 2] in
def : SystemRelay<!add(804, !mul(200, master)), "station refresh error, safety master " # master,
                  "ON while a safety station does not communicate; the SD of the same number and the three behind it tell "
                  "which.", 0,
                  "app. 2(7)">;

// ---------------------------------------------------------------------------------------------- registers: error information
defvar DiagnosisRegisters = "app. 3(1)";
def : SystemRegister<0, "error code", "Code of the latest error, 0 while there is none.", 1, DiagnosisRegisters>;
def : SystemRegister<1, "time of the error: year, month", "BCD: year in b15-b8 (two digits), month in b7-b0.", 1,
                     DiagnosisRegisters>;
def : SystemRegister<2, "time of the error: day, hour", "BCD: day in b15-b8, hour in b7-b0.", 1, DiagnosisRegisters>;
def : SystemRegister<3, "time of the error: minute, second", "BCD: minute in b15-b8, second in b7-b0.", 1, DiagnosisRegisters>;
def : SystemRegister<4, "kind of error information",
                     "b7-b0 say what SD5-SD15 hold: 0 nothing, 1 module or base, 2 file and drive, 3 time as set, 4 place in the "
                     "program, 9 CC-Link Safety, 10 module and station. b15-b8 say what SD16-SD26 hold: 0 nothing, 1 module or "
                     "base, 2 file and drive, 3 time as measured, 4 place in the program, 5 parameter number, 6 annunciator, 9 "
                     "error information, 10 CC-Link Safety, 11 abort code, 12 file diagnosis.", 1, DiagnosisRegisters>;
class CommonWord<int n, string b> : SystemRegister<n, "common error information, word " # !sub(n, 4), b, 1, DiagnosisRegisters>;
def : CommonWord<5, "By the kind in SD4. 1, 10: slot or base, 255 beyond the last slot. 2: drive. 3: microseconds. 4: characters 1 "
                    "and 2 of the program name, the first in the low byte. 9: class of the error.">;
def : CommonWord<6, "1, 10: I/O number, HFFFF where unknown. 2: file name. 3: milliseconds. 4: characters 3 and 4. 9: item of the "
                    "error.">;
def : CommonWord<7, "2: file name. 4: characters 5 and 6. 9: link ID. 10: station.">;
def : CommonWord<8, "2: file name. 4: characters 7 and 8. 9: station.">;
def : CommonWord<9, "2, 4: a dot (H2E) and the first character of the extension. 9: for the system.">;
def : CommonWord<10, "2, 4: the rest of the extension. 9: for the system.">;
def : CommonWord<11, "4: 0. 9: for the system.">;
def : CommonWord<12, "4: block, 0. 9: for the system.">;
def : CommonWord<13, "4: step of a block, 0. 9: for the system.">;
def : CommonWord<14, "4: step of the program, low word. 9: for the system.">;
def : CommonWord<15, "4: step of the program, high word. 9: for the system.">;
class IndividualWord<int n, string b> : SystemRegister<n, "individual error information, word " # !sub(n, 15), b, 1,
                     DiagnosisRegisters>;
def : IndividualWord<16, "By the kind in SD4. 2, 12: drive. 3: microseconds. 5: parameter number. 6: annunciator number. 9: error "
                         "information. 10: number of items. 11: abort code.">;
def : IndividualWord<17, "2, 12: file name. 3: milliseconds. 9: error information. 11: 0.">;
foreach n = [18, 19] in
def : IndividualWord<n, "2, 12: file name. 9: error information. 11: 0.">;
def : IndividualWord<20, "2, 12: file name or dot. 9: error information. 11: 0.">;
foreach n = [21, 22] in
def : IndividualWord<n, "2, 12: extension of the file. 9: error information. 11: 0.">;
def : IndividualWord<23, "4: block. 9: error information. 11: 0.">;
def : IndividualWord<24, "4: step of a block. 9: error information. 11: 0.">;
def : IndividualWord<25, "4: step of the program, low word. 9: error information. 11: 0.">;
def : IndividualWord<26, "4: step of the program, high word. 9: error information. 11: 0.">;
def : SystemRegister<27, "CPU that found the error", "1: CPU A. 2: CPU B.", 1, DiagnosisRegisters>;
def : UserRegister<50, "code to reset", "Code of the error that SM50 clears; the last digit does not count.", 1,
                   DiagnosisRegisters>;
def : SystemRegister<51, "battery low, latched", "Bits that stay 1 after the battery is replaced.", 0, DiagnosisRegisters>;
def : SystemRegister<52, "battery low", "Bits that are 1 while the battery voltage is too low.", 0, DiagnosisRegisters>;
def : SystemRegister<53, "power failures", "Counts how often the supply fell to 85 % or less.", 0, DiagnosisRegisters>;
def : SystemRegister<61, "I/O module verify error", "Lowest I/O number of the modules that differ.", 0, DiagnosisRegisters>;
def : SystemRegister<62, "annunciator number", "The annunciator that was entered first, as SD64; 0 where there is none.", 1,
                     DiagnosisRegisters>;
def : SystemRegister<63, "number of annunciators", "How many entries SD64-SD79 have, 0 to 16.", 1, DiagnosisRegisters>;
foreach n = !range(64, 80) in
def : SystemRegister<n, "annunciator entry " # !sub(n, 63),
                     "Number of an annunciator, in the order in which they turned ON; 0 where the list has ended. RST F takes an "
                     "entry out and moves those behind it up.", 1, DiagnosisRegisters>;
def : SystemRegister<81, "causes of errors that let the CPU go on",
                     "A bit for each: 0 momentary power failure, 1 battery, 2 ROM write count, 3 time in TEST MODE, 4 scan time, 5 "
                     "annunciator, 6 safety remote station, 7 wrong product, 8 timeout of a station, 9 data of a station. Cleared "
                     "with the error and by power-on or reset.", 1, DiagnosisRegisters>;
def : RegisterRun<150, 153, "blown fuses", "A bit for each output module.", 0, "9.1.4">;

// ---------------------------------------------------------------------------------------------- registers: system
defvar SystemRegisters = "app. 3(2)";
def : SystemRegister<210, "clock: year, month", "BCD, shown while SM213 is ON: year in b15-b8 (two digits), month in b7-b0.", 1,
                     SystemRegisters>;
def : SystemRegister<211, "clock: day, hour", "BCD: day in b15-b8, hour in b7-b0.", 1, SystemRegisters>;
def : SystemRegister<212, "clock: minute, second", "BCD: minute in b15-b8, second in b7-b0.", 1, SystemRegisters>;
def : SystemRegister<213, "clock: century, weekday", "BCD: first two digits of the year in b15-b8, weekday in b7-b0, 0 is Sunday.",
                     1, SystemRegisters>;
def : SystemRegister<232, "ROM writes, low word", "How often the ROM has been written, 32 bits with SD233.", 0, SystemRegisters>;
def : SystemRegister<233, "ROM writes, high word", "High word of SD232.", 0, SystemRegisters>;
def : SystemRegister<240, "base mode", "0: automatic.", 0, SystemRegisters>;
def : SystemRegister<241, "extension bases", "0: there are none.", 0, SystemRegisters>;
def : SystemRegister<242, "kind of base", "1: a QS base, 0: none.", 0, SystemRegisters>;
def : SystemRegister<243, "slots in operation", "Slots of each base as the parameters say, with SD244.", 0, SystemRegisters>;
def : SystemRegister<244, "slots in operation, second word", "Goes on from SD243.", 0, SystemRegisters>;
def : SystemRegister<245, "slots mounted", "Slots of each base as found, with SD246.", 0, SystemRegisters>;
def : SystemRegister<246, "slots mounted, second word", "Goes on from SD245.", 0, SystemRegisters>;
def : SystemRegister<250, "highest I/O number", "The I/O number behind the last module, without its last digit.", 0,
                     SystemRegisters>;
defvar NetworkWords = ["number of modules", "I/O number", "network number", "group number", "station number"];
foreach n = !range(0, 5) in
def : SystemRegister<!add(254, n), !strconcat("MELSECNET/H: ", NetworkWords[n]), "Of the mounted network module.", 0,
                     SystemRegisters>;
// The allocation is in the order X Y M (L) B F SB V (S) T ST C D W SW; QS has neither L nor S.
class PointsRegister<Device d>
    : SystemRegister<d.pointsRegister, "points of " # d.prefix, "Allocated number of " # d.prefix # ", as the parameters say.", 1,
                     SystemRegisters>;
foreach d = [DevX, DevY, DevM, DevB, DevF, DevSB, DevV, DevT, DevST, DevC, DevD, DevW, DevSW] in
def : PointsRegister<d>;

// ---------------------------------------------------------------------------------------------- registers: clocks and times
def : SystemRegister<412, "seconds", "Counts the seconds of RUN; 32767 is followed by -32768.", 1, "app. 3(3)">;
def : UserRegister<414, "n of the 2n second clock", "Half of the period of SM414 in seconds, 1 to 32767; 30 until it is written.",
                   1, "app. 3(3)">;
def : SystemRegister<420, "scans", "Counts the scans of RUN; 32767 is followed by -32768.", 1, "app. 3(3)">;
class TimeWords<int n, string what, bit kept> { int number = n; string text = what; bit simulated = kept; }
foreach t = [TimeWords<520, "scan time", 1>, TimeWords<524, "shortest scan time", 1>, TimeWords<526, "longest scan time", 1>,
             TimeWords<540, "END processing time", 0>, TimeWords<542, "waiting time of the constant scan", 0>,
             TimeWords<548, "program execution time", 0>] in {
def : SystemRegister<t.number, t.text # ", milliseconds", "Whole milliseconds, 0 to 6553.", t.simulated, "app. 3(4)">;
def : SystemRegister<!add(t.number, 1), t.text # ", microseconds", "What is left in microseconds, in steps of 100.", t.simulated,
                     "app. 3(4)">;
}

// ---------------------------------------------------------------------------------------------- registers: safety
def : SystemRegister<560, "operation mode", "b1-b0: 00 SAFETY MODE, 01 TEST MODE, 10 SAFETY MODE waiting for restart.", 1,
                     "app. 3(5)">;
def : SystemRegister<561, "time in TEST MODE, low word", "Seconds of RUN in TEST MODE, 32 bits with SD562.", 0, "app. 3(5)">;
def : SystemRegister<562, "time in TEST MODE, high word", "High word of SD561.", 0, "app. 3(5)">;
def : SystemRegister<620, "memory card", "Kind of drive 4 in b7-b4: 3, flash ROM.", 0, "app. 3(6)">;
def : SystemRegister<623, "capacity of drive 4", "In units of 1 KB.", 0, "app. 3(6)">;
class StationRun<int master, int offset, int count, string name, string b, bit w>
    : RegisterRun<!add(800, !mul(200, master), offset), !add(800, !mul(200, master), offset, count, -1),
                  name # ", safety master " # master, b, w, "app. 3(7)">;
foreach master = [1, 2] in {
def : StationRun<master, 0, 4, "stations", "A bit for each of stations 1 to 64: 1 for a safety remote station.", 0>;
def : StationRun<master, 4, 4, "station refresh errors", "A bit for each of stations 1 to 64: 1 while it does not communicate.", 0>;
def : StationRun<master, 8, 64, "station state", "A word for each of stations 1 to 64: 0 normal, 10 initializing, 20 reading data, "
                                                 "30 link error, else the error code (8300 to 8334).", 0>;
def : StationRun<master, 72, 4, "station interlock", "A bit for each of stations 1 to 64: 1 while its I/O is interlocked after an "
                                                     "error.", 0>;
def : StationRun<master, 76, 4, "station interlock release", "A bit for each of stations 1 to 64: turning it ON releases the "
                                                             "interlock.", 1>;
}
