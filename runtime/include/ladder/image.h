// The device images: bit classes, word classes, and the proxies that operands of other widths need.
#pragma once

#include "ladder/bit.h"
#include "ladder/bits.h"
#include "ladder/blocks.h"
#include "ladder/digits.h"
#include "ladder/number.h"
#include "ladder/words.h"
