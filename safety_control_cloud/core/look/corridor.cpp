// SPDX-License-Identifier: BSD-3-Clause
#include "corridor.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "../input/point_reader.hpp"
#include "kernel/scan.hpp"

namespace safety_control_cloud {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The value that has `rank` others before it when all are in order; infinity if there are not so many.
float ranked(std::vector<float> values, std::size_t rank) {
  if (rank >= values.size()) return infinity;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

std::vector<float> depths_of(const Cloud& cloud) {
  std::vector<float> depths(cloud.size());
  std::transform(cloud.begin(), cloud.end(), depths.begin(), [](const Point& point) { return point.z; });
  return depths;
}

const Obstacle too_close_to_measure = {Point(0.0f, 0.0f, 0.0f)};

/// How many of the points inside, by z, come before the one that makes an obstacle, as the points that are too close
/// come first of all; none if these suffice.
std::optional<std::size_t> rank_of(std::size_t too_close, const Corridor& corridor) {
  if (too_close >= corridor.min_points) return std::nullopt;
  return corridor.min_points - too_close - 1;
}

/// The first point at distance z [m], of which there is one.
Obstacle first_at(const Cloud& cloud, float z) {
  return {*std::find_if(cloud.begin(), cloud.end(), [&](const Point& point) { return point.z == z; })};
}

/// Calls visit(x, y, z) for the points inside a run, in the cloud's frame.
template <class Visit>
void for_each_inside(const Run& run, const Corridor& corridor, const Gaze& gaze, Visit visit) {
  const Inside inside = inside_of(run, corridor, gaze);
  with_reader(run.points, [&](auto reader) {
    for (std::size_t i = 0; i < inside.size; ++i) reader(0, inside.columns[i], visit);
  });
}

/// scan(), and each run's points inside while the run is still in the cache.
Counts scan_and_crop(const Runs& runs, const Corridor& corridor, const Gaze& gaze, float* nearest, Cloud& crop) {
  Counts all;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Counts counts = scan(runs, i, i + 1, corridor, gaze, nearest);
    all += counts;
    if (counts.inside == 0) continue;
    for_each_inside(runs[i], corridor, gaze, [&](float x, float y, float z) { crop.points.emplace_back(x, y, z); });
  }
  crop.width = static_cast<std::uint32_t>(crop.size());
  crop.height = 1;
  return all;
}

/// The points among which the `rank`-th nearest is, in the cloud's order, taken from few runs: from those that come
/// nearer than the rank-th of the runs' nearest, of which there are at most `rank`, and from the first that comes just
/// as near.
Cloud candidates_in(const Runs& runs, const std::vector<float>& nearest, float farthest, const Corridor& corridor,
                    const Gaze& gaze) {
  Cloud candidates;
  bool first = farthest < infinity;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool just_as_near = first && nearest[i] == farthest;
    if (!just_as_near && !(nearest[i] < farthest)) continue;
    if (just_as_near) first = false;
    for_each_inside(runs[i], corridor, gaze, [&](float x, float y, float z) {
      const Point point = placed(x, y, z, gaze);
      if (point.z <= farthest) candidates.points.push_back(point);
    });
  }
  return candidates;
}

/// nearest_of() without a list of all points inside.
std::optional<Obstacle> nearest_in(const Runs& runs, const std::vector<float>& nearest, const Counts& counts,
                                   const Corridor& corridor, const Gaze& gaze) {
  const auto rank = rank_of(counts.too_close, corridor);
  if (!rank) return too_close_to_measure;
  if (*rank >= counts.inside) return std::nullopt;

  const float farthest = ranked(nearest, *rank);
  const Cloud candidates = candidates_in(runs, nearest, farthest, corridor, gaze);
  return first_at(candidates, std::min(farthest, ranked(depths_of(candidates), *rank)));
}

}  // namespace

bool is_too_close(float x, float y, float z, const Corridor& corridor, const Gaze& gaze) {
  if (z != -infinity) return false;
  if (gaze.placement) return true;
  const bool left_or_right = std::isfinite(x) && !corridor.spans(x);
  const bool above_or_below = std::isfinite(y) && (y < corridor.y_min || y > corridor.y_max);
  return !left_or_right && !above_or_below;
}

std::uint16_t remembered(const Point& point, const Corridor& corridor, const Gaze& gaze) {
  const bool near = point.z > 0.0f && point.z < gaze.memory->distance;
  if (!near || !corridor.spans(point.x)) return PixelMemory::elsewhere;
  if (point.y > corridor.y_max) return PixelMemory::ground_code(point.y - camera_in(gaze).y);
  return point.y >= corridor.y_min ? PixelMemory::near_code(point.z) : PixelMemory::elsewhere;
}

std::optional<Obstacle> nearest_of(std::size_t too_close, const Cloud& inside, const Corridor& corridor) {
  const auto rank = rank_of(too_close, corridor);
  if (!rank) return too_close_to_measure;
  if (*rank >= inside.size()) return std::nullopt;
  return first_at(inside, ranked(depths_of(inside), *rank));
}

Sight look(const View& view, const Corridor& corridor, const Gaze& gaze) {
  const Runs runs(view, gaze.memory ? Rows::Apart : Rows::Joined);
  std::vector<float> nearest(runs.size());
  if (gaze.memory) gaze.memory->start_cloud();
  const Cloud::Ptr crop(gaze.crop == Crop::Keep ? new Cloud : nullptr);
  const Counts counts = crop ? scan_and_crop(runs, corridor, gaze, nearest.data(), *crop)
                             : scan(runs, 0, runs.size(), corridor, gaze, nearest.data());
  Sight sight;
  sight.nearest = nearest_in(runs, nearest, counts, corridor, gaze);
  sight.inside = counts.inside;
  sight.too_close = counts.too_close;
  sight.returns = counts.returns;
  sight.total = size_of(view);
  if (gaze.memory) sight.lost = gaze.memory->near.lost;
  sight.crop = crop;
  return sight;
}

}  // namespace safety_control_cloud
