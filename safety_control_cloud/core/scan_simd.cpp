// SPDX-License-Identifier: BSD-3-Clause
// scan() with Highway: this file is compiled once for every instruction set, and the best one of the machine is used.
// Nothing here branches on what the points are, so that the time does not depend on the scene; only a run with a point
// at -Inf (REP 117) is gone through once more, from the cache.
#include <limits>
#include <stdexcept>

#include "scan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_simd.cpp"
// Vectors are members of structs here, which those of unknown length cannot be; NEON serves such machines.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "scan_found-inl.hpp"
#include "scan_pixels-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

static_assert(lanes <= Inside::longest_vector);

/// Counts, and finds the nearest.
template <class Placing>
struct Counting {
  Walls walls;
  Placing place;
  Tally returns, inside;
  Float nearest;
  Float lowest;  ///< -inf if a point may be too close

  HWY_INLINE Counting(const Corridor& corridor, const Gaze& gaze)
      : walls(corridor), place(gaze), nearest(all(infinity)), lowest(nearest) {}

  HWY_INLINE void take(const Points& points, std::size_t) { note(points, place(points), is_return(points, walls)); }

  HWY_INLINE void note(const Points& points, const Points& placed, Mask returning) {
    const Mask in_corridor = place.inside(placed, walls, returning);
    returns.add(returning);
    inside.add(in_corridor);
    nearest = hn::IfThenElse(in_corridor, hn::Min(nearest, placed.z), nearest);
    lowest = hn::Min(points.z, lowest);  // of two operands, x86 drops a NaN only if it is the first
  }
};

/// Counts, and writes down what the pixels are to remember.
template <class Placing>
struct Remembering : Counting<Placing> {
  Float near_distance;
  std::uint16_t* seen;

  HWY_INLINE Remembering(const Corridor& corridor, const Gaze& gaze, SeenPixels& pixels)
      : Counting<Placing>(corridor, gaze), near_distance(all(gaze.memory->distance)), seen(pixels.data()) {}

  HWY_INLINE void take(const Points& points, std::size_t column) {
    const Points placed = this->place(points);
    const Mask returning = is_return(points, this->walls);
    this->note(points, placed, returning);

    const hn::Rebind<std::uint16_t, Floats> halves;
    hn::Store(hn::TruncateTo(halves, remembered(placed, this->walls, near_distance, returning)), halves, seen + column);
  }
};

/// Counts the points that are too close. Most clouds have none, and are spared this.
struct CountingTooClose {
  Walls walls;
  bool anywhere;
  Tally too_close;

  HWY_INLINE CountingTooClose(const Corridor& corridor, const Gaze& gaze)
      : walls(corridor), anywhere(gaze.placement != nullptr) {}

  HWY_INLINE void take(const Points& points, std::size_t) { too_close.add(is_too_close(points, walls, anywhere)); }
};

/// Lists the columns inside.
template <class Placing>
struct Listing {
  Walls walls;
  Placing place;
  Inside* found;

  HWY_INLINE Listing(const Corridor& corridor, const Gaze& gaze, Inside& inside)
      : walls(corridor), place(gaze), found(&inside) {}

  HWY_INLINE void take(const Points& points, std::size_t column) {
    const Mask inside = place.inside(place(points), walls, is_return(points, walls));
    const Integer columns = hn::Iota(Integers(), static_cast<std::uint32_t>(column));
    std::uint32_t* end = found->columns.data() + found->size;
    found->size += hn::CompressStore(columns, hn::RebindMask(Integers(), inside), Integers(), end);
  }
};

std::size_t too_close_in(const Run& run, const Corridor& corridor, const Gaze& gaze) {
  CountingTooClose counting(corridor, gaze);
  visit_run(run, counting);
  return counting.too_close.total();
}

/// Counts the points of a run.
template <class Visitor>
Counts scan_run(const Run& run, const Visitor& fresh, const Corridor& corridor, const Gaze& gaze, float& nearest) {
  Visitor visitor = fresh;
  visit_run(run, visitor);
  nearest = hn::GetLane(hn::MinOfLanes(Floats(), visitor.nearest));
  const bool any_too_close = hn::GetLane(hn::MinOfLanes(Floats(), visitor.lowest)) == -infinity;
  return {visitor.returns.total(), visitor.inside.total(), any_too_close ? too_close_in(run, corridor, gaze) : 0};
}

template <class Placing>
Counts scan_with(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
                 float* nearest) {
  Counts counts;
  if (!gaze.memory) {
    const Counting<Placing> fresh(corridor, gaze);
    for (std::size_t i = begin; i < end; ++i) counts += scan_run(runs[i], fresh, corridor, gaze, nearest[i]);
    return counts;
  }
  HWY_ALIGN SeenPixels seen;
  const Remembering<Placing> fresh(corridor, gaze, seen);
  for (std::size_t i = begin; i < end; ++i) {
    const Run run = runs[i];
    fetch_pixels(run, *gaze.memory);
    counts += scan_run(run, fresh, corridor, gaze, nearest[i]);
    remember_pixels(run, seen, *gaze.memory);
  }
  return counts;
}

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
            float* nearest) {
  return gaze.placement ? scan_with<Placed>(runs, begin, end, corridor, gaze, nearest)
                        : scan_with<Unplaced>(runs, begin, end, corridor, gaze, nearest);
}

template <class Placing>
void list(const Run& run, const Corridor& corridor, const Gaze& gaze, Inside& found) {
  Listing<Placing> listing(corridor, gaze, found);
  visit_run(run, listing);
}

Inside inside_of(const Run& run, const Corridor& corridor, const Gaze& gaze) {
  Inside found;
  found.size = 0;
  gaze.placement ? list<Placed>(run, corridor, gaze, found) : list<Unplaced>(run, corridor, gaze, found);
  return found;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace safety_control_cloud {

HWY_EXPORT(scan);
HWY_EXPORT(inside_of);

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
            float* nearest) {
  return HWY_DYNAMIC_DISPATCH(scan)(runs, begin, end, corridor, gaze, nearest);
}

Inside inside_of(const Run& run, const Corridor& corridor, const Gaze& gaze) {
  return HWY_DYNAMIC_DISPATCH(inside_of)(run, corridor, gaze);
}

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const auto target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

void use_instruction_set(const std::string& name) {
  hwy::SetSupportedTargetsForTest(0);
  if (name.empty()) return;
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    if (name != hwy::TargetName(target)) continue;
    hwy::SetSupportedTargetsForTest(target);
    return;
  }
  throw std::invalid_argument("no instruction set " + name + " on this machine");
}

}  // namespace safety_control_cloud

#endif
