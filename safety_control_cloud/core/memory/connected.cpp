// SPDX-License-Identifier: BSD-3-Clause
#include "connected.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace safety_control_cloud {
namespace {

/// Pixels that return nothing, or are mixed of two ranges, do not part a thing: as many slots and lines.
constexpr std::size_t gap = 2;

}  // namespace

Connected::Connected(const NearPixels& found, float jump) : found_(found), jump_(jump) {
  connect();
  things_ = together();
}

/// With what lies to the left of each pixel, and above it.
void Connected::connect() {
  const std::size_t size = found_.pixels.size();
  touched_.assign(size, 0);
  run_.resize(size);
  ahead_.resize(size);
  for (Index i = 0; i < size; ++i) ahead_[i] = found_.pixels[i].ahead;
  std::array<Line, gap + 1> lines;  // the latest first
  for (Line& line : lines) line.at.assign(found_.slots + 2, no_index);
  Index end = 0;
  for (Index begin = 0; begin < size; begin = end) {
    std::rotate(lines.begin(), lines.end() - 1, lines.end());
    while (end < size && found_.pixels[end].line == found_.pixels[begin].line) ++end;
    lines[0].row = found_.rows[found_.pixels[begin].line];
    std::fill(lines[0].at.begin(), lines[0].at.end(), no_index);
    for (Index i = begin; i < end; ++i) connect_left(i, begin);
    for (Index i = begin; i < end; ++i) {
      lines[0].at[found_.pixels[i].slot + std::size_t{1}] = i;
      for (std::size_t up = 1; up <= gap && !connect_up(i, lines[0], lines[up]); ++up) {
      }
    }
  }
}

/// What is connected along a line, from `begin` on, is one run, so that runs are joined and not every pixel.
void Connected::connect_left(Index i, Index begin) {
  const auto& pixels = found_.pixels;
  for (Index j = i; j-- > begin && pixels[j].slot + gap >= pixels[i].slot;) {
    if (!go_on(i, j)) continue;
    touched_[i] |= Left, touched_[j] |= Right;
    run_[i] = run_[j];
    return;
  }
  run_[i] = runs_.add();
}

/// Whether something in a line above that of a pixel is the same thing.
bool Connected::connect_up(Index i, const Line& own, const Line& line) {
  if (own.row - line.row > gap * found_.row_step) return false;
  const Index* const over = line.at.data() + found_.pixels[i].slot + 1;
  if (try_join(i, over[0])) {
    touched_[i] |= Above, touched_[over[0]] |= Below;
    return true;
  }
  const bool left = try_join(i, over[-1]), right = try_join(i, over[1]);
  return left || right;
}

bool Connected::try_join(Index i, Index j) {
  if (j == no_index || !go_on(i, j)) return false;
  const std::pair<Index, Index> both{run_[i], run_[j]};
  if (both != joined_) runs_.join(both.first, both.second);
  joined_ = both;
  return true;
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
