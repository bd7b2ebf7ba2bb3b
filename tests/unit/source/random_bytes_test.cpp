// Any bytes read without a crash, as valid text, and all places lie inside of it. The seed is fixed; a failure names its round.
#include "source/list_reader.h"

#include "llvm/Support/ConvertUTF.h"

#include <gtest/gtest.h>

#include <random>

namespace ladderc {
namespace {

bool is_utf8(const std::string &text) {
  const auto *begin = reinterpret_cast<const llvm::UTF8 *>(text.data());
  return llvm::isLegalUTF8String(&begin, begin + text.size());
}

/// Bytes of a given flavour: all, those of lists and tables, or UTF-16.
std::string random_bytes(std::mt19937 &random, unsigned flavour) {
  static constexpr llvm::StringLiteral kListBytes("LDXOUTK0123 \t\r\n,;\"/:=<>.-\xEF\xBC\xA1\xE3\x80\x80\xCA\xD6\x83\x82");
  std::string bytes(random() % 300, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (flavour == 0 || random() % 50 == 0)
      bytes[i] = static_cast<char>(random());
    else if (flavour == 2 && i % 2 == 1)
      bytes[i] = '\0';
    else
      bytes[i] = kListBytes[random() % kListBytes.size()];
  }
  return bytes;
}

TEST(RandomBytes, ReadInEveryFormat) {
  std::mt19937 random(20240229);
  for (unsigned round = 0; round < 6000; ++round) {
    SCOPED_TRACE(round);
    const Decoded decoded = decode(random_bytes(random, round % 3));
    ASSERT_TRUE(is_utf8(decoded.text));
    SourceSet sources;
    const unsigned file = sources.add("random", decoded.text);
    const std::size_t size = decoded.text.size();
    for (ListFormat format : {ListFormat::Auto, ListFormat::Plain, ListFormat::GxCsv}) {
      Diagnostics diagnostics(sources);
      llvm::BumpPtrAllocator memory;
      llvm::StringSaver saver(memory);
      read_list(sources[file], file, format, saver, diagnostics, [&](const ListLine &line) {
        for (const Word &word : line.words) {
          EXPECT_FALSE(word.text.empty());
          EXPECT_GT(word.range.length, 0u);
          EXPECT_LE(word.range.end(), size);
        }
        for (SourceRange range : {line.comment, line.statement, line.note})
          EXPECT_LE(range.end(), size);
      });
      std::string text;
      llvm::raw_string_ostream out(text);
      print_text(diagnostics, "melsec-qs", out);
      EXPECT_EQ(text.empty(), diagnostics.errors() + diagnostics.warnings() == 0);
    }
  }
}

TEST(RandomBytes, DecodeUnderEveryName) {
  std::mt19937 random(7);
  for (const char *name : {"UTF-8", "UTF-16LE", "UTF-16BE", "GB18030", "Shift_JIS", "BIG5", "EUC-KR"})
    for (unsigned round = 0; round < 300; ++round)
      ASSERT_TRUE(is_utf8(decode(random_bytes(random, round % 2), name).text)) << name << ' ' << round;
}

}  // namespace
}  // namespace ladderc
