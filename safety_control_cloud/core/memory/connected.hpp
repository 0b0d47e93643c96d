// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "near_pixels.hpp"

namespace safety_control_cloud {

using Index = std::uint32_t;  ///< of a pixel among those found
constexpr Index no_index = std::numeric_limits<Index>::max();

/// Some of the pixels, in their order.
using Members = std::vector<Index>;

/// Which of some numbers are connected.
class Union {
 public:
  Index add() {
    parent_.push_back(static_cast<Index>(parent_.size()));
    return parent_.back();
  }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    const Index one = root(a), other = root(b);
    parent_[std::max(one, other)] = std::min(one, other);
  }
  std::size_t size() const { return parent_.size(); }

 private:
  std::vector<Index> parent_;
};

/// Which near pixels are one thing: they touch, and their ranges differ by no more than `jump` [m] from one to the
/// next. Borrows the pixels.
class Connected {
 public:
  Connected(const NearPixels& found, float jump);

  /// Those that are one, by the first of each.
  const std::vector<Members>& things() const { return things_; }

  /// Whether a pixel touches others of its thing on all sides.
  bool is_inner(Index pixel) const { return touched_[pixel] == All; }

 private:
  /// Sides on which a pixel touches another one of its thing.
  enum Side : std::uint8_t { Left = 1, Right = 2, Above = 4, Below = 8, All = 15 };

  /// One of the rows that were looked at: of each slot, and of one beside them, the pixel.
  struct Line {
    std::size_t row = 0;
    Members at = {};
  };

  /// Pixels that return nothing, or are mixed of two ranges, do not part a thing: as many slots and lines.
  static constexpr std::size_t gap = 2;

  void connect();
  void connect_along(Index begin, Index end);
  void connect_up(Index begin, Index end, const std::array<Line, gap + 1>& lines);
  std::vector<Members> together();

  const NearPixels& found_;
  const float jump_;
  Union runs_;
  // Of each pixel.
  std::vector<float> ahead_;
  std::vector<std::uint16_t> slot_;
  std::vector<Index> run_;
  std::vector<std::uint8_t> touched_;  ///< on which sides
  std::vector<Members> things_;
};

}  // namespace safety_control_cloud
