// SPDX-License-Identifier: BSD-3-Clause
#include "passthrough.hpp"

#include <pcl/common/common.h>
#include <pcl/common/io.h>
#include <pcl/filters/passthrough.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "../input/to_cloud.hpp"
#include "meaning.hpp"
#include "nearest.hpp"

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
Cloud::Ptr placed_cloud(const Cloud& cloud, const Outlook& outlook) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Cloud::Ptr points(new Cloud(cloud));
  for (Point& point : *points) {
    const auto [x, y, z] = std::tie(point.x, point.y, point.z);
    point = is_return(x, y, z, outlook.corridor) ? outlook.placed(x, y, z) : Point(nan, nan, nan);
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

std::vector<float> nearest_in_rows(const Cloud& cloud, const Indices& inside) {
  std::vector<float> nearest(cloud.width == 0 ? 0 : cloud.height, std::numeric_limits<float>::infinity());
  for (const auto i : inside) {
    float& of_row = nearest[static_cast<std::size_t>(i) / cloud.width];
    of_row = std::min(of_row, cloud.points[static_cast<std::size_t>(i)].z);
  }
  return nearest;
}

}  // namespace

Sight passthrough(const View& view, const Outlook& outlook, Crop crop, Rows rows) {
  const Corridor& corridor = outlook.corridor;
  const Cloud::Ptr cloud(new Cloud(to_cloud(view)));
  const Cloud::Ptr points = placed_cloud(*cloud, outlook);
  const auto returns = passed(cloud, nullptr, "z", std::nextafter(corridor.range_min, largest), largest);
  const auto ahead = passed(points, returns, "z", std::numeric_limits<float>::denorm_min(), largest);
  const auto between_heights = passed(points, ahead, "y", corridor.y_min, corridor.y_max);
  const auto inside = passed(points, between_heights, "x", corridor.x_min, corridor.x_max);

  Sight sight;
  sight.total = size_of(view);
  sight.too_close = static_cast<std::size_t>(std::count_if(cloud->begin(), cloud->end(), [&](const Point& point) {
    return is_too_close(point.x, point.y, point.z, outlook);
  }));
  sight.returns = returns->size();
  sight.inside = inside->size();
  const Cloud::Ptr obstacles = picked(*points, *inside);
  sight.nearest = corridor.min_points == 1 && sight.too_close == 0
                      ? nearest_in(*obstacles)
                      : nearest_of(sight.too_close, *obstacles, corridor.min_points);
  if (rows == Rows::Apart) sight.nearest_in_rows = nearest_in_rows(*points, *inside);
  if (crop == Crop::Keep) sight.crop = picked(*cloud, *inside);
  return sight;
}

}  // namespace safety_control_cloud
