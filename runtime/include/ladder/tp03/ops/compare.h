// Comparison contacts: F224-F246.
#pragma once

#include "ladder/ops/compare.h"

namespace ladder::tp03 {

using ops::equal;
using ops::greater;
using ops::greater_equal;
using ops::less;
using ops::less_equal;
using ops::not_equal;

}  // namespace ladder::tp03
