// SPDX-License-Identifier: BSD-3-Clause
// safety_control_cloud.core: the C++ decision for Python. Types and docstrings stand in core.pyi.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <type_traits>
#include <utility>

#include "../core/passthrough.hpp"
#include "../core/safety_control.hpp"
#include "../core/scan.hpp"

namespace py = pybind11;
namespace core = safety_control_cloud;

namespace {

/// A reading together with the Python object whose bytes it borrows.
struct BorrowedCloud {
  py::object owner;
  core::Reading reading;

  core::View view() const {
    if (const auto* unreadable = std::get_if<core::Unreadable>(&reading)) throw py::value_error(unreadable->reason);
    return core::view_in(reading);
  }
};

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

BorrowedCloud cloud_of_bytes(const py::buffer& data, std::uint32_t height, std::uint32_t width,
                             const std::vector<FieldTuple>& fields, bool is_bigendian, std::uint32_t point_step,
                             std::uint32_t row_step) {
  core::Layout layout{height, width, {}, is_bigendian, point_step, row_step};
  for (const auto& [name, offset, datatype, count] : fields) layout.fields.push_back({name, offset, datatype, count});
  const py::buffer_info bytes = data.request();
  if (bytes.ndim != 1 || bytes.itemsize != 1 || bytes.strides[0] != 1)
    throw py::type_error("data must be contiguous bytes");
  return {data,
          core::view_of(layout, static_cast<const std::uint8_t*>(bytes.ptr), static_cast<std::size_t>(bytes.size))};
}

core::Depth unit_of(const py::array& image) {
  const py::dtype dtype = image.dtype();
  if (dtype.kind() == 'f' && dtype.itemsize() == 4) return core::Depth::Metres;
  if (dtype.kind() == 'u' && dtype.itemsize() == 2) return core::Depth::Millimetres;
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

/// A Cloud as it is, or the points of an array.
BorrowedCloud cloud_in(const py::object& given) {
  return py::isinstance<BorrowedCloud>(given) ? given.cast<BorrowedCloud>() : cloud_of_points(given.cast<py::array>());
}

core::Crop crop_if(bool wanted) { return wanted ? core::Crop::Keep : core::Crop::Skip; }

template <core::Sight (*Look)(const core::View&, const core::Corridor&, const core::Gaze&)>
core::Sight look(const py::object& given, const core::Settings& settings, bool crop) {
  const BorrowedCloud cloud = cloud_in(given);
  const core::View view = cloud.view();
  const py::gil_scoped_release unlocked;
  core::Gaze gaze;
  gaze.crop = crop_if(crop);
  return Look(view, settings.corridor, gaze);
}

/// With stamp and ros_now left out, every cloud is as old as it should be.
core::Decision decide(core::SafetyControl& control, const py::object& given, double now, bool crop,
                      std::optional<double> stamp, std::optional<double> ros_now) {
  const BorrowedCloud cloud = cloud_in(given);
  const core::Instant instant{now, ros_now.value_or(now)};
  const core::Origin origin{stamp.value_or(instant.ros), core::OpticalFrame{}};
  const py::gil_scoped_release unlocked;
  return control.decide(cloud.reading, origin, instant, crop_if(crop));
}

core::Decision without_cloud(core::SafetyControl& control, double now, std::optional<double> ros_now) {
  return control.without_cloud(core::Instant{now, ros_now.value_or(now)});
}

/// (N, 3) float32 over the crop's own memory.
py::object array_over(const core::Cloud::Ptr& crop) {
  if (!crop) return py::none();
  const py::capsule owner(new core::Cloud::Ptr(crop), [](void* held) { delete static_cast<core::Cloud::Ptr*>(held); });
  const auto count = static_cast<py::ssize_t>(crop->size());
  constexpr auto step = static_cast<py::ssize_t>(sizeof(core::Point)), value = static_cast<py::ssize_t>(sizeof(float));
  return py::array_t<float>({count, py::ssize_t{3}}, {step, value}, reinterpret_cast<const float*>(crop->points.data()),
                            owner);
}

template <class Value>
py::object object_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return py::str(core::name_of(value));
  } else {
    return py::cast(value);
  }
}

template <class Choice, class Named>
void take_choice(const py::handle& given, Choice& value, Named named, const char* otherwise) {
  const std::optional<Choice> choice = named(given.cast<std::string>());
  if (!choice) throw py::value_error(otherwise);
  value = *choice;
}

template <class Value>
void take(const py::handle& given, Value& value) {
  value = given.cast<Value>();
}
void take(const py::handle& given, core::Input& value) {
  take_choice(given, value, core::input_named, "input must be 'cloud' or 'depth'");
}
void take(const py::handle& given, core::Method& value) {
  take_choice(given, value, core::method_named, "method must be 'one_pass' or 'pcl'");
}

py::error_already_set no_parameter(const std::string& name) {
  PyErr_SetString(PyExc_AttributeError, ("there is no parameter " + name).c_str());
  return py::error_already_set();
}

py::dict parameters_of(const core::Settings& settings) {
  py::dict parameters;
  core::for_each_parameter(settings, [&](const char* name, const auto& value) { parameters[name] = object_of(value); });
  return parameters;
}

void set_parameter(core::Settings& settings, const std::string& name, const py::handle& given) {
  bool known = false;
  core::for_each_parameter(settings, [&](const char* candidate, auto& value) {
    if (name != candidate) return;
    known = true;
    take(given, value);
  });
  if (!known) throw no_parameter(name);
}

