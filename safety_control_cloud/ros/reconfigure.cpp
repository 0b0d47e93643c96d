// SPDX-License-Identifier: BSD-3-Clause
#include "reconfigure.hpp"

#include <dynamic_reconfigure/config_tools.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace safety_control_cloud {
namespace {

using dynamic_reconfigure::ConfigTools;

/// The candidate's numbers over the settings in force. Throws std::invalid_argument for a count below zero.
Settings settings_with(const Settings& in_force, const SafetyControlConfig& candidate) {
  dynamic_reconfigure::Config numbers;
  candidate.__toMessage__(numbers);
  Settings settings = in_force;
  for_each_parameter(settings, [&](const std::string& name, auto& setting) {
    using Value = std::decay_t<decltype(setting)>;
    if constexpr (std::is_floating_point_v<Value>) {
      double value = 0.0;
      if (ConfigTools::getParameter(numbers, name, value)) setting = static_cast<Value>(value);
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
      int value = 0;
      if (!ConfigTools::getParameter(numbers, name, value)) return;
      if (value < 0) throw std::invalid_argument(name + " must not be negative");
      setting = static_cast<std::size_t>(value);
    }
  });
  return settings;
}

}  // namespace

Reconfigure::Reconfigure(const ros::NodeHandle& private_handle, const Settings& settings, Adopt adopt, Log& log)
    : settings_(settings), adopt_(std::move(adopt)), log_(log), server_(private_handle) {
  server_.setCallback([this](SafetyControlConfig& candidate, std::uint32_t) { on_candidate(candidate); });
}

void Reconfigure::on_candidate(SafetyControlConfig& candidate) {
  try {
    const Settings settings = settings_with(settings_, candidate);
    adopt_(settings);
    settings_ = settings;
    candidate.refusal.clear();
    in_force_ = candidate;
    for (const auto& doubt : doubts_about(settings_)) log_.warn(doubt);
  } catch (const std::invalid_argument& problems) {
    candidate = in_force_;
    candidate.refusal = problems.what();
    log_.error(std::string("refused to reconfigure: ") + problems.what());
  }
}

}  // namespace safety_control_cloud
