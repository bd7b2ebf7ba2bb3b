// Transfer of words, digits and octal bits: F12-F17, F81, F147.

// Fill and block operands that the common roles do not have: index registers can be filled, pairs of counters too.
def FilledBlocks : Classes<[DevT, DevC] # DataRegisters # [DevV, DevZ], [], [DevY, DevM, DevMS, DevS]>;
def FilledPairBlocks : Classes<[DevT, DevC, DevCL] # DataRegisters, [], [DevY, DevM, DevMS, DevS]>;
def IndexPairs : Classes<[DevZ]>;
def InputDigits : Classes<[], [], [DevX]>;
def OutputDigits : Classes<[], [], [DevY]>;
def RelayDigits : Classes<[], [], [DevM, DevMS]>;

let category = "move" in {
let section = "F12", title = "Transfer",
    description = "D becomes S; DMOV moves 32 bits. Digits that S does not have count as 0; digits as D are written alone, what "
                  "S has beyond them is lost. T and C are current values. With the condition OFF D stays. No flag changes." in
defm MOV : PulsedBoth<"MOV", 12, Computes<"", [0], [1]>, [Source<"S", OpWord>, Target<"D", OpWord>],
                      [Source<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "K100 D0", "K100000 D0">;

let section = "F13", title = "Transfer digits",
    errors = ["6706: m1, m2 or n is not in 1 to 4, or m2 is above m1 or n",
              "6706: M8168 is OFF and S or D is not in 0 to 9999"],
    description = "Copies m2 digits of S, from digit m1 downwards, to D, from digit n downwards; digit 4 is the highest. The "
                  "other digits of D stay. With M8168 OFF they are decimal digits: S and D are numbers from 0 to 9999 before and "
                  "after. With M8168 ON they are groups of four bits. With the condition OFF, and on an error, D stays." in
defm SMOV : Pulsed<"SMOV", 13, MayFail<"smov", [0, 1, 2, 3, 4], [3]>,
                   [SourceDevice<"S", OpWord>, CheckedConstant<"m1">, CheckedConstant<"m2">, Changed<"D", OpWord>,
                    CheckedConstant<"n">], 11, "D10 K4 K2 D20 K3">;

let section = "F14", title = "Transfer inverted",
    description = "D becomes S with every bit inverted, 16 bits, with D 32. Digits that S does not have count as 0 and so become "
                  "1; digits as D are written alone. With the condition OFF D stays. No flag changes." in
defm CML : PulsedBoth<"CML", 14, Computes<"complement", [0], [1]>, [Source<"S", OpWord>, Target<"D", OpWord>],
                      [Source<"S", OpDWord>, Target<"D", OpDWord>], 5, 9, "D0 D1", "D0 D2">;

// From inputs apart: what M8024 reverses would write them.
let section = "F15", title = "Block transfer",
    description = "Copies n words from S onwards to D onwards; the two may overlap, every word is read before it is overwritten. "
                  "Digits stand for one word after the other without a gap: K1M0, K1M4, K1M8, ...; between digits and words, or "
                  "digits of another length, each item takes or gives its low digits. What lies behind the last number of a "
                  "device is left out. With M8024 ON it copies from D to S. With the condition OFF, and on an error, nothing is "
                  "written." in {
let errors = ["6706: n is not in 1 to 512"] in
defm BMOV : Pulsed<"BMOV", 15, MayFail<"bmov", [0, 1, 2], [0, 1]>,
                   [BlockChanged<"S">, BlockChanged<"D">, CheckedConstant<"n">], 7, "D0 D10 K5">;
let errors = ["6706: n is not in 1 to 512", "6705: M8024 is ON and S are inputs"] in
defm BMOV_X : Pulsed<"BMOV", 15, MayFail<"bmov_inputs", [0, 1, 2], [1]>,
                     [BlockIn<"S", 0, InputDigits>, BlockOut<"D">, CheckedConstant<"n">], 7, "K4X0 D10 K2">;
}

let section = "F16", title = "Fill", errors = ["6706: n is not in 1 to 512"],
    description = "Writes S to each of n words from D onwards, DFMOV to n pairs, those of Z0 being (V0, Z0), (V1, Z1), ... "
                  "Digits as D stand for one word after the other without a gap and take the low digits of S. What lies behind "
                  "the last number of the device is left out. With the condition OFF, and on an error, nothing is written." in {
defm FMOV : PulsedBoth<"FMOV", 16, MayFail<"fmov", [0, 1, 2], [1]>,
                       [Source<"S", OpWord>, BlockOut<"D", 0, FilledBlocks>, CheckedConstant<"n">],
                       [Source<"S", OpDWord>, BlockOut<"D", 0, FilledPairBlocks, OpDWordBlock>, CheckedConstant<"n">], 7, 13,
                       "K0 D10 K5", "K100000 D10 K5">;
// The high words lie in V.
let images = ["V"] in
defm FMOV_Z : PulsedWide<"FMOV", 16, MayFail<"dfmov_indexes", [0, 1, 2], [1]>,
                         [Source<"S", OpDWord>, BlockOut<"D", 0, IndexPairs>, CheckedConstant<"n">], 13, "K0 Z0 K16">;
}

let section = "F17", title = "Exchange", errors = ["6705: M8160 is ON and D1 and D2 are different"],
    description = "D1 and D2 change places, in every scan while the condition is ON; XCHP does it once. With M8160 ON, D1 and D2 "
                  "must be the same device, and its high and low bytes change places, with D those of each of its two words (as "
                  "SWAP does). With the condition OFF, and on an error, both stay." in
defm XCH : PulsedBoth<"XCH", 17, MayFail<"xch", [0, 1], [0, 1]>, [Changed<"D1", OpWord>, Changed<"D2", OpWord>],
                      [Changed<"D1", OpDWord>, Changed<"D2", OpDWord>], 5, 9, "D10 D11", "D10 D12">;

let section = "F147", title = "Exchange bytes", category = "conversion",
    description = "The high and the low byte of S change places, with D those of each of its two words; the words keep theirs. "
                  "It happens in every scan while the condition is ON; SWAPP does it once. Digits that S does not have count as "
                  "0 and are not written." in
defm SWAP : PulsedBoth<"SWAP", 147, Computes<"swap", [0], [0]>, [Changed<"S", OpWord>], [Changed<"S", OpDWord>], 3, 5, "D0", "D0">;
}

// The numbers of X and Y are octal, those of M decimal, so that each combination is a record of its own.
multiclass OctalTransfer<string fn, Classes from, Classes to, string args16, string args32> {
  defm "" : PulsedBoth<"PRUN", 81, MayFail<fn, [0, 1], [1]>, [BlockIn<"S", 0, from>, BlockOut<"D", 0, to>],
                       [BlockIn<"S", 0, from, OpDWordBlock>, BlockOut<"D", 0, to, OpDWordBlock>], 5, 9, args16, args32>;
}
let category = "move", section = "F81", title = "Transfer octal bits",
    errors = ["6706: the number of S or D does not end in 0, or their digit counts differ",
              "6706: the bits go beyond the last number of the device"],
    description = "Copies the bits of S to the bits of D with the same octal numbers: eight bits from each ten numbers of M, "
                  "whose numbers ending in 8 and 9 are neither read nor written. PRUN K4X10 K4M0 copies X10-X17 to M0-M7 and "
                  "X20-X27 to M10-M17. S and D begin at a number that ends in 0 and have the same number of digits. With the "
                  "condition OFF, and on an error, D stays." in {
defm PRUN_XY : OctalTransfer<"prun_xy", InputDigits, OutputDigits, "K4X10 K4Y20", "K6X10 K6Y20">;
defm PRUN_XM : OctalTransfer<"prun_xm", InputDigits, RelayDigits, "K4X10 K4M0", "K6X10 K6M0">;
defm PRUN_MY : OctalTransfer<"prun_my", RelayDigits, OutputDigits, "K4M0 K4Y10", "K6M0 K6Y10">;
defm PRUN_MM : OctalTransfer<"prun_mm", RelayDigits, RelayDigits, "K4M0 K4M100", "K6M0 K6M100">;
}
