// Word instructions, in 64-bit arithmetic.
#include "interpreter.h"

namespace ladderc::differential {

namespace {

/// The number that `digits` decimal digits of four bits hold, or -1 where one of them is none.
std::int64_t number_of_bcd(std::uint64_t pattern, unsigned digits) {
  std::int64_t number = 0;
  for (unsigned i = digits; i-- > 0;) {
    const unsigned digit = pattern >> 4 * i & 15;
    if (digit > 9)
      return -1;
    number = number * 10 + digit;
  }
  return number;
}

std::uint64_t bcd_of_number(std::int64_t number) {
  std::uint64_t pattern = 0;
  for (unsigned i = 0; number > 0; ++i, number /= 10)
    pattern |= static_cast<std::uint64_t>(number % 10) << 4 * i;
  return pattern;
}

}  // namespace

bool Interpreter::compare(const Decoded &d, std::size_t index) {
  const std::int64_t a = memory_.read(operands(index)[0], d.wide ? 2 : 1), b = memory_.read(operands(index)[1], d.wide ? 2 : 1);
  if (d.sign == "=")
    return a == b;
  if (d.sign == "<>")
    return a != b;
  if (d.sign == ">")
    return a > b;
  if (d.sign == "<=")
    return a <= b;
  return d.sign == "<" ? a < b : a >= b;
}

bool Interpreter::word(const Decoded &d, std::size_t index) {
  const llvm::ArrayRef<Operand> o = operands(index);
  const unsigned words = d.wide ? 2 : 1;
  const std::uint32_t step = program_.list.instructions[index].step;
  const Operand &target = o.back();
  const auto source = [&](std::size_t k) { return memory_.read(o[k], words); };
  const auto store = [&](std::int64_t value) { memory_.write(target, static_cast<std::uint64_t>(value), words); };
  // `+ S D` works on D and S, `+ S1 S2 D` on S1 and S2.
  const bool two = o.size() == 2;
  const auto left = [&] { return source(two ? 1 : 0); };
  const auto right = [&] { return source(two ? 0 : 1); };
  switch (d.op) {
  case WordOp::Add:
    return store(left() + right()), true;
  case WordOp::Subtract:
    return store(left() - right()), true;
  case WordOp::And:
    return store(left() & right()), true;
  case WordOp::Or:
    return store(left() | right()), true;
  case WordOp::Xor:
    return store(left() ^ right()), true;
  case WordOp::Xnor:
    return store(~(left() ^ right())), true;
  case WordOp::Multiply:
    memory_.write(target, static_cast<std::uint64_t>(source(0) * source(1)), 2 * words);
    return true;
  case WordOp::Divide: {
    const std::int64_t a = source(0), b = source(1);
    if (b == 0)
      return system_.operation_error(4100, step), false;
    const std::uint64_t mask = d.wide ? 0xFFFFFFFFu : 0xFFFFu;
    const std::uint64_t quotient = static_cast<std::uint64_t>(a / b) & mask, remainder = static_cast<std::uint64_t>(a % b) & mask;
    memory_.write(target, target.kind == OperandKind::Digits ? quotient : quotient | remainder << 16 * words, 2 * words);
    return true;
  }
  case WordOp::Increment:
    return store(source(0) + 1), true;
  case WordOp::Decrement:
    return store(source(0) - 1), true;
  case WordOp::Negate:
    return store(-source(0)), true;
  case WordOp::Move:
    return store(source(0)), true;
  case WordOp::Complement:
    return store(~source(0)), true;
  case WordOp::ToBcd: {
    const std::int64_t value = source(0);
    if (value < 0 || value > (d.wide ? 99'999'999 : 9999))
      return system_.operation_error(4100, step), false;
    return store(static_cast<std::int64_t>(bcd_of_number(value))), true;
  }
  case WordOp::FromBcd: {
    const std::int64_t value = number_of_bcd(static_cast<std::uint64_t>(source(0)), 4 * words);
    if (value >= 0)
      return store(value), true;
    if (memory_.array("SM").on[722])
      return true;
    return system_.operation_error(4100, step), false;
  }
  case WordOp::BlockMove:
  case WordOp::Fill:
    return block(d, index);
  }
  return true;
}

/// Element i of a block is a word, or the i-th group of digits.
bool Interpreter::block(const Decoded &d, std::size_t index) {
  const llvm::ArrayRef<Operand> o = operands(index);
  const std::int64_t count = memory_.read(o[2], 1);
  const auto element = [](Operand operand, std::int64_t i) {
    operand.value += operand.kind == OperandKind::Digits ? 4 * operand.digits * i : i;
    return operand;
  };
  const auto fits = [&](const Operand &operand) {
    const DeviceArray &array = memory_.array(operand.device);
    const auto points = static_cast<std::int64_t>(operand.kind == OperandKind::Digits ? array.on.size() : array.value.size());
    return element(operand, count).value <= points;
  };
  if (count == 0)
    return true;
  const bool moves = d.op == WordOp::BlockMove;
  if (count < 0 || !fits(o[1]) || (moves && !fits(o[0]))) {
    system_.operation_error(4101, program_.list.instructions[index].step);
    return false;
  }
  // The whole source first: overlapping blocks come out as if they lay apart.
  std::vector<std::int64_t> values;
  for (std::int64_t i = 0; i < count; ++i)
    values.push_back(memory_.read(moves ? element(o[0], i) : o[0], 1));
  for (std::int64_t i = 0; i < count; ++i)
    memory_.write(element(o[1], i), static_cast<std::uint64_t>(values[static_cast<std::size_t>(i)]), 1);
  return true;
}

}  // namespace ladderc::differential
