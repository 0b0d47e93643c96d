// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace safety_control_cloud {

/// What a pixel of a depth image holds.
enum class Depth : std::uint8_t {
  Millimetres,  ///< 16UC1: 16 bits without a sign; 0 is nothing measured
  Metres,       ///< 32FC1: a float32; NaN and +Inf are nothing measured, for -Inf see MinusInf
};

/// What a pixel of -Inf [m] says.
enum class MinusInf : std::uint8_t {
  Nothing,   ///< nothing measured, as depth_image_proc has it
  TooClose,  ///< something is too close to measure (REP 117)
};

/// A camera without distortion [px].
struct Pinhole {
  double fx = 0.0, fy = 0.0;  ///< focal length
  double cx = 0.0, cy = 0.0;  ///< where the optical axis meets the image
};

/// Borrowed bytes of a rectified depth image, and the camera that took it. Each pixel is a point: the one that the
/// nodelet depth_image_proc/point_cloud_xyz makes of it, to the bit. As with a CloudView, whoever makes one has checked
/// that every pixel lies inside the bytes, and that the focal lengths are no nonsense (see depth_layout.hpp).
struct DepthView {
  const std::uint8_t* bytes = nullptr;
  std::size_t width = 0;     ///< pixels in a row
  std::size_t height = 0;    ///< rows
  std::size_t row_step = 0;  ///< [byte] from one row to the next
  Depth depth = Depth::Metres;
  MinusInf minus_inf = MinusInf::Nothing;
  bool swapped = false;  ///< the byte order is not this machine's
  Pinhole camera;
  std::size_t first_column = 0;  ///< in the camera's image, of a piece of it
  std::size_t first_row = 0;     ///< the same

  std::size_t size() const { return width * height; }
  std::size_t pixel_step() const { return depth == Depth::Metres ? sizeof(float) : sizeof(std::uint16_t); }  ///< [byte]
};

/// Takes a pixel's depth to its point, in exactly depth_image_proc's operations on float32: column u and row v with
/// depth d, as it is stored, lie at ((u - cx) * d * x_scale, (v - cy) * d * y_scale, d * z_scale) [m].
struct Rays {
  float cx, cy;
  float x_scale, y_scale, z_scale;

  explicit Rays(const DepthView& view)
      : cx(static_cast<float>(view.camera.cx)),
        cy(static_cast<float>(view.camera.cy)),
        x_scale(static_cast<float>(double{metres_of(view.depth)} / view.camera.fx)),
        y_scale(static_cast<float>(double{metres_of(view.depth)} / view.camera.fy)),
        z_scale(metres_of(view.depth)) {}

  static float metres_of(Depth unit) { return unit == Depth::Metres ? 1.0f : 0.001f; }
};

}  // namespace safety_control_cloud
