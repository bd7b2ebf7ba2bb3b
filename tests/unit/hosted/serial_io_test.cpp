// Serial ports over a pair of pseudo-terminals: the test holds the partner's end.
#include "captured_run.h"
#include "fake_controller.h"
#include "pseudo_terminal.h"

#include "ladder/hosted/serial_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <termios.h>
#include <thread>

namespace ladder::hosted::test {
namespace {

using testing::HasSubstr;

class SerialTest : public testing::Test {
protected:
  void SetUp() override {
    if (!line_.ok())
      GTEST_SKIP() << "this system has no pseudo-terminals";
  }
  /// What a device does arrives a moment later.
  int read_soon(unsigned port) {
    int byte = -1;
    wait_for([&] { return (byte = io_.read_serial(port)) >= 0; });
    return byte;
  }

  PseudoTerminal line_;
  SerialIo io_;
};

TEST_F(SerialTest, BytesGoBothWaysAsTheyAre) {
  io_.attach(0, line_.path());
  io_.open_serial(0, {9600, 8, 1, 'N'});
  EXPECT_EQ(io_.read_serial(0), -1) << "nothing has come, and nobody waits";
  line_.send("\r\x03\xFF\n");
  for (int byte : {0x0D, 0x03, 0xFF, 0x0A})
    EXPECT_EQ(read_soon(0), byte);
  EXPECT_EQ(io_.read_serial(0), -1);
  for (unsigned char byte : {0x0A, 0x11, 0x00, 0x80})
    EXPECT_TRUE(io_.write_serial(0, byte));
  EXPECT_EQ(line_.receive(4), std::string("\x0A\x11\x00\x80", 4));
}

TEST_F(SerialTest, ADeviceEchoesNothingBeforeTheProgramOpensIt) {
  io_.attach(2, line_.path());
  line_.send("hello\n");
  EXPECT_EQ(read_soon(2), 'h');
  EXPECT_EQ(line_.receive_now(), "");
}

TEST_F(SerialTest, TheProgramsFormatIsSet) {
  io_.attach(0, line_.path());
  io_.open_serial(0, {4800, 8, 2, 'N'});
  EXPECT_EQ(cfgetospeed(line_.settings().get()), speed_t{B4800});
  EXPECT_NE(line_.settings()->c_cflag & CSTOPB, 0u);
  io_.open_serial(0, {19200, 8, 1, 'N'});
  EXPECT_EQ(cfgetospeed(line_.settings().get()), speed_t{B19200});
  EXPECT_EQ(line_.settings()->c_cflag & CSTOPB, 0u);
}

TEST_F(SerialTest, AFormatThatNoDeviceHasIsReportedOnce) {
  char *text = nullptr;
  std::size_t size = 0;
  std::FILE *err = open_memstream(&text, &size);
  {
    SerialIo io(err);
    io.attach(0, line_.path());
    io.open_serial(0, {12345, 7, 2, 'E'});
    io.open_serial(0, {12345, 7, 2, 'E'});
  }
  std::fclose(err);
  EXPECT_EQ(std::string(text, size), line_.path() + ": cannot be set to 12345 bauds, 7 data bits, parity E, 2 stop bits\n");
  std::free(text);
}

TEST_F(SerialTest, APartnerThatGoesAwayIsSilence) {
  io_.attach(0, line_.path());
  line_.close_partner();
  EXPECT_EQ(io_.read_serial(0), -1);
  EXPECT_TRUE(io_.write_serial(0, 'A')) << "lost, and not tried for ever";
}

TEST_F(SerialTest, APortWithoutDeviceIsSilent) {
  EXPECT_EQ(io_.read_serial(1), -1);
  EXPECT_TRUE(io_.write_serial(1, 'A'));
  io_.open_serial(1, {9600, 8, 1, 'N'});
}

TEST_F(SerialTest, ADeviceTakesThePlaceOfAnother) {
  PseudoTerminal second;
  io_.attach(0, line_.path());
  io_.attach(0, second.path());
  second.send("B");
  EXPECT_EQ(read_soon(0), 'B');
}

TEST_F(SerialTest, WhatIsNoSerialDeviceIsRefused) {
  EXPECT_THROW(io_.attach(0, "/nowhere/tty"), SerialError);
  EXPECT_THROW(io_.attach(0, "/dev/null"), SerialError);
}

TEST_F(SerialTest, AProgramTalksThroughTheOption) {
  // What a device received before it was opened is thrown away, so the partner waits until the program has set its format.
  std::thread partner([this] {
    wait_for([&] { return cfgetospeed(line_.settings().get()) == speed_t{B19200}; });
    line_.send("AZ");
  });
  CapturedRun result =
      run({"--serial", "0=" + line_.path(), "--scan-time", "1ms", "--scans", "5000", "--quiet", "--watch", "D0"}, kController);
  partner.join();
  EXPECT_EQ(result.exit, 0);
  EXPECT_THAT(result.err, HasSubstr("the program stopped the CPU")) << "at the Z";
  EXPECT_THAT(result.out, HasSubstr("D0=2\n"));
  EXPECT_EQ(line_.receive(2), "B[");
}

TEST(SerialOption, WhatCannotBeConnectedExitsWith2) {
  CapturedRun missing = run({"--serial", "0=/nowhere/tty"}, kController);
  EXPECT_EQ(missing.exit, 2);
  EXPECT_EQ(missing.err, "fake: cannot open '/nowhere/tty': No such file or directory\n");
  EXPECT_EQ(run({"--serial", "0=/dev/null"}, kController).err, "fake: '/dev/null' is no serial device\n");
}

TEST_F(SerialTest, AControllerWithoutPortsIsSaid) {
  CapturedRun result = run({"--serial", "0=" + line_.path()});
  EXPECT_EQ(result.exit, 2);
  EXPECT_EQ(result.err, "fake: this controller has no serial ports\n");
}

}  // namespace
}  // namespace ladder::hosted::test
