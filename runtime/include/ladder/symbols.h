// What a host must know of a compiled program: where its devices lie, its entry points, and which list line a step is.
//
// The table is written into NAME.symbols.cpp beside the program. Firmware that needs no names does not link it.
#pragma once

#include "ladder/scan_types.h"

#include <cstdint>

namespace ladder {

class Io;

/// How one number of a device class lies in memory.
enum class Shape : std::uint8_t {
  Bits,          ///< one byte a bit
  PackedBits,    ///< 32 bits to a std::uint32_t, the lowest number in bit 0
  Words,         ///< std::int16_t
  Timers,        ///< std::int16_t value at byte 0, contact at 2, coil at 3
  Counters,      ///< the same
  LongCounters,  ///< std::int32_t value at byte 0, contact at 4, coil at 5
};

/// No class of the table.
inline constexpr std::uint32_t kNoClass = 0xFFFFFFFFU;

/// A device class. Several may have one prefix and different numbers: M0 to M7679 and M8000 to M8511.
///
/// What a table is written with: {prefix, shape, radix, input, output, count, points, offset, first, stride, high}; shape, count,
/// first and stride come from the image's type (describe.h), the last three may be left out.
struct DeviceSymbol {
  const char *prefix;  ///< "X"
  Shape shape;
  std::uint8_t radix;        ///< of the numbers: 8, 10, 16
  bool input, output;        ///< refreshed from or to terminals
  std::uint32_t count;       ///< so many numbers from `first` on exist in the image
  std::uint32_t points;      ///< so many numbers from `first` on exist in the controller; beyond count the program never looks
  std::uint32_t offset;      ///< bytes from the start of the program object to the lowest number
  std::uint32_t first = 0;   ///< the lowest number
  std::uint32_t stride = 0;  ///< bytes from number to number; 0: as packed as the shape can be. Packed bits have none
  /// Place in the table of the class with the high words, where a pair is not two neighbours: (V0, Z0) is Z0 with V0.
  std::uint32_t high = kNoClass;
};

/// One instruction that can stop the CPU, and END.
struct StepSymbol {
  std::uint32_t step;
  std::uint32_t line;  ///< of the list file, 1-based
  const char *text;    ///< the instruction as written
};

struct ErrorSymbol {
  std::uint16_t code;
  const char *name;
};

/// The last three members may be left out: connect, input, interrupt.
struct ProgramSymbols {
  const char *name;  ///< class name
  const char *family, *model;
  const char *list_file;
  std::uint32_t size, alignment;  ///< of the program object, bytes
  std::uint32_t instructions, rungs, steps;
  const DeviceSymbol *devices;
  std::uint32_t device_count;
  const StepSymbol *step_symbols;
  std::uint32_t step_symbol_count;
  const ErrorSymbol *errors;
  std::uint32_t error_count;
  void (*construct)(void *memory);  ///< makes the object in `memory`; all devices 0
  void (*power_on)(void *program);  ///< power-on or reset: clears what is not latched, writes initial values, goes to RUN
  void (*set_mode)(void *program, Mode mode);  ///< RUN/STOP switch
  void (*scan)(void *program, Micros now);     ///< one scan
  Status (*status)(const void *program);
  void (*set_calendar)(void *program, Calendar calendar);
  std::uint32_t watchdog_us;        ///< from the parameters, 0: not watched
  void (*watchdog)(void *program);  ///< the host measured a scan longer than watchdog_us

  // What only some controllers have, and the last two only where the program uses it; null otherwise.
  void (*connect)(void *program, Io *io) = nullptr;  ///< serial ports and the like; stays connected over power_on; null disconnects
  /// An input terminal changed between scans: high-speed counters and input interrupts act at once. `number` is that of the device.
  void (*input)(void *program, unsigned number, bool state) = nullptr;
  void (*interrupt)(void *program, unsigned pointer) = nullptr;  ///< requests the routine of a pointer, I001 by 1
};

}  // namespace ladder
