// Special relays M8000-M8511 and special registers D8000-D8511.
//
// "Simulated" ones are kept by the runtime, or obeyed where the program writes them; the others are memory that a host may fill
// with what its hardware knows. Numbers without a record are not described by the manual: memory that nobody looks at.

class SystemRelay<int n, string name, string b, bit simulated, string sec> : Special<"M" # n, name, b, 0, simulated, sec>;
class UserRelay<int n, string name, string b, bit simulated, string sec> : Special<"M" # n, name, b, 1, simulated, sec>;
class SystemRegister<int n, string name, string b, bit simulated, string sec> : Special<"D" # n, name, b, 0, simulated, sec>;
class UserRegister<int n, string name, string b, bit simulated, string sec> : Special<"D" # n, name, b, 1, simulated, sec>;

// -------------------------------------------------------------------------------- relays: RUN, errors, battery
let constant = 1 in
def : SystemRelay<8000, "RUN monitor", "ON in every scan, OFF in STOP.", 1, "7.1">;
let constant = 0 in
def : SystemRelay<8001, "RUN monitor, inverted", "OFF in every scan, ON in STOP.", 1, "7.1">;
def : SystemRelay<8002, "first scan", "ON in the first scan after the change to RUN only.", 1, "7.1">;
def : SystemRelay<8003, "first scan, inverted", "OFF in the first scan after the change to RUN only.", 1, "7.1">;
def : SystemRelay<8004, "an error exists", "ON while any of M8060-M8067 is ON.", 1, "7.4">;
def : SystemRelay<8005, "battery low", "ON while the voltage of the battery is too low.", 0, "7.1">;
def : SystemRelay<8006, "battery low, latched", "Stays ON when the voltage of the battery was too low.", 0, "7.1">;
def : SystemRelay<8007, "battery was low", "Stays ON when the voltage of the battery was too low.", 0, "7.1">;

// -------------------------------------------------------------------------------- relays: clocks
class ClockRelay<int n, string period>
    : SystemRelay<n, period # " clock",
                  "Half of the period OFF, half of it ON, from power-on on and in STOP too; looked at once a scan.", 1, "7.1">;
def : ClockRelay<8011, "10 ms">;
def : ClockRelay<8012, "100 ms">;
def : ClockRelay<8013, "1 s">;
def : ClockRelay<8014, "1 min">;
def : UserRelay<8015, "set the real-time clock",
      "ON: the clock stands and D8013-D8019 may be written. ON to OFF: they become the time, unless there is no such date. "
      "While OFF they show the clock, whatever is written.", 1, "7.1">;

// -------------------------------------------------------------------------------- relays: flags of instructions
def : SystemRelay<8020, "zero", "A calculation gave 0; also bit counts, reals, and an empty queue (SFRD).", 1, "5.1">;
def : SystemRelay<8021, "borrow",
      "A result was below the smallest number; for reals also too small to be shown; SQR and INT: a fraction was "
      "dropped.", 1, "5.1">;
def : SystemRelay<8022, "carry",
      "A result was above the largest number; the bit that a rotation moved out; a full queue (SFWR).", 1, "5.1">;
def : UserRelay<8024, "BMOV backwards", "ON: BMOV transfers from its destination to its source.", 1, "F15">;
def : UserRelay<8026, "RAMP mode", "ON: RAMP holds the final value; OFF: it begins anew.", 1, "F67">;
def : UserRelay<8027, "PR mode", "ON: PR puts out 1-16 characters, up to a NUL; OFF: 8.", 1, "F77">;
def : SystemRelay<8029, "execution complete",
      "An instruction that takes several scans has finished. All of them share it, so it is to be tested directly behind the "
      "instruction.", 1, "5.1">;

// -------------------------------------------------------------------------------- relays: memory, outputs, mode
def : UserRelay<8031, "clear what is not latched",
      "ON: END clears X, Y, the M, S, T, C and D that are not latched, with coils, reset coils and current values.", 1, "7.1">;
