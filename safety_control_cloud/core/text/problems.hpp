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
};

}  // namespace safety_control_cloud
