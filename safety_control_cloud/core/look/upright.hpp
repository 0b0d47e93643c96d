// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "../input/view.hpp"
#include "outlook.hpp"

namespace safety_control_cloud {

/// The pictures of a camera that is placed, as they would be if it were mounted upright: its rows run down, its columns
/// to the right. Who looks for the floor below a thing need not know how the camera is rolled, by quarters of a turn,
/// nor in which order its driver sends the pixels.
class Upright {
 public:
  /// `view` may lie in a frame of its own, in which the camera is upright; `outlook` is of that.
  struct Picture {
    View view;
    Outlook outlook;
  };

  /// The same, if it is upright, or not placed, or no picture in rows and columns. What is turned is a copy, which
  /// lasts until the next.
  Picture of(const View& view, const Outlook& outlook);

  /// Whether the latest is a copy.
  bool is_turned() const { return is_turned_; }

  /// Of the latest picture, another corridor down which it looks.
  Outlook turned(const Outlook& outlook) const;

 private:
  /// By quarters, about the axis along which the camera looks.
  struct Roll {
    float cosine = 1.0f, sine = 0.0f;

    bool lies() const { return cosine == 0.0f; }
    /// What lies to the camera's right and below it lies so far to the right of an upright one, and below that.
    float right(float x, float y) const { return cosine * x + sine * y; }
    float down(float x, float y) const { return cosine * y - sine * x; }
  };

  void note_roll(const Placement& placement);
  void note_order(const View& view);
  View copied(const View& view);

  Roll roll_;
  bool columns_fall_ = false, rows_fall_ = false;  ///< as far as is known: x/z over the columns, y/z over the rows
  bool is_turned_ = false;                         ///< the latest picture
  std::vector<std::array<float, 3>> points_;
};

}  // namespace safety_control_cloud
