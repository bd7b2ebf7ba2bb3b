// Numbers: device numbers, digit counts, constants, and how far an operand reaches.
#pragma once

#include "sema/context.h"
#include "sema/resolve.h"

namespace ladderc::sema {

/// True where a device of that number is one that the position takes.
bool takes_number(const OperandInfo &info, std::int64_t number);

/// Numbers of its class that the operand takes: words for a word device, bits for digits, 1 for a bit. Blocks count as their first
/// place.
std::uint32_t extent(const FamilyInfo &family, const OperandInfo &info, const Operand &operand);

/// Checks the operands that resolve() found good; those that are not in order are marked bad.
void check_operands(const Context &context, InstructionIndex index, Resolved &resolved);

}  // namespace ladderc::sema
