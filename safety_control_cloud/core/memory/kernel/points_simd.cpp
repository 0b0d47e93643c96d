// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <limits>

#include "points.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "points_simd.cpp"
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud::points {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// z, or NaN where nothing returns, or nothing farther than `range_min` [m].
HWY_INLINE float returned_from(float x, float y, float z, float range_min) {
  const float sum = 0.0f * x + 0.0f * y + 0.0f * z;  // of what is not finite, NaN
  return (sum == 0.0f) & (z > range_min) ? z : std::numeric_limits<float>::quiet_NaN();
}

// In blocks, which vectors are made of whose length the compiler knows.
#if HWY_TARGET != HWY_SCALAR && !HWY_HAVE_SCALABLE

constexpr std::size_t block_size = 16;  // [byte] that every instruction set can shuffle

/// Of every fourth point, from this one on, a block.
template <class Tag>
HWY_INLINE hn::Vec<Tag> blocks_from(Tag tag, const std::uint8_t* from, [[maybe_unused]] std::size_t apart) {
  if constexpr (hn::MaxLanes(tag) == block_size / sizeof(float)) {
    return hn::BitCast(tag, hn::LoadU(hn::Repartition<std::uint8_t, Tag>(), from));
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(tag, blocks_from(half, from + hn::MaxLanes(half) * apart, apart),
                       blocks_from(half, from, apart));
  }
}

template <class V>
struct Coordinates {
  V x, y, z;
};

/// Of four points, or of four times as many as there are blocks in a vector.
template <class Tag, class V = hn::Vec<Tag>>
HWY_INLINE Coordinates<V> coordinates_of(Tag tag, V a, V b, V c, V d) {
  const auto xy_of_ac = hn::InterleaveLower(tag, a, c), xy_of_bd = hn::InterleaveLower(tag, b, d);
  const auto z_of_ac = hn::InterleaveUpper(tag, a, c), z_of_bd = hn::InterleaveUpper(tag, b, d);
  return {hn::InterleaveLower(tag, xy_of_ac, xy_of_bd), hn::InterleaveUpper(tag, xy_of_ac, xy_of_bd),
          hn::InterleaveLower(tag, z_of_ac, z_of_bd)};
}

/// How many it has read: in whole vectors, and not the last, whose block may end beyond the cloud.
HWY_INLINE std::size_t read_blocks(const StoredPoints& points, float* x, float* y, float* z) {
  const hn::ScalableTag<float> tag;
  constexpr std::size_t lanes = hn::MaxLanes(tag);
  std::size_t i = 0;
  for (; i + lanes < points.size; i += lanes) {
    const std::uint8_t* const from = points.first + i * points.apart;
    const auto block = [&](std::size_t n) HWY_ATTR { return blocks_from(tag, from + n * points.apart, points.apart); };
    const auto of_all = coordinates_of(tag, block(0), block(1), block(2), block(3));
    hn::StoreU(of_all.x, tag, x + i);
    hn::StoreU(of_all.y, tag, y + i);
    hn::StoreU(of_all.z, tag, z + i);
  }
  return i;
}

/// A row at a time, of which the last lane is the third pixel once more.
std::array<float, 9> around(const StoredAround& pixels, float range_min) {
  constexpr std::size_t side = 3, lanes = block_size / sizeof(float);
  const hn::FixedTag<float, lanes> tag;
  const auto zero = hn::Zero(tag), least = hn::Set(tag, range_min);
  const auto nothing = hn::Set(tag, std::numeric_limits<float>::quiet_NaN());
  float all[side * side + lanes - side];
  for (std::size_t row = 0; row < side; ++row) {
    const std::uint8_t* const from = pixels.first + row * pixels.rows_apart;
    const auto last = blocks_from(tag, from + 2 * pixels.apart, 0);
    const auto [x, y, z] =
        coordinates_of(tag, blocks_from(tag, from, 0), blocks_from(tag, from + pixels.apart, 0), last, last);
    const auto sum = hn::Add(hn::Add(hn::Mul(zero, x), hn::Mul(zero, y)), hn::Mul(zero, z));  // as in returned_from
    hn::StoreU(hn::IfThenElse(hn::And(hn::Eq(sum, zero), hn::Gt(z, least)), z, nothing), tag, all + row * side);
  }
  std::array<float, 9> z;
  std::memcpy(z.data(), all, sizeof z);
  return z;
}

#else

std::size_t read_blocks(const StoredPoints&, float*, float*, float*) { return 0; }

std::array<float, 9> around(const StoredAround& pixels, float range_min) {
  std::array<float, 9> z;
  for (std::size_t i = 0; i < z.size(); ++i) {
    float xyz[3];
    std::memcpy(xyz, pixels.first + i / 3 * pixels.rows_apart + i % 3 * pixels.apart, sizeof xyz);
    z[i] = returned_from(xyz[0], xyz[1], xyz[2], range_min);
  }
  return z;
}

#endif

void read(const StoredPoints& points, float* x, float* y, float* z) {
  for (std::size_t i = read_blocks(points, x, y, z); i < points.size; ++i) {
    float xyz[3];
    std::memcpy(xyz, points.first + i * points.apart, sizeof xyz);
    x[i] = xyz[0], y[i] = xyz[1], z[i] = xyz[2];
  }
}

void place(const PixelsOfRow& pixels, float range_min, const std::optional<Placement>& placement, float* x, float* y,
           float* z) {
  const float *const from_x = pixels.x, *const from_y = pixels.y, *const from_z = pixels.z;
  for (std::size_t i = 0; i < pixels.size; ++i) z[i] = returned_from(from_x[i], from_y[i], from_z[i], range_min);
  if (!placement) return;
  const Placement rows = *placement;
  for (std::size_t i = 0; i < pixels.size; ++i) {
    const Point placed = rows(from_x[i], from_y[i], z[i]);  // of NaN, NaN
    x[i] = placed.x, y[i] = placed.y, z[i] = placed.z;
  }
}

float least_square(const PixelsOfRow& points, const Point& from, float most) {
  const hn::ScalableTag<float> tag;
  constexpr std::size_t lanes = hn::MaxLanes(tag);
  const auto from_x = hn::Set(tag, from.x), from_y = hn::Set(tag, from.y), from_z = hn::Set(tag, from.z);
  auto least = hn::Set(tag, most);
  const auto take = [&](std::size_t i) HWY_ATTR {
    const auto x = hn::Sub(from_x, hn::LoadU(tag, points.x + i)), y = hn::Sub(from_y, hn::LoadU(tag, points.y + i));
    const auto z = hn::Sub(from_z, hn::LoadU(tag, points.z + i));
    least = hn::Min(least, hn::Add(hn::Mul(x, x), hn::Add(hn::Mul(y, y), hn::Mul(z, z))));
  };
  for (std::size_t i = 0; i + lanes <= points.size; i += lanes) take(i);
  if (points.size >= lanes) take(points.size - lanes);  // some of them once more
  float of_all = hn::GetLane(hn::MinOfLanes(tag, least));
  for (std::size_t i = 0; points.size < lanes && i < points.size; ++i) {
    const float x = from.x - points.x[i], y = from.y - points.y[i], z = from.z - points.z[i];
    const float square = x * x + (y * y + z * z);
    of_all = square < of_all ? square : of_all;
  }
  return of_all;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud::points
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace safety_control_cloud::points {

HWY_EXPORT(read);
HWY_EXPORT(around);
HWY_EXPORT(place);
HWY_EXPORT(least_square);

void read(const StoredPoints& points, float* x, float* y, float* z) { HWY_DYNAMIC_DISPATCH(read)(points, x, y, z); }

std::array<float, 9> around(const StoredAround& pixels, float range_min) {
  return HWY_DYNAMIC_DISPATCH(around)(pixels, range_min);
}

void place(const PixelsOfRow& pixels, float range_min, const std::optional<Placement>& placement, float* x, float* y,
           float* z) {
  HWY_DYNAMIC_DISPATCH(place)(pixels, range_min, placement, x, y, z);
}

float least_square(const PixelsOfRow& points, const Point& from, float most) {
  return HWY_DYNAMIC_DISPATCH(least_square)(points, from, most);
}

}  // namespace safety_control_cloud::points

#endif
