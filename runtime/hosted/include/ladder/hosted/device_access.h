// Reading and writing the devices of one program object by reference.
//
// The object holds the numbers that the program can reach (DeviceSymbol::count). The controller has more (points): what lies
// between is kept in a side store here, so that a host can set and read every device of the controller. Access goes word by word
// and bit by bit; a pair may thus lie half in the image and half in the side store. Only 32-bit counters are accessed whole.
#pragma once

#include "ladder/hosted/device_name.h"
#include "ladder/hosted/device_value.h"
#include "ladder/symbols.h"

#include <cstdint>
#include <unordered_map>

namespace ladder::hosted {

class DeviceAccess {
public:
  /// `object` is a constructed program of `symbols`; both outlive this.
  DeviceAccess(const ProgramSymbols &symbols, void *object) : symbols_(&symbols), object_(static_cast<unsigned char *>(object)) {}

  Value read(const DeviceRef &ref) const;
  void write(const DeviceRef &ref, const Value &value);

  /// Where the class's image starts: the lowest number, then `count` numbers in all, laid out as the shape says.
  unsigned char *image(const DeviceSymbol &symbol) const { return object_ + symbol.offset; }

  void clear_side_store() { side_store_.clear(); }

private:
  const DeviceSymbol &symbol(const DeviceRef &ref) const { return symbols_->devices[ref.device]; }
  /// Where the part of the number starts that `ref` means (the cell of a packed bit), or null where the image has no such number.
  unsigned char *place(const DeviceRef &ref, std::uint32_t number) const;
  std::uint32_t read_side(const DeviceRef &ref, std::uint32_t number) const;
  bool read_bit(const DeviceRef &ref, std::uint32_t number) const;
  void write_bit(const DeviceRef &ref, std::uint32_t number, bool bit);
  std::uint16_t read_word(const DeviceRef &ref, std::uint32_t number) const;
  void write_word(const DeviceRef &ref, std::uint32_t number, std::uint16_t value);
  /// The second word of a pair: the next number, or the same number of the class with the high words.
  struct High {
    DeviceRef ref;
    std::uint32_t number;
  };
  High high_word(const DeviceRef &ref) const;
  std::uint32_t read_double(const DeviceRef &ref) const;
  void write_double(const DeviceRef &ref, std::uint32_t value);

  const ProgramSymbols *symbols_;
  unsigned char *object_;
  std::unordered_map<std::uint64_t, std::uint32_t> side_store_;  ///< by class, part and number; absent is 0
};

}  // namespace ladder::hosted
