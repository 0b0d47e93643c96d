// SPDX-License-Identifier: BSD-3-Clause
#include "things_memory.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "evidence.hpp"
#include "following.hpp"
#include "turned.hpp"

namespace safety_control_cloud {
namespace {

/// Of the picture, at least 1/share is a fair extent.
constexpr double fair_share = 500;

/// [m2] of them where the picture says nothing, though it shows the place.
double blank_in(const std::vector<Spot>& spots, const Pixels& picture) {
  double blank = 0.0;
  for (const Spot& spot : spots) {
    if (spot.is_shown() && evidence_of(spot, picture) == Evidence::Nothing) blank += double{spot.share};
  }
  return blank;
}

/// If they are too many, every other one, and those stand for all; but a thing of which one part is lost over and over
/// is no larger for that than it was: of `size` [m2].
void append(std::vector<Spot>& all, std::vector<Spot> some, double size) {
  std::move(some.begin(), some.end(), std::back_inserter(all));
  if (all.size() <= most_lost) return;
  const double lost = std::min(size_of(all), size);
  for (std::size_t i = 0; 2 * i < all.size(); ++i) all[i] = all[2 * i];
  all.resize((all.size() + 1) / 2);
  const auto scale = static_cast<float>(lost / std::max(size_of(all), 1e-12));
  for (Spot& spot : all) spot.share *= scale;
}

/// While a camera turns, its picture says of nothing that it has gone, but of what is seen again that it is not lost.
/// What was never seen itself has nothing that a picture could take for it: it goes by all that do rest.
void drop_what_is_seen(std::vector<Spot>& lost, const Gaze& gaze, float turning, const Pixels& picture) {
  for (Spot& spot : lost)
    if (!spot.only_hides) spot.seen_past = 0;
  const auto is_seen = [&](const Spot& spot) {
    const auto turned = turned_spot(spot, gaze, picture, turning);
    return turned && is_there(*turned, picture);
  };
  lost.erase(std::remove_if(lost.begin(), lost.end(), is_seen), lost.end());
}

}  // namespace

void ThingsMemory::add(std::vector<Remembered> things, float blind_range, const CameraPose& camera) {
  std::move(things.begin(), things.end(), std::back_inserter(things_));
  blind_range_ = std::max(blind_range_, blind_range);
  camera_ = camera;
}

void ThingsMemory::add_unseen(std::vector<Spot> spots) {
  if (spots.empty()) return;
  auto thing = std::find_if(things_.begin(), things_.end(), [](const Remembered& one) { return one.was_never_seen(); });
  if (thing == things_.end()) thing = things_.emplace(things_.end());
  thing->size += size_of(spots);
  append(thing->lost, std::move(spots), thing->size);
}

void ThingsMemory::scale_sizes(double by) {
  for (Remembered& thing : things_)
    for (double* size : {&thing.size, &thing.freed, &thing.seen.size}) *size *= by;
  for_each_spot([by](Spot& spot) { spot.share = static_cast<float>(by * double{spot.share}); });
}

void ThingsMemory::update(std::vector<Thing> seen, const Pixels& picture, const NearFloor& floor,
                          const Backdrop& backdrop, float near, Gaze gaze) {
  const float turning = turning_to(gaze.camera);
  auto before = follow(things_, std::move(seen), near, {++picture_, turning});
  for (std::size_t i = 0; i < things_.size(); ++i) {
    for (Spot& spot : before[i].spots) spot.came_nearer = gaze.nearer.value_or(0.0f);
    lose(things_[i], std::move(before[i]));
  }
  unlearn_blind_range();
  const bool rest = turning <= still;
  has_turned_ = has_turned_ || !rest;
  gaze.has_turned = has_turned_;
  std::optional<std::vector<Backdrop::Place>> hidden;  // asked for once, if at all
  const auto follow_hole = [&](Remembered& thing) {
    if (!hidden) hidden = backdrop.hidden_in(picture);
    auto spots = thing.moved->spots_in(*hidden, backdrop.pixels_each(), picture.width());
    for (Spot& spot : spots) spot.camera = gaze.camera;
    stay_in_hole(thing, std::move(spots));
  };
  for (Remembered& thing : things_) {
    note_vanished(thing, picture, near, rest, gaze.nearer);
    if (!rest) {
      drop_what_is_seen(thing.lost, gaze, turning, picture);
      continue;
    }
    if (thing.lost.empty()) continue;
    if (thing.moved) {
      if (backdrop.is_seen_from(gaze.camera)) follow_hole(thing);
      continue;
    }
    const auto hanging = nearest_hanging(thing.lost);
    const double size = thing.freed + size_of(thing.lost);
    forgive(thing, picture, floor, gaze);
    const bool may_have_moved = hanging && thing.lost.empty() && !thing.is_seen() && backdrop.is_seen_from(gaze.camera);
    if (!may_have_moved) continue;
    thing.moved = Moved{*hanging, size};
    follow_hole(thing);
  }
  camera_ = gaze.camera;
  drop_empty();
}

/// Nothing goes for what is seen behind it, and nothing vanishes: what does not return counts as seen until a picture
/// says more, but where something else is seen now.
void ThingsMemory::update_by_little(std::vector<Thing> seen, const Pixels& picture, float near,
                                    const CameraPose& camera) {
  const float turning = turning_to(camera);
  auto before = follow(things_, std::move(seen), near, {++picture_, turning});
  const auto is_there = [&](const Spot& spot) {
    return turning <= still && show_the_same(spot.camera, camera) && evidence_of(spot, picture) == Evidence::There;
  };
  const auto drop_what_is_there = [&](std::vector<Spot>& spots) {
    spots.erase(std::remove_if(spots.begin(), spots.end(), is_there), spots.end());
  };
  for (std::size_t i = 0; i < things_.size(); ++i) {
    Remembered& thing = things_[i];
    if (thing.is_seen()) {
      lose(thing, std::move(before[i]));
    } else {
      drop_what_is_there(before[i].spots);
      thing.seen = std::move(before[i]);
    }
    drop_what_is_there(thing.lost);
  }
  unlearn_blind_range();
  camera_ = camera;
  drop_empty();
}

void ThingsMemory::drop_empty() {
  const auto is_empty = [](const Remembered& thing) { return !thing.is_seen() && thing.lost.empty(); };
  things_.erase(std::remove_if(things_.begin(), things_.end(), is_empty), things_.end());
}

void ThingsMemory::forget_old(const Patience& patience) {
  const auto is_old = [&](Spot& spot) {
    if (!spot.lost_since) spot.lost_since = patience.now;
    return patience.ends(*spot.lost_since);
  };
  for (Remembered& thing : things_) {
    if (thing.moved) is_old(thing.moved->from);
    thing.lost.erase(std::remove_if(thing.lost.begin(), thing.lost.end(), is_old), thing.lost.end());
  }
}

/// Of what is farther away than near, keeps what has vanished in mid-air, and what has left the picture at its lower
/// border. What leaves the picture of a camera that turns has not: it may be far from its border before.
void ThingsMemory::note_vanished(Remembered& thing, const Pixels& picture, float near, bool resting,
                                 const std::optional<float>& nearer) {
  if (thing.vanished) return;
  float nearest = std::numeric_limits<float>::infinity();
  for (const Spot& spot : thing.lost) nearest = std::min(nearest, spot.point.z);
  const bool fair = thing.size * fair_share >= 1.0 * nearest * nearest * static_cast<double>(picture.height()) /
                                                   static_cast<double>(picture.width());
  const bool is_far_thing =
      resting && !thing.is_seen() && nearest >= near && thing.clouds >= clouds_to_go && fair && !thing.lost.empty();
  const auto leaves = [&](const Spot& spot) { return leaves_at_the_bottom(spot, nearer, picture); };
  if (is_far_thing && !thing.at_border && blank_in(thing.lost, picture) >= 0.95 * thing.size) {
    thing.vanished = true;
    blind_range_ = std::max(blind_range_, nearest);
  } else {
    thing.vanished = is_far_thing && std::all_of(thing.lost.begin(), thing.lost.end(), leaves);
  }
  if (thing.vanished) return;
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

/// [rad] from the picture before.
float ThingsMemory::turning_to(const CameraPose& camera) const {
  return camera_ ? turning_between(*camera_, camera) : 0.0f;
}

void ThingsMemory::lose(Remembered& thing, Thing before) {
  const bool was_noise = thing.is_slight && thing.clouds < 2;
  if (!was_noise) append(thing.lost, std::move(before.spots), thing.size);
}

/// As long as there is one. Its spots are not asked: it may have left most of them.
void ThingsMemory::stay_in_hole(Remembered& thing, std::vector<Spot> spots) {
  thing.moved->clouds_gone = spots.empty() ? thing.moved->clouds_gone + 1 : 0;
  if (spots.empty() && thing.moved->clouds_gone < clouds_to_go) return;
  thing.lost = std::move(spots);
}

void ThingsMemory::turn_corridor(double angle) {
  if (camera_) camera_ = in_turned_frame(*camera_, angle);
  for_each_spot([&](Spot& spot) { spot.camera = in_turned_frame(spot.camera, angle); });
}

void ThingsMemory::change_axes(const CameraPose& now) {
  if (!camera_) return;
  for_each_spot([&](Spot& spot) { spot.camera = in_axes_of(now, *camera_, spot.camera); });
  camera_ = now;
}

void ThingsMemory::stay() {
  for (Remembered& thing : things_) thing.moved.reset();
}

}  // namespace safety_control_cloud
