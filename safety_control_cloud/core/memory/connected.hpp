// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/lines.hpp"
#include "near_pixels.hpp"

namespace safety_control_cloud {

/// Which of some numbers are connected.
class Union {
 public:
  using Index = std::uint32_t;

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

/// Successive slots of one line [begin, end), all of whose pixels are of one thing; some may have none.
struct Stretch {
  NearPixels::Index begin, end;
};

/// All of one thing, line by line.
using Stretches = std::vector<Stretch>;

inline std::size_t size_of(const Stretch& some) { return some.end - some.begin; }

/// Which near pixels are one thing: they touch, and their ranges differ by no more than `jump` [m] from one to the
/// next. Borrows the pixels.
class Connected {
 public:
  using Index = NearPixels::Index;

  Connected(const NearPixels& found, float jump);

  /// Those that are one, line by line; of these, by the first of each.
  const std::vector<Stretches>& things() const { return things_; }

  /// Of each slot, on which sides its pixel touches others of its thing; and behind the last, a word of none.
  const std::vector<std::uint8_t>& touched() const { return touched_; }

  float jump() const { return jump_; }

 private:
  /// Pixels that return nothing, or are mixed of two ranges, do not part a thing: as many slots and lines.
  static constexpr std::size_t gap = 2;

  /// One of the rows that were looked at, with `gap` slots beside it in which nothing is.
  struct Line {
    std::size_t row = 0;
    std::vector<float> ahead;  ///< [m]
    std::vector<Index> run;    ///< of each pixel; of a slot without one, that of the pixel before it
    std::uint8_t* touched = nullptr;

    explicit Line(std::size_t slots);
    lines::LineOfSlots slots() const { return {ahead.data() + gap, run.data() + gap}; }
  };

  void connect();
  void connect_along(Line& line, Index begin);
  void connect_up(Line& line, Line& above, Line& next);
  bool join_aside(const Line& line, const Line& above, std::size_t at);
  void gather_things();

  const NearPixels& found_;
  const float jump_;
  Union runs_;  ///< what is connected along a line is one, so that these are joined and not every pixel
  std::vector<Stretch> stretches_;     ///< of each run
  std::vector<std::uint8_t> touched_;  ///< of each slot, on which sides, and as touched()
  std::vector<Stretches> things_;
  // Of each slot of a line.
  std::vector<std::uint8_t> back_, begins_, up_;
};

}  // namespace safety_control_cloud
