// Floating point of the TP03: results, flags at the ends of the range, and what is no number.
#include "ladder/image.h"
#include "ladder/tp03/ops/float.h"
#include "printing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

using namespace ladder;
using tp03::Fault;

namespace {

constexpr float kMost = std::numeric_limits<float>::max();
constexpr float kLeast = std::numeric_limits<float>::min();
constexpr float kTiny = std::numeric_limits<float>::denorm_min();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

/// The flags as one text: "z" for M8020, "b" for M8021, "c" for M8022.
struct FakeSystem {
  std::string flags = "?";
  void set_flags(bool zero, bool borrow, bool carry) {
    flags = std::string(zero ? "z" : "") + (borrow ? "b" : "") + (carry ? "c" : "");
  }
};

/// What an instruction with one result wrote; 77 and "?" where it wrote nothing.
struct Outcome {
  float value = 77;
  FakeSystem sys;
  Fault fault = Fault::None;
};
template <class F> Outcome outcome(F &&call) {
  Outcome result;
  result.fault = call(result.value, result.sys);
  return result;
}
void expect(const Outcome &seen, float value, const std::string &flags) {
  EXPECT_EQ(seen.fault, Fault::None);
  EXPECT_EQ(seen.value, value);
  EXPECT_EQ(seen.sys.flags, flags);
}
void expect_fault(const Outcome &seen) {
  EXPECT_EQ(seen.fault, Fault::Range);
  EXPECT_EQ(seen.value, 77);
  EXPECT_EQ(seen.sys.flags, "?");
}

Outcome sum(float a, float b) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::eadd(a, b, out, sys); });
}
Outcome difference(float a, float b) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::esub(a, b, out, sys); });
}
Outcome product(float a, float b) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::emul(a, b, out, sys); });
}
Outcome quotient(float a, float b) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::ediv(a, b, out, sys); });
}
Outcome root(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::esqr(source, out, sys); });
}
Outcome sine(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::sin(source, out, sys); });
}
Outcome cosine(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::cos(source, out, sys); });
}
Outcome tangent(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::tan(source, out, sys); });
}
Outcome arc_sine(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::asin(source, out, sys); });
}
Outcome arc_cosine(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::acos(source, out, sys); });
}
Outcome arc_tangent(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::atan(source, out, sys); });
}
Outcome radians(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::rad(source, out, sys); });
}
Outcome degrees(float source) {
  return outcome([=](float &out, FakeSystem &sys) { return tp03::deg(source, out, sys); });
}

}  // namespace

TEST(Tp03Float, IntegersBecomeReal) {
  EXPECT_EQ(tp03::flt(-32768), -32768.0F);
  EXPECT_EQ(tp03::dflt(1000000), 1000000.0F);
  EXPECT_EQ(tp03::dflt(16777217), 16777216.0F) << "halfway: to the even one";
  EXPECT_EQ(tp03::dflt(16777219), 16777220.0F);
  EXPECT_EQ(tp03::dflt(std::numeric_limits<dword>::max()), 2147483648.0F);
}

TEST(Tp03Float, ResultsAndFlags) {
  expect(sum(1.5F, 2.25F), 3.75F, "");
  expect(sum(1.5F, -1.5F), 0, "z");
  expect(difference(1, 2.5F), -1.5F, "");
  expect(product(1.5F, -4), -6, "");
  expect(quotient(7, 2), 3.5F, "");
  expect(quotient(1, 3), 1.0F / 3, "");
}

TEST(Tp03Float, BeyondTheLargestNumber) {
  expect(sum(kMost, kMost), kMost, "c");
  expect(difference(-kMost, kMost), -kMost, "c");
  expect(product(1e30F, -1e30F), -kMost, "c");
  expect(quotient(kMost, 0.5F), kMost, "c");
  expect(sum(kMost, 0), kMost, "");
}

