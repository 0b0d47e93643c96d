// SPDX-License-Identifier: BSD-3-Clause
#include "lost_spots.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace safety_control_cloud {
namespace {

constexpr double beside = 0.04;     ///< [m] a spot may lie by as much to twice as much beside what is known of it
constexpr double above = 0.1;       ///< [m] or below: of so much, one height is kept (out_of_sight.cpp, layer)
constexpr double nearly_all = 0.9;  ///< of the spots: some lie in the air behind an edge
constexpr double going = 0.3;    ///< [s] in which a thing goes out of sight, shown in one picture and not in the next
constexpr double missed = 0.12;  ///< [s] without being shown, by more looks than noise takes it from
constexpr double same = 0.025;   ///< [m] beside what is shown since: its shown rest hides no more of a thing

constexpr double noise = 0.005;        ///< [m] of a camera so near
constexpr double most_advance = 0.02;  ///< [m] in which a robot's way since, and the stamps, may be off by as much
constexpr double at_border = 0.05;     ///< [1] of x/z and y/z: what rests there may have left the picture

constexpr std::size_t most_pictures = 600;  ///< half a minute of a fast camera: what is kept longer is forgotten

/// Found by where they are.
class KnownByCell {
 public:
  explicit KnownByCell(const std::vector<KnownPlace>& known) {
    for (const KnownPlace& one : known) in_cell_[cell_of(one.place)].push_back(&one);
  }

  /// Whether any of those beside a place, about as high [m], tells so.
  template <class Tells>
  bool any_beside(const Point2& here, double height, Tells tells) const {
    const auto does = [&](const KnownPlace* one) { return std::abs(one->height - height) <= above && tells(*one); };
    const auto [x, y] = cell_of(here);
    for (const long ahead : {-1, 0, 1}) {
      for (const long left : {-1, 0, 1}) {
        const auto cell = in_cell_.find({x + ahead, y + left});
        if (cell != in_cell_.end() && std::any_of(cell->second.begin(), cell->second.end(), does)) return true;
      }
    }
    return false;
  }

 private:
  using Cell = std::pair<long, long>;

  static Cell cell_of(const Point2& place) { return {std::lround(place.x / beside), std::lround(place.y / beside)}; }

  std::map<Cell, std::vector<const KnownPlace*>> in_cell_;
};

/// Beyond a camera's blind range by less than a thing comes nearer between two clouds: what rests there is shown.
class JustBeyond {
 public:
  explicit JustBeyond(const Looking& looking)
      : inside_(inside_of(looking.field)), from_(looking.blind_range + noise), to_(looking.blind_range + step_nearer) {}

  /// `advance` [m]: as much nearer than it was.
  bool holds(const Point& there, double advance) const {
    return there.z > from_ + std::clamp(advance, 0.0, most_advance) && there.z < to_ && inside_.holds(there);
  }

 private:
  /// Less its border, whichever way its columns and rows run.
  static FieldOfView inside_of(const FieldOfView& field) {
    const auto [left, right] = std::minmax(field.left, field.right);
    const auto [top, bottom] = std::minmax(field.top, field.bottom);
    return {left + at_border, right - at_border, top + at_border, bottom - at_border};
  }

  FieldOfView inside_;
  double from_, to_;  ///< [m]
};

/// A place around the robot, as its camera has it, and by how much nearer that is than it was seen, so far ahead [m].
struct ByNow {
  ByNow(const Outlook& camera, const Point2& here, double height, double seen_ahead)
      : there(camera.seen_from_camera(in_corridor_axes(here, height))), advance(seen_ahead - double{there.z}) {}

  Point there;
  double advance;  ///< [m]
};

}  // namespace

void LostSpots::note_picture(std::uint32_t number, const Taken& from) {
  pictures_.insert_or_assign(number, from);
  if (pictures_.size() > most_pictures) pictures_.erase(pictures_.begin());
}

void LostSpots::note(const std::vector<LostSpot>& lost, double now) {
  decltype(spots_) spots;
  for (const auto& [spot, picture] : lost) {
    const std::array<float, 3> seen{spot.x, spot.y, spot.z};
    if (const auto found = spots_.find(seen); found != spots_.end()) {
      spots.insert(*found);
      continue;
    }
    Lost& lost_now = spots[seen] = {std::nullopt, 0.0, now};
    const auto taken = pictures_.find(picture);
    if (taken == pictures_.end()) continue;
    const auto& [camera, pose, at] = taken->second;
    lost_now.since = std::min(now, at + going);
    const Point there = camera.placed(spot.x, spot.y, spot.z);
    lost_now.place = beyond(pose, {{there.z, -there.x}, 0.0}).place;
    lost_now.height = -there.y;
  }
  spots_ = std::move(spots);
}

void LostSpots::forget_places() {
  pictures_.clear();
  for (auto& [seen, lost] : spots_) lost.place.reset();
}

bool LostSpots::have_moved(const std::vector<KnownPlace>& known, const Looking& looking) const {
  const SeenAfter seen_after(looking.pose);
  const JustBeyond just_beyond(looking);
  std::vector<std::pair<Point2, const Lost*>> expected;
  for (const auto& [seen, lost] : spots_) {
    if (!lost.place) continue;
    const Point2 here = seen_after(*lost.place);
    const ByNow spot(looking.camera, here, lost.height, seen[2]);
    if (just_beyond.holds(spot.there, spot.advance)) expected.push_back({here, &lost});
  }
  const double some = (1.0 - nearly_all) * static_cast<double>(spots_.size());
  if (static_cast<double>(expected.size()) <= some) return false;
  const KnownByCell by_cell(known);
  const auto is_not_shown = [&](const auto& one) {
    const auto& [here, lost] = one;
    return !by_cell.any_beside(here, lost->height, [&, &here = here, &lost = lost](const KnownPlace& shown) {
      return shown.shown_at > lost->since && length_of(shown.place - here) <= same;
    });
  };
  return static_cast<double>(std::count_if(expected.begin(), expected.end(), is_not_shown)) > some;
}

/// It was shown last, so is forgotten, so much sooner.
bool LostSpots::is_forgotten(const Lost& lost, double time, double now) { return now - lost.since > time - going; }

double LostSpots::kept_until(double time, double now) const {
  double until = now + time;
  for (const auto& [seen, lost] : spots_)
    if (!is_forgotten(lost, time, now)) until = std::min(until, lost.since + time - going);
  return until;
}

bool LostSpots::are_among(const std::vector<KnownPlace>& known, const Looking& looking, double time, double now) const {
  const KnownByCell by_cell(known);
  const SeenAfter seen_after(looking.pose);
  const JustBeyond just_beyond(looking);
  const auto is_near_one = [&](const Point2& here, const Lost& lost, double advance) {
    return by_cell.any_beside(here, lost.height, [&](const KnownPlace& one) {
      const bool has_gone = now - one.shown_at > missed && just_beyond.holds(one.seen_from_camera, advance);
      const bool is_it = one.shown_at <= lost.since + going || length_of(one.place - here) <= same;
      return one.tells_where_it_is() && is_it && !has_gone;
    });
  };
  double known_ones = 0.0;
  for (const auto& [seen, lost] : spots_) {
    if (!lost.place) return false;
    const bool is_old = is_forgotten(lost, time, now);
    const Point2 here = seen_after(*lost.place);
    if (is_old && looking.eye.sees(here)) return false;
    const ByNow spot(looking.camera, here, lost.height, seen[2]);
    if (is_old || is_near_one(here, lost, spot.advance)) ++known_ones;
  }
  return known_ones >= nearly_all * static_cast<double>(spots_.size());
}

}  // namespace safety_control_cloud
