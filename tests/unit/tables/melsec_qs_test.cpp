// The QS tables against the instruction, device and step tables of its manual.
#include "tables/tables.h"

#include "llvm/ADT/STLExtras.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <set>
#include <string>

using namespace ladderc;

namespace {

const FamilyInfo &qs() {
  return *find_family("melsec-qs");
}

/// The entry of that form with that many operands.
const InstructionInfo &entry(llvm::StringRef form, std::size_t operands) {
  for (const InstructionInfo &info : qs().instructions)
    if (info.form == form && info.operands.size() == operands)
      return info;
  ADD_FAILURE() << "no entry " << form.str() << " with " << operands << " operands";
  return qs().instructions.front();
}

std::string prefixes(DeviceSet set) {
  std::string text;
  for (std::size_t id = 0; id < qs().devices.size(); ++id)
    if (contains(set, static_cast<DeviceId>(id)))
      text += (text.empty() ? "" : " ") + qs().devices[id].prefix.str();
  return text;
}

std::set<std::string> expected_forms() {
  std::set<std::string> forms = {"LD",    "LDI",   "AND", "ANI", "OR",    "ORI",   "LDP",      "LDF",    "ANDP",
                                 "ANDF",  "ORP",   "ORF", "ANB", "ORB",   "MPS",   "MRD",      "MPP",    "INV",
                                 "MEP",   "MEF",   "EGP", "EGF", "OUT",   "OUT T", "OUT ST",   "OUTH T", "OUTH ST",
                                 "OUT C", "OUT F", "SET", "RST", "SET F", "RST F", "PLS",      "PLF",    "FF",
                                 "MC",    "MCR",   "END", "NOP", "NOPLF", "PAGE",  "S.QSABORT"};
  for (const char *connection : {"LD", "AND", "OR", "LDD", "ANDD", "ORD"})
    for (const char *sign : {"=", "<>", ">", "<=", "<", ">="})
      forms.insert(std::string(connection) + sign);
  for (const char *mnemonic : {"+", "-", "*", "/", "INC", "DEC", "BCD", "BIN", "NEG", "MOV", "CML"})
    for (const char *width : {"", "D"})
      for (const char *pulse : {"", "P"})
        forms.insert(std::string(width) + mnemonic + pulse);
  for (const char *mnemonic : {"BMOV", "FMOV", "WAND", "DAND", "WOR", "DOR", "WXOR", "DXOR", "WXNR", "DXNR"})
    for (const char *pulse : {"", "P"})
      forms.insert(std::string(mnemonic) + pulse);
  return forms;
}

TEST(MelsecQs, HasEveryFormOfTheManualAndNoOther) {
  std::set<std::string> forms;
  for (const InstructionInfo &info : qs().instructions)
    forms.insert(info.form.str());
  EXPECT_EQ(forms, expected_forms());
  EXPECT_EQ(forms.size(), 143u);
}

TEST(MelsecQs, FamilyFacts) {
  EXPECT_EQ(qs().header, "ladder/melsec_qs.h");
  EXPECT_EQ(qs().ns, "melsec_qs");
  EXPECT_THAT(qs().models, testing::ElementsAre(llvm::StringRef("QS001CPU")));
  EXPECT_EQ(qs().max_branches, 16);
  EXPECT_EQ(qs().max_levels, 15);
  EXPECT_FALSE(qs().has_index_registers);
  EXPECT_TRUE(qs().pairs_cross_classes);
  EXPECT_EQ(qs().end_ns, 8'200'000u);
  EXPECT_EQ(qs().io_refresh_ns, 310'000u);
  EXPECT_EQ(qs().io_refresh_point_ns, 224u);
}

TEST(MelsecQs, MemoryOrder) {
  std::vector<const DeviceInfo *> devices;
  for (const DeviceInfo &device : qs().devices)
    if (device.memory_order != 0)
      devices.push_back(&device);
  llvm::sort(devices, [](const DeviceInfo *a, const DeviceInfo *b) { return a->memory_order < b->memory_order; });
  std::string order;
  for (const DeviceInfo *device : devices)
    order += device->prefix.str() + " ";
  EXPECT_EQ(order, "SM X Y M B F SB V T ST C D W SW SD ");
}

TEST(MelsecQs, Devices) {
  auto device = [](llvm::StringRef prefix) { return qs().devices[find_device(qs(), prefix)]; };
  EXPECT_EQ(device("X").radix, 16);
  EXPECT_TRUE(device("X").external_input);
  EXPECT_EQ(device("X").points_register, 290);
  EXPECT_TRUE(device("Y").external_output);
  EXPECT_EQ(device("M").radix, 10);
  EXPECT_EQ(device("W").radix, 16);
  EXPECT_EQ(device("ST").points, 0u);
  EXPECT_EQ(device("D").points, 6144u);
  EXPECT_EQ(device("D").image, "D");
  EXPECT_EQ(device("SM").image, "sys.SM");
  EXPECT_EQ(device("SD").image, "sys.SD");
  EXPECT_EQ(device("SD").points, 5120u);
  EXPECT_EQ(device("SD").points_register, -1);
  EXPECT_EQ(device("SW").points_register, 304);
  EXPECT_EQ(device("N").kind, DeviceKind::Nesting);
}

TEST(MelsecQs, WhatOperandsTake) {
  const OperandInfo &contact = entry("LD", 1).operands[0];
  EXPECT_EQ(prefixes(contact.devices), "X Y M B F SB SM T ST C");
  EXPECT_EQ(prefixes(contact.word_bits), "D W SW SD");
  EXPECT_EQ(prefixes(contact.digits), "");
  EXPECT_EQ(prefixes(entry("OUT", 1).operands[0].devices), "X Y M B SB SM");
  EXPECT_EQ(prefixes(entry("PLS", 1).operands[0].devices), "X Y M B F SB SM");
  EXPECT_EQ(prefixes(entry("EGP", 1).operands[0].devices), "V");
  EXPECT_EQ(prefixes(entry("OUT ST", 2).operands[0].devices), "ST");
  const OperandInfo &source = entry("MOV", 2).operands[0];
  EXPECT_EQ(prefixes(source.devices), "T ST C D W SW SD");
  EXPECT_EQ(prefixes(source.digits), "X Y M B F SB SM");
  EXPECT_EQ(prefixes(source.word_bits), "");
}

TEST(MelsecQs, SetValuesAreDecimalOrRegisters) {
  for (const char *form : {"OUT T", "OUT ST", "OUTH T", "OUTH ST", "OUT C"}) {
    const OperandInfo &set = entry(form, 2).operands[1];
    EXPECT_EQ(prefixes(set.devices), "D W SW SD") << form;
    EXPECT_EQ(set.digits, 0u) << form;
    EXPECT_TRUE(set.decimal) << form;
    EXPECT_FALSE(set.hexadecimal) << form;
    EXPECT_EQ(set.min, 0) << form;
    EXPECT_EQ(set.max, 32767) << form;
  }
}

TEST(MelsecQs, ConstantsHaveTheRangeOfTheirWidth) {
  EXPECT_EQ(entry("MOV", 2).operands[0].min, -32768);
  EXPECT_EQ(entry("MOV", 2).operands[0].max, 32767);
  EXPECT_EQ(entry("DMOV", 2).operands[0].min, -2147483648LL);
  EXPECT_EQ(entry("DMOV", 2).operands[0].max, 2147483647);
  EXPECT_EQ(entry("BMOV", 3).operands[2].min, 0);
  EXPECT_FALSE(entry("BMOV", 3).operands[0].decimal);
  EXPECT_TRUE(entry("FMOV", 3).operands[0].hexadecimal);
}

TEST(MelsecQs, ThePulseFormDiffersInItsExecutionOnly) {
  for (const InstructionInfo &plain : qs().instructions) {
    if (plain.execution != Execution::WhileOn || plain.lowering != Lowering::Call || plain.spelling == "RST" || plain.stops_scan)
      continue;
    const InstructionInfo &pulse = entry(plain.form.str() + "P", plain.operands.size());
    EXPECT_EQ(pulse.execution, Execution::RisingEdge) << plain.form.str();
    EXPECT_EQ(pulse.function, plain.function);
    EXPECT_EQ(pulse.style, plain.style);
    EXPECT_EQ(pulse.inputs, plain.inputs);
    EXPECT_EQ(pulse.outputs, plain.outputs);
    EXPECT_EQ(pulse.steps, plain.steps);
    EXPECT_EQ(pulse.mnemonic, plain.mnemonic);
    for (auto [a, b] : llvm::zip_equal(plain.operands, pulse.operands)) {
      EXPECT_EQ(a.type, b.type);
      EXPECT_EQ(a.devices, b.devices);
      EXPECT_EQ(a.dir, b.dir);
    }
  }
}

TEST(MelsecQs, The32BitFormDiffersInWidthFunctionAndConstants) {
  for (const char *name : {"+", "-", "INC", "DEC", "BCD", "BIN", "NEG", "CML"}) {
    const InstructionInfo &word = *find_instructions(qs(), name).front();
    const InstructionInfo &dword = entry(std::string("D") + name, word.operands.size());
    EXPECT_EQ(dword.function.str(), "d" + word.function.str()) << name;
    EXPECT_EQ(dword.mnemonic, word.mnemonic) << name;
    for (auto [a, b] : llvm::zip_equal(word.operands, dword.operands)) {
      EXPECT_EQ(a.type, OperandType::Word) << name;
      EXPECT_EQ(b.type, OperandType::DWord) << name;
      EXPECT_EQ(a.devices, b.devices) << name;
    }
    EXPECT_EQ(word.steps_per_constant, 0) << name;
  }
}

TEST(MelsecQs, TwoOperandsAccumulateThreeCombine) {
  const InstructionInfo &two = entry("-", 2), &three = entry("-", 3);
  EXPECT_THAT(two.inputs, testing::ElementsAre(1, 0));
  EXPECT_THAT(two.outputs, testing::ElementsAre(1));
  EXPECT_EQ(two.operands[1].dir, Direction::InOut);
  EXPECT_THAT(three.inputs, testing::ElementsAre(0, 1));
  EXPECT_THAT(three.outputs, testing::ElementsAre(2));
  EXPECT_EQ(three.operands[2].dir, Direction::Out);
}

TEST(MelsecQs, WideResults) {
  EXPECT_EQ(entry("*", 3).operands[2].type, OperandType::DWord);
  EXPECT_EQ(entry("D*", 3).operands[2].type, OperandType::QWord);
  EXPECT_EQ(entry("/", 3).operands[2].type, OperandType::WordTwice);
  EXPECT_EQ(entry("D/", 3).operands[2].type, OperandType::DWordTwice);
}

TEST(MelsecQs, OperationErrors) {
  for (const char *form : {"/", "D/P", "BCD", "DBCD", "BINP", "DBIN"}) {
    const InstructionInfo &info = *find_instructions(qs(), form).front();
    EXPECT_EQ(info.error_code, 4100) << form;
    EXPECT_EQ(info.error_mask, info.mnemonic == "BIN" ? "SM722" : "") << form;
  }
  EXPECT_EQ(entry("BMOV", 3).error_code, 4101);
  EXPECT_EQ(entry("FMOVP", 3).error_code, 4101);
  EXPECT_EQ(entry("FMOV", 3).equal_digits, 1);
  EXPECT_EQ(entry("+", 3).error_code, 0);
}

TEST(MelsecQs, Steps) {
  struct Row {
    const char *form;
    std::size_t operands;
    int steps, per_constant, subset;
  };
  const Row rows[] = {
      {"LD", 1, 1, 0, 0},    {"EGP", 1, 1, 0, 0},   {"EGF", 1, 2, 0, 0},       {"OUT", 1, 1, 0, 0},   {"OUT T", 2, 4, 0, 0},
      {"OUT C", 2, 4, 0, 0}, {"OUT F", 1, 2, 0, 0}, {"SET", 1, 1, 0, 0},       {"SET F", 1, 2, 0, 0}, {"PLS", 1, 2, 0, 0},
      {"FF", 1, 2, 0, 0},    {"MC", 2, 2, 0, 0},    {"MCR", 1, 1, 0, 0},       {"END", 0, 1, 0, 0},   {"LD=", 2, 3, 0, 0},
      {"LDD=", 2, 3, 1, 0},  {"+", 2, 3, 0, 0},     {"+", 3, 4, 0, 0},         {"D+", 3, 4, 1, 0},    {"INC", 1, 2, 0, 0},
      {"MOV", 2, 3, 0, 2},   {"DMOV", 2, 3, 1, 0},  {"CMLP", 2, 3, 0, 2},      {"BMOV", 3, 4, 0, 0},  {"DBCD", 2, 3, 1, 0},
      {"WAND", 2, 3, 0, 0},  {"DXNR", 3, 4, 1, 0},  {"S.QSABORT", 1, 7, 1, 0}, {"NEG", 1, 2, 0, 0}};
  for (const Row &row : rows) {
    const InstructionInfo &info = entry(row.form, row.operands);
    EXPECT_EQ(info.steps, row.steps) << row.form;
    EXPECT_EQ(info.steps_per_constant, row.per_constant) << row.form;
    EXPECT_EQ(info.steps_subset, row.subset) << row.form;
  }
  std::multiset<int> reset;
  for (const InstructionInfo *info : find_instructions(qs(), "RST"))
    reset.insert(info->steps);
  EXPECT_EQ(reset, (std::multiset<int>{1, 2, 2, 4, 4}));  // bit, word, F, timer, counter
}

TEST(MelsecQs, Timing) {
  EXPECT_EQ(entry("LD", 1).times[0].nanoseconds, 100u);
  EXPECT_EQ(entry("LD", 1).times[1].device, "D0.0");
  EXPECT_EQ(entry("MOV", 2).times[0].nanoseconds, 350u);
  EXPECT_EQ(entry("D+", 3).times[0].nanoseconds, 750u);
  for (const InstructionInfo &info : qs().instructions)
    EXPECT_FALSE(info.times.empty()) << info.form.str();
}

TEST(MelsecQs, RungPlacesAndCoils) {
  EXPECT_EQ(entry("LD<=", 2).placement, Placement::Start);
  EXPECT_EQ(entry("ANDD<=", 2).placement, Placement::Series);
  EXPECT_EQ(entry("OR<=", 2).placement, Placement::Parallel);
  EXPECT_EQ(entry("INV", 0).placement, Placement::Series);
  EXPECT_EQ(entry("MCR", 1).placement, Placement::Alone);
  EXPECT_EQ(entry("NOPLF", 0).placement, Placement::BetweenRungs);
  std::set<std::string> driving;
  for (const InstructionInfo &info : qs().instructions)
    if (info.drives)
      driving.insert(info.form.str());
  EXPECT_THAT(driving, testing::UnorderedElementsAre("OUT", "OUT T", "OUT ST", "OUTH T", "OUTH ST", "OUT C", "OUT F", "PLS", "PLF",
                                                     "MC", "EGP", "EGF"));
}

TEST(MelsecQs, ContactsKnowTheirEdge) {
  EXPECT_EQ(entry("LD", 1).edge, Execution::EveryScan);
  EXPECT_TRUE(entry("ORI", 1).negated);
  EXPECT_EQ(entry("ANDP", 1).edge, Execution::RisingEdge);
  EXPECT_EQ(entry("ORF", 1).edge, Execution::FallingEdge);
  EXPECT_FALSE(entry("LDF", 1).negated);
}

TEST(MelsecQs, TheRuntimeKeepsTheSpecialDevicesItSimulates) {
  std::set<std::string> relays;
  std::size_t registers = 0;
  for (const SpecialInfo &special : qs().specials) {
    if (special.simulated && special.device.starts_with("SM"))
      relays.insert(special.device.str());
    registers += special.simulated && special.device.starts_with("SD");
  }
  EXPECT_THAT(relays, testing::UnorderedElementsAre("SM0", "SM1", "SM5", "SM16", "SM50", "SM56", "SM62", "SM203", "SM213", "SM400",
                                                    "SM401", "SM402", "SM403", "SM410", "SM411", "SM412", "SM413", "SM414", "SM560",
                                                    "SM660", "SM722"));
  EXPECT_EQ(registers, 28u + 1 + 18 + 1 + 4 + 13 + 3 + 6 + 1);
  EXPECT_EQ(qs().specials.size(), 144u);
}

TEST(MelsecQs, OnlySwitchesOfTheUserAreWritable) {
  std::set<std::string> writable;
  for (const SpecialInfo &special : qs().specials)
    if (special.writable)
      writable.insert(special.device.str());
  EXPECT_THAT(writable, testing::UnorderedElementsAre("SM50", "SM213", "SM722", "SD50", "SD414", "SD1076-SD1079", "SD1276-SD1279"));
}

}  // namespace
