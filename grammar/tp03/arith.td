// Comparison into bits, BCD, arithmetic, logic and square root: F10, F11, F18-F29, F48.

let category = "comparison" in {
let section = "F10", title = "Compare", errors = ["6706: D + 2 lies beyond the last number of the device"],
    description = "Compares S1 with S2, both signed. Of the three bits from D on, the first is ON where S1 is greater, the "
                  "second where they are equal, the third where S1 is less; the other two are OFF. Numbers of Y continue in "
                  "octal. With the condition OFF, and on an error, the bits stay; RST or ZRST clears them." in
defm CMP : PulsedBoth<"CMP", 10, MayFail<"cmp", [0, 1, 2], [2]>,
                      [Source<"S1", OpWord>, Source<"S2", OpWord>, BitsOut<"D", 3>],
                      [Source<"S1", OpDWord>, Source<"S2", OpDWord>, BitsOut<"D", 3>], 7, 13, "K100 D0 M0", "K100000 D0 M0">;
let section = "F11", title = "Compare with a zone", errors = ["6706: D + 2 lies beyond the last number of the device"],
    description = "Compares S with the zone from S1 to S2, all signed. Of the three bits from D on, the first is ON where S is "
                  "below S1, the second where it is in the zone, limits included, the third where it is above S2; the other two "
                  "are OFF. Where S2 is below S1, S1 is both limits. With the condition OFF, and on an error, the bits stay; RST "
                  "or ZRST clears them." in
defm ZCP : PulsedBoth<"ZCP", 11, MayFail<"zcp", [0, 1, 2, 3], [3]>,
                      [Source<"S1", OpWord>, Source<"S2", OpWord>, Source<"S", OpWord>, BitsOut<"D", 3>],
                      [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Source<"S", OpDWord>, BitsOut<"D", 3>], 9, 17,
                      "K100 K120 D0 M0", "K100000 K120000 D0 M0">;
}

