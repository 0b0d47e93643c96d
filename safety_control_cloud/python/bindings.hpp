// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>

#include "../core/safety_control.hpp"

namespace py = pybind11;
namespace core = safety_control_cloud;

namespace bindings {

/// A reading together with the Python object whose bytes it borrows.
struct BorrowedCloud {
  py::object owner;
  core::Reading reading;

  core::View view(const core::Settings& settings) const;  ///< throws ValueError if the reading is unreadable
};

inline core::Crop crop_if(bool wanted) { return wanted ? core::Crop::Keep : core::Crop::Skip; }

/// A Cloud as it is, or the points of an array.
BorrowedCloud cloud_in(const py::object& given);

/// Where a camera is, by the matrix that takes its frame to target_frame; None: in its own.
core::Placing placing_in(const py::object& camera);

/// Where no ROS time is given, the caller's 0 is a time like any other, and not ROS's for "none".
inline core::Instant instant_of(double now, std::optional<double> ros_now) {
  constexpr double just_after_zero = 1e-9;
  return {now, ros_now.value_or(now == 0.0 ? just_after_zero : now)};
}

void bind_settings(py::module& module);  ///< first: all that takes Settings has them as a default
void bind_clouds(py::module& module);
void bind_scans(py::class_<BorrowedCloud>& cloud);
void bind_results(py::module& module);
void bind_path(py::module& module);
void bind_guard(py::module& module);

/// core.pyi's docstrings, for help(); last. pybind11 itself takes one only where a function is defined.
void document(py::module& module);

}  // namespace bindings
