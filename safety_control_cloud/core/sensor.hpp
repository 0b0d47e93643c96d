// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "doubt/blind.hpp"
#include "doubt/clock.hpp"
#include "doubt/doubt.hpp"
#include "doubt/frozen.hpp"
#include "doubt/sources.hpp"
#include "doubt/stamps.hpp"
#include "doubt/turns.hpp"
#include "input/reading.hpp"
#include "look/look.hpp"
#include "look/placement.hpp"
#include "look/sight.hpp"
#include "look/upright.hpp"
#include "memory/near_loss.hpp"
#include "memory/picture_gap.hpp"
#include "settings.hpp"

namespace safety_control_cloud {

/// One moment on two clocks [s].
struct Instant {
  double steady = 0.0;  ///< never goes back
  double ros = 0.0;     ///< ROS time, the clock of the stamps
};

/// Where and when a reading was taken.
struct Origin {
  double stamp = 0.0;  ///< [s] ROS time
  Placing placing = OpticalFrame{};
  std::string source = {};  ///< who sent it, and over which connection
  std::string frame = {};   ///< that it names as its own
};

/// What a sensor that is believed saw.
struct Seen {
  Sight sight;
  std::optional<Loss> loss;  ///< what it saw before and cannot see any more
  bool is_cut_off = false;   ///< what is nearest may reach nearer than the sensor sees
};

/// What a sensor says of the way ahead, or why it cannot. "Nothing there" is a Seen, "could not look" never is.
using Answer = std::variant<Seen, Doubt>;

/// One input: who sends, what came and when, what was near. It sees readings and answers; what the robot does about the
/// answer is none of its business.
class Sensor {
 public:
  /// The settings are fit: see problems_in().
  explicit Sensor(const Settings& settings);

  /// Goes on with other settings.
  void adopt(const Settings& settings);

  /// The same with those of a corridor that leads elsewhere, by so much to the left [rad].
  void turn_corridor(const Settings& settings, double angle);

  /// A reading has come, readable or not. `alongside`: what else is done with its points, if it is looked at.
  void see(const Reading& reading, const Origin& origin, const Instant& now, Crop crop = Crop::Skip,
           const Alongside* alongside = nullptr);

  /// None has come until `now`.
  void wait(const Instant& now);

  /// To the latest reading, or to its absence.
  const Answer& answer() const { return answer_; }

  /// What was counted in the latest reading, whether or not it is believed; all zero if it could not be looked at.
  const Sight& counted() const { return counted_; }

  /// The latest reading that was looked at, as an upright camera has it; borrowed. And a corridor down which that
  /// looks.
  const View& upright_view() const { return upright_view_; }
  Outlook upright(const Outlook& outlook) const { return upright_.turned(outlook); }

  /// Whether anything was near when it was shown last, or is lost.
  bool is_any_near() const { return near_loss_.is_any_near(); }
  /// Whether what another process lost is lost still, for all that this one has seen.
  bool is_recalled() const { return recalled_; }

  /// Whether the latest reading is the one before once more, with `frozen_clouds` on: it tells nothing of what is
  /// there now, and less if it is placed elsewhere. What is lost is what was lost then.
  bool repeats() const { return repeats_; }

  /// The number of the latest reading in which anything near was looked for; a new one only if that was the latest.
  std::uint32_t picture() const { return near_loss_.picture(); }
  /// See NearLoss.
  const std::vector<Point>& ends_below() const { return near_loss_.ends_below(); }

  /// Forgets the near obstacles that were lost from sight, and how much and how soon the camera used to show: somebody
  /// has looked.
  void forget_losses();

  /// What is near or lost, to outlive the process; empty if nothing is.
  std::string remembered() const;

  /// Goes on with what another process remembered, be that in another frame. Text that makes no sense changes nothing.
  bool recall(const std::string& remembered);

 private:
  Answer answer_to(const Reading& reading, const Origin& origin, const Instant& now, Crop crop,
                   const Alongside* alongside);
  Answer look_at(const Reading& reading, const Outlook& outlook, const Origin& origin, double now, Crop crop,
                 const Alongside* alongside);
  void judge(const View& view, const Sight& sight, const Outlook& outlook, double stamp, double now);

  /// What of a reading is asked of the memory.
  struct Judged {
    std::optional<Loss> loss;
    bool is_cut_off;
  };

  Settings settings_;
  SourceWatch sources_;
  TurnsWatch turns_;
  ClockWatch clock_;
  StampWatch stamps_;
  BlindWatch blind_;
  FrozenWatch frozen_;
  Upright upright_;
  View upright_view_;
  PictureGap gap_;
  NearLoss near_loss_;
  bool recalled_ = false;               ///< what is lost was lost by another process
  std::optional<double> last_arrival_;  ///< [s] steady
  bool repeats_ = false;                ///< the latest reading, the one before
  std::optional<Judged> judged_;        ///< the latest that was believed, by these settings
  Answer answer_ = Doubt{Cause::NoCloud, "no cloud has arrived yet"};
  Sight counted_;
};

}  // namespace safety_control_cloud
