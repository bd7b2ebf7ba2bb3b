// One compiled program and its devices, read straight from its memory by the layout that its symbol table tells.
#pragma once

#include "ladder/symbols.h"
#include "memory.h"

#include <memory>
#include <vector>

namespace ladderc::differential {

class CompiledSide {
public:
  CompiledSide(const ladder::ProgramSymbols &symbols, const FamilyInfo &family, const Parameters &parameters);

  void power_on();
  void set_run(bool run);
  /// An input terminal changed between two scans; false where the program does not look at it then.
  bool input(std::size_t number, bool on);
  void scan(std::uint32_t now_us) { symbols_.scan(object(), now_us); }
  ladder::Status status() const { return symbols_.status(object()); }

  void poke_bit(DeviceId id, std::size_t number, bool on);
  void poke_word(DeviceId id, std::size_t number, std::uint16_t value);
  /// So many points of the class lie in the program's memory.
  std::size_t count(DeviceId id) const;
  /// All points of the class, in the interpreter's form. Points that the program has no memory for are as the host wrote them.
  const DeviceArray &read(DeviceId id);

private:
  struct Release {
    std::size_t alignment;
    void operator()(void *memory) const { ::operator delete (memory, std::align_val_t{alignment}); }
  };
  unsigned char *object() const { return static_cast<unsigned char *>(memory_.get()); }

  void write_initial_values();

  const ladder::ProgramSymbols &symbols_;
  const FamilyInfo &family_;
  const Parameters &parameters_;
  std::unique_ptr<void, Release> memory_;
  std::vector<const ladder::DeviceSymbol *> symbol_;  ///< by device id; null: no memory
  std::vector<DeviceArray> arrays_;
};

}  // namespace ladderc::differential
