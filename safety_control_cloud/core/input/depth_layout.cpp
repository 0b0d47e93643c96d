// SPDX-License-Identifier: BSD-3-Clause
#include "depth_layout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "../text/words.hpp"
#include "extent.hpp"

namespace safety_control_cloud {
namespace {

std::optional<Depth> depth_in(const std::string& encoding) {
  if (encoding == "16UC1") return Depth::Millimetres;
  if (encoding == "32FC1") return Depth::Metres;
  return std::nullopt;
}

std::optional<std::string> problem_with_step(const DepthLayout& layout, std::size_t pixel) {
  if (layout.step % pixel == 0) return std::nullopt;
  return words("step ", layout.step, " is not a multiple of a pixel's ", pixel, " bytes");
}

/// [px] on one side of the image that a camera with these claims sends.
std::uint32_t sent(std::uint32_t whole, std::uint32_t region, std::uint32_t binning) {
  return (region == 0 ? whole : region) / std::max(binning, 1u);
}

std::optional<std::string> problem_with_distortion(const DepthLayout& layout) {
  const std::vector<double>& distortion = layout.camera.D;
  const bool none = std::all_of(distortion.begin(), distortion.end(), [](double value) { return value == 0.0; });
  if (none || layout.rectified) return std::nullopt;
  return "the image is distorted (D of its CameraInfo is not zero): rectify it with image_proc and take its image_rect";
}

bool is_focal_length(double value) { return std::isfinite(value) && value > 0.0; }

std::optional<std::string> problem_with_camera(const DepthLayout& layout) {
  const CameraClaims& camera = layout.camera;
  const std::uint32_t width = sent(camera.width, camera.roi.width, camera.binning_x);
  const std::uint32_t height = sent(camera.height, camera.roi.height, camera.binning_y);
  if (width != layout.width || height != layout.height) {
    return words("the image has ", layout.width, " x ", layout.height, " pixels, its CameraInfo speaks of ", width,
                 " x ", height);
  }
  if (!is_focal_length(camera.K[0]) || !is_focal_length(camera.K[4])) return "K of the CameraInfo has no focal length";
  if (!is_focal_length(camera.P[0]) || !is_focal_length(camera.P[5])) return "P of the CameraInfo has no focal length";
  if (!std::isfinite(camera.P[2]) || !std::isfinite(camera.P[6])) return "P of the CameraInfo has no optical centre";
  if (camera.K[0] == 1.0 && camera.K[4] == 1.0)
    return "K of the CameraInfo is the identity: the camera was never calibrated";
  return problem_with_distortion(layout);
}

/// Of the image as it was sent: the region first, because it counts in pixels before binning.
Pinhole pinhole_of(const CameraClaims& camera) {
  Pinhole pinhole{camera.P[0], camera.P[5], camera.P[2] - camera.roi.x_offset, camera.P[6] - camera.roi.y_offset};
  const double x = 1.0 / std::max(camera.binning_x, 1u), y = 1.0 / std::max(camera.binning_y, 1u);
  return {pinhole.fx * x, pinhole.fy * y, pinhole.cx * x, pinhole.cy * y};
}

/// What is a number in double may be none in float32.
bool is_usable(const Rays& rays) {
  const auto is_number = [](float value) { return std::isfinite(value); };
  return is_number(rays.cx) && is_number(rays.cy) && is_number(rays.x_scale) && is_number(rays.y_scale);
}

/// Over the width or height of an image that one pixel is the `focal`-th part of.
bool is_field_of_view(double pixels, double focal) {
  constexpr double widest = 7.46;     // 150 degrees
  constexpr double narrowest = 5e-6;  // of a pixel: a second of arc
  return pixels <= widest * focal && narrowest * focal <= 1.0;
}

bool has_field_of_view(const DepthView& view) {
  return is_field_of_view(static_cast<double>(view.width), view.camera.fx) &&
         is_field_of_view(static_cast<double>(view.height), view.camera.fy);
}

}  // namespace

Reading view_of(const DepthLayout& layout, const std::uint8_t* bytes, std::size_t size) {
  DepthView view;
  const auto depth = depth_in(layout.encoding);
  if (!depth) return Unreadable{"encoding " + layout.encoding + " is not one of depths: 16UC1 or 32FC1"};
  view.depth = *depth;
  const Extent extent{layout.height, layout.width, {"bytes per pixel", view.pixel_step()}, {"step", layout.step}};
  if (const auto problem = problem_with(extent, size)) return Unreadable{*problem};
  if (const auto problem = problem_with_step(layout, view.pixel_step())) return Unreadable{*problem};
  if (const auto problem = problem_with_camera(layout)) return Unreadable{*problem};

  view.bytes = bytes;
  view.width = layout.width;
  view.height = rows_in(extent);
  view.row_step = layout.step;
  view.swapped = is_foreign(layout.is_bigendian);
  view.camera = pinhole_of(layout.camera);
  if (!is_usable(Rays(view))) return Unreadable{"P of the CameraInfo is beyond all cameras"};
  if (view.size() > 0 && !has_field_of_view(view)) {
    return Unreadable{words("P of the CameraInfo has focal lengths ", view.camera.fx, " and ", view.camera.fy, " for ",
                            view.width, " x ", view.height, " pixels: no camera sees so wide or so narrow")};
  }
  return view;
}

}  // namespace safety_control_cloud
