// Outputs, timers, counters, annunciators, master control and what stands between rungs.

def OUT : OutputForm<"OUT", "OUT", LowerStore, [CoilOperand], [Time<100, "", "Y">, Time<200, "", "D0.0">]> {
  let drives = 1;
  let section = "5.3.1";
  let title = "Output a bit";
  let description = "Writes the result to D in every scan, ON or OFF. Where several OUT of one scan drive the same device, the one "
                    "executed last decides. Timers, counters and annunciators have OUT forms of their own.";
  let example = Rung<"LD X0\nOUT Y10">.text;
}

// ---------------------------------------------------------------------------------------------- timers
defvar Driven = [Time<550, "not executed">, Time<550, "executed, after time-up/count-up">,
                 Time<550, "executed, counting, set value K", "K">, Time<600, "executed, counting, set value D", "D">];

let section = "5.3.2" in {
let title = "Low-speed timer",
    description = "While the result is ON, the current value grows by the ticks that the last scan took; when it reaches the set "
                  "value, the contact closes and the value stands still. The tick is the low-speed unit of the parameters (1 to "
                  "1000 ms, default 100 ms). A set value of 0 closes the contact at once. Result OFF clears a T; an ST keeps value "
                  "and contact until RST. Everything changes when the instruction is executed, not between." in {
def OUT_T : TimerForm<"OUT T", "OUT T", PlainTimers, "on_delay_low", Driven> {
  let example = Rung<"LD X0\nOUT T0 K50\nLD T0\nOUT Y10">.text;
}
def OUT_ST : TimerForm<"OUT ST", "OUT T", RetentiveTimers, "retentive_low", Driven> {
  let example = Rung<"LD X0\nOUT ST0 K50\nLD ST0\nOUT Y10\nLD X1\nRST ST0">.text;
}
}
let title = "High-speed timer",
    description = "As OUT T and OUT ST, but the tick is the high-speed unit of the parameters (0.1 to 100 ms, default 10 ms). One "
                  "timer number is driven either by OUT or by OUTH." in {
def OUTH_T : TimerForm<"OUTH T", "OUTH T", PlainTimers, "on_delay_high", Driven> {
  let example = Rung<"LD X0\nOUTH T1 K25\nLD T1\nOUT Y10">.text;
}
def OUTH_ST : TimerForm<"OUTH ST", "OUTH T", RetentiveTimers, "retentive_high", Driven> {
  let example = Rung<"LD X0\nOUTH ST1 K25\nLD ST1\nOUT Y10\nLD X1\nRST ST1">.text;
}
}
}

def OUT_C : DrivenForm<"OUT C", "OUT C", StyleMethod, "count_up", [CounterOperand<AllCounters>, SetValue], Driven> {
  let inputs = [1];
  let steps = 4;
  let section = "5.3.3";
  let title = "Counter";
  let description = "Counts one when the result turns ON; the counter's coil is the memory of that edge. When the current value "
                    "reaches the set value, the contact closes and value and contact stand still until RST. A set value of 0 acts "
                    "as 1. Result OFF switches the coil OFF only.";
  let example = Rung<"LD X0\nOUT C0 K10\nLD C0\nOUT Y10\nLD X1\nRST C0">.text;
}

// ---------------------------------------------------------------------------------------------- annunciators
def OUT_F : DrivenForm<"OUT F", "OUT F", StyleSystem, "annunciator_out", [AnnunciatorOperand],
                       [Time<18000, "OFF">, Time<370000, "ON, when displayed">, Time<240000, "ON, display completed">]> {
  let steps = 2;
  let section = "5.3.4";
  let title = "Output an annunciator";
  let description = "Writes the result to D in every scan. When D turns ON, its number is entered in SD64-SD79 (at most 16; a "
                    "number stands there once), SD63 counts the entries, SD62 shows the first, SM62 turns ON, the USER LED lights "
                    "and 9000 is reported; the CPU goes on. Turning D OFF with OUT changes the bit only: RST F takes the entry "
                    "out.";
  let errors = ["9000: D turned ON; the CPU goes on"];
  let example = Rung<"LD X0\nOUT F7">.text;
}

