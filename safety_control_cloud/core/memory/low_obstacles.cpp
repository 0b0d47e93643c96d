// SPDX-License-Identifier: BSD-3-Clause
#include "low_obstacles.hpp"

#include <algorithm>
#include <utility>

#include "adjacent.hpp"
#include "../input/point_reader.hpp"

namespace safety_control_cloud {
namespace {

/// What is lower, a robot climbs [mm]: a Kobuki 12, and noise is not to stop it.
constexpr std::int16_t step_height = 25;

/// By which the floor may lie higher than it did and still be the floor [mm]: at 0.7 m, a pitch of 1.2 degrees.
constexpr std::int16_t floor_tolerance = 15;

/// A post of 2 cm at 0.7 m, where an Xtion loses the floor, takes 1/40 of its 60 degrees.
constexpr std::size_t post_share_of_width = 40;

/// As many rows show every step: of one of 30 mm at 0.7 m whose top is not seen, what counts takes 1/120 of the height.
constexpr std::size_t rows_of_survey = 240;

/// Behind as many of these rows without near ground is none: a step is not higher, even if its front does not return.
constexpr std::size_t longest_gap = rows_of_survey / 6;

/// Deeper than any near ground [mm below the camera]: there is none.
constexpr std::int16_t none = PixelMemory::elsewhere - PixelMemory::ground_zero;

/// What a pixel shows of the near ground now.
std::int16_t ground_now(std::uint16_t pixel) {
  constexpr std::uint16_t zero = PixelMemory::now | PixelMemory::ground_zero;
  const auto below = static_cast<std::uint16_t>(pixel - zero);  // what is less wraps
  return static_cast<std::int16_t>(std::min<std::uint16_t>(below, none));
}

bool is_on_step(std::int16_t ground, std::int16_t floor) {
  return ground <= static_cast<std::int16_t>(floor - step_height);
}

/// The point of a pixel, in the corridor's axes.
Point point_at(const View& view, std::size_t row, std::size_t column, const Gaze& gaze) {
  Point point;
  const auto take = [&](float x, float y, float z) { point = placed(x, y, z, gaze); };
  with_reader(view, [&](auto reader) { reader(row, column, take); });
  return point;
}

/// Of another resolution of the same picture; zero if there was none.
std::vector<std::int16_t> stretched(std::vector<std::int16_t> columns, std::size_t width) {
  if (columns.size() == width) return columns;
  std::vector<std::int16_t> all(width, 0);
  for (std::size_t i = 0; i < width && !columns.empty(); ++i) all[i] = columns[i * columns.size() / width];
  return all;
}

}  // namespace

std::optional<Loss> LowObstacles::judge(const PixelMemory& memory, const View& view, const Gaze& gaze) {
  survey(memory);
  const std::size_t post = std::max<std::size_t>(2, memory.width / post_share_of_width);
  if (!any_adjacent(post, memory.width, [this](std::size_t i) { return is_step(i); })) return std::nullopt;
  Loss loss;
  loss.cause = Cause::LowObstacle;
  loss.whole = any_adjacent(post, memory.width, [this](std::size_t i) { return hides_floor(i); });
  loss.reason = "something lower than the corridor stands on the near floor";
  for (const auto& [row, column] : pixels(memory)) {
    const Point point = point_at(view, row, column, gaze);
    if (!loss.obstacle || point.z < loss.obstacle->point.z) loss.obstacle = Obstacle{point};
  }
  return loss;
}

void LowObstacles::survey(const PixelMemory& memory) {
  floor_ = stretched(std::move(floor_), memory.width);
  lowest_.assign(memory.width, none);
  above_.assign(memory.width, 0);
  const std::size_t every = std::max<std::size_t>(1, memory.height / rows_of_survey);
  std::size_t gap = 0;
  bool begun = false;
  for (std::size_t rest = memory.height; rest > 0 && gap < longest_gap; rest -= std::min(rest, every)) {
    const bool shown = look_at_row(memory.row(rest - 1));
    begun = begun || shown;
    gap = begun && !shown ? gap + 1 : 0;
  }
  for (std::size_t i = 0; i < memory.width; ++i) {
    const bool step = above_[i] >= 2 && !memory.is_near_now(i);  // one pixel alone may be noise
    if (step) floor_[i] = std::max(floor_[i], lowest_[i]);  // nearer, the lowest pixel shows more and more of the step
    if (!step && !hides_floor(i)) floor_[i] = 0;
  }
}

/// Whether it shows any near ground.
bool LowObstacles::look_at_row(const std::uint16_t* pixels) {
  Millimetres nearest = none, *lowest = lowest_.data();
  std::int16_t* above = above_.data();
  for (std::size_t i = 0, width = lowest_.size(); i < width; ++i) {
    const Millimetres ground = ground_now(pixels[i]), floor = lowest[i] == none ? ground : lowest[i];
    lowest[i] = floor;
    above[i] = static_cast<std::int16_t>(above[i] + is_on_step(ground, floor));
    nearest = std::min(nearest, ground);
  }
  return nearest != none;
}

bool LowObstacles::hides_floor(std::size_t column) const {
  if (!is_step(column)) return false;
  if (lowest_[column] == none) return true;  // nothing says that the floor is there again
  return lowest_[column] + floor_tolerance < floor_[column];
}

std::vector<LowObstacles::Pixel> LowObstacles::pixels(const PixelMemory& memory) const {
  std::vector<Pixel> found;
  for (std::size_t i = 0; i < memory.width; ++i) {
    std::size_t row = is_step(i) ? memory.height : 0;
    while (row > 0 && !is_on_step(ground_now(memory.row(row - 1)[i]), floor_[i])) --row;
    if (row > 0) found.push_back({row - 1, i});
  }
  return found;
}

}  // namespace safety_control_cloud