TEST(Tp03Float, BelowTheSmallestNumber) {
  expect(product(kLeast, 0.5F), 0, "b");
  expect(product(1e-30F, 1e-30F), 0, "b");  // vanishes altogether
  expect(quotient(1e-30F, -1e30F), 0, "b");
  expect(difference(kLeast * 1.5F, kLeast), 0, "b");
  expect(product(kLeast, 1), kLeast, "");
  expect(product(0, 5), 0, "z");
}

TEST(Tp03Float, ZeroHasNoSign) {
  const Outcome seen = product(-1, 0);
  expect(seen, 0, "z");
  EXPECT_FALSE(std::signbit(seen.value));
  EXPECT_FALSE(std::signbit(product(-kLeast, 0.5F).value));
}

TEST(Tp03Float, DivisionByZeroFails) {
  expect_fault(quotient(7, 0));
  expect_fault(quotient(0, -0.0F));
}

TEST(Tp03Float, InfiniteAndNoNumberFail) {
  for (const float bad : {kInfinity, -kInfinity, kNan}) {
    for (const auto &binary : {sum, difference, product, quotient}) {
      expect_fault(binary(bad, 1));
      expect_fault(binary(1, bad));
    }
    for (const auto &unary : {root, sine, cosine, tangent, arc_sine, arc_cosine, arc_tangent, radians, degrees})
      expect_fault(unary(bad));
  }
}

TEST(Tp03Float, SquareRoot) {
  expect(root(6.25F), 2.5F, "");
  expect(root(0), 0, "z");
  expect(root(-0.0F), 0, "z");
  expect(root(kTiny), std::sqrt(kTiny), "");
  expect_fault(root(-1));
  expect_fault(root(-kTiny));
}

TEST(Tp03Float, Trigonometry) {
  const float pi = 3.14159265F;
  EXPECT_NEAR(sine(pi / 6).value, 0.5F, 1e-7);
  EXPECT_NEAR(cosine(pi / 3).value, 0.5F, 1e-7);
  EXPECT_NEAR(tangent(pi / 4).value, 1.0F, 2e-7);
  EXPECT_NEAR(arc_sine(1).value, pi / 2, 2e-7);
  EXPECT_NEAR(arc_cosine(-1).value, pi, 3e-7);
  EXPECT_NEAR(arc_tangent(-1e30F).value, -pi / 2, 2e-7);
  expect(sine(0), 0, "z");
  expect(arc_cosine(1), 0, "z");
  expect(cosine(0), 1, "");
  expect(sine(kTiny), 0, "b");
  expect_fault(arc_sine(1.0000001F));
  expect_fault(arc_cosine(-1.5F));
}

TEST(Tp03Float, Angles) {
  expect(radians(180), 3.14159265F, "");
  expect(degrees(3.14159265F), 180, "");
  expect(radians(0), 0, "z");
  expect(radians(kLeast), 0, "b");
  expect(degrees(-1e38F), -kMost, "c");
  for (float angle = -720; angle <= 720; angle += 0.5F)
    EXPECT_NEAR(degrees(radians(angle).value).value, angle, 1e-4);
}

TEST(Tp03Float, Comparison) {
  Bits<4> m;
  FakeSystem sys;
  const auto bits = [&] { return std::string(m[0] ? ">" : "") + (m[1] ? "=" : "") + (m[2] ? "<" : "") + (m[3] ? "!" : ""); };
  EXPECT_EQ(tp03::ecmp(2.5F, 1.5F, m.run(0), sys), Fault::None);
  EXPECT_EQ(bits(), ">");
  tp03::ecmp(0.0F, -0.0F, m.run(0), sys);
  EXPECT_EQ(bits(), "=");
  tp03::ecmp(-1.0F, kTiny, m.run(0), sys);
  EXPECT_EQ(bits(), "<");
  EXPECT_EQ(tp03::ecmp(kNan, 1.0F, m.run(0), sys), Fault::Range);
  EXPECT_EQ(tp03::ecmp(1.0F, kInfinity, m.run(0), sys), Fault::Range);
  EXPECT_EQ(bits(), "<") << "kept";
  EXPECT_EQ(sys.flags, "?");
}

