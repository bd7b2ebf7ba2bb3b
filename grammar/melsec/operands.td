// Operand roles that MELSEC families share. The family's devices.td, included before, says which devices each role takes.

// Bits.
def ContactOperand : Operand<"S", "In", OpBit, ContactBits>;
def CoilOperand : Operand<"D", "Out", OpBit, CoilBits>;
def PulseOperand : Operand<"D", "Out", OpBit, PulseBits>;
def ToggleOperand : Operand<"D", "InOut", OpBit, PulseBits>;
def EdgeRelayOperand : Operand<"D", "InOut", OpBit, EdgeRelays> {
  let note = "remembers the result for this instruction; use each number once";
}
def AnnunciatorOperand : Operand<"D", "Out", OpAnnunciator, Annunciators>;
def MasterOperand : Operand<"D", "Out", OpBit, PulseBits> { let note = "not driven by any other instruction"; }
class LevelOperand<int levels> : Operand<"n", "In", OpLevel, Levels> { let max = !sub(levels, 1); }

// Timers and counters. The set value is read at each execution; what a negative one in a register does is not defined.
class TimerOperand<Classes timers> : Operand<"D", "Out", OpTimer, timers>;
class CounterOperand<Classes counters> : Operand<"D", "Out", OpCounter, counters>;
def SetValue : Operand<"set", "In", OpWord, PlainWords> {
  let decimal = 1;
  let max = 32767;
  let note = "set value; no H constant, and a register must not be negative";
}

// Words. OpWord is 16 bits, OpDWord 32; a constant has the range of the width.
class Source<string n, OperandType t> : Operand<n, "In", t, DataWords> { let decimal = 1; let hexadecimal = 1; }
class Target<string n, OperandType t> : Operand<n, "Out", t, DataWords>;
class Changed<string n, OperandType t> : Operand<n, "InOut", t, DataWords>;
def ResetWord : Operand<"D", "Out", OpWord, PlainWords>;

// Blocks: n words, or n groups of digits.
def SourceBlock : Operand<"S", "In", OpWordBlock, DataWords>;
def TargetBlock : Operand<"D", "Out", OpWordBlock, DataWords>;
def BlockLength : Operand<"n", "In", OpWord, DataWords> {
  let decimal = 1;
  let hexadecimal = 1;
  let max = 32767;
  let note = "0: nothing happens";
}

def PageNumber : Operand<"n", "In", OpNumber, NoDevices> { let decimal = 1; let max = 32767; }
