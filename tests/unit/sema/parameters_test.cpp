// The parameter file.
#include "sema/parameters.h"

#include "gmock/gmock.h"
#include <gtest/gtest.h>

namespace ladderc {
namespace {

class ParameterFile : public testing::Test {
protected:
  const FamilyInfo &family_ = *find_family("melsec-qs");
  Parameters parameters_ = default_parameters(family_, "QS001CPU");

  /// The error text, or "".
  std::string read(llvm::StringRef json) { return read_parameters(json, family_, parameters_).value_or(""); }
  std::uint32_t points(llvm::StringRef prefix) const { return parameters_.points[find_device(family_, prefix)]; }
};

TEST_F(ParameterFile, HasDefaults) {
  EXPECT_EQ(read("{}"), "");
  EXPECT_EQ(points("D"), 6144u);
  EXPECT_EQ(points("ST"), 0u);
  EXPECT_EQ(parameters_.low_speed_unit_us, 100'000u);
  EXPECT_EQ(parameters_.high_speed_unit_us, 10'000u);
  EXPECT_EQ(parameters_.watchdog_us, 0u);
  EXPECT_EQ(parameters_.program_name, "MAIN");
}

TEST_F(ParameterFile, SetsPoints) {
  EXPECT_EQ(read(R"({"device_points": {"D": 8192, "M": 0}, "ST_points": 16})"), "");
  EXPECT_EQ(points("D"), 8192u);
  EXPECT_EQ(points("M"), 0u);
  EXPECT_EQ(points("ST"), 16u);
  EXPECT_EQ(read(R"({"device_points": {"Q": 1}})"), "parameter 'device_points': the points of 'Q' cannot be set");
  EXPECT_EQ(read(R"({"device_points": {"SM": 1}})"), "parameter 'device_points': the points of 'SM' cannot be set");
  EXPECT_EQ(read(R"({"device_points": {"N": 1}})"), "parameter 'device_points': the points of 'N' cannot be set");
  EXPECT_EQ(read(R"({"device_points": {"D": -1}})"), "parameter 'device_points': D: -1 is outside 0 to 65535");
  EXPECT_EQ(read(R"({"device_points": {"D": 18446744073709551615}})"),
            "parameter 'device_points': D: 18446744073709551615 is outside 0 to 65535");
  EXPECT_EQ(read(R"({"ST_points": 1.5})"), "parameter 'ST_points': ST: 1.5 is no whole number");
  EXPECT_EQ(read(R"({"device_points": 5})"), "parameter 'device_points': is no object like {\"D\": 8192}");
}

TEST_F(ParameterFile, SetsTimes) {
  EXPECT_EQ(read(R"({"low_speed_unit_ms": 1000, "high_speed_unit_ms": 0.1, "watchdog_ms": 200, "constant_scan_ms": 5.5})"), "");
  EXPECT_EQ(parameters_.low_speed_unit_us, 1'000'000u);
  EXPECT_EQ(parameters_.high_speed_unit_us, 100u);
  EXPECT_EQ(parameters_.watchdog_us, 200'000u);
  EXPECT_EQ(parameters_.constant_scan_us, 5'500u);
  EXPECT_EQ(read(R"({"high_speed_unit_ms": 99.9})"), "");
  EXPECT_EQ(parameters_.high_speed_unit_us, 99'900u);
}

TEST_F(ParameterFile, RefusesTimesOutOfRange) {
  EXPECT_EQ(read(R"({"low_speed_unit_ms": 0})"), "parameter 'low_speed_unit_ms': 0 is outside 1 to 1000");
  EXPECT_EQ(read(R"({"low_speed_unit_ms": 1001})"), "parameter 'low_speed_unit_ms': 1001 is outside 1 to 1000");
  EXPECT_EQ(read(R"({"low_speed_unit_ms": 1.5})"), "parameter 'low_speed_unit_ms': 1.5 is no multiple of 1");
  EXPECT_EQ(read(R"({"high_speed_unit_ms": 0.25})"), "parameter 'high_speed_unit_ms': 0.25 is no multiple of 0.1");
  EXPECT_EQ(read(R"({"high_speed_unit_ms": 100.1})"), "parameter 'high_speed_unit_ms': 100.1 is outside 0.1 to 100");
  EXPECT_EQ(read(R"({"watchdog_ms": "fast"})"), "parameter 'watchdog_ms': \"fast\" is no number");
  EXPECT_EQ(read(R"({"constant_scan_ms": 1e308})"), "parameter 'constant_scan_ms': 1e+308 is outside 0 to 2000");
}

TEST_F(ParameterFile, LatchedRanges) {
  EXPECT_EQ(read(R"({"latched": ["M0-M99", "D5", "XA-X1F"]})"), "");
  ASSERT_EQ(parameters_.latched.size(), 3u);
  EXPECT_EQ(parameters_.latched[0].device, find_device(family_, "M"));
  EXPECT_EQ(parameters_.latched[0].first, 0u);
  EXPECT_EQ(parameters_.latched[0].last, 99u);
  EXPECT_EQ(parameters_.latched[1].last, 5u);
  EXPECT_EQ(parameters_.latched[2].first, 10u);
  EXPECT_EQ(parameters_.latched[2].last, 31u);
  EXPECT_EQ(read(R"({"latched": ["M9-M0"]})"), "parameter 'latched': 'M9-M0' is no range like \"M0-M99\"");
  EXPECT_EQ(read(R"({"latched": ["M0-D9"]})"), "parameter 'latched': 'M0-D9' is no range like \"M0-M99\"");
  EXPECT_EQ(read(R"({"latched": ["M0-M6144"]})"), "parameter 'latched': 'M6144' lies outside the 6144 allocated points");
  EXPECT_EQ(read(R"({"latched": ["K5"]})"), "parameter 'latched': 'K5' is no device");
  EXPECT_EQ(read(R"({"latched": ["N5"]})"), "parameter 'latched': 'N5' is no device");
  EXPECT_EQ(read(R"({"latched": [""]})"), "parameter 'latched': '' is no device");
  EXPECT_EQ(read(R"({"latched": [5]})"), "parameter 'latched': 5 is no range like \"M0-M99\"");
  EXPECT_EQ(read(R"({"latched": [[[5]]]})"), "parameter 'latched': an array is no range like \"M0-M99\"");
  EXPECT_NE(read(R"({"latched": 5})"), "");
}

TEST_F(ParameterFile, LatchedContentsLatchTheirDevices) {
  EXPECT_EQ(read(R"({"latched": {"D10:d": 70000, "M3": 1}})"), "");
  ASSERT_EQ(parameters_.latched_values.size(), 2u);
  EXPECT_EQ(parameters_.latched_values[0].device, "D10:d");
  EXPECT_EQ(parameters_.latched_values[0].value, 70000);
  EXPECT_EQ(parameters_.latched[0].first, 10u);
  EXPECT_EQ(parameters_.latched[0].last, 11u);
  EXPECT_EQ(parameters_.latched[1].device, find_device(family_, "M"));
}

TEST_F(ParameterFile, InitialValues) {
  EXPECT_EQ(read(R"({"device_initial_values": {"D0": -5, "D1": 65535, "D2": "0xFFFE", "D3.A": 1, "TN0": 7, "T1": true}})"), "");
  std::vector<std::pair<std::string, std::int64_t>> values;
  for (const InitialValue &v : parameters_.initial_values)
    values.emplace_back(v.device, v.value);
  EXPECT_THAT(values, testing::ElementsAre(testing::Pair("D0", -5), testing::Pair("D1", -1), testing::Pair("D2", -2),
                                           testing::Pair("D3.A", 1), testing::Pair("T1", 1), testing::Pair("TN0", 7)));
}

TEST_F(ParameterFile, RefusesInitialValuesOutOfRange) {
  auto text = [](const char *what) { return std::string("parameter 'device_initial_values': ") + what; };
  EXPECT_EQ(read(R"({"device_initial_values": {"D0": 65536}})"), text("'D0': 65536 is outside -32768 to 65535"));
  EXPECT_EQ(read(R"({"device_initial_values": {"M0": 2}})"), text("'M0': 2 is outside 0 to 1"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D6144": 1}})"), text("'D6144' lies outside the 6144 allocated points"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D6143:d": 1}})"), text("'D6143:d' lies outside the 6144 allocated points"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D0:f": 1}})"), text("'D0:f': a pair of words is written like D0:d or D0:u"));
  EXPECT_EQ(read(R"({"device_initial_values": {"M0:d": 1}})"), text("'M0:d': a pair of words is written like D0:d or D0:u"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D0": "ten"}})"), text("'D0': 'ten' is no number"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D0": "0x10000"}})"), text("'D0': 0x10000 is outside -32768 to 65535"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D0:d": 2147483648}})"),
            text("'D0:d': 2147483648 is outside -2147483648 to 2147483647"));
  EXPECT_EQ(read(R"({"device_initial_values": {"D0:u": 4294967295}})"), "");
  EXPECT_EQ(parameters_.initial_values.back().value, -1);
}

TEST_F(ParameterFile, NameAndCalendar) {
  EXPECT_EQ(read(R"({"program_name": "PRESS-1", "calendar": "2024-02-29T13:30:00"})"), "");
  EXPECT_EQ(parameters_.program_name, "PRESS-1");
  EXPECT_EQ(parameters_.calendar, "2024-02-29T13:30:00");
  for (const char *name : {"", "TOOLONGNAME", "a b"})
    EXPECT_NE(read(R"({"program_name": ")" + std::string(name) + "\"}"), "") << name;
  for (const char *date : {"2023-02-29T00:00:00", "2024-13-01T00:00:00", "2024-01-01T24:00:00", "2024-01-01", "1979-12-31T00:00:00",
                           "2024-01-01 00:00:00", "2024-00-01T00:00:00", "2024-04-31T00:00:00"})
    EXPECT_NE(read(R"({"calendar": ")" + std::string(date) + "\"}"), "") << date;
}

TEST_F(ParameterFile, UnknownKeysAreErrors) {
  EXPECT_EQ(read(R"({"low_speed_unit": 5})"), "unknown parameter 'low_speed_unit'");
  EXPECT_EQ(read("[]"), "the parameters are no JSON object");
  EXPECT_EQ(read("{"), "the parameters are no JSON");
  EXPECT_EQ(read("{\"program_name\": \"\xFF\"}"), "the parameters are no JSON");
}

TEST_F(ParameterFile, TakesEffectAsAWholeOrNotAtAll) {
  EXPECT_NE(read(R"({"device_points": {"D": 100}, "watchdog_ms": -1})"), "");
  EXPECT_EQ(points("D"), 6144u);
}

}  // namespace
}  // namespace ladderc
