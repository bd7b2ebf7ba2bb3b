// The classes that instruction tables are made of. compiler/tables/tables.h says what each field means; grammar/README.md shows how
// to add a record. A family's tables are grammar/<family>.td and the files that it includes.

// ---------------------------------------------------------------------------------------------- families and devices
class Model<string n> { string name = n; }

class DeviceKind<string n> { string cpp = n; }
def Bit : DeviceKind<"Bit">;
def Word : DeviceKind<"Word">;
def TimerDevice : DeviceKind<"Timer">;
def CounterDevice : DeviceKind<"Counter">;
def LongCounterDevice : DeviceKind<"LongCounter">;
def Nesting : DeviceKind<"Nesting">;
def LabelDevice : DeviceKind<"Label">;
def IndexDevice : DeviceKind<"Index">;

class Points<string m, int n> { string model = m; int points = n; }
// Numbers first to last, inclusive, on a model; "" is all models.
class Numbers<int f, int l, string m = ""> { string model = m; int first = f; int last = l; }

// Inputs (bit n: the n-th terminal) that numbers first to last have for themselves.
class Terminals<int f, int l, int mask> { int first = f; int last = l; int inputs = mask; }

// One device class: prefix as written, radix of the number, default points.
class Device<string p, string t, DeviceKind k, int r, int n> {
  string prefix = p;
  string title = t;
  DeviceKind kind = k;
  int radix = r;
  int points = n;
  list<Points> modelPoints = [];
  bit bitOfWord = 0;
  bit externalInput = 0;
  bit externalOutput = 0;
  int memoryOrder = 0;
  string image = p;
  int pointsRegister = -1;
  string container = "";       // runtime class template of the image, without ladder::
  string beginHook = "";       // function of System that gets the image before the program
  string endHook = "";         // ... and behind it
  bit survivesStop = 0;        // cleared at power-off only, where the family clears others when it stops
  int watched = 0;             // so many of them act between the scans, too
  int first = 0;               // lowest number; points counts from there
  int nameDigits = 1;          // names have at least so many digits
  string highWords = "";       // prefix of the class that holds the high words of pairs: "V" of Z
  list<Numbers> missing = [];  // numbers that do not exist
  list<Numbers> latched = [];  // kept over power-off and STOP unless the parameters say otherwise
  list<Numbers> exclusive = [];    // of each such run a program may use one number
  list<Terminals> terminals = [];  // of the numbers that a program drives or places
  string behaviour = "";
  string section = "";
}

class Special<string d, string n, string b, bit w, bit s, string sec> {
  string device = d;
  string name = n;
  string behaviour = b;
  bit writable = w;
  bit simulated = s;
  int constant = -1;        // 0 or 1: a relay that the system holds at that state in every scan
  string section = sec;
}

class ErrorCode<int c, string n, string why, string what, bit s, string sec> {
  int number = c;
  string name = n;
  string cause = why;
  string action = what;
  bit stops = s;
  string section = sec;
}

// ---------------------------------------------------------------------------------------------- operands
class OperandType<string n> { string cpp = n; }
def OpBit : OperandType<"Bit">;
def OpWord : OperandType<"Word">;
def OpDWord : OperandType<"DWord">;
def OpQWord : OperandType<"QWord">;
def OpWordTwice : OperandType<"WordTwice">;
def OpDWordTwice : OperandType<"DWordTwice">;
def OpWordBlock : OperandType<"WordBlock">;
def OpTimer : OperandType<"Timer">;
def OpCounter : OperandType<"Counter">;
def OpAnnunciator : OperandType<"Annunciator">;
def OpLevel : OperandType<"Level">;
def OpNumber : OperandType<"Number">;
def OpLabel : OperandType<"Label">;
def OpReal : OperandType<"Real">;
def OpDWordBlock : OperandType<"DWordBlock">;
def OpBitRun : OperandType<"BitRun">;
def OpBitTarget : OperandType<"BitTarget">;
def OpLongCounter : OperandType<"LongCounter">;
def OpString : OperandType<"String">;

// Which devices may stand in an operand position: as they are, by a bit (D0.5), by digits (K4X0).
class Classes<list<Device> plain, list<Device> bitsOf = [], list<Device> digitsOf = []> {
  list<Device> devices = plain;
  list<Device> wordBits = bitsOf;
  list<Device> digits = digitsOf;
}

class Operand<string n, string dir, OperandType t, Classes c> {
  string name = n;
  string direction = dir;   // "In", "Out", "InOut"
  OperandType type = t;
  Classes classes = c;
  bit decimal = 0;
  bit hexadecimal = 0;
  int min = 0;              // of a constant, as a signed number; both 0: the range of the type. H constants must fit the width,
  int max = 0;              // then count as the signed number of that bit pattern. Of a level: its first and last number
  string note = "";
  bit indexable = 0;        // D20V0, K30V0, P0Z0
  int first = 0;            // only device numbers first to last fit; both 0: all
  int last = 0;
  int count = 0;            // of a block or bit run whose length is fixed
}

