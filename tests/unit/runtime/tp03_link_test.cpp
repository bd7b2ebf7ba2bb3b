// F190 DTLK, F193 DTLK2, F191 RMIO: controllers that talk to each other over one line.
#include "ladder/tp03/ops/link.h"
#include "printing.h"
#include "tp03_panel_machine.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

using namespace ladder;
using namespace ladder::tp03;

namespace {

constexpr Fault kNone = Fault::None, kRange = Fault::Range;

/// A controller on the line: what one writes, all others hear.
struct Station {
  PanelMachine sys;
  ScriptedIo &io = sys.scripted;
  Bits<256> X, Y;
  Bits<3100> M;
  Words<1000> D;
  DataLink dtlk;
  DataLink2 dtlk2;
  RemoteInOut rmio;
  bool present = true;
  bit driven = on;
};

struct Tp03Link : testing::Test {
  std::vector<std::unique_ptr<Station>> stations;
  std::function<Fault(Station &)> run = [](Station &s) { return s.dtlk.run(s.driven, s.M, s.D, 0, s.sys); };
  /// What a station hears instead of a byte from another one; -1: nothing.
  std::function<int(unsigned from, unsigned to, int byte)> noise = [](unsigned, unsigned, int byte) { return byte; };

  void connect(unsigned count, unsigned settings = 8176) {
    for (unsigned number = 0; number < count; ++number) {
      stations.push_back(std::make_unique<Station>());
      PanelMachine &sys = stations.back()->sys;
      sys.D[settings] = static_cast<word>(number);
      sys.D[settings + 1] = static_cast<word>(count - 1);
      sys.D[settings + 3] = 3;
      sys.D[settings + 4] = 5;
      sys.D[8120] = 0x0091;  // 38400
    }
  }
  Station &operator[](unsigned number) { return *stations[number]; }
  PanelMachine &sys(unsigned number) { return stations[number]->sys; }

  /// The master comes last, so that the slaves hear it from its first byte on.
  void scan(int count = 1) {
    for (int i = 0; i < count; ++i)
      for (unsigned number = static_cast<unsigned>(stations.size()); number-- > 0;)
        if ((*this)[number].present) {
          EXPECT_EQ(run((*this)[number]), kNone);
          deliver(number);
        }
  }
  void deliver(unsigned from) {
    for (const int byte : (*this)[from].io.sent[0])
      for (unsigned to = 0; to < stations.size(); ++to)
        if (const int heard = to == from ? -1 : noise(from, to, byte); heard >= 0)
          (*this)[to].io.arriving[0].push_back(heard);
    (*this)[from].io.sent[0].clear();
  }
  std::vector<int> errors(unsigned number, unsigned first = 8400, unsigned count = 4) {
    std::vector<int> states;
    for (unsigned i = 0; i < count; ++i)
      states.push_back(sys(number).M[first + i] ? 1 : 0);
    return states;
  }
};

using States = std::vector<int>;

}  // namespace

// ---------------------------------------------------------------------------------------------- DTLK

TEST_F(Tp03Link, WordsGoFromEachToAll) {
  connect(4);
  for (unsigned s = 0; s < 4; ++s)
    for (unsigned i = 0; i < 4; ++i)
      (*stations[s]).D[10 * s + i] = static_cast<word>(1000 * s + i + 1);
  (*stations[0]).D[4] = 99;
  scan(60);
  for (unsigned number = 0; number < 4; ++number) {
    for (unsigned s = 0; s < 4; ++s)
      for (unsigned i = 0; i < 4; ++i)
        EXPECT_EQ((*this)[number].D[10 * s + i], static_cast<word>(1000 * s + i + 1)) << number << s << i;
    EXPECT_EQ(errors(number), (States{0, 0, 0, 0})) << number;
    EXPECT_EQ(sys(number).M[8416], on);
    EXPECT_EQ(sys(number).M[8418], on);
    EXPECT_EQ(sys(number).M[8417], off);
    EXPECT_EQ(sys(number).D[8173], static_cast<word>(number));
    EXPECT_EQ(sys(number).D[8174], 3);
    EXPECT_GT(sys(number).D[8401], 0);
    EXPECT_GE(sys(number).D[8402], sys(number).D[8401]);
  }
  EXPECT_EQ((*this)[1].D[4], 0) << "four words of each";
  (*this)[2].D[20] = -5;
  (*this)[2].D[10] = 4711;
  scan(60);
  EXPECT_EQ((*this)[0].D[20], -5);
  EXPECT_EQ((*this)[3].D[20], -5);
  EXPECT_EQ((*this)[2].D[10], 1001) << "the area of another station is written by that only";
}

