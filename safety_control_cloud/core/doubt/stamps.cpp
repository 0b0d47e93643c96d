// SPDX-License-Identifier: BSD-3-Clause
#include "stamps.hpp"

#include <algorithm>
#include <cmath>

#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double fastest_drift = 1e-3;  ///< [s/s] ten times what a poor quartz does
constexpr double longest_pause = 60.0;  ///< [s] after which no more drift is believed unseen
constexpr double farthest = 60.0;       ///< [s] a clock that is off by more has to be set
constexpr double growing = 1e-2;        ///< [s/s] no clock drifts so fast: something piles up
constexpr unsigned few_clouds = 3;      ///< may all be stamped wrongly
constexpr double shortest_set = 1.0;    ///< [s] a single wrong stamp is no clock that was set
constexpr double shortest_look = 0.5;   ///< [s] to tell a steady age from a growing one

}  // namespace

std::optional<Doubt> StampWatch::note(double age, double now, const DoubtSettings& by) {
  if (!(by.stamp_tolerance > 0.0)) return std::nullopt;
  const double slack = last_ ? fastest_drift * std::clamp(now - *last_, 0.0, longest_pause) : 0.0;
  last_ = now;
  if (!(std::abs(age - drift_) <= by.stamp_tolerance + slack)) return unexplained(age, now, by.stamp_tolerance);
  spell_.reset();
  if (is_early(age, now, by.source_timeout)) {
    return Doubt{Cause::Future, words("the cloud's stamp is ", measured(*steady_ - age, "s"),
                                      " ahead of what others' were: its camera's clock jumps")};
  }
  const double steady = steady_ ? std::min(age, *steady_ + slack) : age;
  if (age - steady > by.source_timeout) {
    const bool first_were_wrong = believed_ < few_clouds && *steady_ < 0.0 && age >= 0.0;
    if (first_were_wrong) start_from(age);
    return Doubt{Cause::Stale, words("the cloud came ", measured(age - steady, "s"),
                                     " later than others did (steady "
                                     "offset of its stamps: ",
                                     measured(steady, "s"), "): it waited in a queue")};
  }
  believe(steady, slack);
  return std::nullopt;
}

/// Whether no cloud can have been so fast. Once all are for a while, the camera's clock was set.
bool StampWatch::is_early(double age, double now, double timeout) {
  if (!steady_ || age >= *steady_ - timeout) {
    early_since_.reset();
    return false;
  }
  if (believed_ >= few_clouds && !early_since_) early_since_ = now;
  if (early_since_ && now - *early_since_ < shortest_set) return true;
  early_since_.reset();
  start_from(age);
  return false;
}

void StampWatch::start_from(double age) {
  steady_ = age;
  believed_ = 0;
}

void StampWatch::believe(double steady, double slack) {
  ++believed_;
  steady_ = steady;
  drift_ = std::clamp(drift_ + std::clamp(steady - drift_, -slack, slack), -farthest, farthest);
}

Doubt StampWatch::unexplained(double age, double now, double tolerance) {
  if (!spell_) spell_ = Spell{now, age};
  const double watched = now - spell_->since, pace = (age - spell_->age) / watched;
  std::string trend;
  if (watched >= shortest_look) {
    trend = pace > growing ? ", and ever older: clouds wait in a queue"
                           : ", a steady offset: a clock is off, or every cloud comes so late";
  }
  if (!(age - drift_ <= tolerance)) {
    return Doubt{Cause::Stale, "the cloud's stamp is " + measured(age, "s") + " old" + trend};
  }
  return Doubt{Cause::Future, "the cloud's stamp is " + measured(-age, "s") + " ahead" + trend};
}

}  // namespace safety_control_cloud