// ---------------------------------------------------------------------------------------------- BCD
let category = "bcd" in {
let section = "F18", title = "Binary to BCD", errors = ["6706: S is not in 0 to 9999 (DBCD: 0 to 99999999)"],
    description = "D becomes S written in decimal digits of four bits each: 4 digits in a word, with D 8 in a pair. Digits as D "
                  "take the low ones. With the condition OFF, and on an error, D stays." in
defm BCD : PulsedBoth<"BCD", 18, MayFail<"bcd", [0], [1]>, [SourceDevice<"S", OpWord>, Target<"D", OpWord>],
                      [SourceDevice<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "D0 K4Y0", "D0 K8Y0">;
let section = "F19", title = "BCD to binary", errors = ["6706: a digit of S is not 0 to 9"],
    description = "D becomes the number whose decimal digits S holds in four bits each: 4 digits in a word, with D 8 in a pair. "
                  "S takes no constant, which is binary already. With the condition OFF, and on an error, D stays." in
defm BIN : PulsedBoth<"BIN", 19, MayFail<"bin", [0], [1]>, [SourceDevice<"S", OpWord>, Target<"D", OpWord>],
                      [SourceDevice<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "K4X0 D0", "K8X0 D0">;
}

// ---------------------------------------------------------------------------------------------- arithmetic
// m S1 S2 D, all of one width.
multiclass Combining<string m, int n, Calling c> {
  defm "" : PulsedBoth<m, n, c, [Source<"S1", OpWord>, Source<"S2", OpWord>, Target<"D", OpWord>],
                       [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Target<"D", OpDWord>], 7, 13, "D0 D2 D4", "D0 K100000 D4">;
}
// m D: changes its only operand.
multiclass InPlace<string m, int n, string fn> {
  defm "" : PulsedBoth<m, n, Computes<fn, [0], [0]>, [Changed<"D", OpWord>], [Changed<"D", OpDWord>], 3, 5, "D0", "D0">;
}
// m S1 S2 D with a result of twice the width. That of 16-bit operands may go to an index register pair (Vn, Zn), a wider one not.
def PairResults : Classes<[DevT, DevC] # DataRegisters # [DevZ], [], [DevY, DevM, DevMS, DevS]>;
def ProductResults : Classes<[DevT, DevC] # DataRegisters, [], [DevY, DevM, DevMS, DevS]>;
def QuotientResults : Classes<[DevT, DevC, DevCL] # DataRegisters, [], [DevY, DevM, DevMS, DevS]>;
multiclass Widening<string m, int n, Calling c, OperandType result16, OperandType result32, Classes places32> {
  defm "" : PulsedBoth<m, n, c, [Source<"S1", OpWord>, Source<"S2", OpWord>, Target<"D", result16, PairResults>],
                       [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Target<"D", result32, places32>], 7, 13, "D0 D2 D4",
                       "D0 K100000 D4">;
}

let category = "arithmetic" in {
let section = "F20", title = "Add",
    description = "D becomes S1 + S2, signed, 16 bits, with D 32. M8020 is ON where the stored result is 0, M8021 where the sum "
                  "is below the lowest number, M8022 where it is above the highest one; otherwise they are OFF. The sum wraps "
                  "round then: 32767 + 1 stores -32768. D may be S1 or S2; ADD then adds in every scan. With the condition OFF, "
                  "D and the flags stay." in
defm ADD : Combining<"ADD", 20, ComputesWithFlags<"add", [0, 1], [2]>>;
let section = "F21", title = "Subtract",
    description = "D becomes S1 - S2, signed, 16 bits, with D 32. M8020 is ON where the stored result is 0, M8021 where the "
                  "difference is below the lowest number, M8022 where it is above the highest one; otherwise they are OFF. The "
                  "difference wraps round then: -32768 - 1 stores 32767. D may be S1 or S2; SUB then subtracts in every scan. "
                  "With the condition OFF, D and the flags stay." in
defm SUB : Combining<"SUB", 21, ComputesWithFlags<"sub", [0, 1], [2]>>;
let section = "F22", title = "Multiply",
    description = "D becomes the signed product of S1 and S2 at twice their width, low word first, so that it always fits: a "
                  "pair of words, with D four words. Digits as D take the low bits only, up to K8: K4 keeps 16 bits of the "
                  "product, DMUL never stores more than 32. No flag changes. With the condition OFF D stays." in
defm MUL : Widening<"MUL", 22, Computes<"mul", [0, 1], [2]>, OpDWord, OpQWord, ProductResults>;
let section = "F23", title = "Divide", errors = ["6706: S2 is 0"],
    description = "Divides S1 by S2, both signed. The quotient, cut towards 0, goes to D, the remainder, with the sign of S1, to "
                  "the place behind it (one word, with D a pair). Digits as D take the quotient only. The lowest number divided "
                  "by -1 wraps round to itself, remainder 0. No flag changes. With the condition OFF, and on an error, D stays." in
defm DIV : Widening<"DIV", 23, MayFail<"div", [0, 1], [2]>, OpWordTwice, OpDWordTwice, QuotientResults>;
let section = "F24", title = "Increment",
    description = "Adds 1 to D, 16 bits, with D 32, in every scan while the condition is ON; INCP does it once. The highest "
                  "number is followed by the lowest. No flag changes." in
defm INC : InPlace<"INC", 24, "inc">;
let section = "F25", title = "Decrement",
    description = "Takes 1 from D, 16 bits, with D 32, in every scan while the condition is ON; DECP does it once. The lowest "
                  "number is followed by the highest. No flag changes." in
defm DEC : InPlace<"DEC", 25, "dec">;
let section = "F29", title = "Two's complement",
    description = "D becomes 0 - D, 16 bits, with D 32, in every scan while the condition is ON; NEGP does it once. The lowest "
                  "number stays what it is. No flag changes." in
defm NEG : InPlace<"NEG", 29, "neg">;
let section = "F48", title = "Square root", errors = ["6706: S is negative"],
    description = "D becomes the square root of S without its fraction, 16 bits, with D 32. M8021 is ON where a fraction was cut "
                  "off, M8020 where the result is 0; otherwise they are OFF. With the condition OFF, and on an error, D and the "
                  "flags stay." in
defm SQR : PulsedBoth<"SQR", 48, MayFail<"sqr", [0], [1]>,
                      [Source<"S", OpWord, Registers>, Target<"D", OpWord, Registers>],
                      [Source<"S", OpDWord, Registers>, Target<"D", OpDWord, Registers>], 5, 9, "D0 D1", "D0 D2">;
}

// ---------------------------------------------------------------------------------------------- logic
// The W says 16 bits, so that lists leave it out in 32-bit forms.
multiclass Logic<string m, int n, string fn, string short> {
  defm "" : Pulsed<m, n, Computes<fn, [0, 1], [2]>, [Source<"S1", OpWord>, Source<"S2", OpWord>, Target<"D", OpWord>], 7,
                   "D0 H00FF D4">;
  let wide = 1 in {
    let aliases = [short] in
    def D : AppForm<"D" # m, m, n, WhileOn, Computes<"d" # fn, [0, 1], [2]>,
                    [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Target<"D", OpDWord>], 13, "D0 H00FF00FF D4">;
    let aliases = [short # "P"] in
    def DP : AppForm<"D" # m # "P", m, n, RisingEdge, Computes<"d" # fn, [0, 1], [2]>,
                     [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Target<"D", OpDWord>], 13, "D0 H00FF00FF D4">;
  }
}
let category = "logic" in {
let section = "F26", title = "Bitwise AND",
    description = "D becomes S1 AND S2, bit by bit, 16 bits, with D 32. Digits that a source does not have count as 0. No flag "
                  "changes. With the condition OFF D stays." in
defm WAND : Logic<"WAND", 26, "word_and", "DAND">;
let section = "F27", title = "Bitwise OR",
    description = "D becomes S1 OR S2, bit by bit, 16 bits, with D 32. Digits that a source does not have count as 0. No flag "
                  "changes. With the condition OFF D stays." in
defm WOR : Logic<"WOR", 27, "word_or", "DOR">;
let section = "F28", title = "Bitwise exclusive OR",
    description = "D becomes the bits in which S1 and S2 differ, 16 bits, with D 32. Digits that a source does not have count as "
                  "0. No flag changes. With the condition OFF D stays." in
defm WXOR : Logic<"WXOR", 28, "word_xor", "DXOR">;
}
