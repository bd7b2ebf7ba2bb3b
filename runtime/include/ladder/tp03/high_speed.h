// High-speed counters C235-C254 and the instructions that compare with them.
#pragma once

namespace ladder::tp03 {

class HighSpeed {};

}  // namespace ladder::tp03
