// SPDX-License-Identifier: BSD-3-Clause
#include "recalled_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../input/angle.hpp"

namespace safety_control_cloud {
namespace {

constexpr double least_jump = 0.1;  ///< [m], [rad]

std::string written_name(const SensorSettings& sensor) {
  return (sensor.type == InputKind::Scan ? "scan/" : "") + sensor.name;
}

}  // namespace

std::vector<std::string> written_names(const Sensors& sensors) {
  std::vector<std::string> names;
  for (const SensorSettings& sensor : sensors) names.push_back(written_name(sensor));
  return names;
}

std::vector<KeptPlace> shown_by(const Sensors& sensors, const KeptPlaces& kept) {
  const auto first = [&](const auto& fits) {
    return static_cast<std::size_t>(std::find_if(sensors.begin(), sensors.end(), fits) - sensors.begin());
  };
  const std::size_t camera = first([](const SensorSettings& one) { return one.type != InputKind::Scan; });
  std::vector<std::size_t> by_now;
  for (const std::string& name : kept.sensors) {
    const std::size_t same = first([&](const SensorSettings& one) { return written_name(one) == name; });
    by_now.push_back(same < sensors.size() ? same : camera < sensors.size() ? camera : 0);
  }
  std::vector<KeptPlace> places = kept.all;
  for (KeptPlace& place : places) place.sensor = by_now[place.sensor];
  return places;
}

std::optional<Pose2> seen_from(const KeptPlaces& kept, const Pose2& robot, double stamp, const Twist2& fastest) {
  if (!kept.robot) return std::nullopt;
  Pose2 then = *kept.robot;  // each process counts its own full turns
  then.heading = robot.heading + wrapped(then.heading - robot.heading);
  const Pose2 way = between(then, robot);
  const double time = std::max(0.0, stamp - kept.stamp);
  const bool may_have_come = length_of(way.place) <= speed_of(fastest) * time + least_jump &&
                             std::abs(way.heading) <= std::abs(fastest.w) * time + least_jump;
  return may_have_come ? std::optional(then) : std::nullopt;
}

}  // namespace safety_control_cloud
