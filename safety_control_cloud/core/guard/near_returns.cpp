// SPDX-License-Identifier: BSD-3-Clause
#include "near_returns.hpp"

#include <cstddef>

#include "../memory/pixels.hpp"

namespace safety_control_cloud {
namespace {

constexpr std::size_t columns = 107, rows = 80;  ///< of a picture that are looked at in each look, at most
constexpr std::size_t far_apart = 4;             ///< rows, between which something thin may be seen
constexpr std::size_t in_turn = 8;               ///< looks, in one of which the row midway between two is looked at too

std::size_t step_for(std::size_t size, std::size_t wanted) { return (size + wanted - 1) / wanted; }

}  // namespace

std::size_t rows_apart(std::size_t height) { return step_for(height, rows); }

std::size_t columns_apart(std::size_t width) { return step_for(width, columns); }

std::vector<std::size_t> rows_looked_at(std::size_t height, std::size_t number_of_look) {
  const std::size_t apart = rows_apart(height);
  std::vector<std::size_t> all;
  for (std::size_t row = 0; row < height; row += apart) {
    all.push_back(row);
    const std::size_t midway = row + apart / 2;
    const bool is_its_turn = (row / apart + number_of_look) % in_turn == 0;
    if (apart >= far_apart && is_its_turn && midway < height) all.push_back(midway);
  }
  return all;
}

std::vector<NearReturn> near_returns(const Look& look, const Vicinity& vicinity, const Pose2& pose,
                                     const Pose2& meanwhile) {
  const Pixels pixels(look.view, look.outlook.corridor.range_min);
  const bool is_scan = std::holds_alternative<ScanView>(look.reading);
  const std::size_t across = is_scan ? 1 : columns_apart(pixels.width());
  const bool moved = displacement(meanwhile, 1.0) > 0.0;
  Pose2 then = pose;
  Turn turn(pose.heading);
  std::vector<NearReturn> returns;
  PixelRow row;
  for (const std::size_t r : rows_looked_at(pixels.height(), look.number)) {
    pixels.read(r, across, look.outlook, row);
    for (std::size_t i = 0; i < row.z.size(); ++i) {
      const Point2 place{row.z[i], -row.x[i]};
      const float height = -row.y[i];
      if (!vicinity.holds(place, height)) continue;
      if (moved) {
        then = beyond(pose, shared(meanwhile, static_cast<double>(i) / static_cast<double>(row.z.size())));
        turn = Turn(then.heading);
      }
      returns.push_back({then.place + turn(place), height, length_of(place)});
    }
  }
  return returns;
}

}  // namespace safety_control_cloud
