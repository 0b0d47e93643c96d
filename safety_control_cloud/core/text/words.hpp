// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// A measured value to a thousandth.
inline std::string measured(double value, const char* unit) {
  return words(std::fixed, std::setprecision(3), value, ' ', unit);
}

}  // namespace safety_control_cloud
