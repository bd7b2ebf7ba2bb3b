// Rotation, shift registers and queues: F30-F39.

// ---------------------------------------------------------------------------------------------- ROR, ROL, RCR, RCL
// The manual allows n up to the width and says nothing of 0, which changes nothing.
class Turned<OperandType t> : Changed<"D", t> { let note = "digits: K4 in 16-bit forms, K8 in 32-bit forms"; }
multiclass Rotating<string m, int n, string fn> {
  defm "" : PulsedBoth<m, n, MayFail<fn, [0, 1], [0]>, [Turned<OpWord>, Constant<"n", 0, 16>],
                       [Turned<OpDWord>, Constant<"n", 0, 32>], 5, 9, "D0 K4", "D0 K8">;
}

let category = "rotate-shift", errors = ["6705: D is a number of digits other than K4 (16-bit forms) or K8 (32-bit forms)"] in {
let section = "F30", title = "Rotate right",
    description = "Turns the bits of D, 16, with D 32, to the right by n: what leaves bit 0 comes back at the top. M8022 becomes "
                  "the bit that went round last. RORP does it once, ROR in every scan while the condition is ON. With n = 0 "
                  "nothing happens. With the condition OFF, and on an error, D and M8022 stay." in
defm ROR : Rotating<"ROR", 30, "ror">;
let section = "F31", title = "Rotate left",
    description = "Turns the bits of D, 16, with D 32, to the left by n: what leaves the top comes back at bit 0. M8022 becomes "
                  "the bit that went round last. ROLP does it once, ROL in every scan while the condition is ON. With n = 0 "
                  "nothing happens. With the condition OFF, and on an error, D and M8022 stay." in
defm ROL : Rotating<"ROL", 31, "rol">;
let section = "F32", title = "Rotate right through carry",
    description = "Turns a ring of 17 bits, with D 33, to the right by n. The ring is D with M8022 above its top bit: in each of "
                  "the n steps M8022 enters the top, and bit 0 becomes M8022. RCRP does it once, RCR in every scan while the "
                  "condition is ON. With n = 0 nothing happens. With the condition OFF, and on an error, D and M8022 stay." in
defm RCR : Rotating<"RCR", 32, "rcr">;
let section = "F33", title = "Rotate left through carry",
    description = "Turns a ring of 17 bits, with D 33, to the left by n. The ring is D with M8022 above its top bit: in each of "
                  "the n steps M8022 enters bit 0, and the top bit becomes M8022. RCLP does it once, RCL in every scan while the "
                  "condition is ON. With n = 0 nothing happens. With the condition OFF, and on an error, D and M8022 stay." in
defm RCL : Rotating<"RCL", 33, "rcl">;
}

