// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace safety_control_cloud {

/// A picture's depths [m], row by row.
struct Depths {
  std::size_t width = 0, height = 0;
  std::vector<float> z;
};

/// What was near in a picture that the robot looked at, where nothing has returned since: a plain watch, which gives up
/// wherever it might be that something was seen to go.
class Shown {
 public:
  /// A picture that the robot has looked at, as the decision's cause says.
  void note(const Depths& picture) {
    if (!stands_for(picture)) lone_thing_in(picture);
  }

  /// Whether the robot has to stand before this picture, since what was near has not returned, nor been seen past.
  bool stands_for(const Depths& picture) const {
    if (pixels_.empty() || picture.width != width_ || picture.height != height_) return false;
    const auto is_blank = [&](std::size_t pixel) { return std::isnan(picture.z[pixel]); };
    const auto is_far = [](float z) { return std::isnan(z) || (z > far && std::isfinite(z)); };
    return std::all_of(pixels_.begin(), pixels_.end(), is_blank) &&
           std::all_of(picture.z.begin(), picture.z.end(), is_far);
  }

  void forget() { pixels_.clear(); }

 private:
  static constexpr float nearest = 0.3f, near = 0.6f, far = 1.2f;  ///< [m]
  static constexpr std::size_t least = 6;                          ///< pixels across and down

  /// A rectangle of near pixels in the middle of the picture, before nothing that is near too.
  void lone_thing_in(const Depths& picture) {
    forget();
    std::size_t left = picture.width, right = 0, top = picture.height, bottom = 0;
    for (std::size_t pixel = 0; pixel < picture.z.size(); ++pixel) {
      const float z = picture.z[pixel];
      if (std::isnan(z) || (z > far && std::isfinite(z))) continue;
      if (!(z > nearest && z < near)) return forget();
      const std::size_t column = pixel % picture.width, row = pixel / picture.width;
      left = std::min(left, column), right = std::max(right, column);
      top = std::min(top, row), bottom = std::max(bottom, row);
      pixels_.push_back(pixel);
    }
    width_ = picture.width, height_ = picture.height;
    const bool in_the_middle =
        4 * left > width_ && 4 * right < 3 * width_ && 4 * top > height_ && 4 * bottom < 3 * height_;
    const bool whole = right >= left + least - 1 && bottom >= top + least - 1 &&
                       pixels_.size() == (right - left + 1) * (bottom - top + 1);
    if (pixels_.empty() || !in_the_middle || !whole || !is_one(picture)) forget();
  }

  /// Whether its depths differ by no more than one thing's.
  bool is_one(const Depths& picture) const {
    const auto nearer = [&](std::size_t a, std::size_t b) { return picture.z[a] < picture.z[b]; };
    const auto [first, last] = std::minmax_element(pixels_.begin(), pixels_.end(), nearer);
    return picture.z[*last] - picture.z[*first] < 0.05f;
  }

  std::vector<std::size_t> pixels_;
  std::size_t width_ = 0, height_ = 0;
};

}  // namespace safety_control_cloud
