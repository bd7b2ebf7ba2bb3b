// The numbers of a controller: two's complement words of 16, 32 and 64 bits that wrap silently.
//
// Signed overflow is undefined in C++, so all arithmetic goes through the unsigned types, and the pattern comes back through the
// conversions below (modular in C++20; GCC and Clang document the same for C++17).
#pragma once

#include <cstdint>

namespace ladder {

using word = std::int16_t;
using dword = std::int32_t;
using qword = std::int64_t;

constexpr word to_word(std::uint32_t pattern) noexcept {
  return static_cast<word>(static_cast<std::uint16_t>(pattern));
}
constexpr dword to_dword(std::uint32_t pattern) noexcept {
  return static_cast<dword>(pattern);
}
constexpr qword to_qword(std::uint64_t pattern) noexcept {
  return static_cast<qword>(pattern);
}

/// The pattern of a word without sign extension.
constexpr std::uint32_t pattern_of(word value) noexcept {
  return static_cast<std::uint16_t>(value);
}
constexpr std::uint32_t pattern_of(dword value) noexcept {
  return static_cast<std::uint32_t>(value);
}

}  // namespace ladder
