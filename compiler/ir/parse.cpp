// Reads the text form of the IR. Used by tests and by `ladderc` on .ir files, so that a pass can be tried alone.
//
// Places are read with the operand reader of the lists, since they are written the same way; the table entry of a call is found by
// its form and its numbers of inputs and outputs.
#include "ir/ir.h"
#include "syntax/parser.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

#include <fmt/format.h>

#include <optional>

namespace ladderc::ir {

namespace {

constexpr ValueId kMaxValues = 1 << 20;  // no rung has as many; memory is allocated by the largest number

class Parser {
public:
  Parser(Module &module, std::string &error) : module_(module), error_(error) {}

  bool run(llvm::StringRef text) {
    while (!text.empty()) {
      auto [line, rest] = text.split('\n');
      text = rest;
      ++line_;
      line_text_ = line.split(";;;").first.trim();
      if (!line_text_.empty() && !line_text_.starts_with(";") && !parse_line())
        return false;
    }
    if (open_)
      return fail("routine is not closed");
    return true;
  }

private:
  bool fail(llvm::StringRef what) {
    error_ = fmt::format("line {}: {}", line_, what.str());
    return false;
  }

  bool parse_line() {
    if (take("edges")) {
      llvm::SmallVector<llvm::StringRef> steps;
      line_text_.split(steps, ',');
      for (llvm::StringRef s : steps) {
        EdgeMemory e{};
        if (s.trim().getAsInteger(10, e.step))
          return fail("step number expected");
        module_.edges.push_back(e);
      }
      return true;
    }
    if (take("points"))
      return parse_points();
    if (take("levels"))
      return !line_text_.getAsInteger(10, module_.master_levels) || fail("number of levels expected");
    if (take("loops"))
      return !line_text_.getAsInteger(10, module_.loops) || fail("number of loops expected");
    if (take("text")) {
      module_.texts.push_back(line_text_.str());
      return true;
    }
    if (take("routine"))
      return parse_routine();
    if (line_text_ == "}") {
      open_ = false;
      return true;
    }
    if (!open_)
      return fail("routine expected");
    if (take("rung"))
      return parse_rung();
    if (module_.routines.back().rungs.empty())
      return fail("rung expected");
    return parse_operation();
  }

  bool parse_routine() {
    Routine routine;
    routine.name = take_word().str();
    open_ = true;
    if (take("call") || take("on")) {
      const Operand label = parse_operand(*module_.family, take_word(), {});
      if (label.kind != OperandKind::Device)
        return fail("label expected");
      routine.kind = module_.family->devices[label.device].prefix == "I" ? RoutineKind::Interrupt : RoutineKind::Subroutine;
      routine.label = static_cast<std::uint32_t>(label.value);
    } else if (take("state")) {
      routine.kind = RoutineKind::State;
      llvm::SmallVector<llvm::StringRef> states;
      if (!parse_place(routine.memory, OperandType::Bit) || !take_list(states))
        return fail("memory and states expected");
      for (llvm::StringRef state : states)
        if (!parse_place(state, routine.states.emplace_back(), OperandType::Bit))
          return false;
    }
    module_.routines.push_back(std::move(routine));
    return take("{") || fail("'{' expected");
  }

  bool parse_points() {
    const DeviceId device = find_device(*module_.family, take_word());
    if (device == kNoDevice)
      return fail("device class expected");
    if (module_.points.empty())
      for (const DeviceInfo &d : module_.family->devices)
        module_.points.push_back(d.points);
    return !line_text_.getAsInteger(10, module_.points[device]) || fail("number of points expected");
  }

  bool parse_rung() {
    Rung rung;
    rung.number = static_cast<std::uint32_t>(module_.routines.back().rungs.size() + 1);
    if (take_word().getAsInteger(10, rung.step))
      return fail("step number expected");
    rung.range = SourceRange(0, 0, 0xFF);
    rung.origin = line_text_.str();
    module_.routines.back().rungs.push_back(std::move(rung));
    return true;
  }

  bool parse_operation() {
    Rung &rung = module_.routines.back().rungs.back();
    Operation o{};
    o.step = rung.step;
    if (line_text_.starts_with("%")) {
      if (!take_value(o.result) || !take("="))
        return fail("'%N =' expected");
      rung.values = std::max(rung.values, o.result + 1);
    }
    const llvm::StringRef word = take_word();
    const std::optional<Op> op = find(word);
    if (!op || is_value(*op) != (o.result != kNoValue))
      return fail("unknown operation");
    o.op = *op;
    if (!parse_operands(o))
      return false;
    if (!line_text_.empty())
      return fail("text behind the operation");
    rung.operations.push_back(std::move(o));
    return true;
  }

