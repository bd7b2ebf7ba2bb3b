// Contacts, and the connections between them.

defvar PlainContact = [Time<100, "", "X0">, Time<150, "", "D0.0">];
defvar EdgeContact = [Time<150>];

let section = "5.1.1" in {
def LD : ContactForm<"LD", AtStart, PlainContact> {
  let title = "Begin a block, normally open contact";
  let description = "Opens a new logic block whose result is the state of S. Every rung begins with an LD-type instruction, and so "
                    "does every block that ANB or ORB joins later.";
  let example = Rung<"LD X0\nOUT Y10">.text;
}
def LDI : ContactForm<"LDI", AtStart, PlainContact> {
  let negated = 1;
  let title = "Begin a block, normally closed contact";
  let description = "Opens a new logic block whose result is ON while S is OFF.";
  let example = Rung<"LDI X0\nOUT Y10">.text;
}
def AND : ContactForm<"AND", AtSeries, PlainContact> {
  let title = "Normally open contact in series";
  let description = "The result stays ON only if S is ON as well.";
  let example = Rung<"LD X0\nAND M5\nOUT Y10">.text;
}
def ANI : ContactForm<"ANI", AtSeries, PlainContact> {
  let negated = 1;
  let title = "Normally closed contact in series";
  let description = "The result stays ON only if S is OFF.";
  let example = Rung<"LD X0\nANI D0.5\nOUT Y10">.text;
}
def OR : ContactForm<"OR", AtParallel, PlainContact> {
  let title = "Normally open contact in parallel";
  let description = "The result becomes ON if S is ON. The contact lies parallel to everything since the LD that opened the block.";
  let example = Rung<"LD X0\nOR Y10\nANI X1\nOUT Y10">.text;
}
def ORI : ContactForm<"ORI", AtParallel, PlainContact> {
  let negated = 1;
  let title = "Normally closed contact in parallel";
  let description = "The result becomes ON if S is OFF. The contact lies parallel to everything since the LD that opened the "
                    "block.";
  let example = Rung<"LD X0\nORI X1\nOUT Y10">.text;
}
}

// Each occurrence remembers the state in which it saw S last; the memory is OFF at power-on.
let section = "5.1.2", edge = RisingEdge in {
def LDP : ContactForm<"LDP", AtStart, EdgeContact> {
  let title = "Begin a block, rising edge";
  let description = "Opens a new logic block whose result is ON in the scan in which S is found ON after the instruction saw it "
                    "OFF. Each occurrence has a memory of its own, OFF at power-on, so S that is ON in the first scan counts as an "
                    "edge.";
  let example = Rung<"LDP X0\nSET M0">.text;
}
def ANDP : ContactForm<"ANDP", AtSeries, EdgeContact> {
  let title = "Rising edge in series";
  let description = "The result stays ON only in the scan in which S turned ON. The memory follows S itself, whatever the result "
                    "is.";
  let example = Rung<"LD X0\nANDP X1\nSET M0">.text;
}
def ORP : ContactForm<"ORP", AtParallel, EdgeContact> {
  let title = "Rising edge in parallel";
  let description = "The result becomes ON in the scan in which S turned ON. The memory follows S itself.";
  let example = Rung<"LD X0\nORP X1\nOUT Y10">.text;
}
}
let section = "5.1.2", edge = FallingEdge in {
def LDF : ContactForm<"LDF", AtStart, EdgeContact> {
  let title = "Begin a block, falling edge";
  let description = "Opens a new logic block whose result is ON in the scan in which S is found OFF after the instruction saw it "
                    "ON.";
  let example = Rung<"LDF X0\nRST M0">.text;
}
def ANDF : ContactForm<"ANDF", AtSeries, EdgeContact> {
  let title = "Falling edge in series";
  let description = "The result stays ON only in the scan in which S turned OFF. The memory follows S itself, whatever the result "
                    "is.";
  let example = Rung<"LD X0\nANDF X1\nRST M0">.text;
}
def ORF : ContactForm<"ORF", AtParallel, EdgeContact> {
  let title = "Falling edge in parallel";
  let description = "The result becomes ON in the scan in which S turned OFF. The memory follows S itself.";
  let example = Rung<"LD X0\nORF X1\nOUT Y10">.text;
}
}

