// SPDX-License-Identifier: BSD-3-Clause
#include "low_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "adjacent.hpp"

namespace safety_control_cloud {
namespace {

/// By which the floor may lie higher than it did and still be the floor [mm]: at 0.7 m, a pitch of 1.2 degrees.
constexpr std::int16_t floor_tolerance = 15;

/// A post of 2 cm at 0.7 m, where an Xtion loses the floor, takes 1/40 of its 60 degrees.
constexpr std::size_t post_share_of_width = 40;

/// Of the picture's height: two pictures that end so close together show the same floor.
constexpr double border_share = 0.01;

/// Of another resolution of the same picture; zero if there was none.
std::vector<std::int16_t> stretched(std::vector<std::int16_t> columns, std::size_t width) {
  if (columns.size() == width) return columns;
  std::vector<std::int16_t> all(width, 0);
  for (std::size_t i = 0; i < width && !columns.empty(); ++i) all[i] = columns[i * columns.size() / width];
  return all;
}

std::size_t columns_of(const Frame& frame) {
  const std::size_t step = NearGround::column_step_of(frame.width);
  return (frame.width + step - 1) / step;
}

/// Two pictures may show the same floor so many rows apart.
constexpr StepColumns::Row same_row = 1;
/// No picture shows the floor as low as that.
constexpr double below_all = -1.0 - same_row;

/// What a column shows lowest, in the corridor's axes.
struct Lowest {
  Point place;
  StepColumns::Row row;
};

/// If that lies elsewhere than near and in the corridor.
std::optional<Lowest> lowest_elsewhere(std::size_t column, const NearGround& ground, const Pixels& picture,
                                       const Outlook& outlook) {
  std::size_t row = 0;
  while (row < ground.rows() && ground.row(row)[column] == NearGround::nothing) ++row;
  if (row == ground.rows() || ground.row(row)[column] != NearGround::elsewhere) return std::nullopt;
  return Lowest{placed(picture.at(ground.picture_row(row), ground.picture_column(column)), outlook),
                static_cast<StepColumns::Row>(row)};
}

/// Of a column, in pixels of the picture.
double middle_of(std::size_t column, const Frame& frame) {
  return static_cast<double>(column * NearGround::column_step_of(frame.width));
}

/// y/z at the picture's lower border; NaN if it is not known.
double lowest_in(const Frame& frame) {
  if (!frame.rays.down) return std::numeric_limits<double>::quiet_NaN();
  return frame.rays.down->slant(static_cast<double>(frame.height) - 0.5);
}

}  // namespace

std::optional<Loss> LowObstacles::judge(const NearGround& ground, const Pixels& picture, const Outlook& outlook,
                                        const Patience& patience, float nearer) {
  if (nearer > 0.0f) let_come(nearer, ground, outlook);
  survey(ground, picture, outlook);
  forget_old(patience);
  if (std::exchange(is_corridor_new_, false)) drop_what_lies_beside(ground, picture, outlook);
  const auto any_post = [&](auto fulfils) { return any_adjacent(post_share_of_width, ground.columns(), fulfils); };
  if (beside_.empty() && !any_post([this](std::size_t i) { return is_step(i); })) return std::nullopt;
  const bool whole = !beside_.empty() || any_post([this](std::size_t i) { return hides_floor(i); });
  return Loss{Cause::LowObstacle, nearest(ground, picture, outlook), whole,
              "something lower than the corridor stands on the near floor"};
}

void LowObstacles::move_to(const Frame& frame) {
  if (frame == frame_) return;
  const std::vector<Beside> steps = all_steps();
  const std::size_t columns = columns_of(frame);
  floor_ = stretched(frame_.rays.across ? std::vector<Millimetres>{} : std::move(floor_), columns);
  beside_.clear();
  steps_.clear();
  frame_ = frame;
  for (const Beside& step : steps) {
    if (!shows(step)) beside_.push_back(step);
    for (std::size_t i = 0; i < columns && shows(step); ++i) {
      const double x = frame.rays.across->slant(middle_of(i, frame));
      if (x >= step.from && x < step.to) floor_[i] = std::max(floor_[i], step.floor);
    }
  }
}

void LowObstacles::move_to(float camera_height, float off) {
  off_ = static_cast<Millimetres>(std::lround(1000.0f * off));
  if (!camera_height_) camera_height_ = camera_height;
  const auto up = static_cast<int>(std::lround(1000.0f * (camera_height - *camera_height_)));  // [mm]
  if (up == 0) return;
  steps_.clear();
  *camera_height_ += static_cast<float>(up) / 1000.0f;  // what is left counts with the next
  const auto moved = [=](Millimetres floor) {
    return static_cast<Millimetres>(std::clamp(floor + up, 1, StepColumns::none - 1));
  };
  for (Millimetres& floor : floor_)
    if (floor > 0) floor = moved(floor);
  for (Beside& step : beside_) step.floor = moved(step.floor);
}

/// Those in the picture, if they are as wide as a post and its rays are known, and those beside it.
std::vector<LowObstacles::Beside> LowObstacles::all_steps() const {
  std::vector<Beside> steps = beside_;
  const auto& across = frame_.rays.across;
  const bool any = any_adjacent(post_share_of_width, floor_.size(), [this](std::size_t i) { return is_kept(i); });
  if (!across || !any) return steps;
  const double half = 0.5 * static_cast<double>(NearGround::column_step_of(frame_.width));
  for (std::size_t i = 0; i < floor_.size(); ++i) {
    if (!is_kept(i)) continue;
    const double middle = middle_of(i, frame_);
    const auto [from, to] = std::minmax({across->slant(middle - half), across->slant(middle + half)});
    const auto since = i < hidden_since_.size() ? std::optional(hidden_since_[i]) : std::nullopt;
    steps.push_back({from, to, lowest_in(frame_), floor_[i], since});
  }
  return steps;
}

bool LowObstacles::shows(const Beside& step) const {
  const auto& [across, down] = frame_.rays;
  if (!across) return false;
  const double column = across->pixel(0.5 * (step.from + step.to));
  if (column < -0.5 || column > static_cast<double>(frame_.width) - 0.5) return false;
  if (std::isnan(step.lowest)) return true;
  const double border = down ? border_share * std::abs(down->slope) * static_cast<double>(frame_.height) : 0.0;
  return lowest_in(frame_) >= step.lowest - border;
}

void LowObstacles::survey(const NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  note(ground, picture, outlook);
  look_beside(ground, picture, outlook);
  for (std::size_t i = 0; i < ground.columns(); ++i)
    if (shown_[i] == 0 && !hides_floor(i)) floor_[i] = 0;
}

/// Where it would be in the picture by now, that of all rows between is not known: the robot rolled on, and nobody
/// looked.
void LowObstacles::let_come(float nearer, const NearGround& ground, const Outlook& outlook) {
  const auto& down = frame_.rays.down;
  if (steps_.size() != ground.columns() || !down) return;
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    Step& step = steps_[i];
    if (!is_kept(i) || step.row == StepColumns::no_row) continue;
    Point by_now = step.at;
    by_now.z -= nearer;
    const Point seen = outlook.seen_from_camera(by_now);
    const double row = seen.z > 0.0f ? down->pixel(double{seen.y} / seen.z) : std::numeric_limits<double>::infinity();
    const double from_below =
        (static_cast<double>(ground.picture_row(0)) - row) / static_cast<double>(ground.row_step());
    const double number = std::floor(std::clamp(from_below, below_all, double{StepColumns::no_row}));
    step.came_to = std::min(step.came_to, static_cast<StepColumns::Row>(number));
  }
}