def : UserRelay<8032, "clear what is latched",
      "ON: END clears the latched M, S, C and D, the accumulating timers and the high-speed counters, with coils, reset coils "
      "and current values.", 1, "7.1">;
def : UserRelay<8033, "hold memory in STOP",
      "ON when the switch goes to STOP: outputs and all other devices keep their state.", 1, "7.1">;
def : UserRelay<8034, "disable outputs", "ON: all output terminals are OFF. The program and the image of Y go on.", 1, "7.1">;
def : UserRelay<8035, "forced RUN mode", "Lets inputs command RUN and STOP.", 0, "7.1">;
def : UserRelay<8036, "forced RUN", "RUN command of the forced mode.", 0, "7.1">;
def : UserRelay<8037, "forced STOP", "STOP command of the forced mode.", 0, "7.1">;
def : UserRelay<8039, "constant scan", "ON: a scan takes D8039 ms at least. The host keeps it.", 0, "7.1">;

// -------------------------------------------------------------------------------- relays: step ladder, IST, annunciators
def : UserRelay<8040, "inhibit transfers",
      "ON: no state is left; active states go on driving. Written by the program or by IST.", 1, "7.1">;
def : SystemRelay<8041, "transfers start",
      "Lets S2 go on to the next state. Manual, return: OFF. Step, one cycle: ON while the start button is ON. Continuous: "
      "set by start, cleared by stop.", 1, "F60">;
def : SystemRelay<8042, "start pulse", "ON for one scan when the start button turns ON.", 1, "F60">;
def : UserRelay<8043, "return finished", "The program sets it when the machine has returned to its origin.", 1, "F60">;
def : UserRelay<8044, "at the origin", "The program drives it while the machine is at its origin.", 1, "F60">;
def : UserRelay<8045, "keep outputs",
      "Changing the mode away from the origin resets active states, and outputs too unless this is ON.", 1, "F60">;
def : SystemRelay<8046, "a state is active", "Written at END: ON where M8047 is ON and any of S0-S899 is.", 1, "4.5">;
def : UserRelay<8047, "watch states", "ON: END enters the numbers of the active states S0-S899 into D8040-D8047.", 1, "4.5">;
def : SystemRelay<8048, "an annunciator is ON", "Written at END: ON where M8049 is ON and any of S900-S999 is.", 1, "2.5">;
def : UserRelay<8049, "watch annunciators", "ON: END enters the lowest annunciator that is ON into D8049.", 1, "2.5">;

// -------------------------------------------------------------------------------- relays: interrupts inhibited
def : UserRelay<8050, "inhibit I00x", "ON: edges of X0 interrupt nothing.", 1, "F03">;
def : UserRelay<8051, "inhibit I10x", "ON: edges of X1 interrupt nothing.", 1, "F03">;
def : UserRelay<8052, "inhibit I20x", "ON: edges of X2 interrupt nothing.", 1, "F03">;
def : UserRelay<8053, "inhibit I30x", "ON: edges of X3 interrupt nothing.", 1, "F03">;
def : UserRelay<8054, "inhibit I40x", "ON: edges of X4 interrupt nothing. Not on SR.", 1, "F03">;
def : UserRelay<8055, "inhibit I50x", "ON: edges of X5 interrupt nothing. Not on SR.", 1, "F03">;
def : UserRelay<8056, "inhibit I6xx", "ON: the timer interrupt does not come.", 1, "F03">;
def : UserRelay<8057, "inhibit I7xx", "ON: the timer interrupt does not come.", 1, "F03">;
def : UserRelay<8058, "inhibit I8xx", "ON: the timer interrupt does not come.", 1, "F03">;
def : UserRelay<8059, "inhibit I010-I060", "ON: DHSCS interrupts nothing.", 1, "F03">;

