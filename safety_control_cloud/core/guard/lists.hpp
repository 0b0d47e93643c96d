// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace safety_control_cloud {

/// Lists of numbers as people write them, "[[0.2, 0.1], [-0.2, 0.1], [0.0, -0.1]]"; empty text: no list.
struct Lists {
  std::string text;
};

inline bool operator==(const Lists& a, const Lists& b) { return a.text == b.text; }

/// The numbers, if the text is such lists of `width` numbers each and nothing else.
std::optional<std::vector<std::vector<double>>> lists_in(const Lists& lists, std::size_t width);

}  // namespace safety_control_cloud
