// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

namespace safety_control_cloud {

/// Reads values and remembers whether all of them made sense.
class Reader {
 public:
  explicit Reader(const std::string& text) : from_(text) {}

  std::string word() {
    std::string value;
    from_ >> value;
    return value;
  }
  double number(double least, double most) {
    double value = 0.0;
    good_ = good_ && from_ >> value && value >= least && value <= most;  // a NaN is neither
    return good_ ? value : least;
  }
  std::size_t count(std::size_t most) { return static_cast<std::size_t>(number(0.0, static_cast<double>(most))); }
  /// All that is left, but for the space before it.
  std::string rest() {
    std::string value;
    std::getline(from_ >> std::ws, value);
    return value;
  }
  bool good() const { return good_; }

 private:
  std::istringstream from_;
  bool good_ = true;
};

}  // namespace safety_control_cloud
