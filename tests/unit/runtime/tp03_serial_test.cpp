// F80 RS, and what it shares with F87 MBUS: formats, the time that sending takes, who has a port.
#include "ladder/tp03/ops/serial.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

#include <string>

using namespace ladder;
using namespace ladder::tp03;

namespace {

constexpr Fault kNone = Fault::None, kRange = Fault::Range;

struct Tp03Serial : testing::Test {
  PanelMachine sys;
  Words<300> D;
  SerialTransfer rs;
  word m = 4, n = 4, port = 0;

  Tp03Serial() {
    sys.D[8120] = sys.D[8320] = 0x0081;  // 8 bits, no parity, 1 stop bit, 19200
    sys.D[8124] = sys.D[8324] = 2;
    sys.D[8125] = sys.D[8325] = 3;
    D[0] = 0x3231;
    D[1] = 0x3433;
    D[2] = 0x3635;
  }
  Fault scan(bit condition = on) { return rs.run(condition, D.block(0), m, D.block(100), n, port, sys); }
  std::string sent() { return {sys.scripted.sent[0].begin(), sys.scripted.sent[0].end()}; }
  std::string received(unsigned count) {
    std::string text;
    for (unsigned i = 0; i < count; ++i)
      text += static_cast<char>(tp03::detail::character(D.block(100), i, static_cast<bool>(sys.M[8161])));
    return text;
  }
  void arrive(const std::string &text) { sys.scripted.arrive(text); }
};

}  // namespace

TEST(Tp03SerialFormat, Words) {
  EXPECT_EQ(tp03::detail::serial_format(0x0089), (SerialFormat{19200, 8, 2, 'N'}));
  EXPECT_EQ(tp03::detail::serial_format(0x2099), (SerialFormat{38400, 8, 2, 'N'}));
  EXPECT_EQ(tp03::detail::serial_format(0x0072), (SerialFormat{9600, 7, 1, 'O'}));
  EXPECT_EQ(tp03::detail::serial_format(0x00E4), (SerialFormat{307200, 7, 1, 'E'}));
  EXPECT_EQ(tp03::detail::serial_format(0x00D7), (SerialFormat{153600, 8, 1, 'E'}));
  EXPECT_EQ(tp03::detail::serial_format(0), (SerialFormat{9600, 7, 1, 'N'}));
  EXPECT_EQ(tp03::detail::bits_of({9600, 7, 1, 'N'}), 9U);
  EXPECT_EQ(tp03::detail::bits_of({9600, 8, 2, 'E'}), 12U);
}

TEST_F(Tp03Serial, SendsAtTheSpeedOfTheLine) {
  sys.elapsed = 1000;
  EXPECT_EQ(scan(), kNone);
  EXPECT_EQ(sys.scripted.format, (SerialFormat{19200, 8, 1, 'N'}));
  EXPECT_EQ(sent(), "");
  sys.M[8122] = on;
  scan();
  EXPECT_EQ(sent(), "1") << "a byte goes out when its turn begins";
  EXPECT_EQ(sys.D[8122], 3);
  scan();
  EXPECT_EQ(sent(), "12") << "ten bits take 520 us";
  scan();
  EXPECT_EQ(sent(), "1234");
  EXPECT_EQ(sys.M[8122], on) << "the last bits are on the line";
  EXPECT_EQ(sys.D[8122], 0);
  scan();
  EXPECT_EQ(sys.M[8122], off);
  scan();
  EXPECT_EQ(sent(), "1234");
  sys.elapsed = 10000;
  sys.M[8122] = on;
  scan();
  scan();
  EXPECT_EQ(sent(), "12341234") << "one scan is enough";
  EXPECT_EQ(sys.M[8122], off);
}

TEST_F(Tp03Serial, LengthsAndModes) {
  sys.D[8120] = 0x0381;
  m = 3;
  scan();
  sys.M[8122] = on;
  scan();
  scan();
  EXPECT_EQ(sent(), "\x02"
                    "123"
                    "\x03");
  sys.scripted.sent[0].clear();
  sys.M[8161] = on;
  sys.M[8122] = on;
  scan();
  scan();
  EXPECT_EQ(sent(), "\x02"
                    "135"
                    "\x03")
      << "the low bytes of three words";
  sys.scripted.sent[0].clear();
  m = 0;
  sys.M[8122] = on;
  scan();
  EXPECT_EQ(sys.M[8122], off);
  EXPECT_EQ(sent(), "") << "nothing to send";
}

