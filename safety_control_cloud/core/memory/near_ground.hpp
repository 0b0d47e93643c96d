// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../look/outlook.hpp"
#include "kernel/lines.hpp"
#include "pixels.hpp"

namespace safety_control_cloud {

/// The lower part of a picture, as far as it shows near ground: what lies below the corridor. Only every n-th row and
/// column are read; they are counted here from the lowest row up, and from the left.
class NearGround {
 public:
  using Code = std::int16_t;
  static constexpr Code nothing = lines::ReturnsNothing;  ///< returns
  static constexpr Code elsewhere =
      lines::ReturnsElsewhere;                      ///< a return from farther away or from beside the corridor
  static constexpr Code near = lines::ReturnsNear;  ///< something near, in the corridor
  // From 0 on: near ground, as many [mm] below the camera.

  /// So many rows, and columns, of a picture that has more.
  static constexpr std::size_t most_rows = 120, most_columns = 160;

  /// From one column that is read of a picture as wide as this to the next.
  static std::size_t column_step_of(std::size_t width) { return std::max<std::size_t>(1, width / most_columns); }

  /// Nearer than `distance` [m] ahead of the camera is near. Of `rows_to_read` from the lowest up all columns are read,
  /// whatever they show: each for itself may return nothing, by chance.
  void look_at(const Pixels& picture, const Outlook& outlook, float distance, std::size_t rows_to_read);

  std::size_t rows() const { return rows_; }  ///< that were read
  std::size_t columns() const { return columns_; }
  Code* row(std::size_t i) { return codes_.data() + i * columns_; }
  const Code* row(std::size_t i) const { return codes_.data() + i * columns_; }
  /// Whether any of a row's columns may show near ground. Then it is whole.
  bool shows_ground(std::size_t i) const { return shows_[i]; }
  /// Whether all of a row's columns were read.
  bool is_whole(std::size_t i) const { return whole_[i]; }
  /// Of such a row, how far ahead each column's return is, whatever it is [m]; NaN where there is none.
  const float* ahead(std::size_t i) const { return ahead_.data() + i * columns_; }
  std::size_t row_step() const { return row_step_; }  ///< of the picture, from one that is read to the next
  float distance() const { return distance_; }        ///< [m] ahead of the camera; what is nearer is near
  std::size_t picture_row(std::size_t i) const { return height_ - 1 - i * row_step_; }
  std::size_t picture_column(std::size_t i) const { return i * column_step_; }
  /// The lowest that lies no higher than one of the picture.
  std::size_t row_at(std::size_t picture_row) const { return quotient(height_ - 1 - picture_row, row_step_); }
  std::size_t column_at(std::size_t picture_column) const {
    return std::min(columns_ - 1, quotient(picture_column, column_step_));
  }
  double middle_column() const { return middle_column_; }  ///< that looks straight ahead
  /// Whether something near, in the corridor, is seen in a column, anywhere in the picture.
  bool is_near(std::size_t column) const { return near_[column]; }
  void note_near(std::size_t column) { near_[column] = true; }

 private:
  enum class Columns { All, Probes };

  /// Of what counts rows or columns: of 64 bits it would take many processors twice as long or thrice.
  static std::size_t quotient(std::size_t some, std::size_t by) {
    return static_cast<std::uint32_t>(some) / static_cast<std::uint32_t>(by);
  }

  bool read_row(const Pixels& picture, const Outlook& outlook, float distance, std::size_t number, Columns which);

  // Of one row, as far as it is read.
  PixelRow read_;
  std::vector<Code> codes_read_;
  std::vector<Code> codes_;
  std::vector<float> ahead_;
  std::vector<char> shows_, whole_;  ///< of each row
  std::vector<char> near_;
  std::size_t rows_ = 0, columns_ = 0, height_ = 0, row_step_ = 1, column_step_ = 1;
  double middle_column_ = 0.0;
  float distance_ = 0.0f;
};

}  // namespace safety_control_cloud
