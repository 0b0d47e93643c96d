// SPDX-License-Identifier: BSD-3-Clause
#include "look.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "../input/point_reader.hpp"
#include "kernel/scan.hpp"
#include "nearest.hpp"

namespace safety_control_cloud {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t cached_runs = 4;  ///< at most 128 KB of 32 bytes a point

/// Calls visit(x, y, z) for the points inside a run, in the cloud's frame.
template <class Visit>
void for_each_inside(const Run& run, const Outlook& outlook, Visit visit) {
  const Inside inside = inside_of(run, outlook);
  with_reader(run.points, [&](auto reader) {
    for (std::size_t i = 0; i < inside.size; ++i) reader(0, inside.columns[i], visit);
  });
}

/// scan(), and take(i) for each run i while that is still in the cache.
template <class Take>
Counts scan_and_take(const Runs& runs, const Outlook& outlook, float* nearest, Take take) {
  Counts all;
  for (std::size_t begin = 0; begin < runs.size(); begin += cached_runs) {
    const std::size_t end = std::min(begin + cached_runs, runs.size());
    all += scan(runs, begin, end, outlook, nearest);
    for (std::size_t i = begin; i < end; ++i) take(i);
  }
  return all;
}

void add_inside(const Run& run, const Outlook& outlook, Cloud& crop) {
  for_each_inside(run, outlook, [&](float x, float y, float z) { crop.points.emplace_back(x, y, z); });
  crop.width = static_cast<std::uint32_t>(crop.size());
}

/// The points among which the `rank`-th nearest is, in the cloud's order, taken from few runs: from those that come
/// nearer than the rank-th of the runs' nearest, of which there are at most `rank`, and from the first that comes just
/// as near.
Cloud candidates_in(const Runs& runs, const std::vector<float>& nearest, float farthest, const Outlook& outlook) {
  Cloud candidates;
  bool first = farthest < infinity;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool just_as_near = first && nearest[i] == farthest;
    if (!just_as_near && !(nearest[i] < farthest)) continue;
    if (just_as_near) first = false;
    for_each_inside(runs[i], outlook, [&](float x, float y, float z) {
      const Point point = outlook.placed(x, y, z);
      if (point.z <= farthest) candidates.points.push_back(point);
    });
  }
  return candidates;
}

/// nearest_of() without a list of all points inside.
std::optional<Obstacle> nearest_in(const Runs& runs, const std::vector<float>& nearest, const Counts& counts,
                                   const Outlook& outlook) {
  const auto rank = rank_of(counts.too_close, outlook.corridor.min_points);
  if (!rank) return too_close_to_measure();
  if (*rank >= counts.inside) return std::nullopt;
  const float farthest = ranked(nearest, *rank);
  const Cloud candidates = candidates_in(runs, nearest, farthest, outlook);
  return first_at(candidates, std::min(farthest, ranked_z(candidates, *rank)));
}

/// Of runs of which as many make each row.
std::vector<float> by_rows(std::vector<float> runs, std::size_t rows) {
  if (rows == 0 || runs.size() == rows) return runs;
  const auto in_row = static_cast<std::ptrdiff_t>(runs.size() / rows);
  std::vector<float> nearest;
  for (auto first = runs.begin(); first != runs.end(); first += in_row) {
    nearest.push_back(*std::min_element(first, first + in_row));
  }
  return nearest;
}

}  // namespace

Sight look(const View& view, const Outlook& outlook, Crop crop, Rows rows) {
  return look_alongside(view, outlook, crop, rows, nullptr);
}

Sight look_alongside(const View& view, const Outlook& outlook, Crop crop, Rows rows, const Alongside* alongside) {
  const Runs runs(view, rows);
  std::vector<float> nearest(runs.size());
  const Cloud::Ptr points(crop == Crop::Keep ? new Cloud(0, 1) : nullptr);
  const auto take = [&](std::size_t i) {
    if (points && nearest[i] < infinity) add_inside(runs[i], outlook, *points);
  };
  Counts counts;
  if (alongside) {
    counts = scan_and_gather(runs, outlook, nearest.data(), *alongside);
    for (std::size_t i = 0; i < runs.size(); ++i) take(i);
  } else {
    counts = points ? scan_and_take(runs, outlook, nearest.data(), take)
                    : scan(runs, 0, runs.size(), outlook, nearest.data());
  }
  Sight sight;
  sight.nearest = nearest_in(runs, nearest, counts, outlook);
  sight.inside = counts.inside;
  sight.too_close = counts.too_close;
  sight.returns = counts.returns;
  sight.total = size_of(view);
  if (rows == Rows::Apart) sight.nearest_in_rows = by_rows(std::move(nearest), height_of(view));
  sight.crop = points;
  return sight;
}

}  // namespace safety_control_cloud
