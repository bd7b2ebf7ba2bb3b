// Pulse outputs Y0 and Y1.
#pragma once

namespace ladder::tp03 {

class Pulses {};

}  // namespace ladder::tp03
