// F77 PR: characters to eight outputs, with a strobe and a busy signal.
//
// A character takes three scans: the data, the strobe ON, the strobe OFF. Where the manual is silent: the short mode goes on with
// the first character while the condition is ON; M8027 counts when an output begins; behind the end, or where the condition stops
// it, all ten outputs are OFF; in the long mode M8029 stays ON until the condition is OFF, and is ON for one scan where it is OFF
// already.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/drive.h"
#include "ladder/tp03/ops/keys.h"

#include <cstdint>

namespace ladder::tp03 {

class PrintCharacters {
public:
  template <class Block, class Run, class S> Fault run(bit condition, Block source, Run outputs, S &sys) noexcept {
    if (outputs.points() < kLines || source.points() < (sys.M[kLongMode] ? kLongest : kShortest) / 2)
      return condition ? Fault::Range : Fault::None;
    if (sys.first_scan())
      sending_ = done_ = false;
    if (drive_.see(condition, sys) == Drive::Starts && !(sending_ && long_))
      start(sys);
    if (!condition && sending_ && !long_)
      end(outputs);
    if (done_ && !condition)
      sys.set_complete(off);
    done_ &= static_cast<bool>(condition);
    if (sending_)
      step(source, outputs);
    if (done_)
      sys.set_complete(on);
    return Fault::None;
  }

private:
  static constexpr unsigned kLongMode = 8027;
  static constexpr unsigned kShortest = 8, kLongest = 16;  ///< characters
  static constexpr unsigned kData = 8, kStrobe = 8, kBusy = 9, kLines = 10;

  template <class S> void start(S &sys) noexcept {
    long_ = static_cast<bool>(static_cast<bit>(sys.M[kLongMode]));
    sending_ = true;
    done_ = false;
    character_ = stage_ = 0;
    if (long_)
      sys.set_complete(off);
  }
  template <class Run> void end(Run outputs) noexcept {
    detail::write_bits(outputs, 0, kLines, 0);
    sending_ = false;
  }
  template <class Block, class Run> void step(Block source, Run outputs) noexcept {
    if (stage_ == 0) {
      const std::uint32_t data = character_ < kLongest ? byte_of(source, character_) : 0;
      if (long_ && data == 0) {
        end(outputs);
        done_ = true;
        return;
      }
      detail::write_bits(outputs, 0, kData, data);
    }
    outputs.set(kStrobe, bit(stage_ == 1));
    outputs.set(kBusy, on);
    stage_ = static_cast<std::uint8_t>((stage_ + 1U) % 3U);
    if (stage_ == 0)
      ++character_;
    if (!long_ && character_ == kShortest)
      character_ = 0;
  }
  template <class Block> static std::uint32_t byte_of(const Block &source, unsigned i) noexcept {
    return i / 2 < source.points() ? pattern_of(source.get(i / 2)) >> 8 * (i % 2) & 0xFFU : 0;
  }

  DriveMemory drive_;
  bool sending_ = false, long_ = false, done_ = false;
  std::uint8_t character_ = 0, stage_ = 0;
};

}  // namespace ladder::tp03
