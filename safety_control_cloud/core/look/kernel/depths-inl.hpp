// SPDX-License-Identifier: BSD-3-Clause
// How the pixels of a depth image become points in vectors; part of scan_simd.cpp, compiled once for every instruction
// set. The same operations as DepthReader's, in the same order: the same float32.
#if defined(SAFETY_CONTROL_CLOUD_DEPTHS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_DEPTHS_INL
#undef SAFETY_CONTROL_CLOUD_DEPTHS_INL
#else
#define SAFETY_CONTROL_CLOUD_DEPTHS_INL
#endif

#include "visits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR

/// Pixels that lie anywhere.
template <class Tag>
HWY_INLINE hn::Vec<Tag> pixels_at(Tag tag, const std::uint8_t* from) {
  return hn::BitCast(tag, hn::LoadU(hn::Repartition<std::uint8_t, Tag>(), from));
}

/// 32FC1. Zero times a finite number changes nothing, zero times any other is NaN: nothing measured.
struct InMetres {
  static HWY_INLINE Float at(const std::uint8_t* row, std::size_t column) {
    const Float depth = pixels_at(Floats(), row + column * sizeof(float));
    return hn::MulAdd(depth, hn::Zero(Floats()), depth);
  }
  static HWY_INLINE Float in_metres(Float depth, Float) { return depth; }
};

/// 32FC1 in which -Inf is too close: it stays what it is.
struct InMetresOrTooClose : InMetres {
  static HWY_INLINE Float at(const std::uint8_t* row, std::size_t column) {
    const Float depth = pixels_at(Floats(), row + column * sizeof(float));
    return hn::IfThenElse(hn::Eq(depth, all(-infinity)), depth, InMetres::at(row, column));
  }
};

/// 16UC1. Zero is nothing measured.
struct InMillimetres {
  static HWY_INLINE Float at(const std::uint8_t* row, std::size_t column) {
    const hn::Rebind<std::uint16_t, Floats> halves;
    const auto pixels = pixels_at(halves, row + column * sizeof(std::uint16_t));
    const Float depth = hn::ConvertTo(Floats(), hn::PromoteTo(Signed(), pixels));
    const Float nan = hn::Set(Floats(), std::numeric_limits<float>::quiet_NaN());
    return hn::IfThenElse(hn::Eq(depth, hn::Zero(Floats())), nan, depth);
  }
  static HWY_INLINE Float in_metres(Float depth, Float scale) { return hn::Mul(depth, scale); }
};

/// A row of a depth image.
template <class Unit>
struct Depths {
  const std::uint8_t* first;
  hn::Vec<Signed> columns;
  Float cx, x_scale, down, y_scale, z_scale;

  HWY_INLINE Depths(const DepthView& row, const Rays& rays)
      : first(row.bytes),
        columns(hn::Iota(Signed(), static_cast<std::int32_t>(row.first_column))),
        cx(hn::Set(Floats(), rays.cx)),
        x_scale(hn::Set(Floats(), rays.x_scale)),
        down(hn::Set(Floats(), static_cast<float>(row.first_row) - rays.cy)),
        y_scale(hn::Set(Floats(), rays.y_scale)),
        z_scale(hn::Set(Floats(), rays.z_scale)) {}

  HWY_INLINE void fetch(std::size_t, std::size_t) const {}  // of so few bytes the processor asks for enough
  HWY_INLINE Points at(std::size_t column) const {
    const Float depth = Unit::at(first, column);
    const auto u = hn::Add(columns, hn::Set(Signed(), static_cast<std::int32_t>(column)));
    const Float right = hn::Sub(hn::ConvertTo(Floats(), u), cx);
    return {hn::Mul(hn::Mul(right, depth), x_scale), hn::Mul(hn::Mul(down, depth), y_scale),
            Unit::in_metres(depth, z_scale)};
  }
  HWY_INLINE Points at_in_any_order(std::size_t column) const { return at(column); }
};

#endif

/// Lets the visitor take the points of one row of pixels.
template <class Visitor>
void visit(const DepthView& row, bool, Visitor& visitor) {
  std::size_t visited = 0;
#if HWY_TARGET != HWY_SCALAR
  if (!row.swapped) {
    visited = row.width / lanes * lanes;
    if (row.depth == Depth::Millimetres) {
      visit_points(Depths<InMillimetres>(row, Rays(row)), visited, 0, visitor);
    } else if (row.minus_inf == MinusInf::TooClose) {
      visit_points(Depths<InMetresOrTooClose>(row, Rays(row)), visited, 0, visitor);
    } else {
      visit_points(Depths<InMetres>(row, Rays(row)), visited, 0, visitor);
    }
  }
#endif
  visit_copies(row, visited, visitor);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
