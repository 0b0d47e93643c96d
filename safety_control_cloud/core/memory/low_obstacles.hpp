// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "frame.hpp"
#include "loss.hpp"
#include "near_ground.hpp"
#include "patience.hpp"
#include "step_columns.hpp"

namespace safety_control_cloud {

/// What stands on the near floor and ends below the corridor: a kerb, a step, a shoe. Nearer, the camera looks over it,
/// so it is kept from when it is first seen until the floor before it is seen again, be that beside the corridor, which
/// the rays at its sides leave before they reach the floor.
///
/// In a pixel column it is a step: from the lowest pixel up, the near ground rises at once. Both are seen in one cloud,
/// so that neither a slope nor a bump of the robot looks like one. Where something near is seen in the corridor too,
/// the step is the foot of that, and its distance decides.
///
/// A step is kept by what two clouds in a row show lowest before it, since there may be strays, and two in a row have
/// to show the floor again before it is forgotten: as low in the picture as the step, since a camera sees the floor
/// behind what has come too near to return; after a pause, as low as the step may have come meanwhile.
///
/// What another picture does not show any more, because it ends higher or farther inward, stays.
class LowObstacles {
 public:
  /// The nearest in the latest cloud, if one is at least as wide as a thin post. It is lost as a whole, or about to be,
  /// if it is so near that the floor before it is not seen any more; in each column, for as long as patience lasts.
  /// `nearer` [m] than in the picture before: so much it may have come, if that was a pause ago, or else 0.
  std::optional<Loss> judge(const NearGround& ground, const Pixels& picture, const Outlook& outlook,
                            const Patience& patience, float nearer);

  /// Of a picture that shows too little to forget anything: what is seen in it is kept.
  void note(const NearGround& ground, const Pixels& picture, const Outlook& outlook);

  /// The next picture lies in this frame.
  void move_to(const Frame& frame);

  /// The corridor is another one. What is kept stays, but where the next cloud shows that it lies beside it.
  void change_corridor() { is_corridor_new_ = true; }
  /// The camera is so high [m] in the next picture, in the corridor's axes, or by `off` higher: on a mast that goes up,
  /// the floor before a step goes down.
  void move_to(float camera_height, float off);
  /// It is so in other axes.
  void change_axes() { camera_height_.reset(); }

  /// Of each column, the floor before a step that is kept [mm below the camera]; 0 if there is none.
  const std::vector<NearGround::Code>& floor() const { return floor_; }
  /// Whether there are others, beside the picture.
  bool any_beside() const { return !beside_.empty(); }
  /// As another process knew it, of a camera that was so high [m].
  void restore(std::vector<NearGround::Code> floor, float camera_height) {
    floor_ = std::move(floor), camera_height_ = camera_height;
    steps_.clear();
  }

 private:
  using Millimetres = StepColumns::Millimetres;

  /// A column with a step, that the picture does not show.
  struct Beside {
    double from, to;                     ///< x/z of its sides
    double lowest;                       ///< y/z at the lower border of the picture that showed it
    Millimetres floor;                   ///< before it
    std::optional<double> hidden_since;  ///< [s] steady: that; none: since the next picture
  };

  /// Of a column with a step that is kept, as far as that is known.
  struct Step {
    StepColumns::Row row = StepColumns::no_row;      ///< the lowest that has shown it
    Point at;                                        ///< in the latest picture that did, in the corridor's axes [m]
    StepColumns::Row came_to = StepColumns::no_row;  ///< as low as that it may be by now, and no picture since shows it
  };

  std::vector<Beside> all_steps() const;
  bool shows(const Beside& step) const;
  void survey(const NearGround& ground, const Pixels& picture, const Outlook& outlook);
  void let_come(float nearer, const NearGround& ground, const Outlook& outlook);
  void look_beside(const NearGround& ground, const Pixels& picture, const Outlook& outlook);
  void forget_old(const Patience& patience);
  bool is_as_low_as_step(std::size_t column) const;
  bool is_kept(std::size_t column) const { return floor_[column] > 0; }
  bool is_step(std::size_t column) const { return floor_before(column) > 0; }
  Millimetres floor_before(std::size_t column) const { return std::max(floor_[column], shown_[column]); }
  bool hides_floor(std::size_t column) const;
  void drop_what_lies_beside(const NearGround& ground, const Pixels& picture, const Outlook& outlook);
  /// Of what the columns that show a step have lowest on it; none if all of it has gone out of the picture.
  std::optional<Obstacle> nearest(const NearGround& ground, const Pixels& picture, const Outlook& outlook) const;

  Frame frame_;
  std::vector<Beside> beside_;
  StepColumns columns_;  ///< of the latest picture
  // Of each column.
  std::vector<Millimetres> floor_;  ///< before a step that is kept; 0 if there is none
  std::vector<Millimetres> shown_;  ///< before a step that this cloud shows; 0 if it shows none
  std::vector<Step> steps_;
  std::vector<double> hidden_since_;    ///< [s] steady: the floor before it
  bool is_corridor_new_ = false;        ///< and no cloud has come since
  std::optional<float> camera_height_;  ///< [m] as `floor_` is told; none: no picture has come
  Millimetres off_ = 0;                 ///< by which the floor may lie lower than `floor_` tells
};

}  // namespace safety_control_cloud
