// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string>

#include "bindings.hpp"

namespace bindings {
namespace {

/// (N, 3) float32 over the crop's own memory.
py::object array_over(const core::Cloud::Ptr& crop) {
  if (!crop) return py::none();
  const py::capsule owner(new core::Cloud::Ptr(crop), [](void* held) { delete static_cast<core::Cloud::Ptr*>(held); });
  const auto count = static_cast<py::ssize_t>(crop->size());
  constexpr auto step = static_cast<py::ssize_t>(sizeof(core::Point)), value = static_cast<py::ssize_t>(sizeof(float));
  return py::array_t<float>({count, py::ssize_t{3}}, {step, value}, reinterpret_cast<const float*>(crop->points.data()),
                            owner);
}

py::tuple point_of(const core::Obstacle& obstacle) {
  return py::make_tuple(obstacle.point.x, obstacle.point.y, obstacle.point.z);
}

py::str text_of(const core::Obstacle& obstacle) {
  return py::str("Obstacle(distance={:.3f}, point=({:.3f}, {:.3f}, {:.3f}))")
      .format(obstacle.distance(), obstacle.point.x, obstacle.point.y, obstacle.point.z);
}

py::object text_of(const std::optional<core::Obstacle>& obstacle) {
  return obstacle ? py::object(text_of(*obstacle)) : py::none();
}

py::str text_of(const core::Sight& sight) {
  return py::str("Sight(nearest={}, inside={}, too_close={}, returns={}, total={})")
      .format(text_of(sight.nearest), sight.inside, sight.too_close, sight.returns, sight.total);
}

py::str text_of(const core::Decision& decision) {
  return py::str("Decision(zone={}, speed={:g}, cause={}, nearest={}, reason={!r})")
      .format(core::name_of(decision.zone), decision.speed, core::name_of(decision.cause), text_of(decision.nearest),
              decision.reason);
}

}  // namespace

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
      .value("TWO_SOURCES", core::Cause::TwoSources)
      .value("LOW_OBSTACLE", core::Cause::LowObstacle)
      .value("TWO_COMMANDERS", core::Cause::TwoCommanders)
      .value("WRONG_VIEW", core::Cause::WrongView)
      .value("NO_TIME", core::Cause::NoTime)
      .value("NO_COMMAND", core::Cause::NoCommand)
      .value("BAD_COMMAND", core::Cause::BadCommand)
      .value("NO_ODOMETRY", core::Cause::NoOdometry)
      .value("BUMPER", core::Cause::Bumper)
      .value("CLIFF", core::Cause::Cliff);
  py::class_<core::Obstacle>(module, "Obstacle")
      .def_property_readonly("distance", &core::Obstacle::distance)
      .def_property_readonly("point", &point_of)
      .def("__repr__", [](const core::Obstacle& obstacle) { return text_of(obstacle); });
  py::class_<core::Sight>(module, "Sight")
      .def_readonly("nearest", &core::Sight::nearest)
      .def_readonly("inside", &core::Sight::inside)
      .def_readonly("too_close", &core::Sight::too_close)
      .def_readonly("returns", &core::Sight::returns)
      .def_readonly("total", &core::Sight::total)
      .def_property_readonly("crop", [](const core::Sight& sight) { return array_over(sight.crop); })
      .def("__repr__", [](const core::Sight& sight) { return text_of(sight); });
  py::class_<core::Decision>(module, "Decision")
      .def_readonly("zone", &core::Decision::zone)
      .def_readonly("speed", &core::Decision::speed)
      .def_readonly("cause", &core::Decision::cause)
      .def_readonly("reason", &core::Decision::reason)
      .def_readonly("stuck_since", &core::Decision::stuck_since)
      .def_readonly("hint", &core::Decision::hint)
      .def_readonly("nearest", &core::Decision::nearest)
      .def_readonly("sight", &core::Decision::sight)
      .def("__repr__", [](const core::Decision& decision) { return text_of(decision); });
}

}  // namespace bindings
