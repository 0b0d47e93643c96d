// SPDX-License-Identifier: BSD-3-Clause
#include "ray_lines.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace safety_control_cloud {
namespace {

constexpr std::size_t fewest_pixels = 8;  ///< on a side of a picture
constexpr std::size_t fewest_slopes = 6;  ///< to tell anything by
constexpr std::size_t thinnest = 12;      ///< times as wide as high: of a strip's few rows nothing is known

/// One axis of a picture: x/z over the columns, or y/z over the rows.
struct Axis {
  double Ray::*pixel;
  double Ray::*slant;
  std::size_t size;  ///< [px]
};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Between rays half of their line of pixels apart, so that noise hardly counts.
template <class Lines>
std::vector<double> slopes_in(const Lines& lines, const Axis& axis) {
  std::vector<double> slopes;
  slopes.reserve(RaySamples::rows * RaySamples::columns);
  for (const auto& rays : lines) {
    for (std::size_t i = 0, half = rays.size() / 2; half > 0 && i + half < rays.size(); ++i) {
      const Ray &one = rays[i], &other = rays[i + half];
      slopes.push_back((other.*axis.slant - one.*axis.slant) / (other.*axis.pixel - one.*axis.pixel));
    }
  }
  return slopes;
}

template <class Lines>
std::optional<RayLine> line_along(const Lines& lines, const Axis& axis) {
  std::vector<double> slopes = slopes_in(lines, axis), offsets;
  if (axis.size < fewest_pixels || slopes.size() < fewest_slopes) return std::nullopt;
  const double slope = median(slopes);
  offsets.reserve(RaySamples::rows * RaySamples::columns);
  for (const auto& rays : lines) {
    for (const Ray& ray : rays) offsets.push_back(ray.*axis.slant - slope * ray.*axis.pixel);
  }
  return RayLine{median(offsets), slope};
}

/// What looks one way all over, as a broken driver's picture, tells nothing.
std::optional<RayLine> wide(const std::optional<RayLine>& line, std::size_t size) {
  const bool is_wide = line && std::abs(line->slope) * static_cast<double>(size) > narrowest_picture;
  return is_wide ? line : std::nullopt;
}

RayLines lines_of(const CloudView& cloud) {
  if (cloud.width < 2 || cloud.height < 2) return {};
  const RayLines lines = lines_along(RaySamples(cloud), cloud.width, cloud.height);
  return {wide(lines.across, cloud.width), wide(lines.down, cloud.height)};
}

RayLines lines_of(const DepthView& image) {
  const auto line = [](std::size_t first, double middle, double focal) -> std::optional<RayLine> {
    if (!(focal > 0.0)) return std::nullopt;
    return RayLine{(static_cast<double>(first) - middle) / focal, 1.0 / focal};
  };
  return {line(image.first_column, image.camera.cx, image.camera.fx),
          line(image.first_row, image.camera.cy, image.camera.fy)};
}

}  // namespace

RayLines lines_along(const RaySamples& samples, std::size_t width, std::size_t height) {
  RayLines lines;
  lines.across = line_along(samples.in_row, Axis{&Ray::column, &Ray::x, width});
  if (height * thinnest >= width) lines.down = line_along(samples.in_column, Axis{&Ray::row, &Ray::y, height});
  return lines;
}

RayLines ray_lines_of(const View& view) {
  return std::visit([](const auto& points) { return lines_of(points); }, view);
}

}  // namespace safety_control_cloud