let section = "5.3.7", execution = RisingEdge, steps = 2, outputs = [0], style = StyleSystem in {
def SET_F : OutputForm<"SET F", "SET F", LowerCall, [AnnunciatorOperand],
                       [Time<250, "not executed">, Time<365000, "executed, when displayed">,
                        Time<235000, "executed, display completed">]> {
  let function = "annunciator_set";
  let title = "Set an annunciator";
  let description = "When the result turns ON, D becomes ON and is entered as OUT F does it.";
  let errors = ["9000: D turned ON; the CPU goes on"];
  let example = Rung<"LD X0\nSET F7">.text;
}
def RST_F : OutputForm<"RST F", "RST F", LowerCall, [AnnunciatorOperand],
                       [Time<250, "not executed">, Time<115000, "executed, when displayed">,
                        Time<87000, "executed, display completed">]> {
  let function = "annunciator_reset";
  let title = "Reset an annunciator";
  let description = "When the result turns ON, D becomes OFF and its number leaves SD64-SD79; the numbers behind it move up. Where "
                    "all 16 places were taken, an annunciator that is ON without an entry gets the free one. With the last entry "
                    "SM62 turns OFF and the USER LED goes out.";
  let example = Rung<"LD X0\nSET F7\nLD X1\nRST F7">.text;
}
}

// ---------------------------------------------------------------------------------------------- set, reset, pulses
def SET : OutputForm<"SET", "SET", LowerSet, [CoilOperand], [Time<100, "", "Y">, Time<200, "", "D0.0">]> {
  let execution = WhileOn;
  let section = "5.3.5";
  let title = "Set a bit";
  let description = "While the result is ON, D becomes ON; it stays ON until it is reset or written. Result OFF does nothing.";
  let example = Rung<"LD X0\nSET M0\nLD X1\nRST M0">.text;
}

let section = "5.3.6", title = "Reset a device",
    description = "While the result is ON, a bit becomes OFF; a timer or counter loses contact, coil and current value; a word "
                  "becomes 0. Result OFF does nothing." in {
def RST_bit : OutputForm<"RST", "RST", LowerReset, [CoilOperand],
                         [Time<100, "", "Y">, Time<200, "", "D0.0">, Time<100, "", "SM">]> {
  let execution = WhileOn;
  let example = Rung<"LD X0\nSET M0\nLD X1\nRST M0">.text;
}
defvar ResetTimes = [Time<400, "not executed", "T,C">, Time<500, "executed", "T,C">];
def RST_timer : ResetForm<"RST", "RST", StyleMethod, "reset", TimerOperand<AllTimers>, 4, ResetTimes> {
  let example = Rung<"LD X0\nOUT T0 K50\nLD T0\nOUT Y10\nLD X1\nRST T0">.text;
}
def RST_counter : ResetForm<"RST", "RST", StyleMethod, "reset", CounterOperand<AllCounters>, 4, ResetTimes> {
  let example = Rung<"LD X0\nOUT C0 K10\nLD C0\nOUT Y10\nLD X1\nRST C0">.text;
}
def RST_word : ResetForm<"RST", "RST", StyleValue, "", ResetWord, 2,
                         [Time<200, "not executed", "D">, Time<300, "executed", "D">]> {
  let example = Rung<"LD X0\nRST D8">.text;
}
}

let section = "5.3.8", drives = 1, steps = 2 in {
def PLS : OutputForm<"PLS", "PLS", LowerPulseStore, [PulseOperand], [Time<7100>]> {
  let edge = RisingEdge;
  let title = "Output a pulse on the rising edge";
  let description = "Writes ON to D in the scan in which the result turned ON and OFF in every other scan. The instruction's own "
                    "memory is OFF at power-on and survives STOP: a result that is ON in the first scan gives a pulse, one that "
                    "stays ON over STOP and RUN gives none. A second PLS or PLF of D in the same scan can cut the pulse short.";
  let example = Rung<"LD X0\nPLS M9">.text;
}
def PLF : OutputForm<"PLF", "PLF", LowerPulseStore, [PulseOperand], [Time<7100>]> {
  let edge = FallingEdge;
  let title = "Output a pulse on the falling edge";
  let description = "Writes ON to D in the scan in which the result turned OFF and OFF in every other scan. There is none in the "
                    "first scan.";
  let example = Rung<"LD X0\nPLF M9">.text;
}
}