defvar Connection = [Time<100>];

let section = "5.2.1" in {
def ANB : ConnectionForm<"ANB", AtJoinBlocks, LowerAndBlock, Connection> {
  let title = "Join two blocks in series";
  let description = "Takes the two blocks opened last off the stack and puts one back that is ON if both are.";
  let example = Rung<"LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y10">.text;
}
def ORB : ConnectionForm<"ORB", AtJoinBlocks, LowerOrBlock, Connection> {
  let title = "Join two blocks in parallel";
  let description = "Takes the two blocks opened last off the stack and puts one back that is ON if either is. For a block of one "
                    "contact OR does the same.";
  let example = Rung<"LD X0\nAND X1\nLD X2\nAND X3\nORB\nOUT Y10">.text;
}
}

let section = "5.2.2", example = Rung<"LD X0\nMPS\nAND X1\nOUT Y10\nMRD\nAND X2\nOUT Y11\nMPP\nAND X3\nOUT Y12">.text in {
def MPS : ConnectionForm<"MPS", AtPushBranch, LowerPushBranch, Connection> {
  let title = "Open a branch point";
  let description = "Remembers the result for later branches and leaves it as it is. At most 16 branch points may be open, and "
                    "each needs an MPP.";
}
def MRD : ConnectionForm<"MRD", AtReadBranch, LowerReadBranch, Connection> {
  let title = "Go on from the branch point";
  let description = "The result becomes that of the branch point opened last, which stays open.";
}
def MPP : ConnectionForm<"MPP", AtPopBranch, LowerPopBranch, Connection> {
  let title = "Go on from the branch point and close it";
  let description = "The result becomes that of the branch point opened last, which is closed.";
}
}

def INV : ConnectionForm<"INV", AtSeries, LowerInvert, Connection> {
  let section = "5.2.3";
  let title = "Invert the result";
  let description = "Turns the result of the current block round, with all that lies in series and in parallel before it. Stands "
                    "where an AND may stand.";
  let example = Rung<"LD X0\nAND X1\nINV\nOUT Y10">.text;
}

let section = "5.2.4" in {
def MEP : ConnectionForm<"MEP", AtSeries, LowerEdgeOfResult, [Time<150>]> {
  let edge = RisingEdge;
  let title = "Rising edge of the result";
  let description = "The result is ON only in the scan in which it turned ON. Each occurrence has a memory of its own. Stands "
                    "where an AND may stand.";
  let example = Rung<"LD X0\nAND X1\nMEP\nSET M0">.text;
}
def MEF : ConnectionForm<"MEF", AtSeries, LowerEdgeOfResult, [Time<150>]> {
  let edge = FallingEdge;
  let title = "Falling edge of the result";
  let description = "The result is ON only in the scan in which it turned OFF: what follows is executed although the contacts "
                    "before are OFF. Each occurrence has a memory of its own. Stands where an AND may stand.";
  let example = Rung<"LD X0\nAND X1\nMEF\nSET M0">.text;
}
}

let section = "5.2.5", operands = [EdgeRelayOperand], drives = 1 in {
def EGP : ConnectionForm<"EGP", AtSeries, LowerEdgeRelay, [Time<100>]> {
  let edge = RisingEdge;
  let title = "Rising edge of the result, remembered in an edge relay";
  let description = "As MEP, but the last result is kept in the edge relay D, which then holds the present one.";
  let example = Rung<"LD X0\nEGP V0\nSET M0">.text;
}
def EGF : ConnectionForm<"EGF", AtSeries, LowerEdgeRelay,
                         [Time<11000, "OFF->OFF">, Time<14000, "ON->ON">, Time<14000, "OFF->ON">, Time<16000, "ON->OFF">]> {
  let edge = FallingEdge;
  let steps = 2;
  let title = "Falling edge of the result, remembered in an edge relay";
  let description = "As MEF, but the last result is kept in the edge relay D, which then holds the present one.";
  let example = Rung<"LD X0\nEGF V1\nSET M0">.text;
}
}
