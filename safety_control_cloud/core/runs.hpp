// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "cloud.hpp"

namespace safety_control_cloud {

/// A piece of a row.
struct Run {
  CloudView points;       ///< one row of at most Runs::longest
  std::size_t first = 0;  ///< which point of the cloud its first one is
  bool followed = false;  ///< another point of the cloud lies behind the last one in memory
};

/// A cloud as the runs that it is scanned in. Rows that follow each other without a gap count as one.
class Runs {
 public:
  static constexpr std::size_t longest = 1024;  ///< points; what is done once a run then hardly counts

  explicit Runs(const CloudView& cloud);

  std::size_t size() const { return rows_.height * in_row_; }
  Run operator[](std::size_t run) const;

 private:
  CloudView rows_;
  std::size_t in_row_;  ///< runs
};

}  // namespace safety_control_cloud
