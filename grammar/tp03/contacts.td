// Contacts, and the connections between them.

class ContactForm<string m, Placement where> : Instruction<m, m> {
  let category = "contact";
  let lowering = LowerContact;
  let placement = where;
  let operands = [Operand<"S", "In", OpBit, ContactBits>];
}
class ConnectionForm<string m, Placement where, Lowering how> : Instruction<m, m> {
  let category = "connection";
  let placement = where;
  let lowering = how;
}

let section = "3.2" in {
def LD : ContactForm<"LD", AtStart> {
  let title = "Begin a block, normally open contact";
  let description = "Opens a logic block whose result is the state of S, at the bus, behind MC or in a state of a step ladder. T and C "
                    "are contacts here.";
  let example = Rung<"LD X0\nOUT Y0">.text;
}
def LDI : ContactForm<"LDI", AtStart> {
  let negated = 1;
  let title = "Begin a block, normally closed contact";
  let description = "Opens a logic block whose result is ON while S is OFF.";
  let example = Rung<"LDI X0\nOUT Y0">.text;
}
}
let section = "3.3" in {
def AND : ContactForm<"AND", AtSeries> {
  let title = "Normally open contact in series";
  let description = "The result stays ON only if S is ON as well. Behind an output it goes on with the result that drove the output.";
  let example = Rung<"LD X0\nAND M5\nOUT Y0">.text;
}
def ANI : ContactForm<"ANI", AtSeries> {
  let negated = 1;
  let title = "Normally closed contact in series";
  let description = "The result stays ON only if S is OFF.";
  let example = Rung<"LD X0\nANI M5\nOUT Y0">.text;
}
}
let section = "3.4" in {
def OR : ContactForm<"OR", AtParallel> {
  let title = "Normally open contact in parallel";
  let description = "The result becomes ON if S is ON. The contact lies parallel to everything since the LD that opened the block.";
  let example = Rung<"LD X0\nOR Y0\nANI X1\nOUT Y0">.text;
}
def ORI : ContactForm<"ORI", AtParallel> {
  let negated = 1;
  let title = "Normally closed contact in parallel";
  let description = "The result becomes ON if S is OFF. The contact lies parallel to everything since the LD that opened the block.";
  let example = Rung<"LD X0\nORI X1\nOUT Y0">.text;
}
}

// Each place remembers the state in which it saw S last; it looks only where it is executed.
let section = "3.5", steps = 2 in {
let edge = RisingEdge in {
def LDP : ContactForm<"LDP", AtStart> {
  let title = "Begin a block, rising edge";
  let description = "ON in the execution that finds S ON after the one before saw it OFF. Each place has a memory of its own, OFF at the "
                    "start; where the instruction is skipped (CJ, JCS, an inactive state) the memory stays, and a change is found late.";
  let example = Rung<"LDP X0\nSET M0">.text;
}
def ANDP : ContactForm<"ANDP", AtSeries> {
  let title = "Rising edge in series";
  let description = "The result stays ON only in the execution that finds S newly ON. The memory follows S whatever the result is.";
  let example = Rung<"LD X0\nANDP X1\nSET M0">.text;
}
def ORP : ContactForm<"ORP", AtParallel> {
  let title = "Rising edge in parallel";
  let description = "The result becomes ON in the execution that finds S newly ON.";
  let example = Rung<"LD X0\nORP X1\nOUT Y0">.text;
}
}
let edge = FallingEdge in {
def LDF : ContactForm<"LDF", AtStart> {
  let title = "Begin a block, falling edge";
  let description = "ON in the execution that finds S OFF after the one before saw it ON. Cannot be ON in the first scan.";
  let example = Rung<"LDF X0\nSET M0">.text;
}
def ANDF : ContactForm<"ANDF", AtSeries> {
  let aliases = ["ANF"];
  let title = "Falling edge in series";
  let description = "The result stays ON only in the execution that finds S newly OFF. The memory follows S whatever the result is.";
  let example = Rung<"LD X0\nANDF X1\nSET M0">.text;
}
def ORF : ContactForm<"ORF", AtParallel> {
  let title = "Falling edge in parallel";
  let description = "The result becomes ON in the execution that finds S newly OFF.";
  let example = Rung<"LD X0\nORF X1\nOUT Y0">.text;
}
}
}

let section = "3.6" in
def ORB : ConnectionForm<"ORB", AtJoinBlocks, LowerOrBlock> {
  let title = "Join two blocks in parallel";
  let description = "Takes the two blocks opened last and puts one back that is ON if one of them is.";
  let example = Rung<"LD X0\nAND X1\nLD X2\nAND X3\nORB\nOUT Y0">.text;
}
let section = "3.7" in
def ANB : ConnectionForm<"ANB", AtJoinBlocks, LowerAndBlock> {
  let title = "Join two blocks in series";
  let description = "Takes the two blocks opened last and puts one back that is ON if both are.";
  let example = Rung<"LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0">.text;
}
let section = "3.8" in {
def MPS : ConnectionForm<"MPS", AtPushBranch, LowerPushBranch> {
  let title = "Open a branch point";
  let description = "Keeps the result on a stack of eight for MRD and MPP. The manual allows fewer than eight in one another and also "
                    "counts eight cells: the eighth is a warning, the ninth an error.";
  let example = Rung<"LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nAND X2\nOUT Y1">.text;
}
def MRD : ConnectionForm<"MRD", AtReadBranch, LowerReadBranch> {
  let title = "Go on from the branch point";
  let description = "The result becomes that of the branch point opened last, which stays open.";
  let example = Rung<"LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nAND X2\nOUT Y1\nMPP\nOUT Y2">.text;
}
def MPP : ConnectionForm<"MPP", AtPopBranch, LowerPopBranch> {
  let title = "Go on from the branch point and close it";
  let description = "The result becomes that of the branch point opened last, which is closed.";
  let example = Rung<"LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nAND X2\nOUT Y1">.text;
}
}
let section = "3.10" in
def INV : ConnectionForm<"INV", AtSeries, LowerInvert> {
  let title = "Invert the result";
  let description = "Turns the result of the current block round. The condition of MC, SMCS or a state is not inverted. Stands where AND "
                    "may stand.";
  let example = Rung<"LD X0\nAND X1\nINV\nOUT Y0">.text;
}
