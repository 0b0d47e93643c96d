// SPDX-License-Identifier: BSD-3-Clause
#include "extent.hpp"

#include "../text/words.hpp"

namespace safety_control_cloud {

/// 64-bit products of 32-bit claims: none of them can wrap.
std::optional<std::string> problem_with(const Extent& extent, std::uint64_t size) {
  const auto& [height, width, point, row] = extent;
  const std::uint64_t row_bytes = width * point.bytes, all_bytes = height * row.bytes;
  if (row.bytes < row_bytes) {
    return words(row.name, " ", row.bytes, " is less than width x ", point.name, " = ", row_bytes);
  }
  if (size != all_bytes) return words("data has ", size, " bytes, not height x ", row.name, " = ", all_bytes);
  return std::nullopt;
}

/// Four billion empty rows need no byte, and would take seconds.
std::size_t rows_in(const Extent& extent) { return extent.width == 0 ? 0 : extent.height; }

}  // namespace safety_control_cloud
