// Operand words: device, bit of word, digits, constant.
#pragma once

#include "support/diagnostics.h"
#include "syntax/ast.h"

#include "llvm/ADT/SmallVector.h"

#include <array>

namespace ladderc {

/// Why a word is no operand, and which part of it is to blame.
struct OperandProblem {
  DiagId id = DiagId::OperandUnreadable;
  std::size_t begin = 0;
  std::size_t length = llvm::StringRef::npos;  ///< to the end of the word
  llvm::StringRef device;                      ///< letters before the number
  unsigned radix = 10;                         ///< that the number has there
  llvm::StringRef kind;                        ///< of an UnsupportedConstant: "real", "string"

  /// False where the word does not even begin like an operand.
  bool looks_like_operand() const { return id != DiagId::OperandUnreadable; }
};

/// Reads the operand words of one family. Words are in the reader's normal form (upper case, half-width).
class OperandReader {
public:
  explicit OperandReader(const FamilyInfo &family);

  /// Invalid where the word is no operand; `problem`, if wanted, then says why.
  Operand read(llvm::StringRef word, SourceRange range, OperandProblem *problem = nullptr) const;

  /// True where the word is letters to which a blank and `number` may belong: `S 20`, `K -5`, in a family that prints blanks there.
  bool goes_on(llvm::StringRef word, llvm::StringRef number) const;

private:
  /// The classes of a prefix differ in their numbers only.
  struct Prefix {
    llvm::StringRef text;
    DeviceId device;  ///< the class with the lowest numbers
    std::uint8_t radix;
    bool shared;  ///< by several classes
  };
  /// The prefixes that begin with a character, longest first: `ST0` is no S.
  llvm::ArrayRef<Prefix> prefixes(char first) const;
  DeviceId class_of(const Prefix &prefix, std::uint64_t number) const;
  bool read_device_word(llvm::StringRef word, Operand &operand, OperandProblem &problem) const;
  bool read_device(llvm::StringRef word, const Prefix &prefix, Operand &operand, OperandProblem &problem) const;
  bool read_bit(llvm::StringRef &rest, llvm::StringRef word, Operand &operand, OperandProblem &problem) const;
  bool is_indexed_count(llvm::StringRef rest) const;
  bool read_index(llvm::StringRef rest, Operand &operand) const;
  bool read_decimal(llvm::StringRef word, Operand &operand, OperandProblem &problem) const;
  bool read_digits(llvm::StringRef word, llvm::StringRef rest, std::uint64_t count, Operand &operand,
                   OperandProblem &problem) const;
  bool read_hexadecimal(llvm::StringRef word, Operand &operand, OperandProblem &problem) const;
  bool read_word(llvm::StringRef word, Operand &operand, OperandProblem &problem) const;

  const FamilyInfo &family_;
  llvm::SmallVector<Prefix, 32> prefixes_;
  std::array<std::uint8_t, 257> first_{};  ///< where the prefixes of each character begin
};

}  // namespace ladderc
