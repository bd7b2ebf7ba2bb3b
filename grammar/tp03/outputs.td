// Coils, timers, counters, set and reset, pulses.

class OutputForm<string m, Lowering how, list<Operand> ops, int s = 1> : Instruction<m, m> {
  let category = "output";
  let lowering = how;
  let operands = ops;
  let steps = s;
}
class CoilOperand<Classes c> : Operand<"D", "Out", OpBit, c>;
def LevelOperand : Operand<"N", "In", OpLevel, Levels> { let max = 7; }
def SpecialRelays : Classes<[DevMS]>;
def PlainCoils : Classes<[DevY, DevM]>;

// ---------------------------------------------------------------------------------------------- OUT of bits
let section = "3.2" in {
let title = "Output a bit", drives = 1,
    description = "Writes the result to D in every execution, ON or OFF. Several OUT on one device are legal: the one executed last in "
                  "the scan decides, contacts in between see what they find." in {
def OUT : OutputForm<"OUT", LowerStore, [CoilOperand<PlainCoils>]> { let example = Rung<"LD X0\nOUT Y0">.text; }
def OUT_special : OutputForm<"OUT", LowerStore, [CoilOperand<SpecialRelays>], 2> {
  let example = Rung<"LD X0\nOUT M8034">.text;
}
}
def OUT_S : OutputForm<"OUT", LowerTransfer, [CoilOperand<StepBits>], 2> {
  let transferOutside = LowerStore;
  let title = "Go to a separate state, or output a step relay";
  let description = "Inside a state: a transfer as SET, for targets that do not follow directly (jumps, repeats, other flows). The target "
                    "holds itself; OFF does nothing. Outside of states: writes the result to D as for any relay.";
  let example = Rung<"LD X0\nOUT S20">.text;
}
def OUTI : OutputForm<"OUTI", LowerStoreInverted, [CoilOperand<PlainCoils>]> {
  let aliases = ["OUT I", "OUT NOT"];
  let drives = 1;
  let title = "Output a bit inverted";
  let description = "D becomes the inverse of the result. Where MC, SMCS or a state has switched the bus off, D is OFF.";
  let example = Rung<"LD X0\nOUTI Y0">.text;
}
}

// ---------------------------------------------------------------------------------------------- timers and counters
class SetValue<OperandType t, Classes c = Registers> : Operand<"set", "In", t, c> {
  let decimal = 1;
  let hexadecimal = 1;
  let max = !if(!eq(t, OpWord), 32767, 0);
}
class DrivenForm<string f, CallStyle how, string fn, list<Operand> ops, int s> : Instruction<f, f> {
  let category = "output";
  let lowering = LowerCallWithResult;
  let operands = ops;
  let steps = s;
  let drives = 1;
  let style = how;
  let function = fn;
  let inputs = [1];
  let outputs = [0];
}
class TimerForm<int from, int to, string fn> : DrivenForm<"OUT", StyleMethod, fn, [TimerOperand<"D", from, to>, SetValue<OpWord>], 3> {
  let section = "2.6";
  let example = Rung<"LD X0\nOUT T" # from # " K50\nLD T" # from # "\nOUT Y0">.text;
}
let title = "On-delay timer",
    description = "While the result is ON the timer measures the time since the execution that found it ON first; where its coil is "
                  "executed, the current value becomes the whole units, and the contact closes at the set value. OFF clears value and "
                  "contact. Skipped, the timer stands still; T192-T199 (SR: T196-T199), made for routines, then go on at END. A set "
                  "value of 0 or, in a register, below, closes the contact in the second execution." in {
def OUT_T100 : TimerForm<0, 199, "on_delay_100ms">;
def OUT_T10 : TimerForm<200, 245, "on_delay_10ms">;
def OUT_T1 : TimerForm<256, 511, "on_delay_1ms">;
}
let title = "Accumulating timer",
    description = "As an on-delay timer, but OFF holds value and contact; RST clears them. T246-T249 count 1 ms in the background, also "
                  "where their coil is skipped, and switch where it is executed; T250-T255 count 100 ms. Kept over power-off." in {
def OUT_T1acc : TimerForm<246, 249, "accumulate_1ms">;
def OUT_T100acc : TimerForm<250, 255, "accumulate_100ms">;
}
let section = "2.7, 3.13" in {
def OUT_C : DrivenForm<"OUT", StyleMethod, "count_up", [CounterOperand<"D">, SetValue<OpWord>], 3> {
  let edge = RisingEdge;
  let title = "Counter";
  let description = "Counts one when the result turns ON, while RST does not hold the counter. At the set value the contact closes and the "
                    "value stands still. A set value of 0 acts as 1. A value that was written above the set value becomes the set value "
                    "with the next pulse, which closes the contact.";
  let example = Rung<"LD X0\nOUT C0 K10\nLD C0\nOUT Y0\nLD X1\nRST C0">.text;
}
def OUT_CL : DrivenForm<"OUT", StyleSystem, "count", [LongCounterOperand<"D", 200, 234>, SetValue<OpDWord>], 5> {
  let edge = RisingEdge;
  let title = "32-bit counter";
  let description = "Counts one up when the result turns ON, or down while the direction relay M8200-M8234 is ON; the value is a ring. The "
                    "contact closes in the step up to the set value and opens in the step down from it; elsewhere it stays.";
  let example = Rung<"LD X0\nOUT C200 K-5\nLD C200\nOUT Y0\nLD X1\nRST C200">.text;
}
}
let section = "2.8", category = "high-speed" in
def OUT_HSC : DrivenForm<"OUT", StyleSystem, "enable_high_speed", [LongCounterOperand<"D", 235, 255>, SetValue<OpDWord>], 5> {
  let title = "High-speed counter";
  let description = "While ON, pulses of the counter's own inputs count at once, independent of the scan. Direction relays M8235-M8245 for "
                    "counters with one input. The contact closes at the set value on the way up and opens below it.";
  let example = Rung<"LD X10\nOUT C235 K100\nLD C235\nOUT Y0">.text;
}

