// SPDX-License-Identifier: BSD-3-Clause
#include "things_memory.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace safety_control_cloud {
namespace {

/// So far a thing moves from one cloud to the next [m]: 3 m/s.
constexpr float step = 0.15f;
/// Of a thing of which as much is still seen, nothing is lost.
constexpr double same_size = 0.85;
/// As many spots of a thing tell which one it is.
constexpr std::size_t enough_spots = 24;
/// What is seen past in so many successive clouds has gone.
constexpr unsigned clouds_to_go = 3;
/// Nearly all of a thing.
constexpr double nearly = 0.85;
constexpr std::size_t most_lost = 240;  ///< spots of one thing
/// Of the picture, at least 1/share is a fair extent.
constexpr double fair_share = 500;

bool are_close(const Point& a, const Point& b) {
  return (a.getVector3fMap() - b.getVector3fMap()).squaredNorm() < step * step;
}

/// How much of what was seen lies close to what is seen [share].
double common(const std::vector<Spot>& before, const Thing& now) {
  std::size_t close = 0, asked = 0;
  for (std::size_t i = 0; i < before.size(); i += 1 + before.size() / enough_spots, ++asked) {
    close += std::any_of(now.spots.begin(), now.spots.end(),
                         [&](const Spot& spot) { return are_close(before[i].point, spot.point); });
  }
  return static_cast<double>(close) / static_cast<double>(std::max<std::size_t>(1, asked));
}

void append(std::vector<Spot>& all, std::vector<Spot> some) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
  if (all.size() <= most_lost) return;
  for (std::size_t i = 0; 2 * i < all.size(); ++i) {
    Spot spot = all[2 * i];
    spot.share *= 2.0f;
    all[i] = spot;
  }
  all.resize((all.size() + 1) / 2);
}

}  // namespace

double size_of(const std::vector<Spot>& spots) {
  return std::accumulate(spots.begin(), spots.end(), 0.0,
                         [](double sum, const Spot& spot) { return sum + double{spot.share}; });
}

void ThingsMemory::restore(std::vector<Remembered> things, float blind_range) {
  things_ = std::move(things);
  blind_range_ = blind_range;
}

void ThingsMemory::update(std::vector<Thing> seen, const Pixels& picture, const FloorAgain& floor_again, float near) {
  follow(std::move(seen));
  unlearn_blind_range();
  for (Remembered& thing : things_) {
    note_vanished(thing, picture, near);
    ask(thing, picture, floor_again);
  }
  things_.erase(std::remove_if(things_.begin(), things_.end(),
                               [](const Remembered& thing) { return !thing.is_seen() && thing.lost.empty(); }),
                things_.end());
}

/// Of what is farther away than near, keeps what has vanished in mid-air.
void ThingsMemory::note_vanished(Remembered& thing, const Pixels& picture, float near) {
  if (thing.vanished) return;
  double blank = 0.0;
  float nearest = std::numeric_limits<float>::infinity();
  for (const Spot& spot : thing.lost) {
    nearest = std::min(nearest, spot.point.z);
    if (evidence_of(spot, picture) == Evidence::Nothing) blank += double{spot.share};
  }
  const bool fair = thing.size * fair_share >= 1.0 * nearest * nearest * static_cast<double>(picture.height()) /
                                                   static_cast<double>(picture.width());
  thing.vanished = !thing.is_seen() && nearest >= near && thing.clouds >= clouds_to_go && !thing.at_border && fair &&
                   blank >= 0.95 * thing.size;
  if (thing.vanished) {
    blind_range_ = std::max(blind_range_, nearest);
    return;
  }
  const auto is_far = [near](const Spot& spot) { return spot.point.z >= near; };
  thing.lost.erase(std::remove_if(thing.lost.begin(), thing.lost.end(), is_far), thing.lost.end());
}

void ThingsMemory::unlearn_blind_range() {
  const bool nearer = std::any_of(things_.begin(), things_.end(), [this](const Remembered& thing) {
    return thing.is_seen() && thing.seen.nearest < 0.9f * blind_range_;
  });
  if (!nearer) return;
  blind_range_ = 0.0f;
  for (Remembered& thing : things_) thing.vanished = false;
}

/// Which of the things that were seen are those that are seen now: the ones that have most in common.
void ThingsMemory::follow(std::vector<Thing> seen) {
  std::vector<std::vector<Spot>> before;
  std::vector<double> size_before;
  for (Remembered& thing : things_) {
    before.push_back(std::move(thing.seen.spots));
    size_before.push_back(thing.seen.size);
    thing.seen = Thing{};
    thing.seen.size = size_before.back();  // as it was seen last
  }
  for (Thing& now : seen) {
    std::size_t best = things_.size();
    double most = now.at_border ? 0.05 : 0.25;  // what leaves the corridor there may lose most of it in one step
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].empty() || things_[i].is_seen()) continue;
      const double shared = std::min(common(before[i], now), 1.0) * std::min(1.0, now.size / size_before[i]);
      if (shared > most) best = i, most = shared;
    }
    if (best == things_.size()) {
      things_.emplace_back();
      before.emplace_back();
      size_before.push_back(0.0);
    }
    Remembered& thing = things_[best];
    const bool same = now.size > same_size * size_before[best] && size_before[best] > same_size * now.size &&
                      now.size > same_size * thing.size;
    if (same && thing.lost.empty()) before[best].clear();
    thing.size = std::max(thing.size, now.size);
    thing.at_border = now.at_border;
    thing.stood = thing.stood || now.stands;
    // What is left of it at a border may show no foot: a post that slides out of the corridor still stands.
    for (Spot& spot : now.spots) spot.stands = spot.stands || (thing.stood && (spot.foot_unseen || now.at_border));
    thing.seen = std::move(now);
    thing.freed = 0.0;
    thing.vanished = false;
    ++thing.clouds;
  }
  for (std::size_t i = 0; i < things_.size(); ++i) append(things_[i].lost, std::move(before[i]));
}

void ThingsMemory::ask(Remembered& thing, const Pixels& picture, const FloorAgain& floor_again) {
  double past = 0.0;  // of those that stay
  const auto goes = [&](Spot& spot) {
    const Evidence evidence = evidence_of(spot, picture);
    spot.seen_past = evidence == Evidence::Past ? static_cast<std::uint8_t>(spot.seen_past + 1) : std::uint8_t{0};
    // Seen again, it is a thing that is seen; what comes nearer while a part of it is seen is that thing itself.
    const bool again = evidence == Evidence::There || (evidence == Evidence::Hidden && thing.is_seen() &&
                                                       picture.near(spot.row, spot.column).z > spot.point.z - step);
    if (again) return true;
    if (spot.seen_past >= clouds_to_go || (spot.stands && floor_again(spot.column))) {
      thing.freed += double{spot.share};
      return true;
    }
    if (spot.seen_past > 0) past += double{spot.share};
    return false;
  };
  thing.lost.erase(std::remove_if(thing.lost.begin(), thing.lost.end(), goes), thing.lost.end());
  const double rest = size_of(thing.lost);
  if (rest > 0.0 && thing.freed + past >= nearly * (thing.freed + rest)) thing.lost.clear();
}

}  // namespace safety_control_cloud
