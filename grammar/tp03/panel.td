// Keys, displays, characters and knobs: F70-F77, F82, F83, F85, F86, F89, F192.
//
// Runtime: tp03/ops/panel.h and tp03/ops/text.h. Where a constant may stand for the first word of a run there is an entry of its
// own, because a run of constants has one word.

class KeyBits<string n, int length> : BitsIn<n, length> { let note = "the first of " # length; }
class OutputLines<string n, int length> : BitsOut<n, length, OutputBits> {
  let note = !if(length, "the first of " # length, "");
}
class OneConstant<string n> : Source<n, OpWord, NoDevices>;
def PanelPairs : Classes<[DevT, DevC, DevCL] # DataRegisters # [DevZ]>;
def ShownConstant : OneConstant<"S"> { let max = 9999; }
def PanelRegister : BlockIn<"S", 1, Classes<[DevD]>> {
  let indexable = 0;
  let note = "its number counts, not its value";
}
def EightCharacters : Operand<"S", "In", OpString, NoDevices> {
  let min = 1;
  let max = 8;
  let note = "1 to 8 characters";
}
class Knob<string n, int last> : Constant<n, 0, last> { let indexable = 1; }
class TextForm<string f, string m, int n, string fn, Execution when, Operand source, int most, string args>
    : AppForm<f, m, n, when, MayFail<fn, [0, 1, 2], [1]>, [source, BlockOut<"D", 0, WrittenWords>, Constant<"n", 1, most>], 7,
              args>;
defvar TooFar = "6706: a run of devices goes beyond the last number";

// ---------------------------------------------------------------------------------------------- F70, F71, F72, F75
let category = "io" in {
let section = "F70", maxUses = 1, title = "Type a number with ten keys",
    description = "S to S+9 are the keys 0 to 9. A key that goes down appends its digit to the decimal number in D1, which keeps "
                  "its four lowest digits (DTKY: eight, in a pair). Of D2 to D2+9 the relay of that key is then ON and the others "
                  "are OFF, until another key is accepted; D2+10 is ON while it is down. While a key is down others do not count; "
                  "one that was pressed meanwhile has to be pressed again. Of keys in one scan the lowest counts. Keys that are "
                  "down when the condition comes ON count as pressed. Condition OFF: D1 stays, D2 to D2+10 are switched OFF once.",
    errors = [TooFar] in
defm TKY : PlainBoth<"TKY", 70, Keeps<"TenKey", [0, 1, 2], [1, 2]>,
                     [KeyBits<"S", 10>, Changed<"D1", OpWord>, BitsOut<"D2", 11>],
                     [KeyBits<"S", 10>, Changed<"D1", OpDWord>, BitsOut<"D2", 11>], 7, 13, "X20 D0 M10", "X20 D0 M10">;

let section = "F71", maxUses = 1, title = "Type a number with sixteen keys",
    description = "Four outputs from D1 on are the rows and four inputs from S on the columns of a matrix of keys: 0 to 3, 4 to 7, "
                  "8 to B, C to F. A row is ON for two scans and read in the second, so that eight scans read all keys; M8029 is "
                  "ON in the eighth. Only the first of several keys counts, once. A digit is appended to the decimal number in D2, "
                  "which keeps its four lowest digits (DHKY: eight, in a pair); A to F switch D3 to D3+5 ON, and the others of "
                  "these OFF. With M8167 ON, 0 to F are digits of a hexadecimal number of 16 bits (DHKY: 32). D3+6 is ON while a "
                  "key A to F is down, D3+7 while a digit is. Condition OFF: D2 stays; rows and D3 to D3+7 are switched OFF once, "
                  "and the next drive begins with the first row.",
    errors = [TooFar] in
defm HKY : PlainBoth<"HKY", 71, Keeps<"HexKey", [0, 1, 2, 3], [1, 2, 3]>,
                     [BitsIn<"S", 4, InputBits>, OutputLines<"D1", 4>, Changed<"D2", OpWord, ValueOrIndexWords>, BitsOut<"D3", 8>],
                     [BitsIn<"S", 4, InputBits>, OutputLines<"D1", 4>, Changed<"D2", OpDWord, PanelPairs>, BitsOut<"D3", 8>], 9, 17,
                     "X4 Y10 D0 M0", "X4 Y10 D0 M0">;

let section = "F72", maxUses = 2, title = "Read digital switches",
    description = "Reads n switches of four decimal digits. The outputs D1 to D1+3 are ON one after the other, each for 100 ms and "
                  "until a scan finds them over; at the end of its time the digit is read, the lowest first: of the first switch "
                  "from S to S+3, of the second from S+4 to S+7. Behind the fourth digit the numbers are written to D2 and, with "
                  "n = 2, D2+1, and M8029 is ON for that scan; then it begins anew. Condition OFF: outputs OFF, D2 stays.",
    errors = ["6706: a digit is not 0 to 9; from the end of that cycle to the end of the next one that is right", TooFar] in
defm DSW : Plain<"DSW", 72, Keeps<"DigitalSwitch", [0, 1, 2, 3], [1, 2]>,
                 [BitsIn<"S", 0, InputBits>, OutputLines<"D1", 4>, BlockOut<"D2", 0, ValueOrIndexWords>, Constant<"n", 1, 2>], 9,
                 "X20 Y20 D0 K1">;

let section = "F75", maxUses = 1, title = "Edit a number with arrow keys",
    description = "S to S+3 are the keys down, up, right, left. When the condition comes ON, the digit of the thousands of D1 is "
                  "selected; left and right select the next digit and go round. Up and down count the selected digit round, "
                  "without touching the others. A key counts where it goes down while the condition is ON. A display of four "
                  "digits on D2 to D2+7 shows D1 as with SEGL, n as there; after each twelve scans for that, the strobe of the "
                  "selected digit is ON for ten of twelve more, so that a lamp on it stands out. Condition OFF: D1 stays, D2 to "
                  "D2+7 are OFF.",
    errors = ["6706: D1 is not 0 to 9999", TooFar] in
defm ARWS : Plain<"ARWS", 75, Keeps<"ArrowSwitch", [0, 1, 2, 3], [1, 2]>,
                  [KeyBits<"S", 4>, Changed<"D1", OpWord, ValueOrIndexWords>, OutputLines<"D2", 8>, Constant<"n", 0, 3>], 9,
                  "X10 D0 Y20 K0">;
}

// ---------------------------------------------------------------------------------------------- F73, F74
let category = "display" in {
let section = "F73", title = "Decode a digit for seven segments",
    description = "The low byte of D becomes the segments of the hexadecimal digit in the low four bits of S: bit 0 is the one at "
                  "the top, then clockwise, bit 6 the one in the middle, bit 7 none. The high byte of D stays. With M8273 ON all "
                  "eight bits are inverted. With the condition OFF nothing happens." in
defm SEGD : Pulsed<"SEGD", 73, ComputesWithFlags<"segd", [0, 1], [1]>, [Source<"S", OpWord>, Changed<"D", OpWord>], 5, "D0 K2Y0">;

defvar Multiplexed = "Shows S on a display of four digits, and with n from 4 on S+1 on a second one. D to D+3 carry a digit in "
  "BCD, D+8 to D+11 one of the second display, D+4 to D+7 are the strobes of the digits, the lowest first. A digit takes three "
  "scans: the data, its strobe ON, its strobe OFF; M8029 is ON in the twelfth. The remainder of n divided by 4 tells the polarity: "
  "1 and 3 invert the strobes, 2 and 3 the data, for displays whose logic differs from that of the outputs. Condition OFF: all "
  "these outputs are OFF, and the next drive begins with the lowest digit.";
let section = "F74", maxUses = 2, title = "Show a number on seven-segment displays", description = Multiplexed,
    errors = ["6706: a number is not 0 to 9999", TooFar] in {
defm SEGL : Plain<"SEGL", 74, Keeps<"SegmentLatch", [0, 1, 2], [1]>,
                  [BlockIn<"S", 0, ReadWords>, OutputLines<"D", 0>, Constant<"n", 0, 7>], 7, "D0 Y10 K0">;
defm SEGL_constant : Plain<"SEGL", 74, Keeps<"SegmentLatch", [0, 1, 2], [1]>,
                           [ShownConstant, OutputLines<"D", 8>, Constant<"n", 0, 3>], 7, "K1234 Y10 K1">;
}

let section = "F192", models = LargeModels, title = "Show a text on the operator panel",
    description = "Asks an OP07 or OP08 to show text D in its first line, and with n = 2 text D+1 in the second: D8280 and D8281 "
                  "become these numbers, D8295 and D8296 the number of the register S, whose value stands where the texts have "
                  "'#', and D8284 becomes 13. The panel answers with 13 in D8285; what is typed at '?' goes to the register behind "
                  "S. Text k is in the ten registers from D(1990 + 10 k) on. With the condition OFF nothing happens." in {
defm TEXT : Pulsed<"TEXT", 192, Acts<"show_text", [0, 1, 2], []>, [Count<"D">, PanelRegister, Constant<"n", 1, 2>], 7,
                   "D200 D300 K1">;
}
}

// ---------------------------------------------------------------------------------------------- F76, F77, F82, F83
defvar Characters = " With M8161 OFF a word holds two characters, the first in the low byte; with M8161 ON it holds one in the low "
  "byte, and the high byte is ";
let category = "string" in {
let section = "F76", title = "Characters of the list",
    description = "D becomes the eight characters of S; a shorter S is filled with zeros." # Characters #
                  "0. With the condition OFF nothing happens.",
    errors = ["6706: there are fewer than 4 words from D on, or 8 with M8161 ON"] in
defm ASC : Plain<"ASC", 76, MayFail<"asc", [0, 1], [1]>, [EightCharacters, BlockOut<"D", 0, ValueWords>], 11, "ABCDEFGH D300">;

let section = "F82", title = "Hexadecimal digits to characters",
    description = "D becomes the n lowest hexadecimal digits of the words from S on, as characters 0-9 and A-F, the highest "
                  "digit first." # Characters # "0. Other bytes stay. S and D may overlap. With the condition OFF nothing happens.",
    errors = ["6706: there are fewer words than n digits need, from S or from D on"] in {
let aliases = ["ASCII", "ASIC"] in {
def ASCI : TextForm<"ASCI", "ASCI", 82, "asci", WhileOn, BlockIn<"S", 0, ReadWords>, 256, "D100 D200 K8">;
def ASCI_constant : TextForm<"ASCI", "ASCI", 82, "asci", WhileOn, OneConstant<"S">, 4, "H1F D200 K4">;
}
let aliases = ["ASCIIP", "ASICP"] in {
def ASCIP : TextForm<"ASCIP", "ASCI", 82, "asci", RisingEdge, BlockIn<"S", 0, ReadWords>, 256, "D100 D200 K8">;
def ASCIP_constant : TextForm<"ASCIP", "ASCI", 82, "asci", RisingEdge, OneConstant<"S">, 4, "H1F D200 K4">;
}
}
let section = "F83", title = "Characters to hexadecimal digits",
    description = "The n characters from S on, 0-9 and A-F, are the digits of a number, the highest first. It is written "
                  "right-aligned: D is the last four digits, D+1 the four before, and so on; what is missing in the highest word "
                  "is 0, words above stay." # Characters #
                  "not looked at. S and D may overlap. With the condition OFF, and on an error, nothing happens.",
    errors = ["6706: a character is not 0-9 or A-F", "6706: there are fewer words than n characters need, from S or from D on"] in {
def HEX : TextForm<"HEX", "HEX", 83, "hex", WhileOn, BlockIn<"S", 0, ReadBlocks>, 256, "D200 D100 K8">;
def HEXP : TextForm<"HEXP", "HEX", 83, "hex", RisingEdge, BlockIn<"S", 0, ReadBlocks>, 256, "D200 D100 K8">;
def HEX_constant : TextForm<"HEX", "HEX", 83, "hex", WhileOn, OneConstant<"S">, 2, "H4131 D100 K2">;
def HEXP_constant : TextForm<"HEXP", "HEX", 83, "hex", RisingEdge, OneConstant<"S">, 2, "H4131 D100 K2">;
}
}

let category = "io" in {
let section = "F77", maxUses = 1, title = "Print characters over outputs",
    description = "Puts characters from S on, two in a word, the low byte first, on D to D+7; D+8 is the strobe, D+9 is ON "
                  "meanwhile. A character takes three scans: the data, the strobe ON, the strobe OFF. With M8027 OFF eight "
                  "characters, again and again while the condition is ON; OFF stops at once. With M8027 ON up to 16 characters, as "
                  "far as the first one that is 0, once for each rising edge of the condition; OFF does not stop it, and behind "
                  "the end M8029 is ON until the condition is OFF, at least for one scan. M8027 counts when an output begins. "
                  "Behind the end D to D+9 are OFF.",
    errors = ["6706: there are fewer than 4 words from S on, or 8 with M8027 ON", TooFar] in
defm PR : Plain<"PR", 77, Keeps<"PrintCharacters", [0, 1], [1]>, [BlockIn<"S", 0, ValueWords>, OutputLines<"D", 10>], 5, "D300 Y0">;

// ---------------------------------------------------------------------------------------------- F85, F86, F89
let models = LargeModels in {
let section = "F85", title = "Read a potentiometer",
    description = "D becomes the position, 0 to 1023, of potentiometer S: 0 and 1 are those of the unit, 2 to 7 of the function "
                  "card. With the condition OFF nothing happens.",
    errors = ["6706: S is not 0 to 7 after indexing"] in
defm VRRD : Pulsed<"VRRD", 85, MayFail<"vrrd", [0], [1]>, [Knob<"S", 7>, Target<"D", OpWord, WrittenBlocks>], 5, "K0 D0">;

let section = "F86", title = "Read a potentiometer in ten steps",
    description = "D becomes the position, 0 to 10, of potentiometer S, numbered as with VRRD: a tenth of the full scale to the "
                  "nearest, half of one upwards. With the condition OFF nothing happens.",
    errors = ["6706: S is not 0 to 7 after indexing"] in
defm VRSC : Pulsed<"VRSC", 86, MayFail<"vrsc", [0], [1]>, [Knob<"S", 7>, Target<"D", OpWord>], 5, "K1 D1">;

let section = "F89", title = "Read a channel of the expansion card with a scale",
    description = "D becomes the position of channel S1 on a scale from S2 to S3, to the nearest, half of one upwards. With the "
                  "condition OFF, and on an error, nothing happens.",
    errors = ["6706: S1 is not 0 to 5 after indexing", "6706: S3 is below S2"] in
defm EPSC : Pulsed<"EPSC", 89, MayFail<"epsc", [0, 1, 2], [3]>,
                   [Knob<"S1", 5>, Source<"S2", OpWord>, Source<"S3", OpWord>, Target<"D", OpWord>], 9, "K1 K0 K20 D1">;
}
}
