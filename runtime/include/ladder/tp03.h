// Everything that a program for a TECO TP03 needs. This is the one header that generated code includes.
#pragma once

#include "ladder/bit.h"
#include "ladder/edge.h"
#include "ladder/image.h"
#include "ladder/index.h"
#include "ladder/io.h"
#include "ladder/numbered.h"
#include "ladder/scan_types.h"
#include "ladder/tp03/clocks.h"
#include "ladder/tp03/counter.h"
#include "ladder/tp03/fault.h"
#include "ladder/tp03/high_speed.h"
#include "ladder/tp03/interrupts.h"
#include "ladder/tp03/parameters.h"
#include "ladder/tp03/ports.h"
#include "ladder/tp03/pulses.h"
#include "ladder/tp03/states.h"
#include "ladder/tp03/system.h"
#include "ladder/tp03/timer.h"

#if __has_include("ladder/tp03/ops/arith.h")
#include "ladder/tp03/ops/arith.h"
#endif
#if __has_include("ladder/tp03/ops/clock.h")
#include "ladder/tp03/ops/clock.h"
#endif
#if __has_include("ladder/tp03/ops/compare.h")
#include "ladder/tp03/ops/compare.h"
#endif
#if __has_include("ladder/tp03/ops/convenience.h")
#include "ladder/tp03/ops/convenience.h"
#endif
#if __has_include("ladder/tp03/ops/data.h")
#include "ladder/tp03/ops/data.h"
#endif
#if __has_include("ladder/tp03/ops/float.h")
#include "ladder/tp03/ops/float.h"
#endif
#if __has_include("ladder/tp03/ops/highspeed.h")
#include "ladder/tp03/ops/highspeed.h"
#endif
#if __has_include("ladder/tp03/ops/link.h")
#include "ladder/tp03/ops/link.h"
#endif
#if __has_include("ladder/tp03/ops/move.h")
#include "ladder/tp03/ops/move.h"
#endif
#if __has_include("ladder/tp03/ops/panel.h")
#include "ladder/tp03/ops/panel.h"
#endif
#if __has_include("ladder/tp03/ops/pid.h")
#include "ladder/tp03/ops/pid.h"
#endif
#if __has_include("ladder/tp03/ops/position.h")
#include "ladder/tp03/ops/position.h"
#endif
#if __has_include("ladder/tp03/ops/serial.h")
#include "ladder/tp03/ops/serial.h"
#endif
#if __has_include("ladder/tp03/ops/shift.h")
#include "ladder/tp03/ops/shift.h"
#endif
#if __has_include("ladder/tp03/ops/text.h")
#include "ladder/tp03/ops/text.h"
#endif
