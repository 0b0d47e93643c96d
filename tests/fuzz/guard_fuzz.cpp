// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer: whatever a camera, a driver, a base, a bumper and a clock may say to the guard, in any order, with
// restarts and other settings. What is given is a share of what is wanted, in doubt nothing, and before a wall no more
// than from which the robot still stops.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "../../safety_control_cloud/core/guard_control.hpp"
#include "../core/guard/xtion.hpp"
#include "guard_inputs.hpp"
#include "promises.hpp"

namespace safety_control_cloud {
namespace {

bool is_nothing(const Command& command) {
  const auto is_zero = [](double value) { return value == 0.0; };
  return std::all_of(command.linear.begin(), command.linear.end(), is_zero) &&
         std::all_of(command.angular.begin(), command.angular.end(), is_zero);
}

bool is_share(const Command& given, const Command& wanted, double factor) {
  const auto fits = [factor](double one, double other) {
    return one == other * factor || (one == 0.0 && factor == 0.0);
  };
  return factor >= 0.0 && factor <= 1.0 &&
         std::equal(given.linear.begin(), given.linear.end(), wanted.linear.begin(), fits) &&
         std::equal(given.angular.begin(), given.angular.end(), wanted.angular.begin(), fits);
}

/// Causes with which the robot may move, away from what they name.
bool leaves_ways(Cause cause) {
  const auto ways = {Cause::Seen, Cause::NearLoss, Cause::LowObstacle, Cause::Blind, Cause::Bumper, Cause::Cliff};
  return std::find(ways.begin(), ways.end(), cause) != ways.end();
}

/// A guard, and what a watch that knows nothing of it knows.
class World {
 public:
  explicit World(const GuardChoice& choice) : control_(settings_of(choice)) {}

  void go_on(const GuardStep& step) {
    now_.steady += step.elapsed / 1000.0;
    now_.ros += step.ros_elapsed / 1000.0;
    if (step.elapsed > 0) wall_.reset();
    happen(step);
    require_safe(control_.answer(now_));
  }

  void end_in_silence() {
    now_.steady += 1.0, now_.ros += 1.0;
    require(is_nothing(control_.answer(now_).given), "silence of the driver stops the robot");
  }

 private:
  void happen(const GuardStep& step) {
    switch (step.event) {
      case GuardEvent::Look:
        return look(step);
      case GuardEvent::Want:
        return want(step);
      case GuardEvent::Odometry:
        return control_.note_odometry(now_.ros - step.stamp_age / 1000.0, pose_of(step), twist_of(step));
      case GuardEvent::Pose:
        return control_.note_pose(now_.ros - step.stamp_age / 1000.0, pose_of(step));
      case GuardEvent::Switch: {
        touched_ = step.numbers[0] % 2 == 1;
        control_.note_switch(0, "driver", Edge::Front, touched_, now_);
        return;
      }
      case GuardEvent::Outside: {
        outside_ = step.numbers[0] % 2 == 1;
        return control_.note_outside(outside_ ? std::optional(Doubt{Cause::TwoCommanders, "another"}) : std::nullopt);
      }
      case GuardEvent::Override: {
        control_.ask_override({number_of(step.numbers[0]), number_of(step.numbers[1]), step.numbers[2] % 2 == 1}, now_);
        return;
      }
      case GuardEvent::Settings: {
        wall_.reset();
        return control_.adopt(settings_of(step.choice));
      }
      case GuardEvent::Forget:
        return control_.forget_losses();
      case GuardEvent::Restart:
        return restart();
      case GuardEvent::Quiet:
        return;
    }
  }