// -------------------------------------------------------------------------------- relays: errors
def : SystemRelay<8060, "communication card", "ON with a code in D8060; the CPU goes on.", 0, "7.4">;
def : SystemRelay<8061, "hardware error", "ON with a code in D8061; the CPU stops. Kept for the watchdog (6105).", 1, "7.4">;
def : SystemRelay<8063, "communication error", "ON with a code in D8063 while a link is in error; the CPU goes on.", 1, "7.4">;
def : SystemRelay<8064, "parameter error",
      "ON with a code in D8064; the CPU does not run. ladderc reports these errors when it compiles.", 0, "7.4">;
def : SystemRelay<8065, "syntax error", "ON with a code in D8065, likewise.", 0, "7.4">;
def : SystemRelay<8066, "circuit error", "ON with a code in D8066, likewise.", 0, "7.4">;
def : SystemRelay<8067, "operation error",
      "ON after an instruction could not be executed (D8067); the CPU goes on. OFF when the instruction that failed last "
      "succeeds, and at STOP to RUN.", 1, "5.1">;
def : SystemRelay<8069, "expansion I/O error", "ON with a code in D8069; the CPU goes on.", 0, "7.4">;
def : SystemRelay<8109, "output refresh error", "ON where outputs could not be refreshed.", 0, "7.4">;

// -------------------------------------------------------------------------------- relays: serial ports
def : SystemRelay<8121, "RS waits to send",
      "A request to send came while data were received; cleared when they are sent.", 1, "F80">;
def : UserRelay<8122, "RS request to send", "A pulse of the program sends; cleared afterwards.", 1, "F80">;
def : UserRelay<8123, "RS has received", "Set when all is received; the program clears it to receive again.", 1, "F80">;
def : SystemRelay<8124, "MBUS error in reception", "The check sum or the end of the answer was wrong.", 1, "F87">;
def : SystemRelay<8129, "RS timeout", "Reception stopped for longer than D8129; cleared with M8123.", 1, "F80">;

// -------------------------------------------------------------------------------- relays: pulse outputs, modes of instructions
def : UserRelay<8140, "ZRN clear signal", "ON: ZRN puts out the clear signal of a servo at the origin.", 1, "F156">;
def : UserRelay<8145, "stop pulses of Y0", "ON: the output stops at once.", 1, "F156">;
def : UserRelay<8146, "stop pulses of Y1", "ON: the output stops at once.", 1, "F156">;
def : SystemRelay<8147, "pulses of Y0",
      "ON while pulses go out; the output can be driven again one scan after it went OFF.", 1, "F57">;
def : SystemRelay<8148, "pulses of Y1",
      "ON while pulses go out; the output can be driven again one scan after it went OFF.", 1, "F57">;
def : UserRelay<8160, "XCH swaps bytes", "ON: XCH swaps the bytes of one device.", 1, "F17">;
def : UserRelay<8161, "8-bit mode", "ON: RS, ASCI, HEX, CCD, ASC, MBUS and CRC take one character a word.", 1, "F76">;
def : UserRelay<8167, "HKY hexadecimal", "ON: HKY takes the keys 0-F as digits.", 1, "F71">;
def : UserRelay<8168, "SMOV without BCD", "ON: SMOV moves hexadecimal digits.", 1, "F13">;

// -------------------------------------------------------------------------------- relays: direction of counters
foreach n = !range(200, 235) in
def : UserRelay<!add(8000, n), "direction of C" # n,
                "ON: the counter counts down." # !if(!lt(n, 220), " Not on SR.", ""), 1, "2.7">;
foreach n = !range(235, 246) in
def : UserRelay<!add(8000, n), "direction of C" # n, "ON: the counter counts down.", 1, "3.13">;
foreach n = [246, 247, 248, 249, 251, 252, 253, 254] in
def : SystemRelay<!add(8000, n), "direction of C" # n,
                  "ON after the counter has counted down, OFF after it has counted up.", 1, "2.8">;

