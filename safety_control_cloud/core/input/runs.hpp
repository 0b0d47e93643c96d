// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "view.hpp"

namespace safety_control_cloud {

/// `width` successive points of a row.
CloudView piece_of(CloudView cloud, std::size_t row, std::size_t column, std::size_t width);
DepthView piece_of(DepthView image, std::size_t row, std::size_t column, std::size_t width);

/// A piece of a row.
struct Run {
  View points;            ///< one row of at most Runs::longest
  std::size_t first = 0;  ///< which point of the view its first one is
  bool followed = false;  ///< another point of the view lies behind the last one in memory
};

/// `width` successive points of a run.
Run part_of(const Run& run, std::size_t begin, std::size_t width);

/// Whether a cloud's rows that follow each other without a gap count as one.
enum class Rows { Joined, Apart };

/// A view as the runs that it is scanned in.
class Runs {
 public:
  static constexpr std::size_t longest = 1024;  ///< points; what is done once a run then hardly counts

  explicit Runs(const View& view, Rows rows = Rows::Joined);

  std::size_t size() const { return height_of(rows_) * in_row_; }
  Run operator[](std::size_t i) const;

 private:
  View rows_;
  std::size_t in_row_;  ///< runs
};

}  // namespace safety_control_cloud