/// In a column that shows no near ground in the corridor, near ground beside it is as good: nothing hides it.
void LowObstacles::look_beside(const NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  const Point camera = outlook.camera();
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    if (!is_kept(i) || columns_.lowest(i) != StepColumns::none) continue;
    const auto lowest = lowest_elsewhere(i, ground, picture, outlook);
    if (!lowest || lowest->place.z - camera.z >= ground.distance() || lowest->place.y <= outlook.corridor.y_max)
      continue;
    const auto below = static_cast<Millimetres>(std::lround(1000.0f * (lowest->place.y - camera.y)));
    columns_.note_lowest(i, below, lowest->row);
  }
}

/// Nearer, the lowest pixel shows more and more of the step.
void LowObstacles::note(const NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  const std::size_t columns = ground.columns();
  floor_ = stretched(std::move(floor_), columns);
  if (steps_.size() != columns) steps_.assign(columns, Step{});
  shown_.assign(columns, 0);
  columns_.look_at(ground, floor_);
  for (std::size_t i = 0; i < columns; ++i) {
    if (!columns_.rises(i) || ground.is_near(i)) continue;
    const Millimetres lowest = columns_.lowest(i), of_two = columns_.lowest_of_two(i);
    shown_[i] = lowest == StepColumns::none ? floor_[i] : lowest;
    Step& step = steps_[i];
    step.came_to = StepColumns::no_row;
    if (of_two == StepColumns::none) continue;
    if (!is_kept(i)) step.row = StepColumns::no_row;
    floor_[i] = std::max(floor_[i], of_two);
    const StepColumns::Row row = columns_.first_above(i);
    step.row = std::min(step.row, row);
    step.at = placed(picture.at(ground.picture_row(static_cast<std::size_t>(row)), ground.picture_column(i)), outlook);
  }
}