void bind_settings(py::module& module) {
  py::class_<core::Settings>(module, "Settings")
      .def(py::init([](const py::kwargs& parameters) {
        core::Settings settings;
        for (const auto& [name, value] : parameters) set_parameter(settings, name.cast<std::string>(), value);
        return settings;
      }))
      .def("__getattr__",
           [](const core::Settings& settings, const std::string& name) {
             const py::dict parameters = parameters_of(settings);
             if (!parameters.contains(name)) throw no_parameter(name);
             return py::object(parameters[name.c_str()]);
           })
      .def("__setattr__", &set_parameter)
      .def("__repr__",
           [](const core::Settings& settings) { return py::str("Settings({})").format(parameters_of(settings)); })
      .def("as_dict", &parameters_of)
      .def("problems", &core::problems_in);
}

void bind_clouds(py::module& module) {
  py::class_<BorrowedCloud>(module, "Cloud")
      .def(py::init(&cloud_of_points), py::arg("points"))
      .def_static("of_bytes", &cloud_of_bytes, py::arg("data"), py::arg("height"), py::arg("width"), py::arg("fields"),
                  py::arg("is_bigendian"), py::arg("point_step"), py::arg("row_step"))
      .def_static("of_depth", &cloud_of_depth, py::arg("image"), py::arg("fx"), py::arg("fy"), py::arg("cx"),
                  py::arg("cy"))
      .def_property_readonly("unreadable", [](const BorrowedCloud& cloud) -> py::object {
        const auto* unreadable = std::get_if<core::Unreadable>(&cloud.reading);
        return unreadable ? py::object(py::str(unreadable->reason)) : py::none();
      });
  module.def("look", &look<core::look>, py::arg("cloud"), py::arg("settings") = core::Settings{},
             py::arg("crop") = false);
  module.def("passthrough", &look<core::passthrough>, py::arg("cloud"), py::arg("settings") = core::Settings{},
             py::arg("crop") = false);
  module.def("instruction_sets", &core::instruction_sets);
  module.def("use_instruction_set", &core::use_instruction_set, py::arg("name") = "");
}

void bind_results(py::module& module) {
  py::enum_<core::Zone>(module, "Zone")
      .value("DANGER", core::Zone::Danger)
      .value("WARNING", core::Zone::Warning)
      .value("SAFE", core::Zone::Safe);
  py::enum_<core::Cause>(module, "Cause")
      .value("SEEN", core::Cause::Seen)
      .value("NO_CLOUD", core::Cause::NoCloud)
      .value("SILENT", core::Cause::Silent)
      .value("UNREADABLE", core::Cause::Unreadable)
      .value("BLIND", core::Cause::Blind)
      .value("STALE", core::Cause::Stale)
      .value("FUTURE", core::Cause::Future)
      .value("CLOCK_JUMP", core::Cause::ClockJump)
      .value("NEAR_LOSS", core::Cause::NearLoss)
      .value("FROZEN", core::Cause::Frozen)
      .value("NO_TRANSFORM", core::Cause::NoTransform)
      .value("TWO_SOURCES", core::Cause::TwoSources);
  py::class_<core::Obstacle>(module, "Obstacle")
      .def_property_readonly("distance", &core::Obstacle::distance)
      .def_property_readonly("point", [](const core::Obstacle& obstacle) {
        return py::make_tuple(obstacle.point.x, obstacle.point.y, obstacle.point.z);
      });
  py::class_<core::Sight>(module, "Sight")
      .def_readonly("nearest", &core::Sight::nearest)
      .def_readonly("inside", &core::Sight::inside)
      .def_readonly("too_close", &core::Sight::too_close)
      .def_readonly("returns", &core::Sight::returns)
      .def_readonly("total", &core::Sight::total)
      .def_readonly("lost", &core::Sight::lost)
      .def_property_readonly("crop", [](const core::Sight& sight) { return array_over(sight.crop); });
  py::class_<core::Decision>(module, "Decision")
      .def_readonly("zone", &core::Decision::zone)
      .def_readonly("speed", &core::Decision::speed)
      .def_readonly("cause", &core::Decision::cause)
      .def_readonly("reason", &core::Decision::reason)
      .def_readonly("nearest", &core::Decision::nearest)
      .def_readonly("sight", &core::Decision::sight);
}

}  // namespace

PYBIND11_MODULE(core, module) {
  module.doc() = "The decision of safety_control_cloud: the same C++ code that the node runs.";
  bind_settings(module);
  bind_clouds(module);
  bind_results(module);
  module.def(
      "zone_at",
      [](double distance, const core::Settings& settings) { return core::zone_at(distance, settings.limits); },
      py::arg("distance"), py::arg("settings") = core::Settings{});
  module.def(
      "speed_for",
      [](core::Zone zone, const core::Settings& settings) { return core::speed_for(zone, settings.speeds); },
      py::arg("zone"), py::arg("settings") = core::Settings{});
  py::class_<core::SafetyControl>(module, "SafetyControl")
      .def(py::init<const core::Settings&>(), py::arg("settings") = core::Settings{})
      .def("decide", &decide, py::arg("cloud"), py::arg("now"), py::arg("crop") = false, py::arg("stamp") = py::none(),
           py::arg("ros_now") = py::none())
      .def("without_cloud", &without_cloud, py::arg("now"), py::arg("ros_now") = py::none())
      .def("forget_losses", &core::SafetyControl::forget_losses);
}
