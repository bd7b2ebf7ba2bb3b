// Floating point (F49, F110-F137) and the control loop (F88). Numbers are IEEE-754 singles in register pairs, low word first.

// No constants.
class RealRegister<string n> : RealIn<n, 0>;
// Printed without the dot of operands that an index register may modify.
class PlainRealIn<string n> : RealRegister<n> { let indexable = 0; }
class PlainRealOut<string n> : RealOut<n> { let indexable = 0; }

class Unary<string f> : MayFail<f, [0], [1]>;
class Binary<string f> : MayFail<f, [0, 1], [2]>;

defvar RealFlags = " M8020: the result is 0. M8021: it is not 0, but below the smallest normal number (1.17549435E-38); 0 is "
                   "stored. M8022: it is beyond the largest one (3.40282347E38), which is stored with its sign. OFF changes "
                   "nothing, the flags neither.";
defvar NotFinite = "6706: an operand is infinite or not a number; nothing is written";
defvar RealErrors = [NotFinite];

// ---------------------------------------------------------------------------------------------- integers
let section = "F49", category = "float", title = "Integer to floating point",
    description = "D becomes the number in S: a word, or in the D form a pair. Beyond 24 bits it is rounded to the nearest number "
                  "that D can hold, to the even one of two. Flags stay as they are. Constants are not allowed here, as the other "
                  "instructions convert theirs." in
defm FLT : PulsedBoth<"FLT", 49, Computes<"flt", [0], [1]>, [SourceDevice<"S", OpWord, Registers>, RealOut<"D">],
                      [SourceDevice<"S", OpDWord, Registers>, RealOut<"D">], 5, 9, "D0 D10", "D0 D10">;

let section = "F129", category = "conversion", title = "Floating point to integer", errors = RealErrors,
    description = "D becomes the number in S (a pair in both forms) without its fraction: a word, or in the D form a pair. M8020: "
                  "D is 0. M8021: a fraction was cut off. M8022: S is out of range of D; D becomes the nearest integer and the "
                  "other flags are OFF." in
defm INT : PulsedBoth<"INT", 129, MayFail<"integer", [0], [1]>, [RealIn<"S">, Target<"D", OpWord, Registers>],
                      [RealIn<"S">, Target<"D", OpDWord, Registers>], 5, 9, "D0 D10", "D20 D30">;

// ---------------------------------------------------------------------------------------------- comparison
let category = "comparison", errors = RealErrors in {
let section = "F110", title = "Compare floating point",
    description = "Of the three bits from D on, one comes ON and the others OFF: D where S1 > S2, D+1 where they are equal, D+2 "
                  "where S1 < S2. K and H constants are converted. OFF: the bits keep their state." in
defm ECMP : PulsedWide<"ECMP", 110, MayFail<"ecmp", [0, 1, 2], [2]>, [RealIn<"S1">, RealIn<"S2">, BitsOut<"D", 3>], 13,
                       "D0 D10 M0">;
let section = "F111", title = "Compare floating point with a zone",
    description = "Of the three bits from D on, one comes ON and the others OFF: D where S < S1, D+1 where S lies from S1 to S2, "
                  "D+2 where S > S2. With S1 > S2, S1 is both limits, as in TZCP. OFF: the bits keep their state." in
defm EZCP : PulsedWide<"EZCP", 111, MayFail<"ezcp", [0, 1, 2, 3], [3]>,
                       [RealIn<"S1">, RealIn<"S2">, RealIn<"S">, BitsOut<"D", 3>], 17, "D0 D10 D20 M0">;
}

