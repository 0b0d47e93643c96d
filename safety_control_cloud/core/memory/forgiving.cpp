// SPDX-License-Identifier: BSD-3-Clause
#include "forgiving.hpp"

#include <algorithm>
#include <utility>

#include "evidence.hpp"
#include "likeness.hpp"

namespace safety_control_cloud {
namespace {

/// Nearly all of a thing, and a small part of one.
constexpr double nearly = 0.85, few = 0.25;

/// What is left of a thing when most of it has gone: which of it is seen past by now, and where a hole is [m2].
struct Rest {
  double size = 0.0, past = 0.0, blank = 0.0;

  /// Which may be something else, that went out of sight together with it.
  bool is_a_hole() const { return 2.0 * blank > size - past; }
};

class Forgiving {
 public:
  Forgiving(Remembered& thing, const Pixels& picture, const NearFloor& floor, const Axis& axis)
      : thing_(thing), picture_(picture), floor_(floor), axis_(axis) {
    std::vector<Spot> seen_past, standing;
    said_.reserve(thing.lost.size());
    for (const Spot& spot : thing.lost) {
      said_.push_back(evidence_of(spot, picture));
      if (said_.back() == Evidence::Past) seen_past.push_back(spot);
      if (spot.stands) standing.push_back(spot);
    }
    between_rays_ = may_lie_between_rays(std::move(seen_past), picture);
    floor_between_ = may_stand_between_rays(std::move(standing), floor.rows, picture);
  }

  void drop_what_has_gone() {
    std::vector<Spot>& lost = thing_.lost;
    std::size_t staying = 0;
    for (std::size_t i = 0; i < said_.size(); ++i) {
      const Fate fate = fate_of(lost[i], said_[i]);
      if (fate == Fate::Goes) continue;
      if (fate == Fate::Stays) note_staying(lost[i], staying);
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
      if (between_rays_ || leaves_a_hole(lost[i], picture_)) rest_with(lost[i]).blank += double{lost[i].share};
    const auto goes_along = [this](const Spot& spot) { return !rest_with(spot).is_a_hole(); };
    lost.erase(std::remove_if(lost.begin(), lost.end(), goes_along), lost.end());
  }

 private:
  /// Apart: it stays, whatever becomes of the others.
  enum class Fate { Goes, Stays, Apart };

  Fate fate_of(Spot& spot, Evidence said) {
    if (!spot.axis) spot.axis = axis_;
    if (!are_same(*spot.axis, axis_, same_axis)) return Fate::Apart;
    if (spot.lost_for < floor_.after) ++spot.lost_for;
    const bool is_past = said == Evidence::Past && !between_rays_;
    if (is_past && !thing_.is_seen() && leaves_at_the_top(spot, picture_) && !shows_floor_below(spot)) {
      leaving_ += double{spot.share};
      return Fate::Apart;
    }
    spot.seen_past = is_past ? static_cast<std::uint8_t>(spot.seen_past + 1) : std::uint8_t{0};
    if (is_seen_again(spot, said)) return Fate::Goes;
    if (spot.seen_past < clouds_to_go && !shows_floor_below(spot)) return Fate::Stays;
    thing_.freed += double{spot.share};
    return Fate::Goes;
  }

  /// As a thing that is seen; what comes nearer while a part of it is seen is that thing itself.
  bool is_seen_again(const Spot& spot, Evidence said) const {
    if (said == Evidence::There) return true;
    return said == Evidence::Hidden && thing_.is_seen() &&
           picture_.near(spot.row, spot.column).z > spot.point.z - farthest_step;
  }

  bool shows_floor_below(const Spot& spot) const {
    const bool may_stand = spot.stands && spot.column_shown && spot.lost_for >= floor_.after;
    return may_stand && !floor_between_ && floor_.is_seen_again(spot.column);
  }

  /// `i`: which of the lost it will be.
  void note_staying(const Spot& spot, std::size_t i) {
    if (&rest_with(spot) != &rest_) rest_with(spot).size += double{spot.share};
    if (spot.seen_past > 0) {
      rest_with(spot).past += double{spot.share};
    } else {
      not_seen_past_.push_back(i);
    }
  }

  Rest& rest_with(const Spot& spot) { return spot.went_alone ? alone_rest_ : spot.hung_before ? hung_rest_ : rest_; }

  Remembered& thing_;
  const Pixels& picture_;
  const NearFloor& floor_;
  const Axis& axis_;
  std::vector<Evidence> said_;  ///< of each of the lost
  bool between_rays_ = false, floor_between_ = false;
  Rest rest_, hung_rest_, alone_rest_;
  double leaving_ = 0.0;  ///< [m2] of those that stay
  std::vector<std::size_t> not_seen_past_;
};

}  // namespace

void forgive(Remembered& thing, const Pixels& picture, const NearFloor& floor, const Axis& axis) {
  Forgiving forgiving(thing, picture, floor, axis);
  forgiving.drop_what_has_gone();
  forgiving.drop_the_rest();
}

}  // namespace safety_control_cloud
