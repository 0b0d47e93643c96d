// SPDX-License-Identifier: BSD-3-Clause
#include "margins.hpp"

#include <cmath>

namespace safety_control_cloud {
namespace {

constexpr std::size_t share = 8;  ///< of the picture's width or height a margin takes at most: 1/share
/// A line that returns in as many of so many pictures is none of the margin: more than the stray returns of an empty
/// one.
constexpr std::size_t some = 16;
constexpr std::uint8_t many_of_some = 6;
constexpr std::size_t enough = 4 * some;  ///< pictures until a line that has not returned counts as one that never does

/// Another place along a line in each picture, spread by the golden ratio.
std::size_t place_along(std::size_t size, std::size_t picture) {
  const double part = std::fmod(0.618034 * static_cast<double>(picture), 1.0);
  return static_cast<std::size_t>(part * static_cast<double>(size));
}

}  // namespace

Framing Margins::note(const Pixels& picture) {
  if (picture.width() != width_ || picture.height() != height_) {
    width_ = picture.width(), height_ = picture.height();
    pictures_ = 0;
    for (std::size_t side = 0; side < sides_.size(); ++side) {
      sides_[side].empty = (side == Left || side == Right ? width_ : height_) / share;
      sides_[side].returned.assign(sides_[side].empty, 0);
    }
  }
  const std::size_t row = place_along(height_, pictures_), column = place_along(width_, pictures_);
  const auto look_at = [&](Side& side, auto point_of_line) {
    for (std::size_t line = 0; line < side.empty; ++line) {
      side.returned[line] = static_cast<std::uint8_t>(side.returned[line] + returned(point_of_line(line)));
    }
  };
  look_at(sides_[Left], [&](std::size_t line) { return picture.at(row, line); });
  look_at(sides_[Top], [&](std::size_t line) { return picture.at(line, column); });
  look_at(sides_[Right], [&](std::size_t line) { return picture.at(row, width_ - 1 - line); });
  look_at(sides_[Bottom], [&](std::size_t line) { return picture.at(height_ - 1 - line, column); });
  ++pictures_;
  if (pictures_ % some == 0) {
    for (Side& side : sides_) {
      for (std::size_t line = side.empty; line-- > 0;) {
        if (side.returned[line] >= many_of_some) side.empty = line;
        side.returned[line] = 0;
      }
    }
  }
  Framing framing = picture.framing();
  if (pictures_ >= enough) {
    framing.left = sides_[Left].empty, framing.top = sides_[Top].empty;
    framing.right = sides_[Right].empty, framing.bottom = sides_[Bottom].empty;
  }
  return framing;
}

}  // namespace safety_control_cloud