TEST_F(Tp03Link, RefreshModes) {
  for (word mode = 0; mode <= 2; ++mode) {
    stations.clear();
    connect(3);
    sys(0).D[8178] = mode;
    sys(1).D[8178] = 1;
    for (unsigned i = 0; i < 64; ++i) {
      (*this)[1].M[2064 + i] = on;
      (*this)[0].M[2000 + i] = bit(i % 3 == 0);
    }
    for (unsigned i = 0; i < 8; ++i)
      (*this)[1].D[10 + i] = 5;
    scan(60);
    const unsigned bits = static_cast<unsigned>(mode) * 32, words = mode == 2 ? 8 : 4;
    for (unsigned number : {0U, 2U}) {
      for (unsigned i = 0; i < 64; ++i)
        EXPECT_EQ((*this)[number].M[2064 + i], bit(i < bits)) << mode << " " << i;
      for (unsigned i = 0; i < 8; ++i)
        EXPECT_EQ((*this)[number].D[10 + i], i < words ? 5 : 0) << mode << " " << i;
    }
    for (unsigned i = 0; i < 64; ++i)
      EXPECT_EQ((*this)[2].M[2000 + i], bit(i < bits && i % 3 == 0)) << mode << " " << i;
    EXPECT_EQ(sys(2).D[8175], mode) << "the master tells it";
  }
}

TEST_F(Tp03Link, TimesOfTheManual) {
  // Milliseconds at 9600 bps with 11 bits a byte: settings, request, data of the three modes.
  const struct {
    word mode;
    double data;
  } modes[] = {{0, 31.0}, {1, 40.1}, {2, 67.6}};
  for (const auto &[mode, data] : modes) {
    stations.clear();
    connect(2);
    for (unsigned number : {0U, 1U}) {
      sys(number).D[8120] = 0x0079;
      sys(number).D[8178] = mode;
      sys(number).elapsed = 1000;
    }
    scan(2000);
    // A scan for the slave to see the request, one for the master to see the answer, and rounding.
    EXPECT_NEAR(sys(0).D[8401] * 10, 21.8 + data + 12.6 + data, 10.0) << mode;
  }
}

TEST_F(Tp03Link, MissingSlave) {
  connect(4);
  scan(60);
  (*this)[2].present = false;
  scan(60);
  EXPECT_EQ(errors(0), (States{0, 0, 1, 0}));
  EXPECT_EQ(sys(0).D[8421], 0x01);
  EXPECT_GT(sys(0).D[8405], 0);
  EXPECT_EQ(errors(1), (States{0, 0, 1, 0}));
  EXPECT_EQ(sys(1).D[8421], 0x21) << "another slave sees it too";
  EXPECT_EQ(sys(0).M[8063], on);
  EXPECT_EQ(sys(0).D[8063], 6301);
  EXPECT_EQ(sys(0).M[8416], on) << "the others are there";
  (*this)[3].D[31] = 17;
  scan(60);
  EXPECT_EQ((*this)[1].D[31], 17);
  const word count = sys(0).D[8405];
  (*this)[2].present = true;
  scan(60);
  EXPECT_EQ(errors(0), (States{0, 0, 0, 0}));
  EXPECT_EQ(errors(1), (States{0, 0, 0, 0}));
  EXPECT_EQ(sys(0).D[8421], 0);
  EXPECT_LE(sys(0).D[8405] - count, 1) << "the count stays";
  EXPECT_EQ(sys(0).M[8063], off);
}

