// Every encoding in which lists are found, and damage in each.
#include "source/decode.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace ladderc {
namespace {

std::string utf16(std::u16string_view text, bool little) {
  std::string bytes;
  for (char16_t c : text) {
    const char low = static_cast<char>(c & 0xFF);
    const char high = static_cast<char>(c >> 8);
    bytes += little ? low : high;
    bytes += little ? high : low;
  }
  return bytes;
}

TEST(Decode, PlainAsciiIsUtf8) {
  const Decoded decoded = decode("LD X0\r\nEND\r\n");
  EXPECT_EQ(decoded.text, "LD X0\r\nEND\r\n");
  EXPECT_EQ(decoded.encoding, "UTF-8");
  EXPECT_FALSE(decoded.damaged);
}

TEST(Decode, EndMarksOfDosGoAway) {
  EXPECT_EQ(decode("END\r\n\x1A").text, "END\r\n");
  EXPECT_EQ(decode("END\r\n\x1A\x1A\x1A").text, "END\r\n");
  EXPECT_EQ(decode("LD\x1AX0\n").text, "LD\x1AX0\n");
  EXPECT_EQ(decode("\x1A").text, "");
}

TEST(Decode, ByteOrderMarksDecideAndGoAway) {
  EXPECT_EQ(decode("\xEF\xBB\xBFLD ; 手动").text, "LD ; 手动");
  const Decoded little = decode("\xFF\xFE" + utf16(u"LD ; 手动 \U0001F600", true));
  EXPECT_EQ(little.text, "LD ; 手动 \U0001F600");
  EXPECT_EQ(little.encoding, "UTF-16LE");
  EXPECT_FALSE(little.damaged);
  const Decoded big = decode("\xFE\xFF" + utf16(u"LD ; 手动", false));
  EXPECT_EQ(big.text, "LD ; 手动");
  EXPECT_EQ(big.encoding, "UTF-16BE");
}

TEST(Decode, Utf16IsKnownByItsZeroBytes) {
  EXPECT_EQ(decode(utf16(u"0\tLD\tX0 手动电机\r\n", true)).encoding, "UTF-16LE");
  EXPECT_EQ(decode(utf16(u"0\tLD\tX0 手动电机\r\n", false)).encoding, "UTF-16BE");
  EXPECT_EQ(decode(utf16(u"LD X0", true)).text, "LD X0");
}

TEST(Decode, ChineseCodePage) {
  const Decoded decoded = decode("LD X0 ; \xCA\xD6\xB6\xAF\xB5\xE7\xBB\xFA");
  EXPECT_EQ(decoded.text, "LD X0 ; 手动电机");
  EXPECT_EQ(decoded.encoding, "GB18030");
  EXPECT_FALSE(decoded.damaged);
}

TEST(Decode, JapaneseCodePageIsKnownByItsKana) {
  const Decoded decoded = decode("LD X0 ; \x83\x82\x81\x5B\x83\x5E\x81\x5B\x89\x5E\x93\x5D\x92\x86");
  EXPECT_EQ(decoded.text, "LD X0 ; モーター運転中");
  EXPECT_EQ(decoded.encoding, "SHIFT_JIS");
  EXPECT_FALSE(decoded.damaged);
}

TEST(Decode, TheEncodingCanBeNamed) {
  EXPECT_EQ(decode("\x89\x5E\x93\x5D\x92\x86", "Shift_JIS").text, "運転中");
  EXPECT_EQ(decode("\xA4\xE2\xB0\xCA", "BIG5").text, "手動");
  EXPECT_EQ(decode(utf16(u"手", true), "utf-16le").text, "手");
  EXPECT_EQ(decode("\xFF\xFE" + utf16(u"手", true), "UTF-16LE").text, "手");
  EXPECT_TRUE(is_known_encoding("auto"));
  EXPECT_TRUE(is_known_encoding("GB18030"));
  EXPECT_FALSE(is_known_encoding("no-such-code-page"));
  EXPECT_FALSE(is_known_encoding(""));
  EXPECT_EQ(decode("LD \xFF", "no-such-code-page").text, "LD \xEF\xBF\xBD");
}

TEST(Decode, DamageIsMarkedAndTold) {
  const Decoded cut = decode("\xEF\xBB\xBFLD ; \xE6\x89");
  EXPECT_TRUE(cut.damaged);
  EXPECT_EQ(cut.text, "LD ; \xEF\xBF\xBD\xEF\xBF\xBD");
  const Decoded odd = decode("\xFF\xFE" + utf16(u"LD", true) + "X");
  EXPECT_TRUE(odd.damaged);
  EXPECT_EQ(odd.text, "LD\xEF\xBF\xBD");
  const Decoded half = decode("\xFF\xFE" + utf16(u"A", true) + std::string("\x00\xD8", 2) + utf16(u"B", true));
  EXPECT_TRUE(half.damaged);
  EXPECT_EQ(half.text, "A\xEF\xBF\xBD"
                       "B");
}

TEST(Decode, Utf8WithOneFlawStaysUtf8) {
  const Decoded decoded = decode("; 手动电机停止 \xFF 手动电机停止");
  EXPECT_TRUE(decoded.damaged);
  EXPECT_EQ(decoded.encoding, "UTF-8");
  EXPECT_EQ(decoded.text, "; 手动电机停止 \xEF\xBF\xBD 手动电机停止");
}

TEST(Decode, NothingGivesNothing) {
  EXPECT_EQ(decode("").text, "");
  EXPECT_EQ(decode("\xFF\xFE").text, "");
  EXPECT_EQ(decode("\xEF\xBB\xBF").text, "");
}

}  // namespace
}  // namespace ladderc
