// Operand roles of the TP03 instruction set. The family's devices.td, included before, says which devices each role takes.
//
// A name with a dot in the manual (S., D.) is indexable; roles are, unless the record says `let indexable = 0`.

// Bits.
class BitIn<string n = "S", Classes c = ReadBits> : Operand<n, "In", OpBit, c> { let indexable = 1; }
class BitOut<string n = "D", Classes c = WrittenBits> : Operand<n, "Out", OpBit, c> { let indexable = 1; }
class BitChanged<string n = "D", Classes c = WrittenBits> : Operand<n, "InOut", OpBit, c> { let indexable = 1; }
// `length` consecutive bits from the operand on; 0: as many as another operand says.
class BitsIn<string n, int length = 0, Classes c = ReadBits> : Operand<n, "In", OpBitRun, c> {
  let indexable = 1;
  let count = length;
}
class BitsOut<string n, int length = 0, Classes c = WrittenBits> : Operand<n, "InOut", OpBitRun, c> {
  let indexable = 1;
  let count = length;
}

// Words of 16 bits (OpWord) and 32 (OpDWord). Source takes constants, SourceDevice does not.
class SourceDevice<string n, OperandType t, Classes c = !if(!eq(t, OpWord), ReadWords, ReadPairs)> : Operand<n, "In", t, c> {
  let indexable = 1;
}
class Source<string n, OperandType t, Classes c = !if(!eq(t, OpWord), ReadWords, ReadPairs)> : SourceDevice<n, t, c> {
  let decimal = 1;
  let hexadecimal = 1;
}
class Target<string n, OperandType t, Classes c = !if(!eq(t, OpWord), WrittenWords, WrittenPairs)> : Operand<n, "Out", t, c> {
  let indexable = 1;
}
class Changed<string n, OperandType t, Classes c = !if(!eq(t, OpWord), WrittenWords, WrittenPairs)> : Operand<n, "InOut", t, c> {
  let indexable = 1;
}
// Single precision numbers in pairs of registers; a constant is converted.
class RealIn<string n, bit constants = 1> : Operand<n, "In", OpReal, Registers> {
  let indexable = 1;
  let decimal = constants;
  let hexadecimal = constants;
}
class RealOut<string n> : Operand<n, "Out", OpReal, Registers> { let indexable = 1; }

// Runs of words; `words` 0: as many as another operand says.
class BlockIn<string n, int words = 0, Classes c = ReadBlocks, OperandType t = OpWordBlock> : Operand<n, "In", t, c> {
  let indexable = 1;
  let count = words;
}
class BlockOut<string n, int words = 0, Classes c = WrittenBlocks, OperandType t = OpWordBlock> : Operand<n, "Out", t, c> {
  let indexable = 1;
  let count = words;
}
class BlockChanged<string n, int words = 0, Classes c = WrittenBlocks, OperandType t = OpWordBlock> : Operand<n, "InOut", t, c> {
  let indexable = 1;
  let count = words;
}

// A count or mode that only a constant gives.
class Constant<string n, int low, int high> : Operand<n, "In", OpWord, NoDevices> {
  let decimal = 1;
  let hexadecimal = 1;
  let min = low;
  let max = high;
}
// A constant that the instruction itself checks when it runs, because the manual makes a wrong one an operation error.
class CheckedConstant<string n> : Operand<n, "In", OpWord, NoDevices> {
  let decimal = 1;
  let hexadecimal = 1;
}
// A count that a constant or a data register gives.
class Count<string n> : Operand<n, "In", OpWord, Registers> {
  let decimal = 1;
  let hexadecimal = 1;
}

// Whole timers and counters.
class TimerOperand<string n, int from = 0, int to = 0> : Operand<n, "Out", OpTimer, TimerClass> {
  let first = from;
  let last = to;
}
class CounterOperand<string n> : Operand<n, "Out", OpCounter, CounterClass>;
class LongCounterOperand<string n, int from = 0, int to = 0> : Operand<n, "Out", OpLongCounter, LongCounterClass> {
  let first = from;
  let last = to;
}
