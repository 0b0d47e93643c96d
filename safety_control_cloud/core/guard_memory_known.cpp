// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "guard_memory.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double mistaken_for = 1.0;  ///< [s] until that is written down anew
constexpr const char* what_frees =
    "a sensor sees past that, or after memory_time, or after ~reset, when somebody has looked";
constexpr const char* what_frees_who_strayed = "after memory_time, or after ~reset, when somebody has looked";

}  // namespace

/// Not every sensor that is required has looked since odometry goes on. What was to be placed then is forgotten by and
/// by.
bool GuardMemory::waits_for(const std::vector<GuardSensor>& sensors, const Instant& now) const {
  return jumped_ && !(now.ros - *jumped_ > limits_.places.time) &&
         std::any_of(sensors.begin(), sensors.end(), [this](const GuardSensor& sensor) {
           return sensor.is_required() && !sensor.has_looked_since(*jumped_);
         });
}

/// Why what is out of sight cannot be placed.
std::optional<Doubt> GuardMemory::doubt_at(const Instant& now, const Went& went,
                                           const std::vector<GuardSensor>& sensors) const {
  const auto in_doubt = [](const std::string& reason) { return Doubt{Cause::NoOdometry, reason}; };
  const bool is_placed_by_odometry = by_odometry_ && out_of_sight_.holds_any(now.steady);
  if (is_placed_by_odometry && went.odometry.breaks() != breaks_)
    return in_doubt("odometry jumped or paused, and what is out of sight cannot be placed");
  if (const auto how = check_.contradiction_at(now.steady))
    return in_doubt("odometry cannot be right: " + *how + "; what is out of sight cannot be placed");
  if (has_strayed(now))
    return in_doubt("this node stood still as the robot drove, and what is out of sight cannot be placed");
  if (recalled_) {
    const char* why = recalled_->robot ? "no odometry" : "odometry jumped or was wrong";
    return in_doubt(words(why, ", and what was out of sight before this start cannot be placed"));
  }
  if (waits_for(sensors, now)) return in_doubt("odometry jumped or paused, and not every sensor has looked since");
  if (is_placed_by_odometry && !(went.odometry.is_fresh(now.ros) && went.odometry.pose_at(now.ros)))
    return in_doubt("no odometry, and what is out of sight cannot be placed");
  return std::nullopt;
}

std::vector<Known> GuardMemory::known_at(const Instant& now, const Went& went, const std::vector<GuardSensor>& sensors,
                                         const std::vector<bool>& shows, const Guard& guard) {
  for (auto* kept : {&recalled_, &broke_off_})
    if (*kept && (are_over((*kept)->stamp, now.ros, limits_.places.time) || !remembers())) kept->reset();
  const bool mistaken = is_mistaken(now);
  if (!mistaken) {
    mistaken_.reset();
  } else if (!mistaken_ || std::abs(now.ros - *mistaken_) > mistaken_for) {
    mistaken_ = now.ros;
  }
  Known known;
  known.sensor = "memory";
  known.doubt = doubt_at(now, went, sensors);
  if (mistaken || (recalled_ && !recalled_->robot)) known.hint = what_frees_who_strayed;
  if (known.doubt) return {known};
  jumped_.reset();
  if (!out_of_sight_.holds_any(now.steady)) return {};
  const Whereabouts robot = *whereabouts_at(0.0, went, now);  // there is, or it would be in doubt
  known.law = sensors.front().law();
  known.law.min_points = 1;
  known.hint = what_frees;
  known.ways = {Pose2{}};
  rings_.clear();
  const Around around{robot, guard.reach(0.0, known.law), now.steady};
  auto all = by_odometry_ ? placed_by_odometry(known, around, shows) : placed_as_told(known, around, sensors, shows);
  if (limits_.places.speed > 0.0) all.push_back(at_large(known, around, sensors, shows));
  return all;
}

Known GuardMemory::at_large(Known like, const Around& around, const std::vector<GuardSensor>& sensors,
                            const std::vector<bool>& shows) {
  like.is_at_large = true;
  for (std::size_t i = 0; i < sensors.size(); ++i)
    if (const auto eye = sensors[i].eye(); eye && shows[i]) like.watched_by.push_back(*eye);
  return with(out_of_sight_.rings_at_large(around.robot, around.reach, around.now, like.watched_by), like);
}

std::vector<Known> GuardMemory::placed_by_odometry(const Known& like, const Around& around,
                                                   const std::vector<bool>& shows) {
  return {with(out_of_sight_.rings(around.robot, around.reach, around.now, shows), like)};
}

std::vector<Known> GuardMemory::placed_as_told(Known like, const Around& around,
                                               const std::vector<GuardSensor>& sensors,
                                               const std::vector<bool>& shows) {
  const bool was_placed = told_since_ && around.now - *told_since_ <= limits_.places.time;  // well: all of it counts
  const auto is_missed = [&](std::size_t sensor, const Point2& place, const Heights& heights, double off) {
    return shows[sensor] && !was_placed && sensors[sensor].misses(place, heights, off);
  };
  auto of_each = out_of_sight_.rings_of_each(around.robot, around.reach, around.now, shows, is_missed);
  like.is_reckoned = !was_placed;
  std::vector<Known> all;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    like.seen_by = shows[i] ? sensors[i].eye() : std::nullopt;
    like.is_missed = false;
    all.push_back(with(std::move(of_each[i].all), like));
    like.is_missed = true;
    all.push_back(with(std::move(of_each[i].asked_for), like));
  }
  return all;
}

/// What the margin is kept for: half of it for where things are, the rest for what the robot does. What decides is the
/// nearest of many returns, not one of min_points as in a picture, and lies nearer than the thing by the noise.
Known GuardMemory::with(std::vector<Ring> rings, Known like) {
  for (Ring& ring : rings)
    ring.obstacles.widening = std::max(-like.law.noise, ring.obstacles.widening - 0.5 * limits_.margin);
  rings_.push_back(std::move(rings));
  like.rings = &rings_.back();
  return like;
}

}  // namespace safety_control_cloud
