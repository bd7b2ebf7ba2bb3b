// Program tables of the makers' software, whole and damaged.
#include "reading.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

using testing::Test;

/// A row as GX Works2 writes it: every cell in quotes, tabs between.
std::string row(std::initializer_list<const char *> cells) {
  std::string text;
  for (const char *cell : cells)
    text += (text.empty() ? "\"" : "\t\"") + std::string(cell) + "\"";
  return text + "\r\n";
}

std::string gx_works2(const std::string &title, const std::string &type, std::initializer_list<const char *> names,
                      const std::string &rows) {
  return row({title.c_str()}) + row({type.c_str(), "QCPU (Q mode) Q03UDV"}) + row(names) + rows;
}

const std::initializer_list<const char *> kEnglish = {"Step No.", "Line Statement", "Instruction", "I/O(Device)",
                                                      "Blank",    "PI Statement",   "Note"};
const std::initializer_list<const char *> kChinese = {"步号", "行间声明", "指令", "I/O(软元件)", "空白栏", "PI声明", "注解"};
const std::initializer_list<const char *> kJapanese = {"ステップ番号", "行間ステートメント", "命令",  "I/O(デバイス)",
                                                       "空欄",         "PIステートメント",   "ノート"};
const std::initializer_list<const char *> kKorean = {"스텝 번호", "행 간 스테이트먼트", "명령", "I/O(디바이스)", "", "", ""};

std::string example_rows() {
  return row({"0", " 电机启动", "", "", "", "", ""}) + row({"16", "", "LD", "X5B", "", "", ""}) +
         row({"17", "", "OUT", "T0", "", "", ""}) + row({"", "", "", "K100", "", "", ""}) + row({"", "", "", "", "", "", "计时"}) +
         row({"21", "", "END", "", "", "", ""});
}
const char kExampleRead[] = "4 [电机启动]\n5 ! LD X5B\n6 ! OUT T0\n7 + K100\n8 {计时}\n9 ! END\n";

TEST(CsvReader, HeadsInFourLanguages) {
  EXPECT_EQ(read_text(gx_works2("MAIN", "PLC Information:", kEnglish, example_rows())).text, kExampleRead);
  EXPECT_EQ(read_text(gx_works2("(工程未设置)", "PLC信息:", kChinese, example_rows())).text, kExampleRead);
  EXPECT_EQ(read_text(gx_works2("(プロジェクト未設定)", "PC情報:", kJapanese, example_rows())).text, kExampleRead);
  EXPECT_EQ(read_text(gx_works2("", "PLC 정보:", kKorean, example_rows())).text, kExampleRead);
}

TEST(CsvReader, TheGenuineEncoding) {
  const std::string utf8 = gx_works2("MAIN", "PC情報:", kJapanese, row({"0", "", "LD", "SM400", "", "", "常時オン"}));
  std::string bytes = "\xFF\xFE";
  for (llvm::StringRef rest = utf8; !rest.empty();) {
    // Two- and three-byte characters suffice for these texts.
    const auto lead = static_cast<unsigned char>(rest[0]);
    const unsigned length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : 3;
    unsigned c = length == 1 ? lead : length == 2 ? lead & 0x1F : lead & 0x0F;
    for (unsigned i = 1; i < length; ++i)
      c = c << 6 | (static_cast<unsigned char>(rest[i]) & 0x3F);
    bytes += static_cast<char>(c & 0xFF);
    bytes += static_cast<char>(c >> 8);
    rest = rest.drop_front(length);
  }
  EXPECT_EQ(read_text(decode(bytes).text).text, "4 ! LD SM400\n4 {常時オン}\n");
}

TEST(CsvReader, LabelsStandInTheInstructionColumn) {
  const std::string rows = row({"68", "", "I0", "", "", "", ""}) + row({"69", "", "LD", "X0", "", "割り込み", ""});
  EXPECT_EQ(read_text(gx_works2("MAIN", "PC情報:", kJapanese, rows)).text, "4 ! I0\n5 ! LD X0\n5 {割り込み}\n");
}

TEST(CsvReader, AllOperandsInOneCell) {
  const std::string rows = row({"0", "", "LD=", "K5 D0", "", "", ""}) + row({"3", "", "OUT", "T0  K100", "", "", ""});
  EXPECT_EQ(read_text(gx_works2("MAIN", "PLC Information:", kEnglish, rows)).text, "4 ! LD= K5 D0\n5 ! OUT T0 K100\n");
}

TEST(CsvReader, NoteAndPointerStatementOfOneRow) {
  const std::string rows = row({"0", "", "OUT", "Y0", "", "pointer", "note"});
  EXPECT_EQ(read_text(gx_works2("MAIN", "PLC Information:", kEnglish, rows)).text, "4 ! OUT Y0\n4 {note}\n4 {pointer}\n");
}

TEST(CsvReader, PeripheralStatementsLoseTheirStar) {
  const std::string rows = row({"0", "* lamp", "", "", "", "", ""}) + row({"0", "", "LD", "X0", "", "", ""});
  EXPECT_EQ(read_text(gx_works2("MAIN", "PLC Information:", kEnglish, rows)).text, "4 [lamp]\n5 ! LD X0\n");
}

