// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace safety_control_cloud {

inline bool mentions(const std::vector<std::string>& sentences, const std::string& word) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(word) != std::string::npos; });
}

/// What harms settings that were fit, and how it is told.
template <class AnySettings>
struct Harm {
  const char* sentence;
  std::function<void(AnySettings&)> harm;
};

/// The sentences of the table that its harm does not bring about; a room's check() tells its problems.
template <class AnySettings>
std::vector<std::string> untold(const std::vector<Harm<AnySettings>>& table) {
  std::vector<std::string> sentences;
  for (const auto& [sentence, harm] : table) {
    AnySettings settings;
    Problems problems;
    harm(settings);
    check(settings, problems);
    if (!mentions(problems.sentences, sentence)) sentences.push_back(sentence);
  }
  return sentences;
}

/// Of settings as they are made.
template <class AnySettings>
std::vector<std::string> problems_of_defaults() {
  Problems problems;
  check(AnySettings{}, problems);
  return problems.sentences;
}

}  // namespace safety_control_cloud