  void look(const GuardStep& step) {
    Step picture;
    picture.width = 40, picture.height = 30;
    picture.bytes = step.bytes;
    const bool is_wall = step.placing % 4 < 2 && step.bytes.size() == 1 && step.bytes[0] >= 20;
    if (is_wall) picture.bytes.assign(40 * 30, step.bytes[0]);
    const Depths depths = depths_of(picture);
    const std::vector<float> points = points_of(depths);
    const CloudView cloud = cloud_of(points, depths);
    const auto placing = step.placing % 4 == 3 ? Placing(NoTransform{"nobody knows"}) : xtion();
    const bool by_depth = step.placing % 4 == 1 && std::none_of(depths.z.begin(), depths.z.end(), is_minus_inf);
    looked_at_ = now_.steady;
    control_.see(by_depth ? Reading(image_of(depths)) : Reading(cloud),
                 {now_.ros - step.stamp_age / 1000.0, placing, "camera", "frame"}, now_);
    wall_.reset();
    if (is_wall) wall_ = static_cast<double>(depths.z[0]) - 0.087;
  }

  void want(const GuardStep& step) {
    wanted_ = command_of(step.numbers);
    wanted_at_ = now_.steady;
    control_.want(*wanted_, now_);
  }

  /// kill -9, and a new process with what the old one wrote down.
  void restart() {
    GuardControl another(control_.settings());
    another.recall(control_.remembered());
    control_ = std::move(another);
    wanted_.reset(), looked_at_.reset(), wall_.reset();
    touched_ = outside_ = false;
  }

  static Pose2 pose_of(const GuardStep& step) {
    return {{number_of(step.numbers[0]), number_of(step.numbers[1])}, number_of(step.numbers[2])};
  }
  static Twist2 twist_of(const GuardStep& step) {
    return {number_of(step.numbers[3]), number_of(step.numbers[4]), number_of(step.numbers[5])};
  }

  void require_safe(const Guarded& guarded) const {
    const Settings& settings = control_.settings();
    require(!guarded.reason.empty(), "every answer has a reason");
    const bool moves = !is_nothing(guarded.given);
    if (!moves) return;
    require(wanted_ && now_.steady - wanted_at_ <= settings.command_timeout, "nothing old moves the robot");
    require(is_share(guarded.given, *wanted_, guarded.factor), "what is given is a share of what is wanted");
    require(!outside_, "in doubt from outside the robot stands");
    require_slow(guarded, settings);
    if (guarded.override_left > 0.0) return;
    require(leaves_ways(guarded.cause), "in doubt the robot stands");
    require(looked_at_ && now_.steady - *looked_at_ <= settings.source_timeout, "unseen, nothing moves the robot");
    require(!touched_ || guarded.given.linear[0] <= 0.0, "nothing drives on into what the bumper touches");
    if (wall_) require_stops(guarded, settings);
  }

  static void require_slow(const Guarded& guarded, const Settings& settings) {
    const Twist2 given = in_plane(guarded.given);
    require(is_sound(given), "what is given is finite");
    const bool passes = guarded.override_left > 0.0;
    const Outline outline(footprint_of(settings));
    require(!passes || fastest_point(outline, given) <= settings.override_speed + 1e-9, "an override is slow");
  }

  /// Straight ahead, before a wall that has just been seen.
  void require_stops(const Guarded& guarded, const Settings& settings) const {
    const Twist2 given = in_plane(guarded.given);
    if (given.vx <= 0.0 || given.vy != 0.0 || given.w != 0.0) return;
    const double front = front_of(footprint_of(settings));
    const double way = given.vx * (settings.latency + settings.base_reaction) +
                       given.vx * given.vx / (2.0 * settings.stopping.base_deceleration);
    require(front + way <= *wall_ + 1e-3, "from what is given the robot stops before the wall");
  }

  static double front_of(const Footprint& footprint) {
    double front = footprint.polygon.empty() ? footprint.radius : 0.0;
    for (const Point2& corner : footprint.polygon) front = std::max(front, corner.x);
    return front;
  }

  GuardControl control_;
  Instant now_{100.0, 1000.0};
  std::optional<Command> wanted_;
  double wanted_at_ = 0.0;
  std::optional<double> looked_at_;  ///< [s] at whatever
  std::optional<double> wall_;       ///< [m] ahead of base_frame's origin, seen now
  bool touched_ = false, outside_ = false;
};

}  // namespace
}  // namespace safety_control_cloud

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace safety_control_cloud;
  return happen_as_told<World, GuardChoice, GuardStep>(bytes, size, 48);
}
