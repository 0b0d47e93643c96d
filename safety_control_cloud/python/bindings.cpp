// SPDX-License-Identifier: BSD-3-Clause
// safety_control_cloud.core: the C++ decision for Python. Types and docstrings stand in core.pyi alone.
#include "bindings.hpp"

#include <optional>
#include <string>

#include "../core/speed/speed.hpp"

namespace {

/// With stamp and ros_now left out, every cloud is as old as it should be.
core::Decision decide(core::SafetyControl& control, const py::object& given, double now, bool crop,
                      std::optional<double> stamp, std::optional<double> ros_now, const py::object& camera,
                      const std::string& source, const std::string& frame) {
  const bindings::BorrowedCloud cloud = bindings::cloud_in(given);
  const core::Instant instant = bindings::instant_of(now, ros_now);
  const core::Origin origin{stamp.value_or(instant.ros), bindings::placing_in(camera), source, frame};
  const py::gil_scoped_release unlocked;
  return control.decide(cloud.reading, origin, instant, bindings::crop_if(crop));
}

core::Decision without_cloud(core::SafetyControl& control, double now, std::optional<double> ros_now) {
  return control.without_cloud(bindings::instant_of(now, ros_now));
}

void bind_rules(py::module& module) {
  module.def(
      "zone_at",
      [](double distance, const core::Settings& settings) { return core::zone_at(distance, settings.limits); },
      py::arg("distance"), py::arg("settings") = core::Settings{});
  module.def(
      "speed_for",
      [](core::Zone zone, const core::Settings& settings) { return core::speed_for(zone, settings.speeds); },
      py::arg("zone"), py::arg("settings") = core::Settings{});
}

void bind_control(py::module& module) {
  py::class_<core::SafetyControl>(module, "SafetyControl")
      .def(py::init<const core::Settings&>(), py::arg("settings") = core::Settings{})
      .def("decide", &decide, py::arg("cloud"), py::arg("now"), py::arg("crop") = false, py::arg("stamp") = py::none(),
           py::arg("ros_now") = py::none(), py::arg("camera") = py::none(), py::arg("source") = "",
           py::arg("frame") = "")
      .def("without_cloud", &without_cloud, py::arg("now"), py::arg("ros_now") = py::none())
      .def("forget_losses", &core::SafetyControl::forget_losses)
      .def("remembered", &core::SafetyControl::remembered);
}

}  // namespace

PYBIND11_MODULE(core, module) {
  module.doc() = "The decision of safety_control_cloud: the same C++ code that the node runs.";
  bindings::bind_settings(module);
  bindings::bind_clouds(module);
  bindings::bind_results(module);
  bindings::bind_path(module);
  bindings::bind_guard(module);
  bind_rules(module);
  bind_control(module);
  bindings::document(module);
}
