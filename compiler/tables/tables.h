// What the instruction tables say, as plain data.
//
// Every fact about a controller family that the front end, the lowering, the documentation and the tests need is a record in
// grammar/*.td. The TableGen backend (grammar/tblgen) turns the records into constant arrays of the structures below; nothing
// here is computed at start-up and nothing in the compiler compares mnemonics. A new fact about an instruction is a new field.
#pragma once

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"

#include <cstdint>

namespace ladderc {

/// Index of a device class inside its family's `devices` array. Families have fewer than 64 classes, so that a set of classes is
/// one 64-bit mask (`DeviceSet`).
using DeviceId = std::uint8_t;
constexpr DeviceId kNoDevice = 0xFF;
using DeviceSet = std::uint64_t;
constexpr bool contains(DeviceSet set, DeviceId id) { return id < 64 && ((set >> id) & 1) != 0; }

enum class DeviceKind : std::uint8_t {
  Bit,      ///< one bit a number: X, Y, M
  Word,     ///< 16 bits a number: D, W
  Timer,    ///< contact, coil and a 16-bit current value
  Counter,  ///< contact, coil and a 16-bit current value
  LongCounter,  ///< contact, coil and a 32-bit current value
  Nesting,  ///< a level number, no memory: N
  Label,    ///< a jump, call or interrupt target, no memory: P, I
  Index,    ///< index register: Z, V of TP03
};

struct ModelPoints {
  llvm::StringRef model;
  std::uint32_t points;
};

/// Numbers `first` to `last`, inclusive, of a device class on one model, or on all of them where `model` is empty.
struct ModelNumbers {
  llvm::StringRef model;
  std::uint32_t first, last;
};

/// Input terminals that numbers `first` to `last` of a device class have for themselves: bit n is the n-th input.
struct TerminalUse {
  std::uint32_t first, last;
  std::uint32_t inputs;
};

/// One device class of a family.
struct DeviceInfo {
  llvm::StringRef prefix;    ///< as written before the number: "X", "SM"
  llvm::StringRef title;     ///< "input"
  DeviceKind kind;
  std::uint8_t radix;        ///< of the number: 8, 10 or 16
  std::uint32_t points;      ///< default allocation of the largest model; numbers run from first to first + points - 1
  llvm::ArrayRef<ModelPoints> model_points;  ///< where a model differs
  bool bit_of_word;          ///< `D0.5` exists
  bool external_input;       ///< refreshed from terminals before the scan
  bool external_output;      ///< sent to terminals after the scan
  std::uint8_t memory_order; ///< place in the family's device memory; a pair or digit run that crosses the end goes on in the next
                             ///< class of the same kind. 0: not part of it
  llvm::StringRef image;     ///< member of the generated class that holds it: "X", "sys.SM"
  std::int32_t points_register;  ///< number of the special register that tells the allocated points, -1: none
  llvm::StringRef behaviour; ///< one or two sentences for the documentation
  llvm::StringRef section;   ///< of the manual
  llvm::StringRef container; ///< runtime class template of the image, without `ladder::`; empty: by the kind
  llvm::StringRef begin_hook, end_hook;  ///< functions of System that get the image before and after the program; empty: none
  bool survives_stop = false;  ///< cleared at power-off only, where the family clears others when it stops
  std::uint8_t watched = 0;  ///< so many of them act between the scans, too, in programs with interrupts or high-speed counters
  std::uint32_t first = 0;   ///< lowest number; two classes may share a prefix where their numbers do not (M0 on, M8000 on)
  std::uint8_t name_digits = 1;  ///< names are written with at least so many digits: I001
  DeviceId high_words = kNoDevice;  ///< the class of equal numbers that holds the high word of a pair: V for Z
  llvm::ArrayRef<ModelNumbers> missing;  ///< numbers inside the range that do not exist; those of all models and of the model
  llvm::ArrayRef<ModelNumbers> latched;  ///< kept over power-off and STOP unless the parameters say otherwise
  llvm::ArrayRef<ModelNumbers> exclusive;  ///< of each such run a program may use one number: I000 or I001
  llvm::ArrayRef<TerminalUse> terminals;   ///< of the numbers that a program drives or places
};

enum class Direction : std::uint8_t { In, Out, InOut };

/// What an operand position takes. Widths count in 16-bit words of device memory.
enum class OperandType : std::uint8_t {
  Bit,        ///< a bit device, a timer's or counter's contact, or a bit of a word
  Word,       ///< 16 bits: a word device, K1-K4 digits, or a constant
  DWord,      ///< 32 bits: two consecutive words (low first), K1-K8 digits, or a constant
  QWord,      ///< 64 bits: four consecutive words (low first), or K1-K8 digits (the low 32 bits)
  WordTwice,  ///< two 16-bit results in consecutive words (quotient, remainder); digits take the first only
  DWordTwice, ///< two 32-bit results in consecutive pairs; digits take the first only
  WordBlock,  ///< the first of a run of words whose length another operand gives; digits are runs of digit groups
  Timer,      ///< a whole timer: contact, coil, value
  Counter,    ///< a whole counter
  Annunciator,///< an annunciator with its registration
  Level,      ///< a nesting level
  Number,     ///< a constant that is not data: a page number
  Label,      ///< a jump or call target
  Real,       ///< an IEEE-754 single in two consecutive words, or a K or H constant, which is converted
  DWordBlock, ///< the first of a run of 32-bit values
  BitRun,     ///< the first of a run of bits whose length the instruction or another operand gives
  BitTarget,  ///< a bit that is written later, outside of the instruction (an interrupt, a running operation)
  LongCounter,///< a whole 32-bit counter
  String,     ///< a text of the list
};

struct OperandInfo {
  llvm::StringRef name;      ///< S, S1, D, n
  Direction dir;
  OperandType type;
  DeviceSet devices;         ///< classes that may stand here as they are
  DeviceSet word_bits;       ///< word classes of which a bit may stand here (`D0.5`)
  DeviceSet digits;          ///< bit classes of which digits may stand here (`K4X0`)
  bool decimal;              ///< K constants
  bool hexadecimal;          ///< H constants
  std::int64_t min, max;     ///< range of a constant, and of a level
  llvm::StringRef note;      ///< for the documentation
  bool indexable = false;    ///< an index register may modify it: D20V0, K30V0, P0Z0
  std::uint32_t first = 0, last = 0;  ///< only these device numbers fit; both 0: all
  std::uint16_t count = 0;   ///< of a block or bit run whose length is fixed: so many; 0: another operand tells at run time
};

/// When the instruction acts.
enum class Execution : std::uint8_t { EveryScan, WhileOn, RisingEdge, FallingEdge };

/// Where in a rung the instruction may stand, and what it does to the block stack.
enum class Placement : std::uint8_t {
  Start,          ///< opens a block: LD
  Series,         ///< needs an open block, changes its result: AND, INV, MEP
  Parallel,       ///< needs an open block; not an AND position: OR
  JoinBlocks,     ///< needs two open blocks and makes them one: ANB, ORB
  PushBranch,     ///< MPS
  ReadBranch,     ///< MRD
  PopBranch,      ///< MPP
  Output,         ///< consumes the result and leaves it: OUT, MOV
  Alone,          ///< stands without a condition: MCR
  Anywhere,       ///< no effect on the rung: NOP
  Label,          ///< stands between rungs, marks the next one: P8, I001
  BetweenRungs,   ///< no effect, but stands between rungs only: NOPLF
  End,            ///< ends the program
};

/// How the instruction becomes IR. Everything that is not sequence logic is a call of a runtime function.
enum class Lowering : std::uint8_t {
  Contact,          ///< load a bit; `edge` and `negated` say which contact; `placement` says LD, AND or OR
  CompareContact,   ///< as Contact, the bit is the value of `function`
  AndBlock, OrBlock, PushBranch, ReadBranch, PopBranch,
  Invert,           ///< INV
  EdgeOfResult,     ///< MEP, MEF: `edge`; memory per place
  EdgeRelay,        ///< EGP, EGF: `edge`; memory is the operand
  Store,            ///< OUT: operand 0 becomes the result
  Set, Reset,       ///< while ON: operand 0 becomes 1 or 0
  PulseStore,       ///< PLS, PLF: operand 0 becomes the edge of the result
  Toggle,           ///< FF
  MasterControl, MasterControlReset,
  Call,             ///< call `function` when `execution` says so
  CallWithResult,   ///< call `function` every scan, the result is its first argument: timers, counters
  Nothing,          ///< NOP
  End,
  StoreInverted,    ///< OUTI: operand 0 becomes the inverse of the result, OFF where the bus is dead
  Label,            ///< P8: target of jumps, or head of a subroutine
  InterruptLabel,   ///< I001: head of an interrupt routine
  Jump,             ///< CJ: go on behind the label in operand 0 while ON
  CallRoutine,      ///< CALL: run the subroutine in operand 0
  Return,           ///< SRET
  InterruptReturn,  ///< IRET
  MainEnd,          ///< FEND: ends the main program
  Loop, LoopEnd,    ///< FOR n, NEXT
  Skip, SkipEnd,    ///< JCS, JCR: skip while ON
  BusStart, BusEnd, ///< SMCS, SMCR: a master control without level and device
  State, StateEnd,  ///< STL, RET
  Transfer,         ///< SET S, OUT S: inside a state a transfer, elsewhere what `transfer_outside` says
};

/// How the generated code calls `function`.
enum class CallStyle : std::uint8_t {
  None,
  Value,    ///< `out = f(inputs)`; an empty function name is the plain assignment, of 0 where there is no input
  Status,   ///< `f(inputs, outputs)` returns false for an operation error, with nothing written
  Void,     ///< `f(inputs, outputs)` cannot fail
  Method,   ///< `operand0.f(other inputs)`: timers and counters
  System,   ///< `sys.f(inputs)`; with `stops_scan`, it returns false when the program must not go on
  Memory,   ///< `f_STEP.run(condition, inputs, outputs, sys)`: an object of type `function` that each place in the list has for itself
};

struct TimeInfo {
  llvm::StringRef condition;  ///< "executed", "S D executed", "OFF->ON"; empty: always
  llvm::StringRef device;     ///< restricts the entry to operands like this one: "X0", "D0.0", "T,C"; empty: any
  std::uint32_t nanoseconds;  ///< as the manual's timing table tells
};

struct InstructionInfo;

/// One mnemonic with one operand list: what one line of a list can be. A mnemonic with several operand lists (`+ S D` and
/// `+ S1 S2 D`, `OUT M0` and `OUT T0 K10`) has several entries.
struct InstructionInfo {
  llvm::StringRef form;       ///< as the manual's tables name it: "OUT T", "D+P"
  llvm::StringRef spelling;   ///< as typed: "OUT", "D+P"
  llvm::ArrayRef<llvm::StringRef> aliases;  ///< other spellings: "LD ="
  llvm::StringRef mnemonic;   ///< the instruction that the form belongs to: "OUT", "+"
  llvm::StringRef title;
  llvm::StringRef description;
  llvm::StringRef category;
  llvm::StringRef section;
  llvm::StringRef example;    ///< one or more list lines, "\n" between them, that compile without a message
  llvm::ArrayRef<llvm::StringRef> models;   ///< empty: all
  llvm::ArrayRef<OperandInfo> operands;
  Execution execution;
  Placement placement;
  Lowering lowering;
  bool negated;               ///< a normally closed contact: LDI
  bool drives;                ///< writes operand 0 in every scan, so that a second such instruction is a double coil
  Execution edge;             ///< RisingEdge or FallingEdge of contacts and PLS-like instructions, else EveryScan
  CallStyle style;
  llvm::StringRef function;   ///< runtime function, without namespace
  llvm::ArrayRef<std::uint8_t> inputs;   ///< operand indexes in the order of the function's parameters
  llvm::ArrayRef<std::uint8_t> outputs;  ///< operand indexes that the function writes
  bool stops_scan;            ///< a System call after which the program does not go on when it returns false
  std::uint16_t error_code;   ///< operation error of a Status function; 0: cannot fail
  llvm::StringRef error_mask; ///< special relay that suppresses the error while ON ("SM722"), or empty
  llvm::StringRef errors;     ///< "4100: a digit is not 0-9", lines for the documentation
  std::uint8_t steps;         ///< basic step count
  std::uint8_t steps_per_constant;  ///< added for each K or H operand: 1 for 32-bit forms and S.QSABORT
  std::uint8_t steps_subset;  ///< step count when every operand qualifies for subset processing; 0: as `steps`
  std::uint8_t equal_digits;  ///< 1: digit counts of operands 0 and 1 must be equal when both are digit designations
  llvm::ArrayRef<TimeInfo> times;
  std::int16_t number = -1;   ///< function number: F12 and FNC12 are MOV; -1: none
  bool wide = false;          ///< the D form of a function number
  bool passes_system = false; ///< the function takes `sys` as its last argument
  std::uint8_t max_uses = 0;  ///< so many may stand in a program, all forms of the mnemonic together; 0: any number
  Lowering transfer_outside = Lowering::Nothing;  ///< of Transfer: Set or Store
  llvm::ArrayRef<llvm::StringRef> images = {};  ///< classes, by prefix, whose whole images the function gets behind the condition
};

struct SpecialInfo {
  llvm::StringRef device;     ///< "SM400", or a run "SD1000-SD1003"
  llvm::StringRef name;
  llvm::StringRef behaviour;
  bool writable;              ///< the program may write it
  bool simulated;             ///< the runtime keeps it; otherwise it is plain memory that the host may fill
  llvm::StringRef section;
  std::int8_t constant = -1;  ///< 0 or 1: a relay that the system holds at that state in every scan; -1: it changes
};

struct ErrorInfo {
  std::uint16_t code;
  llvm::StringRef name;       ///< "OPERATION ERROR"
  llvm::StringRef cause;
  llvm::StringRef action;
  bool stops;                 ///< the CPU stops
  llvm::StringRef section;
};

/// The limits and texts of a family that are not per instruction.
struct FamilyInfo {
  llvm::StringRef id;         ///< "melsec-qs"
  llvm::StringRef title;      ///< "MELSEC QS (QS001CPU)"
  llvm::StringRef manual;     ///< how messages name the manual: "QS"
  llvm::StringRef header;     ///< runtime header that the generated code includes: "ladder/melsec_qs.h"
  llvm::StringRef ns;         ///< runtime namespace of System: "melsec_qs"
  llvm::ArrayRef<llvm::StringRef> models;   ///< the first is the default
  std::uint8_t max_branches;  ///< outstanding MPS
  std::uint8_t max_levels;    ///< nesting levels of master control
  bool has_index_registers;
  bool pairs_cross_classes;   ///< a pair at the end of a class goes on in the next one of the memory order
  llvm::ArrayRef<DeviceInfo> devices;
  llvm::ArrayRef<InstructionInfo> instructions;
  llvm::ArrayRef<SpecialInfo> specials;
  llvm::ArrayRef<ErrorInfo> errors;
  std::uint32_t end_ns;              ///< END processing time of the real CPU
  std::uint32_t io_refresh_ns;       ///< basic time of the I/O refresh
  std::uint32_t io_refresh_point_ns; ///< for each refreshed point
  std::uint32_t not_executed_step_ns;///< (steps + 1) times this where the condition of a basic instruction is OFF
  llvm::StringRef ops = "ops";       ///< namespace of the functions that Value, Status and Void calls name
  bool errors_stop = true;           ///< an operation error stops the CPU; otherwise the program goes on with the next instruction
  bool first_scan_pulses = true;     ///< a P form whose condition is ON in the first scan acts there
  bool clears_on_stop = false;       ///< RUN to STOP clears what is not latched
  bool spaced_operands = false;      ///< a blank may stand between letter and number: `S 20`, `K 100`
  std::uint8_t warned_branches = 0;  ///< outstanding MPS from which on a warning is due; 0: none
  std::uint8_t max_loops = 0;        ///< FOR-NEXT inside each other
  std::uint8_t max_calls = 0;        ///< calls inside each other
  std::uint8_t max_merge = 0;        ///< STL in succession
  std::int16_t end_label = -1;       ///< the label that means END: P63
  llvm::StringRef base;              ///< of a family that is another one with other ranges: the id of that one
  std::uint8_t warned_merge = 0;     ///< STL in succession from which on a warning is due; 0: none
};

/// All families, in alphabetical order of their ids.
llvm::ArrayRef<FamilyInfo> families();
/// The family of that id, or null.
const FamilyInfo *find_family(llvm::StringRef id);
/// The device class with that prefix, or kNoDevice. Where classes share a prefix, the one with the lowest numbers.
DeviceId find_device(const FamilyInfo &family, llvm::StringRef prefix);
/// The device class with that prefix that a number belongs to: of those that begin at or before it, the last one. Whether the number
/// exists is another question.
DeviceId find_device(const FamilyInfo &family, llvm::StringRef prefix, std::uint64_t number);
/// All entries with that spelling or alias (upper case; two words are joined by one blank). Empty: unknown.
llvm::ArrayRef<const InstructionInfo *> find_instructions(const FamilyInfo &family, llvm::StringRef spelling);
/// The error of that code, or null.
const ErrorInfo *find_error(const FamilyInfo &family, std::uint16_t code);
/// Points of the class for the model, before parameters.
std::uint32_t points_of(const DeviceInfo &device, llvm::StringRef model);
/// The runs of numbers that exist on a model with that many points, in ascending order.
llvm::SmallVector<ModelNumbers, 4> existing_numbers(const DeviceInfo &device, llvm::StringRef model, std::uint32_t points);
bool number_exists(const DeviceInfo &device, llvm::StringRef model, std::uint32_t points, std::uint64_t number);
/// What is latched on a model by default: the runs that name the model, or else those for all models, as far as numbers exist.
llvm::SmallVector<ModelNumbers, 4> latched_numbers(const DeviceInfo &device, llvm::StringRef model);
/// True where the class can modify the number of an operand: V and Z.
bool is_index_register(const FamilyInfo &family, DeviceId device);
/// The family whose manual the messages cite: the base of a family that has one.
llvm::StringRef cited_family(const FamilyInfo &family);

}  // namespace ladderc
