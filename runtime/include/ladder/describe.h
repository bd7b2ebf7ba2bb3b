// How a device image lies in memory, found from its type: what NAME.symbols.cpp puts into its table.
#pragma once

#include "ladder/counter.h"
#include "ladder/image.h"
#include "ladder/symbols.h"
#include "ladder/timer.h"

#include <cstdint>
#include <type_traits>

namespace ladder {
namespace detail {

template <class Image> struct ShapeOf;
template <unsigned N> struct ShapeOf<Bits<N, false>> { static constexpr Shape kShape = Shape::Bits; };
template <unsigned N> struct ShapeOf<Bits<N, true>> { static constexpr Shape kShape = Shape::PackedBits; };
template <unsigned N> struct ShapeOf<Words<N>> { static constexpr Shape kShape = Shape::Words; };
template <unsigned N> struct ShapeOf<Timers<N>> { static constexpr Shape kShape = Shape::Timers; };
template <unsigned N> struct ShapeOf<Counters<N>> { static constexpr Shape kShape = Shape::Counters; };

template <class T> using Plain = std::remove_cv_t<std::remove_reference_t<T>>;

}  // namespace detail

/// `shape_of<decltype(Program::X)>()`.
template <class Image> constexpr Shape shape_of() noexcept {
  return detail::ShapeOf<detail::Plain<Image>>::kShape;
}

/// Points in the image.
template <class Image> constexpr std::uint32_t count_of() noexcept {
  return detail::Plain<Image>::kPoints;
}

}  // namespace ladder
