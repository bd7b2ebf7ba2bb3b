// Reports of scenario runs for machines.
#include "driver/scenario.h"

#include <gmock/gmock.h>

namespace ladderc::test {
namespace {

using testing::HasSubstr;

struct TwoResults {
  std::vector<driver::Scenario> scenarios{2};
  std::vector<driver::ScenarioResult> results{2};
  TwoResults() {
    scenarios[0].name = "good";
    scenarios[0].file = "s.json";
    scenarios[1].name = "bad <&\"\x01> name";
    scenarios[1].file = "s.json";
    results[1].fail("D1 is 6 & not < 7");
    results[1].failures.push_back({{"step", 1}, {"scan", 3}, {"device", "D1"}, {"expected", 7}, {"got", 6}});
  }
};

TEST(Report, JsonHasNumbers) {
  const TwoResults run;
  const auto json = nlohmann::json::parse(driver::json_report(run.scenarios, run.results));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["passed"], true);
  EXPECT_FALSE(json[0].contains("messages"));
  EXPECT_EQ(json[1]["name"], "bad <&\"\x01> name");
  EXPECT_EQ(json[1]["messages"][0], "D1 is 6 & not < 7");
  EXPECT_TRUE(json[1]["failures"][0]["got"].is_number());
  EXPECT_EQ(json[1]["failures"][0]["expected"], 7);
}

TEST(Report, JUnitIsXml) {
  const TwoResults run;
  const std::string xml = driver::junit_report(run.scenarios, run.results);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"ladderc\" tests=\"2\" failures=\"1\">"));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"s.json\" name=\"good\"/>"));
  EXPECT_THAT(xml, HasSubstr("name=\"bad &lt;&amp;&quot; &gt; name\">"));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"D1 is 6 &amp; not &lt; 7\">"));
}

}  // namespace
}  // namespace ladderc::test
