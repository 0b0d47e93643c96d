// SPDX-License-Identifier: BSD-3-Clause
#include "raster.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

#include "../input/point_reader.hpp"
#include "../look/meaning.hpp"

namespace safety_control_cloud {
namespace {

/// What lies further aside is in no corridor that a robot drives down: a slope.
constexpr float steepest = 3.0f;
/// Cells across and down, at most.
constexpr std::size_t most_cells = 640;
/// A cell in spacings of the points: moire leaves no cell empty from about here on.
constexpr float cell_in_spacings = 1.5f;
/// The grid stays for as long as the spacing changes by less than this factor.
constexpr float same_spacing = 1.5f;

bool is_ahead(const Point& point) {
  return std::abs(point.x) < steepest * point.z && std::abs(point.y) < steepest * point.z;
}

/// How far points lie apart [slope]: their number over the part of the view that they fill, in boxes.
float spacing_of(const std::vector<Point>& points, const Grid& grid) {
  constexpr std::size_t across = 64;
  std::bitset<across * across> filled;
  const float wide = (grid.right - grid.left) / across, high = (grid.bottom - grid.top) / across;
  const auto index = [](float slope, float least, float step) {
    return std::min(across - 1, static_cast<std::size_t>(std::max(0.0f, (slope - least) / step)));
  };
  for (const Point& point : points) {
    filled.set(index(point.y / point.z, grid.top, high) * across + index(point.x / point.z, grid.left, wide));
  }
  return std::sqrt(static_cast<float>(filled.count()) * wide * high / static_cast<float>(points.size()));
}

}  // namespace

void Raster::fit(const std::vector<Point>& returns) {
  Grid grid = grid_;
  constexpr float margin = 0.02f;
  for (const Point& point : returns) {
    const float x = point.x / point.z, y = point.y / point.z;
    extent_.left = std::min(extent_.left, x), extent_.right = std::max(extent_.right, x);
    extent_.top = std::min(extent_.top, y), extent_.bottom = std::max(extent_.bottom, y);
  }
  const bool are_known = usual_.any_known();  // then grow by whole cells, so that those before stay
  const auto reach = [&](float border, float extent, float away) {
    if (away * (extent - border) <= 0.0f) return border;
    const float beyond = extent + away * margin;
    return are_known ? border + away * grid.cell * std::ceil(away * (beyond - border) / grid.cell) : beyond;
  };
  grid.left = reach(grid.left, extent_.left, -1.0f), grid.right = reach(grid.right, extent_.right, 1.0f);
  grid.top = reach(grid.top, extent_.top, -1.0f), grid.bottom = reach(grid.bottom, extent_.bottom, 1.0f);
  const float widest = std::max(grid.right - grid.left, grid.bottom - grid.top);
  const float wanted = std::max(cell_in_spacings * spacing_of(returns, grid), widest / (most_cells - 1));
  const bool grown =
      grid.left != grid_.left || grid.top != grid_.top || grid.right != grid_.right || grid.bottom != grid_.bottom;
  const float ratio = wanted / grid_.cell;
  const bool is_like_it = ratio < same_spacing && ratio > 1.0f / same_spacing;
  if (!grown && is_like_it) return;
  const bool same = are_known && is_like_it && widest <= grid.cell * (most_cells - 1);
  if (!same) grid.cell = wanted;
  const auto cells = [&](float from, float to) {
    return static_cast<std::size_t>((to - from) / grid.cell + (same ? 0.5f : 0.0f));
  };
  grid.width = 1 + cells(grid.left, grid.right);
  grid.height = 1 + cells(grid.top, grid.bottom);
  if (same) {
    usual_.grow({cells(grid.top, grid_.top), cells(grid.left, grid_.left), grid.height, grid.width});
  } else {
    usual_.forget();
  }
  grid_ = grid;
}

RayLines Raster::rays() const {
  const double cell = double{grid_.cell};
  return {RayLine{double{grid_.left} + 0.5 * cell, cell}, RayLine{double{grid_.top} + 0.5 * cell, cell}};
}

/// Its margins are what the grid has beyond all returns.
Framing Raster::framing() const {
  Framing framing;
  if (extent_.left > extent_.right) return framing;  // no cloud has come
  const auto cell_of = [](float slope, float least, float cell, std::size_t size) {
    return std::min(size - 1, static_cast<std::size_t>(std::max(0.0f, (slope - least) / cell)));
  };
  framing.left = cell_of(extent_.left, grid_.left, grid_.cell, grid_.width);
  framing.right = grid_.width - 1 - cell_of(extent_.right, grid_.left, grid_.cell, grid_.width);
  framing.top = cell_of(extent_.top, grid_.top, grid_.cell, grid_.height);
  framing.bottom = grid_.height - 1 - cell_of(extent_.bottom, grid_.top, grid_.cell, grid_.height);
  framing.middle_row = -double{grid_.top} / double{grid_.cell};
  framing.middle_column = -double{grid_.left} / double{grid_.cell};
  return framing;
}

View Raster::picture_of(const View& points, const Corridor& corridor, bool anything_near) {
  take(points, corridor);
  if (!returns_.empty()) fit(returns_);
  fill();
  usual_.note(cells_, grid_.width, anything_near);
  return view();
}

View Raster::picture_of_few(const View& points, const Corridor& corridor) {
  take(points, corridor);
  const bool is_fitted = extent_.left <= extent_.right;
  if (!returns_.empty() && !is_fitted) fit(returns_);
  const auto is_beside = [this](const Point& point) {
    const std::ptrdiff_t row = grid_.row(point), column = grid_.column(point);
    return row < 0 || column < 0 || row >= static_cast<std::ptrdiff_t>(grid_.height) ||
           column >= static_cast<std::ptrdiff_t>(grid_.width);
  };
  returns_.erase(std::remove_if(returns_.begin(), returns_.end(), is_beside), returns_.end());
  fill();
  return view();
}

void Raster::take(const View& points, const Corridor& corridor) {
  returns_.clear();
  for_each_point(points, [&](float x, float y, float z) {
    if (!is_return(x, y, z, corridor)) return;
    const Point point(x, y, z);
    if (is_ahead(point)) returns_.push_back(point);
  });
}

void Raster::fill() {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  cells_.assign(grid_.width * grid_.height, {nan, nan, nan});
  hits_.take(grid_, returns_);
  filled_ = 0;
  for (const Point& point : returns_) {
    const std::size_t row = std::min(grid_.height - 1, static_cast<std::size_t>(grid_.row(point)));
    const std::size_t column = std::min(grid_.width - 1, static_cast<std::size_t>(grid_.column(point)));
    auto& cell = cells_[row * grid_.width + column];
    filled_ += std::isnan(cell[2]);
    if (!(cell[2] <= point.z)) cell = {point.x, point.y, point.z};
  }
}

View Raster::view() const { return in_rows(cells_, grid_.width); }

}  // namespace safety_control_cloud
