// SPDX-License-Identifier: BSD-3-Clause
// What a run has left in the pixels' memory; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL
#undef SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL
#else
#define SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "pixel_memory.hpp"
#include "runs.hpp"
#include "scan.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Codes = hn::CappedTag<std::uint16_t, 16>;  // Highway 1.0 cannot reduce longer ones
using Code = hn::Vec<Codes>;

constexpr std::size_t codes = hn::MaxLanes(Codes());

/// How many lanes were set in all masks; at most 65535 altogether.
class CodeTally {
 public:
  HWY_INLINE CodeTally() : count_(hn::Zero(Codes())) {}

  HWY_INLINE void add(hn::Mask<Codes> mask) {
#if HWY_TARGET <= HWY_AVX3  // masks have registers of their own
    count_ = hn::IfThenElse(mask, hn::Add(count_, hn::Set(Codes(), 1)), count_);
#else  // a set lane is all ones, which is -1
    count_ = hn::Sub(count_, hn::VecFromMask(Codes(), mask));
#endif
  }
  HWY_INLINE std::size_t total() const { return hn::GetLane(hn::SumOfLanes(Codes(), count_)); }

 private:
  Code count_;
};

/// What the pixels of a run are to remember of a cloud, with the flag `now`; 0 where they return nothing. A vector is
/// stored whole, wherever its last point ends.
using SeenPixels = std::array<std::uint16_t, Runs::longest + Inside::longest_vector>;

/// Asks for the memory of a run's pixels, so that it has come when the run has been scanned.
HWY_INLINE void fetch_pixels(const Run& run, const PixelMemory& memory) {
  constexpr std::size_t cache_line = 64 / sizeof(std::uint16_t);
  const std::uint16_t* pixels = memory.pixels.data() + run.first;
  for (std::size_t i = 0; i < width_of(run.points); i += cache_line) hwy::Prefetch(pixels + i);
}

/// Brings a piece of a row up to date, and PixelMemory::note().
HWY_NOINLINE void remember_piece(const std::uint16_t* seen, PixelMemory& memory, std::size_t row, std::size_t column,
                                 std::size_t size) {
  const Codes tag;
  const Code near_end = hn::Set(tag, PixelMemory::ground_zero), flag = hn::Set(tag, PixelMemory::now);
  std::uint16_t* pixels = memory.row(row) + column;
  std::uint16_t* nearest_now = memory.near.nearest_now.data() + column;
  Code nearest_lost = hn::Set(tag, PixelMemory::none);
  CodeTally now, lost;
  std::size_t i = 0;
  for (; i + codes <= size; i += codes) {
    const Code kept = hn::AndNot(flag, hn::LoadU(tag, pixels + i));
    const Code pixel = hn::Max(hn::LoadU(tag, seen + i), kept), flipped = hn::Xor(pixel, flag);  // `now` is more
    hn::StoreU(pixel, tag, pixels + i);
    hn::StoreU(hn::Min(hn::LoadU(tag, nearest_now + i), flipped), tag, nearest_now + i);
    nearest_lost = hn::Min(nearest_lost, pixel);
    now.add(hn::Lt(flipped, near_end));
    lost.add(hn::Lt(pixel, near_end));
  }
  std::uint16_t& nearest_lost_in_row = memory.near.nearest_lost[row];
  nearest_lost_in_row = std::min(nearest_lost_in_row, hn::GetLane(hn::MinOfLanes(tag, nearest_lost)));
  memory.near.now += now.total();
  memory.near.lost += lost.total();
  for (std::size_t rest = i; rest < size; ++rest) {
    pixels[rest] = std::max(seen[rest], PixelMemory::code_of(pixels[rest]));
  }
  memory.note(row, column + i, size - i);
}

void remember_pixels(const Run& run, const SeenPixels& seen, PixelMemory& memory) {
  const std::uint16_t* piece = seen.data();
  memory.for_each_piece(run.first, width_of(run.points), [&](std::size_t row, std::size_t column, std::size_t size) {
    remember_piece(piece, memory, row, column, size);
    piece += size;
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
