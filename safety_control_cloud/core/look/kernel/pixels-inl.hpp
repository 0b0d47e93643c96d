// SPDX-License-Identifier: BSD-3-Clause
// How a run is brought into the pixels' memory; part of scan_simd.cpp, compiled once for every instruction set.
#if defined(SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL
#undef SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL
#else
#define SAFETY_CONTROL_CLOUD_SCAN_PIXELS_INL
#endif

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "../../memory/pixel_memory.hpp"
#include "depths-inl.hpp"
#include "tally-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

/// The pixels of a run in one row while it is scanned: brings them up to date, and does what PixelMemory::note() does.
class Pixels {
 public:
  HWY_INLINE Pixels() {}  // a defaulted one would not be compiled for the instruction set

  HWY_INLINE void start_run(std::uint16_t* pixels, std::uint16_t* nearest_now) {
    nearest_lost_ = hn::Set(Codes(), PixelMemory::none);
    now_ = lost_ = Tally<Codes>();
    move_to(pixels, nearest_now);
  }
  HWY_INLINE void move_to(std::uint16_t* pixels, std::uint16_t* nearest_now) {
    pixels_ = pixels;
    nearest_now_ = nearest_now;
  }

  /// What `codes` pixels are to remember of the cloud, with the flag `now`; 0 where they return nothing.
  HWY_INLINE void take(Code seen, std::size_t column) {
    const Codes tag;
    const Code flag = hn::Set(tag, PixelMemory::now);
    const Code kept = hn::AndNot(flag, hn::LoadU(tag, pixels_ + column));
    const Code pixel = hn::Max(seen, kept), flipped = hn::Xor(pixel, flag);  // `now` is more
    hn::StoreU(pixel, tag, pixels_ + column);
    hn::StoreU(hn::Min(hn::LoadU(tag, nearest_now_ + column), flipped), tag, nearest_now_ + column);
    nearest_lost_ = hn::Min(nearest_lost_, pixel);
    now_.add(is_near(pixel));
    lost_.add(is_near(flipped));
  }

  HWY_INLINE void note(NearPixels& near, std::size_t row) const {
    const std::uint16_t least = least_of(nearest_lost_);
    if (PixelMemory::is_near(least)) near.nearest_lost[row] = std::min(near.nearest_lost[row], least);
    near.now += now_.total();
    near.lost += lost_.total();
  }

 private:
  /// Of codes whose top bit has been flipped. Every instruction set compares signed numbers, and not all others.
  static HWY_INLINE hn::Mask<Codes> is_near(Code flipped) {
    const SignedCodes tag;
    return hn::RebindMask(Codes(),
                          hn::Lt(hn::BitCast(tag, flipped), hn::Set(tag, PixelMemory::ground_zero - PixelMemory::now)));
  }

  std::uint16_t* pixels_;
  std::uint16_t* nearest_now_;
  Code nearest_lost_;
  Tally<Codes> now_, lost_;  // of a run, which 16 bits can count
};

/// The end of a row that does not fill a vector, in one.
struct RowEnd {
  HWY_ALIGN std::uint16_t pixels[codes], nearest_now[codes];

  RowEnd(const std::uint16_t* some_pixels, const std::uint16_t* some_nearest, std::size_t size) {
    std::fill(std::copy_n(some_pixels, size, pixels), pixels + codes, PixelMemory::nothing);
    std::fill(std::copy_n(some_nearest, size, nearest_now), nearest_now + codes, PixelMemory::none);
  }
};

/// visit_run() for a run in one row, with the visitor's `pixels` on those of the run.
template <class Visitor>
void visit_pixels(const Run& run, PixelMemory& memory, Visitor& visitor) {
  const std::size_t row = run.first / memory.width, column = run.first % memory.width;
  std::uint16_t *pixels = memory.row(row) + column, *nearest_now = memory.near.nearest_now.data() + column;
  visitor.pixels.start_run(pixels, nearest_now);
  const std::size_t width = width_of(run.points), rest = width % codes, whole = width - rest;
  assert(column + width <= memory.width);
  if (rest == 0) {
    visit_run(run, visitor);
  } else {
    if (whole > 0) visit_run(part_of(run, 0, whole), visitor);
    RowEnd end(pixels + whole, nearest_now + whole, rest);
    visitor.pixels.move_to(end.pixels, end.nearest_now);
    visit_run(part_of(run, whole, rest), visitor);
    std::copy_n(end.pixels, rest, pixels + whole);
    std::copy_n(end.nearest_now, rest, nearest_now + whole);
  }
  visitor.pixels.note(memory.near, row);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#endif
