// Convenience instructions and the annunciator timer: F46, F60-F69.
//
// Those that need several scans are objects (Keeps). M8029 is written by executions with the condition ON only, as every flag.

class InnerTimer<string n> : TimerOperand<n, 0, 199> {
  let direction = "InOut";
  let indexable = 1;
}
class Annunciator<string n> : BitsOut<n, 1, StepBits> {
  let first = 900;
  let last = 999;
}
class HundredMs<string n> : Constant<n, 1, 32767> { let note = "units of 100 ms"; }

// ---------------------------------------------------------------------------------------------- F46, F64, F65: timers
let category = "diagnostic", section = "F46", title = "Set an annunciator after a time",
    errors = ["6706: D, after indexing, is not S900-S999"],
    description = "While the condition is ON, S measures the time. When it has been ON without a break for m x 100 ms, D comes "
                  "ON, and stays so until ANR or RST. OFF clears S and leaves D. S is a 100 ms timer that nothing else drives. "
                  "With M8049 ON, M8048 tells that an annunciator S900-S999 is ON, and D8049 the lowest one." in
defm ANS : Plain<"ANS", 46, Keeps<"ans", [0, 1, 2], [0, 2]>, [InnerTimer<"S">, HundredMs<"m">, Annunciator<"D">], 7,
                 "T0 K10 S900">;

let category = "other" in {
let section = "F64", title = "Teaching timer",
    description = "Measures how long the condition is ON, a button say. While it is ON, D + 1 is the time in units of 100 ms, and "
                  "D is the time in seconds times 10^n, cut to whole numbers: with n = 1 a set value for a 100 ms timer, with n = "
                  "2 for one of 10 ms. Both stop at 32767. When the condition goes OFF, D + 1 becomes 0 and D stays." in
defm TTMR : Plain<"TTMR", 64, Keeps<"ttmr", [0, 1], [0]>, [BlockOut<"D", 2, Registers>, Constant<"n", 0, 2>], 5, "D300 K1">;
let section = "F65", title = "Special timer",
    description = "Four outputs of one condition, with a time of m x 100 ms that S measures anew after each change of the "
                  "condition. D: ON with the condition, OFF that time after it went OFF. D + 1: ON for that time after it went "
                  "OFF. D + 2: ON for that time after it came ON, as long as it is ON. D + 3: ON that time after it came ON, OFF "
                  "that time after it went OFF. With the contact D + 3 normally closed in front of the instruction, D + 2 and D + "
                  "1 take turns. S is a 100 ms timer that nothing else drives; it is cleared when the time after OFF is over." in
defm STMR : Plain<"STMR", 65, Keeps<"stmr", [0, 1, 2], [0, 2]>, [InnerTimer<"S">, HundredMs<"m">, BitsOut<"D", 4>], 7,
                  "T10 K100 M0">;
}

// ---------------------------------------------------------------------------------------------- F60 IST
class ModeInputs<string n> : BitsIn<n, 8, Classes<[DevX, DevY, DevM]>> { let indexable = 0; }
class SequenceEnd<string n> : BitsIn<n, 1, StepBits> {
  let indexable = 0;
  let first = 20;
  let last = 899;
}
let category = "stage", section = "F60", title = "Initial states and modes", images = ["S", "Y"],
    errors = ["6706: D1 is not below D2"],
    description = "Runs a step ladder in five modes. S is the first of eight bits: manual, return to the origin, step, one cycle, "
                  "continuous (one of them ON; of several the lowest counts, with none the mode stays), start of the return, "
                  "start, stop. D1 and D2 are the lowest and the highest state of the automatic sequence. S0 belongs to manual, "
                  "S1 to return, S2 to the three automatic modes: the first execution after RUN and a change between these groups "
                  "switch them, S2 only while no state from D1 to D2 is active. A change away from the origin (M8043 and M8044 "
                  "OFF) resets S0-S899 before and, unless M8045 is ON, all Y. M8040 (no transfers): ON in manual; in return and "
                  "one cycle from stop until start; in step except in the scan in which start is pressed; in continuous after RUN "
                  "until start. M8041 (transfer from S2): in step and one cycle while start is ON, in continuous from start until "
                  "stop, otherwise OFF. M8042: ON for the scan in which start, or in return mode the start of the return, is "
                  "pressed. The program drives M8043, M8044 and M8045. With the condition OFF everything stays, M8042 goes OFF. "
                  "Place it before the step ladder." in
