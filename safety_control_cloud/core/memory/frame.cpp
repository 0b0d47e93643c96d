// SPDX-License-Identifier: BSD-3-Clause
#include "frame.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double same = 0.25;   // [px]
constexpr double slack = 0.02;  // of a side, by which two pictures may end elsewhere and still show the same

/// One axis of a picture.
struct Side {
  const std::optional<RayLine>& line;
  std::size_t size;

  double last() const { return static_cast<double>(size) - 1.0; }
  bool shows(double slant, double beside = 0.0) const {
    const double pixel = line->pixel(slant);
    return pixel >= -0.5 - beside && pixel <= last() + 0.5 + beside;
  }
};

Side across(const Frame& frame) { return {frame.rays.across, frame.width}; }
Side down(const Frame& frame) { return {frame.rays.down, frame.height}; }

bool are_same(const Side& one, const Side& other) {
  if (one.size != other.size || one.line.has_value() != other.line.has_value()) return false;
  if (!one.line) return true;
  const auto is_same = [&](double pixel) { return std::abs(other.line->pixel(one.line->slant(pixel)) - pixel) < same; };
  return is_same(0.0) && is_same(one.last());
}

bool shows(const Side& from, const Side& to, double slant) {
  const double nearer = (1.0 + growth) * slant;
  const bool leaves = from.line && from.shows(nearer) && !to.shows(nearer, slack * static_cast<double>(to.size));
  return to.shows(slant) && !leaves;
}

/// Where a spot lies along one side.
struct Position {
  std::uint16_t at;
  bool shown;
};

Position placed_along(const Side& from, const Side& to, double slant, const Position& before) {
  const double scale = static_cast<double>(to.size) / static_cast<double>(std::max<std::size_t>(1, from.size));
  const double pixel = to.line ? to.line->pixel(slant) + 0.5 : (before.at + 0.5) * scale;
  const bool shown = to.line ? shows(from, to, slant) : before.shown && !from.line;
  return {static_cast<std::uint16_t>(std::clamp(pixel, 0.0, to.last())), shown};
}

std::optional<double> angle_of(const Frame& frame) {
  const auto& [across, down] = frame.rays;
  if (!across || !down) return std::nullopt;
  return std::abs(across->slope * down->slope) * static_cast<double>(frame.width * frame.width);
}

}  // namespace

bool Frame::operator==(const Frame& other) const {
  return are_same(across(*this), across(other)) && are_same(down(*this), down(other));
}

double share_of_angle(const Frame& one, const Frame& other) {
  const auto part = angle_of(one), whole = angle_of(other);
  return part && whole ? *part / *whole : 1.0;
}

void place(Spot& spot, const Frame& from, const Frame& to) {
  const double x = double{spot.point.x} / spot.point.z, y = double{spot.point.y} / spot.point.z;
  const auto column = placed_along(across(from), across(to), x, {spot.column, spot.column_shown});
  const auto row = placed_along(down(from), down(to), y, {spot.row, spot.row_shown});
  spot.column = column.at, spot.column_shown = column.shown;
  spot.row = row.at, spot.row_shown = row.shown;
}

}  // namespace safety_control_cloud
