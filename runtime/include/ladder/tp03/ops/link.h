// Links between controllers: F190 DTLK, F193 DTLK2, F191 RMIO.
//
// Each station of a data link writes an area that all others read. Remote I/O makes the first 32 inputs and outputs of up to four
// slaves those of the master. The table of that is lost in the manual; here slave s has X200-X237 and Y200-Y237 of the master (s =
// 1), X240 and Y240 on, X300 and Y300 on, X340 and Y340 on. The outputs of a slave that misses its master go OFF. Telegrams:
// link_frame.h; who speaks when, and what happens on errors: link_station.h.
#pragma once

#include "ladder/bit.h"
#include "ladder/number.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/ops/link_station.h"

#include <cstdint>

namespace ladder::tp03 {
namespace detail {

/// 16 bits of an image; numbers that it does not have read 0 and keep nothing.
template <class Image> word read_image(const Image &image, unsigned first) noexcept {
  std::uint32_t pattern = 0;
  for (unsigned i = 0; i < 16 && Image::has(first + i); ++i)
    pattern |= std::uint32_t{static_cast<bit>(image[first + i]).value()} << i;
  return to_word(pattern);
}
template <class Image> void write_image(Image &image, unsigned first, word value) noexcept {
  for (unsigned i = 0; i < 16 && Image::has(first + i); ++i)
    image[first + i] = bit::lowest_of(pattern_of(value) >> i);
}

/// Data links ask with nothing, and a silent master changes nothing.
struct SharedArea {
  unsigned request_words() const noexcept { return 0; }
  word request_word(unsigned, unsigned) const noexcept { return 0; }
  void take_request(unsigned, word) const noexcept {}
  void master_lost() const noexcept {}
};

}  // namespace detail

struct DataLinkRules {
  static constexpr LinkDevices kDevices = {8176, 8173, 8401, 8403, 8419, 8400, 8416, {8418, 8417}};
  static constexpr unsigned kMostSlaves = 15, kMostWords = 12, kResource = Ports::kDataLink;
  static constexpr word kSlaves = 7, kErrorCode = 6301;
  static constexpr bool kShared = true, kShowsLayout = true;
  static constexpr std::uint8_t kWrongCounter = link_error::kThird, kWrongCommand = link_error::kForm;
  static constexpr std::uint8_t kWrongCommandOfMaster = link_error::kMasterForm;
  static constexpr std::uint8_t kSeenWrongCounter = link_error::kSeenThird, kSeenWrongCommand = link_error::kSeenCommand;
  static constexpr std::uint8_t kSeenForm = link_error::kForm;
};
struct DataLink2Rules : DataLinkRules {
  static constexpr unsigned kMostWords = 40;
  static constexpr bool kShowsLayout = false;
};
struct RemoteInOutRules {
  static constexpr LinkDevices kDevices = {8376, 8373, 8331, 8333, 8338, 8336, 8335, {8342, 8341}};
  static constexpr unsigned kMostSlaves = 4, kMostWords = 2, kResource = Ports::kRemoteInOut;
  static constexpr word kSlaves = 4, kErrorCode = 6302;
  static constexpr bool kShared = false, kShowsLayout = false;
  static constexpr std::uint8_t kWrongCounter = link_error::kForm, kWrongCommand = link_error::kThird;
  static constexpr std::uint8_t kWrongCommandOfMaster = link_error::kMasterCommand;
  static constexpr std::uint8_t kSeenWrongCounter = link_error::kSeenForm, kSeenWrongCommand = link_error::kSeenThird;
  static constexpr std::uint8_t kSeenForm = link_error::kSeenForm;
};

// ---------------------------------------------------------------------------------------------- F190
/// Station s: D10s on, M(2000 + 64s) on; refresh mode 0 has 4 words, mode 1 also 32 bits, mode 2 8 words and 64 bits.
class DataLink : LinkStation<DataLinkRules> {
public:
  template <class M, class D, class S> Fault run(bit condition, M &m, D &d, word port, S &sys) noexcept {
    return exchange(condition, port, Area<M, D>{{}, m, d}, sys);
  }

private:
  template <class M, class D> struct Area : detail::SharedArea {
    M &m;
    D &d;

    std::uint8_t layout(std::uint8_t mode) const noexcept { return mode; }
    bool accepts(unsigned layout) const noexcept { return layout <= 2; }
    static constexpr unsigned bit_words(unsigned layout) noexcept { return 2 * layout; }
    unsigned data_words(unsigned layout) const noexcept { return bit_words(layout) + (layout == 2 ? 8U : 4U); }
    word data_word(unsigned layout, unsigned station, unsigned i) const noexcept {
      if (i < bit_words(layout))
        return detail::read_image(m, first_bit(station, i));
      const unsigned number = 10 * station + i - bit_words(layout);
      return D::has(number) ? static_cast<word>(d[number]) : word{0};
    }
    void take_data(unsigned layout, unsigned station, unsigned i, word value) const noexcept {
      const unsigned number = 10 * station + i - bit_words(layout);
      if (i < bit_words(layout))
        detail::write_image(m, first_bit(station, i), value);
      else if (D::has(number))
        d[number] = value;
    }
    static constexpr unsigned first_bit(unsigned station, unsigned i) noexcept { return 2000 + 64 * station + 16 * i; }
  };
};

// ---------------------------------------------------------------------------------------------- F193
/// Station s: S2 words from S1 + s S2 on. A station passes over areas of others that it has no registers for.
class DataLink2 : LinkStation<DataLink2Rules> {
public:
  template <class Block, class S> Fault run(bit condition, Block shared, word words, word port, S &sys) noexcept {
    constexpr word kMostWords = static_cast<word>(DataLink2Rules::kMostWords);
    const unsigned count = words >= 1 && words <= kMostWords ? static_cast<unsigned>(words) : 0U;
    settle(sys);
    if (condition && (count == 0 || (last_station() + 1) * count > shared.points()))
      return Fault::Range;
    return exchange(condition, port, Area<Block>{{}, shared, count}, sys);
  }

private:
  static constexpr std::uint8_t kFree = 0x80;

