// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/lines.hpp"
#include "near_ground.hpp"

namespace safety_control_cloud {

/// What a picture shows in its columns of the near ground: the lowest of it, and what stands out of that. Strays may
/// lie lower than any floor, where that is too near to return, so the lowest is what two pixels beside each other show.
class StepColumns {
 public:
  using Millimetres = NearGround::Code;  ///< below the camera
  using Row = std::int16_t;              ///< of NearGround, from the lowest up

  /// Deeper than any near ground: there is none.
  static constexpr Millimetres none = lines::no_ground;
  static constexpr Row no_row = lines::no_row;

  static Millimetres ground_now(NearGround::Code code) { return code < 0 ? none : code; }
  static bool is_on_step(Millimetres ground, Millimetres floor) { return ground <= floor - step_height; }

  /// Of each column that has a step already, `kept` is the floor before that, or else 0.
  void look_at(const NearGround& ground, const std::vector<Millimetres>& kept);

  /// Beside the corridor it shows this lowest.
  void note_lowest(std::size_t column, Millimetres lowest, Row row) {
    lowest_[column] = lowest, lowest_row_[column] = row;
  }

  /// The near ground that it shows lowest now; `none` if it shows none.
  Millimetres lowest(std::size_t column) const { return lowest_[column]; }

  /// Of this picture and the one before, what both show; and the row in which they do.
  Millimetres lowest_of_two(std::size_t column) const {
    const Millimetres now = lowest_[column], before = lowest_before_[column];
    return now == none || before == none ? none : std::min(now, before);
  }
  Row lowest_row_of_two(std::size_t column) const { return std::max(lowest_row_[column], lowest_row_before_[column]); }

  /// Whether ground rises by a step. One pixel alone may be noise.
  bool rises(std::size_t column) const { return above_[column] >= 2; }
  /// The lowest row of that; `no_row` if there is none.
  Row first_above(std::size_t column) const { return first_above_[column]; }

 private:
  /// What is lower, a robot climbs [mm]: a Kobuki 12, and noise is not to stop it.
  static constexpr Millimetres step_height = 25;

  void look_at_row(Row number, const NearGround::Code* codes, const Millimetres* kept);

  // Of each column.
  std::vector<Millimetres> lowest_, lowest_before_;  ///< now, and in the picture before
  std::vector<Row> lowest_row_, lowest_row_before_;  ///< in which they lie
  std::vector<std::int16_t> above_;           ///< pixels that show ground a step above that, or above what is kept
  std::vector<Row> first_above_;              ///< the lowest of them
  std::vector<Millimetres> row_, row_below_;  ///< the ground of one row, with `none` at both ends, and of that below
};

}  // namespace safety_control_cloud
