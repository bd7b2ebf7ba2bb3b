// Pulse outputs and positioning: F57 PLSY, F58 PWM, F59 PLSR, F156 ZRN, F157 PLSV, F158 DRVI, F159 DRVA.
//
// The system puts the pulses out between scans; the instruction starts, watches and stops them. Runtime: tp03/ops/position.h.

// Y0 or Y1.
class PulseOutput<string n> : Operand<n, "InOut", OpBitTarget, OutputBits> {
  let indexable = 1;
  let first = 0;
  let last = 1;
}

defvar PulseRules = " The position counter of the output, (D8141, D8140) for Y0 and (D8143, D8142) for Y1, counts along. M8147 "
  "(Y0) or M8148 (Y1) is ON while pulses go out; M8145 or M8146 stops them at once without completing the instruction, and "
  "nothing starts while it is ON. An output drives one instruction at a time: a drive while the output is in use is refused with "
  "an error until the condition was OFF; a drive in the scan in which the output stopped is in error for that scan and starts in "
  "the next. The output is chosen when the drive begins; a later change of its index register waits for the next drive.";
defvar Ends = " A condition that goes OFF behind the end switches M8029 off.";
defvar InUse = "6706: D is neither Y0 nor Y1 after indexing, is in use, or stopped less than one scan ago";
defvar InUse1 = "6706: D1 is neither Y0 nor Y1 after indexing, is in use, or stopped less than one scan ago";

