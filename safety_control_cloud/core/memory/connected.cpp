// SPDX-License-Identifier: BSD-3-Clause
#include "connected.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {

Connected::Connected(const NearPixels& found, float jump) : found_(found), jump_(jump) {
  connect();
  things_ = together();
}

/// With what lies to the left of each pixel, and above it. What is connected along a line is one run, so that runs are
/// joined and not every pixel.
void Connected::connect() {
  const auto size = static_cast<Index>(found_.pixels.size());
  touched_.assign(size, 0);
  run_.resize(size);
  ahead_.resize(size);
  slot_.resize(size);
  for (Index i = 0; i < size; ++i) {
    ahead_[i] = found_.pixels[i].ahead;
    slot_[i] = found_.pixels[i].slot;
  }
  std::array<Line, gap + 1> lines;  // the latest first
  for (Line& line : lines) line.at.assign(found_.slots + 2, no_index);
  Index end = 0;
  for (Index begin = 0; begin < size; begin = end) {
    const std::uint16_t line = found_.pixels[begin].line;
    while (end < size && found_.pixels[end].line == line) ++end;
    std::rotate(lines.begin(), lines.end() - 1, lines.end());
    lines[0].row = found_.rows[line];
    std::fill(lines[0].at.begin(), lines[0].at.end(), no_index);
    connect_along(begin, end);
    Index* const at = lines[0].at.data() + 1;
    for (Index i = begin; i < end; ++i) at[slot_[i]] = i;
    connect_up(begin, end, lines);
  }
}

/// Each of a line to the nearest to its left that is as far ahead.
void Connected::connect_along(Index begin, Index end) {
  const float* const ahead = ahead_.data();
  const std::uint16_t* const slot = slot_.data();
  Index* const run = run_.data();
  std::uint8_t* const touched = touched_.data();
  for (Index i = begin; i < end; ++i) {
    Index left = no_index;
    for (Index j = i; left == no_index && j-- > begin && slot[j] + gap >= slot[i];)
      if (std::abs(ahead[i] - ahead[j]) <= jump_) left = j;
    if (left == no_index) {
      run[i] = runs_.add();
      continue;
    }
    touched[i] |= Left, touched[left] |= Right;
    run[i] = run[left];
  }
}

/// Each to what is straight above and as far ahead, or else to both beside that, or else to the same of the line above.
void Connected::connect_up(Index begin, Index end, const std::array<Line, gap + 1>& lines) {
  const float* const ahead = ahead_.data();
  const Index* const run = run_.data();
  std::uint8_t* const touched = touched_.data();
  Index one = no_index, other = no_index;  // runs, the latest that were joined
  const auto goes_on = [&](Index i, Index j) { return j != no_index && std::abs(ahead[i] - ahead[j]) <= jump_; };
  const auto join = [&](Index i, Index j) {
    if (run[i] == one && run[j] == other) return;
    one = run[i], other = run[j];
    runs_.join(one, other);
  };
  std::size_t above = 0;
  while (above < gap && lines[0].row - lines[above + 1].row <= gap * found_.row_step) ++above;
  for (Index i = begin; i < end; ++i) {
    for (std::size_t up = 1; up <= above; ++up) {
      const Index* const over = lines[up].at.data() + 1 + slot_[i];
      if (goes_on(i, over[0])) {
        touched[i] |= Above, touched[over[0]] |= Below;
        join(i, over[0]);
        break;
      }
      const bool left = goes_on(i, over[-1]), right = goes_on(i, over[1]);
      if (left) join(i, over[-1]);
      if (right) join(i, over[1]);
      if (left || right) break;
    }
  }
}

/// Those that are one, by the first of each.
std::vector<Members> Connected::together() {
  std::vector<Index> thing(runs_.size());  // of each run; the first run of a thing is the first to be met
  Index things = 0;
  for (Index run = 0; run < thing.size(); ++run) {
    const Index root = runs_.root(run);
    thing[run] = root == run ? things++ : thing[root];
  }
  std::vector<Index> size(things, 0);
  for (const Index run : run_) ++size[thing[run]];
  std::vector<Members> all(things);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].reserve(size[i]);
  for (Index i = 0; i < run_.size(); ++i) all[thing[run_[i]]].push_back(i);
  return all;
}

}  // namespace safety_control_cloud
