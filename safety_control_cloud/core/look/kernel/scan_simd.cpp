// SPDX-License-Identifier: BSD-3-Clause
// scan() with Highway, or with what ../without_highway/ has in its place: this file is compiled once for every
// instruction set, and the best one of the machine is used. Nothing here branches on what the points are, so that the
// time does not depend on the scene; only a run with a point at -Inf (REP 117) is gone through once more, from the
// cache.
#include <limits>
#include <stdexcept>

#include "scan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_simd.cpp"
// Vectors are members of structs here, which those of unknown length cannot be; NEON serves such machines.
#define SAFETY_CONTROL_OF_UNKNOWN_LENGTH (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#ifdef SAFETY_CONTROL_FEW_TARGETS
#define HWY_DISABLED_TARGETS (SAFETY_CONTROL_OF_UNKNOWN_LENGTH | HWY_SSSE3 | HWY_SSE4)
#else
#define HWY_DISABLED_TARGETS SAFETY_CONTROL_OF_UNKNOWN_LENGTH
#endif
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "found-inl.hpp"
#include "gathering-inl.hpp"
#include "runs-inl.hpp"
#include "tally-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace safety_control_cloud {
namespace HWY_NAMESPACE {
namespace {

static_assert(lanes <= Inside::longest_vector && lanes <= Places::longest_vector);

/// Counts, and finds the nearest.
template <class Placing>
struct Counting {
  Walls walls;
  Placing place;
  Tally<Integers> returns, inside;
  Float nearest;
  Float lowest;  ///< -inf if a point may be too close

  explicit HWY_INLINE Counting(const Outlook& outlook) : walls(outlook.corridor), place(outlook) { start_run(); }

  HWY_INLINE void start_run() { nearest = lowest = all(infinity); }

  HWY_INLINE void go_on_from(const Counting& other) {
    returns = other.returns, inside = other.inside;
    nearest = other.nearest, lowest = other.lowest;
  }

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t column, std::size_t) {
    note(points.at_in_any_order(column));
  }

  /// A function, not the loop's own lines: named there, the points go to memory instead of registers.
  HWY_INLINE Found note(const Points& points) {
    const Found found(points, walls, place);
    returns.add(hn::RebindMask(Integers(), found.returning));
    inside.add(hn::RebindMask(Integers(), found.inside));
    nearest = hn::IfThenElse(found.inside, hn::Min(nearest, found.placed.z), nearest);
    lowest = lesser(points.z, lowest);
    return found;
  }
};

template <class Placing>
constexpr bool is_quick<Counting<Placing>> = true;

/// Counts the points that are too close. Most clouds have none, and are spared this.
struct CountingTooClose {
  Walls walls;
  bool anywhere;
  Tally<Integers> too_close;

  explicit HWY_INLINE CountingTooClose(const Outlook& outlook)
      : walls(outlook.corridor), anywhere(outlook.placement.has_value()) {}

  HWY_INLINE void go_on_from(const CountingTooClose& other) { too_close = other.too_close; }

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t column, std::size_t) {
    too_close.add(hn::RebindMask(Integers(), is_too_close(points.at_in_any_order(column), walls, anywhere)));
  }
};

/// Lists the columns inside.
template <class Placing>
struct Listing {
  Walls walls;
  Placing place;
  Inside* found;

  HWY_INLINE Listing(const Outlook& outlook, Inside& inside)
      : walls(outlook.corridor), place(outlook), found(&inside) {}

  HWY_INLINE void go_on_from(const Listing&) {}

  template <class Source>
  HWY_INLINE void take(const Source& points, std::size_t from, std::size_t column) {
    const Mask inside = Found(points.at(from), walls, place).inside;
    if (hn::AllFalse(Floats(), inside)) return;  // most of most clouds
    const Chosen chosen(inside);
    chosen.write(hn::Iota(Integers(), static_cast<std::uint32_t>(column)), found->columns.data() + found->size);
    found->size += chosen.size();
  }
};

std::size_t too_close_in(const Run& run, const Outlook& outlook) {
  CountingTooClose counting(outlook);
  visit_run(run, counting);
  return counting.too_close.total();
}

/// How many points of the run that has been visited are too close, and the nearest of those inside.
template <class Placing>
HWY_INLINE std::size_t end_run(const Counting<Placing>& counting, const Run& run, const Outlook& outlook,
                               float& nearest) {
  nearest = hn::GetLane(hn::MinOfLanes(Floats(), counting.nearest));
  const bool any_too_close = hn::GetLane(hn::MinOfLanes(Floats(), counting.lowest)) == -infinity;
  return any_too_close ? too_close_in(run, outlook) : 0;
}

