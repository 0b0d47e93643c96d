// SPDX-License-Identifier: BSD-3-Clause
#include "passthrough.hpp"

#include <pcl/common/common.h>
#include <pcl/filters/passthrough.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace safety_control_cloud {
namespace {

/// The points with low <= axis <= high; those with a NaN or an infinity are dropped whatever the axis.
Cloud::Ptr passed(const Cloud::ConstPtr& cloud, const char* axis, float low, float high) {
  Cloud::Ptr kept(new Cloud);
  pcl::PassThrough<Point> filter;
  filter.setInputCloud(cloud);
  filter.setFilterFieldName(axis);
  filter.setFilterLimits(low, high);
  filter.filter(*kept);
  return kept;
}

/// getMinMax3D, asked only where there is a point: of an empty cloud it would say 3.4e38 m, which reads "Safe".
std::optional<Obstacle> nearest_in(const Cloud& inside) {
  if (inside.empty()) return std::nullopt;
  Point low, high;
  pcl::getMinMax3D(inside, low, high);
  return Obstacle{*std::find_if(inside.begin(), inside.end(), [&](const Point& point) { return point.z == low.z; })};
}

}  // namespace

Sight passthrough(const CloudView& view, const Corridor& corridor, Crop crop) {
  const Cloud::Ptr cloud(new Cloud(to_cloud(view)));
  const auto too_close = std::count_if(cloud->begin(), cloud->end(), [&](const Point& point) {
    return is_too_close(point.x, point.y, point.z, corridor);
  });
  constexpr float largest = std::numeric_limits<float>::max();
  const auto returns = passed(cloud, "z", std::nextafter(corridor.range_min, largest), largest);
  const auto between_heights = passed(returns, "y", corridor.y_min, corridor.y_max);
  const auto inside = passed(between_heights, "x", corridor.x_min, corridor.x_max);

  Sight sight;
  sight.total = view.size();
  sight.too_close = static_cast<std::size_t>(too_close);
  sight.returns = returns->size();
  sight.inside = inside->size();
  sight.nearest =
      corridor.min_points == 1 && too_close == 0 ? nearest_in(*inside) : nearest_of(sight.too_close, *inside, corridor);
  if (crop == Crop::Keep) sight.crop = inside;
  return sight;
}

}  // namespace safety_control_cloud
