// SPDX-License-Identifier: BSD-3-Clause
#include "stand.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "evidence.hpp"

namespace safety_control_cloud {
namespace {

/// As much of the picture's height may return nothing between a thing and the floor that it stands on: 1/share.
constexpr std::size_t blank_share = 24;
/// Strays return one by one, at any range; as many rows that are read in which one goes on show something.
constexpr std::size_t no_strays = 3;
constexpr float agreement = 0.15f;  ///< share by which the floor's range changes from one of them to the next

/// The edge of what stands upright leans in the picture, as the robot pitches, by at most this share of its width: what
/// a column shows near the edge reaches the floor in another one.
constexpr std::size_t edge_share = 128;
/// Of the rows below an edge, so many may show a stray return where something too near hides the floor: 1/share.
constexpr std::size_t stray_share = 6;

using Code = NearGround::Code;

/// On the near floor; unseen where nothing returns below it, or what is seen there is no farther away: its foot may
/// stand beside the corridor.
enum class Stand { Hangs, Stands, Unseen };

/// What a picture shows in the column in which a thing has its foot, in the rows that are read, from the lowest up.
/// Which pixels return is as good as random: what is asked of each is asked without a branch.
class ColumnBelow {
 public:
  /// `most_blank`: so many rows that follow one another may return nothing between a thing and the floor.
  ColumnBelow(const Foot& foot, std::size_t column, std::size_t most_blank, const NearGround& ground,
              const Pixels& picture, const Outlook& outlook)
      : foot_(foot),
        ground_(ground),
        picture_(picture),
        outlook_(outlook),
        column_(column),
        most_blank_(most_blank),
        noise_(noise_at(foot.ahead)) {}

  Stand stand() const {
    std::size_t lowest = ground_.row_at(foot_.row);
    const auto surface = surface_below(lowest);
    auto other = surface ? std::optional<Seen>(seen_in(*surface)) : std::nullopt;
    if (!other || is_near(*other) || !is_farther(*other)) {
      lowest = lowest_from(lowest);
      if (other && *surface >= lowest) other.reset();
    }
    const Below below = other ? Below() : below_row(lowest);
    // Where no surface goes on, something else than ground may show in much of what is below the thing.
    if (2 * below.others > below.blank) other = below.other;
    // What reaches the floor below its foot is another thing.
    if (other) return is_near(*other) || is_farther(*other) ? Stand::Hangs : Stand::Unseen;
    if (!below.gap && lowest < ground_.rows()) return Stand::Stands;
    return below.gap && !(below.ground && is_farther(*below.ground)) ? Stand::Unseen : Stand::Hangs;
  }

  /// Whether what has this foot goes on in this column.
  bool goes_on() const {
    const Point place = placed(picture_.at(foot_.row, ground_.picture_column(column_)), outlook_);
    return std::abs(place.z - outlook_.camera().z - foot_.ahead) <= noise_;
  }

  /// Whether something too near to return hides all that this column would show, from the foot's row down.
  bool is_hidden() const {
    const std::size_t rows = std::min(ground_.row_at(foot_.row), ground_.rows());
    return rows > 0 && !goes_on() && !surface_below(rows) &&
           below_row(rows).blank * stray_share >= rows * (stray_share - 1);
  }

 private:
  struct Seen {
    Code code;
    float ahead;  ///< [m]
  };
  static bool is_near(const Seen& seen) { return seen.code == NearGround::near; }

  /// Above the ground, only some of the columns have been read.
  Seen seen_in(std::size_t i) const {
    if (ground_.shows_ground(i)) return {ground_.row(i)[column_], ground_.ahead(i)[column_]};
    const Point place = placed(picture_.at(ground_.picture_row(i), ground_.picture_column(column_)), outlook_);
    const float ahead = place.z - outlook_.camera().z;
    if (!returned(place)) return {NearGround::nothing, ahead};
    return {outlook_.corridor.holds(place) && ahead < ground_.distance() ? NearGround::near : NearGround::elsewhere,
            ahead};
  }

  /// What all of the rows below one show.
  struct Below {
    std::size_t blank = 0, others = 0;  ///< so many return nothing, or what is neither ground nor the thing
    std::optional<Seen> other, ground;  ///< the uppermost of these
    bool gap = false;                   ///< too many that follow one another show neither ground nor anything near
  };

  Below below_row(std::size_t lowest) const {
    Below below;
    std::size_t missing = 0;
    for (std::size_t i = 0; i < std::min(lowest, ground_.rows()); ++i) {
      const Seen seen = seen_in(i);
      const bool is_ground = seen.code >= 0;
      const bool is_other = seen.code == NearGround::elsewhere || (is_near(seen) && !is_of_thing(seen));
      below.blank += seen.code == NearGround::nothing;
      below.others += is_other;
      if (is_other) below.other = seen;
      if (is_ground) below.ground = seen;
      missing = is_ground || is_near(seen) ? 0 : missing + 1;
      below.gap = below.gap || missing > most_blank_;
    }
    return below;
  }

  /// Whether what is seen may be the thing that has this foot.
  bool is_of_thing(const Seen& seen) const { return std::abs(seen.ahead - foot_.ahead) <= noise_; }
  bool is_farther(const Seen& seen) const { return !(seen.ahead <= foot_.ahead + noise_); }

