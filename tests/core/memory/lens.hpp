// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "../../../safety_control_cloud/core/input/depth.hpp"
#include "../../../safety_control_cloud/core/look/ray_lines.hpp"
#include "../scene.hpp"

namespace safety_control_cloud {

/// A camera of any lens, or a part of its picture, which sees what an Xtion would: nothing at or below 0.4 m and at or
/// beyond 5.0 m, and a floor.
struct Lens {
  std::size_t width = 160, height = 120;
  double focal = 138.56;              ///< [px]
  double across = 79.5, down = 59.5;  ///< [px] where the optical axis meets the picture

  static Lens of(double degrees) {
    Lens lens;
    lens.focal = 80.0 / std::tan(degrees * 3.14159265 / 360.0);
    return lens;
  }
  /// A part of its picture, from this column and row on.
  Lens part(std::size_t left, std::size_t top, std::size_t columns, std::size_t rows) const {
    return {columns, rows, focal, across - static_cast<double>(left), down - static_cast<double>(top)};
  }
  /// As many pixels, and more or fewer of them in a degree.
  Lens scaled(double by) const {
    return {static_cast<std::size_t>(by * static_cast<double>(width)),
            static_cast<std::size_t>(by * static_cast<double>(height)), by * focal, by * (across + 0.5) - 0.5,
            by * (down + 0.5) - 0.5};
  }

  RayLines rays() const { return {RayLine{-across / focal, 1.0 / focal}, RayLine{-down / focal, 1.0 / focal}}; }

  bool shows_column(double slant) const {
    const double column = across + focal * slant;
    return column > 0.0 && column < static_cast<double>(width);
  }

  std::vector<Xyz> points(const std::vector<Board>& boards) const {
    std::vector<Xyz> points;
    points.reserve(width * height);
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        const auto x = static_cast<float>((static_cast<double>(column) - across) / focal);
        const auto y = static_cast<float>((static_cast<double>(row) - down) / focal);
        float z = y > 0.0f ? floor_y / y : inf;
        for (const Board& board : boards) {
          const bool hit = x * board.z >= board.x_min && x * board.z <= board.x_max && y * board.z >= board.y_min &&
                           y * board.z <= board.y_max;
          if (hit) z = std::min(z, board.z);
        }
        points.push_back(z <= 0.4f || z >= 5.0f ? Xyz{nan, nan, nan} : Xyz{x * z, y * z, z});
      }
    }
    return points;
  }

  static std::vector<float> depths(const std::vector<Xyz>& points) {
    std::vector<float> depths;
    depths.reserve(points.size());
    for (const Xyz& point : points) depths.push_back(point.z);
    return depths;
  }

  CloudView view_of_rows(const std::vector<Xyz>& points) const {
    CloudView view = view_of(points);
    view.width = width, view.height = height, view.row_step = width * sizeof(Xyz);
    return view;
  }

  DepthView view_of_depths(const std::vector<float>& depths) const {
    DepthView view;
    view.bytes = reinterpret_cast<const std::uint8_t*>(depths.data());
    view.width = width, view.height = height, view.row_step = width * sizeof(float);
    view.camera = {focal, focal, across, down};
    return view;
  }
};

}  // namespace safety_control_cloud