// ---------------------------------------------------------------------------------------------- instructions
class Execution<string n> { string cpp = n; }
def EveryScan : Execution<"EveryScan">;
def WhileOn : Execution<"WhileOn">;
def RisingEdge : Execution<"RisingEdge">;
def FallingEdge : Execution<"FallingEdge">;

class Placement<string n> { string cpp = n; }
foreach p = ["Start", "Series", "Parallel", "JoinBlocks", "PushBranch", "ReadBranch", "PopBranch", "Output", "Alone", "Anywhere",
             "BetweenRungs", "End", "Label"] in
def At # p : Placement<p>;

class Lowering<string n> { string cpp = n; }
foreach l = ["Contact", "CompareContact", "AndBlock", "OrBlock", "PushBranch", "ReadBranch", "PopBranch", "Invert", "EdgeOfResult",
             "EdgeRelay", "Store", "Set", "Reset", "PulseStore", "Toggle", "MasterControl", "MasterControlReset", "Call",
             "CallWithResult", "Nothing", "End", "StoreInverted", "Label", "InterruptLabel", "Jump", "CallRoutine", "Return",
             "InterruptReturn", "MainEnd", "Loop", "LoopEnd", "Skip", "SkipEnd", "BusStart", "BusEnd", "State", "StateEnd",
             "Transfer"] in
def Lower # l : Lowering<l>;

class CallStyle<string n> { string cpp = n; }
foreach s = ["None", "Value", "Status", "Void", "Method", "System", "Memory"] in
def Style # s : CallStyle<s>;

class Time<int ns, string when = "", string dev = ""> { int nanoseconds = ns; string condition = when; string device = dev; }

// One form with one operand list. `f` is the form as the manual's tables name it; the spelling is its first word.
//
// Calls: `inputs` are operand indexes in the order of the function's parameters, `outputs` those that the function writes. An
// OpWordBlock is passed once, as a block: where it is written it stands in `inputs` at the place of its parameter and in `outputs`
// too, so that everybody who asks what an instruction writes looks at `outputs` only (FMOV S D n: inputs [0, 1, 2], outputs [1]).
// An InOut operand stands in both lists.
class Instruction<string f, string m> {
  string form = f;
  string spelling = !if(!lt(!find(f, " "), 0), f, !substr(f, 0, !find(f, " ")));
  string mnemonic = m;
  list<string> aliases = [];
  string title = "";
  string description = "";
  string category = "other";
  string section = "";
  string example = "";
  list<string> models = [];
  list<Operand> operands = [];
  Execution execution = EveryScan;
  Placement placement = AtOutput;
  Lowering lowering = LowerCall;
  bit negated = 0;
  bit drives = 0;
  Execution edge = EveryScan;
  CallStyle style = StyleNone;
  string function = "";
  list<int> inputs = [];
  list<int> outputs = [];
  bit stopsScan = 0;
  int errorCode = 0;
  string errorMask = "";
  list<string> errors = [];   // "4100: the divisor is 0", for the documentation
  int steps = 1;
  int stepsPerConstant = 0;   // for each K or H operand
  int stepsSubset = 0;        // where every operand qualifies for subset processing; 0: as steps
  bit equalDigits = 0;
  list<Time> times = [];
  int number = -1;            // function number: F12 is MOV
  bit wide = 0;               // its D form
  bit passesSystem = 0;       // the function takes `sys` as its last argument
  int maxUses = 0;            // so many may stand in a program, all forms of the mnemonic together; 0: any number
  Lowering transferOutside = LowerNothing;  // of LowerTransfer: LowerSet or LowerStore
  list<string> images = [];   // prefixes of the classes whose whole images the function gets in front of its operands
}

// The backend is run once per family file, grammar/<family>.td, which has one Family record: every Instruction, Special and
// ErrorCode that the file defines or includes belongs to it. Devices are those of its list.
class Family<string i, string t, string man> {
  string id = i;
  string title = t;
  string manual = man;
  string header = "";
  string ns = "";
  list<string> models = [];
  int maxBranches = 16;
  int maxLevels = 15;
  bit hasIndexRegisters = 0;
  bit pairsCrossClasses = 0;
  list<Device> devices = [];   // in the order of the documentation
  int endNs = 0;
  int ioRefreshNs = 0;
  int ioRefreshPointNs = 0;
  int notExecutedStepNs = 0;
  string ops = "ops";          // namespace of the runtime functions
  bit errorsStop = 1;          // an operation error stops the CPU
  bit firstScanPulses = 1;     // P forms act in the first scan
  bit clearsOnStop = 0;        // RUN to STOP clears what is not latched
  bit spacedOperands = 0;      // `S 20` is S20
  int warnedBranches = 0;      // outstanding MPS from which on a warning is due
  int maxLoops = 0;
  int maxCalls = 0;
  int maxMerge = 0;            // STL in succession
  int warnedMerge = 0;         // from which on a warning is due
  int endLabel = -1;           // P63
  string base = "";            // id of the family whose instructions it shares
}
