// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string>
#include <type_traits>

#include "bindings.hpp"

namespace bindings {
namespace {

template <class Value>
py::object object_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return py::str(core::name_of(value));
  } else {
    return py::cast(value);
  }
}

py::object object_of(const core::Lists& lists) { return py::str(lists.text); }

py::object object_of(const core::Sensors& sensors) {
  py::list list;
  for (const core::SensorSettings& sensor : sensors) {
    py::dict entry;
    entry["name"] = sensor.name;
    entry["type"] = core::name_of(sensor.type);
    entry["topic"] = sensor.topic;
    entry["required"] = sensor.required;
    for (const auto& [name, value] : sensor.own) entry[name.c_str()] = value;
    list.append(entry);
  }
  return list;
}

py::object object_of(const core::Switches& switches) {
  py::list list;
  for (const core::SwitchSettings& one : switches) {
    py::dict entry;
    entry["name"] = one.name;
    entry["type"] = core::name_of(one.type);
    entry["topic"] = one.topic;
    if (one.side) entry["side"] = core::name_of(*one.side);
    entry["timeout"] = one.timeout;
    list.append(entry);
  }
  return list;
}

template <class Choice, class Named>
void take_choice(const py::handle& given, Choice& value, Named named, const char* otherwise) {
  const auto choice = py::isinstance<py::str>(given) ? named(given.cast<std::string>()) : std::nullopt;
  if (!choice) throw py::value_error(otherwise);
  value = *choice;
}

template <class Value>
const char* kind_of(const Value&) {
  if constexpr (std::is_same_v<Value, bool>) return "True or False";
  return std::is_same_v<Value, std::string> ? "a name" : std::is_integral_v<Value> ? "a whole number" : "a number";
}

template <class Value>
void take(const py::handle& given, Value& value, const std::string& name) {
  try {
    value = given.cast<Value>();
  } catch (const py::cast_error&) {
    throw py::type_error(name + " must be " + kind_of(value));
  }
}
void take(const py::handle& given, core::Lists& value, const std::string& name) { take(given, value.text, name); }
void take(const py::handle& given, core::Mode& value, const std::string&) {
  take_choice(given, value, core::mode_named, "mode must be 'drive' or 'guard'");
}
void take(const py::handle& given, core::CommandType& value, const std::string&) {
  take_choice(given, value, core::command_type_named, "command_type must be 'twist' or 'twist_stamped'");
}
void take(const py::handle& given, core::InputKind& value, const std::string&) {
  take_choice(given, value, core::input_named, "input must be 'cloud', 'depth' or 'scan'");
}
void take(const py::handle& given, core::MinusInf& value, const std::string&) {
  take_choice(given, value, core::minus_inf_named, "depth_minus_inf must be 'too_close' or 'nothing'");
}
void take(const py::handle& given, core::Method& value, const std::string&) {
  take_choice(given, value, core::method_named, "method must be 'one_pass' or 'pcl'");
}

core::SensorSettings sensor_in(const py::handle& given) {
  core::SensorSettings sensor;
  if (!py::isinstance<py::dict>(given)) throw py::type_error("each of sensors must be a dict");
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const std::string name = key.cast<std::string>();
    if (name == "name") {
      take(value, sensor.name, name);
    } else if (name == "type") {
      take(value, sensor.type, name);
    } else if (name == "topic") {
      take(value, sensor.topic, name);
    } else if (name == "required") {
      take(value, sensor.required, name);
    } else {
      take(value, sensor.own[name], name);
    }
  }
  return sensor;
}

core::SwitchSettings switch_in(const py::handle& given) {
  core::SwitchSettings one;
  if (!py::isinstance<py::dict>(given)) throw py::type_error("each of switches must be a dict");
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const std::string name = key.cast<std::string>();
    if (name == "name") {
      take(value, one.name, name);
    } else if (name == "type") {
      take_choice(value, one.type, core::switch_named, "type must be 'bumper' or 'cliff'");
    } else if (name == "topic") {
      take(value, one.topic, name);
    } else if (name == "side") {
      take_choice(value, one.side.emplace(), core::edge_named, "side must be 'front', 'front_left', 'left', ...");
    } else if (name == "timeout") {
      take(value, one.timeout, name);
    } else {
      throw py::type_error("a switch has no " + name);
    }
  }
  return one;
}

py::sequence list_in(const py::handle& given, const std::string& name) {
  if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given))
    throw py::type_error(name + " must be a list of " + name);
  return given.cast<py::sequence>();
}
void take(const py::handle& given, core::Sensors& value, const std::string& name) {
  value.clear();
  for (const py::handle sensor : list_in(given, name)) value.push_back(sensor_in(sensor));
}
void take(const py::handle& given, core::Switches& value, const std::string& name) {
  value.clear();
  for (const py::handle one : list_in(given, name)) value.push_back(switch_in(one));
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
    take(given, value, name);
  });
  if (!known) throw no_parameter(name);
}

}  // namespace

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
      .def("problems", [](const core::Settings& settings) { return core::problems_in(settings); });
}

}  // namespace bindings