TEST_F(Tp03Serial, RemainingBytesCountDataOnly) {
  sys.D[8120] = 0x0371;
  sys.elapsed = 1042;
  scan();
  sys.M[8122] = on;
  for (int left : {4, 3, 2, 1, 0, 0}) {
    scan();
    EXPECT_EQ(sys.D[8122], left);
  }
  EXPECT_EQ(sent().size(), 6U);
}

TEST_F(Tp03Serial, HostThatCannotTakeAByte) {
  scan();
  sys.scripted.takes = false;
  sys.M[8122] = on;
  scan();
  scan();
  EXPECT_EQ(sys.D[8122], 4);
  sys.scripted.takes = true;
  scan();
  EXPECT_EQ(sent(), "1");
  scan();
  EXPECT_EQ(sent(), "1234");
  EXPECT_EQ(sys.M[8122], off);
}

TEST_F(Tp03Serial, FormatCountsWhenTheDriveBegins) {
  scan();
  sys.D[8120] = 0x0091;
  scan();
  EXPECT_EQ(sys.scripted.format.baud, 19200U);
  EXPECT_EQ(sys.scripted.opened, 1);
  scan(off);
  scan();
  EXPECT_EQ(sys.scripted.format.baud, 38400U);
}

TEST_F(Tp03Serial, ReceivesACount) {
  arrive("lost");
  scan();
  EXPECT_EQ(sys.M[8123], off) << "what came before the drive is gone";
  D[102] = 77;
  arrive("AB");
  scan();
  EXPECT_EQ(sys.D[8123], 2);
  EXPECT_EQ(sys.M[8123], off);
  arrive("CDE");
  scan();
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(received(4), "ABCD");
  EXPECT_EQ(D[102], 77);
  EXPECT_EQ(sys.D[8123], 4);
  arrive("FG");
  scan();
  EXPECT_EQ(sys.D[8123], 4) << "nothing is received until M8123 is reset";
  sys.M[8123] = off;
  arrive("HI");
  scan();
  EXPECT_EQ(sys.D[8123], 2);
  EXPECT_EQ(received(4), "HICD");
}

TEST_F(Tp03Serial, ReceivesBetweenStartAndEnd) {
  sys.D[8120] = 0x0381;
  n = 10;
  scan();
  arrive("xx\x02"
         "12\x02"
         "3\x03"
         "yy");
  scan();
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8129], off);
  EXPECT_EQ(sys.D[8123], 4);
  EXPECT_EQ(received(4), "12\x02"
                         "3");
  sys.M[8123] = off;
  arrive("4\x03");
  scan();
  EXPECT_EQ(sys.D[8123], 0) << "no start character";
  arrive("\x02\x03");
  scan();
  EXPECT_EQ(sys.M[8123], on) << "a telegram without data";
  EXPECT_EQ(sys.D[8123], 0);
}

TEST_F(Tp03Serial, PauseEndsATelegram) {
  sys.D[8129] = 6;
  n = 20;
  scan();
  for (int i = 0; i < 20; ++i)
    scan();
  EXPECT_EQ(sys.M[8123], off) << "nothing has begun";
  arrive("ABC");
  scan();
  for (int i = 0; i < 5; ++i)
    scan();
  EXPECT_EQ(sys.M[8123], off);
  arrive("D");
  scan();
  for (int i = 0; i < 5; ++i)
    scan();
  EXPECT_EQ(sys.M[8123], off);
  scan();
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8129], on);
  EXPECT_EQ(sys.D[8123], 4);
  sys.M[8123] = off;
  scan();
  EXPECT_EQ(sys.M[8129], off);
  sys.D[8129] = 4;
  arrive("A");
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(sys.M[8123], off);
    scan();
  }
  EXPECT_EQ(sys.M[8129], on) << "out of range means 50 ms";
}

TEST_F(Tp03Serial, RequestWaitsForTheReception) {
  scan();
  arrive("A");
  scan();
  sys.M[8122] = on;
  scan();
  EXPECT_EQ(sys.M[8121], on);
  EXPECT_EQ(sent(), "");
  arrive("BCD");
  scan();
  EXPECT_EQ(sys.M[8123], on);
  EXPECT_EQ(sys.M[8121], off);
  EXPECT_EQ(sent(), "1");
  scan();
  EXPECT_EQ(sent(), "1234");
  EXPECT_EQ(sys.M[8123], on) << "sending does not touch what was received";
}

TEST_F(Tp03Serial, AnswerThatComesWhileSending) {
  sys.elapsed = 1000;
  scan();
  sys.M[8122] = on;
  scan();
  arrive("WXYZ");
  scan();
  EXPECT_EQ(sys.D[8123], 0);
  scan();
  scan();
  EXPECT_EQ(sys.M[8122], off);
  EXPECT_EQ(received(4), "WXYZ") << "is taken behind it";
}

