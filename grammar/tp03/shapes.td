// The shapes in which TP03 application instructions come: which of the forms m, mP, Dm, DmP exist, and how they are called.
//
// D in front means 32 bits and calls the function with "d" in front; P behind means that a rising edge of the condition is needed.
// Every function lies in the namespace ladder::tp03 (runtime/include/ladder/tp03/ops). Examples are whole programs: the shape adds
// END. Steps follow the rule of the manual (1, and 2 for a 16-bit operand, 4 for a 32-bit one) unless given.

class Rung<string lines> { string text = lines # "\nEND"; }

// How a function is called. `reads` are the operand indexes in the order of its parameters; what a Value call returns, or the outputs
// that other calls get as arguments behind the inputs, are `writes`. Blocks, bit runs and timers are passed once: where they are
// written they stand in both lists.
class Calling<CallStyle s, string f, list<int> reads, list<int> writes, int error, bit system> {
  CallStyle style = s;
  string function = f;
  list<int> inputs = reads;
  list<int> outputs = writes;
  int errorCode = error;
  bit passesSystem = system;
}
// D := f(inputs); cannot fail. An empty name is the plain assignment.
class Computes<string f, list<int> reads, list<int> writes> : Calling<StyleValue, f, reads, writes, 0, 0>;
// D := f(inputs, sys): sets flags.
class ComputesWithFlags<string f, list<int> reads, list<int> writes> : Calling<StyleValue, f, reads, writes, 0, 1>;
// Fault f(inputs, outputs, sys): may fail, and has then written nothing.
class MayFail<string f, list<int> reads, list<int> writes> : Calling<StyleStatus, f, reads, writes, 6706, 1>;
// void f(inputs, outputs, sys)
class Acts<string f, list<int> reads, list<int> writes> : Calling<StyleVoid, f, reads, writes, 0, 1>;
// An object of type f for each place: Fault f::run(condition, inputs, outputs, sys), called in every scan, ON and OFF.
class Keeps<string f, list<int> reads, list<int> writes> : Calling<StyleMemory, f, reads, writes, 6706, 1>;

// The D form calls another function than the 16-bit one.
class Wide<Calling c> : Calling<c.style, !if(!empty(c.function), "", !if(!eq(c.style, StyleMemory), "D" # c.function, "d" # c.function)),
                                c.inputs, c.outputs, c.errorCode, c.passesSystem>;

class AppForm<string f, string m, int n, Execution when, Calling c, list<Operand> ops, int s, string args> : Instruction<f, m> {
  let number = n;
  let execution = when;
  let lowering = !if(!eq(c.style, StyleMemory), LowerCallWithResult, LowerCall);
  let style = c.style;
  let function = c.function;
  let inputs = c.inputs;
  let outputs = c.outputs;
  let errorCode = c.errorCode;
  let passesSystem = c.passesSystem;
  let operands = ops;
  let steps = s;
  let example = Rung<"LD X0\n" # f # !if(!empty(args), "", " " # args)>.text;
}

// m and mP.
multiclass Pulsed<string m, int n, Calling c, list<Operand> ops, int s, string args> {
  def "" : AppForm<m, m, n, WhileOn, c, ops, s, args>;
  def P : AppForm<m # "P", m, n, RisingEdge, c, ops, s, args>;
}
// Dm and DmP only: `m` is the mnemonic without its D.
multiclass PulsedWide<string m, int n, Calling c, list<Operand> ops, int s, string args> {
  let wide = 1 in {
    def D : AppForm<"D" # m, m, n, WhileOn, c, ops, s, args>;
    def DP : AppForm<"D" # m # "P", m, n, RisingEdge, c, ops, s, args>;
  }
}
// m, mP, Dm, DmP.
multiclass PulsedBoth<string m, int n, Calling c, list<Operand> ops16, list<Operand> ops32, int s16, int s32, string args16,
                      string args32> {
  defm "" : Pulsed<m, n, c, ops16, s16, args16>;
  defm "" : PulsedWide<m, n, Wide<c>, ops32, s32, args32>;
}
// m only; Dm only; m and Dm: instructions without a P form.
multiclass Plain<string m, int n, Calling c, list<Operand> ops, int s, string args> {
  def "" : AppForm<m, m, n, !if(!eq(c.style, StyleMemory), EveryScan, WhileOn), c, ops, s, args>;
}
multiclass PlainWide<string m, int n, Calling c, list<Operand> ops, int s, string args> {
  let wide = 1 in
  def D : AppForm<"D" # m, m, n, !if(!eq(c.style, StyleMemory), EveryScan, WhileOn), c, ops, s, args>;
}
multiclass PlainBoth<string m, int n, Calling c, list<Operand> ops16, list<Operand> ops32, int s16, int s32, string args16,
                     string args32> {
  defm "" : Plain<m, n, c, ops16, s16, args16>;
  defm "" : PlainWide<m, n, Wide<c>, ops32, s32, args32>;
}
