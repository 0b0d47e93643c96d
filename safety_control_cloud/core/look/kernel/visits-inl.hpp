// SPDX-License-Identifier: BSD-3-Clause
// How points are handed to a visitor, and copies of those that cannot be loaded where they lie; part of scan_simd.cpp,
// compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_VISITS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_VISITS_INL
#undef SAFETY_CONTROL_CLOUD_VISITS_INL
#else
#define SAFETY_CONTROL_CLOUD_VISITS_INL
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../../input/fetch.hpp"
#include "../../input/point_reader.hpp"
#include "../../input/runs.hpp"
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

static_assert(Runs::longest % lanes == 0);

/// Copies of points, for layouts without a faster way and for the end of a cloud.
struct Copied {
  static constexpr std::size_t longest = 64;
  static_assert(longest % (2 * lanes) == 0);  // visitors take one or two vectors at once

  HWY_ALIGN float x[longest], y[longest], z[longest];

  /// Of at most `longest` points. The last vectors are filled up with NaN, which is nothing.
  explicit Copied(const View& few) {
    std::size_t at = 0;
    for_each_point(few, [&](float px, float py, float pz) {
      x[at] = px;
      y[at] = py;
      z[at++] = pz;
    });
    for (; at % (2 * lanes) != 0; ++at) x[at] = y[at] = z[at] = std::numeric_limits<float>::quiet_NaN();
  }

  HWY_INLINE void fetch(std::size_t, std::size_t) const {}
  HWY_INLINE Points at(std::size_t column) const {
    const Floats tag;
    return {hn::Load(tag, x + column), hn::Load(tag, y + column), hn::Load(tag, z + column)};
  }
  HWY_INLINE Points at_in_any_order(std::size_t column) const { return at(column); }
};

/// Lets the visitor take `size` points, which stand `shift` columns into the run, and NaN to the end of a vector that
/// they do not fill, as in Copied. A function of its own, so that the compiler keeps what the visitor counts in
/// registers; only that is written back, for a row of a picture is soon over.
template <class Source, class Visitor>
HWY_NOINLINE void visit_points(const Source& points, std::size_t size, std::size_t shift, Visitor& visitor) {
  Visitor local = visitor;
  for (std::size_t column = 0; column < size; column += lanes) {
    points.fetch(column, lanes);
    local.take(points, column, shift + column);
  }
  visitor.go_on_from(local);
}

/// Whether a visitor takes points faster than the memory brings them.
template <class Visitor>
constexpr bool is_quick = false;

/// Bytes one after the other.
struct Stretch {
  const std::uint8_t* from;
  std::size_t size;
};

/// The same points, of which nothing is asked for.
template <class Source>
struct NotFetched : Source {
  HWY_INLINE void fetch(std::size_t, std::size_t) const {}
};

template <class Source>
struct FetchedOnce : Source {
  HWY_INLINE void fetch(std::size_t column, std::size_t size) const {
    const Stretch bytes = this->bytes_of(column, size);
    fetch_once(bytes.from, bytes.size);
  }
};

template <class Source>
struct FetchedTwice : Source {
  HWY_INLINE void fetch(std::size_t column, std::size_t size) const {
    const Stretch bytes = this->bytes_of(column, size);
    fetch_twice(bytes.from, bytes.size);
  }
};

template <class Source, class Visitor>
void visit_fetched(const Source& points, std::size_t size, Visitor& visitor) {
  if (best_told == Told::LinesOnce) return visit_points(FetchedOnce<Source>{points}, size, 0, visitor);
  if constexpr (is_quick<Visitor>) {
    if (best_told == Told::Pages) return visit_points(NotFetched<Source>{points}, size, 0, visitor);
  }
  visit_points(FetchedTwice<Source>{points}, size, 0, visitor);
}

template <class Row, class Visitor>
void visit_copies(const Row& row, std::size_t begin, Visitor& visitor) {
  for (; begin < row.width; begin += Copied::longest) {
    const std::size_t width = std::min(row.width - begin, Copied::longest);
    visit_points(Copied(piece_of(row, 0, begin, width)), width, begin, visitor);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
