// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace safety_control_cloud {

/// What the latest cloud left in a PixelMemory: who looks for what is near need not go through all pixels again.
struct NearPixels {
  std::vector<std::uint16_t> nearest_now;   ///< of each column: the nearest return; none if the code is not near
  std::vector<std::uint16_t> nearest_lost;  ///< of each row: the nearest that is lost; none if no near one is
  std::size_t now = 0;                      ///< pixels that return something near and in the corridor
  std::size_t lost = 0;  ///< pixels that return nothing, and last did something near and in the corridor
};

/// What every pixel of an organised cloud returned last, in 16 bits so that a VGA image of it stays in the L2 cache.
/// The low 15 bits are a code; the top bit is set if the pixel returned in the latest cloud.
///
///   [0, ground_zero)        a near return in the corridor, its distance in 0.1 mm
///   [ground_zero, elsewhere)  a near return from below the corridor, how far below the camera in 1 mm
///   elsewhere               a return from farther away or from beside the corridor
///   nothing                 no return yet
struct PixelMemory {
  static constexpr std::uint16_t now = 0x8000;
  static constexpr std::uint16_t nothing = 0x7FFF;
  static constexpr std::uint16_t none = nothing | now;  ///< more than any pixel
  static constexpr std::uint16_t elsewhere = 0x7FFE;
  static constexpr std::uint16_t ground_zero = 30000;
  static constexpr float near_per_metre = 10000.0f;
  static constexpr float ground_per_metre = 1000.0f;
  static constexpr double farthest = 2.7;  ///< [m] a greater `distance` would not fit into the codes

  float distance = 0.0f;  ///< [m] a return nearer than this is near
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint16_t> pixels;  ///< row by row
  NearPixels near;

  static std::uint16_t near_code(float z) { return rounded(z * near_per_metre); }
  static std::uint16_t ground_code(float y) {
    const float below = std::clamp(y, 0.0f, static_cast<float>(farthest));
    return static_cast<std::uint16_t>(ground_zero + rounded(below * ground_per_metre));
  }
  static std::uint16_t rounded(float value) { return static_cast<std::uint16_t>(std::nearbyint(value)); }
  static double distance_of_near(std::uint16_t code) { return code / double{near_per_metre}; }

  static bool is_now(std::uint16_t pixel) { return (pixel & now) != 0; }
  static std::uint16_t code_of(std::uint16_t pixel) { return static_cast<std::uint16_t>(pixel & ~now); }
  static bool is_near(std::uint16_t code) { return code < ground_zero; }
  static bool is_ground(std::uint16_t code) { return code >= ground_zero && code < elsewhere; }

  /// Whether something near is seen in this column, and in the corridor.
  bool is_near_now(std::size_t column) const { return is_near(near.nearest_now[column]); }

  const std::uint16_t* row(std::size_t i) const { return pixels.data() + i * width; }
  std::uint16_t* row(std::size_t i) { return pixels.data() + i * width; }

  /// Empties `near`, before a cloud comes.
  void start_cloud();
  /// Counts a piece of a row into `near`, after its pixels have been brought up to date.
  void note(std::size_t row, std::size_t column, std::size_t size);
  /// note() for pixels that may lie in several rows.
  void note(std::size_t first, std::size_t size) {
    for_each_piece(first, size,
                   [this](std::size_t row, std::size_t column, std::size_t some) { note(row, column, some); });
  }

  /// Calls visit(row, column, size) for the pieces of rows that the pixels [first, first + size) are.
  template <class Visit>
  void for_each_piece(std::size_t first, std::size_t size, Visit visit) const {
    for (const std::size_t end = first + size; first < end;) {
      const std::size_t row = first / width, column = first % width, some = std::min(width - column, end - first);
      visit(row, column, some);
      first += some;
    }
  }
};

}  // namespace safety_control_cloud
