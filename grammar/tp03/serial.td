// Serial ports: F80 RS, F87 MBUS, and the links between controllers F190 DTLK, F191 RMIO, F193 DTLK2.
//
// Runtime: tp03/ops/serial.h and tp03/ops/link.h. The links get whole images, because what they exchange is not named by operands.

class SerialText<string n> : BlockIn<n, 0, Registers> { let indexable = 0; }
class SerialBuffer<string n> : BlockOut<n, 0, Registers> { let indexable = 0; }
def SerialPort : Constant<"K", 0, 1> { let note = "0: built-in RS-485, 1: expansion card"; }
def LinkedRegisters : BlockChanged<"S1", 0, Classes<[DevD]>>;
def LinkedWords : Source<"S2", OpWord, Registers> {
  let min = 1;
  let max = 40;
}

defvar Transfers = " M8121-M8129 and D8120-D8129 are those of port 0; port 1 has M8321-M8329 and D8320-D8329, but M8124 for "
  "errors. The format is taken from D8120 when the drive begins: b0 eight data bits and not seven, b2 b1 parity (01 odd, 10 even), "
  "b3 two stop bits, b7-b4 the rate (7: 9600, 8: 19200, 9: 38400, A: 57600, B: 76800, C: 128000, D: 153600, E: 307200; others: "
  "9600). A pulse that sets M8122 sends m bytes from S on; D8122 counts down, and behind the last M8122 is reset. While a telegram "
  "comes in, M8121 is ON and the request waits. What is received is stored from D on, up to n bytes, D8123 counts up, and M8123 is "
  "ON behind the end; no more is received until the program resets it. A pause of D8129 x 10 ms (5-255, others: 50 ms) ends a "
  "telegram too, and sets M8129, which is reset together with M8123. With n = 0 nothing is received; when n is above 0 again, "
  "M8123 has to be set and reset first. With M8161 OFF a word holds two bytes, the first in the low one; with M8161 ON one, in the "
  "low byte. Sending takes the time of the bits; bytes that come meanwhile are taken behind it. One instruction at a time has a "
  "port, the first that is driven. Condition OFF: stops at once, resets M8121 and M8122 and leaves the port; what was received "
  "stays.";
defvar TransferErrors = ["6706: m or n is not 0 to 255", "6706: there are fewer words than m or n bytes need"];
defvar Telegram = [SerialText<"S">, Count<"m">, SerialBuffer<"D">, Count<"n">, SerialPort];

let category = "comm", errors = TransferErrors in {
let section = "F80", title = "Send and receive without a protocol",
    description = "Sends and receives bytes over a serial port. With b8 of the format a telegram begins with the character in "
                  "D8124, with b9 it ends with that in D8125, and so do those that are sent; these characters are neither stored "
                  "nor counted. Without an end character n bytes or a pause end a telegram." # Transfers in
defm RS : Plain<"RS", 80, Keeps<"SerialTransfer", [0, 1, 2, 3, 4], [2]>, Telegram, 11, "D200 K4 D500 K10 K0">;

let section = "F87", title = "Modbus master",
    description = "Sends m bytes (station, function, data) as a Modbus telegram and receives answers. With b13 of the format OFF "
                  "it is RTU: two bytes of CRC-16 follow, and an answer ends with a pause or n bytes. With b13 ON it is ASCII: "
                  "':', two hexadecimal characters for each byte and for the LRC, CR and LF; an answer ends with these, a pause, "
                  "or where it is longer than n bytes. Check codes are neither stored nor counted. An answer whose check code or "
                  "end is wrong is stored all the same and sets M8124 together with M8123; M8124 is reset with it. Where a pause "
                  "stands for CR and LF the check code decides." # Transfers in
defm MBUS : Plain<"MBUS", 87, Keeps<"Modbus", [0, 1, 2, 3, 4], [2]>, Telegram, 11, "D200 K6 D500 K8 K0">;
}

