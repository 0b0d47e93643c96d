// SPDX-License-Identifier: BSD-3-Clause
// Which points are what, a vector at a time; part of scan_simd.cpp, compiled once for every instruction set.
// The same tests as in meaning.hpp.
#if defined(SAFETY_CONTROL_CLOUD_FOUND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_FOUND_INL
#undef SAFETY_CONTROL_CLOUD_FOUND_INL
#else
#define SAFETY_CONTROL_CLOUD_FOUND_INL
#endif

#include "../outlook.hpp"
#include "../places.hpp"
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

/// A corridor in every lane.
struct Walls {
  Float x_min, x_max, y_min, y_max, range_min;

  explicit HWY_INLINE Walls(const Corridor& corridor)
      : x_min(all(corridor.x_min)),
        x_max(all(corridor.x_max)),
        y_min(all(corridor.y_min)),
        y_max(all(corridor.y_max)),
        range_min(all(corridor.range_min)) {}

  HWY_INLINE Mask span(const Points& points) const { return is_within(points.x, x_min, x_max); }
  HWY_INLINE Mask span_down(const Points& points) const { return is_within(points.y, y_min, y_max); }
};

HWY_INLINE Mask is_return(const Points& points, const Walls& walls) {
  // Zero times a finite number changes nothing, zero times any other is NaN.
  const Float zero = all(0.0f);
  const Float z_if_finite =
      hn::MulAdd(points.x, zero, hn::MulAdd(points.y, zero, hn::MulAdd(points.z, zero, points.z)));
  return hn::Gt(z_if_finite, walls.range_min);
}

/// The cloud's frame is the corridor's.
struct Unplaced {
  explicit HWY_INLINE Unplaced(const Outlook&) {}
  HWY_INLINE Points operator()(const Points& points) const { return points; }
  HWY_INLINE Mask ahead(Mask some, const Points& placed) const { return those_less(some, all(0.0f), placed.z); }
};

/// Takes points to the corridor's axes, by the very operations of Placement.
struct Placed {
  Float xx, xy, xz, x0, yx, yy, yz, y0, zx, zy, zz, z0;

  explicit HWY_INLINE Placed(const Outlook& outlook) : Placed(outlook.placement->rows) {}
  HWY_INLINE Points operator()(const Points& points) const {
    const auto along = [&](Float a, Float b, Float c, Float d) HWY_ATTR {
      const Float across = hn::Add(hn::Mul(a, points.x), hn::Mul(b, points.y));
      return hn::Add(hn::Add(across, hn::Mul(c, points.z)), d);
    };
    return {along(xx, xy, xz, x0), along(yx, yy, yz, y0), along(zx, zy, zz, z0)};
  }
  /// A far point may have overflowed on its way.
  HWY_INLINE Mask ahead(Mask some, const Points& placed) const {
    return those_less(those_less(some, all(0.0f), placed.z), placed.z, all(infinity));
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
  const Mask y_within = walls.span_down(points);
  const Mask x_maybe = hn::Or(x_within, hn::Not(hn::IsFinite(points.x)));
  const Mask y_maybe = hn::Or(y_within, hn::Not(hn::IsFinite(points.y)));
  return hn::And(at_minus_infinity, hn::And(x_maybe, y_maybe));
}

/// A region in every lane.
struct Bounds {
  Float x_min, x_max, y_min, y_max, z_min, z_max;

  explicit HWY_INLINE Bounds(const Region& region)
      : x_min(all(region.x_min)),
        x_max(all(region.x_max)),
        y_min(all(region.y_min)),
        y_max(all(region.y_max)),
        z_min(all(region.z_min)),
        z_max(all(region.z_max)) {}

  HWY_INLINE Mask hold(const Points& placed) const {
    const Mask across = is_within(placed.x, x_min, x_max), down = is_within(placed.y, y_min, y_max);
    return hn::And(across, hn::And(down, is_within(placed.z, z_min, z_max)));
  }
};

/// Points, in the corridor's axes, and which of them are what.
struct Found {
  Points placed;
  Mask returning, inside;

  template <class Placing>
  HWY_INLINE Found(const Points& points, const Walls& walls, const Placing& place) : placed(place(points)) {
    returning = is_return(points, walls);
    const Mask ahead = place.ahead(returning, placed);
    inside = hn::And(ahead, hn::And(walls.span(placed), walls.span_down(placed)));
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
