// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace safety_control_cloud {

/// In which cells of a raster anything returns at all: between the lines of a lidar, and above the curve of the
/// uppermost, nothing ever does. A hole there says nothing. A cell that has returned in a good part of some successive
/// pictures is a usual one for good, whatever hides it later; and until enough pictures of it have come in which
/// nothing near was remembered, every cell is.
class UsualCells {
 public:
  /// The next picture, cell by cell of one grid, NaN where nothing returns.
  void note(const std::vector<std::array<float, 3>>& cells, std::size_t width, bool anything_near);

  /// A larger grid of such cells begins, with so many new rows and columns before the first.
  struct Growth {
    std::size_t above, left, height, width;
  };
  void grow(const Growth& growth);

  /// Another grid begins.
  void forget() { *this = UsualCells(); }

  /// Whether enough pictures have come to know of any that it is one.
  bool any_known() const { return pictures_ >= some; }

  /// Whether pictures are wanted in which nothing is near.
  bool learns() const { return learns_; }

  bool never_returns(std::size_t cell) const {
    return cell < cells_.size() && cells_[cell].free == enough && !cells_[cell].usual;
  }

 private:
  static constexpr std::uint8_t some = 16, enough = 4 * some;  ///< pictures
  static constexpr std::uint8_t many_of_some = 6;

  struct Cell {
    std::uint8_t returned = 0;  ///< in so many of the latest pictures
    std::uint8_t free = 0;      ///< pictures in which nothing near was remembered
    bool usual = false;
  };

  std::size_t pictures_ = 0, width_ = 0;
  std::vector<Cell> cells_;
  bool learns_ = true;
};

}  // namespace safety_control_cloud
