// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "../time/steady_condition.hpp"

namespace safety_control_cloud {

/// Gives those who are connected to a topic their names. roscpp knows at once how many there are, but not who they are,
/// and goes on counting those that were killed: the master knows the names, and the one named knows whether it lives.
/// Both may take any time to answer, so they are asked from a thread of its own. Connections outlive the master: while
/// there is none, or a new one that has not heard of this node, those it named last are asked alone.
class Connected {
 public:
  /// Whether this process is one of them, of which another nodelet may publish.
  enum class Self { LeftOut, Counts };

  explicit Connected(std::string topic, Self self = Self::LeftOut);
  ~Connected();

  struct Living {
    std::vector<std::string> names;
    double as_of;          ///< [s, steady]
    bool is_master_there;  ///< or else a new subscription would wait for one
  };

  /// Who they are that live, if this many are connected now, those too that have yet to connect; none: nobody has told
  /// yet. Returns at once.
  std::optional<Living> living(std::size_t connected);

  /// The same in words, also of those whose names are not known.
  std::vector<std::string> names(std::size_t connected);

 private:
  /// None: nobody asks any more.
  std::optional<Living> living_of_those(std::optional<std::size_t> connected);
  void ask();

  const std::string topic_;
  const Self self_;
  std::mutex mutex_;
  SteadyCondition asked_;
  std::optional<std::size_t> connected_;  ///< none: nobody has asked
  std::optional<Living> answer_;          ///< to the present number of them
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace safety_control_cloud
