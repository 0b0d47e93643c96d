// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

namespace safety_control_cloud {

/// Which of the choices has this name.
template <class Choice>
std::optional<Choice> choice_named(const std::string& name, std::initializer_list<Choice> choices) {
  for (const Choice choice : choices) {
    if (name == name_of(choice)) return choice;
  }
  return std::nullopt;
}

}  // namespace safety_control_cloud
