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
void keep_row(Points& points, std::size_t row, std::size_t column, std::size_t width) {
  points.bytes += row * points.row_step + column * step_of(points);
  points.width = width;
  points.height = 1;
}

/// Leaves nothing but `width` successive points of a row: where the view lies, since a copy for each of a picture's
/// runs would cost more than the rest that is done once a run.
void keep(CloudView& cloud, std::size_t row, std::size_t column, std::size_t width) {
  keep_row(cloud, row, column, width);
}
void keep(DepthView& image, std::size_t row, std::size_t column, std::size_t width) {
  keep_row(image, row, column, width);
  image.first_row += row;
  image.first_column += column;
}

}  // namespace

CloudView piece_of(CloudView cloud, std::size_t row, std::size_t column, std::size_t width) {
  keep(cloud, row, column, width);
  return cloud;
}

DepthView piece_of(DepthView image, std::size_t row, std::size_t column, std::size_t width) {
  keep(image, row, column, width);
  return image;
}

Run part_of(const Run& run, std::size_t begin, std::size_t width) {
  const bool ends_run = begin + width == width_of(run.points);
  Run part{run.points, run.first + begin, run.followed || !ends_run};
  std::visit([&](auto& points) { keep(points, 0, begin, width); }, part.points);
  return part;
}

Runs::Runs(const View& view, Rows rows)
    : rows_(in_longest_rows(view, rows)),
      in_row_(width_of(rows_) / longest + (width_of(rows_) % longest == 0 ? 0 : 1)) {}

Run Runs::operator[](std::size_t i) const {
  const std::size_t row = in_row_ == 1 ? i : i / in_row_;  // a division for each of a picture's rows would show
  const std::size_t begin = (i - row * in_row_) * longest;
  Run run{rows_};
  std::visit(
      [&](auto& points) {
        const std::size_t row_width = points.width, width = std::min(longest, row_width - begin);
        const bool ends_row = begin + width == row_width;
        const bool rows_in_order = points.row_step >= row_width * step_of(points);
        run.first = row * row_width + begin;
        run.followed = !ends_row || (row + 1 < points.height && rows_in_order);
        keep(points, row, begin, width);
      },
      run.points);
  return run;
}

}  // namespace safety_control_cloud
