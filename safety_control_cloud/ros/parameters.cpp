// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.hpp"

#include <XmlRpcValue.h>

#include <algorithm>
#include <iomanip>
#include <locale>
#include <numeric>
#include <optional>
#include <sstream>

namespace safety_control_cloud {
namespace {

using XmlRpc::XmlRpcValue;

std::string lines(const std::vector<std::string>& sentences) {
  std::string text = "cannot start with these parameters:";
  for (const auto& sentence : sentences) text += "\n  - " + sentence;
  return text;
}

/// Levenshtein distance: how many letters to add, drop or change (a row of the usual table at a time).
std::size_t edits_between(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, changed});
    }
  }
  return row.back();
}

std::vector<std::string> known_names() {
  std::vector<std::string> names = {"diagnostic_period", "refusal", "image_transport"};  // libraries' own
  const Settings defaults;
  for_each_parameter(defaults, [&](const char* name, const auto&) { names.emplace_back(name); });
  return names;
}

std::string unknown_parameter(const std::string& node, const std::string& name, const std::vector<std::string>& known) {
  const auto closer = [&](const auto& a, const auto& b) { return edits_between(name, a) < edits_between(name, b); };
  const std::string closest = *std::min_element(known.begin(), known.end(), closer);
  const bool similar = edits_between(name, closest) <= std::max<std::size_t>(2, closest.size() / 3);
  return "there is no parameter ~" + name + (similar ? "; did you mean ~" + closest + "?" : "") +
         " (it stays on the parameter server until: rosparam delete " + node + "/" + name + ")";
}

/// Names right under the private namespace; what lies deeper (a nodelet's or a library's) is not ours to judge.
std::vector<std::string> given_names(const ros::NodeHandle& private_handle) {
  std::vector<std::string> all, given;
  private_handle.getParamNames(all);
  const std::string prefix = private_handle.getNamespace() + "/";
  for (const auto& name : all) {
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string own = name.substr(prefix.size());
    if (own.find('/') == std::string::npos) given.push_back(own);
  }
  return given;
}

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

/// Takes one ROS parameter into one setting, or says what is wrong with it.
struct Taking {
  XmlRpcValue given;

  std::optional<std::string> into(double& setting) const {
    const auto number = number_in(given);
    if (!number) return "must be a number";
    setting = *number;
    return std::nullopt;
  }

  std::optional<std::string> into(float& setting) const {
    double wide = 0.0;
    if (const auto problem = into(wide)) return problem;
    setting = static_cast<float>(wide);
    return std::nullopt;
  }

  std::optional<std::string> into(std::size_t& setting) const {
    XmlRpcValue value = given;
    if (value.getType() != XmlRpcValue::TypeInt) return "must be a whole number";
    if (static_cast<int&>(value) < 0) return "must not be negative";
    setting = static_cast<std::size_t>(static_cast<int&>(value));
    return std::nullopt;
  }

  std::optional<std::string> into(std::string& setting) const {
    XmlRpcValue value = given;
    if (value.getType() != XmlRpcValue::TypeString) return "must be a name";
    setting = static_cast<std::string&>(value);
    return std::nullopt;
  }

  /// Lists of numbers, as YAML has them, or as a text of the same form.
  std::optional<std::string> into(Lists& setting) const {
    const auto text = given.getType() == XmlRpcValue::TypeArray ? text_of(given) : std::nullopt;
    if (text) setting.text = *text;
    if (text || !into(setting.text)) return std::nullopt;
    return "must be a list of lists of numbers";
  }

  std::optional<std::string> into(Method& setting) const {
    return into_choice(setting, method_named, "must be one_pass or pcl");
  }
  std::optional<std::string> into(MinusInf& setting) const {
    return into_choice(setting, minus_inf_named, "must be too_close or nothing");
  }
  std::optional<std::string> into(InputKind& setting) const {
    return into_choice(setting, input_named, "must be cloud or depth");
  }
  std::optional<std::string> into(Mode& setting) const {
    return into_choice(setting, mode_named, "must be drive or guard");
  }
  std::optional<std::string> into(CommandType& setting) const {
    return into_choice(setting, command_type_named, "must be twist or twist_stamped");
  }

 private:
  template <class Choice, class Named>
  std::optional<std::string> into_choice(Choice& setting, Named named, const char* otherwise) const {
    std::string name;
    const bool is_name = !into(name);
    const auto choice = is_name ? named(name) : std::nullopt;
    if (!choice) return otherwise;
    setting = *choice;
    return std::nullopt;
  }
};

}  // namespace

BadParameters::BadParameters(const std::vector<std::string>& problems) : std::runtime_error(lines(problems)) {}

Settings load_settings(const ros::NodeHandle& private_handle) {
  Settings settings;
  std::vector<std::string> problems;
  for_each_parameter(settings, [&](const char* name, auto& setting) {
    Taking taking;
    if (!private_handle.getParam(name, taking.given)) return;
    if (const auto problem = taking.into(setting)) problems.push_back("~" + std::string(name) + " " + *problem);
  });
  const auto known = known_names();
  for (const auto& name : given_names(private_handle)) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      problems.push_back(unknown_parameter(private_handle.getNamespace(), name, known));
    }
  }
  for (const auto& problem : problems_in(settings)) problems.push_back(problem);
  if (!problems.empty()) throw BadParameters(problems);
  return settings;
}

std::vector<std::string> parameters_without_underscore(int argc, const char* const* argv) {
  const auto known = known_names();
  std::vector<std::string> sentences;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find(":="));
    if (name == argument || std::find(known.begin(), known.end(), name) == known.end()) continue;
    sentences.push_back(argument + " gives a topic another name; the parameter is set by _" + argument);
  }
  return sentences;
}

}  // namespace safety_control_cloud
