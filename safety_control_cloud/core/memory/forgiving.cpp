// SPDX-License-Identifier: BSD-3-Clause
#include "forgiving.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "evidence.hpp"
#include "likeness.hpp"
#include "turned.hpp"

namespace safety_control_cloud {
namespace {

/// Nearly all of a thing, and a small part of one.
constexpr double nearly = 0.85, few = 0.25;

constexpr float straight = 0.05f;  ///< sine of the angle by which a camera may look past the corridor's end, 3 degrees
constexpr double as_high = 0.09;   ///< [rad] 5 degrees: what it would not see if it never tilted lies farther beyond

/// What is left of a thing when most of it has gone: which of it is seen past by now, and where a hole is [m2].
struct Rest {
  double size = 0.0, past = 0.0, blank = 0.0;

  /// Which may be something else, that went out of sight together with it.
  bool is_a_hole() const { return 2.0 * blank > size - past; }
};

class Forgiving {
 public:
  Forgiving(Remembered& thing, const Pixels& picture, const NearFloor& floor, const Gaze& gaze)
      : thing_(thing), picture_(picture), floor_(floor), gaze_(gaze), clouds_to_count_(gaze.has_turned ? 2 : 1) {
    turn_to_gaze();
    std::vector<Spot> seen_past, standing;
    said_.reserve(thing.lost.size());
    for (std::size_t i = 0; i < thing.lost.size(); ++i) {
      said_.push_back(evidence(i));
      if (said_.back() == Evidence::Past) seen_past.push_back(shown(i));
      if (shown(i).stands) standing.push_back(shown(i));
    }
    between_rays_ = may_lie_between_rays(std::move(seen_past), picture);
    floor_between_ = may_stand_between_rays(std::move(standing), floor.rows, picture);
  }

  void drop_what_has_gone() {
    std::vector<Spot>& lost = thing_.lost;
    std::size_t staying = 0;
    for (std::size_t i = 0; i < said_.size(); ++i) {
      const Fate fate = fate_of(i);
      if (fate == Fate::Goes) continue;
      if (fate == Fate::Stays) note_staying(lost[i], staying);
      if (!elsewhere_.empty()) std::swap(elsewhere_[staying], elsewhere_[i]);
      std::swap(lost[staying++], lost[i]);
    }
    lost.resize(staying);
    rest_.size = size_of(lost) - leaving_ - hung_rest_.size - alone_rest_.size;
  }

  void drop_the_rest() {
    const double gone = thing_.freed + rest_.past + hung_rest_.past + alone_rest_.past;
    const double all = thing_.freed + rest_.size + hung_rest_.size + alone_rest_.size;
    const bool is_most = gone >= nearly * all && gone >= few * (gone + leaving_);
    if (!(gone > 0.0) || !is_most) return;
    std::vector<Spot>& lost = thing_.lost;
    for (const std::size_t i : not_seen_past_)
      if (between_rays_ || is_a_hole(i)) rest_with(lost[i]).blank += double{lost[i].share};
    std::size_t staying = 0;
    for (std::size_t i = 0; i < lost.size(); ++i)
      if (will_be_asked(i) || rest_with(lost[i]).is_a_hole()) lost[staying++] = lost[i];
    lost.resize(staying);
  }

 private:
  /// Apart: it stays, whatever becomes of the others.
  enum class Fate { Goes, Stays, Apart };

  /// Of a spot that was seen when the camera looked elsewhere.
  struct Elsewhere {
    bool is_so = false;
    std::optional<TurnedSpot> turned{};  ///< whole; none: the picture says nothing of it, whatever the others do
    bool will_be_asked = false;          ///< once the camera looks there again; if not, it may go along
  };

  void turn_to_gaze() {
    const auto is_elsewhere = [&](const Spot& spot) { return !show_the_same(spot.camera, gaze_.camera); };
    if (std::none_of(thing_.lost.begin(), thing_.lost.end(), is_elsewhere)) return;
    for (const Spot& spot : thing_.lost) elsewhere_.push_back(is_elsewhere(spot) ? looked_for(spot) : Elsewhere{});
  }

  /// What was seen as the camera turned may never be looked at so again; and one that looks down the corridor shows all
  /// that it would show if it never turned.
  Elsewhere looked_for(const Spot& spot) const {
    auto turned = turned_spot(spot, gaze_, picture_);
    if (turned && turned->is_whole) return {true, std::move(turned)};
    const bool looks_ahead = std::abs(ahead_of(gaze_.camera)[0]) < straight && ahead_of(gaze_.camera)[2] > 0.0f;
    const auto beyond = above_or_below(spot, gaze_, picture_);
    return {true, std::nullopt, spot.turning <= still && (!looks_ahead || !beyond || *beyond > as_high)};
  }

  bool is_elsewhere(std::size_t i) const { return !elsewhere_.empty() && elsewhere_[i].is_so; }
  bool will_be_asked(std::size_t i) const { return is_elsewhere(i) && elsewhere_[i].will_be_asked; }
  const TurnedSpot* turned(std::size_t i) const {
    return is_elsewhere(i) && elsewhere_[i].turned ? &*elsewhere_[i].turned : nullptr;
  }
  /// As the picture would show it.
  const Spot& shown(std::size_t i) const { return turned(i) ? turned(i)->spot : thing_.lost[i]; }

