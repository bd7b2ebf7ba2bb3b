// Direct input and output, high-speed counters, pulse density: F50, F52-F56.

class InputRun<string n, int length = 0> : BitsIn<n, length, InputBits>;
// The whole counter, by reference: it is compared at its own counts, outside of the instruction.
class HighSpeedCounter<string n> : Operand<n, "In", OpLongCounter, LongCounterClass> {
  let indexable = 1;
  let first = 235;
  let last = 254;
}
class LaterBit<string n, Classes c> : Operand<n, "Out", OpBitTarget, c> { let indexable = 1; }
def InnerBits : Classes<[DevM, DevMS, DevS]>;
// Inputs that count by themselves.
class FastInput<int from, int to> : BitsIn<"S1", 1, InputBits> {
  let first = from;
  let last = to;
}
// Rows of MTR.
class MatrixTable<Classes c> : BitsOut<"D2", 0, c> { let indexable = 0; }
// I010-I060, handed over as a number.
def CountInterrupt : Operand<"D", "In", OpWord, Interrupts> {
  let first = 10;
  let last = 60;
}

let category = "io" in {
// ------------------------------------------------------------------------- F50 REF
let section = "F50", errors = ["6706: n is not 8 or 16, or D does not end in 0 or lies outside of X0-X17 and Y0-Y7"] in {
let title = "Refresh inputs or outputs",
    description = "Inputs: reads n terminals from D on into the image at once, where the host knows them at this moment; what it "
                  "knows only from scan to scan stays as it was read before the scan. Outputs: sends the image of n outputs from "
                  "D on to the terminals at once, unless M8034 is ON. D is X0, X10 or Y0, n 8 or 16; points beyond X17 and Y7 "
                  "are left out. The next END, or the next scan, does the same for all terminals again." in {
defm REF_X : Pulsed<"REF", 50, MayFail<"refresh_inputs", [0, 1], [0]>, [BitsOut<"D", 0, InputBits>, CheckedConstant<"n">], 5,
                    "X10 K8">;
defm REF_Y : Pulsed<"REF", 50, MayFail<"refresh_outputs", [0, 1], []>, [BitsIn<"D", 0, OutputBits>, CheckedConstant<"n">], 5,
                    "Y0 K8">;
}
}

// ------------------------------------------------------------------------- F52 MTR
class Matrix<string f, Classes table>
    : AppForm<"MTR", "MTR", 52, EveryScan, Keeps<f, [0, 1, 2, 3], [1, 2]>,
              [InputRun<"S", 8>, BitsOut<"D1", 0, OutputBits>, MatrixTable<table>, Constant<"n", 2, 8>], 9, ""> {
  let title = "Read a matrix of inputs";
  let section = "F52";
  let description = "While ON, the n outputs D1, D1+1, ... are switched ON one after another, each for 20 ms or, where scans are "
                    "longer, for a scan. At the end of its time the 8 inputs from S on are read into the row of D2 that belongs "
                    "to the output: rows begin 10 apart for M and S (M10, M20, ...), 8 apart for Y (Y0, Y10, ...). Outputs go to "
                    "their terminals at once, and inputs are read directly where the host knows them, as with REF. When the last "
                    "row has been read M8029 is ON until the next execution, and the first output follows. OFF switches the "
                    "outputs OFF and keeps the table; ON again begins with the first.";
  let errors = ["6706: the inputs, outputs or rows do not all exist"];
}
def MTR : Matrix<"ReadMatrix", InnerBits> { let example = Rung<"LD X0\nMTR X20 Y40 M10 K3">.text; }
def MTR_Y : Matrix<"ReadMatrixToOutputs", OutputBits> { let example = Rung<"LD X0\nMTR X20 Y40 Y50 K3">.text; }
}

let category = "high-speed" in {
// ------------------------------------------------------------------------- F53 DHSCS, F54 DHSCR
class AtCount<string m, int n, string f, list<int> reads, list<int> writes, Operand target, string d>
    : AppForm<"D" # m, m, n, EveryScan, Keeps<f, reads, writes>, [Source<"S1", OpDWord>, HighSpeedCounter<"S2">, target], 13, ""> {
  let wide = 1;
  let example = Rung<"LD M8000\nOUT C235 K1000\nLD X10\nD" # m # " K100 C235 " # d>.text;
}
defvar CompareRules = " Only a count compares: neither a value written to the counter or to S1, nor a reset. Goes on in scans that "
                      "skip it, until it is executed with its condition OFF. Six of DHSCS, DHSCR and DHSZ may be ON at a time.";
