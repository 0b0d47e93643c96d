// SPDX-License-Identifier: BSD-3-Clause
#include "pixels.hpp"

#include <algorithm>
#include <cmath>

namespace safety_control_cloud {
namespace {

const Point nothing = {0.0f, 0.0f, std::numeric_limits<float>::quiet_NaN()};

constexpr double farthest = 1e6;  // [px] beside the picture: from there all ways in it are parallel

/// To 1/64 of a pixel. A depth image tells it at once and a cloud by its returns, but for rounding; of ways that begin
/// there, what lies midway between two pixels is to lie so for both.
double middle_of(const RayLine& line) {
  return std::round(64.0 * std::clamp(line.pixel(0.0), -farthest, farthest)) / 64.0;
}

}  // namespace

template <class OneReader>
Point Pixels::read(const Pixels& picture, std::size_t row, std::size_t column) {
  Point point;
  const auto take = [&](float x, float y, float z) { point = picture.point_of(x, y, z); };
  (*std::get_if<OneReader>(&picture.reader_))(row, column, take);
  return point;
}

/// Of pixels none of which lies beside the picture, and behind which others lie.
std::array<float, 9> Pixels::read_plain_around(const Pixels& picture, std::size_t row, std::size_t column) {
  const bool all_are = row > 0 && row + 2 < picture.height_ && column > 0 && column + 1 < picture.width_;
  if (!all_are) return read_around<CloudReader<float, false>>(picture, row, column);
  const std::uint8_t* const first = picture.plain_ + (row - 1) * picture.row_step_ + (column - 1) * picture.pixel_step_;
  return points::around({first, picture.pixel_step_, picture.row_step_}, picture.range_min_);
}

template <class OneReader>
std::array<float, 9> Pixels::read_around(const Pixels& picture, std::size_t row, std::size_t column) {
  std::array<float, 9> z;
  z.fill(nothing.z);
  const OneReader& reader = *std::get_if<OneReader>(&picture.reader_);
  const auto read = [&](std::size_t i, std::size_t j) {
    const auto take = [&](float px, float py, float pz) { z[3 * i + j] = picture.point_of(px, py, pz).z; };
    reader(row + i - 1, column + j - 1, take);
  };
  const auto is_there = [&](std::size_t i, std::size_t j) {
    return row + i > 0 && row + i <= picture.height_ && column + j > 0 && column + j <= picture.width_;
  };
  const bool all_are = is_there(0, 0) && is_there(2, 2);  // most are: then nine in a row, without a branch
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (all_are || is_there(i, j)) read(i, j);
  return z;
}

Pixels::Pixels(const View& view, float range_min, const RayHits* hits, const UsualCells* usual)
    : width_(width_of(view)), height_(height_of(view)), range_min_(range_min), hits_(hits), usual_(usual) {
  framing_.middle_row = 0.5 * static_cast<double>(height_);
  framing_.middle_column = 0.5 * static_cast<double>(width_);
  std::visit([this](const auto& some) { bytes_ = some.bytes, row_step_ = some.row_step, pixel_step_ = step_of(some); },
             view);
  with_reader(view, [this](const auto& reader) {
    using OneReader = std::decay_t<decltype(reader)>;
    reader_.emplace<OneReader>(reader);
    read_ = &read<OneReader>;
    around_ = &read_around<OneReader>;
  });
  const auto* const cloud = std::get_if<CloudView>(&view);
  if (!cloud || !cloud->is_of_floats() || !cloud->y_and_z_follow_x()) return;
  plain_ = cloud->bytes + cloud->offset[0];
  around_ = &read_plain_around;
}

void Pixels::fetch_row(std::size_t row, std::size_t step, std::size_t from) const {
  const std::size_t apart = std::max(cache_line, step * pixel_step_), size = (width_ - from) * pixel_step_;
  const std::uint8_t* const first = bytes_ + row * row_step_ + from * pixel_step_;
  constexpr std::size_t at_once = 4;  // to count takes longer than to ask
  std::size_t at = 0;
  for (; at + (at_once - 1) * apart < size; at += at_once * apart)
    for (std::size_t i = 0; i < at_once; ++i) fetch_line(first + at + i * apart);
  for (; at < size; at += apart) fetch_line(first + at);
}

void Pixels::look_along(const RayLines& rays) {
  if (rays.down) framing_.middle_row = middle_of(*rays.down);
  if (rays.across) framing_.middle_column = middle_of(*rays.across);
}

void Pixels::read(std::size_t row, std::size_t step, const Outlook& outlook, PixelRow& into) const {
  const std::size_t size = (width_ + step - 1) / step;
  for (auto* coordinate : {&into.x, &into.y, &into.z}) coordinate->resize(size);
  float *const xs = into.x.data(), *const ys = into.y.data(), *const zs = into.z.data();
  const auto take_each = [&](const auto& reader) {
    for (std::size_t i = 0; i < size; ++i) {
      const auto take = [&](float x, float y, float z) { xs[i] = x, ys[i] = y, zs[i] = z; };
      reader(row, i * step, take);
    }
  };
  if (plain_) {
    points::read({plain_ + row * row_step_, step * pixel_step_, size}, xs, ys, zs);
  } else {
    std::visit(take_each, reader_);
  }
  points::place(into.pixels(), range_min_, outlook.placement, xs, ys, zs);
}

Point Pixels::near(std::ptrdiff_t row, std::ptrdiff_t column) const {
  const auto beside = [](std::ptrdiff_t i, std::size_t size) {
    return i < 0 || i >= static_cast<std::ptrdiff_t>(size);
  };
  if (beside(row, height_) || beside(column, width_)) return nothing;
  return at(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
}

}  // namespace safety_control_cloud
