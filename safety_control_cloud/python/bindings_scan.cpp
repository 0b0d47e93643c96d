// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <stdexcept>

#include "../core/input/scan.hpp"
#include "bindings.hpp"

namespace bindings {
namespace {

using Ranges = py::array_t<float, py::array::c_style | py::array::forcecast>;

core::Reading reading_of(core::ScanPoints& points, const core::Scan& scan) {
  try {
    return points.of(scan);
  } catch (const std::invalid_argument& problem) {
    return core::Unreadable{problem.what()};
  }
}

/// Its points are made here, and live as long as the cloud.
BorrowedCloud cloud_of_scan(const Ranges& ranges, double angle_min, double angle_max, double angle_increment,
                            double range_min, double range_max, double time_increment, double scan_time) {
  if (ranges.ndim() != 1) throw py::value_error("ranges must have shape (N,)");
  core::Scan scan;
  scan.angle_min = angle_min, scan.angle_max = angle_max, scan.angle_increment = angle_increment;
  scan.time_increment = time_increment, scan.scan_time = scan_time;
  scan.range_min = range_min, scan.range_max = range_max;
  scan.ranges = ranges.data();
  scan.size = static_cast<std::size_t>(ranges.size());
  auto points = std::make_unique<core::ScanPoints>();
  const core::Reading reading = reading_of(*points, scan);
  return {py::capsule(points.release(), [](void* owned) { delete static_cast<core::ScanPoints*>(owned); }), reading};
}

}  // namespace

void bind_scans(py::class_<BorrowedCloud>& cloud) {
  cloud.def_static("of_scan", &cloud_of_scan, py::arg("ranges"), py::arg("angle_min"), py::arg("angle_max"),
                   py::arg("angle_increment"), py::arg("range_min"), py::arg("range_max"),
                   py::arg("time_increment") = 0.0, py::arg("scan_time") = 0.0);
}

}  // namespace bindings
