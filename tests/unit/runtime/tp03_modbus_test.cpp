// F87 MBUS: telegrams of Modbus RTU and ASCII.
#include "ladder/tp03/ops/serial.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace ladder;
using namespace ladder::tp03;

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Tp03Modbus : testing::Test {
  PanelMachine sys;
  Words<300> D;
  Modbus mbus;
  word m = 6, n = 20;

  Tp03Modbus() { sys.D[8120] = 0x0081; }
  void ascii() { sys.D[8120] = 0x2081; }
  Fault scan(bit condition = on) { return mbus.run(condition, D.block(0), m, D.block(100), n, 0, sys); }
  void command(const Bytes &bytes) {
    for (unsigned i = 0; i < bytes.size(); ++i)
      tp03::detail::set_character(D.block(0), i, bytes[i], false);
    m = static_cast<word>(bytes.size());
  }
  void send() {
    sys.scripted.sent[0].clear();
    sys.M[8122] = on;
    for (int i = 0; i < 20; ++i)
      scan();
    EXPECT_EQ(sys.M[8122], off);
  }
  std::string text() { return {sys.scripted.sent[0].begin(), sys.scripted.sent[0].end()}; }
  Bytes received() {
    Bytes bytes;
    for (unsigned i = 0; i < static_cast<unsigned>(sys.D[8123]); ++i)
      bytes.push_back(tp03::detail::character(D.block(100), i, false));
    return bytes;
  }
  /// A telegram comes, and then nothing for as long as it takes.
  template <class Telegram> void answer(const Telegram &telegram, int scans = 8) {
    sys.M[8123] = off;
    scan();
    sys.scripted.arrive(telegram);
    for (int i = 0; i < scans; ++i)
      scan();
  }
};

}  // namespace

TEST_F(Tp03Modbus, RtuRequest) {
  scan();
  command({0x01, 0x03, 0x00, 0x00, 0x00, 0x02});
  send();
  EXPECT_EQ(sys.scripted.sent[0], (Bytes{0x01, 0x03, 0x00, 0x00, 0x00, 0x02, 0xC4, 0x0B}));
  EXPECT_EQ(sys.D[8122], 0);
  command({0x11, 0x06, 0x00, 0x01, 0x00, 0x03});
  send();
  EXPECT_EQ(sys.scripted.sent[0], (Bytes{0x11, 0x06, 0x00, 0x01, 0x00, 0x03, 0x9A, 0x9B}));
}

TEST_F(Tp03Modbus, RtuAnswer) {
  scan();
  answer(Bytes{0x01, 0x03, 0x04, 0x00, 0x06, 0x00, 0x05, 0xDA, 0x31});
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8124], off);
  EXPECT_EQ(sys.M[8129], on) << "a pause ends it";
  EXPECT_EQ(received(), (Bytes{0x01, 0x03, 0x04, 0x00, 0x06, 0x00, 0x05}));
  EXPECT_EQ(D[104], 0) << "no check code is stored";
  n = 7;
  answer(Bytes{0x01, 0x03, 0x04, 0x00, 0x06, 0x00, 0x05, 0xDA, 0x31}, 1);
  EXPECT_EQ(sys.M[8123], on) << "n bytes end it too";
  EXPECT_EQ(sys.M[8124], off);
  EXPECT_EQ(sys.M[8129], off);
}

TEST_F(Tp03Modbus, RtuErrors) {
  scan();
  answer(Bytes{0x01, 0x03, 0x04, 0x00, 0x07, 0x00, 0x05, 0xDA, 0x31});
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8124], on);
  sys.M[8123] = off;
  scan();
  EXPECT_EQ(sys.M[8124], off);
  answer(Bytes{0xFF});
  EXPECT_EQ(sys.M[8124], on);
  answer(Bytes{0xFF, 0xFF});
  EXPECT_EQ(sys.M[8124], on) << "the check code of nothing";
  n = 4;
  answer(Bytes{0x01, 0x03, 0x04, 0x00, 0x06, 0x00, 0x05, 0xDA, 0x31}, 1);
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8124], on) << "longer than n allows";
  EXPECT_EQ(received().size(), 4U);
}

TEST_F(Tp03Modbus, AsciiRequest) {
  ascii();
  scan();
  command({0x01, 0x03, 0x00, 0x00, 0x00, 0x02});
  send();
  EXPECT_EQ(text(), ":010300000002FA\r\n");
  command({0xF7, 0x03, 0x13, 0x89, 0x00, 0x0A});
  send();
  EXPECT_EQ(text(), ":F7031389000A60\r\n");
}

TEST_F(Tp03Modbus, AsciiRemainingBytes) {
  ascii();
  sys.elapsed = 521;
  scan();
  command({0x01, 0x02});
  sys.M[8122] = on;
  for (int left : {2, 2, 1, 1, 0, 0, 0, 0, 0}) {
    scan();
    EXPECT_EQ(sys.D[8122], left) << sys.scripted.sent[0].size();
  }
  EXPECT_EQ(text(), ":0102FD\r\n");
}

TEST_F(Tp03Modbus, AsciiAnswer) {
  ascii();
  scan();
  answer(std::string("noise:01030400060005ED\r\nmore"), 1);
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8124], off);
  EXPECT_EQ(sys.M[8129], off);
  EXPECT_EQ(received(), (Bytes{0x01, 0x03, 0x04, 0x00, 0x06, 0x00, 0x05}));
  n = 7;
  answer(std::string(":01030400060005ED\r\n"), 1);
  EXPECT_EQ(sys.M[8124], off) << "exactly n";
  answer(std::string(":0103:01030400060005ED\r\n"), 1);
  EXPECT_EQ(sys.M[8124], off) << "':' begins a new telegram";
  EXPECT_EQ(received().size(), 7U);
  answer(std::string(":01030400060005ED"));
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8129], on) << "a pause may stand for the end";
  EXPECT_EQ(sys.M[8124], off);
}

TEST_F(Tp03Modbus, AsciiErrors) {
  ascii();
  scan();
  for (const char *wrong : {":01030400060005EE\r\n", ":0103040006000\r\n", ":01030400060005ED\rX", ":0103040006000GED\r\n",
                            ":01030400060005ED\n", ":01030400060005ed\r\n", ":00\r\n", ":\r\n"}) {
    answer(std::string(wrong), 1);
    EXPECT_EQ(sys.M[8123], on) << wrong;
    EXPECT_EQ(sys.M[8124], on) << wrong;
  }
  n = 6;
  answer(std::string(":01030400060005ED\r\n"), 1);
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8124], on) << "longer than n allows";
  answer(std::string(":0103"));
  EXPECT_EQ(sys.M[8124], on) << "a pause without a right check code";
}

TEST_F(Tp03Modbus, QuestionAndAnswer) {
  scan();
  for (int round = 0; round < 3; ++round) {
    command({0x01, 0x03, 0x00, 0x00, 0x00, 0x02});
    send();
    answer(Bytes{0x01, 0x03, 0x04, 0x00, 0x06, 0x00, 0x05, 0xDA, 0x31});
    EXPECT_EQ(sys.M[8124], off);
    EXPECT_EQ(received().size(), 7U);
  }
}