// ---------------------------------------------------------------------------------------------- F190, F193
defvar Links = " Station 0 is the master and asks one slave after the other; every station hears all. Settings, as they are behind "
  "the first scan of RUN: D8176 own station 0-15, and for the master D8177 slaves 1-15 (others: 7), D8179 tries before a slave is "
  "in error 0-10 (others: 3; 0 is one), D8180 time-out 5-255 x 10 ms (others: 5). The format of the port is that of RS. M8416 is "
  "ON while others are heard, M8418 or M8417 while the link has port 0 or 1. M8400 (master) and M8401-M8415 (slaves) are ON where "
  "a station fails, with a code in D8419-D8434 and a count in D8403-D8418, and OFF when it is heard again; M8063 is ON meanwhile, "
  "with 6301 in D8063. D8401 is the time of a round, D8402 of the longest, x 10 ms. Codes: 01 no answer, 02 wrong station, 03 "
  "wrong counter, 04 damaged; in a slave 11 the master is silent, 14 it is damaged or has other settings; of another slave 21 no "
  "answer, 22 wrong station, 23 wrong counter, 32 unknown command; 31 a request came before the settings. Only one data link runs "
  "at a time, on the port that is driven first. The maker's telegrams are not known: it talks to programs of this compiler only. "
  "Condition OFF: leaves the port.";
let category = "comm" in {
let section = "F190", models = LargeModels, images = ["M", "D"], title = "Data link",
    description = "Up to 16 controllers share registers and relays. Each station s writes an area of its own that the link copies "
                  "to all others: with D8178 of the master 0, D10s to D10s+3; with 1 also M(2000+64s) to M(2031+64s); with 2, D10s "
                  "to D10s+7 and M(2000+64s) to M(2063+64s). D8173-D8175 show the station, the slaves and this mode." # Links,
    errors = ["6706: D8176 is not 0 to 15"] in
defm DTLK : Plain<"DTLK", 190, Keeps<"DataLink", [0], []>, [SerialPort], 3, "K0">;

let section = "F193", title = "Data link with a free area",
    description = "As DTLK, but station s owns the S2 registers from S1 + s S2 on; no relays are shared. S2 has to be the same in "
                  "all stations, S1 need not. D8173 and D8174 show the station and the slaves; D8175 and D8178 are not "
                  "used." # Links,
    errors = ["6706: D8176 is not 0 to 15", "6706: S2 is not 1 to 40",
              "6706: the area goes beyond the last register: in the master that of any slave, in a slave its own"] in {
defm DTLK2 : Plain<"DTLK2", 193, Keeps<"DataLink2", [0, 1, 2], [0]>, [LinkedRegisters, LinkedWords, SerialPort], 7, "D100 K20 K1">;
}

// ---------------------------------------------------------------------------------------------- F191
let section = "F191", models = LargeModels, images = ["X", "Y"], title = "Remote I/O",
    description = "The inputs X0-X37 of up to four slaves become inputs of the master, and outputs of the master become their "
                  "Y0-Y37. Slave 1 has X200-X237 and Y200-Y237 of the master, slave 2 X240 and Y240 on, slave 3 X300 and Y300 on, "
                  "slave 4 X340 and Y340 on. Station 0 is the master and asks one slave after the other. Settings, as they are "
                  "behind the first scan of RUN: D8376 own station 0-4, and for the master D8377 slaves 1-4 (others: 4), D8379 "
                  "tries before a slave is in error 0-10 (others: 3; 0 is one), D8380 time-out 5-255 x 10 ms (others: 5). D8373 "
                  "and D8374 show the station and the slaves. The format of the port is that of RS. M8335 is ON while others are "
                  "heard, M8342 or M8341 while it has port 0 or 1. M8336 (master) and M8337-M8340 (slaves) are ON where a station "
                  "fails, with a code in D8338-D8342 and a count in D8333-D8337, and OFF when it is heard again; M8063 is ON "
                  "meanwhile, with 6302 in D8063. The program goes on; a slave that misses its master switches Y0-Y37 OFF. D8331 "
                  "is the time of a round, D8332 of the longest, x 10 ms. Codes: 01 no answer, 02 wrong station, 03 wrong command, "
                  "04 damaged; in a slave 11 the master is silent, 13 wrong command, 14 it is damaged or has other settings; of "
                  "another slave 21 no answer, 22 wrong station, 23 wrong command, 24 damaged; 31 a request came before the "
                  "settings. It talks to programs of this compiler only. Condition OFF: leaves the port.",
    errors = ["6706: D8376 is not 0 to 4"] in
defm RMIO : Plain<"RMIO", 191, Keeps<"RemoteInOut", [0], []>, [SerialPort], 3, "K0">;
}
