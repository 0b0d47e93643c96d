// SPDX-License-Identifier: BSD-3-Clause
#include "latest_look.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

constexpr double long_on_its_way = 0.2;  ///< [s] what comes later after its stamp than this may have one that is off

FieldOfView field_in(const View& view) {
  const auto field = field_of(view, Sense::Either);
  const auto* seen = std::get_if<FieldOfView>(&field);
  return seen ? *seen : FieldOfView{};
}

}  // namespace

LatestLook::LatestLook(const Reading& reading, const View& view, const Outlook& from_there, const Heights& heights,
                       const Bearings& bearings)
    : is_scan(std::holds_alternative<ScanView>(reading)), outlook(from_there) {
  if (const auto* scan = std::get_if<ScanView>(&reading)) {
    eye = eye_of(outlook, *scan, bearings);
    horizon = Horizon(outlook, *scan, heights);
    range_min = scan->range_min;
    lasts = scan->lasts;
  } else {
    field = field_in(view);
    eye = eye_of(outlook, field);
    horizon = Horizon(outlook, field, heights);
  }
}

double LatestLook::may_last() const {
  return time_to_arrive > long_on_its_way ? std::max(time_to_arrive, lasts) : lasts;
}

double LatestLook::age_at(const Instant& now) const {
  return std::max(now.steady - arrival.steady, now.ros - arrival.ros) + time_to_arrive;
}

std::vector<Pose2> LatestLook::ways_since(const Instant& now, const Odometry& odometry, const Given& given) const {
  const auto way = odometry.way_since(stamp(), now.ros);
  const auto way_since_arrival = odometry.way_since(arrival.ros, now.ros);
  if (!way || !way_since_arrival) return given.ways_since(from, now.steady);
  if (time_to_arrive <= long_on_its_way && lasts == 0.0) return {*way};
  return {*way, *way_since_arrival};
}

bool LatestLook::misses(const Point2& place, const Heights& heights, double off) const {
  if (!eye.sees(place)) return false;
  if (is_scan) return length_of(place - eye.place) - off < range_min;
  const auto seen = [&](double height) { return outlook.seen_from_camera(in_corridor_axes(place, height)); };
  const Point low = seen(heights.bottom), high = seen(heights.top);
  const auto is_above = [up = field.top](const Point& there) { return there.y < up * there.z; };
  const auto is_below = [down = field.bottom](const Point& there) { return there.y > down * there.z; };
  return (is_above(low) && is_above(high)) || (is_below(low) && is_below(high));
}

}  // namespace safety_control_cloud
