// What a generated program looks like to the runtime: every member and function of its interface, used once.
#include "ladder/describe.h"
#include "ladder/melsec_qs.h"

#include <cstdint>

namespace {

using namespace ladder;

constexpr melsec_qs::Parameters kParameters{
    "MAIN    ", 100000, 10000, 0, 200000, {6144, 6144, 6144, 0, 2048, 1024, 1536, 1024, 0, 512, 16, 512, 6144, 2048, 1536}};

struct Program {
  Bits<64> X, Y;
  Bits<200> M;
  Bits<1024> F;
  Bits<8> edge;
  Words<100> D;
  Words<16> W;
  Timers<4> T;
  Timers<2> ST;
  Counters<3> C;
  Gap gap;
  melsec_qs::System<> sys;

  bool scan(Micros now) noexcept;
  void bits() noexcept;
  bool words() noexcept;
  bool blocks() noexcept;
  void crossings() noexcept;
};

static_assert(shape_of<decltype(Program::X)>() == (kPackedBits ? Shape::PackedBits : Shape::Bits));
static_assert(count_of<decltype(Program::T)>() == 4);

void Program::bits() noexcept {
  Y[5] = (X[0] | Y[5]) & !X[1];
  Y[0x1F] |= X[4] ^ M[3];
  Y[5] &= !X[0];
  M[0] = X[0];
  M[1] = on;
  M[2] = rising(D.bit(0, 3), X[3]);
  D.bit(2, 0xF) = X[2];
  D.bit(2, 3) |= X[1];
  D.bit(2, 3) &= !X[1];
  if (falling(edge[1], D.bit(0, 5) & X[3]))
    Y[2] = !Y[2];
  T[0].on_delay_low(X[0], 50, sys);
  T[1].on_delay_high(X[0], D[3], sys);
  ST[0].retentive_low(X[0], 50, sys);
  ST[1].retentive_high(X[0] & T[0].contact, 50, sys);
  C[0].count_up(T[0].contact, 10, sys);
  if (rising(edge[0], X[3])) {
    C[0].reset();
    ST[0].reset();
  }
  Y[9] = ops::greater_equal(D[0], D[1]) & X[3] & ops::equal(D.pair(0), 100000);
}

bool Program::words() noexcept {
  D[0] = 100;
  D[1] = ops::add(D[0], 10);
  D[2] = ops::word_and(X.word<3>(0x10), 0x00FF);
  D.pair(4) = ops::dadd(D.pair(0), X.dword<5>(3));
  Y.digits<4>(0x10) = ops::complement(D[3]);
  Y.digits<8>(0) = ops::dmul(D.pair(0), 5);
  D.quad(6) = ops::dmul(D.pair(0), D.pair(2));
  if (!ops::div(D[0], D[1], D[2], D[3]))
    return sys.operation_error(4100, 20);
  if (!ops::ddiv(D.pair(0), X.dword<4>(0), Y.digits<8>(4)))
    return sys.operation_error(4100, 21);
  if (!ops::ddiv(D.pair(0), D.pair(2), D.pair(4), D.pair(6)))
    return sys.operation_error(4100, 22);
  if (!ops::bcd(D[0], Y.digits<4>(0x10)))
    return sys.operation_error(4100, 23);
  if (!ops::dbin(X.dword<8>(0), D.pair(8)) && !sys.SM[722])
    return sys.operation_error(4100, 24);
  if (X[7])
    return sys.abort(D[0], 30);
  return true;
}

bool Program::blocks() noexcept {
  return ops::bmov(D.block(10), D.block(11), 5) && ops::bmov(D.block(10), M.digit_block<2>(1), D[0]) &&
         ops::bmov(T.block(0), W.block(1), D[0]) && ops::bmov(X.digit_block<1>(5), C.block(0), 2) &&
         ops::fmov(0, M.digit_block<3>(0), 7);
}

void Program::crossings() noexcept {
  pair(D[99], W[0]) = 100000;
  quad(D[99], W[0], W[1], gap.discard()) = ops::dmul(pair(W[15], gap.discard()), 3);
  digits_of(X[62], X[63], Y[0], Y[1]) = D[0];
  D[3] = digits_of(X[62], X[63], Y[0], Y[1]).word();
  D.pair(0) = digits_of(X[62], X[63], Y[0], Y[1]).dword();
}

bool Program::scan(Micros now) noexcept {
  if (!sys.begin_scan(now))
    return false;
  bits();
  if (!words())
    return false;
  if (!blocks())
    return sys.operation_error(4101, 40);
  crossings();
  sys.annunciator_out(F, 12, X[5], 50);
  sys.annunciator_set(F, 13, 51);
  sys.annunciator_reset(F, 12);
  sys.end_scan(F);
  return true;
}

Program program;

}  // namespace

extern "C" {

void program_power_on() {
  program.sys.power_on(kParameters);
}
void program_set_mode(int run) {
  program.sys.set_mode(run != 0 ? Mode::Run : Mode::Stop);
}
bool program_scan(std::uint32_t now) {
  return program.scan(now);
}
bool program_set_calendar(std::uint16_t year) {
  return program.sys.set_calendar({year, 1, 1, 0, 0, 0, 0});
}
std::uint32_t program_errors() {
  program.sys.watchdog_error();
  program.sys.scan_time_error(30000);
  return program.sys.status().step;
}

/// Looked at by check_program.cmake.
void self_hold() {
  program.Y[5] = (program.X[0] | program.Y[5]) & !program.X[1];
}
}