TEST_F(Tp03Link, MasterAlone) {
  connect(1);
  sys(0).D[8177] = 2;
  const auto scans_until = [&](const std::function<bool()> &reached) {
    int scans = 0;
    for (; scans < 200 && !reached(); ++scans)
      scan();
    return scans;
  };
  // A try is a scan to send the request and five to wait for the answer.
  EXPECT_NEAR(scans_until([&] { return bool(sys(0).M[8401]); }), 3 * 6, 3);
  EXPECT_EQ(sys(0).M[8402], off);
  EXPECT_NEAR(scans_until([&] { return bool(sys(0).M[8402]); }), 3 * 6, 1);
  EXPECT_EQ(sys(0).D[8420], 0x01);
  EXPECT_EQ(sys(0).D[8404], 1);
  EXPECT_EQ(sys(0).D[8421], 0x01);
  EXPECT_EQ(sys(0).M[8416], off);
  EXPECT_EQ(sys(0).M[8418], on);
  EXPECT_NEAR(scans_until([&] { return sys(0).D[8405] == 2; }), 2 * 6, 3) << "one try in each round while it is in error";
  EXPECT_EQ(sys(0).D[8404], 2);
}

TEST_F(Tp03Link, MasterGoesAway) {
  connect(3);
  scan(60);
  (*this)[0].present = false;
  scan(40);
  EXPECT_EQ(sys(1).M[8400], off);
  scan(40);
  for (unsigned number : {1U, 2U}) {
    EXPECT_EQ(sys(number).M[8400], on);
    EXPECT_EQ(sys(number).D[8419], 0x11);
    EXPECT_EQ(sys(number).D[8403], 1);
    EXPECT_EQ(sys(number).M[8416], off);
    EXPECT_EQ(sys(number).M[8418], on);
  }
  (*this)[0].present = true;
  scan(40);
  EXPECT_EQ(sys(1).M[8400], off);
  EXPECT_EQ(sys(1).M[8416], on);
}

TEST_F(Tp03Link, SlaveWithoutMasterWaits) {
  connect(2);
  (*this)[0].present = false;
  scan(200);
  EXPECT_EQ(errors(1), (States{0, 0, 0, 0}));
  EXPECT_EQ(sys(1).M[8416], off);
}

TEST_F(Tp03Link, TwoSlavesOfOneNumber) {
  connect(3);
  sys(2).D[8176] = 1;  // and nobody is slave 2
  scan(80);
  EXPECT_EQ(sys(0).M[8402], on);
  EXPECT_NE(sys(0).D[8421], 0);
}

TEST_F(Tp03Link, NoiseIsFoundAndOvercome) {
  connect(3);
  unsigned damaged = 0, bytes = 0;
  noise = [&](unsigned, unsigned, int byte) {
    const bool hit = ++bytes % 97 == 0;
    damaged += hit ? 1U : 0U;
    return hit ? byte ^ 1 : byte;
  };
  for (int i = 0; i < 200; ++i) {
    (*this)[1].D[10] = static_cast<word>(i);
    (*this)[1].D[11] = static_cast<word>(~i);
    scan();
    const word seen = (*this)[0].D[10], inverse = (*this)[0].D[11];
    EXPECT_TRUE((seen == 0 && inverse == 0) || seen == static_cast<word>(~inverse)) << "damaged data are not taken";
  }
  EXPECT_GT(damaged, 20U);
  noise = [](unsigned, unsigned, int byte) { return byte; };
  scan(100);
  EXPECT_EQ(errors(0), (States{0, 0, 0, 0}));
  EXPECT_EQ(errors(2), (States{0, 0, 0, 0}));
}

