// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.hpp"

#include <XmlRpcValue.h>

#include <algorithm>
#include <numeric>

#include "taking.hpp"
#include "time/diagnostic_period.hpp"

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

std::string misplaced_parameter(const std::string& node, const std::string& name) {
  return "~" + name + " is not read: put ~" + name.substr(name.rfind('/') + 1) + " right under the node's name (it " +
         "stays on the parameter server until: rosparam delete " + node + "/" + name + ")";
}

/// Names under the private namespace.
std::vector<std::string> given_names(const ros::NodeHandle& private_handle) {
  std::vector<std::string> all, given;
  private_handle.getParamNames(all);
  const std::string prefix = private_handle.getNamespace() + "/";
  for (const auto& name : all) {
    if (name.compare(0, prefix.size(), prefix) == 0) given.push_back(name.substr(prefix.size()));
  }
  return given;
}

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
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  // What lies deeper, a nodelet's or a library's, is not ours to judge, unless its name is one of ours.
  for (const auto& name : given_names(private_handle)) {
    const std::size_t slash = name.rfind('/');
    if (slash == std::string::npos && !is_known(name))
      problems.push_back(unknown_parameter(private_handle.getNamespace(), name, known));
    if (slash != std::string::npos && is_known(name.substr(slash + 1)))
      problems.push_back(misplaced_parameter(private_handle.getNamespace(), name));
  }
  if (double period = 1.0; private_handle.getParam("diagnostic_period", period) && !is_diagnostic_period(period))
    problems.push_back("~diagnostic_period must be more than 0 s and at most 3600");
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