template <class Placing>
Counts scan_placing(const Runs& runs, std::size_t begin, std::size_t end, const Outlook& outlook, float* nearest) {
  Counting<Placing> counting(outlook);
  std::size_t too_close = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Run run = runs[i];
    counting.start_run();
    visit_run(run, counting);
    too_close += end_run(counting, run, outlook, nearest[i]);
  }
  return {counting.returns.total(), counting.inside.total(), too_close};
}

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Outlook& outlook, float* nearest) {
  return outlook.placement ? scan_placing<Placed>(runs, begin, end, outlook, nearest)
                           : scan_placing<Unplaced>(runs, begin, end, outlook, nearest);
}

template <class Placing>
void list(const Run& run, const Outlook& outlook, Inside& found) {
  Listing<Placing> listing(outlook, found);
  visit_run(run, listing);
}

Inside inside_of(const Run& run, const Outlook& outlook) {
  Inside found;
  found.size = 0;
  outlook.placement ? list<Placed>(run, outlook, found) : list<Unplaced>(run, outlook, found);
  return found;
}

template <class Placing>
void gather_placing(const Run& run, const Outlook& outlook, const Region& region, Places& places) {
  Gathering<Placing> gathering(outlook, region, places);
  visit_run(run, gathering);
  places.size = gathering.size;
}

void gather(const Run& run, const Outlook& outlook, const Region& region, Places& places) {
  outlook.placement ? gather_placing<Placed>(run, outlook, region, places)
                    : gather_placing<Unplaced>(run, outlook, region, places);
}

/// What is done with the places of a run leaves the memory idle: it is asked for more of the next run before.
HWY_INLINE void fetch_next(const Run& run) {
  constexpr std::size_t size = 8192;  // [byte]
  const auto* cloud = std::get_if<CloudView>(&run.points);
  if (cloud) fetch_early(cloud->bytes + cloud->width * cloud->point_step, size);
}

template <class Visitor>
Counts scan_and_take(Visitor both, const Runs& runs, const Outlook& outlook, float* nearest, Places& places,
                     const TakePlaces& take) {
  std::size_t too_close = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run run = runs[i];
    both.counting.start_run();
    both.gathering.size = 0;
    visit_run(run, both);
    fetch_next(run);
    too_close += end_run(both.counting, run, outlook, nearest[i]);
    places.size = both.gathering.size;
    take(places);
  }
  return {both.counting.returns.total(), both.counting.inside.total(), too_close};
}

/// Of two that are placed.
Counts scan_and_gather(const Runs& runs, const Outlook& outlook, float* nearest, const Alongside& alongside) {
  const auto& [other, region, take] = alongside;
  const bool alike =
      outlook.placement->rows == other.placement->rows && outlook.corridor.range_min == other.corridor.range_min;
  Places places;
  const Counting<Placed> counting(outlook);
  if (alike) {
    const Gathering<Unplaced> gathering(other, region, places);
    return scan_and_take(BothAlike{counting, gathering}, runs, outlook, nearest, places, take);
  }
  const Gathering<Placed> gathering(other, region, places);
  return scan_and_take(Both{counting, gathering}, runs, outlook, nearest, places, take);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace safety_control_cloud
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace safety_control_cloud {

HWY_EXPORT(scan);
HWY_EXPORT(inside_of);
HWY_EXPORT(gather);
HWY_EXPORT(scan_and_gather);
HWY_EXPORT(find_cells);

Counts scan(const Runs& runs, std::size_t begin, std::size_t end, const Outlook& outlook, float* nearest) {
  return HWY_DYNAMIC_DISPATCH(scan)(runs, begin, end, outlook, nearest);
}

Inside inside_of(const Run& run, const Outlook& outlook) { return HWY_DYNAMIC_DISPATCH(inside_of)(run, outlook); }

void gather(const Run& run, const Outlook& outlook, const Region& region, Places& places) {
  HWY_DYNAMIC_DISPATCH(gather)(run, outlook, region, places);
}

Counts scan_and_gather(const Runs& runs, const Outlook& outlook, float* nearest, const Alongside& alongside) {
  if (outlook.placement && alongside.outlook.placement)  // as a robot's cameras are
    return HWY_DYNAMIC_DISPATCH(scan_and_gather)(runs, outlook, nearest, alongside);
  Counts all;
  Places places;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    all += scan(runs, i, i + 1, outlook, nearest);
    gather(runs[i], alongside.outlook, alongside.region, places);
    alongside.take(places);
  }
  return all;
}

void find_cells(const Places& places, const std::vector<CellGrid>& grids, CellNumbers& cells) {
  HWY_DYNAMIC_DISPATCH(find_cells)(places, grids, cells);
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