  bool parse_operands(Operation &o) {
    switch (o.op) {
    case Op::Constant:
      o.constant = line_text_ == "1";
      if (!o.constant && line_text_ != "0")
        return fail("0 or 1 expected");
      line_text_ = {};
      return true;
    case Op::Load:
      return parse_place(o.place, OperandType::Bit);
    case Op::Not:
      return take_value(o.a) || fail("value expected");
    case Op::And:
    case Op::AndNot:
    case Op::Or:
    case Op::OrNot:
    case Op::Xor:
      return (take_value(o.a) && take(",") && take_value(o.b)) || fail("two values expected");
    case Op::Rising:
    case Op::Falling:
    case Op::Pulse:
    case Op::Store:
      return parse_place(o.place, OperandType::Bit) && ((take(",") && take_value(o.a)) || fail("value expected"));
    case Op::Set:
    case Op::Reset:
      return parse_place(o.place, OperandType::Bit) && ((take("if") && take_value(o.a)) || fail("condition expected"));
    case Op::Test:
    case Op::Call:
    case Op::Run:
      return parse_call(o);
    case Op::Active:
    case Op::Leave:
    case Op::Return:
    case Op::EndScan:
      return true;
    default:
      return parse_flow(o);
    }
  }

  /// `if %a`, or nothing where the operation is unconditional.
  bool parse_condition(Operation &o) { return !take("if") || take_value(o.a) || fail("condition expected"); }
  bool parse_number(std::uint32_t &number) { return !take_word().getAsInteger(10, number) || fail("number expected"); }

  bool parse_flow(Operation &o) {
    llvm::SmallVector<llvm::StringRef> places;
    switch (o.op) {
    case Op::Label:
      return parse_place(o.place, OperandType::Label);
    case Op::Jump:
    case Op::Gosub:
      return parse_place(o.place, OperandType::Label) && parse_condition(o);
    case Op::Transfer:
      if (!parse_place(o.place, OperandType::Bit) || !parse_condition(o) || !take_list(places))
        return fail("states expected");
      return parse_places(o, places, OperandType::Bit);
    case Op::Loop:
      if (!parse_number(o.target) || !take_list(places))
        return fail("count expected");
      return parse_places(o, places, OperandType::Word);
    case Op::Next:
      return parse_number(o.target);
    case Op::Enter:
      return parse_number(o.target) && parse_place(o.place, OperandType::Bit) && ((take(",") && take_value(o.a)) || fail("value expected"));
    default:
      return false;
    }
  }

  bool parse_places(Operation &o, llvm::ArrayRef<llvm::StringRef> words, OperandType type) {
    return llvm::all_of(words, [&](llvm::StringRef word) { return parse_place(word, o.inputs.emplace_back(), type); });
  }

  bool parse_call(Operation &o) {
    std::string form;
    if (take("\"")) {
      form = line_text_.take_until([](char c) { return c == '"'; }).str();
      line_text_ = line_text_.drop_front(std::min(form.size() + 1, line_text_.size())).ltrim();
    } else {
      form = take_word().str();
    }
    if ((take("if") || take("with")) && !take_value(o.a))
      return fail("condition expected");
    llvm::SmallVector<llvm::StringRef> inputs, outputs;
    if (!take_list(inputs) || (take("->") && !take_list(outputs)))
      return fail("operand list expected");
    if (take("at") && take_word().getAsInteger(10, o.step))
      return fail("step number expected");
    for (const InstructionInfo &info : module_.family->instructions)
      if (!o.info && info.form == form && fits(info, info.inputs, inputs) && fits(info, info.outputs, outputs))
        o.info = &info;
    if (!o.info)
      return fail("no such instruction form");
    auto parse_operands = [&](auto &words, llvm::ArrayRef<std::uint8_t> indexes, llvm::SmallVectorImpl<Place> &places) {
      for (const auto &[word, index] : llvm::zip_equal(words, indexes)) {
        const OperandInfo &operand = o.info->operands[index];
        if (!parse_place(word, places.emplace_back(), operand.type))
          return false;
        places.back().count = operand.count;
        places.back().wide_index = o.info->wide;
      }
      return true;
    };
    return parse_operands(inputs, o.info->inputs, o.inputs) && parse_operands(outputs, o.info->outputs, o.outputs);
  }

  /// True where the table entry takes those places at those operands: one form can have entries for words and for timers.
  bool fits(const InstructionInfo &info, llvm::ArrayRef<std::uint8_t> operands, llvm::ArrayRef<llvm::StringRef> words) const {
    if (operands.size() != words.size())
      return false;
    for (const auto &[index, word] : llvm::zip_equal(operands, words)) {
      const Operand place = parse_operand(*module_.family, word, {});
      if (place.kind == OperandKind::Device && !contains(info.operands[index].devices, place.device))
        return false;
    }
    return true;
  }

  bool parse_place(Place &place, OperandType type) {
    return parse_place(line_text_.take_while([](char c) { return c != ',' && c != ' '; }), place, type, true);
  }

