// SPDX-License-Identifier: BSD-3-Clause
#include "turns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace safety_control_cloud {
namespace {

constexpr std::size_t looked_at = 16;  ///< of the latest pictures
constexpr std::size_t many = 7;        ///< changes among them; one camera may flicker a few times
constexpr std::ptrdiff_t of_each =
    5;  ///< pictures of either camera among them: a few false points may resemble each other

constexpr double same_share = 0.02;      ///< of returns: no more than noise
constexpr double same_inside = 0.005;    ///< of all points
constexpr double by_chance = 4.0;        ///< standard deviations of a share of few points
constexpr double same_nearest = 0.05;    ///< [m] no more than noise and what a robot drives in as many pictures
constexpr double nothing_nearest = 1e9;  ///< [m]

constexpr std::size_t least_probes = 8;  ///< that return in both, for two pictures to be alike
constexpr float same_depth = 0.05f;      ///< [1] of it
constexpr double most_alike = 0.8;       ///< of those: some lie at an edge

using Pictures = std::deque<Picture>;

std::size_t changes_of_frame(const Pictures& pictures) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < pictures.size(); ++i) changes += pictures[i].frame != pictures[i - 1].frame;
  return changes;
}

std::size_t steps_back(const Pictures& pictures) {
  std::size_t steps = 0;
  for (std::size_t i = 1; i < pictures.size(); ++i) steps += pictures[i].stamp < pictures[i - 1].stamp;
  return steps;
}

/// How often a value goes from one to the other of the only two that it takes; 0 if it takes more, or only one. What is
/// false in single pictures is false in another way each time.
std::size_t changes_of(const std::function<double(const Picture&)>& value, double same, const Pictures& pictures) {
  const double one = value(pictures.front());
  const auto is_one = [&](const Picture& picture) { return std::abs(value(picture) - one) <= same; };
  const auto first_other = std::find_if_not(pictures.begin(), pictures.end(), is_one);
  if (first_other == pictures.end()) return 0;
  const double other = value(*first_other);
  if (std::abs(other - one) <= 2.0 * same) return 0;
  const auto ones = std::count_if(pictures.begin(), pictures.end(), is_one);
  if (std::min(ones, static_cast<std::ptrdiff_t>(pictures.size()) - ones) < of_each) return 0;
  std::size_t changes = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (!is_one(pictures[i]) && !(std::abs(value(pictures[i]) - other) <= same)) return 0;
    changes += i > 0 && is_one(pictures[i]) != is_one(pictures[i - 1]);
  }
  return changes;
}

/// By how much a share differs from one picture of a camera to the next.
double same_for(double least, double (*share_in)(const Picture&), const Pictures& pictures) {
  const auto points = static_cast<double>(pictures.back().points);
  if (points == 0.0) return least;
  double share = 0.0;
  for (const Picture& picture : pictures) share += share_in(picture) / static_cast<double>(pictures.size());
  return std::max(least, by_chance * std::sqrt(std::max(0.0, share * (1.0 - share)) / points));
}

bool show_the_same(const Picture& one, const Picture& other) {
  std::size_t both = 0, alike = 0;
  for (std::size_t i = 0; i < one.probes.depths.size(); ++i) {
    const float here = one.probes.depths[i], there = other.probes.depths[i];
    if (std::isnan(here) || std::isnan(there)) continue;
    ++both;
    alike += std::abs(here - there) <= same_depth * std::min(here, there);
  }
  return both >= least_probes && static_cast<double>(alike) >= most_alike * static_cast<double>(both);
}

bool all_show_the_same(const Pictures& pictures) {
  return std::adjacent_find(pictures.begin(), pictures.end(), std::not_fn(show_the_same)) == pictures.end();
}

double returns_in(const Picture& picture) { return picture.returns; }
double inside_in(const Picture& picture) { return picture.inside; }
double nearest_in(const Picture& picture) { return picture.nearest.value_or(nothing_nearest); }

bool go_to_and_fro(const Pictures& pictures) {
  const double returns = same_for(same_share, returns_in, pictures);
  const double inside = same_for(same_inside, inside_in, pictures);
  return changes_of(returns_in, returns, pictures) >= many || changes_of(inside_in, inside, pictures) >= many;
}

bool are_of_two(const Pictures& pictures) {
  const std::size_t nearest = changes_of(nearest_in, same_nearest, pictures);
  return changes_of_frame(pictures) >= many || steps_back(pictures) >= many || nearest == looked_at - 1 ||
         (go_to_and_fro(pictures) && (nearest > 0 || !all_show_the_same(pictures)));
}

}  // namespace

std::optional<Doubt> TurnsWatch::note(const Picture& picture, double now, double timeout) {
  latest_.push_back(picture);
  if (latest_.size() > looked_at) latest_.pop_front();
  if (are_of_two(latest_)) in_turn_ = now;
  if (!in_turn_ || now - *in_turn_ > timeout) return std::nullopt;
  return Doubt{Cause::TwoSources, "pictures of two cameras arrive in turn over one connection"};
}

}  // namespace safety_control_cloud
