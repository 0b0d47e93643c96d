// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "evidence.hpp"
#include "near_ground.hpp"
#include "thing.hpp"

namespace safety_control_cloud {

/// As much of the picture's height may return nothing between a thing and the floor that it stands on: 1/share.
constexpr std::size_t blank_share = 24;

/// A picture, and what its lower part shows of near ground. Borrowed.
struct GroundPicture {
  const NearGround& ground;
  const Pixels& picture;
  const Outlook& outlook;

  Point placed_at(std::size_t row, std::size_t column) const { return placed(picture.at(row, column), outlook); }
  float ahead(const Point& placed) const { return placed.z - outlook.camera().z; }  ///< [m] of the camera
};

/// Whether what is so far ahead of the camera [m] may be the thing that has this foot.
inline bool may_be_of(const Foot& foot, float ahead) { return std::abs(ahead - foot.ahead) <= noise_at(foot.ahead); }

/// On the near floor; unseen where nothing returns below it, or what is seen there is no farther away: its foot may
/// stand beside the corridor.
enum class Stand { Hangs, Stands, Unseen };

/// What a picture shows in the column in which a thing has its foot, or in one beside that, in the rows that are read,
/// from the lowest up. Which pixels return is as good as random: what is asked of each is asked without a branch.
class ColumnBelow {
 public:
  ColumnBelow(const Foot& foot, std::size_t column, const GroundPicture& shown);

  Stand stand() const;

  /// Whether something too near to return hides all that this column would show, from the foot's row down.
  bool is_hidden() const;

 private:
  using Code = NearGround::Code;

  struct Seen {
    Code code;
    float ahead;  ///< [m]
  };

  /// What all of the rows below one show.
  struct Below {
    std::size_t blank = 0, others = 0;  ///< so many return nothing, or what is neither ground nor the thing
    std::optional<Seen> other, ground;  ///< the uppermost of these
    bool gap = false;                   ///< too many that follow one another show neither ground nor anything near
  };

  static bool is_near(const Seen& seen) { return seen.code == NearGround::near; }
  bool is_of_thing(const Seen& seen) const { return may_be_of(foot_, seen.ahead); }
  bool is_farther(const Seen& seen) const { return !(seen.ahead <= foot_.ahead + noise_at(foot_.ahead)); }
  float ahead_in(std::size_t i) const;
  Seen seen_in(std::size_t i) const;
  Below below_row(std::size_t lowest) const;
  std::size_t lowest_from(std::size_t lowest) const;
  std::optional<std::size_t> surface_below(std::size_t lowest) const;

  const Foot& foot_;
  const GroundPicture& shown_;
  const NearGround& ground_;
  const std::size_t column_;
  const std::size_t most_blank_;  ///< so many rows that follow one another may return nothing above the floor
};

}  // namespace safety_control_cloud