// ---------------------------------------------------------------------------------------------- arithmetic
let category = "float" in {
let section = "F118", title = "Binary to decimal floating point", errors = RealErrors,
    description = "D becomes the mantissa (1000 to 9999 with the sign of S, or 0) and D+1 the exponent (-41 to 35) of S as "
                  "mantissa x 10^exponent, rounded to the nearest: 100 is 1000 and -1. M8020: S is 0; D and D+1 become 0. M8021: S "
                  "is not 0 but below 1175 x 10^-41; D and D+1 become 0. M8022: S would round to more than 3402 x 10^35, which is "
                  "stored." in
defm EBCD : PulsedWide<"EBCD", 118, MayFail<"ebcd", [0, 1], [1]>, [RealRegister<"S">, BlockOut<"D", 2, Registers>], 9, "D44 D40">;

let section = "F119", title = "Decimal to binary floating point",
    errors = ["6706: the mantissa is neither 0 nor 1000 to 9999 with either sign, or the exponent is not -41 to 35; nothing is "
              "written"],
    description = "D becomes S x 10^(S+1), mantissa and exponent being two words, rounded to a single. With the mantissa 0 it is "
                  "0, whatever the exponent is. 1175 x 10^-41 is the smallest number." # RealFlags in
defm EBIN : PulsedWide<"EBIN", 119, MayFail<"ebin", [0], [1]>, [BlockIn<"S", 2, Registers>, RealOut<"D">], 9, "D50 D40">;

defvar TwoReals = [RealIn<"S1">, RealIn<"S2">, RealOut<"D">];
let section = "F120", title = "Add floating point", errors = RealErrors,
    description = "D becomes S1 + S2. K and H constants are converted." # RealFlags in
defm EADD : PulsedWide<"EADD", 120, Binary<"eadd">, TwoReals, 13, "D50 D40 D10">;
let section = "F121", title = "Subtract floating point", errors = RealErrors,
    description = "D becomes S1 - S2. K and H constants are converted." # RealFlags in
defm ESUB : PulsedWide<"ESUB", 121, Binary<"esub">, TwoReals, 13, "D50 D40 D10">;
let section = "F122", title = "Multiply floating point", errors = RealErrors,
    description = "D becomes S1 x S2. K and H constants are converted." # RealFlags in
defm EMUL : PulsedWide<"EMUL", 122, Binary<"emul">, TwoReals, 13, "D50 D40 D10">;
let section = "F123", title = "Divide floating point", errors = ["6706: the divisor is 0; nothing is written", NotFinite],
    description = "D becomes S1 / S2. K and H constants are converted." # RealFlags in
defm EDIV : PulsedWide<"EDIV", 123, Binary<"ediv">, TwoReals, 13, "D50 D40 D10">;

let section = "F127", title = "Square root of floating point", errors = ["6706: S is negative; nothing is written", NotFinite],
    description = "D becomes the square root of S. K and H constants are converted. M8020: the result is 0; M8021 and M8022 are "
                  "OFF. The program needs sqrtf of a C library." in
defm ESQR : PulsedWide<"ESQR", 127, Unary<"esqr">, [RealIn<"S">, RealOut<"D">], 9, "D50 D40">;

// ---------------------------------------------------------------------------------------------- trigonometry
defvar OneReal = [RealRegister<"S">, RealOut<"D">];
let section = "F130", title = "Sine", errors = RealErrors,
    description = "D becomes the sine of the angle S in radians. The program needs sinf of a C library." # RealFlags in
defm SIN : PulsedWide<"SIN", 130, Unary<"sin">, OneReal, 9, "D10 D20">;
let section = "F131", title = "Cosine", errors = RealErrors,
    description = "D becomes the cosine of the angle S in radians. The program needs cosf of a C library." # RealFlags in
defm COS : PulsedWide<"COS", 131, Unary<"cos">, OneReal, 9, "D10 D20">;
let section = "F132", title = "Tangent", errors = RealErrors,
    description = "D becomes the tangent of the angle S in radians. The program needs tanf of a C library." # RealFlags in
defm TAN : PulsedWide<"TAN", 132, Unary<"tan">, OneReal, 9, "D10 D20">;

defvar OnePlainReal = [PlainRealIn<"S">, PlainRealOut<"D">];
defvar NoSine = "6706: S is not -1 to 1; nothing is written";
let section = "F133", title = "Arc sine", errors = [NoSine],
    description = "D becomes the angle from -pi/2 to pi/2 whose sine is S; S may be 1 too. The program needs asinf of a C library."
                  # RealFlags in
defm ASIN : PulsedWide<"ASIN", 133, Unary<"asin">, OnePlainReal, 9, "D10 D20">;
let section = "F134", title = "Arc cosine", errors = [NoSine],
    description = "D becomes the angle from 0 to pi whose cosine is S; S may be 1 too. The program needs acosf of a C library."
                  # RealFlags in
defm ACOS : PulsedWide<"ACOS", 134, Unary<"acos">, OnePlainReal, 9, "D10 D20">;
let section = "F135", title = "Arc tangent", errors = RealErrors,
    description = "D becomes the angle from -pi/2 to pi/2 whose tangent is S. The program needs atanf of a C "
                  "library." # RealFlags in
defm ATAN : PulsedWide<"ATAN", 135, Unary<"atan">, OnePlainReal, 9, "D10 D20">;
let section = "F136", title = "Degrees to radians", errors = RealErrors,
    description = "D becomes S x pi / 180." # RealFlags in
defm RAD : PulsedWide<"RAD", 136, Unary<"rad">, OnePlainReal, 9, "D10 D20">;
let section = "F137", title = "Radians to degrees", errors = RealErrors,
    description = "D becomes S x 180 / pi." # RealFlags in
defm DEG : PulsedWide<"DEG", 137, Unary<"deg">, OnePlainReal, 9, "D10 D20">;
}

