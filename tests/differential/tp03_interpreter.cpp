// A list executed instruction by instruction. What a dead bus means is decided at outputs; contacts are worked out everywhere.
#include "tp03_interpreter.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringRef.h"

#include <algorithm>

namespace ladderc::differential {

namespace {

const std::set<std::string> kSequence = {"LD",  "LDI", "LDP", "LDF", "AND",  "ANI",  "ANDP",  "ANDF", "OR",   "ORI",  "ORP",
                                         "ORF", "ANB", "ORB", "MPS", "MRD",  "MPP",  "INV",   "NOP",  "OUT",  "OUTI", "SET",
                                         "RST", "PLS", "PLF", "MC",  "MCR",  "SMCS", "SMCR",  "JCS",  "JCR",  "STL",  "RET",
                                         "CJ",  "CJP", "P",   "FOR", "NEXT", "CALL", "CALLP", "SRET", "FEND", "END"};
const std::set<std::string> kWords = {"MOV", "CML",  "XCH", "ADD",  "SUB", "MUL", "DIV", "INC", "DEC",
                                      "NEG", "WAND", "WOR", "WXOR", "BCD", "BIN", "CMP", "ZCP"};

bool is_word(llvm::StringRef name) {
  if (name == "ALT" || name == "ALTP")
    return true;
  for (const std::string &word : kWords)
    for (const llvm::StringRef front : {"", "D"})
      for (const llvm::StringRef back : {"", "P"})
        if (name == front.str() + word + back.str())
          return true;
  return false;
}

/// "DLD>=": the join, the width and the sign.
struct Comparison {
  char join;
  bool wide;
  std::string sign;
};
std::optional<Comparison> comparison(llvm::StringRef name) {
  const std::size_t at = name.find_first_of("=<>");
  if (at == llvm::StringRef::npos)
    return std::nullopt;
  llvm::StringRef word = name.take_front(at);
  const bool wide = word.consume_front("D");
  if (word != "LD" && word != "AND" && word != "OR")
    return std::nullopt;
  return Comparison{word.front(), wide, name.drop_front(at).str()};
}

bool compare(const std::string &sign, std::int64_t a, std::int64_t b) {
  return sign == "=" ? a == b : sign == "<>" ? a != b : sign == ">" ? a > b : sign == "<" ? a < b : sign == ">=" ? a >= b : a <= b;
}

constexpr std::int64_t kFirstHighSpeed = 235;
/// T192-T199 keep time where their coil is skipped; this machine does not know how.
bool is_routine_timer(std::int64_t timer) {
  return timer >= 192 && timer <= 199;
}

}  // namespace

bool is_system_class(const FamilyInfo &family, DeviceId id) {
  constexpr std::uint32_t kSpecial = 8000;
  return family.devices[id].first == kSpecial;
}

bool Tp03Interpreter::knows_instruction(const InstructionInfo &info) {
  const std::string name = info.spelling.str();
  const bool high_speed = name == "OUT" && info.operands[0].first == kFirstHighSpeed;
  return !high_speed && (kSequence.count(name) || comparison(name) || is_word(name));
}

bool Tp03Interpreter::knows(const CheckedProgram &program) {
  const FamilyInfo &family = *program.family;
  return llvm::all_of(program.list.instructions, [&](const Instruction &i) {
    return i.info && knows_instruction(*i.info) && llvm::none_of(program.list.operands_of(i), [&](const Operand &o) {
             const bool timer = o.device != kNoDevice && family.devices[o.device].prefix == "T" && is_routine_timer(o.value);
             const bool label = o.device != kNoDevice && family.devices[o.device].prefix == "P" && o.index != kNoDevice;
             return label || (o.device != kNoDevice && is_system_class(family, o.device)) || (timer && i.info->spelling == "OUT");
           });
  });
}

Tp03Interpreter::Tp03Interpreter(const CheckedProgram &program)
    : program_(program), family_(*program.family), arrays_(family_.devices.size()), edges_(program.list.instructions.size()),
      states_(find_device(family_, "S")) {
  for (DeviceId id = 0; id < family_.devices.size(); ++id) {
    const llvm::StringRef prefix = family_.devices[id].prefix;
    const std::uint32_t points = program.parameters.points[id];
    const bool counter = prefix == "C", wide = counter && family_.devices[id].first == 200, parts = counter || prefix == "T";
    if (parts || prefix == "X" || prefix == "Y" || prefix == "M" || prefix == "S")
      arrays_[id].on.resize(points);
    if (parts)
      arrays_[id].coil.resize(points);
    if (wide)
      arrays_[id].wide.resize(points);
    else if (parts || prefix == "D" || prefix == "V" || prefix == "Z")
      arrays_[id].value.resize(points);
  }
  for (const Instruction &i : program.list.instructions)
    names_.push_back(i.info->spelling.str());
  find_structure();
}

void Tp03Interpreter::find_structure() {
  const std::size_t count = names_.size();
  ranges_.resize(count);
  range_on_.resize(count);
  partner_.assign(count, kNowhere);
  region_of_.assign(count, -1);
  std::vector<std::size_t> open, skips, loops;
  int region = -1;
  for (std::size_t i = 0; i < count; ++i) {
    if (name(i) == "MCR")
      std::erase_if(open, [&](std::size_t k) { return name(k) == "MC" && operands(k)[0].value >= operands(i)[0].value; });
    if (name(i) == "SMCR")
      std::erase_if(open, [&](std::size_t k) { return name(k) == "SMCS"; });
    ranges_[i] = open;
    if (name(i) == "MC" || name(i) == "SMCS")
      open.push_back(i);
    if (name(i) == "JCS")
      skips.push_back(i);
    if (name(i) == "JCR") {
      for (std::size_t k : skips)
        partner_[k] = i;
      skips.clear();
    }
    if (name(i) == "FOR")
      loops.push_back(i);
    if (name(i) == "NEXT") {
      partner_[i] = loops.back();
      partner_[loops.back()] = i;
      loops.pop_back();
    }
    if (name(i) == "P")
      labels_[operands(i)[0].value] = i;
    if (name(i) == "STL") {
      first_stl_ = std::min(first_stl_, i);
      const bool merges = region >= 0 && regions_.back().body == i;
      if (!merges) {
        if (region >= 0)
          regions_.back().end = i;
        region = static_cast<int>(regions_.size());
        regions_.push_back({i + 1, count, {}});
      }
      regions_.back().states.push_back(static_cast<std::uint32_t>(operands(i)[0].value));
      regions_.back().body = i + 1;
    } else if (name(i) == "RET" && region >= 0) {
      regions_.back().end = i;
      region = -1;
    }
    region_of_[i] = region;
  }
}

void Tp03Interpreter::power_on() {
  for (DeviceId id = 0; id < arrays_.size(); ++id)
    clear_unlatched(arrays_[id], id, family_, program_.parameters);
  forget_unlatched();
  running_ = stopped_ = false;
  set_run(true);
}

void Tp03Interpreter::set_run(bool run) {
  if (run && !running_) {
    std::fill(edges_.begin(), edges_.end(), 0);
    for (Region &region : regions_)
      region.was_on = false;
    left_.clear();
    leave_due_ = false;
    first_scan_ = true;
  }
  if (!run && running_) {
    for (DeviceId id = 0; id < arrays_.size(); ++id)
      if (family_.devices[id].prefix != "V" && family_.devices[id].prefix != "Z")
        clear_unlatched(arrays_[id], id, family_, program_.parameters);
    forget_unlatched();
  }
  running_ = run;
}

/// What timers and counters have beside their devices.
void Tp03Interpreter::forget_unlatched() {
  auto latched = [&](DeviceId id, std::int64_t number) {
    return llvm::any_of(program_.parameters.latched,
                        [&](const DeviceRange &r) { return r.device == id && r.first <= number && number <= r.last; });
  };
  const DeviceId t = find_device(family_, "T");
  std::erase_if(timers_, [&](const auto &timer) { return !latched(t, timer.first); });
  std::erase_if(reset_coils_, [&](const auto &coil) { return !latched(coil.first.first, coil.first.second); });
}

void Tp03Interpreter::scan(std::uint32_t now_us) {
  elapsed_us_ = first_scan_ ? 0 : now_us - last_us_;
  last_us_ = now_us;
  if (!running_ || stopped_)
    return;
  ++scan_;
  jumps_back_ = 0;
  leave_due_ = !left_.empty() || leave_due_;
  for (std::uint32_t state : left_)
    arrays_[states_].on[state] = 0;
  left_.clear();
  const DeviceId t = find_device(family_, "T");
  for (std::int64_t n = 246; n <= 249; ++n)
    if (arrays_[t].coil[static_cast<std::size_t>(n)]) {
      Operand timer;
      timer.device = t;
      timer.value = n;
      advance(timer, elapsed_us_, false);
    }
  (void)run(0, names_.size(), false);
  first_scan_ = false;
}

bool Tp03Interpreter::edge(std::size_t i, char kind, bool now) {
  const bool before = edges_[i];
  edges_[i] = now;
  return kind == 'P' ? now && !before : !now && before;
}

bool Tp03Interpreter::bus(std::size_t i) const {
  for (std::size_t opener : ranges_[i])
    if (!range_on_[opener])
      return false;
  return region_of_[i] < 0 || regions_[static_cast<std::size_t>(region_of_[i])].on;
}

// ---------------------------------------------------------------------------------------------- flow

bool Tp03Interpreter::run(std::size_t pc, std::size_t end, bool routine) {
  std::vector<LoopState> loops;
  while (pc < end) {
    const std::string &what = name(pc);
    if (const std::uint32_t rung = program_.list.instructions[pc].rung; rung != result_.rung)
      result_ = {{}, {}, rung};
    if (what == "END" || what == "FEND")
      return false;
    if (what == "SRET" && routine)
      return true;
    if (what == "STL") {
      pc = enter_region(pc);
      continue;
    }
    if (what == "JCS" && condition(pc)) {
      pc = partner_[pc];
      continue;
    }
    if (what == "FOR") {
      loops.push_back({pc, partner_[pc], std::max<std::int64_t>(read(operands(pc)[0], 1), 1)});
    } else if (what == "NEXT") {
      if (--loops.back().left > 0) {
        pc = loops.back().begin + 1;
        continue;
      }
      loops.pop_back();
    } else if (what == "CJ" || what == "CJP") {
      const std::size_t target = take_jump(pc, loops);
      if (target == kNowhere)
        return false;
      pc = target;
      continue;
    } else if (what == "CALL" || what == "CALLP") {
      const bool on = what == "CALL" ? condition(pc) : edge(pc, 'P', condition(pc)) && !first_scan_;
      const Result kept = result_;
      if (on && !run(labels_.at(operands(pc)[0].value), names_.size(), true))
        return false;
      result_ = kept;
    } else if (!sequence(pc, what)) {
      output(pc, what);
    }
    ++pc;
  }
  return true;
}

/// Where CJ goes on; kNowhere: END. A loop without end stops the CPU, as the watchdog does, until power comes on again.
std::size_t Tp03Interpreter::take_jump(std::size_t i, std::vector<LoopState> &loops) {
  const bool on = name(i) == "CJ" ? condition(i) : edge(i, 'P', condition(i)) && !first_scan_;
  if (!on)
    return i + 1;
  constexpr std::int64_t kEnd = 63;
  if (operands(i)[0].value == kEnd)
    return kNowhere;
  const std::size_t target = labels_.at(operands(i)[0].value);
  constexpr unsigned kMostJumpsBack = 100'000;
  if (target < i && ++jumps_back_ > kMostJumpsBack) {
    stopped_ = true;
    return kNowhere;
  }
  while (!loops.empty() && (target < loops.back().begin || target > loops.back().end))
    loops.pop_back();
  return target;
}

/// States that a transfer has left switch off what they drove where the first STL stands. Returns where to go on.
std::size_t Tp03Interpreter::enter_region(std::size_t i) {
  if (i == first_stl_ && std::exchange(leave_due_, false))
    leave_regions();
  Region &region = regions_[static_cast<std::size_t>(region_of_[i])];
  bool outer = true;
  for (std::size_t opener : ranges_[i])
    outer = outer && range_on_[opener];
  region.on = outer && llvm::all_of(region.states, [&](std::uint32_t s) { return arrays_[states_].on[s] != 0; });
  const bool enters = region.on || region.was_on;
  region.was_on = region.on;
  return enters ? region.body : region.end;
}

void Tp03Interpreter::leave_regions() {
  for (Region &region : regions_) {
    const bool on = llvm::all_of(region.states, [&](std::uint32_t s) { return arrays_[states_].on[s] != 0; });
    if (!region.was_on || on)
      continue;
    region.was_on = region.on = false;
    (void)run(region.body, region.end, false);
  }
}

// ---------------------------------------------------------------------------------------------- contacts

bool Tp03Interpreter::sequence(std::size_t i, const std::string &what) {
  std::vector<bool> &blocks = result_.blocks;
  auto join = [&](char how, bool on) {
    if (how == 'L')
      blocks.push_back(on);
    else
      blocks.back() = how == 'A' ? blocks.back() && on : blocks.back() || on;
  };
  if (const auto c = comparison(what)) {
    const unsigned width = c->wide ? 2 : 1;
    join(c->join, compare(c->sign, read(operands(i)[0], width), read(operands(i)[1], width)));
    return true;
  }
  if (what == "ANB" || what == "ORB") {
    const bool second = blocks.back();
    blocks.pop_back();
    join(what[0], second);
  } else if (what == "MPS")
    result_.branches.push_back(blocks.back());
  else if (what == "MRD" || what == "MPP") {
    blocks.back() = result_.branches.back();
    if (what == "MPP")
      result_.branches.pop_back();
  } else if (what == "INV")
    blocks.back() = !blocks.back();
  else if (const llvm::StringRef text = what;
           text.size() <= 4 &&
           (text.starts_with("LD") || text.starts_with("AN") || text == "OR" || text == "ORI" || text == "ORP" || text == "ORF")) {
    bool on = bit(operands(i)[0]) != 0;
    const char last = what.back();
    if (what.size() > 2 && (last == 'P' || last == 'F'))
      on = edge(i, last, on);
    else if (last == 'I')
      on = !on;
    join(what[0], on);
  } else
    return false;
  return true;
}

// ---------------------------------------------------------------------------------------------- outputs

void Tp03Interpreter::output(std::size_t i, const std::string &what) {
  static const std::set<std::string> nothing = {"NOP", "MCR", "SMCR", "JCS", "JCR", "RET", "P", "SRET"};
  if (nothing.count(what))
    return;
  const bool on = condition(i);
  if (what == "OUT")
    drive(i);
  else if (what == "OUTI")
    bit(operands(i)[0]) = bus(i) && !on;
  else if (what == "SET" || what == "RST")
    set_or_reset(i, what == "SET");
  else if (what == "PLS" || what == "PLF")
    bit(operands(i)[0]) = edge(i, what[2] == 'S' ? 'P' : 'F', on);
  else if (what == "MC") {
    bit(operands(i)[1]) = on;
    range_on_[i] = on;
  } else if (what == "SMCS")
    range_on_[i] = on;
  else
    word(i, what);
}

void Tp03Interpreter::drive(std::size_t i) {
  const llvm::ArrayRef<Operand> o = operands(i);
  const llvm::StringRef prefix = family_.devices[o[0].device].prefix;
  const bool on = condition(i);
  if (prefix == "T")
    drive_timer(o[0], read(o[1], 1), on);
  else if (prefix == "C")
    drive_counter(i, o[0], read(o[1], arrays_[o[0].device].wide.empty() ? 1 : 2), on);
  else if (o[0].device == states_ && region_of_[i] >= 0) {
    if (on)
      transfer(i);
  } else
    bit(o[0]) = on;
}

void Tp03Interpreter::set_or_reset(std::size_t i, bool set) {
  const Operand &o = operands(i)[0];
  const llvm::StringRef prefix = family_.devices[o.device].prefix;
  const bool on = condition(i);
  if (!set && prefix == "C")
    return reset_counter(o, on);
  if (!on)
    return;
  if (set && o.device == states_ && region_of_[i] >= 0)
    return transfer(i);
  DeviceArray &a = arrays_[o.device];
  if (!a.on.empty())
    a.on[place(o)] = set;
  if (!a.value.empty())
    a.value[place(o)] = 0;
  if (prefix == "T") {
    a.coil[place(o)] = 0;
    timers_[o.value].rest_us = 0;
  }
}

void Tp03Interpreter::transfer(std::size_t i) {
  const auto target = static_cast<std::uint32_t>(operands(i)[0].value);
  const Region &region = regions_[static_cast<std::size_t>(region_of_[i])];
  arrays_[states_].on[target] = 1;
  if (llvm::is_contained(region.states, target))
    return;
  left_.erase(target);
  left_.insert(region.states.begin(), region.states.end());
}

}  // namespace ladderc::differential