TEST(CsvReader, QuotesLostAndRowsShortenedByASpreadsheet) {
  const std::string list = "MAIN\n"
                           "PLC Information:\tFXCPU FX3U/FX3UC\n"
                           "Step No.\tLine Statement\tInstruction\tI/O(Device)\tBlank\tPI Statement\tNote\n"
                           "0\tstart\n"
                           "0\t\tLD\tX002\n"
                           "1\t\tOUT\tC235\n"
                           "\t\t\tK9999999\n"
                           "6\t\tEND\n";
  EXPECT_EQ(read_text(list).text, "4 [start]\n5 ! LD X002\n6 ! OUT C235\n7 + K9999999\n8 ! END\n");
}

TEST(CsvReader, CommasInsteadOfTabsAndPaddedRows) {
  const std::string list = "MAIN,,,,,,\r\n"
                           "PLC信息:,FXCPU FX3U/FX3UC,,,,,\r\n"
                           "步号,行间声明,指令,I/O(软元件),空白栏,PI声明,注解\r\n"
                           "0,\"启动, 手动\",,,,,\r\n"
                           "0,,LD,X002,,,\r\n"
                           "1,,OUT,Y001,,,\"灯 \"\"一\"\"\"\r\n"
                           ",,,,,,\r\n"
                           "2,,END,,,,\r\n";
  EXPECT_EQ(read_text(list).text, "4 [启动, 手动]\n5 ! LD X002\n6 ! OUT Y001\n6 {灯 \"\"一\"\"}\n8 ! END\n");
}

TEST(CsvReader, SemicolonsOfEuropeanSpreadsheets) {
  const std::string list = "MAIN;;;;;;\nPLC Information:;QCPU;;;;;\n"
                           "Step No.;Line Statement;Instruction;I/O(Device);Blank;PI Statement;Note\n"
                           "0;;LD;X0;;;\n1;;END;;;;\n";
  EXPECT_EQ(read_text(list).text, "4 ! LD X0\n5 ! END\n");
}

TEST(CsvReader, TheTitleRowsWereLost) {
  const std::string list = row(kEnglish) + row({"0", "", "LD", "X0", "", "", ""}) + row({"1", "", "END", "", "", "", ""});
  EXPECT_EQ(read_text(list).text, "2 ! LD X0\n3 ! END\n");
}

TEST(CsvReader, GxDeveloperWithHead) {
  const std::string list = "\"MAIN\"\r\n\"PLC Type:FX3U(C)\"\r\n"
                           "\"Step No.\",\"Line Statement\",\"Instruction\",\"I/O(Device)\",\"Blank\",\"PI Statement\",\"Note\"\r\n"
                           "\"0\",\"\",\"LD\",\"X000\",\"\",\"\",\"\"\r\n";
  EXPECT_EQ(read_text(list).text, "4 ! LD X000\n");
}

TEST(CsvReader, GxDeveloperWithoutHead) {
  EXPECT_EQ(read_text("0,,LD,X0,,,,,\n1,,OUT,T204,,,,,\n,,,K100,,,,,,\n4,,END,,,,,,\n").text,
            "1 ! LD X0\n2 ! OUT T204\n3 + K100\n4 ! END\n");
}

TEST(CsvReader, NormalisesCells) {
  EXPECT_EQ(read_text("0,,ｌｄ≤,ｄ０　K5,,,\n1,,out,y0,,,\n").text, "1 ! LD<= D0 K5\n2 ! OUT Y0\n");
}

TEST(CsvReader, AQuoteThatDoesNotEndStopsAtItsRow) {
  const Reading reading = read_text("0,\"motor,,,,\n0,,LD,X0,,,\n1,,OUT,Y0,,,\n");
  EXPECT_EQ(reading.text, "1 [motor,,,,]\n2 ! LD X0\n3 ! OUT Y0\n");
  EXPECT_EQ(reading.messages, "1 unclosed-quote\n");
}

TEST(CsvReader, StringConstantsAreOneWord) {
  EXPECT_EQ(read_text("0,,LD,X0,,,\n1,,$MOV,\"\"\"a b;c\"\" D0\",,,\n").text, "1 ! LD X0\n2 ! $MOV \"a b;c\" D0\n");
}

TEST(CsvReader, PlacesAreThoseOfTheCell) {
  SourceSet sources;
  const unsigned file = sources.add("a.csv", gx_works2("MAIN", "PC情報:", kJapanese, row({"0", "", "LD", "X1F", "", "", ""})));
  Diagnostics diagnostics(sources);
  llvm::BumpPtrAllocator memory;
  llvm::StringSaver saver(memory);
  unsigned lines = 0;
  read_list(sources[file], file, ListFormat::GxCsv, saver, diagnostics, [&](const ListLine &line) {
    ++lines;
    ASSERT_EQ(line.words.size(), 2u);
    EXPECT_EQ(sources.text(line.words[1].range), "X1F");
    EXPECT_EQ(sources.position(line.words[1].range).line, 4u);
    EXPECT_EQ(sources.position(line.words[1].range).column, 14u);
  });
  EXPECT_EQ(lines, 1u);
}

TEST(CsvReader, AForcedFormatReadsWhatIsThere) {
  EXPECT_EQ(read_text("0,,LD\n", ListFormat::GxCsv).text, "1 ! LD\n");
  EXPECT_EQ(read_text("LD X0\nOUT Y0", ListFormat::GxCsv).text, "");
}

}  // namespace
}  // namespace ladderc
