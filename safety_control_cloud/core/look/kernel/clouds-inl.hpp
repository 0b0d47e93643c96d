// SPDX-License-Identifier: BSD-3-Clause
// How the points of a cloud come into vectors; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_CLOUDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_CLOUDS_INL
#undef SAFETY_CONTROL_CLOUD_CLOUDS_INL
#else
#define SAFETY_CONTROL_CLOUD_CLOUDS_INL
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "visits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

/// Asks for the bytes that come up when another `distance` have been taken. The processor sees by itself that a cloud
/// is read from end to end, but asks too late, and not across the end of a page. Behind the cloud it does no harm.
HWY_INLINE void fetch_ahead(const std::uint8_t* from, std::size_t size) {
  constexpr std::size_t distance = 4096, cache_line = 64;
  for (std::size_t i = 0; i < size; i += cache_line) hwy::Prefetch(from + distance + i);
}

#if HWY_TARGET != HWY_SCALAR

constexpr std::size_t block_size = 16;  ///< [byte] within which every instruction set can shuffle

/// A block from every fourth point.
template <class Tag>
HWY_INLINE hn::Vec<Tag> every_fourth_block(Tag tag, const std::uint8_t* from, [[maybe_unused]] std::size_t point_step) {
  if constexpr (hn::MaxLanes(tag) == block_size / sizeof(float)) {
    return hn::BitCast(tag, hn::LoadU(hn::Repartition<std::uint8_t, Tag>(), from));
  } else {
    const hn::Half<Tag> half;
    const std::uint8_t* middle = from + hn::MaxLanes(half) * point_step;
    return hn::Combine(tag, every_fourth_block(half, middle, point_step), every_fourth_block(half, from, point_step));
  }
}

/// The first three floats of the blocks of successive points: rows to columns, four points at a time.
HWY_INLINE Points transposed(Float first, Float second, Float third, Float fourth) {
  const Floats tag;
  const Float xy_odd = hn::InterleaveLower(tag, first, third), z_odd = hn::InterleaveUpper(tag, first, third);
  const Float xy_even = hn::InterleaveLower(tag, second, fourth), z_even = hn::InterleaveUpper(tag, second, fourth);
  return {hn::InterleaveLower(tag, xy_odd, xy_even), hn::InterleaveUpper(tag, xy_odd, xy_even),
          hn::InterleaveLower(tag, z_odd, z_even)};
}

/// x, y, z and nothing else.
struct Packed {
  const std::uint8_t* first;

  HWY_INLINE void fetch(std::size_t column, std::size_t size) const { fetch_ahead(first + column * 12, size * 12); }
  HWY_INLINE Points at(std::size_t column) const {
    Float x, y, z;  // no Points: its constructor would not be compiled for the instruction set
    hn::LoadInterleaved3(Floats(), reinterpret_cast<const float*>(first + column * 3 * sizeof(float)), x, y, z);
    return {x, y, z};
  }
};

/// x, y, z in this order, and a step that the compiler knows.
template <std::size_t point_step>
struct Stepped {
  const std::uint8_t* first;

  HWY_INLINE void fetch(std::size_t column, std::size_t size) const {
    fetch_ahead(first + column * point_step, size * point_step);
  }
  HWY_INLINE Float blocks(const std::uint8_t* from) const { return every_fourth_block(Floats(), from, point_step); }
  HWY_INLINE Points at(std::size_t column) const {
    const std::uint8_t* from = first + column * point_step;
    return transposed(blocks(from), blocks(from + point_step), blocks(from + 2 * point_step),
                      blocks(from + 3 * point_step));
  }
};

/// x, y and z in any order and with any gaps, but within one block.
struct Near {
  const std::uint8_t* first;
  std::size_t point_step;
  hn::Vec<Bytes> order;

  HWY_INLINE void fetch(std::size_t column, std::size_t size) const {
    fetch_ahead(first + column * point_step, size * point_step);
  }
  HWY_INLINE Float blocks(const std::uint8_t* from) const {
    const auto bytes = hn::BitCast(Bytes(), every_fourth_block(Floats(), from, point_step));
    return hn::BitCast(Floats(), hn::TableLookupBytes(bytes, order));
  }
  HWY_INLINE Points at(std::size_t column) const {
    const std::uint8_t* from = first + column * point_step;
    return transposed(blocks(from), blocks(from + point_step), blocks(from + 2 * point_step),
                      blocks(from + 3 * point_step));
  }
};

/// Where the bytes of x, y and z lie in their block.
HWY_INLINE hn::Vec<Bytes> order_in(const CloudView& view, std::size_t lowest) {
  HWY_ALIGN std::uint8_t order[block_size] = {};
  for (std::size_t i = 0; i < 3 * sizeof(float); ++i) {
    order[i] = static_cast<std::uint8_t>(view.offset[i / sizeof(float)] - lowest + i % sizeof(float));
  }
  return hn::LoadDup128(Bytes(), order);
}

#endif

/// Lets the visitor take the points of one row of a cloud, the fastest way that the layout allows. `followed` as in
/// Run.
template <class Visitor>
void visit(const CloudView& points, [[maybe_unused]] bool followed, Visitor& visitor) {
  std::size_t visited = 0;
#if HWY_TARGET != HWY_SCALAR
  const auto [x, y, z] = points.offset;
  const std::size_t lowest = std::min({x, y, z}), end = std::max({x, y, z}) + sizeof(float);
  const bool plain = y == x + sizeof(float) && z == y + sizeof(float);
  const bool near = points.point_step >= 3 * sizeof(float) && end - lowest <= block_size;
  if (near && points.scalar == Scalar::Float32 && !points.swapped) {
    // The last point of the cloud must be copied: its block may end beyond the data.
    visited = (points.width - (followed ? 0 : 1)) / Visitor::at_once * Visitor::at_once;
    const std::uint8_t* first = points.bytes + lowest;
    if (plain && points.point_step == 12) {
      visit_points(Packed{first}, visited, 0, visitor);
    } else if (plain && points.point_step == 16) {
      visit_points(Stepped<16>{first}, visited, 0, visitor);
    } else if (plain && points.point_step == 20) {
      visit_points(Stepped<20>{first}, visited, 0, visitor);
    } else if (plain && points.point_step == 32) {
      visit_points(Stepped<32>{first}, visited, 0, visitor);
    } else {
      visit_points(Near{first, points.point_step, order_in(points, lowest)}, visited, 0, visitor);
    }
  }
#endif
  visit_copies(points, visited, visitor);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
