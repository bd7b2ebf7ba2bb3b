// The interpreter's device memory: plain arrays, and the order in which classes lie one behind the other.
#pragma once

#include "sema/parameters.h"
#include "syntax/ast.h"

#include "llvm/ADT/STLFunctionalExtras.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace ladderc::differential {

/// One device class, its lowest number first. Bits use `on`, words `value`, timers and counters all three (`on` is the contact);
/// 32-bit counters have `wide` in place of `value`.
struct DeviceArray {
  std::vector<std::uint8_t> on, coil;
  std::vector<std::uint16_t> value;
  std::vector<std::uint32_t> wide;
};

class Memory {
public:
  Memory(const FamilyInfo &family, const Parameters &parameters);

  /// Power-on: everything but what is latched becomes 0. SM and SD are never latched.
  void clear();
  /// What the parameters write at power-on and at STOP to RUN.
  void write_initial_values();
  DeviceArray &array(DeviceId id) { return arrays_[id]; }
  const DeviceArray &array(DeviceId id) const { return arrays_[id]; }
  DeviceArray &array(std::string_view prefix);

  /// `distance` places behind the device, in the next class of the memory where the end of one is crossed.
  std::uint8_t &bit(DeviceId id, std::uint64_t number, unsigned distance = 0);
  std::uint16_t &word(DeviceId id, std::uint64_t number, unsigned distance = 0);

  /// A contact or a bit of a word.
  bool read_bit(const Operand &operand);
  void write_bit(const Operand &operand, bool on);

  /// The number in `words` words (1 or 2), signed.
  std::int64_t read(const Operand &operand, unsigned words);
  /// The low words of `pattern`, or as many digits as the operand has.
  void write(const Operand &operand, std::uint64_t pattern, unsigned words);

private:
  const FamilyInfo &family_;
  const Parameters &parameters_;
  std::vector<DeviceArray> arrays_;
  std::vector<DeviceId> next_;  ///< the class behind each one
};

/// The same for memory of another kind.
void clear_unlatched(DeviceArray &array, DeviceId id, const FamilyInfo &family, const Parameters &parameters);
/// `initial` names one bit or one word.
void write_initial_value(const InitialValue &initial, const FamilyInfo &family,
                         llvm::function_ref<DeviceArray &(DeviceId)> array_of);

}  // namespace ladderc::differential