TEST(Tp03Float, ZoneComparison) {
  Bits<4> m;
  FakeSystem sys;
  const auto zone = [&](float low, float high, float value) {
    EXPECT_EQ(tp03::ezcp(low, high, value, m.run(0), sys), Fault::None);
    return m[0] & !m[1] & !m[2] ? -1 : m[1] & !m[0] & !m[2] ? 0 : m[2] & !m[0] & !m[1] ? 1 : 99;
  };
  EXPECT_EQ(zone(1, 2, 0.5F), -1);
  EXPECT_EQ(zone(1, 2, 1), 0);
  EXPECT_EQ(zone(1, 2, 2), 0);
  EXPECT_EQ(zone(1, 2, 2.5F), 1);
  EXPECT_EQ(zone(5, 1, 4), -1);
  EXPECT_EQ(zone(5, 1, 5), 0);
  EXPECT_EQ(zone(5, 1, 6), 1);
  EXPECT_EQ(tp03::ezcp(1.0F, 2.0F, kNan, m.run(0), sys), Fault::Range);
}

TEST(Tp03Float, ToIntegers) {
  FakeSystem sys;
  word narrow = 77;
  const auto integer = [&](float source) {
    EXPECT_EQ(tp03::integer(source, narrow, sys), Fault::None);
    return narrow;
  };
  EXPECT_EQ(integer(123.75F), 123);
  EXPECT_EQ(sys.flags, "b");
  EXPECT_EQ(integer(-123.75F), -123);
  EXPECT_EQ(integer(-0.5F), 0);
  EXPECT_EQ(sys.flags, "zb");
  EXPECT_EQ(integer(0), 0);
  EXPECT_EQ(sys.flags, "z");
  EXPECT_EQ(integer(-32768.75F), -32768);
  EXPECT_EQ(sys.flags, "b") << "still in range once the fraction is cut off";
  EXPECT_EQ(integer(32768), 32767);
  EXPECT_EQ(sys.flags, "c");
  EXPECT_EQ(integer(-32769), -32768);
  EXPECT_EQ(integer(-kMost), -32768);
  EXPECT_EQ(tp03::integer(kNan, narrow, sys), Fault::Range);
  EXPECT_EQ(narrow, -32768);

  dword wide = 77;
  EXPECT_EQ(tp03::dinteger(-70000.5F, wide, sys), Fault::None);
  EXPECT_EQ(wide, -70000);
  EXPECT_EQ(sys.flags, "b");
  tp03::dinteger(-2147483648.0F, wide, sys);
  EXPECT_EQ(wide, std::numeric_limits<dword>::min());
  EXPECT_EQ(sys.flags, "");
  tp03::dinteger(2147483648.0F, wide, sys);
  EXPECT_EQ(wide, std::numeric_limits<dword>::max());
  EXPECT_EQ(sys.flags, "c");
  tp03::dinteger(-3e9F, wide, sys);
  EXPECT_EQ(wide, std::numeric_limits<dword>::min());
  EXPECT_EQ(tp03::dinteger(kInfinity, wide, sys), Fault::Range);
}

// ---- decimal numbers

namespace {

struct Decimal {
  int mantissa, exponent;
  bool operator==(const Decimal &other) const { return mantissa == other.mantissa && exponent == other.exponent; }
};
std::ostream &operator<<(std::ostream &out, const Decimal &value) {
  return out << value.mantissa << "e" << value.exponent;
}

Decimal to_decimal(float source, FakeSystem &sys) {
  Words<2> d;
  EXPECT_EQ(tp03::ebcd(source, d.block(0), sys), Fault::None);
  return {d[0], d[1]};
}
Outcome to_binary(int mantissa, int exponent) {
  Words<2> d;
  d[0] = static_cast<word>(mantissa);
  d[1] = static_cast<word>(exponent);
  return outcome([&](float &out, FakeSystem &sys) { return tp03::ebin(d.block(0), out, sys); });
}

}  // namespace

