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

/// Where a pixel's point lies depends on its row.
DepthView with_joined_rows(const DepthView& image) { return image; }

View in_longest_rows(const View& view, Rows rows) {
  if (rows == Rows::Apart) return view;
  return std::visit([](const auto& points) { return View(with_joined_rows(points)); }, view);
}

template <class Points>
void cut_out(Points& points, std::size_t row, std::size_t column, std::size_t width) {
  points.bytes += row * points.row_step + column * step_of(points);
  points.width = width;
  points.height = 1;
}

}  // namespace

CloudView piece_of(CloudView cloud, std::size_t row, std::size_t column, std::size_t width) {
  cut_out(cloud, row, column, width);
  return cloud;
}

DepthView piece_of(DepthView image, std::size_t row, std::size_t column, std::size_t width) {
  cut_out(image, row, column, width);
  image.first_row += row;
  image.first_column += column;
  return image;
}

Run part_of(const Run& run, std::size_t begin, std::size_t width) {
  const bool ends_run = begin + width == width_of(run.points);
  const auto cut = [&](const auto& points) { return View(piece_of(points, 0, begin, width)); };
  return {std::visit(cut, run.points), run.first + begin, run.followed || !ends_run};
}

Runs::Runs(const View& view, Rows rows)
    : rows_(in_longest_rows(view, rows)),
      in_row_(width_of(rows_) / longest + (width_of(rows_) % longest == 0 ? 0 : 1)) {}

Run Runs::operator[](std::size_t run) const {
  const std::size_t row = run / in_row_, begin = run % in_row_ * longest;
  return std::visit(
      [&](const auto& rows) {
        const std::size_t width = std::min(longest, rows.width - begin);
        const bool ends_row = begin + width == rows.width;
        const bool rows_in_order = rows.row_step >= rows.width * step_of(rows);
        return Run{piece_of(rows, row, begin, width), row * rows.width + begin,
                   !ends_row || (row + 1 < rows.height && rows_in_order)};
      },
      rows_);
}

}  // namespace safety_control_cloud
