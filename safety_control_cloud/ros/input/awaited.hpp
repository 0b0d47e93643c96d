// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "../time/steady_condition.hpp"

namespace safety_control_cloud {

/// A topic that somebody publishes, by the master's books.
struct Published {
  std::string topic, type;
  std::vector<std::string> nodes;
};

struct Wanted {
  std::string topic, type;
};

/// Why what is wanted may not have come: who publishes it, as what, and where else there is such a thing. Of several
/// that are wanted together, the first that nobody sends. `own`: a topic on which the node answers, and no input.
std::string why_nothing_came(const std::vector<Wanted>& wanted, const std::vector<Published>& published,
                             const std::string& own = {});

/// Knows why topics are silent, until something comes. The master may take any time to answer, so it is asked from a
/// thread of its own, which ends with the first message.
class Awaited {
 public:
  Awaited(std::vector<Wanted> wanted, std::string own);
  ~Awaited();

  /// Why nothing has come, as far as is known. Returns at once.
  std::string why() const;

  /// Nobody waits any longer. Returns at once.
  void has_come();

 private:
  void ask();

  const std::vector<Wanted> wanted_;
  const std::string own_;
  mutable std::mutex mutex_;
  SteadyCondition came_;
  std::string why_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace safety_control_cloud