void LowObstacles::forget_old(const Patience& patience) {
  if (hidden_since_.size() != floor_.size()) hidden_since_.assign(floor_.size(), patience.now);
  for (std::size_t i = 0; i < floor_.size(); ++i) {
    if (!hides_floor(i)) hidden_since_[i] = patience.now;
    if (patience.ends(hidden_since_[i])) floor_[i] = 0;
  }
  const auto is_old = [&](Beside& step) {
    if (!step.hidden_since) step.hidden_since = patience.now;
    return patience.ends(*step.hidden_since);
  };
  beside_.erase(std::remove_if(beside_.begin(), beside_.end(), is_old), beside_.end());
}

bool LowObstacles::hides_floor(std::size_t column) const {
  if (!is_kept(column)) return false;
  const Millimetres lowest = columns_.lowest_of_two(column);
  if (lowest == StepColumns::none) return true;  // nothing says that the floor is there again
  return lowest + floor_tolerance < floor_[column] + off_ || !is_as_low_as_step(column);
}

/// What two clouds show lowest.
bool LowObstacles::is_as_low_as_step(std::size_t column) const {
  const StepColumns::Row row = std::min(steps_[column].row, steps_[column].came_to);
  return row == StepColumns::no_row || columns_.lowest_row_of_two(column) <= row + same_row;
}

/// By what its column shows lowest.
void LowObstacles::drop_what_lies_beside(const NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    const auto lowest = lowest_elsewhere(i, ground, picture, outlook);
    if (lowest && !outlook.corridor.spans(lowest->place.x)) floor_[i] = 0;
  }
}

std::optional<Obstacle> LowObstacles::nearest(const NearGround& ground, const Pixels& picture,
                                              const Outlook& outlook) const {
  std::optional<Obstacle> found;
  for (std::size_t i = 0; i < ground.columns(); ++i) {
    const auto is_on_it = [&](std::size_t row) {
      return StepColumns::is_on_step(StepColumns::ground_now(ground.row(row)[i]), floor_before(i));
    };
    std::size_t row = is_step(i) ? 0 : ground.rows();
    while (row < ground.rows() && !is_on_it(row)) ++row;
    if (row == ground.rows()) continue;
    const Obstacle obstacle{placed(picture.at(ground.picture_row(row), ground.picture_column(i)), outlook)};
    if (!found || obstacle.distance() < found->distance()) found = obstacle;
  }
  return found;
}

}  // namespace safety_control_cloud
