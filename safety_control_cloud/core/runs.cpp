// SPDX-License-Identifier: BSD-3-Clause
#include "runs.hpp"

#include <algorithm>

namespace safety_control_cloud {
namespace {

CloudView with_joined_rows(CloudView cloud) {
  if (cloud.height > 1 && cloud.row_step == cloud.width * cloud.point_step) {
    cloud.width = cloud.size();
    cloud.height = 1;
  }
  return cloud;
}

}  // namespace

Runs::Runs(const CloudView& cloud)
    : rows_(with_joined_rows(cloud)), in_row_(rows_.width / longest + (rows_.width % longest == 0 ? 0 : 1)) {}

Run Runs::operator[](std::size_t run) const {
  const std::size_t row = run / in_row_, begin = run % in_row_ * longest;
  Run piece{rows_, row * rows_.width + begin, false};
  piece.points.bytes += row * rows_.row_step + begin * rows_.point_step;
  piece.points.width = std::min(longest, rows_.width - begin);
  piece.points.height = 1;
  const bool ends_row = begin + piece.points.width == rows_.width;
  const bool rows_in_order = rows_.row_step >= rows_.width * rows_.point_step;
  piece.followed = !ends_row || (row + 1 < rows_.height && rows_in_order);
  return piece;
}

}  // namespace safety_control_cloud
