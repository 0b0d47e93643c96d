// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string>

namespace safety_control_cloud {

/// Its arguments, one after the other.
template <class... Parts>
std::string words(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Whether it is a part of a ROS name.
inline bool is_name(const std::string& name) {
  const auto fits = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '_';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), fits);
}

/// A measured value to a thousandth.
inline std::string measured(double value, const char* unit) {
  return words(std::fixed, std::setprecision(3), value, ' ', unit);
}

}  // namespace safety_control_cloud