  Evidence evidence(std::size_t i) const {
    if (is_elsewhere(i)) return turned(i) ? evidence_of(*turned(i), picture_) : Evidence::Nothing;
    return evidence_of(thing_.lost[i], picture_);
  }
  bool is_a_hole(std::size_t i) const {
    return turned(i) ? leaves_a_hole(*turned(i), picture_) : leaves_a_hole(thing_.lost[i], picture_);
  }

  Fate fate_of(std::size_t i) {
    Spot& spot = thing_.lost[i];
    if (is_elsewhere(i) && !turned(i)) {
      if (!will_be_asked(i)) leaving_ += double{spot.share};
      return Fate::Apart;
    }
    if (spot.lost_for < floor_.after) ++spot.lost_for;
    const bool is_past = said_[i] == Evidence::Past && !between_rays_;
    if (may_have_left(i, is_past)) {
      leaving_ += double{spot.share};
      return Fate::Apart;
    }
    spot.seen_past = is_past ? static_cast<std::uint8_t>(spot.seen_past + 1) : std::uint8_t{0};
    if (is_seen_again(i)) return Fate::Goes;
    if (spot.seen_past < clouds_to_go && !shows_floor_below(i)) return Fate::Stays;
    thing_.freed += double{spot.share};
    return Fate::Goes;
  }

  /// What has left at the lower border is looked over: then the floor is seen again too.
  bool may_have_left(std::size_t i, bool is_past) const {
    if (thing_.is_seen()) return false;
    if (leaves_at_the_bottom(shown(i), gaze_.nearer, picture_))
      return (is_past || shows_floor_below(i)) && !is_there_above(i);
    return is_past && leaves_at_the_top(shown(i), picture_) && !shows_floor_below(i);
  }

  /// Whether the same wall is still there right above it, beside the corridor: a wall that came nearer would not be.
  bool is_there_above(std::size_t i) const {
    const std::vector<Spot>& lost = thing_.lost;
    const Spot* above = nullptr;
    for (const Spot& spot : lost) {
      const bool is_above = spot.column == lost[i].column && spot.row < lost[i].row;
      if (is_above && (!above || spot.row > above->row)) above = &spot;
    }
    if (!above || std::abs(above->point.z - lost[i].point.z) > noise_at(above->point.z)) return false;
    const bool were_seen_at_once = above->picture != 0 && above->picture == lost[i].picture;
    return were_seen_at_once && said_[static_cast<std::size_t>(above - lost.data())] == Evidence::There;
  }

  /// As a thing that is seen; what comes nearer while a part of it is seen is that thing itself.
  bool is_seen_again(std::size_t i) const {
    if (said_[i] == Evidence::There) return true;
    const Spot& spot = shown(i);
    return said_[i] == Evidence::Hidden && thing_.is_seen() &&
           picture_.near(spot.row, spot.column).z > spot.point.z - farthest_step;
  }

  bool shows_floor_below(std::size_t i) const {
    const Spot& spot = shown(i);
    const bool may_stand = spot.stands && spot.column_shown && thing_.lost[i].lost_for >= floor_.after;
    if (!may_stand || floor_between_ || !floor_.is_seen_again(spot.column)) return false;
    const auto shows_it = [this](const TurnedSpot::Place& place) { return floor_.is_seen_again(place.column); };
    return !turned(i) || std::all_of(turned(i)->places.begin(), turned(i)->places.end(), shows_it);
  }

  /// `i`: which of the lost it will be.
  void note_staying(const Spot& spot, std::size_t i) {
    if (&rest_with(spot) != &rest_) rest_with(spot).size += double{spot.share};
    if (spot.seen_past >= clouds_to_count_) {
      rest_with(spot).past += double{spot.share};
    } else {
      not_seen_past_.push_back(i);
    }
  }

  Rest& rest_with(const Spot& spot) { return spot.went_alone ? alone_rest_ : spot.hung_before ? hung_rest_ : rest_; }

  Remembered& thing_;
  const Pixels& picture_;
  const NearFloor& floor_;
  const Gaze& gaze_;
  const unsigned clouds_to_count_;    ///< that show something behind a spot, for the rest of the thing to go with it
  std::vector<Evidence> said_;        ///< of each of the lost
  std::vector<Elsewhere> elsewhere_;  ///< of each of the lost; empty if none is
  bool between_rays_ = false, floor_between_ = false;
  Rest rest_, hung_rest_, alone_rest_;
  double leaving_ = 0.0;  ///< [m2] of those that stay
  std::vector<std::size_t> not_seen_past_;
};

}  // namespace

void forgive(Remembered& thing, const Pixels& picture, const NearFloor& floor, const Gaze& gaze) {
  Forgiving forgiving(thing, picture, floor, gaze);
  forgiving.drop_what_has_gone();
  forgiving.drop_the_rest();
}

}  // namespace safety_control_cloud