TEST_F(Tp03Link, DamagedAnswers) {
  connect(3);
  scan(60);
  noise = [](unsigned from, unsigned, int byte) { return from == 1 && byte == '\r' ? ' ' : byte; };
  scan(60);
  EXPECT_EQ(sys(0).M[8401], on);
  EXPECT_EQ(sys(0).D[8420], 0x04);
  EXPECT_EQ(sys(2).M[8401], on);
  EXPECT_EQ(sys(2).D[8420], 0x04);
  noise = [](unsigned from, unsigned, int byte) { return from == 0 && byte == '\r' ? ' ' : byte; };
  scan(60);
  EXPECT_EQ(sys(1).M[8400], on);
  EXPECT_TRUE(sys(1).D[8419] == 0x14 || sys(1).D[8419] == 0x11);
}

TEST_F(Tp03Link, SettingsCountBehindTheFirstScan) {
  connect(2);
  sys(1).first = on;
  sys(1).D[8176] = 0;
  scan();
  EXPECT_EQ(sys(1).M[8418], off) << "the program may still write its number";
  sys(1).D[8176] = 1;
  sys(1).first = off;
  scan();
  EXPECT_EQ(sys(1).D[8173], 1);
  sys(1).D[8176] = 5;
  scan(60);
  EXPECT_EQ(sys(1).D[8173], 1) << "a change waits for the next RUN";
  EXPECT_EQ(errors(0), (States{0, 0, 0, 0}));
}

TEST_F(Tp03Link, SettingsOutOfRange) {
  connect(1);
  for (unsigned place : {8177U, 8178U, 8179U, 8180U})
    sys(0).D[place] = -1;
  scan(2);
  EXPECT_EQ(sys(0).D[8174], 7);
  EXPECT_EQ(sys(0).D[8175], 0);
  Station wrong;
  wrong.sys.D[8176] = 16;
  EXPECT_EQ(wrong.dtlk.run(on, wrong.M, wrong.D, 0, wrong.sys), kRange);
  EXPECT_EQ(wrong.sys.M[8418], off);
  EXPECT_EQ(wrong.dtlk.run(off, wrong.M, wrong.D, 0, wrong.sys), kNone);
}

TEST_F(Tp03Link, OneDataLinkOnOnePort) {
  connect(2);
  scan();
  Station &s = (*this)[0];
  EXPECT_EQ(s.dtlk2.run(on, s.D.block(500), 4, 1, s.sys), kNone);
  EXPECT_EQ(s.sys.M[8417], off) << "the first one that was driven wins";
  EXPECT_TRUE(s.sys.ports.claim(1, this)) << "and the other port is free";
  s.sys.ports.release(1, this);
  s.driven = off;
  scan();
  EXPECT_EQ(s.sys.M[8418], off);
  EXPECT_EQ(s.dtlk2.run(on, s.D.block(500), 4, 1, s.sys), kNone);
  EXPECT_EQ(s.sys.M[8417], on);
  scan();
  EXPECT_EQ(s.sys.M[8417], on) << "OFF of the other one changes nothing";
  s.sys.ports.restart();
  s.dtlk2.run(off, s.D.block(500), 4, 1, s.sys);
  EXPECT_EQ(s.sys.M[8417], off);
}

TEST_F(Tp03Link, SlaveThatMissedTheSettings) {
  connect(2);
  noise = [](unsigned, unsigned, int) { return -1; };
  scan();
  Station &slave = (*this)[1];
  slave.io.arrive(std::string(":010201FC\r\n"));
  scan();
  EXPECT_EQ(sys(1).M[8401], on);
  EXPECT_EQ(sys(1).D[8420], 0x31);
  EXPECT_EQ(slave.io.arriving[0].size(), 0U);
}

