// The intermediate representation: what a list does, without its stacks.
//
// A routine is a sequence of rungs, a rung a sequence of operations in the order of the list. Boolean results are SSA values local
// to their rung; everything that outlives a rung is a place: a device, a private edge memory, a master control state. Effects are
// ordered, and a load happens where its contact stands, so that a later contact sees what an earlier coil wrote in the same scan.
//
// The first routine is the main program. Subroutines, interrupt routines and the states of a step ladder are routines of their own,
// which it calls. Inside a routine labels, jumps and loops are operations like others that nothing is moved across; a label, a loop's
// head and its end have a rung to themselves.
//
// The IR knows no family: an application instruction is a Call or Test of a runtime function with places as arguments. Families
// bring device classes (for printing and emission) by reference to their table.
#pragma once

#include "sema/check.h"
#include "support/source.h"
#include "tables/tables.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ladderc::ir {

using ValueId = std::uint32_t;
constexpr ValueId kNoValue = ~0u;

enum class PlaceKind : std::uint8_t {
  Bit,      ///< device bit, or the contact of a timer or counter
  WordBit,  ///< bit `bit` of a word device
  Word,     ///< the words from `number` on; how many, the operand type says
  Digits,   ///< `digits` groups of four bits from `number` on
  Object,   ///< a whole timer, counter or annunciator
  Decimal,  ///< constant, written in decimal
  Hex,      ///< constant, written in hexadecimal
  Edge,     ///< private edge memory `number`
  Master,   ///< master control state of level `number`
  Text,     ///< string `value` of the module
  Label,    ///< a label by its number; from kHiddenLabel on, those that the list does not name
};

/// Labels from here on are the ends of skipped ranges.
constexpr std::uint32_t kHiddenLabel = 0x10000;

/// Something that an operation reads or writes, or a constant.
struct Place {
  PlaceKind kind = PlaceKind::Decimal;
  OperandType type = OperandType::Bit;
  DeviceId device = kNoDevice;
  std::uint8_t digits = 0;
  std::uint8_t bit = 0;
  std::uint32_t number = 0;
  std::int64_t value = 0;  ///< of a constant, a text's index in the module's list
  DeviceId index = kNoDevice;      ///< class of the index register that modifies the number or the constant
  std::uint8_t index_number = 0;
  bool wide_index = false;         ///< the index is the pair of registers: 32-bit instructions
  std::uint16_t count = 0;         ///< of a block or bit run: how many, where the table entry says

  bool is_indexed() const { return index != kNoDevice; }
  bool is_constant() const { return kind == PlaceKind::Decimal || kind == PlaceKind::Hex || kind == PlaceKind::Text; }
  bool operator==(const Place &) const = default;
};

enum class Op : std::uint8_t {
  Constant,  ///< %n = const 0|1
  Load,      ///< %n = load PLACE
  Not,       ///< %n = not %a
  And,       ///< %n = and %a, %b
  AndNot,    ///< %n = andn %a, %b        a and not b
  Or,        ///< %n = or %a, %b
  OrNot,     ///< %n = orn %a, %b         a or not b
  Xor,       ///< %n = xor %a, %b
  Rising,    ///< %n = rising PLACE, %a   edge against the memory PLACE, which becomes %a
  Falling,   ///< %n = falling PLACE, %a
  Pulse,     ///< %n = pulse PLACE, %a    as rising, but never in the first scan
  Active,    ///< %n = active             the state that this routine belongs to is ON, and so is the bus that it lies in
  Test,      ///< %n = test FUNCTION (PLACES)
  Store,     ///< store PLACE, %a
  Set,       ///< set PLACE if %a
  Reset,     ///< reset PLACE if %a
  Call,      ///< call FUNCTION if %a (PLACES) -> (PLACES); without `if`: always
  Run,       ///< run FUNCTION with %a (PLACES) -> (PLACES): every scan, the condition is an argument
  Transfer,  ///< transfer PLACE if %a (PLACES): the first state goes ON, the others OFF at the end of the scan
  Label,     ///< label PLACE
  Jump,      ///< jump PLACE if %a; without `if`: always
  Gosub,     ///< gosub PLACE if %a
  Loop,      ///< loop N (PLACE): what follows, up to `next N`, so many times
  Next,      ///< next N
  Enter,     ///< enter ROUTINE PLACE, %a: a state's routine, while %a is ON and once more behind it; PLACE remembers
  Leave,     ///< leave: the routines of states that a transfer has left run once with a dead bus
  Return,    ///< return: from a subroutine or interrupt routine
  EndScan,   ///< endscan
};

