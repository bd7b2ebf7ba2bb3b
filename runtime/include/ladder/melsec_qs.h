// Everything that a program for a MELSEC QS safety CPU needs. This is the one header that generated code includes.
#pragma once

#include "ladder/bit.h"
#include "ladder/counter.h"
#include "ladder/edge.h"
#include "ladder/image.h"
#include "ladder/melsec_qs/parameters.h"
#include "ladder/melsec_qs/system.h"
#include "ladder/ops/arith.h"
#include "ladder/ops/compare.h"
#include "ladder/ops/convert.h"
#include "ladder/ops/logic.h"
#include "ladder/ops/move.h"
#include "ladder/scan_types.h"
#include "ladder/timer.h"