defm IST : Plain<"IST", 60, Keeps<"ist", [0, 1, 2], []>,
                 [ModeInputs<"S">, SequenceEnd<"D1">, SequenceEnd<"D2">], 7, "X30 S20 S40">;

// ---------------------------------------------------------------------------------------------- F61 SER, F69 SORT
class TableSize<string n, int most> : Count<n> {
  let min = 1;
  let max = most;
}
def SearchedPairs : Classes<[DevT, DevC, DevCL] # DataRegisters, [], [DevX, DevY, DevM, DevMS, DevS]>;
def FoundPairs : Classes<[DevT, DevC, DevCL] # DataRegisters, [], [DevY, DevM, DevMS, DevS]>;
let category = "table" in {
let section = "F61", title = "Search a table",
    errors = ["6706: n is not in 1 to 256 (DSER: 1 to 128)", "6706: n items from S1, or 5 from D, go beyond the last number"],
    description = "Compares the n items from S1 on with S2, signed, 16 bits, with D 32. Into the five places from D on, of the "
                  "same width: how many items equal S2, the position of the first and of the last of them (0 is S1; all three are "
                  "0 where there is none), the position of the smallest and of the largest item, of several the last one. No flag "
                  "changes. With the condition OFF, and on an error, D stays." in
defm SER : PulsedBoth<"SER", 61, MayFail<"ser", [0, 1, 2, 3], [2]>,
                      [BlockIn<"S1">, Source<"S2", OpWord>, BlockOut<"D", 5>, TableSize<"n", 256>],
                      [BlockIn<"S1", 0, SearchedPairs, OpDWordBlock>, Source<"S2", OpDWord>,
                       BlockOut<"D", 5, FoundPairs, OpDWordBlock>, TableSize<"n", 128>],
                      9, 17, "D100 D0 D50 K10", "D100 D0 D50 K10">;
let section = "F69", title = "Sort a table",
    errors = ["6706: m1 is not in 1 to 32, m2 not in 1 to 6, or n not in 1 to m2",
              "6706: m1 x m2 words from S or D go beyond the last one"],
    description = "The table has m1 rows and m2 columns and lies column by column from S on. It is copied to D, in the same "
                  "order, with the rows ascending by column n, signed; equal rows keep their order. D may be S. The work takes m1 "
                  "executions, one in each scan; in the last one and from then on while the condition is ON, M8029 is ON, before "
                  "OFF. m1, m2 and n are read when it starts; S is read in the first execution. For another run the condition has "
                  "to go OFF, which also ends a run." in
defm SORT : Plain<"SORT", 69, Keeps<"sort", [0, 1, 2, 3, 4], [3]>,
                  [BlockIn<"S", 0, Registers>, TableSize<"m1", 32>, TableSize<"m2", 6>, BlockOut<"D", 0, Registers>,
                   TableSize<"n", 6>],
                  11, "D100 K5 K4 D200 K2">;
}

