// SPDX-License-Identifier: BSD-3-Clause
#include "optics.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// Of the picture's pixels, or of 160 across where it has more, so that noise aside from a ray is none of the lens.
constexpr double same = 0.75, coarse = 160.0;
constexpr std::ptrdiff_t fewest = 4;  ///< probes to tell anything by

double pixels_between(float one, float other, const std::optional<RayLine>& line) {
  return line ? std::abs((double{one} - double{other}) / line->slope) : 0.0;
}

}  // namespace

Optics::Probes Optics::probes_of(const Pixels& picture) {
  Probes probes;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const std::size_t row = (2 * (i / across) + 1) * picture.height() / (2 * down);
    const std::size_t column = (2 * (i % across) + 1) * picture.width() / (2 * across);
    const Point point = picture.at(row, column);
    probes[i] = {point.x / point.z, point.y / point.z};
  }
  return probes;
}

/// By most of them: some may be set by hand, or noise.
bool Optics::look_elsewhere(const Probes& now) const {
  const double tolerance = same * std::max(1.0, static_cast<double>(width_) / coarse);
  std::ptrdiff_t compared = 0, elsewhere = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (std::isnan(now[i].x) || std::isnan(known_[i].x)) continue;
    ++compared;
    elsewhere += pixels_between(now[i].x, known_[i].x, lines_.across) > tolerance ||
                 pixels_between(now[i].y, known_[i].y, lines_.down) > tolerance;
  }
  return compared >= fewest && 2 * elsewhere > compared;
}

const RayLines& Optics::look_at(const View& view, const Pixels& picture) {
  if (std::holds_alternative<DepthView>(view)) {
    width_ = height_ = 0;
    return lines_ = ray_lines_of(view);
  }
  const Probes now = probes_of(picture);
  if (picture.width() != width_ || picture.height() != height_ || look_elsewhere(now)) {
    width_ = picture.width(), height_ = picture.height();
    known_ = now;
    lines_ = RayLines{};
  }
  if (!lines_.across || !lines_.down) {
    const RayLines fitted = ray_lines_of(view);
    if (!lines_.across) lines_.across = fitted.across;
    if (!lines_.down) lines_.down = fitted.down;
  }
  for (std::size_t i = 0; i < now.size(); ++i) known_[i] = std::isnan(known_[i].x) ? now[i] : known_[i];
  return lines_;
}

}  // namespace safety_control_cloud