TEST_F(Tp03Link, SlaveSeesWhatOthersDoWrong) {
  connect(2);
  noise = [](unsigned, unsigned, int) { return -1; };
  Station &slave = (*this)[1];
  const auto hears = [&](const std::string &text) {
    slave.io.arrive(text);
    scan();
    return static_cast<int>(sys(1).D[8422]);
  };
  scan();
  EXPECT_EQ(hears(":00010003000503F4\r\n"), 0);
  EXPECT_EQ(hears(":030205F6\r\n:0203050000000000000000F6\r\n"), 0x22) << "slave 2 answers for slave 3";
  EXPECT_EQ(hears(":030205F6\r\n:0303050000000000000000F5\r\n"), 0);
  EXPECT_EQ(hears(":030205F6\r\n:0303040000000000000000F6\r\n"), 0x23) << "another counter";
  EXPECT_EQ(hears(":030205F6\r\n:030905EF\r\n"), 0x32) << "no such command";
  EXPECT_EQ(hears(":030205F6\r\n:030305000000F5\r\n"), 0x04) << "too short";
  EXPECT_EQ(hears(":030205F6\r\n:030205F6\r\n"), 0x21) << "no answer";
  hears(":030905EF\r\n");
  EXPECT_EQ(hears(":000905F2\r\n"), 0x32);
  EXPECT_EQ(sys(1).D[8419], 0x14);
  EXPECT_EQ(sys(1).M[8400], on);
}

// ---------------------------------------------------------------------------------------------- DTLK2

TEST_F(Tp03Link, FreeAreas) {
  connect(3);
  run = [](Station &s) { return s.dtlk2.run(s.driven, s.D.block(100), 40, 0, s.sys); };
  for (unsigned s = 0; s < 3; ++s)
    for (unsigned i = 0; i < 40; ++i)
      (*this)[s].D[100 + 40 * s + i] = static_cast<word>(100 * s + i + 1);
  scan(100);
  for (unsigned number = 0; number < 3; ++number)
    for (unsigned s = 0; s < 3; ++s)
      for (unsigned i = 0; i < 40; ++i)
        EXPECT_EQ((*this)[number].D[100 + 40 * s + i], static_cast<word>(100 * s + i + 1)) << number << " " << s << " " << i;
  EXPECT_EQ(sys(1).D[8175], 0) << "not used";
}

TEST_F(Tp03Link, LengthsMustAgree) {
  connect(3);
  run = [this](Station &s) {
    const word words = &s == stations[1].get() ? word{3} : word{4};
    return s.dtlk2.run(s.driven, s.D.block(100), words, 0, s.sys);
  };
  (*this)[2].D[108] = 9;
  scan(80);
  EXPECT_EQ(sys(1).M[8400], on);
  EXPECT_EQ(sys(1).D[8419], 0x14);
  EXPECT_EQ(sys(0).M[8401], on);
  EXPECT_EQ((*this)[0].D[108], 9) << "the others go on";
}

TEST_F(Tp03Link, AreasMustExist) {
  Station s;
  s.sys.D[8177] = 3;
  EXPECT_EQ(s.dtlk2.run(on, s.D.block(1000 - 16), 4, 0, s.sys), kNone);
  EXPECT_EQ(s.dtlk2.run(on, s.D.block(1000 - 15), 4, 0, s.sys), kRange);
  for (word words : {word{0}, word{41}, word{-1}}) {
    EXPECT_EQ(s.dtlk2.run(on, s.D.block(0), words, 0, s.sys), kRange);
    EXPECT_EQ(s.dtlk2.run(off, s.D.block(0), words, 0, s.sys), kNone);
  }
}

TEST_F(Tp03Link, SlaveWithoutRoomForAll) {
  connect(3);
  run = [this](Station &s) { return s.dtlk2.run(s.driven, s.D.block(&s == stations[1].get() ? 992 : 100), 4, 0, s.sys); };
  (*this)[0].D[100] = 7;
  (*this)[1].D[996] = 8;
  (*this)[2].D[108] = 9;
  scan(80);
  EXPECT_EQ((*this)[1].D[992], 7);
  EXPECT_EQ((*this)[2].D[104], 8);
  EXPECT_EQ(errors(1), (States{0, 0, 0, 0}));
}

