// Reset, decoding, counting, mean values, annunciators and check codes: F40-F45, F47, F84, F170, F171, F188.

// ---------------------------------------------------------------------------------------------- ZRST
// One list for each way in which a run of devices is handed over; the function tells two classes of one such way apart. The rest
// are the combinations that fail whenever they are executed.
def ResetWords : Classes<[DevT, DevC] # DataRegisters>;
def ResetContacts : Classes<[DevY, DevM, DevMS, DevS, DevCL]>;
class Mixed<string n, OperandType t, Classes c> : Operand<n, "In", t, c> {
  let indexable = 1;
  let note = "D1 and D2 differ in kind: error 6705";
}
multiclass MixedReset<Operand first, Operand second, string args> {
  defm "" : Pulsed<"ZRST", 40, MayFail<"zrst_mixed", [], []>, [first, second], 5, args>;
}
let category = "other", section = "F40", title = "Reset a zone", errors = ["6705: D1 and D2 are of different kinds"],
    description = "Resets everything from D1 to D2: bits become OFF, registers 0; timers and counters lose their value, contact "
                  "and coil as with RST. Where D1 has the higher number, D1 alone is reset. Both name devices of one kind, where "
                  "counters of 16 and of 32 bits, and special relays and registers and the others, are two kinds. With the "
                  "condition OFF, and on an error, nothing changes." in {
defm ZRST_bits : Pulsed<"ZRST", 40, MayFail<"zrst", [0, 1], [0, 1]>, [BitsOut<"D1">, BitsOut<"D2">], 5, "M100 M200">;
defm ZRST_words : Pulsed<"ZRST", 40, MayFail<"zrst", [0, 1], [0, 1]>,
                         [BlockChanged<"D1", 0, ResetWords>, BlockChanged<"D2", 0, ResetWords>], 5, "C0 C9">;
defm ZRST_long : Pulsed<"ZRST", 40, MayFail<"zrst", [0, 1], [0, 1]>,
                        [BlockChanged<"D1", 0, LongCounterClass, OpDWordBlock>,
                         BlockChanged<"D2", 0, LongCounterClass, OpDWordBlock>], 5, "C200 C209">;
defm ZRST_bits_long : MixedReset<Mixed<"D1", OpBit, WrittenBits>, Mixed<"D2", OpBit, LongCounterClass>, "M0 C200">;
defm ZRST_long_bits : MixedReset<Mixed<"D1", OpBit, LongCounterClass>, Mixed<"D2", OpBit, WrittenBits>, "C200 M0">;
defm ZRST_words_other : MixedReset<Mixed<"D1", OpWord, ResetWords>, Mixed<"D2", OpBit, ResetContacts>, "C0 C200">;
defm ZRST_other_words : MixedReset<Mixed<"D1", OpBit, ResetContacts>, Mixed<"D2", OpWord, ResetWords>, "C200 C0">;
}

