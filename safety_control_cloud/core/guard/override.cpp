// SPDX-License-Identifier: BSD-3-Clause
#include "override.hpp"

#include <algorithm>

#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

/// Written so that NaN is refused.
std::optional<std::string> refusal_of(const OverrideWish& wish, const GuardSettings& settings) {
  if (!(settings.override_max > 0.0)) return "override_max is 0: not enabled";
  if (!(wish.seconds > 0.0 && wish.seconds <= settings.override_max))
    return "seconds must be more than 0 and at most override_max, " + measured(settings.override_max, "s");
  if (!(wish.speed > 0.0 && wish.speed <= settings.override_speed))
    return "speed must be more than 0 and at most override_speed, " + measured(settings.override_speed, "m/s");
  return std::nullopt;
}

}  // namespace

OverrideReply SightOverride::ask(const OverrideWish& wish, const GuardSettings& settings,
                                 const std::optional<Doubt>& doubt, double now) {
  if (wish.seconds == 0.0) {
    const bool held = holds(now);
    end();
    return {true, held ? "ended" : "there was none"};
  }
  if (const auto refusal = refusal_of(wish, settings)) return {false, "refused: " + *refusal};
  if (doubt && !wish.even_in_doubt)
    return {false, words("refused: the sensor is in doubt, ", name_of(doubt->cause), " (", doubt->reason,
                         "), and even_in_doubt is not asked for")};
  granted_ = wish;
  speed_ = wish.speed;
  until_ = now + wish.seconds;
  return {true, words("for ", measured(wish.seconds, "s"), " commands pass at up to ", measured(wish.speed, "m/s"),
                      " whatever the sensor shows", wish.even_in_doubt ? ", even in doubt" : "")};
}

void SightOverride::adopt(const GuardSettings& settings) {
  if (!until_) return;
  if (granted_.seconds > settings.override_max) return end();
  speed_ = std::min(speed_, settings.override_speed);
}

double SightOverride::left(double now) const { return until_ ? std::max(0.0, *until_ - now) : 0.0; }

bool SightOverride::covers(const std::vector<Known>& known, double now) const {
  if (!holds(now)) return false;
  const auto commanded_twice = [](const Known& one) { return one.doubt && one.doubt->cause == Cause::TwoCommanders; };
  if (std::any_of(known.begin(), known.end(), commanded_twice)) return false;
  return granted_.even_in_doubt || !doubt_of(known);
}

std::optional<Doubt> doubt_of(const Known& known) {
  if (known.doubt) return known.doubt;
  return known.lost && known.lost->cause != Cause::Seen ? known.lost : std::nullopt;
}

std::optional<Doubt> doubt_of(const std::vector<Known>& known) {
  for (const Known& one : known)
    if (auto doubt = doubt_of(one)) return doubt;
  return std::nullopt;
}

}  // namespace safety_control_cloud
