// SPDX-License-Identifier: BSD-3-Clause
#include "taking.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

#include "../core/text/words.hpp"

namespace safety_control_cloud {
namespace {

using XmlRpc::XmlRpcValue;

constexpr const char* all_of_entry = "must have a name, a type and a topic";

std::optional<double> number_in(XmlRpcValue value) {
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<int&>(value);
  if (value.getType() == XmlRpcValue::TypeDouble) return static_cast<double&>(value);
  return std::nullopt;
}

/// Lists of numbers, whatever their depth, as people write them.
std::optional<std::string> text_of(XmlRpcValue value) {
  if (const auto number = number_in(value)) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(17) << *number;
    return text.str();
  }
  if (value.getType() != XmlRpcValue::TypeArray) return std::nullopt;
  std::string text;
  for (int i = 0; i < value.size(); ++i) {
    const auto item = text_of(value[i]);
    if (!item) return std::nullopt;
    text += (i == 0 ? "" : ", ") + *item;
  }
  return "[" + text + "]";
}

}  // namespace

template <class Choice, class Named>
Taking::Problem Taking::into_choice(Choice& setting, Named named, const char* otherwise) const {
  std::string name;
  const bool is_name = !into(name);
  const auto choice = is_name ? named(name) : std::nullopt;
  if (!choice) return otherwise;
  setting = *choice;
  return std::nullopt;
}

Taking::Problem Taking::into(double& setting) const {
  const auto number = number_in(given);
  if (!number) return "must be a number";
  setting = *number;
  return std::nullopt;
}

Taking::Problem Taking::into(float& setting) const {
  double wide = 0.0;
  if (const auto problem = into(wide)) return problem;
  setting = static_cast<float>(wide);
  return std::nullopt;
}

Taking::Problem Taking::into(bool& setting) const {
  XmlRpcValue value = given;
  if (value.getType() != XmlRpcValue::TypeBoolean) return "must be true or false";
  setting = static_cast<bool&>(value);
  return std::nullopt;
}

Taking::Problem Taking::into(std::size_t& setting) const {
  XmlRpcValue value = given;
  if (value.getType() != XmlRpcValue::TypeInt) return "must be a whole number";
  if (static_cast<int&>(value) < 0) return "must not be negative";
  setting = static_cast<std::size_t>(static_cast<int&>(value));
  return std::nullopt;
}

Taking::Problem Taking::into(std::string& setting) const {
  XmlRpcValue value = given;
  if (value.getType() != XmlRpcValue::TypeString) return "must be a name";
  setting = static_cast<std::string&>(value);
  return std::nullopt;
}

Taking::Problem Taking::into(Lists& setting) const {
  const auto text = given.getType() == XmlRpcValue::TypeArray ? text_of(given) : std::nullopt;
  if (text) setting.text = *text;
  if (text || !into(setting.text)) return std::nullopt;
  return "must be a list of lists of numbers";
}

template <class Entry>
Taking::Problem Taking::into_list(std::vector<Entry>& setting, const char* otherwise) const {
  XmlRpcValue value = given;
  if (value.getType() != XmlRpcValue::TypeArray) return otherwise;
  setting.clear();
  for (int i = 0; i < value.size(); ++i) {
    setting.emplace_back();
    if (const auto problem = Taking{value[i]}.into_entry(setting.back())) return words("[", i, "] ", *problem);
  }
  return std::nullopt;
}

Taking::Problem Taking::into(Sensors& setting) const { return into_list(setting, "must be a list of sensors"); }

Taking::Problem Taking::into(Switches& setting) const { return into_list(setting, "must be a list of switches"); }

Taking::Problem Taking::into(Method& setting) const {
  return into_choice(setting, method_named, "must be one_pass or pcl");
}

Taking::Problem Taking::into(MinusInf& setting) const {
  return into_choice(setting, minus_inf_named, "must be too_close or nothing");
}

Taking::Problem Taking::into(InputKind& setting) const {
  return into_choice(setting, input_named, "must be cloud, depth or scan");
}

Taking::Problem Taking::into(Mode& setting) const { return into_choice(setting, mode_named, "must be drive or guard"); }

Taking::Problem Taking::into(CommandType& setting) const {
  return into_choice(setting, command_type_named, "must be twist or twist_stamped");
}

Taking::Problem Taking::into_entry(SwitchSettings& one) const {
  XmlRpcValue entry = given;
  if (entry.getType() != XmlRpcValue::TypeStruct) return all_of_entry;
  for (auto& [key, value] : entry) {
    const Taking taking{value};
    Problem problem;
    if (key == "name") {
      problem = taking.into(one.name);
    } else if (key == "type") {
      problem = taking.into_choice(one.type, switch_named, "must be bumper or cliff");
    } else if (key == "topic") {
      problem = taking.into(one.topic);
    } else if (key == "side") {
      one.side = Edge::Front;
      problem = taking.into_choice(*one.side, edge_named, "must be front, front_left, left, rear_left, rear, ...");
    } else if (key == "timeout") {
      problem = taking.into(one.timeout);
    } else {
      return "has no " + key;
    }
    if (problem) return key + " " + *problem;
  }
  return entry.hasMember("type") ? Problem() : all_of_entry;
}

Taking::Problem Taking::into_entry(SensorSettings& sensor) const {
  XmlRpcValue entry = given;
  if (entry.getType() != XmlRpcValue::TypeStruct) return all_of_entry;
  for (auto& [key, value] : entry) {
    const Taking taking{value};
    const Problem problem = key == "name"       ? taking.into(sensor.name)
                            : key == "type"     ? taking.into(sensor.type)
                            : key == "topic"    ? taking.into(sensor.topic)
                            : key == "required" ? taking.into(sensor.required)
                                                : taking.into_own(key, sensor.own[key]);
    if (problem) return key + " " + *problem;
  }
  return entry.hasMember("type") ? Problem() : all_of_entry;
}

Taking::Problem Taking::into_own(const std::string& name, double& setting) const {
  if (!is_flag(name)) return into(setting);
  bool flag = false;
  const Problem problem = into(flag);
  setting = flag ? 1.0 : 0.0;
  return problem;
}

}  // namespace safety_control_cloud
