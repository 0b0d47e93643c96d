// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace safety_control_cloud {

/// Where the floor is hidden, three pixels in four and more are blank, whatever stray ranges the others return; and
/// what rounding takes.
constexpr double mostly_blank = 0.7499;

/// How much of a strip of rows is blank in each column, over so many clouds that chance does not blank as much as what
/// hides the floor does: in ordinary light one, in low light more.
class BlankShares {
 public:
  /// The next picture has other columns.
  void clear() { shares_.clear(); }

  /// Of each column, so many of the strip's `rows` are blank now; a post is `post` columns wide.
  void note(const std::vector<std::uint16_t>& blank, std::size_t rows, std::size_t post);

  double operator[](std::size_t column) const { return double{shares_[column]}; }
  double clouds() const { return clouds_; }

 private:
  void note_usual(const std::vector<std::uint16_t>& blank, std::size_t rows);
  double by_chance() const;
  void note_what_is_blank_at_once(const std::vector<std::uint16_t>& blank, std::size_t rows, std::size_t post,
                                  double chance);

  std::array<float, 8> usual_{};  ///< the share of pixels that were blank lately, in parts from left to right
  double clouds_ = 1.0;
  std::vector<float> shares_;  ///< of each column, over the latest `clouds_`
};

}  // namespace safety_control_cloud