// ---------------------------------------------------------------------------------------------- RMIO

namespace {

struct Tp03Remote : Tp03Link {
  Tp03Remote() {
    run = [](Station &s) { return s.rmio.run(s.driven, s.X, s.Y, 0, s.sys); };
  }
};

}  // namespace

TEST_F(Tp03Remote, InputsAndOutputs) {
  connect(5, 8376);
  (*this)[1].X[0] = on;
  (*this)[2].X[037] = on;
  (*this)[4].X[5] = on;
  (*this)[0].Y[0207] = on;
  (*this)[0].Y[0377] = on;
  (*this)[3].Y[0] = on;
  scan(60);
  EXPECT_EQ((*this)[0].X[0200], on);
  EXPECT_EQ((*this)[0].X[0277], on);
  EXPECT_EQ((*this)[0].X[0345], on);
  EXPECT_EQ((*this)[0].X[0], off);
  EXPECT_EQ((*this)[1].Y[7], on);
  EXPECT_EQ((*this)[4].Y[037], on);
  EXPECT_EQ((*this)[3].Y[0], off) << "the master says so";
  EXPECT_EQ((*this)[2].Y[7], off);
  for (unsigned number = 0; number < 5; ++number) {
    EXPECT_EQ(sys(number).M[8335], on);
    EXPECT_EQ(sys(number).M[8342], on);
    EXPECT_EQ(sys(number).D[8373], static_cast<word>(number));
    EXPECT_EQ(sys(number).D[8374], 4);
    EXPECT_EQ(errors(number, 8336, 5), (States{0, 0, 0, 0, 0}));
  }
  EXPECT_GT(sys(0).D[8331], 0);
}

TEST_F(Tp03Remote, LostSlaveAndLostMaster) {
  connect(3, 8376);
  (*this)[0].Y[0200] = on;
  scan(60);
  EXPECT_EQ((*this)[1].Y[0], on);
  (*this)[2].present = false;
  scan(60);
  EXPECT_EQ(errors(0, 8336, 5), (States{0, 0, 1, 0, 0}));
  EXPECT_EQ(sys(0).D[8340], 0x01);
  EXPECT_GT(sys(0).D[8335], 0);
  EXPECT_EQ(sys(0).D[8063], 6302);
  EXPECT_EQ(sys(1).D[8340], 0x21);
  (*this)[0].present = false;
  scan(80);
  EXPECT_EQ(sys(1).M[8336], on);
  EXPECT_EQ(sys(1).D[8338], 0x11);
  EXPECT_EQ(sys(1).D[8333], 1);
  EXPECT_EQ((*this)[1].Y[0], off) << "outputs of a lost slave are OFF";
}

TEST_F(Tp03Remote, CodesOfItsOwn) {
  connect(2, 8376);
  scan(60);
  noise = [](unsigned, unsigned, int) { return -1; };
  Station &slave = (*this)[1];
  slave.io.arrive(std::string(":000905F2\r\n"));
  scan();
  EXPECT_EQ(sys(1).D[8338], 0x13);
  slave.io.arrive(std::string(":03020500000000F6\r\n"));
  scan();
  slave.io.arrive(std::string(":030905EF\r\n"));
  scan();
  EXPECT_EQ(sys(1).D[8341], 0x23);
  slave.io.arrive(std::string(":01020500F8\r\n"));
  scan();
  EXPECT_EQ(sys(1).D[8338], 0x14) << "a request without outputs";
}

TEST_F(Tp03Remote, NumbersAboveFour) {
  Station s;
  s.sys.D[8376] = 5;
  EXPECT_EQ(s.rmio.run(on, s.X, s.Y, 0, s.sys), kRange);
}
