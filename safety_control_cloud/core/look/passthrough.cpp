// SPDX-License-Identifier: BSD-3-Clause
#include "passthrough.hpp"

#include <pcl/common/common.h>
#include <pcl/common/io.h>
#include <pcl/filters/passthrough.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace safety_control_cloud {
namespace {

using Indices = pcl::IndicesPtr::element_type;  // PCL 1.10 has no other name for it

constexpr float largest = std::numeric_limits<float>::max();

/// Which of these points have low <= axis <= high; those with a NaN or an infinity are dropped whatever the axis.
pcl::IndicesPtr passed(const Cloud::ConstPtr& cloud, const pcl::IndicesPtr& among, const char* axis, float low,
                       float high) {
  pcl::IndicesPtr kept(new Indices);
  pcl::PassThrough<Point> filter;
  filter.setInputCloud(cloud);
  if (among) filter.setIndices(among);
  filter.setFilterFieldName(axis);
  filter.setFilterLimits(low, high);
  filter.filter(*kept);
  return kept;
}

Cloud::Ptr picked(const Cloud& cloud, const Indices& indices) {
  Cloud::Ptr points(new Cloud);
  pcl::copyPointCloud(cloud, indices, *points);
  return points;
}

/// The cloud in the corridor's axes; a point that is no return becomes NaN, because it has no place there.
Cloud::Ptr placed_cloud(const Cloud& cloud, const Corridor& corridor, const Gaze& gaze) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Cloud::Ptr points(new Cloud(cloud));
  for (Point& point : *points) {
    const auto [x, y, z] = std::tie(point.x, point.y, point.z);
    point = is_return(x, y, z, corridor) ? placed(x, y, z, gaze) : Point(nan, nan, nan);
  }
  return points;
}

/// getMinMax3D, asked only where there is a point: of an empty cloud it would say 3.4e38 m, which reads "Safe".
std::optional<Obstacle> nearest_in(const Cloud& inside) {
  if (inside.empty()) return std::nullopt;
  Point low, high;
  pcl::getMinMax3D(inside, low, high);
  return Obstacle{*std::find_if(inside.begin(), inside.end(), [&](const Point& point) { return point.z == low.z; })};
}

void remember(const Cloud& cloud, const Cloud& placed, const Corridor& corridor, const Gaze& gaze) {
  PixelMemory& memory = *gaze.memory;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    std::uint16_t& pixel = memory.pixels[i];
    const Point& point = cloud.points[i];
    // Whether or not its place is too far for a float.
    const bool returned = is_return(point.x, point.y, point.z, corridor);
    if (returned) pixel = remembered(placed.points[i], corridor, gaze);
    const std::uint16_t code = PixelMemory::code_of(pixel);
    pixel = static_cast<std::uint16_t>(returned ? code | PixelMemory::now : code);
  }
  memory.start_cloud();
  memory.note(0, memory.pixels.size());
}

}  // namespace

Sight passthrough(const View& view, const Corridor& corridor, const Gaze& gaze) {
  const Cloud::Ptr cloud(new Cloud(to_cloud(view)));
  const Cloud::Ptr points = placed_cloud(*cloud, corridor, gaze);
  const auto returns = passed(cloud, nullptr, "z", std::nextafter(corridor.range_min, largest), largest);
  const auto ahead = passed(points, returns, "z", std::numeric_limits<float>::denorm_min(), largest);
  const auto between_heights = passed(points, ahead, "y", corridor.y_min, corridor.y_max);
  const auto inside = passed(points, between_heights, "x", corridor.x_min, corridor.x_max);

  Sight sight;
  sight.total = size_of(view);
  sight.too_close = static_cast<std::size_t>(std::count_if(cloud->begin(), cloud->end(), [&](const Point& point) {
    return is_too_close(point.x, point.y, point.z, corridor, gaze);
  }));
  sight.returns = returns->size();
  sight.inside = inside->size();
  const Cloud::Ptr obstacles = picked(*points, *inside);
  sight.nearest = corridor.min_points == 1 && sight.too_close == 0 ? nearest_in(*obstacles)
                                                                   : nearest_of(sight.too_close, *obstacles, corridor);
  if (gaze.memory) {
    remember(*cloud, *points, corridor, gaze);
    sight.lost = gaze.memory->near.lost;
  }
  if (gaze.crop == Crop::Keep) sight.crop = picked(*cloud, *inside);
  return sight;
}

}  // namespace safety_control_cloud
