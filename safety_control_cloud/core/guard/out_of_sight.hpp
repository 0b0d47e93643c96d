// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "eye.hpp"
#include "horizon.hpp"
#include "kept_places.hpp"
#include "known_places.hpp"
#include "looks_taken.hpp"
#include "near_returns.hpp"
#include "pose.hpp"
#include "remembered_place.hpp"
#include "surroundings.hpp"
#include "whereabouts.hpp"

namespace safety_control_cloud {

/// What is kept of what has left the picture.
struct OutOfSightLimits {
  Vicinity vicinity = {};  ///< what came into it is kept; of no size: nothing is
  double time = 0.0;       ///< [s] for so long
  double speed = 0.0;      ///< [m/s] of obstacles
};

/// What came near the robot and no sensor shows any more: beside it, behind it, in its blind zone. Kept as places in a
/// frame that rests, in which somebody says where the robot is, each until a sensor sees what is behind it, or has seen
/// nothing there for a while where it could, or until its time is over and the picture shows none of what it may be the
/// end of. A place counts once two looks have shown it, or one beside it.
class OutOfSight {
 public:
  explicit OutOfSight(OutOfSightLimits limits) : limits_(std::move(limits)) {}

  /// Goes on within other limits: what lies above or below them is not kept any more.
  void limit(OutOfSightLimits limits);

  /// What `sensor` shows, the robot being there in the resting frame. `now` [s] steady, `came_after` [s] the look's
  /// stamp. Of a cloud that is not organised nothing is kept: nobody could tell what is seen behind it.
  /// `meanwhile`: the way that the robot went while the look was being taken.
  void note(std::size_t sensor, const Look& look, const Whereabouts& robot, double now, double came_after,
            const Pose2& meanwhile);

  /// `sensor` shows something, and nobody knows from where.
  void note_unplaced(std::size_t sensor, double now);

  void forget() { *this = OutOfSight(limits_); }

  /// Where the robot was at a stamp [s, ROS]; none: it is not known.
  using RobotAt = std::function<std::optional<Whereabouts>(double stamp)>;

  /// From now on another frame rests, in which the robot is `there`. What a look showed of which `was_at` tells where
  /// the robot was in that frame is placed by it; all else as it lies around the robot.
  void go_on_in_frame(const Whereabouts& robot, const Whereabouts& there, double now, const RobotAt& was_at = nullptr);

  /// What is kept, around the robot.
  std::vector<KeptPlace> placed(const Whereabouts& robot, double now) const;

  /// From now on these too are kept, as if their sensors had shown them, before they look again, to a robot that was
  /// there.
  void recall(const std::vector<KeptPlace>& places, const Whereabouts& there, double now);

  /// Whether somebody asks for a place in base_frame that a sensor saw, a part of what stood or hung there between
  /// these heights, or up to `off` [m] elsewhere.
  using AsksFor = std::function<bool(std::size_t sensor, const Point2& place, const Heights& heights, double off)>;

  struct Rings {
    std::vector<Ring> all, asked_for;
  };

  /// Whether anything would be kept.
  bool remembers() const { return limits_.vicinity.distance > 0.0 && limits_.time > 0.0; }

  /// Whether anything is.
  bool holds_any(double now) const;
  /// The same of what one look alone has shown.
  bool has_seen_any(double now) const;

  /// What is kept and was seen to rest, around the robot, and as a camera there has it. What walks leaves a trail of
  /// places, of which each was shown for a moment.
  std::vector<KnownPlace> resting(const Outlook& camera, const Whereabouts& robot, double now) const;

  /// What is kept and not shown by the latest look of its sensor, around the robot, out to `reach` [m]; by how much it
  /// may have been displaced meanwhile. `shows`: of each sensor, whether its latest look is believed still.
  std::vector<Ring> rings(const Whereabouts& robot, double reach, double now, const std::vector<bool>& shows) const;

  /// What was not seen to stay where it was, and does not lie amidst what one of these sees: wherever it may have gone
  /// since, as fast as obstacles are.
  std::vector<Ring> rings_at_large(const Whereabouts& robot, double reach, double now,
                                   const std::vector<Eye>& eyes) const;

  /// The same of what each sensor saw.
  std::vector<Rings> rings_of_each(const Whereabouts& robot, double reach, double now, const std::vector<bool>& shows,
                                   const AsksFor& asks) const;

 private:
  using Place = RememberedPlace;
  using Places = std::unordered_map<std::uint64_t, Place>;  ///< by cell

  /// A place as it lies around the robot now, and by how much it may have been displaced meanwhile.
  struct Here {
    Point2 place;
    double range, off;              ///< [m]
    const LooksTaken::Taken& look;  ///< the latest that showed it
  };

  static void put(const Place& place, Places& places);
  const LooksTaken::Taken* shown_by(const Place& place, double now) const;
  void drop_what_is_over(double now);
  void drift(const Drift& way, const Point2& robot);
  void make_room(const Point2& robot);
  bool counts(const Place& place, double now) const;
  template <class Is>
  bool any_beside(const Place& place, Is is) const;
  bool was_staying(const Place& place) const;
  template <class Visit>
  void for_each(const Whereabouts& robot, double now, Visit visit) const;
  template <class Visit>
  void for_each_unseen(const Whereabouts& robot, double reach, double now, const std::vector<bool>& shows,
                       Visit visit) const;
  void keep(const NearReturn& seen, double now, double off, const Heights& stands);
  std::uint8_t looks_of(const Place& before) const;
  void take_over_from_beside(Place& shown) const;
  void note_who_does_not_see(Place& shown, const Place& before) const;

  OutOfSightLimits limits_;
  Places places_;
  LooksTaken looks_;  ///< as long as a place of theirs may be kept
};

}  // namespace safety_control_cloud
