// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "../core/settings.hpp"

namespace safety_control_cloud {

/// Takes one ROS parameter into one setting, or says what is wrong with it.
struct Taking {
  using Problem = std::optional<std::string>;

  XmlRpc::XmlRpcValue given;

  Problem into(double& setting) const;
  Problem into(float& setting) const;
  Problem into(bool& setting) const;
  Problem into(std::size_t& setting) const;
  Problem into(std::string& setting) const;
  Problem into(Lists& setting) const;  ///< as YAML has them, or as a text of the same form
  Problem into(Sensors& setting) const;
  Problem into(Switches& setting) const;
  Problem into(Method& setting) const;
  Problem into(MinusInf& setting) const;
  Problem into(InputKind& setting) const;
  Problem into(Mode& setting) const;
  Problem into(CommandType& setting) const;

 private:
  template <class Entry>
  Problem into_list(std::vector<Entry>& setting, const char* otherwise) const;
  Problem into_entry(SensorSettings& sensor) const;
  Problem into_entry(SwitchSettings& one) const;
  Problem into_own(const std::string& name, double& setting) const;
  template <class Choice, class Named>
  Problem into_choice(Choice& setting, Named named, const char* otherwise) const;
};

}  // namespace safety_control_cloud