def FF : OutputForm<"FF", "FF", LowerToggle, [ToggleOperand], [Time<250, "not executed", "Y">, Time<4900, "executed", "Y">]> {
  let execution = RisingEdge;
  let edge = RisingEdge;
  let steps = 2;
  let section = "5.3.9";
  let title = "Invert a bit";
  let description = "When the result turns ON, D changes its state. Each occurrence has a memory of its own.";
  let example = Rung<"LD X0\nFF Y10">.text;
}

// ---------------------------------------------------------------------------------------------- master control
let category = "master", section = "5.4.1", example = Rung<"LD X0\nMC N0 M100\nLD X1\nOUT Y10\nMCR N0">.text in {
// Drives operand 1: the level is operand 0.
def MC : Instruction<"MC", "MC"> {
  let lowering = LowerMasterControl;
  let drives = 1;
  let operands = [LevelOperand<15>, MasterOperand];
  let steps = 2;
  let times = [Time<200, "", "M0">, Time<300, "", "D0.0">];
  let title = "Begin a master control region";
  let description = "Writes the result to D and begins the region of level n, which MCR n ends. While the result is OFF, the "
                    "instructions of the region are executed with their condition OFF: outputs are OFF, timers cleared, retentive "
                    "timers and counters keep value and contact, what SET, RST and the word instructions wrote stays. Regions nest "
                    "from N0 upwards; a level may be used again, with another D, when its region has ended.";
}
def MCR : Instruction<"MCR", "MCR"> {
  let lowering = LowerMasterControlReset;
  let placement = AtAlone;
  let operands = [LevelOperand<15>];
  let times = [Time<100>];
  let title = "End a master control region";
  let description = "Ends the region of level n and all deeper ones. Not conditional: no contact stands before it.";
}
}

// ---------------------------------------------------------------------------------------------- no operation, end
let lowering = LowerNothing, placement = AtAnywhere, section = "5.6.1", category = "other", times = [Time<100>] in {
def NOP : Instruction<"NOP", "NOP"> {
  let title = "No operation";
  let description = "Takes a step and does nothing; the result is kept.";
  let example = Rung<"LD X0\nNOP\nOUT Y10">.text;
}
def NOPLF : Instruction<"NOPLF", "NOPLF"> {
  let placement = AtBetweenRungs;
  let title = "No operation, page break in print-outs";
  let description = "Takes a step and does nothing; the engineering tool begins a new page there. Stands between rungs.";
  let example = Rung<"LD X0\nOUT Y10\nNOPLF\nLD X1\nOUT Y11">.text;
}
def PAGE : Instruction<"PAGE", "PAGE"> {
  let operands = [PageNumber];
  let title = "No operation, page number";
  let description = "Takes a step and does nothing; marks that page n begins.";
  let example = Rung<"LD X0\nOUT Y10\nNOPLF\nPAGE K1\nLD X1\nOUT Y11">.text;
}
}

let category = "termination" in {
def END : Instruction<"END", "END"> {
  let lowering = LowerEnd;
  let placement = AtEnd;
  let section = "5.5.1";
  let times = [Time<8200000, "with error check">];
  let title = "End of the program";
  let description = "Ends the scan: outputs and inputs are refreshed, peripherals served, and the next scan begins at step 0. The "
                    "last instruction of every program.";
  let errors = ["4010: the program has no END; the CPU does not go to RUN"];
  let example = Rung<"LD X0\nOUT Y10">.text;
}
def QSABORT : Instruction<"S.QSABORT", "S.QSABORT"> {
  let execution = WhileOn;
  let style = StyleSystem;
  let function = "abort";
  let stopsScan = 1;
  let operands = [Source<"S", OpWord>];
  let inputs = [0];
  let steps = 7;
  let stepsPerConstant = 1;
  let section = "8.1";
  let times = [Time<344000, "executed">, Time<34000, "not executed">];
  let title = "Forced stop of the controller";
  let description = "While the result is ON, the program stops at once and the CPU enters the stop error 4700: SD0 = 4700, SM0 is "
                    "ON while SM1 stays OFF, SD4 = H0B04, SD5-SD15 tell program and step, SD16 is the abort code S.";
  let errors = ["4700: executed; the CPU stops"];
  let example = Rung<"LD X0\nS.QSABORT K1234">.text;
}
}
