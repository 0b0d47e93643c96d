// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>
#include <vector>

#include "../core/path/contact.hpp"
#include "../core/path/escape.hpp"
#include "../core/speed/fan.hpp"
#include "../core/speed/limit.hpp"
#include "bindings.hpp"

namespace bindings {
namespace {

using Pair = std::array<double, 2>;
using Triple = std::array<double, 3>;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

core::Twist2 twist_of(const Triple& twist) { return {twist[0], twist[1], twist[2]}; }
Triple triple_of(const core::Twist2& twist) { return {twist.vx, twist.vy, twist.w}; }

/// Made by numpy itself, and read and written by their numbers, one after the other: pybind11 before 2.12 misreads the
/// types of numpy 2, and with them how far numbers lie apart.
template <class... Sizes>
Array empty(Sizes... sizes) {
  return py::module_::import("numpy").attr("empty")(py::make_tuple(sizes...)).template cast<Array>();
}

std::vector<core::Point2> points_of(const Array& array) {
  if (array.ndim() != 2 || array.shape(1) != 2) throw py::value_error("points must have shape (N, 2)");
  std::vector<core::Point2> points(static_cast<std::size_t>(array.shape(0)));
  const double* numbers = array.data();
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {numbers[2 * i], numbers[2 * i + 1]};
  return points;
}

Array array_of(const std::vector<core::Point2>& points) {
  Array array = empty(points.size(), 2);
  double* numbers = array.mutable_data();
  for (std::size_t i = 0; i < points.size(); ++i) numbers[2 * i] = points[i].x, numbers[2 * i + 1] = points[i].y;
  return array;
}

core::Footprint footprint_of(const std::vector<Pair>& polygon, double radius, double margin) {
  core::Footprint footprint{{}, radius, margin};
  for (const Pair& corner : polygon) footprint.polygon.push_back({corner[0], corner[1]});
  return footprint;
}

/// One number for each point.
template <class Ask>
Array each(const Array& points, Ask ask) {
  const std::vector<core::Point2> places = points_of(points);
  Array answers = empty(places.size());
  std::transform(places.begin(), places.end(), answers.mutable_data(), ask);
  return answers;
}

Array time_to_contact(const core::Outline& outline, const Triple& twist, const Array& points, double widening,
                      double horizon) {
  const core::Sweep sweep(outline, twist_of(twist), widening, horizon);
  return each(points, [&](const core::Point2& point) { return sweep.time_to_contact(point); });
}

std::tuple<Array, std::vector<std::uint32_t>, double> reduced(const Array& points, double cell) {
  const core::Obstacles obstacles = core::reduced(points_of(points), cell);
  return {array_of(obstacles.points), obstacles.counts, obstacles.widening};
}

core::Limit limit(const core::Outline& outline, const core::Law& law, const Array& points, const Triple& wanted,
                  const std::vector<Triple>& under_way, double age) {
  std::vector<core::Twist2> twists;
  for (const Triple& twist : under_way) twists.push_back(twist_of(twist));
  return core::limit(outline, law, {points_of(points), {}, 0.0}, {age}, {std::move(twists)}, twist_of(wanted));
}

core::Law law_of(const py::kwargs& numbers) {
  core::Law law;
  const py::object in_python = py::cast(&law, py::return_value_policy::reference);
  for (const auto& [name, value] : numbers) py::setattr(in_python, name, value);
  const auto problems = core::problems_in(law);
  if (!problems.empty()) throw py::value_error(problems.front());
  return law;
}

void bind_footprint(py::module& module) {
  const auto made = [](const std::vector<Pair>& polygon, double radius, double margin) {
    return core::Outline(footprint_of(polygon, radius, margin));
  };
  py::class_<core::Outline>(module, "Footprint")
      .def(py::init(made), py::arg("polygon") = std::vector<Pair>{}, py::arg("radius") = 0.0, py::arg("margin") = 0.0)
      .def("signed_distance", [](const core::Outline& outline, const Array& points) {
        return each(points, [&](const core::Point2& point) { return outline.signed_distance(point); });
      });
  module.def(
      "problems_in_footprint",
      [](const std::vector<Pair>& polygon, double radius, double margin) {
        return core::problems_in(footprint_of(polygon, radius, margin));
      },
      py::arg("polygon") = std::vector<Pair>{}, py::arg("radius") = 0.0, py::arg("margin") = 0.0);
}

void bind_law(py::module& module) {
  py::class_<core::Law>(module, "Law")
      .def(py::init(&law_of))
      .def_readwrite("sensor_period", &core::Law::sensor_period)
      .def_readwrite("latency", &core::Law::latency)
      .def_readwrite("base_reaction", &core::Law::base_reaction)
      .def_readwrite("linear_deceleration", &core::Law::linear_deceleration)
      .def_readwrite("angular_deceleration", &core::Law::angular_deceleration)
      .def_readwrite("obstacle_speed", &core::Law::obstacle_speed)
      .def_readwrite("escape_speed", &core::Law::escape_speed)
      .def_readwrite("noise", &core::Law::noise)
      .def_readwrite("min_points", &core::Law::min_points);
  py::class_<core::Limit>(module, "Limit")
      .def_readonly("factor", &core::Limit::factor)
      .def_readonly("is_escape", &core::Limit::is_escape)
      .def_property_readonly("time", [](const core::Limit& limit) { return limit.contact.time; })
      .def_property_readonly("point", [](const core::Limit& limit) { return limit.contact.point; });
}

}  // namespace

void bind_path(py::module& module) {
  bind_footprint(module);
  bind_law(module);
  module.def("time_to_contact", &time_to_contact, py::arg("footprint"), py::arg("twist"), py::arg("points"),
             py::arg("widening") = 0.0, py::arg("horizon") = std::numeric_limits<double>::infinity());
  module.def(
      "moved",
      [](const Array& points, const Triple& twist, double time) {
        std::vector<core::Point2> moved = points_of(points);
        for (core::Point2& point : moved) point = core::moved(point, twist_of(twist), time);
        return array_of(moved);
      },
      py::arg("points"), py::arg("twist"), py::arg("time"));
  module.def("reduced", &reduced, py::arg("points"), py::arg("cell"));
  module.def(
      "limited", [](const Triple& twist, double factor) { return triple_of(core::limited(twist_of(twist), factor)); },
      py::arg("twist"), py::arg("factor"));
  module.def(
      "greatest_factor",
      [](double time, double delay, double reaction, double braking, double share) {
        return core::greatest_factor(time, {delay, reaction, braking}, share);
      },
      py::arg("time"), py::arg("delay"), py::arg("reaction"), py::arg("braking"), py::arg("share") = 0.0);
  module.def(
      "straying",
      [](const core::Outline& outline, const core::Law& law, const Triple& under_way, const Triple& wanted,
         double least, double most, double age) {
        const core::Straying off = core::straying(outline, law, core::response_to(law, {age}, twist_of(wanted)),
                                                  twist_of(under_way), twist_of(wanted), {least, most});
        return std::make_tuple(off.share, off.widening);
      },
      py::arg("footprint"), py::arg("law"), py::arg("under_way"), py::arg("wanted"), py::arg("least") = 0.0,
      py::arg("most") = 1.0, py::arg("age") = 0.0);
  module.def(
      "fan",
      [](const core::Outline& outline, const core::Law& law, const Triple& under_way, const Triple& wanted,
         double least, double most, double age) {
        const auto fan = core::fan(outline, law, core::response_to(law, {age}, twist_of(wanted)), twist_of(under_way),
                                   twist_of(wanted), {least, most});
        std::vector<Triple> twists;
        if (fan) std::transform(fan->twists.begin(), fan->twists.end(), std::back_inserter(twists), triple_of);
        return fan ? std::optional(std::make_tuple(fan->share, twists, fan->widening)) : std::nullopt;
      },
      py::arg("footprint"), py::arg("law"), py::arg("under_way"), py::arg("wanted"), py::arg("least") = 0.0,
      py::arg("most") = 1.0, py::arg("age") = 0.0);
  module.def("limit", &limit, py::arg("footprint"), py::arg("law"), py::arg("points"), py::arg("wanted"),
             py::arg("under_way") = std::vector<Triple>{}, py::arg("age") = 0.0);
}

}  // namespace bindings
