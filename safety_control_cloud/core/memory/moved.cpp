// SPDX-License-Identifier: BSD-3-Clause
#include "moved.hpp"

#include <algorithm>
#include <limits>

namespace safety_control_cloud {
namespace {

/// Of its size a hole is at least so large: a part of it may hide what was not known.
constexpr double least_share = 0.25;
/// So far around what is lost it may have swung while a part of it still hides its old place [m].
constexpr double swing = 0.02;

}  // namespace

std::vector<Spot> Moved::spots_in(const std::vector<Backdrop::Place>& hidden, std::size_t pixels_each,
                                  std::size_t width) const {
  const double pixel = double{from.point.z} / static_cast<double>(width);
  const double each = pixel * pixel * static_cast<double>(pixels_each);
  if (static_cast<double>(hidden.size()) * each < least_share * size) return {};
  const std::size_t step = 1 + hidden.size() / most_lost;
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < hidden.size(); i += step) {
    const auto& [row, column, right, down] = hidden[i];
    Spot spot = from;
    spot.row = static_cast<std::uint16_t>(row), spot.column = static_cast<std::uint16_t>(column);
    spot.point = Point(right * from.point.z, down * from.point.z, from.point.z);
    spot.share = static_cast<float>(each * static_cast<double>(step));
    spot.company = Backdrop::dense;
    spot.seen_past = 0;
    spot.picture = 0;
    spot.foot_unseen = spot.hung_before = false;
    spots.push_back(spot);
  }
  return spots;
}

std::optional<Spot> nearest_hanging(const std::vector<Spot>& spots) {
  std::optional<Spot> nearest;
  for (const Spot& spot : spots)
    if (!spot.stands && (!nearest || spot.point.z < nearest->point.z)) nearest = spot;
  return nearest;
}

Backdrop::Part part_around(const std::vector<Spot>& spots, std::size_t width) {
  constexpr double most = std::numeric_limits<double>::infinity();
  Backdrop::Part part{most, -most, most, -most};
  double nearest = most;
  for (const Spot& spot : spots) {
    const double row = spot.row, column = spot.column;
    part.first_row = std::min(part.first_row, row), part.last_row = std::max(part.last_row, row);
    part.first_column = std::min(part.first_column, column), part.last_column = std::max(part.last_column, column);
    nearest = std::min(nearest, double{spot.point.z});
  }
  const double around = swing / nearest * static_cast<double>(width);
  part.first_row -= around, part.last_row += around, part.first_column -= around, part.last_column += around;
  return part;
}

}  // namespace safety_control_cloud