  bool parse_place(llvm::StringRef word, Place &place, OperandType type, bool consume = false) {
    if (consume)
      line_text_ = line_text_.drop_front(word.size()).ltrim();
    place.type = type;
    for (auto [prefix, kind] :
         {std::pair{llvm::StringRef("edge"), PlaceKind::Edge},
          {llvm::StringRef("master"), PlaceKind::Master},
          {llvm::StringRef("skip"), PlaceKind::Label}})
      if (word.starts_with(prefix)) {
        place.kind = kind;
        if (word.drop_front(prefix.size()).getAsInteger(10, place.number))
          return fail("number expected");
        place.number += kind == PlaceKind::Label ? kHiddenLabel : 0;
        return true;
      }
    if (word.starts_with("text")) {
      place.kind = PlaceKind::Text;
      return !word.drop_front(4).getAsInteger(10, place.value) || fail("number expected");
    }
    if (!word.getAsInteger(10, place.value)) {
      place.kind = PlaceKind::Decimal;
      return true;
    }
    const Operand operand = parse_operand(*module_.family, word, {});
    if (operand.kind == OperandKind::Invalid)
      return fail(fmt::format("'{}' is no place", word.str()));
    place = to_place(operand, type);
    return true;
  }

  bool take(llvm::StringRef token) {
    if (!line_text_.starts_with(token))
      return false;
    const llvm::StringRef rest = line_text_.drop_front(token.size());
    if (llvm::isAlpha(token.back()) && !rest.empty() && rest.front() != ' ')
      return false;
    line_text_ = rest.ltrim();
    return true;
  }

  llvm::StringRef take_word() {
    const llvm::StringRef word = line_text_.take_until([](char c) { return c == ' '; });
    line_text_ = line_text_.drop_front(word.size()).ltrim();
    return word;
  }

  bool take_value(ValueId &value) {
    if (!line_text_.starts_with("%"))
      return false;
    const llvm::StringRef digits = line_text_.drop_front().take_while(llvm::isDigit);
    line_text_ = line_text_.drop_front(1 + digits.size()).ltrim();
    return !digits.getAsInteger(10, value) && value < kMaxValues;
  }

  bool take_list(llvm::SmallVectorImpl<llvm::StringRef> &items) {
    if (!take("("))
      return false;
    const std::size_t end = line_text_.find(')');
    if (end == llvm::StringRef::npos)
      return false;
    line_text_.take_front(end).split(items, ',', -1, false);
    for (llvm::StringRef &item : items)
      item = item.trim();
    line_text_ = line_text_.drop_front(end + 1).ltrim();
    return true;
  }

  static std::optional<Op> find(llvm::StringRef word) {
    for (unsigned i = 0; i <= static_cast<unsigned>(Op::EndScan); ++i)
      if (name(static_cast<Op>(i)) == word)
        return static_cast<Op>(i);
    return std::nullopt;
  }

  Module &module_;
  std::string &error_;
  llvm::StringRef line_text_;
  unsigned line_ = 0;
  bool open_ = false;
};

/// What a whole device is in a position of that type.
PlaceKind kind_of(OperandType type) {
  switch (type) {
  case OperandType::Bit:
  case OperandType::BitRun:
  case OperandType::BitTarget:
    return PlaceKind::Bit;
  case OperandType::Timer:
  case OperandType::Counter:
  case OperandType::LongCounter:
  case OperandType::Annunciator:
    return PlaceKind::Object;
  case OperandType::Label:
    return PlaceKind::Label;
  default:
    return PlaceKind::Word;
  }
}

}  // namespace

Place to_place(const Operand &operand, OperandType type) {
  Place p;
  p.type = type;
  p.device = operand.device;
  p.number = static_cast<std::uint32_t>(operand.value);
  p.digits = operand.digits;
  p.bit = operand.bit;
  p.index = operand.index;
  p.index_number = operand.index_number;
  switch (operand.kind) {
  case OperandKind::BitOfWord:
    p.kind = PlaceKind::WordBit;
    break;
  case OperandKind::Digits:
    p.kind = PlaceKind::Digits;
    break;
  case OperandKind::Text:
    p.kind = PlaceKind::Text;
    p.number = 0;
    p.value = operand.value;
    break;
  case OperandKind::Decimal:
  case OperandKind::Hexadecimal:
    p.kind = operand.kind == OperandKind::Decimal ? PlaceKind::Decimal : PlaceKind::Hex;
    p.number = 0;
    // A pattern with the top bit set is a negative number of the operand's width.
    p.value = type == OperandType::DWord || type == OperandType::Real ? static_cast<std::int32_t>(operand.value)
                                                                      : static_cast<std::int16_t>(operand.value);
    break;
  default:
    p.kind = kind_of(type);
  }
  return p;
}

Place to_place(const Operand &operand, const OperandInfo &info) {
  Place p = to_place(operand, info.type);
  p.count = info.count;
  return p;
}

bool parse(llvm::StringRef text, Module &module, std::string &error) {
  return Parser(module, error).run(text);
}

}  // namespace ladderc::ir