let models = LargeModels, category = "high-speed" in {
let section = "F57", title = "Output pulses",
    description = "Puts S2 pulses of S1 Hz out on D, ON for half of each; S2 = 0 is without end. The pulses do not depend on the "
                  "scan; the image of D shows their level at the beginning of the scan. S1 may change while pulses go out: the "
                  "frequency follows, and a value out of range is an error that leaves the last one. S2 counts when the drive "
                  "begins. Behind the last pulse D is OFF and M8029 ON. Condition OFF: stops at once, the next drive begins "
                  "anew." # Ends # PulseRules,
    errors = ["6706: S1 is not 1-32767 (DPLSY 1-100000), or S2 is negative", InUse] in
defm Plsy : PlainBoth<"PLSY", 57, Keeps<"PulseTrain", [0, 1, 2], [2]>,
                      [Source<"S1", OpWord>, Source<"S2", OpWord>, PulseOutput<"D">],
                      [Source<"S1", OpDWord>, Source<"S2", OpDWord>, PulseOutput<"D">], 7, 13, "K1000 D0 Y0", "D0 K200000 Y1">;

let section = "F58", title = "Modulate a pulse width",
    description = "D is ON for S1 ms out of every S2 ms, independently of the scan: S1 = 0 is always OFF, S1 = S2 always ON. The "
                  "image of D shows its level at the beginning of the scan. Both may change while D is driven and act at once; a "
                  "wrong pair is an error that leaves the last one. Condition OFF: D is OFF. M8029, the busy and stop relays and "
                  "the position counters have no part in it. An output drives one instruction at a time: a drive while it is in "
                  "use is refused with an error until the condition was OFF. The output is chosen when the drive begins.",
    errors = ["6706: S2 is not 1-3000, or S1 is negative or above S2", InUse] in
defm Pwm : Plain<"PWM", 58, Keeps<"PulseWidth", [0, 1, 2], [2]>, [Source<"S1", OpWord>, Source<"S2", OpWord>, PulseOutput<"D">], 7,
                 "D10 K50 Y0">;

let section = "F59", title = "Output pulses with ramps",
    description = "Puts S2 pulses out on D: the frequency rises to S1 in ten equal steps of S1/10 in S3 ms, and falls in the same "
                  "steps before the end. Frequencies outside 10-100000 Hz are taken as the nearest of these. Where S2 is too "
                  "small for both ramps, the frequency turns in the middle. All operands count when the drive begins. Behind the "
                  "last pulse D is OFF and M8029 ON. Condition OFF: stops at once, the next drive begins anew. S3 should be at "
                  "least ten scans and 450000/S1, and at most 818 S2/S1; nothing checks that." # Ends # PulseRules,
    errors = ["6706: S2 is below 110, or S3 is not 0-5000", InUse] in
defm Plsr : PlainBoth<"PLSR", 59, Keeps<"PulseRamp", [0, 1, 2, 3], [3]>,
                      [Source<"S1", OpWord>, Source<"S2", OpWord>, Source<"S3", OpWord>, PulseOutput<"D">],
                      [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Source<"S3", OpDWord>, PulseOutput<"D">], 9, 17,
                      "K500 D0 K3600 Y0", "K50000 D0 K500 Y1">;

let section = "F156", title = "Return to the origin",
    description = "Runs backwards at S1 Hz, at S2 Hz from the scan in which the near-point signal S3 comes ON, and stops in the "
                  "scan in which S3 goes OFF: the position counter becomes 0, M8029 is ON, and with M8140 ON the clear signal is "
                  "given, Y2 for Y0 and Y3 for Y1, for 20 ms and until the next scan begins. S3 is looked at when the instruction "
                  "is executed. A drive with S3 ON begins at S2. The speed changes at once: D8145-D8148 have no part in it. The "
                  "position counts down. Operands count when the drive begins. Condition OFF before the end: stops at once, "
                  "without M8029." # Ends # PulseRules,
    errors = ["6706: S1 is not 10-32767 (DZRN 10-100000), or S2 is not 10-32767", InUse], images = ["Y"] in
defm Zrn : PlainBoth<"ZRN", 156, Keeps<"HomeReturn", [0, 1, 2, 3], [3]>,
                     [Source<"S1", OpWord>, Source<"S2", OpWord>, BitIn<"S3">, PulseOutput<"D">],
                     [Source<"S1", OpDWord>, Source<"S2", OpDWord>, BitIn<"S3">, PulseOutput<"D">], 9, 17,
                     "K1000 K100 X3 Y0", "K50000 K1000 X3 Y1">;

let section = "F157", title = "Output pulses of variable speed",
    description = "Puts pulses of |S| Hz out on D1 without end. D2 is ON and the position counts up for a positive S, OFF and "
                  "down for a negative one. S acts at once whenever it changes, without ramps; 0 puts no pulses out, leaves D2 "
                  "and switches the busy relay off; a value out of range is an error that leaves the last one. M8029 is OFF while "
                  "the condition is ON. Condition OFF: stops at once, D2 keeps its state." # PulseRules,
    errors = ["6706: S of DPLSV is not -100000 to 100000", InUse1] in
defm Plsv : PlainBoth<"PLSV", 157, Keeps<"VariablePulses", [0, 1], [1, 2]>,
                      [Source<"S", OpWord>, PulseOutput<"D1">, BitOut<"D2">],
                      [Source<"S", OpDWord>, PulseOutput<"D1">, BitOut<"D2">], 7, 13, "D0 Y0 Y4", "D0 Y1 Y5">;

defvar MoveRules = " The frequency starts at the base speed D8145, rises with an acceleration that takes it to the highest speed "
  "(D8147, D8146) in D8148 ms, in a hundred steps, and falls in the same way; a move that is too short turns in the middle. "
  "Frequencies below the root of (D8147, D8146) / (2 D8148 / 1000) are raised to it. D8145 is at most a tenth of the highest "
  "speed, (D8147, D8146) 10-100000 Hz, D8148 50-5000 ms, values beyond are taken as the nearest of these; 0 in (D8147, D8146) or "
  "D8148, as after power-on, is 100000 Hz and 100 ms. All operands count when the drive begins. At the end M8029 is ON; a move of "
  "0 pulses is at its end at once and leaves D2. Condition OFF on the way: falls along the ramp and stops, without M8029; a new "
  "drive before that is refused.";

let section = "F158", title = "Move by a distance",
    description = "Puts |S1| pulses out on D1 at S2 Hz. D2 is ON and the position counts up for a positive S1, OFF and down for a "
                  "negative one." # MoveRules # Ends # PulseRules,
    errors = ["6706: S2 is not 10-32767 (DDRVI 10-100000), or above (D8147, D8146)", InUse1] in
defm Drvi : PlainBoth<"DRVI", 158, Keeps<"RelativeMove", [0, 1, 2], [2, 3]>,
                      [Source<"S1", OpWord>, Source<"S2", OpWord>, PulseOutput<"D1">, BitOut<"D2">],
                      [Source<"S1", OpDWord>, Source<"S2", OpDWord>, PulseOutput<"D1">, BitOut<"D2">], 9, 17,
                      "K500 K1000 Y0 Y4", "D0 K50000 Y1 Y5">;

let section = "F159", title = "Move to a position",
    description = "Puts as many pulses out on D1 at S2 Hz as lie between the position counter of D1 and S1. D2 is ON and the "
                  "position counts up where S1 is higher, OFF and down where it is lower." # MoveRules # Ends # PulseRules,
    errors = ["6706: S2 is not 10-32767 (DDRVA 10-100000), or above (D8147, D8146)", InUse1] in
defm Drva : PlainBoth<"DRVA", 159, Keeps<"AbsoluteMove", [0, 1, 2], [2, 3]>,
                      [Source<"S1", OpWord>, Source<"S2", OpWord>, PulseOutput<"D1">, BitOut<"D2">],
                      [Source<"S1", OpDWord>, Source<"S2", OpDWord>, PulseOutput<"D1">, BitOut<"D2">], 9, 17,
                      "K400 K1000 Y0 Y4", "D0 K50000 Y1 Y5">;
}
