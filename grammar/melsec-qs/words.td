// Arithmetic, conversion, transfer and logic of words.

// ---------------------------------------------------------------------------------------------- arithmetic
let category = "arithmetic" in {
let section = "6.2.1-6.2.2" in {
let title = "Add",
    description = "Two operands: D becomes D + S. Three operands: D becomes S1 + S2. Signed numbers of 16 bits, with D of 32. A "
                  "result that does not fit wraps round without a flag or an error." in
defm Add : TwoAndThree<"+", "D+", "add", 500, 600, 650, 750>;
let title = "Subtract",
    description = "Two operands: D becomes D - S. Three operands: D becomes S1 - S2. Signed numbers of 16 bits, with D of 32. A "
                  "result that does not fit wraps round without a flag or an error." in
defm Subtract : TwoAndThree<"-", "D-", "sub", 500, 600, 650, 750>;
}
let section = "6.2.3-6.2.4" in {
let title = "Multiply",
    description = "D becomes the signed product of S1 and S2 at twice their width, low word first, so that it always fits. Digits "
                  "as D take the low bits only: up to K8 for *, and the low 32 bits for D*." in
defm Multiply : Widening<"*", "mul", NeverFails, OpDWord, OpQWord, [Time<550, "executed">], [Time<42000>]>;
let title = "Divide", errors = ["4100: S2 is 0"],
    description = "Divides S1 by S2, both signed. The quotient, cut towards 0, goes to D, the remainder, with the sign of S1, to "
                  "the place behind it (one word, with D two). Digits as D take the quotient only. The lowest number divided by -1 "
                  "wraps round to itself, remainder 0. Division by 0 leaves D as it is and stops the CPU." in
defm Divide : Widening<"/", "div", FailsOnData, OpWordTwice, OpDWordTwice, [Time<14000>], [Time<25000>]>;
}
let section = "6.2.5-6.2.6" in {
let title = "Increment",
    description = "Adds 1 to D, 16 bits, with D 32. The highest number is followed by the lowest, without a flag or an error." in
defm Increment : InPlace<"INC", "inc", 350, 450>;
let title = "Decrement",
    description = "Takes 1 from D, 16 bits, with D 32. The lowest number is followed by the highest, without a flag or an error." in
defm Decrement : InPlace<"DEC", "dec", 350, 450>;
}
}

// ---------------------------------------------------------------------------------------------- conversion
let category = "conversion" in {
let section = "6.3.1", title = "Binary to BCD", errors = ["4100: S is not in 0 to 9999 (DBCD: 0 to 99999999)"],
    description = "D becomes S written in decimal digits of four bits each: 4 digits in a word, with D 8 in a pair. A negative S "
                  "or one with more digits leaves D as it is and stops the CPU." in
defm BCD : Converting<"BCD", "bcd", FailsOnData, 0, [Time<16000>], [Time<23000>]>;
let section = "6.3.2", title = "BCD to binary", errors = ["4100: a digit of S is not 0 to 9 and SM722 is OFF"], errorMask = "SM722",
    description = "D becomes the number whose decimal digits S holds in four bits each: 4 digits in a word, with D 8 in a pair. "
                  "Where a digit is A to F, D stays as it is; with SM722 OFF the CPU stops as well." in
defm BIN : Converting<"BIN", "bin", FailsOnData, 0, [Time<15000>], [Time<18000>]>;
let section = "6.3.3", title = "Two's complement",
    description = "D changes its sign: it becomes 0 - D. The lowest number stays what it is." in
defm Negate : InPlace<"NEG", "neg", 14000, 15000>;
}

// ---------------------------------------------------------------------------------------------- transfer
let category = "move" in {
let section = "6.4.1", title = "Transfer",
    description = "D becomes S. Bits that the digits of S do not have become 0; digits as D are written alone, the points beside "
                  "them stay. A pair or a run of digits that crosses the end of a device goes on in the next one of the device "
                  "memory." in
defm Move : Converting<"MOV", "", NeverFails, 2, [Time<350>], [Time<450>]>;
let section = "6.4.2", title = "Transfer inverted",
    description = "D becomes S with every bit inverted. Bits that the digits of S do not have count as 0 and so become 1." in
defm Complement : Converting<"CML", "complement", NeverFails, 2, [Time<350>], [Time<450>]>;
// 16-bit only. The times of the P forms are not printed; they are those of the plain ones.
let equalDigits = 1 in {
let section = "6.4.3", title = "Block transfer",
    errors = ["4101: n is negative, or n words from S or D cross the end of the device"],
    description = "Copies n words from S onwards to D onwards; the two may overlap. Between bits and words each word takes or "
                  "gives the low digits that the designation names. Two digit designations have the same number of digits. A block "
                  "that crosses the end of its device is not copied at all and stops the CPU." in
defm BlockMove : Pulsed<"BMOV", "BMOV", "bmov", FailsOnRange.style, FailsOnRange.error, [SourceBlock, TargetBlock, BlockLength],
                        [0, 1, 2], [1], 4, [Time<35000, "n = 1">, Time<67000, "n = 96">], "D0 D10 K5">;
let section = "6.4.4", title = "Fill", errors = ["4101: n is negative, or n words from D cross the end of the device"],
    description = "Writes S to each of n words from D onwards; digits as D take the low digits of S, group after group. Two digit "
                  "designations have the same number of digits. A block that crosses the end of its device is not written at all "
                  "and stops the CPU." in
defm Fill : Pulsed<"FMOV", "FMOV", "fmov", FailsOnRange.style, FailsOnRange.error, [Source<"S", OpWord>, TargetBlock, BlockLength],
                   [0, 1, 2], [1], 4, [Time<30000, "n = 1">, Time<48000, "n = 96">], "K0 D10 K5">;
}
}

// ---------------------------------------------------------------------------------------------- logic
let category = "logic" in {
let section = "7.1.1", title = "Bitwise AND",
    description = "Two operands: D becomes D AND S. Three operands: D becomes S1 AND S2. Bit by bit, 16 bits, with D 32. Bits that "
                  "the digits of a source do not have count as 0." in
defm And : TwoAndThree<"WAND", "DAND", "word_and", 500, 600, 650, 750>;
let section = "7.1.2", title = "Bitwise OR",
    description = "Two operands: D becomes D OR S. Three operands: D becomes S1 OR S2. Bit by bit, 16 bits, with D 32. Bits that "
                  "the digits of a source do not have count as 0." in
defm Or : TwoAndThree<"WOR", "DOR", "word_or", 500, 600, 650, 750>;
let section = "7.1.3", title = "Bitwise exclusive OR",
    description = "Two operands: D becomes the bits in which D and S differ. Three operands: those in which S1 and S2 differ. 16 "
                  "bits, with D 32. Bits that the digits of a source do not have count as 0." in
defm Xor : TwoAndThree<"WXOR", "DXOR", "word_xor", 500, 600, 650, 750>;
let section = "7.1.4", title = "Bitwise exclusive NOR",
    description = "Two operands: D becomes the bits in which D and S agree. Three operands: those in which S1 and S2 agree. 16 "
                  "bits, with D 32. Bits that the digits of a source do not have count as 0, so the result there is the inverse of "
                  "the other source." in
defm Xnor : TwoAndThree<"WXNR", "DXNR", "word_xnor", 500, 600, 650, 750>;
}
