// Comparison contacts: F224-F246. Not indexable.

class ComparedValue<string n, OperandType t> : Source<n, t> { let indexable = 0; }
// `n` is the number of the LD contact; AND is 8 behind it, OR 16. Lists of related controllers write the D behind: LDD=.
class CompareForm<string connection, bit is32, string sign, Placement at, int n, OperandType t, string fn>
    : Instruction<!if(is32, "D", "") # connection # sign, connection # sign> {
  let aliases = !if(is32, ["D" # connection # " " # sign, connection # "D" # sign, connection # "D " # sign],
                    [connection # " " # sign]);
  let section = "F" # n;
  let category = "comparison";
  let placement = at;
  let lowering = LowerCompareContact;
  let style = StyleValue;
  let function = fn;
  let inputs = [0, 1];
  let number = n;
  let wide = is32;
  let steps = !if(is32, 9, 5);
  let operands = [ComparedValue<"S1", t>, ComparedValue<"S2", t>];
}
multiclass Compare<string sign, int n, string fn> {
  let example = Rung<"LD" # sign # " D0 K10\nOUT Y0">.text in
  def LD : CompareForm<"LD", 0, sign, AtStart, n, OpWord, fn>;
  let example = Rung<"DLD" # sign # " D0 K100000\nOUT Y0">.text in
  def LDD : CompareForm<"LD", 1, sign, AtStart, n, OpDWord, fn>;
  let example = Rung<"LD X0\nAND" # sign # " D0 D1\nOUT Y0">.text in
  def AND : CompareForm<"AND", 0, sign, AtSeries, !add(n, 8), OpWord, fn>;
  let example = Rung<"LD X0\nDAND" # sign # " D0 D2\nOUT Y0">.text in
  def ANDD : CompareForm<"AND", 1, sign, AtSeries, !add(n, 8), OpDWord, fn>;
  let example = Rung<"LD X0\nOR" # sign # " K4X10 H0F\nOUT Y0">.text in
  def OR : CompareForm<"OR", 0, sign, AtParallel, !add(n, 16), OpWord, fn>;
  let example = Rung<"LD X0\nDOR" # sign # " C200 D2\nOUT Y0">.text in
  def ORD : CompareForm<"OR", 1, sign, AtParallel, !add(n, 16), OpDWord, fn>;
}

let title = "Comparison contact, equal",
    description = "A contact that is ON while S1 equals S2. Both are signed numbers of 16 bits, with D of 32. AND puts it in "
                  "series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the "
                  "top bit set is negative. C200 on stand in the D forms only. No flag changes." in
defm Equal : Compare<"=", 224, "equal">;
let title = "Comparison contact, greater",
    description = "A contact that is ON while S1 is greater than S2. Both are signed numbers of 16 bits, with D of 32. AND puts "
                  "it in series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with "
                  "the top bit set is negative. C200 on stand in the D forms only. No flag changes." in
defm Greater : Compare<">", 225, "greater">;
let title = "Comparison contact, less",
    description = "A contact that is ON while S1 is less than S2. Both are signed numbers of 16 bits, with D of 32. AND puts it "
                  "in series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the "
                  "top bit set is negative. C200 on stand in the D forms only. No flag changes." in
defm Less : Compare<"<", 226, "less">;
let title = "Comparison contact, not equal",
    description = "A contact that is ON while S1 differs from S2. Both are signed numbers of 16 bits, with D of 32. AND puts it "
                  "in series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the "
                  "top bit set is negative. C200 on stand in the D forms only. No flag changes." in
defm NotEqual : Compare<"<>", 228, "not_equal">;
let title = "Comparison contact, less or equal",
    description = "A contact that is ON while S1 is less than or equal to S2. Both are signed numbers of 16 bits, with D of 32. "
                  "AND puts it in series, OR in parallel. Digits that are narrower than the number count as positive; an H "
                  "constant with the top bit set is negative. C200 on stand in the D forms only. No flag changes." in
defm LessEqual : Compare<"<=", 229, "less_equal">;
let title = "Comparison contact, greater or equal",
    description = "A contact that is ON while S1 is greater than or equal to S2. Both are signed numbers of 16 bits, with D of "
                  "32. AND puts it in series, OR in parallel. Digits that are narrower than the number count as positive; an H "
                  "constant with the top bit set is negative. C200 on stand in the D forms only. No flag changes." in
defm GreaterEqual : Compare<">=", 230, "greater_equal">;