TEST(Tp03Float, BinaryToDecimal) {
  FakeSystem sys;
  EXPECT_EQ(to_decimal(100, sys), (Decimal{1000, -1}));
  EXPECT_EQ(to_decimal(-2500, sys), (Decimal{-2500, 0}));
  EXPECT_EQ(to_decimal(5e6F, sys), (Decimal{5000, 3}));
  EXPECT_EQ(to_decimal(1.3F, sys), (Decimal{1300, -3})) << "the single is a little less than 1.3";
  EXPECT_EQ(to_decimal(99995, sys), (Decimal{1000, 2})) << "rounds to one more digit";
  EXPECT_EQ(to_decimal(99994.9F, sys), (Decimal{9999, 1}));
  EXPECT_EQ(sys.flags, "");
  EXPECT_EQ(to_decimal(-0.0F, sys), (Decimal{0, 0}));
  EXPECT_EQ(sys.flags, "z");
}

TEST(Tp03Float, BinaryToDecimalAtTheEnds) {
  FakeSystem sys;
  EXPECT_EQ(to_decimal(kLeast, sys), (Decimal{1175, -41}));
  EXPECT_EQ(sys.flags, "");
  EXPECT_EQ(to_decimal(-kTiny, sys), (Decimal{0, 0}));
  EXPECT_EQ(sys.flags, "b");
  EXPECT_EQ(to_decimal(3.402e38F, sys), (Decimal{3402, 35}));
  EXPECT_EQ(sys.flags, "");
  EXPECT_EQ(to_decimal(-kMost, sys), (Decimal{-3402, 35}));
  EXPECT_EQ(sys.flags, "c");
  Words<2> d;
  EXPECT_EQ(tp03::ebcd(kInfinity, d.block(0), sys), Fault::Range);
}

TEST(Tp03Float, DecimalToBinary) {
  expect(to_binary(1000, -1), 100, "");
  expect(to_binary(-2500, 0), -2500, "");
  expect(to_binary(1250, -3), 1.25F, "");
  expect(to_binary(0, 999), 0, "z");
  expect(to_binary(3402, 35), 3.402e38F, "");
  expect(to_binary(-3403, 35), -kMost, "c");
  expect(to_binary(1175, -41), kLeast, "");
  expect(to_binary(-1174, -41), 0, "b");
  for (const Decimal bad : {Decimal{999, 0}, {-10000, 0}, {1, 0}, {1000, 36}, {1000, -42}, {-32768, 0}})
    expect_fault(to_binary(bad.mantissa, bad.exponent));
}

TEST(Tp03Float, DecimalsAreTheNearestBinaryAndComeBack) {
  unsigned wrong = 0;
  FakeSystem sys;
  for (int exponent = -41; exponent <= 35; ++exponent) {
    for (int mantissa = 1000; mantissa <= 9999; mantissa += 7) {
      if ((exponent == -41 && mantissa <= 1175) || (exponent == 35 && mantissa > 3402))
        continue;
      const float value = to_binary(mantissa, exponent).value;
      wrong += std::strtof((std::to_string(mantissa) + "e" + std::to_string(exponent)).c_str(), nullptr) != value;
      wrong += !(to_decimal(value, sys) == Decimal{mantissa, exponent});
    }
  }
  EXPECT_EQ(wrong, 0U);
}

TEST(Tp03Float, EveryBinaryExponentHasFourDigits) {
  FakeSystem sys;
  for (int exponent = -126; exponent <= 127; ++exponent) {
    for (const float fraction : {1.0F, 1.25F, 1.5F, 1.99999988F}) {
      const float value = std::ldexp(fraction, exponent);
      if (value > 3.402e38F)
        continue;
      const Decimal seen = to_decimal(value, sys);
      ASSERT_GE(seen.mantissa, 1000) << value;
      ASSERT_LE(seen.mantissa, 9999) << value;
      ASSERT_NEAR(seen.mantissa * std::pow(10.0, seen.exponent) / static_cast<double>(value), 1, 0.0005001) << value;
    }
  }
}
