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
#include "pixels-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

static_assert(lanes <= Inside::longest_vector);

/// Counts, and finds the nearest.
template <class Placing>
struct Counting {
  static constexpr std::size_t at_once = lanes;

  Walls walls;
  Placing place;
  Tally<Integers> returns, inside;
  Float nearest;
  Float lowest;  ///< -inf if a point may be too close

  HWY_INLINE Counting(const Corridor& corridor, const Gaze& gaze) : walls(corridor), place(gaze) { start_run(); }

  HWY_INLINE void start_run() { nearest = lowest = all(infinity); }

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t column, std::size_t) {
    note(points.at(column));
  }

  HWY_INLINE Found note(const Points& points) {
    const Found found(points, walls, place);
    returns.add(hn::RebindMask(Integers(), found.returning));
    inside.add(hn::RebindMask(Integers(), found.inside));
    nearest = hn::IfThenElse(found.inside, hn::Min(nearest, found.placed.z), nearest);
    lowest = hn::IfThenElse(hn::Lt(points.z, lowest), points.z, lowest);  // Min() drops a NaN on some machines only
    return found;
  }
};

/// Counts, and brings the pixels up to date.
template <class Placing>
struct Remembering : Counting<Placing> {
  static constexpr std::size_t at_once = codes;

  Float near_distance;
  Pixels pixels;

  HWY_INLINE Remembering(const Corridor& corridor, const Gaze& gaze)
      : Counting<Placing>(corridor, gaze), near_distance(all(gaze.memory->distance)) {}

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t column, std::size_t pixel) {
    const auto first = of_points(points.at(column));
    const auto second = lanes == codes ? first : of_points(points.at(column + lanes));
    pixels.take(codes_of(first, second), pixel);
  }

  HWY_INLINE hn::Vec<Signed> of_points(const Points& points) {
    return remembered(this->note(points), this->place, near_distance);
  }
};

/// Counts the points that are too close. Most clouds have none, and are spared this.
struct CountingTooClose {
  static constexpr std::size_t at_once = lanes;

  Walls walls;
  bool anywhere;
  Tally<Integers> too_close;

  HWY_INLINE CountingTooClose(const Corridor& corridor, const Gaze& gaze)
      : walls(corridor), anywhere(gaze.placement != nullptr) {}

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t column, std::size_t) {
    too_close.add(hn::RebindMask(Integers(), is_too_close(points.at(column), walls, anywhere)));
  }
};

/// Lists the columns inside.
template <class Placing>
struct Listing {
  static constexpr std::size_t at_once = lanes;

  Walls walls;
  Placing place;
  Inside* found;

  HWY_INLINE Listing(const Corridor& corridor, const Gaze& gaze, Inside& inside)
      : walls(corridor), place(gaze), found(&inside) {}

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t from, std::size_t column) {
    const Mask inside = Found(points.at(from), walls, place).inside;
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

/// Starts with the next run.
template <class Placing>
void scan_run(const Run& run, Counting<Placing>& counting, PixelMemory*) {
  counting.start_run();
  visit_run(run, counting);
}

template <class Placing>
void scan_run(const Run& run, Remembering<Placing>& remembering, PixelMemory* memory) {
  remembering.start_run();
  visit_pixels(run, *memory, remembering);
}

template <class Visitor>
Counts scan_with(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
                 float* nearest) {
  Visitor visitor(corridor, gaze);
  std::size_t too_close = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Run run = runs[i];
    scan_run(run, visitor, gaze.memory);
    nearest[i] = hn::GetLane(hn::MinOfLanes(Floats(), visitor.nearest));
    const bool any_too_close = hn::GetLane(hn::MinOfLanes(Floats(), visitor.lowest)) == -infinity;
    if (any_too_close) too_close += too_close_in(run, corridor, gaze);
  }
  return {visitor.returns.total(), visitor.inside.total(), too_close};
}

template <class Placing>
Counts scan_placing(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
                    float* nearest) {
  return gaze.memory ? scan_with<Remembering<Placing>>(runs, begin, end, corridor, gaze, nearest)
                     : scan_with<Counting<Placing>>(runs, begin, end, corridor, gaze, nearest);
}

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Corridor& corridor, const Gaze& gaze,
            float* nearest) {
  return gaze.placement ? scan_placing<Placed>(runs, begin, end, corridor, gaze, nearest)
                        : scan_placing<Unplaced>(runs, begin, end, corridor, gaze, nearest);
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
