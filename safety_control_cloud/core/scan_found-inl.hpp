// SPDX-License-Identifier: BSD-3-Clause
// Which points are what, a vector at a time; part of scan_simd.cpp, compiled once for every instruction set.
// The same tests as is_return(), is_inside(), is_too_close() and remembered() of corridor.hpp.
#if defined(SAFETY_CONTROL_CLOUD_SCAN_FOUND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_SCAN_FOUND_INL
#undef SAFETY_CONTROL_CLOUD_SCAN_FOUND_INL
#else
#define SAFETY_CONTROL_CLOUD_SCAN_FOUND_INL
#endif

#include "corridor.hpp"
#include "scan_depths-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

using Integers = hn::RebindToUnsigned<Floats>;
using Integer = hn::Vec<Integers>;
using Mask = hn::Mask<Floats>;

constexpr float infinity = std::numeric_limits<float>::infinity();

HWY_INLINE Float all(float value) { return hn::Set(Floats(), value); }
HWY_INLINE Integer all_of(std::uint32_t value) { return hn::Set(Integers(), value); }

/// A corridor in every lane.
struct Walls {
  Float x_min, x_max, y_min, y_max, range_min;

  explicit HWY_INLINE Walls(const Corridor& corridor)
      : x_min(all(corridor.x_min)),
        x_max(all(corridor.x_max)),
        y_min(all(corridor.y_min)),
        y_max(all(corridor.y_max)),
        range_min(all(corridor.range_min)) {}

  HWY_INLINE Mask span(const Points& points) const { return hn::And(hn::Ge(points.x, x_min), hn::Le(points.x, x_max)); }
  HWY_INLINE Mask hold(const Points& points) const {
    return hn::And(span(points), hn::And(hn::Ge(points.y, y_min), hn::Le(points.y, y_max)));
  }
};

HWY_INLINE Mask is_return(const Points& points, const Walls& walls) {
  // Zero times a finite number changes nothing, zero times any other is NaN.
  const Float z_if_finite = hn::MulAdd(points.x, all(0.0f), hn::MulAdd(points.y, all(0.0f), points.z));
  return hn::And(hn::Gt(z_if_finite, walls.range_min), hn::Lt(z_if_finite, all(infinity)));
}

HWY_INLINE Mask is_inside(const Points& placed, const Walls& walls) {
  return hn::And(walls.hold(placed), hn::Gt(placed.z, all(0.0f)));
}

/// The cloud's frame is the corridor's.
struct Unplaced {
  explicit HWY_INLINE Unplaced(const Gaze&) {}
  HWY_INLINE Points operator()(const Points& points) const { return points; }
  HWY_INLINE Mask inside(const Points& placed, const Walls& walls, Mask returning) const {
    return hn::And(returning, is_inside(placed, walls));
  }
};

/// Takes points to the corridor's axes, by the very operations of Placement.
struct Placed {
  Float xx, xy, xz, x0, yx, yy, yz, y0, zx, zy, zz, z0;

  explicit HWY_INLINE Placed(const Gaze& gaze) : Placed(gaze.placement->rows) {}
  HWY_INLINE Points operator()(const Points& points) const {
    const auto along = [&](Float a, Float b, Float c, Float d) HWY_ATTR {
      const Float across = hn::Add(hn::Mul(a, points.x), hn::Mul(b, points.y));
      return hn::Add(hn::Add(across, hn::Mul(c, points.z)), d);
    };
    return {along(xx, xy, xz, x0), along(yx, yy, yz, y0), along(zx, zy, zz, z0)};
  }
  /// A far point may have overflowed on its way.
  HWY_INLINE Mask inside(const Points& placed, const Walls& walls, Mask returning) const {
    return hn::And(hn::And(returning, hn::Lt(placed.z, all(infinity))), is_inside(placed, walls));
  }

 private:
  using Rows = std::array<std::array<float, 4>, 3>;
  explicit HWY_INLINE Placed(const Rows& r)
      : xx(all(r[0][0])),
        xy(all(r[0][1])),
        xz(all(r[0][2])),
        x0(all(r[0][3])),
        yx(all(r[1][0])),
        yy(all(r[1][1])),
        yz(all(r[1][2])),
        y0(all(r[1][3])),
        zx(all(r[2][0])),
        zy(all(r[2][1])),
        zz(all(r[2][2])),
        z0(all(r[2][3])) {}
};

HWY_INLINE Mask is_too_close(const Points& points, const Walls& walls, bool anywhere) {
  const Mask at_minus_infinity = hn::Eq(points.z, all(-infinity));
  if (anywhere) return at_minus_infinity;
  const Mask x_within = walls.span(points);
  const Mask y_within = hn::And(hn::Ge(points.y, walls.y_min), hn::Le(points.y, walls.y_max));
  const Mask x_maybe = hn::Or(x_within, hn::Not(hn::IsFinite(points.x)));
  const Mask y_maybe = hn::Or(y_within, hn::Not(hn::IsFinite(points.y)));
  return hn::And(at_minus_infinity, hn::And(x_maybe, y_maybe));
}

/// What pixels remember of these points, with the flag `now`; 0 of those that are no returns. Only the low 16 bits of
/// every lane mean something.
HWY_INLINE Integer remembered(const Points& placed, const Walls& walls, Float near_distance, Mask returning) {
  const Mask near = hn::And(hn::Gt(placed.z, all(0.0f)), hn::Lt(placed.z, near_distance));
  const Mask in_sight = hn::And(walls.span(placed), hn::Ge(placed.y, walls.y_min));
  const Mask below = hn::Gt(placed.y, walls.y_max);
  const Float depth_below = hn::Min(hn::Max(placed.y, all(0.0f)), all(static_cast<float>(PixelMemory::farthest)));
  const Float metres = hn::IfThenElse(below, depth_below, placed.z);
  const Float per_metre = hn::IfThenElse(below, all(PixelMemory::ground_per_metre), all(PixelMemory::near_per_metre));
  // From 2^23 on the bits of a float count in ones: adding rounds, as std::nearbyint does, and needs no conversion.
  constexpr float two_to_23 = 8388608.0f;
  const Float zero = hn::IfThenElse(below, all(two_to_23 + (PixelMemory::now | PixelMemory::ground_zero)),
                                    all(two_to_23 + PixelMemory::now));
  const Integer code = hn::BitCast(Integers(), hn::Add(hn::Mul(metres, per_metre), zero));
  const Integer seen = hn::IfThenElse(hn::RebindMask(Integers(), hn::And(near, in_sight)), code,
                                      all_of(PixelMemory::now | PixelMemory::elsewhere));
  return hn::IfThenElseZero(hn::RebindMask(Integers(), returning), seen);
}

/// How many lanes were set in all masks.
class Tally {
 public:
  HWY_INLINE Tally() : count_(hn::Zero(Integers())) {}

  HWY_INLINE void add(Mask mask) {
#if HWY_TARGET <= HWY_AVX3  // masks have registers of their own
    count_ = hn::IfThenElse(hn::RebindMask(Integers(), mask), hn::Add(count_, all_of(1)), count_);
#else  // a set lane is all ones, which is -1
    count_ = hn::Sub(count_, hn::BitCast(Integers(), hn::VecFromMask(Floats(), mask)));
#endif
  }
  HWY_INLINE std::size_t total() const { return hn::GetLane(hn::SumOfLanes(Integers(), count_)); }

 private:
  Integer count_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