// ---------------------------------------------------------------------------------------------- SET, RST, PLS, PLF
let section = "3.12", execution = WhileOn in {
let title = "Set a bit", description = "While the result is ON, D becomes ON; it stays ON until it is reset or written." in {
def SET : OutputForm<"SET", LowerSet, [CoilOperand<PlainCoils>]> { let example = Rung<"LD X0\nSET M0\nLD X1\nRST M0">.text; }
def SET_special : OutputForm<"SET", LowerSet, [CoilOperand<SpecialRelays>], 2> { let example = Rung<"LD X0\nSET M8034">.text; }
}
def SET_S : OutputForm<"SET", LowerTransfer, [CoilOperand<StepBits>], 2> {
  let transferOutside = LowerSet;
  let title = "Go to the next state, or set a step relay";
  let description = "Inside a state, with the result ON: the state D becomes ON at once, and the state that contains the instruction (all of "
                    "them behind several STL in succession) goes OFF at the end of the scan, so that both are ON together for one scan. "
                    "M8040 ON inhibits it. Outside of states, or on the state itself: sets D.";
  let example = Rung<"LD M8002\nSET S0\nSTL S0\nLD X0\nSET S20\nSTL S20\nOUT Y0\nRET">.text;
}
let title = "Reset a bit", description = "While the result is ON, D becomes OFF. RST S clears that state only, it is no transfer." in {
def RST : OutputForm<"RST", LowerReset, [CoilOperand<PlainCoils>]> { let example = Rung<"LD X0\nSET M0\nLD X1\nRST M0">.text; }
def RST_special : OutputForm<"RST", LowerReset, [CoilOperand<Classes<[DevMS, DevS]>>], 2> {
  let example = Rung<"LD X0\nRST M8034">.text;
}
}
def RST_T : OutputForm<"RST", LowerCall, [TimerOperand<"D">], 2> {
  let style = StyleMethod;
  let function = "reset";
  let outputs = [0];
  let title = "Reset a timer";
  let description = "While the result is ON, current value and contact are cleared.";
  let example = Rung<"LD X0\nOUT T250 K50\nLD T250\nOUT Y0\nLD X1\nRST T250">.text;
}
def RST_word : OutputForm<"RST", LowerCall, [Operand<"D", "Out", OpWord, RegistersOrIndex>], 3> {
  let style = StyleValue;
  let outputs = [0];
  let title = "Clear a register";
  let description = "While the result is ON, D becomes 0.";
  let example = Rung<"LD X0\nRST D8">.text;
}
}
let section = "3.13", title = "Reset a counter",
    description = "Drives the reset coil with the result: while it is ON, value and contact are cleared and pulses do not count. Where the "
                  "instruction is skipped, the reset coil keeps its state." in {
def RST_C : OutputForm<"RST", LowerCallWithResult, [CounterOperand<"D">], 2> {
  let style = StyleMethod;
  let function = "drive_reset";
  let outputs = [0];
  let example = Rung<"LD X0\nOUT C0 K10\nLD C0\nOUT Y0\nLD X1\nRST C0">.text;
}
def RST_CL : OutputForm<"RST", LowerCallWithResult, [LongCounterOperand<"D">], 2> {
  let style = StyleMethod;
  let function = "drive_reset";
  let outputs = [0];
  let example = Rung<"LD X0\nOUT C200 K10\nLD C200\nOUT Y0\nLD X1\nRST C200">.text;
}
}
let section = "3.11", drives = 1 in {
def PLS : OutputForm<"PLS", LowerPulseStore, [CoilOperand<PulseBits>]> {
  let edge = RisingEdge;
  let title = "Rising edge as a relay";
  let description = "D is ON from the execution that finds the result newly ON to the next one.";
  let example = Rung<"LD X0\nPLS M0\nLD M0\nSET Y0">.text;
}
def PLF : OutputForm<"PLF", LowerPulseStore, [CoilOperand<PulseBits>]> {
  let edge = FallingEdge;
  let title = "Falling edge as a relay";
  let description = "D is ON from the execution that finds the result newly OFF to the next one. A master control that goes OFF makes a "
                    "falling edge.";
  let example = Rung<"LD X0\nPLF M0\nLD M0\nSET Y0">.text;
}
}

