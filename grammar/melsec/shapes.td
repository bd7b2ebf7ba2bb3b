// The shapes in which MELSEC instructions come. A shape states once what the forms of an instruction have in common; the family's
// files say title, description, section, times and example.
//
// D in front of a mnemonic means 32 bits and calls the function with "d" in front; P behind it means that a rising edge of the
// condition is needed. Examples are whole programs: the shape adds END.

class Rung<string lines> { string text = lines # "\nEND"; }

// ---------------------------------------------------------------------------------------------- contacts
// LD, AND or OR with one bit.
class ContactForm<string m, Placement where, list<Time> t> : Instruction<m, m> {
  let category = "contact";
  let lowering = LowerContact;
  let placement = where;
  let operands = [ContactOperand];
  let times = t;
}

// One comparison as LD, AND and OR contact. `short` is the time of an AND or OR contact that the result so far has already decided.
class CompareForm<string connection, string width, string sign, Placement where, OperandType type, string fn>
    : Instruction<connection # width # sign, sign> {
  let aliases = [connection # width # " " # sign];
  let category = "comparison";
  let lowering = LowerCompareContact;
  let placement = where;
  let style = StyleValue;
  let function = fn;
  let operands = [Source<"S1", type>, Source<"S2", type>];
  let inputs = [0, 1];
  let steps = 3;
  let stepsPerConstant = !if(!eq(width, "D"), 1, 0);
}
multiclass Compare<string sign, string fn, int ns16, int short16, int ns32, int short32> {
  let times = [Time<ns16>], example = Rung<"LD" # sign # " D0 K10\nOUT Y0">.text in
  def LD : CompareForm<"LD", "", sign, AtStart, OpWord, fn>;
  let times = [Time<short16, "not executed">, Time<ns16, "executed">] in {
    let example = Rung<"LD X0\nAND" # sign # " D0 D1\nOUT Y0">.text in
    def AND : CompareForm<"AND", "", sign, AtSeries, OpWord, fn>;
    let example = Rung<"LD X0\nOR" # sign # " K4X10 H0F\nOUT Y0">.text in
    def OR : CompareForm<"OR", "", sign, AtParallel, OpWord, fn>;
  }
  let times = [Time<ns32>], example = Rung<"LDD" # sign # " D0 K100000\nOUT Y0">.text in
  def LDD : CompareForm<"LD", "D", sign, AtStart, OpDWord, fn>;
  let times = [Time<short32, "not executed">, Time<ns32, "executed">] in {
    let example = Rung<"LD X0\nANDD" # sign # " D0 D2\nOUT Y0">.text in
    def ANDD : CompareForm<"AND", "D", sign, AtSeries, OpDWord, fn>;
    let example = Rung<"LD X0\nORD" # sign # " K8X10 D2\nOUT Y0">.text in
    def ORD : CompareForm<"OR", "D", sign, AtParallel, OpDWord, fn>;
  }
}

// ---------------------------------------------------------------------------------------------- connections
// Works on the block stack, the branch stack or the running result; no operand.
class ConnectionForm<string m, Placement where, Lowering how, list<Time> t> : Instruction<m, m> {
  let category = "connection";
  let placement = where;
  let lowering = how;
  let times = t;
}

// ---------------------------------------------------------------------------------------------- outputs
class OutputForm<string f, string m, Lowering how, list<Operand> ops, list<Time> t> : Instruction<f, m> {
  let category = "output";
  let lowering = how;
  let operands = ops;
  let times = t;
}
// Executed with the result in each scan: timers and counters are driven, annunciators follow the result.
class DrivenForm<string f, string m, CallStyle how, string fn, list<Operand> ops, list<Time> t>
    : OutputForm<f, m, LowerCallWithResult, ops, t> {
  let drives = 1;
  let style = how;
  let function = fn;
  let outputs = [0];
}
class TimerForm<string f, string m, Classes timers, string fn, list<Time> t>
    : DrivenForm<f, m, StyleMethod, fn, [TimerOperand<timers>, SetValue], t> {
  let inputs = [1];
  let steps = 4;
}
// SET and RST of what is not a bit.
class ResetForm<string f, string m, CallStyle how, string fn, Operand op, int n, list<Time> t>
    : OutputForm<f, m, LowerCall, [op], t> {
  let execution = WhileOn;
  let style = how;
  let function = fn;
  let outputs = [0];
  let steps = n;
}

// ---------------------------------------------------------------------------------------------- words
// A function of words that acts while the condition is ON, or with P on its rising edge. `error` 0: cannot fail.
class WordForm<string f, string m, string fn, CallStyle how, int error, list<Operand> ops, list<int> reads, list<int> writes, int n,
               list<Time> t> : Instruction<f, m> {
  let execution = WhileOn;
  let style = how;
  let function = fn;
  let errorCode = error;
  let operands = ops;
  let inputs = reads;
  let outputs = writes;
  let steps = n;
  let times = t;
}
// The form and its P form. `args` are the operands of the example.
multiclass Pulsed<string f, string m, string fn, CallStyle how, int error, list<Operand> ops, list<int> reads, list<int> writes,
                  int n, list<Time> t, string args> {
  let example = Rung<"LD X0\n" # f # " " # args>.text in
  def "" : WordForm<f, m, fn, how, error, ops, reads, writes, n, t>;
  let execution = RisingEdge, example = Rung<"LD X0\n" # f # "P " # args>.text in
  def P : WordForm<f # "P", m, fn, how, error, ops, reads, writes, n, t>;
}

// How a calculation reports errors.
class Fails<CallStyle how, int c> { CallStyle style = how; int error = c; }
def NeverFails : Fails<StyleValue, 0>;
def FailsOnData : Fails<StyleStatus, 4100>;
def FailsOnRange : Fails<StyleStatus, 4101>;

// 16 and 32 bits: m S D (D := D op S) and m S1 S2 D (D := S1 op S2). `m16` and `m32` are the mnemonics of the widths ("+", "D+").
multiclass Accumulating<string m16, string m32, string fn, int ns16, int ns32> {
  defm "" : Pulsed<m16, m16, fn, StyleValue, 0, [Source<"S", OpWord>, Changed<"D", OpWord>], [1, 0], [1], 3,
                   [Time<ns16, "executed">], "D0 D10">;
  let stepsPerConstant = 1 in
  defm D : Pulsed<m32, m16, "d" # fn, StyleValue, 0, [Source<"S", OpDWord>, Changed<"D", OpDWord>], [1, 0], [1], 3,
                  [Time<ns32, "executed">], "D0 D10">;
}
multiclass Combining<string m16, string m32, string fn, int ns16, int ns32> {
  defm Three : Pulsed<m16, m16, fn, StyleValue, 0, [Source<"S1", OpWord>, Source<"S2", OpWord>, Target<"D", OpWord>], [0, 1], [2],
                      4, [Time<ns16, "executed">], "D0 K5 D10">;
  let stepsPerConstant = 1 in
  defm DThree : Pulsed<m32, m16, "d" # fn, StyleValue, 0, [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Target<"D", OpDWord>],
                       [0, 1], [2], 4, [Time<ns32, "executed">], "D0 K50000 D10">;
}
multiclass TwoAndThree<string m16, string m32, string fn, int two16, int three16, int two32, int three32> {
  defm "" : Accumulating<m16, m32, fn, two16, two32>;
  defm "" : Combining<m16, m32, fn, three16, three32>;
}

// m S1 S2 D with a destination that is wider than the sources.
multiclass Widening<string m, string fn, Fails f, OperandType result16, OperandType result32, list<Time> t16, list<Time> t32> {
  defm "" : Pulsed<m, m, fn, f.style, f.error, [Source<"S1", OpWord>, Source<"S2", OpWord>, Target<"D", result16>], [0, 1], [2], 4,
                   t16, "D0 K5 D10">;
  let stepsPerConstant = 1 in
  defm D : Pulsed<"D" # m, m, "d" # fn, f.style, f.error, [Source<"S1", OpDWord>, Source<"S2", OpDWord>, Target<"D", result32>],
                  [0, 1], [2], 4, t32, "D0 K50000 D10">;
}

// m D: changes its only operand.
multiclass InPlace<string m, string fn, int ns16, int ns32> {
  defm "" : Pulsed<m, m, fn, StyleValue, 0, [Changed<"D", OpWord>], [0], [0], 2, [Time<ns16>], "D0">;
  defm D : Pulsed<"D" # m, m, "d" # fn, StyleValue, 0, [Changed<"D", OpDWord>], [0], [0], 2, [Time<ns32>], "D0">;
}

// m S D: D := f(S). An empty `fn` is the plain assignment, for both widths. `subset`: steps of the 16-bit forms with quick
// operands.
multiclass Converting<string m, string fn, Fails f, int subset, list<Time> t16, list<Time> t32> {
  let stepsSubset = subset in
  defm "" : Pulsed<m, m, fn, f.style, f.error, [Source<"S", OpWord>, Target<"D", OpWord>], [0], [1], 3, t16, "D0 D10">;
  let stepsPerConstant = 1 in
  defm D : Pulsed<"D" # m, m, !if(!empty(fn), "", "d" # fn), f.style, f.error, [Source<"S", OpDWord>, Target<"D", OpDWord>], [0],
                  [1], 3, t32, "D0 D10">;
}
