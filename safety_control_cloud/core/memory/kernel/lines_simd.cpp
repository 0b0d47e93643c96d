// SPDX-License-Identifier: BSD-3-Clause
// Plain loops without a branch, since which pixels return is as good as random; this file is compiled once for every
// instruction set, and the compiler makes vectors of them.
#include <cmath>
#include <cstring>
#include <limits>

#include "lines.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lines_simd.cpp"
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud::lines {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// So many side by side, with results of their own, since a compiler may not change the order in which floats are
/// added or compared.
constexpr std::size_t at_once = 8;

/// Of those that are numbers.
float least_of(const float* values, std::size_t size) {
  const hn::ScalableTag<float> tag;
  constexpr std::size_t lanes = hn::MaxLanes(tag);
  auto least = hn::Set(tag, std::numeric_limits<float>::infinity());
  std::size_t i = 0;
  for (; i + lanes <= size; i += lanes) {
    const auto some = hn::LoadU(tag, values + i);
    least = hn::IfThenElse(hn::Lt(some, least), some, least);
  }
  float of_all = hn::GetLane(hn::MinOfLanes(tag, least));
  for (; i < size; ++i) of_all = values[i] < of_all ? values[i] : of_all;
  return of_all;
}

float find_near(const PixelsOfRow& pixels, const Surrounding& around, float* ahead) {
  const float *const x = pixels.x, *const y = pixels.y, *const z = pixels.z;
  const float x_min = around.corridor.x_min, x_max = around.corridor.x_max;
  const float y_min = around.corridor.y_min, y_max = around.corridor.y_max;
  const float from = around.camera.z, farthest = around.distance;
  for (std::size_t i = 0; i < pixels.size; ++i) {
    const float there = z[i] - from;
    const bool is_one = (there > 0.0f) & (there < farthest) & (z[i] > 0.0f) & (x[i] >= x_min) & (x[i] <= x_max) &
                        (y[i] >= y_min) & (y[i] <= y_max);
    ahead[i] = is_one ? there : std::numeric_limits<float>::quiet_NaN();
  }
  return least_of(ahead, pixels.size);
}

int find_ground(const PixelsOfRow& pixels, const Surrounding& around, std::int16_t* ground, float* ahead) {
  const float *const x = pixels.x, *const y = pixels.y, *const z = pixels.z;
  const float left = around.corridor.x_min, right = around.corridor.x_max;
  const float top = around.corridor.y_min, bottom = around.corridor.y_max;
  const float camera_y = around.camera.y, camera_z = around.camera.z, distance = around.distance;
  int greatest = ReturnsNothing;
  for (std::size_t i = 0; i < pixels.size; ++i) {
    const float below = y[i] - camera_y, positive = below > 0.0f ? below : 0.0f;
    const auto millimetres = static_cast<int>(0.5f + 1000.0f * (positive < 30.0f ? positive : 30.0f));
    ahead[i] = z[i] - camera_z;
    const bool near = (ahead[i] < distance) & (z[i] > 0.0f);
    const bool inside = (x[i] >= left) & (x[i] <= right) & (y[i] >= top);
    const int here = y[i] <= bottom ? int{ReturnsNear} : millimetres;
    const int shown = near & inside ? here : int{ReturnsElsewhere};
    const int code = z[i] == z[i] ? shown : int{ReturnsNothing};
    ground[i] = static_cast<std::int16_t>(code);
    greatest = greatest > code ? greatest : code;
  }
  return greatest;
}

/// Of two that are not negative, so that this is as short as they are.
HWY_INLINE std::int16_t apart(std::int16_t one, std::int16_t other) {
  return static_cast<std::int16_t>(one > other ? one - other : other - one);
}

/// All bits, or none. With comparisons in their place, GCC 12 branches in note_steps_in.
HWY_INLINE int if_less(int one, int other) { return (one - other) >> 31; }
HWY_INLINE int one_of(int bits, int if_all, int if_none) { return (bits & if_all) | (~bits & if_none); }

/// Arguments that do not overlap: of so many arrays, compilers do not find that out at run time. `left` and `right` are
/// `row`'s own: read as its neighbours, they would be carried from one column to the next, and make no vectors.
HWY_NOINLINE void note_steps_in(const std::int16_t* HWY_RESTRICT left, const std::int16_t* HWY_RESTRICT row,
                                const std::int16_t* HWY_RESTRICT right, const std::int16_t* HWY_RESTRICT below,
                                const std::int16_t* HWY_RESTRICT kept, std::int16_t* HWY_RESTRICT lowest,
                                std::int16_t* HWY_RESTRICT lowest_row, std::int16_t* HWY_RESTRICT above,
                                std::int16_t* HWY_RESTRICT first_above, std::size_t columns, std::int16_t number,
                                const StepLimits& limits) {
  const int apart_at_least = limits.same_ground + 1, less_than_step = limits.step - 1;
  for (std::size_t i = 0; i < columns; ++i) {
    const std::int16_t here = row[i], low = lowest[i], low_row = lowest_row[i], first = first_above[i], keeps = kept[i];
    const int is_shown_twice = if_less(apart(here, left[i]), apart_at_least) |
                               if_less(apart(here, right[i]), apart_at_least) |
                               if_less(apart(here, below[i]), apart_at_least);
    const int is_lowest = ~if_less(low, no_ground) & if_less(here, no_ground) & is_shown_twice;
    const int lowest_now = one_of(is_lowest, here, low);
    const int floor = lowest_now & if_less(lowest_now, no_ground);
    const int is_above = if_less(here, (floor > keeps ? floor : keeps) - less_than_step);
    lowest[i] = static_cast<std::int16_t>(lowest_now);
    lowest_row[i] = static_cast<std::int16_t>(one_of(is_lowest, number, low_row));
    above[i] = static_cast<std::int16_t>(above[i] - is_above);
    first_above[i] = static_cast<std::int16_t>(one_of(is_above & ~if_less(first, no_row), number, first));
  }
}

void note_steps(const std::int16_t* row, const std::int16_t* below, const std::int16_t* kept, std::size_t columns,
                std::int16_t number, const StepLimits& limits, const StepsSoFar& steps) {
  note_steps_in(row - 1, row, row + 1, below, kept, steps.lowest, steps.lowest_row, steps.above, steps.first_above,
                columns, number, limits);
}

HWY_INLINE bool goes_on(float one, float other, float jump) { return std::fabs(one - other) <= jump; }

/// As many slots at a time as a compiler needs to see that what it writes on the way is nothing that it reads.
constexpr std::size_t part = 64;

/// What is told of floats is put into bytes, of which a vector holds more.
void go_on_along(const LineOfSlots& line, std::size_t slots, float jump, std::uint8_t* back, std::uint8_t* begins,
                 std::uint8_t* touched) {
  constexpr int from_one = 1, from_two = 2, from_any = from_one | from_two, begun = 2;  // bits of back
  int told[part];
  for (std::size_t begin = 0; begin < slots; begin += part) {
    const std::size_t size = slots - begin < part ? slots - begin : part;
    for (std::size_t i = 0; i < size; ++i) {
      const float* const here = line.ahead + begin + i;
      const bool one = goes_on(here[0], here[-1], jump), two = !one & goes_on(here[0], here[-2], jump);
      const bool is_first = (here[0] == here[0]) & !one & !two, is_parted = two & (here[-1] == here[-1]);
      const int begin_here = (is_first ? int{Begins} : 0) | (is_parted ? Begins | GoesOn : 0);
      told[i] = (one ? from_one : 0) | (two ? from_two : 0) | begin_here << begun;
    }
    for (std::size_t i = 0; i < size; ++i) back[begin + i] = static_cast<std::uint8_t>(told[i]);
  }
  for (std::size_t i = 0; i < slots; ++i) {
    const bool right = ((back[i + 1] & from_any) == from_one) | ((back[i + 2] & from_any) == from_two);
    touched[i] = static_cast<std::uint8_t>(((back[i] & from_any) != 0 ? Left : 0) | (right ? Right : 0));
  }
  for (std::size_t i = 0; i < slots; ++i) begins[i] = static_cast<std::uint8_t>(back[i] >> begun);
}

HWY_INLINE int up_from(float here, const float* there, const std::uint32_t* run, float jump, int by_run, int straight) {
  const bool over = goes_on(here, there[0], jump);
  const bool left = !over & goes_on(here, there[-1], jump), right = !over & goes_on(here, there[1], jump);
  const bool left_same = run[-1] == run[0], right_same = run[1] == run[0];
  return (over ? by_run | straight : 0) | ((left & left_same) | (right & right_same) ? by_run : 0) |
         ((left & !left_same) | (right & !right_same) ? int{OtherRun} : 0);
}

/// Where a slot goes on from one of these, its pixel touches on a side, or the one from which it goes on does.
HWY_INLINE void touch(const std::uint8_t* from, std::size_t size, int straight, int side, std::uint8_t* touched) {
  for (std::size_t i = 0; i < size; ++i)
    touched[i] = static_cast<std::uint8_t>(touched[i] | ((from[i] & straight) != 0 ? side : 0));
}

HWY_INLINE bool is_other(const std::uint32_t* run) { return run[0] != run[-1]; }

void go_on_up(const LineOfSlots& line, const LineOfSlots& above, const LineOfSlots& next, std::size_t slots, float jump,
              std::uint8_t* up, const Touched& touched) {
  int told[part];
  std::uint8_t from[part];
  for (std::size_t begin = 0; begin < slots; begin += part) {
    const std::size_t size = slots - begin < part ? slots - begin : part;
    const float* const here = line.ahead + begin;
    const float *const over = above.ahead + begin, *const over_that = next.ahead + begin;
    const std::uint32_t *const run = line.run + begin, *const run_above = above.run + begin;
    const std::uint32_t* const run_next = next.run + begin;
    for (std::size_t i = 0; i < size; ++i) {
      const int by_above = up_from(here[i], over + i, run_above + i, jump, RunAbove, StraightAbove);
      const int by_next = up_from(here[i], over_that + i, run_next + i, jump, RunNext, StraightNext);
      const bool other = is_other(run + i) | is_other(run_above + i) | is_other(run_next + i);
      told[i] = (by_above != 0 ? by_above : by_next) | (other ? int{IsOther} : 0);
    }
    for (std::size_t i = 0; i < size; ++i) from[i] = static_cast<std::uint8_t>(told[i]);
    touch(from, size, StraightAbove | StraightNext, Above, touched.line + begin);
    touch(from, size, StraightAbove, Below, touched.above + begin);
    touch(from, size, StraightNext, Below, touched.next + begin);
    std::memcpy(up + begin, from, size);
  }
}

InSlots in_slots(const SomeSlots& some, const Corridor& corridor, float border) {
  const float left = corridor.x_min + border, right = corridor.x_max - border, top = corridor.y_min + border;
  float nearest[at_once];
  double squares[at_once] = {};
  int pixels[at_once] = {}, beside[at_once] = {};
  for (float& one : nearest) one = std::numeric_limits<float>::infinity();
  const auto take = [&](std::size_t i, std::size_t j) {
    const float ahead = some.ahead[i], x = some.x[i], y = some.y[i];
    const bool is_pixel = ahead == ahead;
    const double wide = double{is_pixel ? ahead : 0.0f};
    nearest[j] = ahead < nearest[j] ? ahead : nearest[j];
    squares[j] += wide * wide;
    pixels[j] += is_pixel ? 1 : 0;
    beside[j] |= is_pixel & ((x < left) | (x > right) | (y < top)) ? 1 : 0;
  };
  std::size_t i = 0;
  for (; i + at_once <= some.size; i += at_once)
    for (std::size_t j = 0; j < at_once; ++j) take(i + j, j);
  for (; i < some.size; ++i) take(i, 0);
  InSlots all;
  for (std::size_t j = 0; j < at_once; ++j) {
    all.nearest = nearest[j] < all.nearest ? nearest[j] : all.nearest;
    all.squares += squares[j];
    all.pixels += static_cast<std::size_t>(pixels[j]);
    all.beside = all.beside || beside[j] != 0;
  }
  return all;
}

void note_lowest(const SomeSlots& some, std::uint32_t first, std::uint32_t* lowest) {
  const float* const ahead = some.ahead;
  const auto size = static_cast<std::uint32_t>(some.size);
  for (std::uint32_t i = 0; i < size; ++i) lowest[i] = ahead[i] == ahead[i] ? first + i : lowest[i];
}

/// Of eight bytes that are 0 or 1, each as one bit: the product moves the i-th to bit 56 + i.
HWY_INLINE std::uint64_t bits_of(const std::uint8_t* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return (word * 0x0102040810204080u) >> 56;
}

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the first byte is the least of its word");

void mark_inner(const std::uint8_t* touched, std::size_t size, std::uint64_t* inner) {
  for (std::size_t begin = 0; begin < size; begin += in_word) {
    std::uint8_t is_inner[in_word];
    for (std::size_t i = 0; i < in_word; ++i) is_inner[i] = touched[begin + i] == AllSides ? 1 : 0;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < in_word; i += 8) word |= bits_of(is_inner + i) << i;
    const std::size_t left = size - begin;
    inner[begin / in_word] = left < in_word ? word & ((std::uint64_t{1} << left) - 1) : word;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud::lines
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace safety_control_cloud::lines {

HWY_EXPORT(find_near);
HWY_EXPORT(find_ground);
HWY_EXPORT(note_steps);
HWY_EXPORT(go_on_along);
HWY_EXPORT(go_on_up);
HWY_EXPORT(in_slots);
HWY_EXPORT(note_lowest);
HWY_EXPORT(mark_inner);

float find_near(const PixelsOfRow& pixels, const Surrounding& around, float* ahead) {
  return HWY_DYNAMIC_DISPATCH(find_near)(pixels, around, ahead);
}

int find_ground(const PixelsOfRow& pixels, const Surrounding& around, std::int16_t* ground, float* ahead) {
  return HWY_DYNAMIC_DISPATCH(find_ground)(pixels, around, ground, ahead);
}

void note_steps(const std::int16_t* row, const std::int16_t* below, const std::int16_t* kept, std::size_t columns,
                std::int16_t number, const StepLimits& limits, const StepsSoFar& steps) {
  HWY_DYNAMIC_DISPATCH(note_steps)(row, below, kept, columns, number, limits, steps);
}

void go_on_along(const LineOfSlots& line, std::size_t slots, float jump, std::uint8_t* back, std::uint8_t* begins,
                 std::uint8_t* touched) {
  HWY_DYNAMIC_DISPATCH(go_on_along)(line, slots, jump, back, begins, touched);
}

void go_on_up(const LineOfSlots& line, const LineOfSlots& above, const LineOfSlots& next, std::size_t slots, float jump,
              std::uint8_t* up, const Touched& touched) {
  HWY_DYNAMIC_DISPATCH(go_on_up)(line, above, next, slots, jump, up, touched);
}

InSlots in_slots(const SomeSlots& some, const Corridor& corridor, float border) {
  return HWY_DYNAMIC_DISPATCH(in_slots)(some, corridor, border);
}

void note_lowest(const SomeSlots& some, std::uint32_t first, std::uint32_t* lowest) {
  HWY_DYNAMIC_DISPATCH(note_lowest)(some, first, lowest);
}

void mark_inner(const std::uint8_t* touched, std::size_t size, std::uint64_t* inner) {
  HWY_DYNAMIC_DISPATCH(mark_inner)(touched, size, inner);
}

}  // namespace safety_control_cloud::lines

#endif
