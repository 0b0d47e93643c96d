// SPDX-License-Identifier: BSD-3-Clause
#include "tutorial.hpp"

#include <pcl/common/common.h>
#include <pcl/filters/passthrough.h>
#include <pcl_conversions/pcl_conversions.h>

namespace safety_control_cloud {
namespace {

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

constexpr float x_min = -0.30f, x_max = 0.30f, y_min = -0.25f, y_max = 0.20f;  // [m]

}  // namespace

Seen tutorial(const sensor_msgs::PointCloud2& message) {
  const Cloud::Ptr cloud(new Cloud), between_heights(new Cloud), inside(new Cloud);
  pcl::fromROSMsg(message, *cloud);

  pcl::PassThrough<Point> filter;
  filter.setInputCloud(cloud);
  filter.setFilterFieldName("y");
  filter.setFilterLimits(y_min, y_max);
  filter.filter(*between_heights);
  filter.setInputCloud(between_heights);
  filter.setFilterFieldName("x");
  filter.setFilterLimits(x_min, x_max);
  filter.filter(*inside);

  Point low, high;
  pcl::getMinMax3D(*inside, low, high);
  Seen seen;
  seen.nearest = low.z;
  pcl::toROSMsg(*inside, seen.crop);
  return seen;
}

float pcl_with_indices(const sensor_msgs::PointCloud2& message) {
  const Cloud::Ptr cloud(new Cloud);
  pcl::fromROSMsg(message, *cloud);

  const pcl::IndicesPtr between_heights(new pcl::Indices);
  pcl::Indices inside;
  pcl::PassThrough<Point> filter;
  filter.setInputCloud(cloud);
  filter.setFilterFieldName("y");
  filter.setFilterLimits(y_min, y_max);
  filter.filter(*between_heights);
  filter.setIndices(between_heights);
  filter.setFilterFieldName("x");
  filter.setFilterLimits(x_min, x_max);
  filter.filter(inside);

  Eigen::Vector4f low, high;
  pcl::getMinMax3D(*cloud, inside, low, high);
  return low.z();
}

}  // namespace safety_control_cloud
