// SPDX-License-Identifier: BSD-3-Clause
#include "field_of_view.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "ray_lines.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t fewest_pixels = 8;  ///< on a side of a picture
constexpr std::size_t fewest_rays = 12;   ///< to tell anything by
constexpr double tolerance = 0.08;        ///< of the picture's width or height by which a lens may bend a ray
constexpr double blur = 0.02;             ///< by which noise may
constexpr double beside = 0.25;           ///< of the width or height by which the optical axis may miss the picture
constexpr double most_misfits = 0.25;     ///< share of the rays: what was filtered, or set by hand

const char* const not_optical =
    "the points do not lie as a camera's that looks along z: x/z must grow with the column and y/z with the row (x "
    "right,"
    " y down, z forward)";
const char* const not_ahead = "straight ahead (x = 0, y = 0 along z) lies outside the picture";

/// One axis of a picture: x/z over the columns, or y/z over the rows.
struct Axis {
  double Ray::*pixel;
  double Ray::*slant;
  std::size_t size;  ///< [px]
};

bool is_wide(const RayLine& line, const Axis& axis, Sense sense) {
  const double width = line.slope * static_cast<double>(axis.size);
  return width > narrowest_picture || (sense == Sense::Either && width < -narrowest_picture);
}

bool fits(const Ray& ray, const RayLine& line, const Axis& axis) {
  const double off = std::abs(ray.*axis.slant - line.slant(ray.*axis.pixel));
  return off <= blur + tolerance * std::abs(line.slope) * static_cast<double>(axis.size);
}

std::pair<double, double> ends_of(const RayLine& line, const Axis& axis) {
  const double one = line.at_zero - 0.5 * line.slope;
  return std::minmax({one, one + line.slope * static_cast<double>(axis.size)});
}

/// Whether all rays are one: what a test or a broken driver fills a picture with tells nothing of its frame.
bool are_one(const RaySamples& samples) {
  const Ray* first = nullptr;
  for (const auto& rays : samples.in_row) {
    for (const Ray& ray : rays) {
      if (!first) first = &ray;
      if (std::abs(ray.x - first->x) + std::abs(ray.y - first->y) > blur) return false;
    }
  }
  return true;
}

bool holds_zero(const RayLine& line, const Axis& axis) {
  const auto [low, high] = ends_of(line, axis);
  return low <= beside * (high - low) && high >= -beside * (high - low);
}

}  // namespace

bool FieldOfView::holds(const Point& point) const {
  const double x = double{point.x} / point.z, y = double{point.y} / point.z;
  return point.z > 0.0f && x >= left && x <= right && y >= top && y <= bottom;
}

std::variant<FieldOfView, NotOptical> field_of(const View& view, Sense sense) {
  const Axis across{&Ray::column, &Ray::x, width_of(view)}, down{&Ray::row, &Ray::y, height_of(view)};
  if (across.size < fewest_pixels || down.size < 2) return FieldOfView{};
  const RaySamples samples(view);
  const std::size_t measured = samples.ahead + samples.behind;
  if (measured < fewest_rays) return FieldOfView{};
  if (static_cast<double>(samples.behind) > most_misfits * static_cast<double>(measured))
    return NotOptical{not_optical};
  if (are_one(samples)) return FieldOfView{};

  const RayLines lines = lines_along(samples, across.size, down.size);
  const auto &x = lines.across, &y = lines.down;
  const bool narrow = (x && !is_wide(*x, across, sense)) || (y && !is_wide(*y, down, sense));
  if (narrow) return NotOptical{not_optical};
  std::size_t misfits = samples.behind;
  for (const auto& rays : samples.in_row) {
    misfits += static_cast<std::size_t>(std::count_if(rays.begin(), rays.end(), [&](const Ray& ray) {
      return (x && !fits(ray, *x, across)) || (y && !fits(ray, *y, down));
    }));
  }
  if (static_cast<double>(misfits) > most_misfits * static_cast<double>(measured)) return NotOptical{not_optical};
  const bool aside = (x && !holds_zero(*x, across)) || (y && !holds_zero(*y, down));
  if (aside && sense == Sense::Optical) return NotOptical{not_ahead};

  FieldOfView field;
  if (x) std::tie(field.left, field.right) = ends_of(*x, across);
  if (y) std::tie(field.top, field.bottom) = ends_of(*y, down);
  return field;
}

double share_in_view(const Outlook& outlook, const FieldOfView& field, double from, double to) {
  constexpr int across = 5, down = 5, ahead = 4;
  const Corridor& corridor = outlook.corridor;
  const auto between = [](double low, double high, int i, int count) {
    return static_cast<float>(low + (high - low) * (i + 0.5) / count);
  };
  int seen = 0;
  for (int i = 0; i < across * down * ahead; ++i) {
    const Point point(between(corridor.x_min, corridor.x_max, i % across, across),
                      between(corridor.y_min, corridor.y_max, i / across % down, down),
                      between(from, to, i / across / down, ahead));
    seen += field.holds(outlook.seen_from_camera(point));
  }
  return static_cast<double>(seen) / (across * down * ahead);
}

}  // namespace safety_control_cloud
