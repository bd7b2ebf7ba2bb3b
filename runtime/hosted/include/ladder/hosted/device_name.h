// Finding a device by the text that people write: "X1F", "D100", "TN0", "D0:d", "D0.5", "K4X0".
//
// The classes and their radix come from the program's table. A timer or counter T0 is its contact; TN0 is its current value, TC0
// its coil, TS0 its contact again. ":d", ":u" and ":f" read 32 bits: two words, low word first. CN200 has 32 bits by itself where
// the counter has, and C200:d is the same. Case does not matter.
#pragma once

#include "ladder/symbols.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ladder::hosted {

/// A text names no device, or a value does not fit it. The message is for the user, without file or option.
class DeviceError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// How the value of a device reads.
enum class Format : std::uint8_t {
  Bit,       ///< 0 or 1
  Word,      ///< 16 bits, signed
  Signed,    ///< 32 bits, signed
  Unsigned,  ///< 32 bits, unsigned
  Float,     ///< IEEE-754 single in 32 bits
};

/// Which of the memories of a device number is meant.
enum class Part : std::uint8_t { Whole, Contact, Coil, Current };

constexpr std::uint8_t kNoBit = 0xFF;

/// A place in the devices of one program. Made by find_device, hence inside the controller's range.
struct DeviceRef {
  std::uint32_t device;  ///< index in ProgramSymbols::devices
  std::uint32_t number;  ///< the first, where several numbers make the value
  Part part;             ///< Whole for bits and words
  Format format;
  std::uint8_t word_bit;  ///< bit of the word, or kNoBit
  std::uint8_t digits;    ///< groups of four bits (K4X0: 4), or 0

  friend bool operator==(const DeviceRef &, const DeviceRef &) = default;
};

/// Number of bits that the value occupies in the devices: 1, 16, 32, or four for each digit.
unsigned width_of(const DeviceRef &ref);

/// Throws DeviceError when `text` is no device of the program's controller or lies outside its range.
DeviceRef find_device(const ProgramSymbols &symbols, std::string_view text);

/// The number as it is written behind the prefix: 31 is "1F" where the radix is 16.
std::string number_text(std::uint32_t number, unsigned radix);

}  // namespace ladder::hosted
