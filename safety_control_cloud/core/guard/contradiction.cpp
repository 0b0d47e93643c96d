// SPDX-License-Identifier: BSD-3-Clause
#include "contradiction.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double surely_gone = 0.08, gone_against = 0.05;    ///< [m]
constexpr double surely_turned = 0.2, turned_against = 0.1;  ///< [rad]
constexpr double most_turned = 1.2;                          ///< [rad] beyond it, ahead is not ahead any more
constexpr double hardly = 0.1;                               ///< of the turn

/// What is common to all ways: the least, if it leads one way by all; or else nothing.
template <class Of>
double surely(const std::vector<Pose2>& ways, Of of) {
  const auto by_size = [&](const Pose2& a, const Pose2& b) { return of(a) < of(b); };
  const auto [least, most] = std::minmax_element(ways.begin(), ways.end(), by_size);
  return of(*least) > 0.0 ? of(*least) : std::min(of(*most), 0.0);
}

bool is_against(double way, double as_told, double least_told, double least) {
  return std::abs(as_told) >= least_told && way * as_told < 0.0 && std::abs(way) >= least;
}

}  // namespace

std::optional<std::string> contradiction(const Pose2& way, const std::vector<Pose2>& as_told) {
  if (as_told.empty()) return std::nullopt;
  const auto turn_of = [](const Pose2& one) { return one.heading; };
  const double turn = surely(as_told, turn_of);
  if (is_against(way.heading, turn, surely_turned, turned_against))
    return "it turns the other way than the base is told to";
  const bool hardly_turns = std::abs(way.heading) < hardly * std::abs(turn);
  if (std::abs(turn) >= surely_turned && hardly_turns && length_of(way.place) >= gone_against)
    return "it does not turn, as the base is told to, and goes on";
  const auto turns_far = [](const Pose2& one) { return std::abs(one.heading) > most_turned; };
  if (turns_far(way) || std::any_of(as_told.begin(), as_told.end(), turns_far)) return std::nullopt;
  const double ahead = surely(as_told, [](const Pose2& one) { return one.place.x; });
  const double left = surely(as_told, [](const Pose2& one) { return one.place.y; });
  if (is_against(way.place.x, ahead, surely_gone, gone_against))
    return ahead > 0.0 ? "it goes backward, and the base is told to go ahead"
                       : "it goes ahead, and the base is told to go backward";
  if (is_against(way.place.y, left, surely_gone, gone_against) && std::abs(turn) < turned_against)
    return "it goes to the other side than the base is told to";
  return std::nullopt;
}

}  // namespace safety_control_cloud
