// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "../input/view.hpp"
#include "../look/corridor.hpp"
#include "pixels.hpp"
#include "ray_hits.hpp"
#include "usual_cells.hpp"

namespace safety_control_cloud {

/// Makes a picture of a cloud that is not organised, as a pinhole camera at the cloud's origin would see it: each cell
/// holds the nearest return in it. A cell is a little wider than the points lie apart, so that a surface leaves no
/// holes; how far that is, the cloud says itself.
class Raster {
 public:
  /// The picture of these points, as far as they are returns; valid until the next one.
  /// `anything_near`: something near is remembered.
  View picture_of(const View& points, const Corridor& corridor, bool anything_near);

  /// Of few points, of which nothing is learned, the picture in the cells there are. What lies beside is left out.
  View picture_of_few(const View& points, const Corridor& corridor);

  std::size_t filled() const { return filled_; }  ///< cells that hold a return
  const Grid& grid() const { return grid_; }
  const RayHits& hits() const { return hits_; }
  const UsualCells& usual() const { return usual_; }
  RayLines rays() const;  ///< which way its cells look
  Framing framing() const;

 private:
  /// Slopes between which all returns lay so far.
  struct Extent {
    float left = std::numeric_limits<float>::infinity(), top = left, right = -left, bottom = -left;
  };

  void take(const View& points, const Corridor& corridor);
  void fit(const std::vector<Point>& returns);
  void fill();
  View view() const;

  Grid grid_;
  Extent extent_;
  RayHits hits_;
  UsualCells usual_;
  std::size_t filled_ = 0;
  std::vector<Point> returns_;
  std::vector<std::array<float, 3>> cells_;
};

}  // namespace safety_control_cloud