// ---------------------------------------------------------------------------------------------- DECO, ENCO
class CodedWord<string n> : SourceDevice<n, OpWord, ValueOrIndexWords>;
let category = "conversion" in {
let section = "F41", title = "Decode",
    description = "The low n bits of S, of a word or n bits from a bit device on, are the number of a bit. With bits as D, the "
                  "2^n bits from D on become OFF except for that one, which is ON: n is 1 to 8, up to 256 bits. With a word as "
                  "D, that bit of the word is 1 and all others are 0: n is 1 to 4. With n = 0 nothing happens. With the "
                  "condition OFF, and on an error, D stays." in {
let errors = ["6706: n is not in 0 to 8", "6706: n bits from S, or 2^n bits from D, go beyond the last number"] in {
defm DECO_bits_bits : Pulsed<"DECO", 41, MayFail<"deco_bits_to_bits", [0, 1, 2], [1]>,
                             [BitsIn<"S">, BitsOut<"D">, CheckedConstant<"n">], 7, "X0 M0 K3">;
defm DECO_word_bits : Pulsed<"DECO", 41, MayFail<"deco_to_bits", [0, 1, 2], [1]>,
                             [Source<"S", OpWord, ValueOrIndexWords>, BitsOut<"D">, CheckedConstant<"n">], 7, "D0 M0 K3">;
}
let errors = ["6706: n is not in 0 to 4", "6706: n bits from S go beyond the last number"] in {
defm DECO_bits_word : Pulsed<"DECO", 41, MayFail<"deco_bits", [0, 2], [1]>,
                             [BitsIn<"S">, Target<"D", OpWord, ValueWords>, CheckedConstant<"n">], 7, "X0 D1 K3">;
defm DECO_word_word : Pulsed<"DECO", 41, MayFail<"deco", [0, 2], [1]>,
                             [Source<"S", OpWord, ValueOrIndexWords>, Target<"D", OpWord, ValueWords>, CheckedConstant<"n">], 7,
                             "D0 D1 K3">;
}
}
let section = "F42", title = "Encode",
    description = "D becomes the number of the highest bit that is ON among 2^n bits: those from a bit device S on, n 1 to 8, or "
                  "the low ones of a word S, n 1 to 4. Lower bits that are ON do not matter. With n = 0 nothing happens. With "
                  "the condition OFF, and on an error, D stays." in {
let errors = ["6706: no bit of S is ON", "6706: n is not in 0 to 8", "6706: 2^n bits from S go beyond the last number"] in
defm ENCO_bits : Pulsed<"ENCO", 42, MayFail<"enco_bits", [0, 2], [1]>,
                        [BitsIn<"S">, Target<"D", OpWord, ValueOrIndexWords>, CheckedConstant<"n">], 7, "M0 D0 K3">;
let errors = ["6706: no bit of S is ON", "6706: n is not in 0 to 4"] in
defm ENCO_word : Pulsed<"ENCO", 42, MayFail<"enco", [0, 2], [1]>,
                        [CodedWord<"S">, Target<"D", OpWord, ValueOrIndexWords>, CheckedConstant<"n">], 7, "D0 D1 K4">;
}
}

