// What holds for the records of every family.
#include "tables/tables.h"

#include "llvm/ADT/STLExtras.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

using namespace ladderc;

namespace {

template <typename Check> void for_each_instruction(Check check) {
  for (const FamilyInfo &family : families())
    for (const InstructionInfo &info : family.instructions) {
      SCOPED_TRACE(family.id.str() + ": " + info.form.str());
      check(family, info);
    }
}

TEST(Records, HaveAllTexts) {
  for_each_instruction([](const FamilyInfo &, const InstructionInfo &info) {
    for (llvm::StringRef text :
         {info.form, info.spelling, info.mnemonic, info.title, info.description, info.category, info.section})
      EXPECT_FALSE(text.empty());
  });
}

TEST(Records, ShowThemselvesInTheirExample) {
  for_each_instruction([](const FamilyInfo &, const InstructionInfo &info) {
    bool shown = false;
    llvm::SmallVector<llvm::StringRef> lines;
    info.example.split(lines, '\n');
    for (llvm::StringRef line : lines)
      shown |= info.placement == Placement::Label  // written as the word of its operand
                   ? line.starts_with(info.spelling) && line.count(' ') == 0
                   : line.split(' ').first == info.spelling && static_cast<std::size_t>(line.count(' ')) == info.operands.size();
    EXPECT_TRUE(shown) << info.example.str();
    EXPECT_EQ(lines.back(), "END");
  });
}

TEST(Records, SpellingIsTheFirstWordOfTheForm) {
  for_each_instruction(
      [](const FamilyInfo &, const InstructionInfo &info) { EXPECT_EQ(info.spelling, info.form.split(' ').first); });
}

/// True where one operand as written can stand in both positions.
bool overlap(const OperandInfo &a, const OperandInfo &b) {
  if (a.last != 0 && b.last != 0 && (a.last < b.first || b.last < a.first))
    return false;
  return (a.devices & b.devices) || (a.word_bits & b.word_bits) || (a.digits & b.digits) || (a.decimal && b.decimal) ||
         (a.hexadecimal && b.hexadecimal);
}

TEST(Records, OperandsChooseTheEntry) {
  for_each_instruction([](const FamilyInfo &family, const InstructionInfo &info) {
    for (const InstructionInfo *other : find_instructions(family, info.spelling)) {
      if (other == &info || other->operands.size() != info.operands.size())
        continue;
      bool all = true;
      for (auto [a, b] : llvm::zip(info.operands, other->operands))
        all &= overlap(a, b);
      EXPECT_FALSE(all) << "an operand list fits this entry and another of '" << info.spelling.str() << "'";
    }
  });
}

TEST(Records, IndexesNameOperandsOfTheRightDirection) {
  for_each_instruction([](const FamilyInfo &, const InstructionInfo &info) {
    for (std::uint8_t index : info.outputs) {
      ASSERT_LT(index, info.operands.size());
      EXPECT_NE(info.operands[index].dir, Direction::In);
    }
    for (std::uint8_t index : info.inputs) {
      ASSERT_LT(index, info.operands.size());
      const OperandInfo &operand = info.operands[index];
      EXPECT_TRUE(operand.dir != Direction::Out || operand.type == OperandType::WordBlock ||
                  operand.type == OperandType::DWordBlock || operand.type == OperandType::BitRun);
    }
  });
}

TEST(Records, ConstantsAreNotWritten) {
  for_each_instruction([](const FamilyInfo &, const InstructionInfo &info) {
    for (const OperandInfo &operand : info.operands) {
      if (operand.decimal || operand.hexadecimal) {
        EXPECT_EQ(operand.dir, Direction::In) << operand.name.str();
        EXPECT_LT(operand.min, operand.max) << operand.name.str();
      }
    }
  });
}

TEST(Records, OnlyStatusAndMemoryCallsCanFail) {
  for_each_instruction([](const FamilyInfo &family, const InstructionInfo &info) {
    if (info.style != CallStyle::Memory) {
      EXPECT_EQ(info.style == CallStyle::Status, info.error_code != 0);
    }
    if (info.error_code != 0) {
      EXPECT_NE(find_error(family, info.error_code), nullptr);
    }
    // Each line of the reference begins with a code.
    llvm::SmallVector<llvm::StringRef> lines;
    info.errors.split(lines, '\n', -1, false);
    for (llvm::StringRef line : lines) {
      std::uint16_t code = 0;
      EXPECT_FALSE(line.take_until([](char c) { return c == ':' || c == '-'; }).getAsInteger(10, code)) << line.str();
      EXPECT_NE(find_error(family, code), nullptr) << line.str();
    }
  });
}

TEST(Records, DeviceSetsHoldTheirOwnKinds) {
  for_each_instruction([](const FamilyInfo &family, const InstructionInfo &info) {
    for (const OperandInfo &operand : info.operands)
      for (std::size_t id = 0; id < 64; ++id) {
        auto device = static_cast<DeviceId>(id);
        if (contains(operand.devices | operand.word_bits | operand.digits, device)) {
          ASSERT_LT(id, family.devices.size());
        }
        if (contains(operand.digits, device)) {
          EXPECT_EQ(family.devices[id].kind, DeviceKind::Bit);
        }
        if (contains(operand.word_bits, device)) {
          EXPECT_TRUE(family.devices[id].bit_of_word);
        }
      }
  });
}

std::string runtime_headers() {
  std::string text;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(LADDERC_SOURCE_DIR "/runtime/include/ladder"))
    if (entry.is_regular_file()) {
      std::ifstream file(entry.path());
      text.append(std::istreambuf_iterator<char>(file), {});
    }
  return text;
}

TEST(Records, FunctionsAreInTheRuntime) {
  const std::string headers = runtime_headers();
  for_each_instruction([&](const FamilyInfo &, const InstructionInfo &info) {
    if (info.function.empty())
      return;
    // A memory is a type: a structure, or a template by another name.
    const std::string name = info.function.str();
    const bool found = info.style == CallStyle::Memory ? headers.find("struct " + name + " ") != std::string::npos ||
                                                             headers.find("class " + name + " ") != std::string::npos ||
                                                             headers.find("using " + name + " ") != std::string::npos
                                                       : headers.find(" " + name + "(") != std::string::npos;
    EXPECT_TRUE(found) << name;
  });
}

TEST(Records, MemoryOrderIsAnOrder) {
  for (const FamilyInfo &family : families()) {
    std::set<int> places;
    for (const DeviceInfo &device : family.devices) {
      if (device.memory_order != 0) {
        EXPECT_TRUE(places.insert(device.memory_order).second) << device.prefix.str();
      }
    }
  }
}

TEST(Records, SpecialDevicesAreDevicesOfTheFamily) {
  for (const FamilyInfo &family : families())
    for (const SpecialInfo &special : family.specials) {
      llvm::StringRef prefix = special.device.take_until([](char c) { return c >= '0' && c <= '9'; });
      EXPECT_NE(find_device(family, prefix), kNoDevice) << special.device.str();
      EXPECT_FALSE(special.name.empty() || special.behaviour.empty() || special.section.empty()) << special.device.str();
    }
}

}  // namespace