defvar TooMany = "6705: a seventh comparison at a time";
let section = "F53", title = "Set a bit, or interrupt, at a count", errors = [TooMany],
    description = "While ON, the count that brings the high-speed counter S2 to the value S1, from below or above, sets D at "
                  "once, without waiting for the scan; an output goes straight to its terminal. D stays ON. With I010 to I060 as "
                  "D the count requests that interrupt routine instead; M8059 ON inhibits it." # CompareRules in {
def DHSCS : AtCount<"HSCS", 53, "SetAtCount", [0, 1], [2], LaterBit<"D", InnerBits>, "M10">;
def DHSCS_Y : AtCount<"HSCS", 53, "SetOutputAtCount", [0, 1], [2], LaterBit<"D", OutputBits>, "Y1">;
def DHSCS_I : AtCount<"HSCS", 53, "InterruptAtCount", [0, 1, 2], [], CountInterrupt, ""> {
  let example = Rung<"EI\nLD M8000\nOUT C235 K1000\nLD M8000\nDHSCS K100 C235 I010\nFEND\nI010\nLD M8000\nINC D0\nIRET">.text;
}
}
let section = "F54", title = "Reset a bit, or clear the counter, at a count", errors = [TooMany],
    description = "While ON, the count that brings the high-speed counter S2 to the value S1, from below or above, resets D at "
                  "once, without waiting for the scan; an output goes straight to its terminal. D stays OFF until something else "
                  "sets it. With the same counter as D the count clears it: the value becomes 0, the contact OFF." #
                  CompareRules in {
def DHSCR : AtCount<"HSCR", 54, "ResetAtCount", [0, 1], [2], LaterBit<"D", InnerBits>, "M10">;
def DHSCR_Y : AtCount<"HSCR", 54, "ResetOutputAtCount", [0, 1], [2], LaterBit<"D", OutputBits>, "Y1">;
def DHSCR_C : AtCount<"HSCR", 54, "ClearAtCount", [0, 1, 2], [], HighSpeedCounter<"D">, "C235"> {
  let errors = [TooMany, "6705: D is another counter than S2"];
}
}

// ------------------------------------------------------------------------- F55 DHSZ
class CountZone<string f, Classes c, string d>
    : AppForm<"DHSZ", "HSZ", 55, EveryScan, Keeps<f, [0, 1, 2, 3], [3]>,
              [Source<"S1", OpDWord>, Source<"S2", OpDWord>, HighSpeedCounter<"S">, BitsOut<"D", 3, c>], 17, ""> {
  let wide = 1;
  let section = "F55";
  let title = "Compare a count with a zone";
  let errors = [TooMany, "6706: D, D+1, D+2 do not all exist"];
  let description = "While ON, every count of the high-speed counter S writes three bits at once, without waiting for the scan: "
                    "D is ON below S1, D+1 from S1 to S2, D+2 above S2; outputs go straight to their terminals. An S2 below S1 "
                    "counts as S1. The execution that finds it ON first writes them too. OFF leaves them as they are." #
                    CompareRules;
  let example = Rung<"LD M8000\nOUT C251 K5000\nLD X10\nDHSZ K1000 K2000 C251 " # d>.text;
}
def DHSZ : CountZone<"ZoneOfCount", InnerBits, "M10">;
def DHSZ_Y : CountZone<"ZoneOfCountToOutputs", OutputBits, "Y0">;

// ------------------------------------------------------------------------- F56 SPD
class Density<int from, int to>
    : AppForm<"SPD", "SPD", 56, EveryScan, Keeps<"PulseDensity", [0, 1, 2], [2]>,
              [FastInput<from, to>, Source<"S2", OpWord>, BlockOut<"D", 3, ValueOrIndexWords>], 7, "X" # from # " K100 D0"> {
  let section = "F56";
  let title = "Pulse density";
  let errors = ["6706: the time S2 is 0 or below, S1 is no fast input, or D, D+1, D+2 do not all exist"];
  let description = "While ON, counts the edges OFF to ON of the input S1 (X0-X5, SR X0-X3), also those between scans, in "
                    "windows of S2 ms that follow each other without a gap. D is the count of the last whole window, D+1 that of "
                    "the present one so far, D+2 the ms that are left of it. Where one scan ends several windows, its edges are "
                    "shared out evenly. Goes on in scans that skip it. OFF leaves all three as they are; ON again begins a new "
                    "window.";
}
def SPD : Density<0, 3>;
def SPD_X4 : Density<4, 5> { let models = LargeModels; }
}