// ---------------------------------------------------------------------------------------------- control loop
class PlainRegister<string n> : SourceDevice<n, OpWord, Registers> { let indexable = 0; }
def PlainDataRegisters : Classes<PlainRegisters>;
def ParameterBlock : BlockChanged<"S3", 25, PlainDataRegisters> { let indexable = 0; }
def PlainOutput : Changed<"D", OpWord, Registers> { let indexable = 0; }
let section = "F88", category = "pid", title = "PID control loop",
    description =
        "Keeps the measured value S2 at the set value S1 by the output D. S3 is the first of 25 parameters: S3 sampling time Ts "
        "(1-32767 ms); S3+1 action: bit 0 reverse (the output rises while the measured value is too low), bit 1 alarm on changes "
        "of the input, bit 2 on those of the output, bit 4 automatic tuning, bit 5 limits of the output, which exclude bit 2; "
        "S3+2 input filter a (0-99 %); S3+3 gain Kp (1-32767 %); S3+4 integral time TI (x 100 ms, 0 without); S3+5 derivative "
        "gain aD (0-100 %); S3+6 derivative time TD (x 10 ms, 0 without); S3+7 to S3+19 not used here; S3+20, S3+21 alarm limits "
        "of a rise and of a fall of the input between samples; S3+22, S3+23 those of the output, or its upper and lower limit; "
        "S3+24 alarms: bit 0, 1 input rose, fell, bit 2, 3 output rose, fell.\n"
        "While ON, a scan that finds Ts elapsed calculates: PVf = PV + a (PVf' - PV); EV = SV - PVf (forward: PVf - SV); Dn = TD "
        "/ (Ts + aD TD) x (2 PVf' - PVf - PVf'') (forward: negative) + aD TD / (Ts + aD TD) x Dn'; MV = MV' + Kp ((EV - EV') + Ts "
        "/ TI x EV + Dn). MV keeps its fraction, D is rounded. Limits act on the sum itself, so that it does not wind up. ON, and "
        "the first scan, start without a jump from what D holds; so does a value that the program writes to D. OFF: D stays.\n"
        "Tuning: D is the height of a step and stands still. When the measured value has gone a third of the way to the set "
        "value, bit 0, Kp, TI and TD are written (Kp = 120 x D / (R L), TI = 20 L, TD = 50 L, with R the steepest rise per second "
        "and L the dead time in seconds, at least Ts), bit 4 goes OFF and control begins. A tuning that fails leaves the "
        "parameters and turns bit 4 OFF.",
    errors = ["6730: Ts is below 1", "6732: the filter is not 0-99", "6733: Kp is below 1", "6734: TI is negative",
              "6735: aD is not 0-100", "6736: TD is negative",
              "6706: a limit of an alarm that is on is negative, or the upper limit lies below the lower one",
              "6740: Ts is not above the scan time, outside of interrupt routines; every scan calculates, with the scan time as Ts",
              "6742-6747: change of the input, deviation, integral part, derivative part because of its gain, derivative part, "
              "output: limited to 16 bits; goes on",
              "6750: tuning ended, nothing to learn or parameters out of range",
              "6751: tuning goes on, the input moves away from the set value",
              "6752: tuning ended, the input went up and down"] in
defm PID : Plain<"PID", 88, Keeps<"Pid", [0, 1, 2, 3], [2, 3]>,
                 [PlainRegister<"S1">, PlainRegister<"S2">, ParameterBlock, PlainOutput], 9, "D0 D1 D100 D150">;