// -------------------------------------------------------------------------------- relays: display, expansion port, links
def : UserRelay<8273, "SEGD inverted", "ON: SEGD inverts the segment pattern. SEGL has an operand for it.", 1, "F73">;
def : SystemRelay<8321, "expansion port: waits to send", "As M8121.", 1, "F80">;
def : UserRelay<8322, "expansion port: request to send", "As M8122.", 1, "F80">;
def : UserRelay<8323, "expansion port: has received", "As M8123.", 1, "F80">;
def : SystemRelay<8329, "expansion port: timeout", "As M8129.", 1, "F80">;
def : SystemRelay<8335, "RMIO communicates", "ON while another station is talked to.", 1, "F191">;
def : SystemRelay<8336, "RMIO: error of the master", "Seen by a slave.", 1, "F191">;
foreach slave = [1, 2, 3, 4] in
def : SystemRelay<!add(8336, slave), "RMIO: error of slave " # slave, "ON after an error in talking to the slave.", 1, "F191">;
def : SystemRelay<8341, "RMIO on the expansion port", "ON while RMIO runs there.", 1, "F191">;
def : SystemRelay<8342, "RMIO on the built-in port", "ON while RMIO runs there.", 1, "F191">;
def : SystemRelay<8400, "DTLK: error of the master", "Seen by a slave.", 1, "F190">;
foreach slave = !range(1, 16) in
def : SystemRelay<!add(8400, slave), "DTLK: error of slave " # slave, "ON after an error in talking to the slave.", 1, "F190">;
def : SystemRelay<8416, "DTLK communicates", "ON while another station is talked to.", 1, "F190">;
def : SystemRelay<8417, "DTLK on the expansion port", "ON while DTLK runs there.", 1, "F190">;
def : SystemRelay<8418, "DTLK on the built-in port", "ON while DTLK runs there.", 1, "F190">;

// -------------------------------------------------------------------------------- registers: time
def : UserRegister<8000, "watchdog",
      "ms; 200 at power-on, 200-1600. A longer scan stops the CPU with 6105. The host measures.", 1, "F07">;
def : UserRegister<8006, "memory capacity", "Set in the parameters.", 0, "1.3">;
def : SystemRegister<8010, "last scan", "Units of 0.1 ms, with the waiting of a constant scan. Of the last whole scan.", 1, "7.1">;
def : SystemRegister<8011, "shortest scan",
      "Units of 0.1 ms, with the waiting of a constant scan. Since the change to RUN.", 1, "7.1">;
def : SystemRegister<8012, "longest scan",
      "Units of 0.1 ms, with the waiting of a constant scan. Since the change to RUN.", 1, "7.1">;
def : UserRegister<8013, "clock: second, 0-59", "Shows the real-time clock. Written through M8015 or by TWR.", 1, "7.1">;
def : UserRegister<8014, "clock: minute, 0-59", "Shows the real-time clock. Written through M8015 or by TWR.", 1, "7.1">;
def : UserRegister<8015, "clock: hour, 0-23", "Shows the real-time clock. Written through M8015 or by TWR.", 1, "7.1">;
def : UserRegister<8016, "clock: day, 1-31", "Shows the real-time clock. Written through M8015 or by TWR.", 1, "7.1">;
def : UserRegister<8017, "clock: month, 1-12", "Shows the real-time clock. Written through M8015 or by TWR.", 1, "7.1">;
def : UserRegister<8018, "clock: year, 2000-2099", "Shows the real-time clock. Written through M8015 or by TWR.", 1, "7.1">;
def : UserRegister<8019, "clock: weekday", "0 is Sunday, 6 Saturday. Follows from the date.", 1, "7.1">;
def : UserRegister<8039, "constant scan time", "ms; where M8039 is ON.", 0, "7.1">;

