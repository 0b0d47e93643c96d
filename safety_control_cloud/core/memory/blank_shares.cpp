// SPDX-License-Identifier: BSD-3-Clause
#include "blank_shares.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// By so many standard deviations chance must miss what is mostly blank. At 20 Hz and with a hundred places for a post,
/// it is tried eight million times in an hour, and it is skewed.
constexpr double deviations = 6.0;

/// Chance of which this is the logarithm is none in one cloud: once in an hour at 20 Hz.
constexpr double no_chance = -16.0;

/// At most so many clouds are asked: 0.8 s. Of a thin post and three rows they are enough where six pixels in ten are
/// blank by chance; where more are, the robot may stand for nothing.
constexpr double most_clouds = 16.0;

/// How much is blank by chance is a mean over about so many clouds: what hides the floor is noticed before that rises.
constexpr float usual_clouds = 8.0f;

/// So many make it sure that, where each of so many pixels is blank by chance, three in four are by something else.
double clouds_to_ask(double chance, std::size_t pixels) {
  const double beyond = mostly_blank - chance;
  if (beyond <= 0.0) return most_clouds;
  const double needed = deviations * deviations * chance * (1.0 - chance) / (beyond * beyond);
  return std::clamp(needed / static_cast<double>(pixels), 1.0, most_clouds);
}

}  // namespace

/// Begins with what is blank by chance. What was lost before the light fell stays so: its share is high already.
void BlankShares::note(const std::vector<std::uint16_t>& blank, std::size_t rows, std::size_t post) {
  if (rows == 0) return;
  note_usual(blank, rows);
  const double chance = by_chance();
  if (shares_.empty()) shares_.assign(blank.size(), static_cast<float>(chance));
  clouds_ = clouds_to_ask(chance, rows * post);
  const auto latest = static_cast<float>(2.0 / (clouds_ + 1.0)), all = static_cast<float>(rows);
  for (std::size_t i = 0; i < blank.size(); ++i)
    shares_[i] = latest * static_cast<float>(blank[i]) / all + (1.0f - latest) * shares_[i];
  if (chance < mostly_blank) note_what_is_blank_at_once(blank, rows, post, chance);
}

void BlankShares::note_usual(const std::vector<std::uint16_t>& blank, std::size_t rows) {
  const float latest = shares_.empty() ? 1.0f : 1.0f / usual_clouds;
  for (std::size_t part = 0; part < usual_.size(); ++part) {
    const std::size_t begin = part * blank.size() / usual_.size(), end = (part + 1) * blank.size() / usual_.size();
    if (begin == end) continue;
    const auto pixels = static_cast<float>((end - begin) * rows);
    std::size_t some = 0;
    for (std::size_t i = begin; i < end; ++i) some += blank[i];
    usual_[part] += latest * (static_cast<float>(some) / pixels - usual_[part]);
  }
}

/// The median: what hides less than half of the floor does not raise it.
double BlankShares::by_chance() const {
  auto parts = usual_;
  const auto middle = parts.begin() + (parts.size() - 1) / 2;
  std::nth_element(parts.begin(), middle, parts.end());
  return double{*middle};
}

/// In one cloud, adjacent columns of which no pixel returns: a thin post moves by its width from one cloud to the next
/// while the robot turns.
void BlankShares::note_what_is_blank_at_once(const std::vector<std::uint16_t>& blank, std::size_t rows,
                                             std::size_t post, double chance) {
  const double needed = std::ceil(no_chance / (std::log(chance) * static_cast<double>(rows)));
  const std::size_t wide = std::max(post, static_cast<std::size_t>(needed));
  std::size_t adjacent = 0;
  for (std::size_t i = 0; i < blank.size(); ++i) {
    adjacent = blank[i] == rows ? adjacent + 1 : 0;
    if (adjacent >= wide) std::fill_n(shares_.begin() + static_cast<std::ptrdiff_t>(i + 1 - wide), wide, 1.0f);
  }
}

}  // namespace safety_control_cloud