  /// The lowest row in which the thing is seen, from that of its foot down. Its border, if it is about to be too near,
  /// returns here and there alone.
  std::size_t lowest_from(std::size_t lowest) const {
    std::size_t others = 0;
    for (std::size_t i = lowest; i-- > 0 && lowest - i <= most_blank_ + 1 && others < no_strays;) {
      const Seen seen = seen_in(i);
      const bool same = is_of_thing(seen), is_other = !same & (seen.code != NearGround::nothing);
      others = (others + 1) * is_other;
      lowest = same ? i : lowest;
    }
    return lowest;
  }

  /// The first row below `lowest` in which it shows a surface, and no ground: rows that follow one another agree,
  /// unlike strays.
  std::optional<std::size_t> surface_below(std::size_t lowest) const {
    std::size_t adjacent = 0;
    for (std::size_t i = 0; i < std::min(lowest, ground_.rows()); ++i) {
      const Code code = ground_.row(i)[column_];
      adjacent = code == NearGround::elsewhere || code == NearGround::near ? adjacent + 1 : 0;
      if (adjacent < no_strays) continue;
      const float ahead = seen_in(i).ahead, before = seen_in(i - 1).ahead;
      if (std::abs(ahead - before) <= agreement * std::min(ahead, before)) return i;
    }
    return std::nullopt;
  }

  const Foot& foot_;
  const NearGround& ground_;
  const Pixels& picture_;
  const Outlook& outlook_;
  const std::size_t column_, most_blank_;
  const float noise_;  ///< [m]
};

/// What stands under one foot, by its own column or those beside it.
class FootBelow {
 public:
  FootBelow(const Foot& foot, std::size_t edge, std::size_t most_blank, const NearGround& ground, const Pixels& picture,
            const Outlook& outlook)
      : foot_(foot), edge_(edge), most_blank_(most_blank), ground_(ground), picture_(picture), outlook_(outlook) {}

  Stand stand() const {
    const std::size_t column = ground_.column_at(foot_.column);
    const Stand own = below(column).stand();
    if (own != Stand::Hangs || !is_edge()) return own;
    const std::size_t first = column - std::min(edge_, column), last = std::min(column + edge_, ground_.columns() - 1);
    for (std::size_t i = first; i <= last; ++i)
      if (below(i).is_hidden()) return Stand::Unseen;
    return own;
  }

  /// Whether the picture shows no more of it here than the edge of something that is itself too near to return.
  bool is_edge() const {
    const std::size_t most = edge_ * (ground_.picture_column(1) - ground_.picture_column(0));
    return 1 + run<-1>(most) + run<+1>(most) <= most;
  }

 private:
  ColumnBelow below(std::size_t column) const { return {foot_, column, most_blank_, ground_, picture_, outlook_}; }

  /// So many pixels beside it, `most` at most, show it too.
  template <int Way>
  std::size_t run(std::size_t most) const {
    std::size_t pixels = 0, column = foot_.column;
    while (pixels < most && (Way < 0 ? column > 0 : column + 1 < picture_.width())) {
      column += static_cast<std::size_t>(Way);
      const Point place = placed(picture_.at(foot_.row, column), outlook_);
      if (!(std::abs(place.z - outlook_.camera().z - foot_.ahead) <= noise_at(foot_.ahead))) break;
      ++pixels;
    }
    return pixels;
  }

  const Foot& foot_;
  const std::size_t edge_, most_blank_;
  const NearGround& ground_;
  const Pixels& picture_;
  const Outlook& outlook_;
};

}  // namespace

void place_on_ground(std::vector<Thing>& things, NearGround& ground, const Pixels& picture, const Outlook& outlook) {
  const std::size_t columns = ground.columns(), edge = std::max<std::size_t>(1, columns / edge_share);
  const std::size_t height = picture.height();
  const std::size_t most_blank = std::max<std::size_t>(1, height / ground.row_step() / blank_share);
  // What ends with the picture stands, though it be so thin that the column which is read shows the floor beside it.
  const std::size_t at_the_end = 2 * ground.row_step() + height / blank_share;
  for (Thing& thing : things) {
    std::vector<char> stands(columns, false), unseen(columns, false);
    std::size_t standing = 0, hanging = 0;
    thing.is_edge = !thing.feet.empty();
    for (const Foot& foot : thing.feet) {
      const std::size_t column = ground.column_at(foot.column);
      if (foot.ahead < ground.distance()) ground.note_near(column);
      const FootBelow below(foot, edge, most_blank, ground, picture, outlook);
      const Stand stand = foot.row + at_the_end >= height ? Stand::Stands : below.stand();
      thing.is_edge = thing.is_edge && stand != Stand::Hangs && below.is_edge();
      standing += stand == Stand::Stands;
      hanging += stand == Stand::Hangs;
      for (std::size_t i = column - std::min(edge, column); i <= std::min(column + edge, columns - 1); ++i) {
        stands[i] = stands[i] || stand == Stand::Stands;
        unseen[i] = unseen[i] || stand == Stand::Unseen;
      }
    }
    thing.stands = 2 * standing >= thing.feet.size();
    thing.hangs = 2 * hanging > thing.feet.size();
    for (Spot& spot : thing.spots) {
      const std::size_t column = ground.column_at(spot.column);
      const bool juts_out = spot.overhang >= clear_overhang;
      spot.stands = stands[column] && !juts_out;
      spot.foot_unseen = unseen[column] && !juts_out;
    }
  }
}

}  // namespace safety_control_cloud
