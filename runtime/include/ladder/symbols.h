// What a host must know of a compiled program: its devices by name and where they lie, its entry points, and which list line a step is.
//
// The table is written into NAME.symbols.cpp beside the program. Firmware that needs no names does not link it.
#pragma once

#include "ladder/scan_types.h"

#include <cstdint>

namespace ladder {

/// How a device class lies in memory.
enum class Shape : std::uint8_t {
  Bits,        ///< one byte a bit
  PackedBits,  ///< 32 bits to a std::uint32_t, number 0 in bit 0
  Words,       ///< std::int16_t
  Timers,      ///< ladder::Timer: contact, coil, value
  Counters,    ///< ladder::Counter: contact, coil, value
};

struct DeviceSymbol {
  const char *prefix;    ///< "X"
  Shape shape;
  std::uint8_t radix;    ///< of the numbers: 8, 10, 16
  bool input, output;    ///< refreshed from or to terminals
  std::uint32_t count;   ///< numbers 0 to count - 1 exist in the image
  std::uint32_t points;  ///< numbers 0 to points - 1 exist in the controller; beyond count the program never looks
  std::uint32_t offset;  ///< bytes from the start of the program object
};

/// One instruction that can stop the CPU, and END.
struct StepSymbol {
  std::uint32_t step;
  std::uint32_t line;    ///< of the list file, 1-based
  const char *text;      ///< the instruction as written
};

struct ErrorSymbol {
  std::uint16_t code;
  const char *name;
};

struct ProgramSymbols {
  const char *name;      ///< class name
  const char *family, *model;
  const char *list_file;
  std::uint32_t size, alignment;      ///< of the program object, bytes
  std::uint32_t instructions, rungs, steps;
  const DeviceSymbol *devices;
  std::uint32_t device_count;
  const StepSymbol *step_symbols;
  std::uint32_t step_symbol_count;
  const ErrorSymbol *errors;
  std::uint32_t error_count;
  void (*construct)(void *memory);             ///< makes the object in `memory`; all devices 0
  void (*power_on)(void *program);             ///< power-on or reset: clears what is not latched, writes initial values, goes to RUN
  void (*set_mode)(void *program, Mode mode);  ///< RUN/STOP switch
  void (*scan)(void *program, Micros now);     ///< one scan
  Status (*status)(const void *program);
  void (*set_calendar)(void *program, Calendar calendar);
  std::uint32_t watchdog_us;                   ///< from the parameters, 0: not watched
  void (*watchdog)(void *program);             ///< the host measured a scan longer than watchdog_us
};

}  // namespace ladder
