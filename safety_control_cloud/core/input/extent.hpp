// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace safety_control_cloud {

/// How far one thing lies behind the other, and what the message calls that.
struct ClaimedStep {
  const char* name;
  std::uint64_t bytes;  ///< a claim of 32 bits
};

/// What a message claims of the rows in its data.
struct Extent {
  std::uint32_t height;
  std::uint32_t width;
  ClaimedStep point;  ///< from one point or pixel to the next
  ClaimedStep row;    ///< from one row to the next
};

/// Why `size` bytes cannot be these rows, with none missing and none over.
std::optional<std::string> problem_with(const Extent& extent, std::uint64_t size);

/// The rows that there is something in to look at.
std::size_t rows_in(const Extent& extent);

}  // namespace safety_control_cloud
