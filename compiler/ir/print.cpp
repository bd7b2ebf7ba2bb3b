// The text form of the IR.
#include "ir/extent.h"
#include "ir/ir.h"

#include "llvm/ADT/StringExtras.h"

#include <fmt/format.h>

namespace ladderc::ir {

namespace {

std::string number_text(const DeviceInfo &device, std::uint32_t number) {
  if (device.radix == 16)
    return fmt::format("{:X}", number);
  if (device.radix == 8)
    return fmt::format("{:o}", number);
  return fmt::format("{}", number);
}

std::uint64_t mask_of(OperandType type) {
  const std::uint32_t words = words_of(type);
  return words >= 4 ? ~std::uint64_t{0} : (std::uint64_t{1} << (16 * words)) - 1;
}

std::string list_of(const Module &module, llvm::ArrayRef<Place> places) {
  std::string text = "(";
  for (const Place &p : places) {
    if (text.size() > 1)
      text += ", ";
    text += to_text(module, p);
  }
  return text + ")";
}

std::string condition_of(const Operation &o) {
  return o.a == kNoValue ? "" : fmt::format(" if %{}", o.a);
}

std::string callee(const InstructionInfo *entry) {
  if (!entry)
    return "?";  // broken IR, in a message of the verifier
  const InstructionInfo &info = *entry;
  return info.form.contains(' ') ? fmt::format("\"{}\"", info.form.str()) : info.form.str();
}

}  // namespace

static std::string plain_text(const Module &module, const Place &place);

std::string to_text(const Module &module, const Place &place) {
  std::string text = plain_text(module, place);
  if (place.is_indexed()) {
    if (place.kind == PlaceKind::Decimal)
      text = "K" + text;
    text += fmt::format("{}{}", module.family->devices[place.index].prefix.str(), unsigned(place.index_number));
  }
  return text;
}

static std::string plain_text(const Module &module, const Place &place) {
  switch (place.kind) {
  case PlaceKind::Decimal:
    return fmt::format("{}", place.value);
  case PlaceKind::Hex:
    return fmt::format("H{:X}", static_cast<std::uint64_t>(place.value) & mask_of(place.type));
  case PlaceKind::Edge:
    return fmt::format("edge{}", place.number);
  case PlaceKind::Master:
    return fmt::format("master{}", place.number);
  case PlaceKind::Text:
    return fmt::format("text{}", place.value);
  case PlaceKind::Label:
    if (place.number >= kHiddenLabel)
      return fmt::format("skip{}", place.number - kHiddenLabel);
    break;
  default:
    break;
  }
  if (place.device >= module.family->devices.size())
    return "?";  // broken IR, in a message of the verifier
  const DeviceInfo &device = module.family->devices[place.device];
  std::string digits = number_text(device, place.number);
  if (digits.size() < device.name_digits)
    digits.insert(0, device.name_digits - digits.size(), '0');
  std::string text = device.prefix.str() + digits;
  if (place.kind == PlaceKind::WordBit)
    return fmt::format("{}.{:X}", text, place.bit);
  if (place.kind == PlaceKind::Digits)
    return fmt::format("K{}{}", place.digits, text);
  return text;
}

std::string to_text(const Module &module, const Operation &o) {
  std::string text;
  if (is_value(o.op))
    text = fmt::format("%{} = ", o.result);
  text += name(o.op).str();
  switch (o.op) {
  case Op::Constant:
    return text + (o.constant ? " 1" : " 0");
  case Op::Load:
    return text + " " + to_text(module, o.place);
  case Op::Not:
    return text + fmt::format(" %{}", o.a);
  case Op::And:
  case Op::AndNot:
  case Op::Or:
  case Op::OrNot:
  case Op::Xor:
    return text + fmt::format(" %{}, %{}", o.a, o.b);
  case Op::Rising:
  case Op::Falling:
  case Op::Pulse:
  case Op::Store:
    return text + fmt::format(" {}, %{}", to_text(module, o.place), o.a);
  case Op::Set:
  case Op::Reset:
    return text + fmt::format(" {} if %{}", to_text(module, o.place), o.a);
  case Op::Test:
    return text + fmt::format(" {} {}", callee(o.info), list_of(module, o.inputs));
  case Op::Call:
  case Op::Run:
    text += " " + callee(o.info);
    if (o.a != kNoValue)
      text += fmt::format(" {} %{}", o.op == Op::Run ? "with" : "if", o.a);
    text += " " + list_of(module, o.inputs);
    if (!o.outputs.empty())
      text += " -> " + list_of(module, o.outputs);
    if (tells_step(o))
      text += fmt::format(" at {}", o.step);
    return text;
  case Op::Label:
    return text + " " + to_text(module, o.place);
  case Op::Jump:
  case Op::Gosub:
    return text + " " + to_text(module, o.place) + condition_of(o);
  case Op::Transfer:
    return text + " " + to_text(module, o.place) + condition_of(o) + " " + list_of(module, o.inputs);
  case Op::Loop:
    return text + fmt::format(" {} {}", o.target, list_of(module, o.inputs));
  case Op::Next:
    return text + fmt::format(" {}", o.target);
  case Op::Enter:
    return text + fmt::format(" {} {}, %{}", o.target, to_text(module, o.place), o.a);
  case Op::Active:
  case Op::Leave:
  case Op::Return:
  case Op::EndScan:
    return text;
  }
  return text;
}

static void print_head(const Module &module, const Routine &routine, llvm::raw_ostream &out) {
  out << "routine " << routine.name;
  if (routine.kind == RoutineKind::Subroutine || routine.kind == RoutineKind::Interrupt)
    out << (routine.kind == RoutineKind::Subroutine ? " call " : " on ") << routine.name;
  if (routine.kind == RoutineKind::State)
    out << " state " << to_text(module, routine.memory) << " " << list_of(module, routine.states);
  out << " {\n";
}

void print(const Module &module, const SourceSet &sources, llvm::raw_ostream &out) {
  for (std::size_t id = 0; id < module.points.size(); ++id)
    if (const DeviceInfo &device = module.family->devices[id]; module.points[id] != device.points)
      out << "points " << device.prefix << " " << module.points[id] << "\n";
  if (!module.edges.empty()) {
    out << "edges";
    for (std::size_t i = 0; i < module.edges.size(); ++i)
      out << (i ? ", " : " ") << module.edges[i].step;
    out << "\n";
  }
  if (module.master_levels)
    out << "levels " << module.master_levels << "\n";
  if (module.loops)
    out << "loops " << module.loops << "\n";
  for (const std::string &text : module.texts)
    out << "text " << text << "\n";
  for (const Routine &routine : module.routines) {
    print_head(module, routine, out);
    for (const Rung &rung : routine.rungs) {
      out << "  rung " << rung.step;
      if (!rung.origin.empty())
        out << " " << rung.origin;
      else if (rung.range.file < sources.size())
        out << " \"" << sources[rung.range.file].name() << "\":" << sources.position(rung.range).line;
      out << "\n";
      for (const Operation &o : rung.operations)
        out << "    " << to_text(module, o) << "\n";
    }
    out << "}\n";
  }
}

}  // namespace ladderc::ir
