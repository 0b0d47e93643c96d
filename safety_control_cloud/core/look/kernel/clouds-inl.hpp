// SPDX-License-Identifier: BSD-3-Clause
// How the points of a cloud come into vectors; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_CLOUDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_CLOUDS_INL
#undef SAFETY_CONTROL_CLOUD_CLOUDS_INL
#else
#define SAFETY_CONTROL_CLOUD_CLOUDS_INL
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../../input/fetch.hpp"
#include "visits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

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
struct PackedInOrder {
  const std::uint8_t* first;

  HWY_INLINE Stretch bytes_of(std::size_t column, std::size_t size) const { return {first + column * 12, size * 12}; }
  HWY_INLINE Points at(std::size_t column) const {
    Float x, y, z;  // no Points: its constructor would not be compiled for the instruction set
    hn::LoadInterleaved3(Floats(), reinterpret_cast<const float*>(first + column * 3 * sizeof(float)), x, y, z);
    return {x, y, z};
  }
  HWY_INLINE Points at_in_any_order(std::size_t column) const { return at(column); }
};

#if HWY_TARGET <= HWY_AVX3

/// The same with fewer shuffles where the order does not matter. The lanes of three successive vectors are x, y, z, x,
/// ... and 3 n + 1 in each: what is x in one of the vectors is not in the others, so that the x of all three are
/// blended, each in its lane. The y lie one lane behind their x, the z two.
class Packed : public PackedInOrder {
  static_assert(lanes % 3 == 1);

  struct Tables {
    alignas(sizeof(Float)) std::int32_t axis[lanes], one_on[lanes], two_on[lanes];
  };
  static constexpr Tables tables() {
    Tables all{};
    for (std::size_t i = 0; i < lanes; ++i) {
      all.axis[i] = static_cast<std::int32_t>(i % 3);
      all.one_on[i] = static_cast<std::int32_t>((i + 1) % lanes);
      all.two_on[i] = static_cast<std::int32_t>((i + 2) % lanes);
    }
    return all;
  }
  using Order = decltype(hn::SetTableIndices(Floats(), Tables{}.one_on));

  /// Each blend might load it anew, across two lines of the cache.
  static HWY_INLINE Float loaded_once(const float* from) {
    Float vector = hn::LoadU(Floats(), from);
    __asm__("" : "+v"(vector.raw));
    return vector;
  }

  Mask x_of_first, x_of_second;
  Order one_on, two_on;

 public:
  explicit HWY_INLINE Packed(const std::uint8_t* points) : PackedInOrder{points} {
    static constexpr Tables of = tables();
    const auto axis = hn::Load(Signed(), of.axis);
    x_of_first = hn::RebindMask(Floats(), hn::Eq(axis, hn::Zero(Signed())));
    x_of_second = hn::RebindMask(Floats(), hn::Eq(axis, hn::Set(Signed(), 2)));
    one_on = hn::SetTableIndices(Floats(), of.one_on);
    two_on = hn::SetTableIndices(Floats(), of.two_on);
  }

  HWY_INLINE Points at_in_any_order(std::size_t column) const {
    const auto* from = reinterpret_cast<const float*>(first + column * 3 * sizeof(float));
    const Float a = loaded_once(from), b = loaded_once(from + lanes), c = loaded_once(from + 2 * lanes);
    const auto blended = [&](Float in_first, Float in_second, Float in_third) HWY_ATTR {
      return hn::IfThenElse(x_of_first, in_first, hn::IfThenElse(x_of_second, in_second, in_third));
    };
    return {blended(a, b, c), hn::TableLookupLanes(blended(b, c, a), one_on),
            hn::TableLookupLanes(blended(c, a, b), two_on)};
  }
};

#else

using Packed = PackedInOrder;

#endif

/// x, y, z in this order, and a step that the compiler knows.
template <std::size_t point_step>
struct Stepped {
  const std::uint8_t* first;

  HWY_INLINE Stretch bytes_of(std::size_t column, std::size_t size) const {
    return {first + column * point_step, size * point_step};
  }
  HWY_INLINE Float blocks(const std::uint8_t* from) const { return every_fourth_block(Floats(), from, point_step); }
  HWY_INLINE Points at(std::size_t column) const {
    const std::uint8_t* from = first + column * point_step;
    return transposed(blocks(from), blocks(from + point_step), blocks(from + 2 * point_step),
                      blocks(from + 3 * point_step));
  }
  /// Where points fill their blocks, vectors are loaded whole.
  HWY_INLINE Points at_in_any_order(std::size_t column) const {
    if constexpr (point_step != block_size) return at(column);
    const auto* from = reinterpret_cast<const float*>(first + column * point_step);
    const auto whole = [&](std::size_t i) HWY_ATTR { return hn::LoadU(Floats(), from + i * lanes); };
    return transposed(whole(0), whole(1), whole(2), whole(3));
  }
};

/// x, y and z in any order and with any gaps, but within one block.
struct Near {
  const std::uint8_t* first;
  std::size_t point_step;
  hn::Vec<Bytes> order;

  HWY_INLINE Stretch bytes_of(std::size_t column, std::size_t size) const {
    return {first + column * point_step, size * point_step};
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
  HWY_INLINE Points at_in_any_order(std::size_t column) const { return at(column); }
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
  fetch_pages(points.bytes, points.width * points.point_step);
#if HWY_TARGET != HWY_SCALAR
  const auto [x, y, z] = points.offset;
  const std::size_t lowest = std::min({x, y, z}), end = std::max({x, y, z}) + sizeof(float);
  const bool plain = points.y_and_z_follow_x();
  const bool near = points.point_step >= 3 * sizeof(float) && end - lowest <= block_size;
  if (near && points.is_of_floats()) {
    // The last point of the cloud must be copied: its block may end beyond the data.
    visited = (points.width - (followed ? 0 : 1)) / lanes * lanes;
    const std::uint8_t* first = points.bytes + lowest;
    if (plain && points.point_step == 12) {
      visit_fetched(Packed{first}, visited, visitor);
    } else if (plain && points.point_step == 16) {
      visit_fetched(Stepped<16>{first}, visited, visitor);
    } else if (plain && points.point_step == 20) {
      visit_fetched(Stepped<20>{first}, visited, visitor);
    } else if (plain && points.point_step == 32) {
      visit_fetched(Stepped<32>{first}, visited, visitor);
    } else {
      visit_fetched(Near{first, points.point_step, order_in(points, lowest)}, visited, visitor);
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
