// SPDX-License-Identifier: BSD-3-Clause
#include "contradiction.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr double lately = 10.0, enough = 0.3, longest_gap = 0.2;  ///< [s]
constexpr double surely_gone = 0.08, gone_against = 0.05;         ///< [m]
constexpr double surely_turned = 0.2, turned_against = 0.1;       ///< [rad]
constexpr double most_turned = 1.2;                               ///< [rad] beyond it, ahead is not ahead any more
constexpr double rest = 0.01;                                     ///< [m], [rad] no way

/// What is common to all ways: the least, if it leads one way by all; or else nothing.
template <class Of>
double surely(const std::vector<Pose2>& ways, Of of) {
  const auto by_size = [&](const Pose2& a, const Pose2& b) { return of(a) < of(b); };
  const auto [least, most] = std::minmax_element(ways.begin(), ways.end(), by_size);
  return of(*least) > 0.0 ? of(*least) : std::min(of(*most), 0.0);
}

enum class Sense { Neither, Along, Against };

/// Of a way along one axis.
Sense sense_of(double way, double as_told, double least_told, double least) {
  if (std::abs(as_told) < least_told || std::abs(way) < least) return Sense::Neither;
  return way * as_told < 0.0 ? Sense::Against : Sense::Along;
}

}  // namespace

Compared compared(const Pose2& way, const std::vector<Pose2>& as_told) {
  if (as_told.empty()) return {};
  const double turn = surely(as_told, [](const Pose2& one) { return one.heading; });
  const Sense turned = sense_of(way.heading, turn, surely_turned, turned_against);
  if (turned == Sense::Against) return {false, "it turns the other way than the base is told to"};
  const auto turns_far = [](const Pose2& one) { return std::abs(one.heading) > most_turned; };
  if (turns_far(way) || std::any_of(as_told.begin(), as_told.end(), turns_far)) return {turned == Sense::Along, {}};
  const double ahead = surely(as_told, [](const Pose2& one) { return one.place.x; });
  const double left = surely(as_told, [](const Pose2& one) { return one.place.y; });
  const Sense went = sense_of(way.place.x, ahead, surely_gone, gone_against);
  if (went == Sense::Against)
    return {false, ahead > 0.0 ? "it goes backward, and the base is told to go ahead"
                               : "it goes ahead, and the base is told to go backward"};
  const Sense slid =
      std::abs(turn) < turned_against ? sense_of(way.place.y, left, surely_gone, gone_against) : Sense::Neither;
  if (slid == Sense::Against) return {false, "it goes to the other side than the base is told to"};
  const auto senses = {turned, went, slid};
  const bool is_told_to_go = std::abs(turn) >= surely_turned || std::hypot(ahead, left) >= surely_gone;
  const bool stood = is_told_to_go && length_of(way.place) <= rest && std::abs(way.heading) <= rest;
  return {std::find(senses.begin(), senses.end(), Sense::Along) != senses.end(), {}, stood};
}

void Contradictions::note(const Compared& one, double now) {
  const double time = std::clamp(noted_ ? now - *noted_ : 0.0, 0.0, longest_gap), kept = std::exp(-time / lately);
  noted_ = now;
  against_ = kept * against_ + (one.contradiction ? time : 0.0);
  along_ = kept * along_ + (one.agrees ? time : 0.0);
  stood_ = one.agrees ? 0.0 : stood_ + (one.stood ? time : 0.0);
}

bool Contradictions::prevail() const { return against_ >= enough && against_ > along_; }

bool Contradictions::has_stood() const { return stood_ >= enough; }

}  // namespace safety_control_cloud
