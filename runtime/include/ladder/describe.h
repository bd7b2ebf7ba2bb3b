// How a device image lies in memory, found from its type: what NAME.symbols.cpp puts into its table.
#pragma once

#include "ladder/counter.h"
#include "ladder/image.h"
#include "ladder/numbered.h"
#include "ladder/symbols.h"
#include "ladder/timer.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ladder {

namespace tp03 {
template <unsigned N> class Timers;
template <unsigned N> class Counters;
template <unsigned N> class LongCounters;
}  // namespace tp03

namespace detail {

template <class Image> struct ShapeOf;
template <unsigned N> struct ShapeOf<Bits<N, false>> { static constexpr Shape kShape = Shape::Bits; };
template <unsigned N> struct ShapeOf<Bits<N, true>> { static constexpr Shape kShape = Shape::PackedBits; };
template <unsigned N> struct ShapeOf<Words<N>> { static constexpr Shape kShape = Shape::Words; };
template <unsigned N> struct ShapeOf<Timers<N>> { static constexpr Shape kShape = Shape::Timers; };
template <unsigned N> struct ShapeOf<Counters<N>> { static constexpr Shape kShape = Shape::Counters; };
template <unsigned N> struct ShapeOf<tp03::Timers<N>> { static constexpr Shape kShape = Shape::Timers; };
template <unsigned N> struct ShapeOf<tp03::Counters<N>> { static constexpr Shape kShape = Shape::Counters; };
template <unsigned N> struct ShapeOf<tp03::LongCounters<N>> { static constexpr Shape kShape = Shape::LongCounters; };
template <class Image, unsigned First> struct ShapeOf<Numbered<Image, First>> : ShapeOf<Image> {};

template <class Image> struct FirstOf { static constexpr std::uint32_t kFirst = 0; };
template <class Image, unsigned First> struct FirstOf<Numbered<Image, First>> { static constexpr std::uint32_t kFirst = First; };

template <class T> using Plain = std::remove_cv_t<std::remove_reference_t<T>>;

template <class T> T &some() noexcept;  // for decltype
/// What one number of the image is.
template <class Image> using Element = Plain<decltype(some<Plain<Image>>()[0])>;

/// Hosts find the members by the shape.
template <class Owner> constexpr bool lies_as(Shape shape) noexcept {
  const std::size_t value_size = shape == Shape::LongCounters ? 4 : 2;
  return sizeof(Owner::value) == value_size && offsetof(Owner, value) == 0 && offsetof(Owner, contact) == value_size &&
         offsetof(Owner, coil) == value_size + 1;
}

}  // namespace detail

/// `shape_of<decltype(Program::X)>()`.
template <class Image> constexpr Shape shape_of() noexcept {
  constexpr Shape kShape = detail::ShapeOf<detail::Plain<Image>>::kShape;
  if constexpr (kShape == Shape::Timers || kShape == Shape::Counters || kShape == Shape::LongCounters)
    static_assert(detail::lies_as<detail::Element<Image>>(kShape), "value, contact and coil are not where the shape says");
  return kShape;
}

/// Points in the image.
template <class Image> constexpr std::uint32_t count_of() noexcept {
  return detail::Plain<Image>::kPoints;
}

/// The lowest number.
template <class Image> constexpr std::uint32_t first_of() noexcept {
  return detail::FirstOf<detail::Plain<Image>>::kFirst;
}

/// Bytes from number to number; 0 for packed bits.
template <class Image> constexpr std::uint32_t stride_of() noexcept {
  if constexpr (shape_of<Image>() == Shape::PackedBits)
    return 0;
  else
    return sizeof(detail::Element<Image>);
}

}  // namespace ladder