// -------------------------------------------------------------------------------- registers: step ladder
foreach n = !range(1, 9) in
def : SystemRegister<!add(8039, n), "active state " # n,
                     "Written at END while M8047 is ON: numbers of the active states S0-S899, lowest first, 0 behind the last.", 1,
                     "4.5">;
def : SystemRegister<8049, "lowest annunciator",
      "Written at END while M8049 is ON: the lowest of S900-S999 that is ON, or 0.", 1, "2.5">;

// -------------------------------------------------------------------------------- registers: error codes
def : SystemRegister<8060, "code of M8060", "See the error codes.", 0, "7.4">;
def : SystemRegister<8061, "code of M8061", "See the error codes.", 1, "7.4">;
def : SystemRegister<8063, "code of M8063", "See the error codes.", 1, "7.4">;
def : SystemRegister<8064, "code of M8064", "See the error codes.", 0, "7.4">;
def : SystemRegister<8065, "code of M8065", "See the error codes.", 0, "7.4">;
def : SystemRegister<8066, "code of M8066", "See the error codes.", 0, "7.4">;
def : SystemRegister<8067, "operation error",
      "Code of the last operation error. Stays when M8067 goes OFF; 0 at STOP to RUN.", 1, "5.1">;
def : SystemRegister<8069, "code of M8069", "See the error codes.", 0, "7.4">;

// -------------------------------------------------------------------------------- registers: serial ports
def : UserRegister<8120, "communication format",
      "Speed, parity, data and stop bits, header and terminator of the built-in port. Taken over when an instruction opens "
      "the port.", 1, "F80">;
def : SystemRegister<8122, "RS: bytes to send", "So many are left.", 1, "F80">;
def : SystemRegister<8123, "RS: bytes received", "So many have come.", 1, "F80">;
def : UserRegister<8124, "RS: header",
      "The character in front of a message, where D8120 asks for one; 2 (STX) at power-on.", 1, "F80">;
def : UserRegister<8125, "RS: terminator",
      "The character behind a message, where D8120 asks for one; 3 (ETX) at power-on.", 1, "F80">;
def : UserRegister<8129, "RS: timeout", "Units of 10 ms, 5-255; any other number is 50 ms.", 1, "F80">;

// -------------------------------------------------------------------------------- registers: pulse outputs
def : SystemRegister<8140, "position of Y0, low word", "Pulses that went out, less those backwards.", 1, "F156">;
def : SystemRegister<8141, "position of Y0, high word", "Pulses that went out, less those backwards.", 1, "F156">;
def : SystemRegister<8142, "position of Y1, low word", "Pulses that went out, less those backwards.", 1, "F156">;
def : SystemRegister<8143, "position of Y1, high word", "Pulses that went out, less those backwards.", 1, "F156">;
def : UserRegister<8145, "base speed", "Hz; of DRVI and DRVA, a tenth of the highest speed at most.", 1, "F158">;
def : UserRegister<8146, "highest speed, low word", "Hz, 10-100000, of DRVI and DRVA; 0 is 100000.", 1, "F158">;
def : UserRegister<8147, "highest speed, high word", "Hz, 10-100000, of DRVI and DRVA; 0 is 100000.", 1, "F158">;
def : UserRegister<8148, "acceleration", "ms from standstill to the highest speed, 50-5000; 0 is 100.", 1, "F158">;

