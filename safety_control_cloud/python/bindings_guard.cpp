// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "../core/guard_control.hpp"
#include "bindings.hpp"

namespace bindings {
namespace {

using Triple = std::array<double, 3>;

void see(core::GuardControl& control, const py::object& given, double now, std::optional<double> stamp,
         std::optional<double> ros_now, const py::object& camera, const std::string& source, const std::string& frame,
         std::size_t sensor) {
  if (sensor >= core::sensors_of(control.settings()).size()) throw py::index_error("there is no such sensor");
  const BorrowedCloud cloud = cloud_in(given);
  const core::Instant instant = instant_of(now, ros_now);
  const core::Origin origin{stamp.value_or(instant.ros), placing_in(camera), source, frame};
  const py::gil_scoped_release unlocked;
  control.see(cloud.reading, origin, instant, sensor);
}

void want(core::GuardControl& control, const Triple& linear, const Triple& angular, double now,
          std::optional<double> stamp, std::optional<double> ros_now) {
  control.want({linear, angular}, instant_of(now, ros_now), stamp);
}

void note_switch(core::GuardControl& control, const std::string& which, const std::string& side, bool touched,
                 double now, const std::string& who) {
  const core::Switches& switches = control.settings().switches;
  const auto found = std::find_if(switches.begin(), switches.end(), [&](const auto& one) { return one.name == which; });
  if (found == switches.end()) throw py::value_error("there is no switch " + which);
  const auto edge = core::edge_named(side);
  if (!edge) throw py::value_error("a robot has no side " + side);
  control.note_switch(static_cast<std::size_t>(found - switches.begin()), who, *edge, touched, instant_of(now, {}));
}

py::tuple ask_override(core::GuardControl& control, double seconds, double speed, double now,
                       std::optional<double> ros_now, bool even_in_doubt) {
  const auto reply = control.ask_override({seconds, speed, even_in_doubt}, instant_of(now, ros_now));
  return py::make_tuple(reply.granted, reply.words);
}

py::object pair_of(const std::optional<core::Point2>& point) {
  return point ? py::object(py::make_tuple(point->x, point->y)) : py::none();
}

py::str text_of(const core::Guarded& guarded) {
  const core::Twist2 given = in_plane(guarded.given);
  return py::str("Guarded(factor={:g}, given=({:g}, {:g}, {:g}), cause={}, point={}, reason={!r})")
      .format(guarded.factor, given.vx, given.vy, given.w, core::name_of(guarded.cause), pair_of(guarded.point),
              guarded.reason);
}

}  // namespace

void bind_guard(py::module& module) {
  py::class_<core::Command>(module, "Command")
      .def(py::init([](const Triple& linear, const Triple& angular) {
             return core::Command{linear, angular};
           }),
           py::arg("linear") = Triple{}, py::arg("angular") = Triple{})
      .def_readonly("linear", &core::Command::linear)
      .def_readonly("angular", &core::Command::angular);
  py::class_<core::Guarded>(module, "Guarded")
      .def_readonly("wanted", &core::Guarded::wanted)
      .def_readonly("given", &core::Guarded::given)
      .def_readonly("factor", &core::Guarded::factor)
      .def_readonly("time_to_contact", &core::Guarded::time_to_contact)
      .def_property_readonly("point", [](const core::Guarded& guarded) { return pair_of(guarded.point); })
      .def_readonly("sensor", &core::Guarded::sensor)
      .def_readonly("cause", &core::Guarded::cause)
      .def_readonly("reason", &core::Guarded::reason)
      .def_readonly("hint", &core::Guarded::hint)
      .def_readonly("in_view", &core::Guarded::in_view)
      .def_property_readonly("stuck_since",
                             [](const core::Guarded& guarded) {
                               return guarded.stuck ? std::optional(guarded.stuck_since) : std::nullopt;
                             })
      .def_readonly("open", &core::Guarded::open)
      .def_readonly("override_left", &core::Guarded::override_left)
      .def_readonly("sight", &core::Guarded::sight)
      .def("__repr__", [](const core::Guarded& guarded) { return text_of(guarded); });
  py::class_<core::GuardControl>(module, "GuardControl")
      .def(py::init<const core::Settings&>(), py::arg("settings"))
      .def("see", &see, py::arg("cloud"), py::arg("now"), py::arg("stamp") = py::none(),
           py::arg("ros_now") = py::none(), py::arg("camera") = py::none(), py::arg("source") = "",
           py::arg("frame") = "", py::arg("sensor") = 0)
      .def("want", &want, py::arg("linear"), py::arg("angular"), py::arg("now"), py::arg("stamp") = py::none(),
           py::arg("ros_now") = py::none())
      .def(
          "note_odometry",
          [](core::GuardControl& control, double stamp, const Triple& pose, const Triple& twist, const Triple& base) {
            control.note_odometry(stamp, {{pose[0], pose[1]}, pose[2]}, {twist[0], twist[1], twist[2]},
                                  {{base[0], base[1]}, base[2]});
          },
          py::arg("stamp"), py::arg("pose"), py::arg("twist"), py::arg("base") = Triple{})
      .def_property_readonly("answer_period", &core::GuardControl::answer_period)
      .def(
          "note_pose",
          [](core::GuardControl& control, double stamp, const Triple& pose) {
            control.note_pose(stamp, {{pose[0], pose[1]}, pose[2]});
          },
          py::arg("stamp"), py::arg("pose"))
      .def(
          "note_outside",
          [](core::GuardControl& control, const std::optional<core::Cause>& cause, const std::string& reason) {
            control.note_outside(cause ? std::optional(core::Doubt{*cause, reason}) : std::nullopt);
          },
          py::arg("cause"), py::arg("reason") = "")
      .def("note_switch", &note_switch, py::arg("which"), py::arg("side"), py::arg("touched"), py::arg("now"),
           py::arg("who") = "driver")
      .def("ask_override", &ask_override, py::arg("seconds"), py::arg("speed"), py::arg("now"),
           py::arg("ros_now") = py::none(), py::arg("even_in_doubt") = false)
      .def(
          "answer",
          [](core::GuardControl& control, double now, std::optional<double> ros_now) {
            return control.answer(instant_of(now, ros_now));  // a copy: what it refers to changes with every answer
          },
          py::arg("now"), py::arg("ros_now") = py::none())
      .def("until_silent", &core::GuardControl::until_silent, py::arg("now"))
      .def("adopt", &core::GuardControl::adopt, py::arg("settings"))
      .def("forget_losses", &core::GuardControl::forget_losses)
      .def("remembered", &core::GuardControl::remembered)
      .def("recall", &core::GuardControl::recall, py::arg("remembered"));
}

}  // namespace bindings