// ---------------------------------------------------------------------------------------------- bits of words
let category = "logic" in {
let section = "F43", title = "Count the bits that are ON",
    description = "D becomes the number of bits of S that are 1; DSUM counts 32 bits and writes a pair, whose high word is 0. "
                  "M8020 is ON where no bit is 1, else OFF; no other flag changes. With the condition OFF, D and the flag stay." in
defm SUM : PulsedBoth<"SUM", 43, ComputesWithFlags<"sum", [0], [1]>, [Source<"S", OpWord>, Target<"D", OpWord>],
                      [Source<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "D0 D2", "D0 D2">;
let section = "F44", title = "Look at a bit", errors = ["6706: n is not in 0 to 15 (DBON: 0 to 31)"],
    description = "D becomes the state of bit n of S. With the condition OFF, and on an error, D stays." in
defm BON : PulsedBoth<"BON", 44, MayFail<"bon", [0, 2], [1]>, [Source<"S", OpWord>, BitOut<>, CheckedConstant<"n">],
                      [Source<"S", OpDWord>, BitOut<>, CheckedConstant<"n">], 7, 13, "D10 M0 K15", "D10 M0 K31">;
}

def MeanPairs : Classes<[DevT, DevC, DevCL] # DataRegisters, [], [DevX, DevY, DevM, DevMS, DevS]>;
let category = "arithmetic", section = "F45", title = "Mean value", errors = ["6706: n is not in 1 to 64"],
    description = "D becomes the sum of n signed words from S on, with D of n pairs, divided by n; the quotient is cut towards "
                  "0. The sum cannot overflow. Digits stand for one word after the other without a gap. Where fewer than n exist "
                  "behind S, those that do are added and n counts as their number. No flag changes. With the condition OFF, and "
                  "on an error, D stays." in
defm MEAN : PulsedBoth<"MEAN", 45, MayFail<"mean", [0, 2], [1]>,
                       [BlockIn<"S">, Target<"D", OpWord>, CheckedConstant<"n">],
                       [BlockIn<"S", 0, MeanPairs, OpDWordBlock>, Target<"D", OpDWord>, CheckedConstant<"n">], 7, 13,
                       "D100 D150 K5", "D100 D150 K5">;

let category = "diagnostic", section = "F47", title = "Reset an annunciator", images = ["S"],
    description = "The annunciator with the lowest number that is ON, of S900-S999, becomes OFF; where none is ON nothing "
                  "happens. ANR goes on with the next one in each scan, ANRP with each press. With M8049 ON, D8049 becomes the "
                  "lowest number that is left at once, or 0, and M8048 tells whether there is one." in
defm ANR : Pulsed<"ANR", 47, Acts<"anr", [], []>, [], 1, "">;

// ---------------------------------------------------------------------------------------------- Gray code
let category = "conversion", errors = ["6706: S is negative"] in {
let section = "F170", title = "Binary to Gray code",
    description = "D becomes the Gray code of S: S exclusive-or S shifted right by one bit. S is 0 to 32767, with D 0 to "
                  "2147483647. With the condition OFF, and on an error, D stays." in
defm GRY : PulsedBoth<"GRY", 170, MayFail<"gry", [0], [1]>, [Source<"S", OpWord>, Target<"D", OpWord>],
                      [Source<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "K1234 K3Y10", "D0 D2">;
let section = "F171", title = "Gray code to binary",
    description = "D becomes the number whose Gray code is S. S is 0 to 32767, with D 0 to 2147483647. With the condition OFF, "
                  "and on an error, D stays." in
defm GBIN : PulsedBoth<"GBIN", 171, MayFail<"gbin", [0], [1]>, [Source<"S", OpWord>, Target<"D", OpWord>],
                       [Source<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "K3X0 D10", "D0 D2">;
}

// ---------------------------------------------------------------------------------------------- check codes
// Operands of CRC are not indexable, those of CCD are.
class CheckedBlock<string n, string dir> : Operand<n, dir, OpWordBlock, Registers>;
class CheckCount<string n, bit index> : Count<n> { let indexable = index; }
def CodePlaces : Classes<[DevT, DevC] # DataRegisters, [], [DevM, DevMS, DevS]>;
let category = "string", section = "F84", title = "Check code: sum and parity",
    errors = ["6706: n is not in 1 to 256", "6706: S or D goes beyond the last number of its device"],
    description = "Of n bytes from S on, D becomes the sum, 16 bits without a sign that wrap round, and D + 1 the exclusive-or. "
                  "With M8161 OFF the bytes are the low and the high one of each word; with M8161 ON the low one of each of n "
                  "words. Digits stand for one word after the other without a gap. With the condition OFF, and on an error, D "
                  "stays." in
defm CCD : Pulsed<"CCD", 84, MayFail<"ccd", [0, 1, 2], [1]>,
                  [BlockIn<"S">, BlockOut<"D", 2, CodePlaces>, CheckCount<"n", 1>], 7, "D100 D0 K10">;
let category = "comm", section = "F188", title = "Cyclic redundancy check",
    errors = ["6706: n is not in 1 to 256", "6706: S or D goes beyond the last number of its device"],
    description = "CRC-16 of n bytes from S on, as MODBUS uses it: the register starts at HFFFF; each byte is combined with its "
                  "low byte, then it is shifted right eight times, with HA001 combined whenever a 1 drops out. With M8161 OFF "
                  "the bytes are the low and the high one of each word and D becomes the code; with M8161 ON they are the low "
                  "one of each of n words, D becomes the low byte of the code and D + 1 the high one. With the condition OFF, "
                  "and on an error, D stays." in
defm CRC : Pulsed<"CRC", 188, MayFail<"crc", [0, 1, 2], [1]>,
                  [CheckedBlock<"S", "In">, CheckedBlock<"D", "Out">, CheckCount<"n", 0>], 7, "D100 D0 K6">;
