// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "../core/input/depth_layout.hpp"
#include "../core/input/layout.hpp"
#include "../core/look/kernel/scan.hpp"
#include "../core/look/outlook.hpp"
#include "../core/look/passthrough.hpp"
#include "bindings.hpp"

namespace bindings {
namespace {

std::size_t forward_stride(const py::array& points, py::ssize_t axis) {
  const py::ssize_t stride = points.strides(axis);
  if (stride < 0)
    throw py::value_error("points must not be reversed along an axis: pass numpy.ascontiguousarray(points)");
  return static_cast<std::size_t>(stride);
}

BorrowedCloud cloud_of_points(const py::array& points) {
  if (!py::isinstance<py::array_t<float>>(points))
    throw py::type_error("points must be float32 in this machine's byte order");
  const auto axes = points.ndim();
  if ((axes != 2 && axes != 3) || points.shape(axes - 1) != 3)
    throw py::value_error("points must have shape (N, 3) or (H, W, 3)");

  core::CloudView view;
  view.bytes = static_cast<const std::uint8_t*>(points.data());
  view.width = static_cast<std::size_t>(points.shape(axes - 2));
  view.height = axes == 3 ? static_cast<std::size_t>(points.shape(0)) : 1;
  view.point_step = forward_stride(points, axes - 2);
  view.row_step = axes == 3 ? forward_stride(points, 0) : view.width * view.point_step;
  const std::size_t between = forward_stride(points, axes - 1);
  view.offset = {0, between, 2 * between};
  return {points, view};
}

using FieldTuple = std::tuple<std::string, std::uint32_t, std::uint8_t, std::uint32_t>;

py::buffer_info contiguous(const py::buffer& data) {
  py::buffer_info bytes = data.request();
  if (bytes.ndim != 1 || bytes.itemsize != 1 || bytes.strides[0] != 1)
    throw py::type_error("data must be contiguous bytes");
  return bytes;
}

BorrowedCloud cloud_of_bytes(const py::buffer& data, std::uint32_t height, std::uint32_t width,
                             const std::vector<FieldTuple>& fields, bool is_bigendian, std::uint32_t point_step,
                             std::uint32_t row_step) {
  core::Layout layout{height, width, {}, is_bigendian, point_step, row_step};
  for (const auto& [name, offset, datatype, count] : fields) layout.fields.push_back({name, offset, datatype, count});
  const py::buffer_info bytes = contiguous(data);
  return {py::memoryview(data),
          core::view_of(layout, static_cast<const std::uint8_t*>(bytes.ptr), static_cast<std::size_t>(bytes.size))};
}

using Region = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

/// In the order of sensor_msgs/CameraInfo.
core::CameraClaims camera_claims(std::uint32_t height, std::uint32_t width, const std::vector<double>& D,
                                 const std::array<double, 9>& K, const std::array<double, 12>& P,
                                 std::uint32_t binning_x, std::uint32_t binning_y, const Region& roi) {
  const auto& [x_offset, y_offset, roi_height, roi_width] = roi;
  return {height, width, D, K, P, binning_x, binning_y, {x_offset, y_offset, roi_height, roi_width}};
}

BorrowedCloud cloud_of_image(const py::buffer& data, std::uint32_t height, std::uint32_t width,
                             const std::string& encoding, bool is_bigendian, std::uint32_t step, bool rectified,
                             const core::CameraClaims& camera) {
  const core::DepthLayout layout{height, width, encoding, is_bigendian, step, rectified, camera};
  const py::buffer_info bytes = contiguous(data);
  return {py::memoryview(data),
          core::view_of(layout, static_cast<const std::uint8_t*>(bytes.ptr), static_cast<std::size_t>(bytes.size))};
}

core::Depth unit_of(const py::array& image) {
  // By its name: pybind11 before 2.12 reads an item's size from where NumPy 2 has something else.
  const auto name = image.dtype().attr("name").cast<std::string>();
  if (name == "float32") return core::Depth::Metres;
  if (name == "uint16") return core::Depth::Millimetres;
  throw py::type_error("image must be float32 [m] or uint16 [mm]");
}

BorrowedCloud cloud_of_depth(const py::array& image, double fx, double fy, double cx, double cy) {
  if (image.ndim() != 2) throw py::value_error("image must have shape (H, W)");
  core::DepthView view;
  view.bytes = static_cast<const std::uint8_t*>(image.data());
  view.height = static_cast<std::size_t>(image.shape(0));
  view.width = static_cast<std::size_t>(image.shape(1));
  view.row_step = forward_stride(image, 0);
  view.depth = unit_of(image);
  view.swapped = !image.dtype().attr("isnative").cast<bool>();
  view.camera = {fx, fy, cx, cy};
  if (forward_stride(image, 1) != view.pixel_step() && view.size() > 0)
    throw py::value_error("a row's pixels must follow each other: pass numpy.ascontiguousarray(image)");
  return {image, view};
}

template <core::Sight (*Look)(const core::View&, const core::Outlook&, core::Crop, core::Rows)>
core::Sight look(const py::object& given, const core::Settings& settings, bool crop, const py::object& camera) {
  const BorrowedCloud cloud = cloud_in(given);
  const core::View view = cloud.view(settings);
  const auto outlook = core::outlook_of(settings, placing_in(camera));
  if (const auto* missing = std::get_if<core::NoTransform>(&outlook)) throw py::value_error(missing->reason);
  const py::gil_scoped_release unlocked;
  return Look(view, std::get<core::Outlook>(outlook), crop_if(crop), core::Rows::Joined);
}

}  // namespace

core::View BorrowedCloud::view(const core::Settings& settings) const {
  if (const auto* unreadable = std::get_if<core::Unreadable>(&reading)) throw py::value_error(unreadable->reason);
  return core::view_in(reading, settings);
}

core::Placing placing_in(const py::object& camera) {
  if (camera.is_none()) return core::OpticalFrame{};
  if (py::isinstance<py::str>(camera)) return core::NoTransform{camera.cast<std::string>()};
  const auto matrix = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(camera);
  if (!matrix || matrix.ndim() != 2 || matrix.shape(0) < 3 || matrix.shape(0) > 4 || matrix.shape(1) != 4)
    throw py::value_error("camera must be a matrix of shape (3, 4) or (4, 4)");
  return core::placing_of(Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(matrix.data()));
}

BorrowedCloud cloud_in(const py::object& given) {
  return py::isinstance<BorrowedCloud>(given) ? given.cast<BorrowedCloud>() : cloud_of_points(given.cast<py::array>());
}

void bind_clouds(py::module& module) {
  py::class_<core::CameraClaims>(module, "CameraClaims")
      .def(py::init(&camera_claims), py::arg("height"), py::arg("width"), py::arg("D"), py::arg("K"), py::arg("P"),
           py::arg("binning_x") = 0, py::arg("binning_y") = 0, py::arg("roi") = Region{});
  py::class_<BorrowedCloud> cloud(module, "Cloud");
  cloud.def(py::init(&cloud_of_points), py::arg("points"))
      .def_static("of_bytes", &cloud_of_bytes, py::arg("data"), py::arg("height"), py::arg("width"), py::arg("fields"),
                  py::arg("is_bigendian"), py::arg("point_step"), py::arg("row_step"))
      .def_static("of_depth", &cloud_of_depth, py::arg("image"), py::arg("fx"), py::arg("fy"), py::arg("cx"),
                  py::arg("cy"))
      .def_static("of_image", &cloud_of_image, py::arg("data"), py::arg("height"), py::arg("width"),
                  py::arg("encoding"), py::arg("is_bigendian"), py::arg("step"), py::arg("rectified"),
                  py::arg("camera"))
      .def_property_readonly("unreadable", [](const BorrowedCloud& cloud) -> py::object {
        const auto* unreadable = std::get_if<core::Unreadable>(&cloud.reading);
        return unreadable ? py::object(py::str(unreadable->reason)) : py::none();
      });
  bind_scans(cloud);
  module.def("look", &look<core::look>, py::arg("cloud"), py::arg("settings") = core::Settings{},
             py::arg("crop") = false, py::arg("camera") = py::none());
  module.def("passthrough", &look<core::passthrough>, py::arg("cloud"), py::arg("settings") = core::Settings{},
             py::arg("crop") = false, py::arg("camera") = py::none());
  module.def("instruction_sets", &core::instruction_sets);
  module.def("use_instruction_set", &core::use_instruction_set, py::arg("name") = "");
}

}  // namespace bindings
