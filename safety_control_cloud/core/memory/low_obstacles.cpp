// SPDX-License-Identifier: BSD-3-Clause
#include "low_obstacles.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "adjacent.hpp"

namespace safety_control_cloud {
namespace {

/// What is lower, a robot climbs [mm]: a Kobuki 12, and noise is not to stop it.
constexpr std::int16_t step_height = 25;

/// By which the floor may lie higher than it did and still be the floor [mm]: at 0.7 m, a pitch of 1.2 degrees.
constexpr std::int16_t floor_tolerance = 15;

/// A post of 2 cm at 0.7 m, where an Xtion loses the floor, takes 1/40 of its 60 degrees.
constexpr std::size_t post_share_of_width = 40;

/// Deeper than any near ground [mm below the camera]: there is none.
constexpr NearGround::Code none = std::numeric_limits<NearGround::Code>::max();

NearGround::Code ground_now(NearGround::Code code) { return code < 0 ? none : code; }

bool is_on_step(std::int16_t ground, std::int16_t floor) { return ground <= floor - step_height; }

/// Of another resolution of the same picture; zero if there was none.
std::vector<std::int16_t> stretched(std::vector<std::int16_t> columns, std::size_t width) {
  if (columns.size() == width) return columns;
  std::vector<std::int16_t> all(width, 0);
  for (std::size_t i = 0; i < width && !columns.empty(); ++i) all[i] = columns[i * columns.size() / width];
  return all;
}

}  // namespace

std::optional<Loss> LowObstacles::judge(const NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  survey(ground);
  if (std::exchange(is_corridor_new_, false)) drop_what_lies_beside(ground, picture, outlook);
  const auto any_post = [&](auto fulfils) { return any_adjacent(post_share_of_width, ground.columns(), fulfils); };
  if (!any_post([this](std::size_t i) { return is_step(i); })) return std::nullopt;
  const bool whole = any_post([this](std::size_t i) { return hides_floor(i); });
  return Loss{Cause::LowObstacle, nearest(ground, picture, outlook), whole,
              "something lower than the corridor stands on the near floor"};
}

void LowObstacles::survey(const NearGround& ground) {
  floor_ = stretched(std::move(floor_), ground.columns());
  lowest_.assign(ground.columns(), none);
  above_.assign(ground.columns(), 0);
  for (std::size_t row = 0; row < ground.rows(); ++row) {
    if (ground.shows_ground(row)) look_at_row(ground.row(row));  // all others change nothing
  }
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    const bool step = above_[i] >= 2 && !ground.is_near(i);  // one pixel alone may be noise
    if (step) floor_[i] = std::max(floor_[i], lowest_[i]);   // nearer, the lowest pixel shows more and more of the step
    if (!step && !hides_floor(i)) floor_[i] = 0;
  }
}

/// A step that is kept goes on as one while its foot leaves the picture: what is left of it need be no step by itself.
void LowObstacles::look_at_row(const Millimetres* codes) {
  Millimetres *lowest = lowest_.data(), *above = above_.data();
  const Millimetres* const kept = floor_.data();
  for (std::size_t i = 0, width = lowest_.size(); i < width; ++i) {
    const Millimetres ground = ground_now(codes[i]);
    lowest[i] = lowest[i] == none ? ground : lowest[i];
    above[i] = static_cast<Millimetres>(above[i] + is_on_step(ground, std::max(lowest[i], kept[i])));
  }
}

bool LowObstacles::hides_floor(std::size_t column) const {
  if (!is_step(column)) return false;
  if (lowest_[column] == none) return true;  // nothing says that the floor is there again
  return lowest_[column] + floor_tolerance < floor_[column];
}

/// By what its column shows lowest.
void LowObstacles::drop_what_lies_beside(const NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    std::size_t row = 0;
    while (row < ground.rows() && ground.row(row)[i] == NearGround::nothing) ++row;
    if (row == ground.rows() || ground.row(row)[i] != NearGround::elsewhere) continue;
    const Point place = placed(picture.at(ground.picture_row(row), ground.picture_column(i)), outlook);
    if (place.x < outlook.corridor.x_min || place.x > outlook.corridor.x_max) floor_[i] = 0;
  }
}

std::optional<Obstacle> LowObstacles::nearest(const NearGround& ground, const Pixels& picture,
                                              const Outlook& outlook) const {
  std::optional<Obstacle> found;
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    std::size_t row = is_step(i) ? 0 : ground.rows();
    while (row < ground.rows() && !is_on_step(ground_now(ground.row(row)[i]), floor_[i])) ++row;
    if (row == ground.rows()) continue;
    const Obstacle obstacle{placed(picture.at(ground.picture_row(row), ground.picture_column(i)), outlook)};
    if (!found || obstacle.distance() < found->distance()) found = obstacle;
  }
  return found;
}

}  // namespace safety_control_cloud