bool is_value(Op op);
llvm::StringRef name(Op op);

struct Operation {
  Op op;
  ValueId result = kNoValue;  ///< of value operations; dense within the rung
  ValueId a = kNoValue, b = kNoValue;
  bool constant = false;                  ///< of Constant
  const InstructionInfo *info = nullptr;  ///< the table entry of Test, Call, Run: function, style, errors
  std::uint32_t step = 0;                 ///< of the instruction that it came from
  Place place;                            ///< of Load, Rising, Falling, Pulse, Store, Set, Reset, Transfer, Label, Jump, Gosub, Enter
  std::uint32_t target = 0;               ///< of Enter: the routine; of Loop and Next: the loop
  llvm::SmallVector<Place, 0> inputs;     ///< of Test, Call, Run, Transfer, Loop
  llvm::SmallVector<Place, 0> outputs;
};

/// True for an operation that has a condition and acts only while it is ON.
bool is_conditional(Op op);
/// True for what directs the flow through the routine or leaves it: no operation moves across.
bool is_flow(Op op);

/// True where an index register picks one of the operation's devices.
bool is_indexed(const Operation &operation);

/// True where the runtime is told the step, for its error information.
bool tells_step(const Operation &operation);

struct Rung {
  std::uint32_t number = 0;                                    ///< 1-based, as sema counts
  std::uint32_t step = 0;                                      ///< of its first instruction
  std::uint32_t first_instruction = 0, instruction_count = 0;  ///< in the list
  SourceRange range;                                           ///< of its first mnemonic
  std::string origin;  ///< of a rung that was read from IR text: the place that stood there, `"press.il":1`
  std::vector<Operation> operations;
  std::uint32_t values = 0;  ///< value numbers 0 to values - 1 are used
};

struct EdgeMemory {
  std::uint32_t step;  ///< of the instruction that owns it
};

enum class RoutineKind : std::uint8_t { Main, Subroutine, Interrupt, State };

struct Routine {
  std::string name;  ///< "main", "P10", "I001", "S20", "S29_S39_S49"
  std::vector<Rung> rungs;
  RoutineKind kind = RoutineKind::Main;
  std::uint32_t label = 0;            ///< of a subroutine or interrupt routine
  llvm::SmallVector<Place, 1> states; ///< of a state: all that must be ON
  Place memory;                       ///< of a state: whether its last execution found it ON
};

/// One list as IR. Places of the list are ranges in the compilation's sources.
struct Module {
  const FamilyInfo *family = nullptr;
  std::vector<std::uint32_t> points;  ///< allocation of each device class; empty: the family's
  std::string name;                   ///< of the program
  std::vector<Routine> routines;      ///< the first is the main routine
  std::vector<EdgeMemory> edges;      ///< private edge memories by number
  std::uint32_t master_levels = 0;    ///< master control states 0 to master_levels - 1 are used
  std::uint32_t loops = 0;            ///< loops 0 to loops - 1 are used
  std::vector<std::string> texts;     ///< string operands

  std::uint32_t points_of(DeviceId device) const { return points.empty() ? family->devices[device].points : points[device]; }
};

/// Text form, stable and complete: parse(print(m)) prints the same.
void print(const Module &module, const SourceSet &sources, llvm::raw_ostream &out);
std::string to_text(const Module &module, const Place &place);
std::string to_text(const Module &module, const Operation &operation);

/// The place that an operand of a list means in a position of that type.
Place to_place(const Operand &operand, OperandType type);
Place to_place(const Operand &operand, const OperandInfo &info);

/// Checks that values are defined once and before use, dense numbering, operand counts against the table entry, and that places
/// exist. Returns what is wrong, or an empty text.
std::string verify(const Module &module);

/// Reads the text form into `module`, whose family is set. On failure returns false and `error` says line and reason.
bool parse(llvm::StringRef text, Module &module, std::string &error);

}  // namespace ladderc::ir
