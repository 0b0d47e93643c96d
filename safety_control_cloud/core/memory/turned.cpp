// SPDX-License-Identifier: BSD-3-Clause
#include "turned.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double least_ahead = 0.05;  // [m] of the camera: nearer, directions mean nothing
/// By how much the camera may be rolled against how it was for a column to show what stood below a spot, and tilted for
/// that to have stood there: what ends with the picture counts as standing, though it may hang right below that.
constexpr float level = 0.05f, as_low = 0.0175f;
/// One in so many pixels is asked, of a picture that is `coarse` pixels wide: around each one, so many tell.
constexpr double asked = 3.0, coarse = 160.0;

/// Where something lies in the picture [px].
struct Position {
  double row, column;
};

bool are_known(const RayLines& rays) { return rays.across && rays.down; }

class Turning {
 public:
  Turning(const Gaze& gaze, const Pixels& picture) : gaze_(gaze), picture_(picture) {}

  std::optional<Position> position_of(const Point& place) const {
    const Point seen = gaze_.outlook.seen_from_camera(place);
    if (!(seen.z > least_ahead)) return std::nullopt;
    return Position{gaze_.rays.down->pixel(double{seen.y} / seen.z), gaze_.rays.across->pixel(double{seen.x} / seen.z)};
  }

  bool is_shown(const Position& at, const Position& off) const {
    return at.row - off.row >= 0.0 && at.row + off.row <= last_row() && at.column - off.column >= 0.0 &&
           at.column + off.column <= last_column();
  }

  /// [px] that an angle takes there.
  Position pixels_of(double angle, const Position& at) const {
    const auto pixels = [=](const RayLine& line, double pixel) {
      const double slant = line.slant(pixel);
      return angle * (1.0 + slant * slant) / std::abs(line.slope);
    };
    return {pixels(*gaze_.rays.down, at.row), pixels(*gaze_.rays.across, at.column)};
  }

  /// As far as they lie in the picture.
  void add_around(const Position& at, const Position& off, std::vector<TurnedSpot::Place>& places) const {
    add(at, places);
    const int across = steps_of(off.column), down = steps_of(off.row);
    for (int i = 1; i <= across; ++i)
      for (const int side : {-i, i}) add({at.row, at.column + off.column * side / across}, places);
    for (int i = 1; i <= down; ++i)
      for (const int side : {-i, i}) add({at.row + off.row * side / down, at.column}, places);
  }

  double rows_beyond(const Position& at) const { return std::max({0.0, -at.row, at.row - last_row()}); }

  int steps_of(double pixels) const { return static_cast<int>(std::ceil(std::abs(pixels) / step_)); }

 private:
  double last_row() const { return static_cast<double>(picture_.height()) - 1.0; }
  double last_column() const { return static_cast<double>(picture_.width()) - 1.0; }

  void add(const Position& at, std::vector<TurnedSpot::Place>& places) const {
    if (is_shown(at, {0.0, 0.0}))
      places.push_back(
          {static_cast<std::size_t>(std::lround(at.row)), static_cast<std::size_t>(std::lround(at.column))});
  }

  const Gaze& gaze_;
  const Pixels& picture_;
  const double step_ = asked * std::max(1.0, static_cast<double>(picture_.width()) / coarse);  // [px]
};

Spot moved_to(const Spot& spot, const TurnedSpot::Place& place) {
  Spot moved = spot;
  moved.row = static_cast<std::uint16_t>(place.row), moved.column = static_cast<std::uint16_t>(place.column);
  return moved;
}

/// Whether nothing is seen there that is not behind it, and as much returns as did around the spot, but for half.
bool shows_what_is_behind(const Spot& spot, const TurnedSpot::Place& place, const Pixels& picture) {
  const float farthest = spot.point.z + noise_at(spot.point.z);
  int behind = 0;
  for (const float z : picture.around(place.row, place.column)) {
    if (z <= farthest) return false;
    behind += z > farthest;
  }
  return 2 * behind >= spot.company;
}

}  // namespace

std::optional<TurnedSpot> turned_spot(const Spot& spot, const Gaze& gaze, const Pixels& picture, float turning) {
  if (!are_known(gaze.rays)) return std::nullopt;
  const Turning to(gaze, picture);
  const Point place = spot.place();
  const auto at = to.position_of(place);
  if (!at) return std::nullopt;
  if (!to.is_shown(*at, {0.0, 0.0})) return std::nullopt;
  const Position off = to.pixels_of(std::max(least_off, double{spot.turning} + double{turning}), *at);
  TurnedSpot turned{spot, {}, to.is_shown(*at, off)};
  turned.spot.point = gaze.outlook.seen_from_camera(place);
  turned.spot.row = static_cast<std::uint16_t>(std::lround(at->row));
  turned.spot.column = static_cast<std::uint16_t>(std::lround(at->column));
  turned.spot.row_shown = turned.spot.column_shown = true;
  const auto is_as_before = [&](const auto& direction, float by) {
    return std::abs(direction(spot.camera)[1] - direction(gaze.camera)[1]) < by;
  };
  turned.spot.stands = spot.stands && is_as_before(right_of, level) && is_as_before(ahead_of, as_low);
  to.add_around(*at, off, turned.places);
  if (spot.only_hides) return turned;
  Point nearer = place;
  nearer.z -= static_cast<float>(growth / (1.0 + growth)) * std::max(0.0f, nearer.z - gaze.outlook.camera().z);
  const auto end = to.position_of(nearer);
  if (!end) return turned;
  const double down = end->row - at->row, across = end->column - at->column;
  const int steps = to.steps_of(std::hypot(down, across));
  for (int i = 1; i <= steps; ++i)
    to.add_around({at->row + down * i / steps, at->column + across * i / steps}, off, turned.places);
  return turned;
}

std::optional<double> above_or_below(const Spot& spot, const Gaze& gaze, const Pixels& picture) {
  if (!are_known(gaze.rays)) return std::nullopt;
  const Turning to(gaze, picture);
  const auto at = to.position_of(spot.place());
  return at ? std::optional(to.rows_beyond(*at) * std::abs(gaze.rays.down->slope)) : std::nullopt;
}

Evidence evidence_of(const TurnedSpot& turned, const Pixels& picture) {
  const Evidence said = evidence_of(turned.spot, picture);
  if (said == Evidence::Nothing) return said;
  const auto says_so = [&](const TurnedSpot::Place& place) {
    if (said == Evidence::Past) return shows_what_is_behind(turned.spot, place, picture);
    const Evidence there = evidence_of(moved_to(turned.spot, place), picture);
    return there == Evidence::There || there == Evidence::Hidden;
  };
  return std::all_of(turned.places.begin(), turned.places.end(), says_so) ? said : Evidence::Nothing;
}

bool is_there(const TurnedSpot& turned, const Pixels& picture) {
  return std::all_of(turned.places.begin(), turned.places.end(), [&](const TurnedSpot::Place& place) {
    return evidence_of(moved_to(turned.spot, place), picture) == Evidence::There;
  });
}

bool leaves_a_hole(const TurnedSpot& turned, const Pixels& picture) {
  return std::any_of(turned.places.begin(), turned.places.end(), [&](const TurnedSpot::Place& place) {
    return leaves_a_hole(moved_to(turned.spot, place), picture);
  });
}

}  // namespace safety_control_cloud