TEST_F(Tp03Serial, NothingToReceive) {
  n = 0;
  scan();
  arrive("ABCD");
  scan();
  EXPECT_EQ(sys.D[8123], 0);
  n = 4;
  arrive("ABCD");
  scan();
  EXPECT_EQ(sys.M[8123], off) << "does not wait yet";
  sys.M[8123] = on;
  scan();
  sys.M[8123] = off;
  arrive("EFGH");
  scan();
  EXPECT_EQ(received(4), "EFGH");
  EXPECT_EQ(sys.M[8123], on);
}

TEST_F(Tp03Serial, OffStops) {
  sys.elapsed = 1000;
  scan();
  sys.M[8122] = on;
  scan();
  scan(off);
  EXPECT_EQ(sys.M[8122], off);
  EXPECT_EQ(sent(), "1");
  for (int i = 0; i < 10; ++i)
    scan(off);
  EXPECT_EQ(sent(), "1");
  scan();
  EXPECT_EQ(sent(), "1");
  sys.M[8123] = on;
  scan(off);
  EXPECT_EQ(sys.M[8123], on) << "what was received stays";
  scan();
  arrive("ABCD");
  scan();
  EXPECT_EQ(sys.D[8123], 0);
}

TEST_F(Tp03Serial, OnePortOneUser) {
  SerialTransfer other;
  Modbus expansion;
  scan();
  EXPECT_EQ(other.run(on, D.block(0), 4, D.block(200), 4, 0, sys), kNone);
  EXPECT_EQ(expansion.run(on, D.block(0), 4, D.block(200), 4, 1, sys), kNone);
  EXPECT_EQ(sys.scripted.opened, 2) << "the expansion port has a user of its own";
  arrive("ABCD");
  other.run(on, D.block(0), 4, D.block(200), 4, 0, sys);
  scan();
  EXPECT_EQ(received(4), "ABCD");
  scan(off);
  sys.M[8123] = off;
  other.run(on, D.block(0), 4, D.block(200), 4, 0, sys);
  arrive("EFGH");
  other.run(on, D.block(0), 4, D.block(200), 4, 0, sys);
  EXPECT_EQ(D[200], 0x4645);
  sys.ports.restart();
  sys.M[8123] = off;
  scan();
  EXPECT_EQ(sys.scripted.opened, 4) << "STOP gives every port back";
}

TEST_F(Tp03Serial, ExpansionPortHasItsOwnDevices) {
  port = 1;
  scan();
  sys.M[8322] = on;
  sys.scripted.arrive(std::string("ABCD"), 1);
  scan();
  scan();
  EXPECT_EQ(sys.scripted.sent[1].size(), 4U);
  EXPECT_EQ(sys.M[8323], on);
  EXPECT_EQ(sys.D[8323], 4);
  EXPECT_EQ(sys.D[8123], 0);
  EXPECT_EQ(sys.M[8123], off);
}

TEST_F(Tp03Serial, Ranges) {
  for (word wrong : {word{-1}, word{256}}) {
    m = wrong;
    EXPECT_EQ(scan(), kRange);
    m = 4;
    n = wrong;
    EXPECT_EQ(scan(), kRange);
    n = 4;
  }
  EXPECT_EQ(rs.run(on, D.block(299), 3, D.block(0), 0, 0, sys), kRange);
  EXPECT_EQ(rs.run(on, D.block(299), 2, D.block(0), 0, 0, sys), kNone);
  EXPECT_EQ(rs.run(on, D.block(0), 0, D.block(299), 3, 0, sys), kRange);
  sys.M[8161] = on;
  EXPECT_EQ(rs.run(on, D.block(299), 2, D.block(0), 0, 0, sys), kRange);
  EXPECT_EQ(rs.run(off, D.block(299), 255, D.block(0), 0, 0, sys), kNone);
}

TEST_F(Tp03Serial, ModeThatChangesWhileSending) {
  m = 255;
  scan();
  sys.M[8122] = on;
  rs.run(on, D.block(172), 255, D.block(100), 4, 0, sys);
  sys.M[8161] = on;
  for (int i = 0; i < 40; ++i)
    EXPECT_EQ(rs.run(on, D.block(172), 4, D.block(100), 4, 0, sys), kNone);
  EXPECT_EQ(sys.scripted.sent[0].size(), 255U) << "words behind the last register are sent as 0";
}