// ---------------------------------------------------------------------------------------------- buses
let section = "3.9" in {
def MC : Instruction<"MC", "MC"> {
  let category = "master";
  let lowering = LowerMasterControl;
  let operands = [LevelOperand, CoilOperand<PulseBits>];
  let steps = 3;
  let title = "Master control";
  let description = "D becomes the result, and up to MCR of the level everything acts on its condition and D together. OFF: coils OFF, timers "
                    "cleared except accumulating ones, counters and what SET and RST drive keep their state, application instructions are "
                    "not executed. Levels ascend inwards from N0 to N7.";
  let example = Rung<"LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0">.text;
}
def MCR : Instruction<"MCR", "MCR"> {
  let category = "master";
  let placement = AtAlone;
  let lowering = LowerMasterControlReset;
  let operands = [LevelOperand];
  let steps = 2;
  let title = "End of master control";
  let description = "Ends the level and all levels inside it.";
  let example = Rung<"LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0">.text;
}
}
let section = "3.15", category = "master" in {
def SMCS : Instruction<"SMCS", "SMCS"> {
  let lowering = LowerBusStart;
  let title = "Common condition";
  let description = "Up to SMCR everything acts on its condition and the result here together; further SMCS add their conditions. OFF acts as "
                    "for MC. A contact stands directly behind it.";
  let example = Rung<"LD X0\nSMCS\nLD X1\nOUT Y0\nSMCR">.text;
}
def SMCR : Instruction<"SMCR", "SMCR"> {
  let placement = AtAlone;
  let lowering = LowerBusEnd;
  let title = "End of the common conditions";
  let description = "Ends all SMCS.";
  let example = Rung<"LD X0\nSMCS\nLD X1\nOUT Y0\nSMCR">.text;
}
}
let section = "3.14" in {
def NOP : Instruction<"NOP", "NOP"> {
  let placement = AtAnywhere;
  let lowering = LowerNothing;
  let title = "No operation";
  let description = "Does nothing; may stand anywhere.";
  let example = Rung<"LD X0\nNOP\nOUT Y0">.text;
}
def END : Instruction<"END", "END"> {
  let category = "termination";
  let placement = AtEnd;
  let lowering = LowerEnd;
  let title = "End of the program";
  let description = "Ends the scan. The first END of a list is its end.";
  let example = Rung<"LD X0\nOUT Y0">.text;
}
}