// -------------------------------------------------------------------------------- registers: links, displays
def : SystemRegister<8173, "DTLK: own station", "As it works.", 1, "F190">;
def : SystemRegister<8174, "DTLK: slaves", "As it works.", 1, "F190">;
def : SystemRegister<8175, "DTLK: refresh range", "As it works; unused by DTLK2.", 1, "F190">;
def : UserRegister<8176, "DTLK: set the own station", "0: master. 1-15: slave.", 1, "F190">;
def : UserRegister<8177, "DTLK: set the number of slaves", "1-15; 7 at power-on. Of the master.", 1, "F190">;
def : UserRegister<8178, "DTLK: set the refresh range", "0-2. Of the master; unused by DTLK2.", 1, "F190">;
def : UserRegister<8179, "DTLK: retries", "0-10; 3 at power-on. Of the master.", 1, "F190">;
def : UserRegister<8180, "DTLK: timeout", "Units of 10 ms, 5-255; 5 at power-on.", 1, "F190">;
def : SystemRegister<8280, "TEXT: file of line 1", "Written by TEXT.", 1, "F192">;
def : SystemRegister<8281, "TEXT: file of line 2", "Written by TEXT.", 1, "F192">;
def : SystemRegister<8284, "TEXT: request", "13 asks the panel to show the text.", 1, "F192">;
def : SystemRegister<8285, "TEXT: answer", "The panel writes 13.", 0, "F192">;
def : SystemRegister<8295, "TEXT: register of line 1", "Number of the D register that the line shows.", 1, "F192">;
def : SystemRegister<8296, "TEXT: register of line 2", "Number of the D register that the line shows.", 1, "F192">;
def : UserRegister<8320, "expansion port: communication format", "As D8120.", 1, "F80">;
def : SystemRegister<8322, "expansion port: bytes to send", "As D8122.", 1, "F80">;
def : SystemRegister<8323, "expansion port: bytes received", "As D8123.", 1, "F80">;
def : UserRegister<8324, "expansion port: header", "As D8124.", 1, "F80">;
def : UserRegister<8325, "expansion port: terminator", "As D8125.", 1, "F80">;
def : UserRegister<8329, "expansion port: timeout", "As D8129.", 1, "F80">;
def : SystemRegister<8331, "RMIO: network scan", "Time of the last one.", 1, "F191">;
def : SystemRegister<8332, "RMIO: longest network scan", "Time of the longest one.", 1, "F191">;
def : SystemRegister<8333, "RMIO: errors of the master", "Counted.", 1, "F191">;
foreach slave = [1, 2, 3, 4] in
def : SystemRegister<!add(8333, slave), "RMIO: errors of slave " # slave, "Counted.", 1, "F191">;
def : SystemRegister<8338, "RMIO: error code of the master", "0: none.", 1, "F191">;
foreach slave = [1, 2, 3, 4] in
def : SystemRegister<!add(8338, slave), "RMIO: error code of slave " # slave, "0: none.", 1, "F191">;
def : SystemRegister<8373, "RMIO: own station", "As it works.", 1, "F191">;
def : SystemRegister<8374, "RMIO: slaves", "As it works.", 1, "F191">;
def : UserRegister<8376, "RMIO: set the own station", "0: master. 1-4: slave.", 1, "F191">;
def : UserRegister<8377, "RMIO: set the number of slaves", "1-4; 4 at power-on.", 1, "F191">;
def : UserRegister<8379, "RMIO: retries", "3 at power-on.", 1, "F191">;
def : UserRegister<8380, "RMIO: timeout", "Units of 10 ms; 5 at power-on.", 1, "F191">;
def : SystemRegister<8401, "DTLK: network scan", "Time of the last one.", 1, "F190">;
def : SystemRegister<8402, "DTLK: longest network scan", "Time of the longest one.", 1, "F190">;
def : SystemRegister<8403, "DTLK: errors of the master", "Counted.", 1, "F190">;
foreach slave = !range(1, 16) in
def : SystemRegister<!add(8403, slave), "DTLK: errors of slave " # slave, "Counted.", 1, "F190">;
def : SystemRegister<8419, "DTLK: error code of the master", "0: none.", 1, "F190">;
foreach slave = !range(1, 16) in
def : SystemRegister<!add(8419, slave), "DTLK: error code of slave " # slave, "0: none.", 1, "F190">;
def : SystemRegister<8510, "measured value 1", "Analogue input or potentiometer of the CPU.", 0, "F45">;
def : SystemRegister<8511, "measured value 2", "Analogue input or potentiometer of the CPU.", 0, "F45">;
