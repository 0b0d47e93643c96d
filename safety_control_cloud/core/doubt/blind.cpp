// SPDX-License-Identifier: BSD-3-Clause
#include "blind.hpp"

#include <algorithm>
#include <cmath>

#include "../text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr double following = 3.0, giving_in = 30.0;  ///< [s] for an e-th of the way
constexpr double longest_step = 1.0;                 ///< [s] a pause without clouds shows nothing
constexpr double few = 50.0;                         ///< returns; of so few, a tenth says nothing

}  // namespace

std::optional<Doubt> doubt_about_returns(const Returned& cloud, const DoubtSettings& by) {
  const bool enough = static_cast<double>(cloud.returns) >= by.min_valid_ratio * static_cast<double>(cloud.total);
  if (cloud.returns > 0 && cloud.returns >= by.min_returns && enough) return std::nullopt;
  return Doubt{Cause::Blind, words(cloud.returns, " returns of ", cloud.total, " points")};
}

std::optional<Doubt> BlindWatch::note(const Returned& cloud, const DoubtSettings& by, double now) {
  if (auto doubt = doubt_about_returns(cloud, by)) return doubt;
  const auto returns = static_cast<double>(cloud.returns);
  const double ratio = by.min_valid_ratio;
  const bool too_few =
      level_ > few && !cloud.tells_what_is_missing() && (returns < ratio * level_ || returns < ratio * ratio * most_);
  const double lately = std::max(level_, ratio * most_);
  follow(returns, too_few ? giving_in : following, now);
  if (!too_few) return std::nullopt;
  return Doubt{Cause::Blind, words(cloud.returns, " returns, where lately there were ", std::lround(lately))};
}

void BlindWatch::follow(double returns, double pace, double now) {
  const double step = std::clamp(now - last_, 0.0, longest_step);
  level_ = level_ > 0.0 ? level_ * std::pow(returns / level_, 1.0 - std::exp(-step / pace)) : returns;
  most_ = std::max(most_, level_);
  last_ = now;
}

}  // namespace safety_control_cloud
