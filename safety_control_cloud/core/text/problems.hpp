// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace safety_control_cloud {

/// Collects a sentence for every requirement that does not hold. Requirements are written so that NaN fails them.
struct Problems {
  std::vector<std::string> sentences;

  void require(bool holds, const std::string& sentence) {
    if (!holds) sentences.push_back(sentence);
  }

  /// Of a parameter that names a frame, or none.
  void require_frame(const std::string& parameter, const std::string& frame) {
    require(frame.empty() || frame.front() != '/', parameter + " must not begin with a slash: tf2 has no such frames");
  }
};

}  // namespace safety_control_cloud
