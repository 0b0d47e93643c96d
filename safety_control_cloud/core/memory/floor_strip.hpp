// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "blank_shares.hpp"
#include "loss.hpp"
#include "near_ground.hpp"
#include "patience.hpp"

namespace safety_control_cloud {

/// The near floor, in the lowest rows of a picture: a thing that is expected to return. What stands in a column nearer
/// than it hides it. Its rows are those, from the lowest that shows any ground up, whose lowest ground lies as low as
/// the floor's. How low the floor lies in a row is the lowest such return, soon forgotten where none lies as low again:
/// one bump of the robot must not make feet of the floor. What lies clearly higher is the foot of something. A row in
/// which all lie higher than the floor of another shows feet alone: the strip ends there.
class FloorStrip {
 public:
  /// Of one column, the pixels of the strip.
  struct Column {
    int shown;   ///< the floor, or something beyond it, is seen now
    int hidden;  ///< it is expected, and now it is not seen
  };

  /// For so many clouds a column that was mostly blank may count as that: strays fill it now and then.
  static constexpr std::uint8_t lately = 8;

  /// The camera is so high [m] in the next picture, in the corridor's axes. On a mast that goes down, a row looks at
  /// floor that is nearer, maybe too near to return: what was learned of it counts no more until it shows floor from
  /// there, or until the mast is up again; but what hides the floor does so still.
  void move_to(float camera_height);
  /// It is so in other axes.
  void change_axes() { camera_height_.reset(); }

  /// Finds the floor again in the latest picture. That it was ever seen in a column is forgotten once that has
  /// been blank for too long: what the picture shows by itself, a gap between floor and floor, is not.
  void survey(const NearGround& ground, const Patience& patience = {});

  const std::vector<std::size_t>& rows() const { return rows_; }  ///< of the picture, in which it lies
  /// So many of those that NearGround counts may show it.
  std::size_t rows_to_read() const;
  std::size_t columns() const { return shown_.size(); }
  Column column(std::size_t i) const { return {shown_[i], i < first_ || i >= last_ ? foot_[i] : foot_[i] + blank_[i]}; }

  /// Whether the floor is seen again in a column, and is blank nowhere right beside it and farther out: what stood in
  /// it may have come nearer, and what comes nearer grows and moves away from the middle of the picture.
  /// `among_strays`: blank is also what mostly was it lately.
  bool is_seen_again(std::size_t column, bool among_strays = false) const;

  /// Where the strip is blank over the width of a post: something stands nearer than the camera can see. In low light
  /// chance blanks as much now and then: there, over so many clouds that it does not. Above rows that return nothing
  /// only where the floor has been seen before: such a camera leaves gaps beside it too. From left to right; spans may
  /// overlap.
  std::vector<Span> covered() const;

 private:
  using Code = NearGround::Code;
  using Count = std::uint16_t;

  Code learned(const NearGround& ground, std::size_t row);
  void count_row(const NearGround& ground, std::size_t row);
  void expect(const Patience& patience);
  void note_blank();
  bool is_border(std::size_t column, std::size_t size) const;
  bool shows_floor(std::size_t i) const;

  std::optional<float> camera_height_;  ///< [m] as this was learned; none: no picture has come
  std::vector<float> seen_from_;        ///< [m] of each row, the least height of the camera from which it showed floor
  std::vector<Code> lowest_;            ///< ground of each row; 0 = none
  std::vector<std::size_t> rows_;
  double middle_ = 0.0;               ///< the column that looks straight ahead
  bool above_border_ = false;         ///< the lowest rows return nothing
  std::size_t first_ = 0, last_ = 0;  ///< the columns in which the floor is expected
  BlankShares blank_shares_;
  // Of each column.
  std::vector<Count> shown_;
  std::vector<Count> foot_;                 ///< return something nearer than the floor
  std::vector<Count> blank_;                ///< return nothing
  std::vector<std::uint8_t> blank_lately_;  ///< it was blank; in so many more clouds it counts as that
  std::vector<std::uint8_t> expected_;      ///< so many clouds have shown the floor, at most `certain`
  std::vector<double> blank_since_;         ///< [s] steady; now, if it is not
};

}  // namespace safety_control_cloud
