// Block transfers. Blocks are described in ladder/blocks.h; an image in which a block of variable length starts must hold all
// points of its device class, because the end of the image is the end that is checked.
#pragma once

#include "ladder/blocks.h"
#include "ladder/number.h"

namespace ladder::ops {

/// Copies n words. Overlapping blocks come out as if the source had been read as a whole first. False, and nothing written, when
/// either block ends before n words or n is negative.
template <class Source, class Destination>
[[nodiscard]] constexpr bool bmov(Source source, Destination destination, word n) noexcept {
  if (n <= 0)
    return n == 0;
  const unsigned count = static_cast<unsigned>(n);
  if (count > source.points() || count > destination.points())
    return false;
  if (source.origin() == destination.origin() && source.first() < destination.first()) {
    for (unsigned i = count; i-- > 0;)
      destination.set(i, source.get(i));
  } else {
    for (unsigned i = 0; i < count; ++i)
      destination.set(i, source.get(i));
  }
  return true;
}

/// Writes `source` n times. False, and nothing written, when the block ends before n words or n is negative.
template <class Destination> [[nodiscard]] constexpr bool fmov(word source, Destination destination, word n) noexcept {
  if (n <= 0)
    return n == 0;
  const unsigned count = static_cast<unsigned>(n);
  if (count > destination.points())
    return false;
  for (unsigned i = 0; i < count; ++i)
    destination.set(i, source);
  return true;
}

}  // namespace ladder::ops
