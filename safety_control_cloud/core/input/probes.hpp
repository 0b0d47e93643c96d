// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "view.hpp"

namespace safety_control_cloud {

/// The middle of the i-th of `parts` of so many pixels.
constexpr std::size_t middle_of_part(std::size_t i, std::size_t parts, std::size_t pixels) {
  return (2 * i + 1) * pixels / (2 * parts);
}

/// How far away some pixels are, the same ones of each picture [m]; NaN where nothing returned, and of what is no
/// picture.
struct Probes {
  static constexpr std::size_t across = 8, down = 8;
  std::array<float, across * down> depths;

  Probes();
  explicit Probes(const View& view);
};

}  // namespace safety_control_cloud
