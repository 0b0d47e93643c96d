// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "camera_pose.hpp"
#include "pixels.hpp"

namespace safety_control_cloud {

/// What is seen behind what comes near, on a lattice of an organised picture. What is too near to return and moves
/// makes a hole in it that was not there.
class Backdrop {
 public:
  /// A place of the lattice.
  struct Place {
    std::size_t row = 0, column = 0;  ///< of the picture
    float right = 0.0f, down = 0.0f;  ///< of straight ahead, per metre
  };

  /// Some of the picture's rows and columns, the last ones with it.
  struct Part {
    double first_row = 0.0, last_row = 0.0, first_column = 0.0, last_column = 0.0;

    bool holds(std::size_t row, std::size_t column) const;
  };

  /// The next picture. What is known behind and around what is `lost`, for which the robot stands, rests: what the
  /// picture does not show there any more is hidden. Elsewhere it has gone, as it has where the robot drives on.
  void note(const Pixels& picture, const CameraPose& camera, const std::vector<Part>& lost);

  /// Where a picture shows a hole in what is behind, which goes on beside it. A shadow is none, since what casts it is
  /// seen beside it, nor is what has never returned.
  std::vector<Place> hidden_in(const Pixels& picture) const;

  /// So many of the 3 x 3 pixels around a place return, if it does.
  static constexpr std::uint8_t dense = 6;

  /// Whether it knows what is behind what a camera shows there.
  bool is_seen_from(const CameraPose& camera) const;

  /// Of the picture, that a place stands for.
  std::size_t pixels_each() const { return step_ * step_; }

 private:
  struct Cell {
    Point behind;                 ///< in the cloud's frame
    std::int8_t returns = 0;      ///< more than are missing, of late; less: below 0
    std::uint8_t nearer_for = 0;  ///< so many pictures have shown something nearer

    bool is_known() const;
  };
  struct Shown;
  /// Cells that lie side by side.
  struct Line {
    std::size_t first, apart, size;

    std::size_t operator[](std::size_t i) const { return first + i * apart; }
  };
  enum class End { Open, GoesOn, Differs };

  /// Of a column or row of the lattice, in the picture.
  std::size_t middle(std::size_t i) const { return step_ / 2 + i * step_; }
  Place place_of(std::size_t cell) const;
  static void note_at(Cell& cell, const Point& point, bool rests);
  Shown shown_at(const Pixels& picture, std::size_t cell) const;
  End end_of(const std::vector<Shown>& shown, const Line& line, std::ptrdiff_t at, std::ptrdiff_t outward,
             std::size_t last) const;
  void mark_holes(const std::vector<Shown>& shown, const Line& line, std::vector<std::uint8_t>& marks) const;

  std::size_t step_ = 1, columns_ = 0, next_row_ = 0;
  std::vector<Cell> cells_;
  CameraPose camera_;
};

}  // namespace safety_control_cloud
