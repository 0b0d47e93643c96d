// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.hpp"

#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

Zone zone_of(const Loss& loss, const ZoneLimits& limits) {
  return loss.whole || !loss.obstacle ? Zone::Danger : zone_at(loss.obstacle->distance(), limits);
}

Decision by_obstacle(const Sight& sight, Zone zone, bool is_cut_off) {
  Decision decision;
  decision.zone = zone;
  decision.cause = Cause::Seen;
  decision.reason =
      sight.nearest ? "nearest obstacle at " + measured(sight.nearest->distance(), "m") : "corridor is free";
  if (is_cut_off) decision.reason += ", and nearer than that the camera may be blind for it";
  decision.nearest = sight.nearest;
  decision.sight = sight;
  return decision;
}

Decision by_loss(const Sight& sight, const Loss& loss, Zone zone) {
  Decision decision;
  decision.zone = zone;
  decision.cause = loss.cause;
  decision.reason = loss.reason;
  decision.nearest = loss.obstacle;
  decision.stuck_since = loss.since;
  decision.hint = loss.hint;
  decision.sight = sight;
  return decision;
}

}  // namespace

Zone zone_of(const Sight& sight, const ZoneLimits& limits) {
  return sight.nearest ? zone_at(sight.nearest->distance(), limits) : Zone::Safe;
}

Decision standing_for(const Doubt& doubt, const Sight& counted) {
  Decision decision;
  decision.cause = doubt.cause;
  decision.reason = doubt.reason;
  decision.sight = counted;
  return decision;
}

Decision standing_for(const Unplaced& unplaced, const Sight& counted) {
  Decision decision = standing_for(*unplaced.doubt(), counted);
  decision.stuck_since = unplaced.since();
  decision.hint = Unplaced::hint;
  return decision;
}

Decision verdict_on(const Sensor& sensor, const ZoneLimits& limits) {
  if (const auto* doubt = std::get_if<Doubt>(&sensor.answer())) return standing_for(*doubt, sensor.counted());
  const auto& [sight, loss, is_cut_off] = std::get<Seen>(sensor.answer());
  const Zone seen = zone_of(sight, limits);
  const Zone lost = loss ? zone_of(*loss, limits) : Zone::Safe;
  if (lost < seen) return by_loss(sight, *loss, lost);
  return by_obstacle(sight, is_cut_off ? Zone::Danger : seen, is_cut_off && seen != Zone::Danger);
}

}  // namespace safety_control_cloud