// ---------------------------------------------------------------------------------------------- SFTR, SFTL, WSFR, WSFL
// That n2 is above n1 is found when the instruction runs.
class ShiftRegister<string f, string m, int n, Execution when, string fn, list<Operand> ops, string args>
    : AppForm<f, m, n, when, MayFail<fn, [0, 1, 2, 3], [1]>, ops, 9, args> {
  let category = "rotate-shift";
}
// The list of F30-F39 prints BSFR and BSFL, the headings SFTR and SFTL.
multiclass BitShift<string m, string alias, int n, string fn> {
  defvar ops = [BitsIn<"S">, BitsOut<"D">, Constant<"n1", 1, 1024>, Constant<"n2", 1, 1024>];
  let aliases = [alias] in
  def "" : ShiftRegister<m, m, n, WhileOn, fn, ops, "X0 M0 K16 K4">;
  let aliases = [alias # "P"] in
  def P : ShiftRegister<m # "P", m, n, RisingEdge, fn, ops, "X0 M0 K16 K4">;
}
multiclass WordShift<string m, int n, string fn> {
  defvar ops = [BlockIn<"S">, BlockChanged<"D">, Constant<"n1", 1, 512>, Constant<"n2", 1, 512>];
  let equalDigits = 1 in {
    def "" : ShiftRegister<m, m, n, WhileOn, fn, ops, "D0 D10 K16 K4">;
    def P : ShiftRegister<m # "P", m, n, RisingEdge, fn, ops, "D0 D10 K16 K4">;
  }
}

let errors = ["6706: n2 is above n1", "6706: n2 bits from S, or n1 bits from D, go beyond the last number"] in {
let section = "F34", title = "Shift bits right",
    description = "D is the lowest of the n1 bits of a shift register. All of them move down by n2 places, the lowest n2 are "
                  "lost, and the n2 bits from S on enter at the upper end, lowest first. S may lie in the register and counts as "
                  "it was before. SFTRP shifts once, SFTR in every scan while the condition is ON. No flag changes. With the "
                  "condition OFF, and on an error, D stays." in
defm SFTR : BitShift<"SFTR", "BSFR", 34, "sftr">;
let section = "F35", title = "Shift bits left",
    description = "D is the lowest of the n1 bits of a shift register. All of them move up by n2 places, the highest n2 are lost, "
                  "and the n2 bits from S on enter at the lower end, lowest first. S may lie in the register and counts as it was "
                  "before. SFTLP shifts once, SFTL in every scan while the condition is ON. No flag changes. With the condition "
                  "OFF, and on an error, D stays." in
defm SFTL : BitShift<"SFTL", "BSFL", 35, "sftl">;
}
let errors = ["6706: n2 is above n1", "6706: n2 words from S, or n1 words from D, go beyond the last number",
              "6705: the digits of S and D overlap, and not by whole groups"] in {
let section = "F36", title = "Shift words right",
    description = "D is the first of the n1 words of a shift register. All of them move down by n2 places, the first n2 are lost, "
                  "and the n2 words from S on enter at the upper end, first one first. With digits the words are groups of "
                  "digits, of the same size in S and D. S may lie in the register and counts as it was before. WSFRP shifts once, "
                  "WSFR in every scan while the condition is ON. No flag changes. With the condition OFF, and on an error, D "
                  "stays." in
defm WSFR : WordShift<"WSFR", 36, "wsfr">;
let section = "F37", title = "Shift words left",
    description = "D is the first of the n1 words of a shift register. All of them move up by n2 places, the last n2 are lost, "
                  "and the n2 words from S on enter at the lower end, first one first. With digits the words are groups of "
                  "digits, of the same size in S and D. S may lie in the register and counts as it was before. WSFLP shifts once, "
                  "WSFL in every scan while the condition is ON. No flag changes. With the condition OFF, and on an error, D "
                  "stays." in
defm WSFL : WordShift<"WSFL", 37, "wsfl">;
}

// ---------------------------------------------------------------------------------------------- SFWR, SFRD
let category = "table", errors = ["6706: the count of items is negative", "6706: n words go beyond the last number"] in {
let section = "F38", title = "Write into a queue",
    description = "A queue is n words: the first counts the items, the n - 1 others hold them. S is stored behind the last item, "
                  "and the count grows by 1. Where n - 1 items are stored already, nothing is written and M8022 is ON; a write "
                  "that succeeds makes it OFF. Set the count to 0 before the first use. SFWRP writes one item, SFWR one in every "
                  "scan while the condition is ON. With the condition OFF, and on an error, everything stays." in
defm SFWR : Pulsed<"SFWR", 38, MayFail<"sfwr", [0, 1, 2], [1]>, [Source<"S", OpWord>, BlockChanged<"D">, Constant<"n", 2, 512>], 7,
                   "D0 D1 K10">;
let section = "F39", title = "Read from a queue",
    description = "A queue is n words: the first counts the items, the n - 1 others hold them. The oldest item goes to D, all "
                  "other places move up by one (the last one keeps its value), and the count falls by 1. Where the count is 0, "
                  "nothing is read and M8020 is ON; a read that succeeds makes it OFF. SFRDP reads one item, SFRD one in every "
                  "scan while the condition is ON. With the condition OFF, and on an error, everything stays." in
defm SFRD : Pulsed<"SFRD", 39, MayFail<"sfrd", [0, 2], [0, 1]>, [BlockChanged<"S">, Target<"D", OpWord>, Constant<"n", 2, 512>], 7,
                   "D1 D20 K10">;
}
