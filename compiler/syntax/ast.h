// The program as the list has it.
//
// Instructions and operands lie in two flat vectors; an instruction names its operands by index. Nothing is resolved beyond what
// one line can tell: a word is split into device, number, digits or bit, and the mnemonic into the table entries that share its
// spelling. Which entry it is, whether the operands fit and where the steps fall is sema's.
#pragma once

#include "support/source.h"
#include "tables/tables.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ladderc {

/// `Operand::index` of an operand with an index register in a family that has none.
constexpr DeviceId kForeignIndex = 0xFE;

/// The parser keeps no more operands of one instruction; it reports the first one beyond.
constexpr unsigned kMaxOperands = 32;

enum class OperandKind : std::uint8_t {
  Device,       ///< X1F, D100, T0, N1, P10
  BitOfWord,    ///< D0.5: device D, number 0, bit 5
  Digits,       ///< K4X10: four digits from X10
  Decimal,      ///< K100
  Hexadecimal,  ///< H1F
  Text,         ///< "ABC": a string; `value` is its index in ListProgram::texts
  Invalid,      ///< could not be read; a message has been reported
};

struct Operand {
  OperandKind kind = OperandKind::Invalid;
  DeviceId device = kNoDevice;
  std::uint8_t digits = 0;     ///< 1-8 where kind is Digits (as written: 0 and 9 are kept for sema to refuse)
  std::uint8_t bit = 0;        ///< 0-15 where kind is BitOfWord
  DeviceId index = kNoDevice;  ///< index register class where the operand is index modified (`D0Z1`), or kForeignIndex
  std::uint8_t index_number = 0;
  std::int64_t value = 0;  ///< device number, or the constant: K as written, H as an unsigned number
  SourceRange range;
};

struct Instruction {
  llvm::ArrayRef<const InstructionInfo *> candidates;  ///< entries of that spelling; empty where the mnemonic is unknown
  const InstructionInfo *info = nullptr;               ///< the chosen entry; set by sema
  std::uint32_t first_operand = 0;
  std::uint8_t operand_count = 0;
  SourceRange range;       ///< of the mnemonic
  std::uint32_t step = 0;  ///< first program step; set by sema
  std::uint32_t rung = 0;  ///< 1-based; set by sema
};

enum class CommentKind : std::uint8_t {
  Line,       ///< behind an instruction, `; ...` or `// ...`
  Statement,  ///< above a rung: a line of its own, or the CSV's line statement
  Note,       ///< the CSV's note of an output, or its P/I statement
};

/// `instruction` is the one that the comment stands behind (Line, Note) or before (Statement; behind the last instruction it is the
/// count of instructions).
struct Comment {
  std::uint32_t instruction;
  CommentKind kind;
  SourceRange range;  ///< of the text, without the comment mark and outer blanks
};

/// One list file after parsing.
struct ListProgram {
  const FamilyInfo *family = nullptr;
  unsigned file = 0;  ///< index in the SourceSet
  std::vector<Instruction> instructions;
  std::vector<Operand> operands;
  std::vector<std::string> texts;  ///< string operands without their quotes
  std::vector<Comment> comments;  ///< in the order of their instructions
  SourceRange end_of_text;        ///< zero length, for messages about what is missing

  llvm::ArrayRef<Operand> operands_of(const Instruction &i) const {
    return llvm::ArrayRef<Operand>(operands).slice(i.first_operand, i.operand_count);
  }
};

}  // namespace ladderc