  template <class Block> struct Area : detail::SharedArea {
    Block shared;
    unsigned words;

    std::uint8_t layout(std::uint8_t) const noexcept { return static_cast<std::uint8_t>(kFree + words); }
    bool accepts(unsigned layout) const noexcept { return layout == kFree + words; }
    unsigned data_words(unsigned) const noexcept { return words; }
    word data_word(unsigned, unsigned station, unsigned i) const noexcept {
      const unsigned place = station * words + i;
      return place < shared.points() ? shared.get(place) : word{0};
    }
    void take_data(unsigned, unsigned station, unsigned i, word value) const noexcept {
      if (const unsigned place = station * words + i; place < shared.points())
        shared.set(place, value);
    }
  };
};

// ---------------------------------------------------------------------------------------------- F191
class RemoteInOut : LinkStation<RemoteInOutRules> {
public:
  template <class X, class Y, class S> Fault run(bit condition, X &x, Y &y, word port, S &sys) noexcept {
    return exchange(condition, port, Area<X, Y>{x, y}, sys);
  }

private:
  template <class X, class Y> struct Area {
    X &x;
    Y &y;

    static constexpr std::uint8_t kLayout = 0x40;
    static constexpr unsigned kWords = 2, kFirst = 0200, kPoints = 32;

    std::uint8_t layout(std::uint8_t) const noexcept { return kLayout; }
    bool accepts(unsigned layout) const noexcept { return layout == kLayout; }
    /// In the master.
    static constexpr unsigned remote(unsigned slave, unsigned i) noexcept { return kFirst + kPoints * (slave - 1) + 16 * i; }
    unsigned request_words() const noexcept { return kWords; }
    word request_word(unsigned slave, unsigned i) const noexcept { return detail::read_image(y, remote(slave, i)); }
    void take_data(unsigned, unsigned slave, unsigned i, word value) const noexcept {
      detail::write_image(x, remote(slave, i), value);
    }
    /// In a slave.
    void take_request(unsigned i, word value) const noexcept { detail::write_image(y, 16 * i, value); }
    unsigned data_words(unsigned) const noexcept { return kWords; }
    word data_word(unsigned, unsigned, unsigned i) const noexcept { return detail::read_image(x, 16 * i); }
    void master_lost() const noexcept {
      for (unsigned i = 0; i < kWords; ++i)
        take_request(i, 0);
    }
  };
};

}  // namespace ladder::tp03
