// Image sizes, functions and files.
#include "emit/layout.h"

#include "compiled.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

std::uint32_t count(const Compiled &c, llvm::StringRef device) {
  return emit::make_layout(c.module, c.program.parameters, {}).count[find_device(*c.program.family, device)];
}

TEST(Layout, AnImageIsAsLargeAsTheHighestNumber) {
  auto c = compile_rungs("LD X1F / MOV K1 D7 / OUT Y5 / OUT T3 K5");
  EXPECT_EQ(count(*c, "X"), 0x20u);
  EXPECT_EQ(count(*c, "D"), 8u);
  EXPECT_EQ(count(*c, "Y"), 6u);
  EXPECT_EQ(count(*c, "T"), 4u);
  EXPECT_EQ(count(*c, "M"), 0u);
}

TEST(Layout, WideOperandsReachBehindTheirNumber) {
  EXPECT_EQ(count(*compile_rungs("LD X0 / DMOV K1 D7"), "D"), 9u);
  EXPECT_EQ(count(*compile_rungs("LD X0 / D* D0 D2 D10"), "D"), 14u);
  EXPECT_EQ(count(*compile_rungs("LD X0 / / D0 D1 D10"), "D"), 12u);
  EXPECT_EQ(count(*compile_rungs("LD X0 / D/ D0 D2 D10"), "D"), 14u);
  EXPECT_EQ(count(*compile_rungs("LD X0 / MOV K4X10 K2M3"), "X"), 0x20u);
  EXPECT_EQ(count(*compile_rungs("LD X0 / MOV K4X10 K2M3"), "M"), 11u);
  EXPECT_EQ(count(*compile_rungs("LD D5.3 / OUT Y0"), "D"), 6u);
}

TEST(Layout, WhatCrossesTheEndNeedsBothClasses) {
  auto c = compile_rungs("LD X0 / DMOV K1 D6143");
  EXPECT_EQ(count(*c, "D"), 6144u);
  EXPECT_EQ(count(*c, "W"), 1u);
}

TEST(Layout, ABlockCanReachTheWholeAllocation) {
  EXPECT_EQ(count(*compile_rungs("LD X0 / BMOV D0 W0 D5"), "D"), 6144u);
  EXPECT_EQ(count(*compile_rungs("LD X0 / BMOV D0 W0 D5", R"({"device_points": {"D": 100}})"), "D"), 100u);
}

emit::Layout layout_of(unsigned rungs, emit::LayoutLimits limits) {
  std::string list;
  for (unsigned i = 0; i < rungs; ++i)
    list += i == 7 ? "LD X0\nBCD D0 D1\n" : "LD X0\nOUT Y" + std::to_string(i % 10) + "\n";
  auto c = compile(list + "END\n");
  return emit::make_layout(c->module, c->program.parameters, limits);
}

TEST(Layout, FunctionsAndFilesHoldAllRungsInOrder) {
  for (const unsigned rungs : {1u, 10u, 63u, 64u, 65u, 500u}) {
    emit::LayoutLimits limits;
    limits.operations_per_function = 40;
    limits.operations_per_file = 200;
    const emit::Layout layout = layout_of(rungs, limits);
    std::size_t next = 0;
    unsigned file = 0;
    for (const emit::Chunk &chunk : layout.routines[0].chunks) {
      EXPECT_EQ(chunk.first, next);
      EXPECT_LE(2 * (chunk.last - chunk.first + 1), 40u);
      EXPECT_TRUE(chunk.file == file || chunk.file == file + 1);
      file = chunk.file;
      EXPECT_EQ(chunk.can_stop, chunk.first <= 7 && 7 <= chunk.last);
      next = chunk.last + 1;
    }
    EXPECT_EQ(next, rungs);
    EXPECT_EQ(layout.files, file + 1);
  }
}

TEST(Layout, AFunctionHoldsNoMoreRungsThanItsLimit) {
  const emit::Layout layout = layout_of(130, {});
  ASSERT_EQ(layout.routines[0].chunks.size(), 3u);
  EXPECT_EQ(layout.routines[0].chunks[0].last, 63u);
  EXPECT_EQ(layout.routines[0].chunks[2].first, 128u);
  EXPECT_EQ(layout.files, 1u);
}

TEST(Layout, AnEmptyProgramHasNoFunction) {
  auto c = compile("END\n");
  EXPECT_TRUE(emit::make_layout(c->module, c->program.parameters, {}).routines[0].chunks.empty());
}

}  // namespace
}  // namespace ladderc::test
