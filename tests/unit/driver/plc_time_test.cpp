// The real CPU's scan time by the timing table.
#include "driver/plc_time.h"

#include "driver/compilation.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

driver::PlcTime time_of(std::string list) {
  driver::Compilation c;
  c.options.family = "melsec-qs";
  EXPECT_TRUE(c.check_text("test.il", std::move(list), nullptr));
  EXPECT_TRUE(c.program.ok);
  return driver::plc_time(c.program);
}

TEST(PlcTime, AddsTheInstructionsAndEnd) {
  const driver::PlcTime none = time_of("END\n"), two = time_of("LD X0\nOUT Y0\nEND\n"), bits = time_of("LD D0.0\nOUT D0.1\nEND\n");
  EXPECT_GE(none.end_us, 8200);
  EXPECT_NEAR(two.instructions_us - none.instructions_us, 0.2, 1e-9);    // 100 ns each
  EXPECT_NEAR(bits.instructions_us - none.instructions_us, 0.35, 1e-9);  // 150 and 200 ns: bits of words are slower
  EXPECT_EQ(two.unknown, 0u);
}

TEST(PlcTime, MoreIsSlower) {
  std::string list;
  double before = 0;
  for (unsigned i = 0; i < 5; ++i) {
    list += "LD X0\n* D0 D1 D10\nBMOV D0 D10 K50\n";
    const double now = time_of(list + "END\n").total_us();
    EXPECT_GT(now, before);
    before = now;
  }
}

}  // namespace
}  // namespace ladderc::test
