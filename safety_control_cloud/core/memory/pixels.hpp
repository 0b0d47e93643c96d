// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <variant>
#include <vector>

#include "../input/fetch.hpp"
#include "../input/point_reader.hpp"
#include "../look/outlook.hpp"
#include "../look/ray_lines.hpp"
#include "kernel/points.hpp"
#include "ray_hits.hpp"
#include "usual_cells.hpp"

namespace safety_control_cloud {

/// Some pixels of one row, in the corridor's axes [m]; z is NaN where nothing returns.
struct PixelRow {
  std::vector<float> x, y, z;

  points::PixelsOfRow pixels() const { return {x.data(), y.data(), z.data(), z.size()}; }
};

/// How a picture looks out.
struct Framing {
  std::size_t left = 0, top = 0, right = 0, bottom = 0;  ///< so many columns and rows at its sides never return
  double middle_row = 0.0, middle_column = 0.0;          ///< which look straight ahead
};

/// Which return, if any, lies in a direction: a pixel of an organised cloud, of a depth image, or of the raster that is
/// made of a cloud that is not organised. Reads single pixels; the bytes are borrowed.
class Pixels {
 public:
  /// A return lies farther than `range_min` [m]. `hits` and `usual`, of a raster, are borrowed too.
  Pixels(const View& view, float range_min, const RayHits* hits = nullptr, const UsualCells* usual = nullptr);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  const Framing& framing() const { return framing_; }  ///< unless it is told: no margins, and ahead is in the middle
  void frame(const Framing& framing) { framing_ = framing; }
  void look_along(const RayLines& rays);  ///< which tell where ahead is, if they are known: maybe beside the picture
  const RayHits* hits() const { return hits_; }  ///< of a raster, which rays return; none: the pixels are the rays

  /// Whether nothing ever returns at a place in the picture, whatever is there.
  bool never_returns(std::size_t row, std::size_t column) const {
    return usual_ && usual_->never_returns(row * width_ + column);
  }

  /// In the cloud's frame; z is NaN where nothing returns.
  Point at(std::size_t row, std::size_t column) const {
    return plain_ ? plain_at(row, column) : read_(*this, row, column);
  }
  /// Every `step`-th pixel of a row, placed, all at once.
  void read(std::size_t row, std::size_t step, const Outlook& outlook, PixelRow& into) const;
  /// Asks for the bytes of every `step`-th pixel of a row from one on, which will be read soon: by now they may be in
  /// no cache.
  void fetch_row(std::size_t row, std::size_t step, std::size_t from = 0) const;
  /// The same for around(), of a place in the picture.
  void fetch_around(std::size_t row, std::size_t column) const {
    const std::size_t first = row - std::min<std::size_t>(1, row), last = std::min(row + 1, height_ - 1);
    for (std::size_t i = first; i <= last; ++i) fetch_line(bytes_ + i * row_step_ + column * pixel_step_);
  }
  /// at() of a place that may lie beside the picture.
  Point near(std::ptrdiff_t row, std::ptrdiff_t column) const;
  /// z of the 3 x 3 pixels around a place in the picture, row by row.
  std::array<float, 9> around(std::size_t row, std::size_t column) const { return around_(*this, row, column); }

 private:
  using Reader = std::variant<CloudReader<float, false>, CloudReader<float, true>, CloudReader<double, false>,
                              CloudReader<double, true>, DepthReader<float, false>, DepthReader<float, true>,
                              DepthReader<std::uint16_t, false>, DepthReader<std::uint16_t, true>>;

  /// Finite, and far enough.
  bool is_any(float x, float y, float z) const { return (0.0f * x + 0.0f * y + 0.0f * z == 0.0f) & (z > range_min_); }
  Point point_of(float x, float y, float z) const {
    return is_any(x, y, z) ? Point(x, y, z) : Point(0.0f, 0.0f, std::numeric_limits<float>::quiet_NaN());
  }
  template <class OneReader>
  static Point read(const Pixels& picture, std::size_t row, std::size_t column);
  /// Of most clouds: a call would take as long as the reading.
  Point plain_at(std::size_t row, std::size_t column) const {
    float xyz[3];
    std::memcpy(xyz, plain_ + row * row_step_ + column * pixel_step_, sizeof xyz);
    return point_of(xyz[0], xyz[1], xyz[2]);
  }
  template <class OneReader>
  static std::array<float, 9> read_around(const Pixels& picture, std::size_t row, std::size_t column);
  static std::array<float, 9> read_plain_around(const Pixels& picture, std::size_t row, std::size_t column);

  Reader reader_ = CloudReader<float, false>{};
  Point (*read_)(const Pixels&, std::size_t, std::size_t) = nullptr;
  std::array<float, 9> (*around_)(const Pixels&, std::size_t, std::size_t) = nullptr;
  const std::uint8_t* bytes_ = nullptr;
  const std::uint8_t* plain_ = nullptr;  ///< the first x, if the others lie behind it as points::read() wants them
  std::size_t row_step_ = 0, pixel_step_ = 0;  ///< [byte]
  std::size_t width_, height_;
  float range_min_;
  Framing framing_;
  const RayHits* hits_;
  const UsualCells* usual_;
};

/// In the corridor's axes.
inline Point placed(const Point& point, const Outlook& outlook) { return outlook.placed(point.x, point.y, point.z); }

/// Whether anything returned.
inline bool returned(const Point& point) { return !std::isnan(point.z); }

}  // namespace safety_control_cloud