// ---------------------------------------------------------------------------------------------- F62 ABSD, F63 INCD
class CamTable<OperandType t> : BlockIn<"S1", 0, !if(!eq(t, OpWordBlock), ReadBlocks, SearchedPairs), t> {
  let note = !if(!eq(t, OpWordBlock), "digits: K4", "digits: K8") # " from a number that is a multiple of 16";
}
def CamCounter : CounterOperand<"S2"> {
  let direction = "In";
  let indexable = 1;
}
def LongCamCounter : LongCounterOperand<"S2"> {
  let direction = "In";
  let indexable = 1;
}
class CounterPair<string n> : BlockChanged<n, 2, CounterClass> { let last = 198; }
def CamCount : Constant<"n", 1, 64>;
let category = "other" in {
let section = "F62", title = "Absolute cam", maxUses = 1,
    errors = ["6706: 2n numbers from S1, or n bits from D, go beyond the last one",
              "6706: digits in S1 are not K4 (DABSD: K8) or do not begin at a multiple of 16"],
    description = "S1 is a table of n pairs, rise and fall, 16 bits, with D 32; S2 is a counter, which the program drives and "
                  "resets. Each of the n bits from D on is ON while the value of S2 is not below its rise and below its fall; "
                  "where the rise is not below the fall, while the value is not below the rise or below the fall. DABSD follows "
                  "high-speed counters too, once in each scan. No flag changes. With the condition OFF, and on an error, D stays. "
                  "May stand in a program once." in
defm ABSD : PlainBoth<"ABSD", 62, MayFail<"absd", [0, 1, 2, 3], [2]>,
                      [CamTable<OpWordBlock>, CamCounter, BitsOut<"D">, CamCount],
                      [CamTable<OpDWordBlock>, LongCamCounter, BitsOut<"D">, CamCount], 9, 17, "D300 C0 M0 K4", "D300 C200 M0 K4">;
let section = "F63", title = "Incremental cam", images = ["C"],
    errors = ["6706: n numbers from S1, or n bits from D, go beyond the last one",
              "6706: digits in S1 are not K4 or do not begin at a multiple of 16"],
    description = "Runs through n stages, one of the n bits from D on being ON in each. S2 is a counter that the program drives; "
                  "S2 + 1 holds the number of the stage, from 0. When S2 has reached the number of its stage in the table S1, it "
                  "is reset and the next stage begins; behind the last one the first, and M8029 is ON for that execution, "
                  "otherwise OFF. When the condition goes OFF, both counters are cleared and all n bits go OFF; when it comes ON, "
                  "the first stage begins. Where RUN finds the condition ON, counters that are latched go on." in
defm INCD_cam : Plain<"INCD", 63, Keeps<"incd", [0, 1, 2, 3], [1, 2]>,
                      [CamTable<OpWordBlock>, CounterPair<"S2">, BitsOut<"D">, CamCount], 9, "D300 C0 M0 K4">;
}

// ---------------------------------------------------------------------------------------------- F66 ALT, F67 RAMP, F68 ROTC
let category = "output", section = "F66", title = "Alternate",
    description = "D changes its state. ALTP does so when the condition comes ON, ALT in every scan while it is ON. With the "
                  "condition OFF D stays." in
defm ALT : Pulsed<"ALT", 66, Computes<"alt", [0], [0]>, [BitChanged<"D">], 3, "M0">;

let category = "other" in {
let section = "F67", title = "Ramp",
    description = "D goes evenly from S1 to S2 in n scans, D + 1 counts them: D is S1 in the scan in which the condition comes ON "
                  "and S2 n scans later, where M8029 is ON, otherwise OFF. Then D starts from S1 again, or, with M8026 ON, stays "
                  "at S2 and M8029 ON. In between values are cut towards S1. S1 and S2 are read in every scan. OFF interrupts: D "
                  "and D + 1 stay, and the next ON starts from S1. Where RUN finds the condition ON, the count in D + 1 goes on: "
                  "clear it before if it is latched." in
defm RAMP : Plain<"RAMP", 67, Keeps<"ramp", [0, 1, 2, 3], [2]>,
                  [SourceDevice<"S1", OpWord, Registers>, SourceDevice<"S2", OpWord, Registers>, BlockOut<"D", 2, Registers>,
                   Constant<"n", 1, 32767>],
                  9, "D1 D2 D3 K1000">;
let section = "F68", title = "Rotary table",
    errors = ["6706: m2 is above m1", "6706: S + 1 or S + 2 is not in 0 to m1 - 1"],
    description = "Turns a table of m1 divisions by the shorter way until the called item stands at the called window. S is the "
                  "item at window 0, S + 1 the called window, S + 2 the called item, all counted from 0. The program copies an "
                  "encoder to D (phase A) and D + 1 (phase B), and to D + 2 the sensor that item 0 stands at window 0. S counts "
                  "up where A leads and down where B leads, from m1 - 1 to 0 and back; D + 2 holds it at 0. One of D + 3 "
                  "(forward, fast), D + 4 (forward, slow), D + 5 (stop), D + 6 (backward, slow) and D + 7 (backward, fast) is ON; "
                  "slow are the last m2 divisions, forward is where S counts up, also of two equal ways. When the condition goes "
                  "OFF, they go OFF. The manual's text of this section is that of SORT; what the instruction does here is what is "
                  "known of it elsewhere." in
defm ROTC : Plain<"ROTC", 68, Keeps<"rotc", [0, 1, 2, 3], [0, 3]>,
                  [BlockChanged<"S", 3, Registers>, Constant<"m1", 2, 32767>, Constant<"m2", 0, 32767>, BitsOut<"D", 8>], 9,
                  "D200 K10 K2 M0">;
}
