// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <variant>

#include "../input/point_reader.hpp"
#include "../look/outlook.hpp"

namespace safety_control_cloud {

/// Which return, if any, lies in a direction: a pixel of an organised cloud, of a depth image, or of the raster that is
/// made of a cloud that is not organised. Reads single pixels; the bytes are borrowed.
class Pixels {
 public:
  /// A return lies farther than `range_min` [m].
  Pixels(const View& view, float range_min);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  /// In the cloud's frame; z is NaN where nothing returns.
  Point at(std::size_t row, std::size_t column) const { return read_(*this, row, column); }
  /// Calls visit(column, point) for every `step`-th pixel of a row.
  template <class Visit>
  void along(std::size_t row, std::size_t step, Visit visit) const {
    std::visit(
        [&](const auto& reader) {
          for (std::size_t column = 0; column < width_; column += step) {
            const auto take = [&](float x, float y, float z) { visit(column, point_of(x, y, z)); };
            reader(row, column, take);
          }
        },
        reader_);
  }
  /// at() of a place that may lie beside the picture.
  Point near(std::ptrdiff_t row, std::ptrdiff_t column) const;

 private:
  using Reader = std::variant<CloudReader<float, false>, CloudReader<float, true>, CloudReader<double, false>,
                              CloudReader<double, true>, DepthReader<float, false>, DepthReader<float, true>,
                              DepthReader<std::uint16_t, false>, DepthReader<std::uint16_t, true>>;

  Point point_of(float x, float y, float z) const {
    const bool any = 0.0f * x + 0.0f * y + 0.0f * z == 0.0f && z > range_min_;  // finite
    return any ? Point(x, y, z) : Point(0.0f, 0.0f, std::numeric_limits<float>::quiet_NaN());
  }
  template <class OneReader>
  static Point read(const Pixels& picture, std::size_t row, std::size_t column);

  Reader reader_ = CloudReader<float, false>{};
  Point (*read_)(const Pixels&, std::size_t, std::size_t) = nullptr;
  std::size_t width_, height_;
  float range_min_;
};

/// In the corridor's axes.
inline Point placed(const Point& point, const Outlook& outlook) { return outlook.placed(point.x, point.y, point.z); }

/// Whether anything returned.
inline bool returned(const Point& point) { return !std::isnan(point.z); }

}  // namespace safety_control_cloud
