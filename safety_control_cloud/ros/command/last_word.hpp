// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace safety_control_cloud {

/// For a node in another's process, as a nodelet in its manager. When that process is asked to end (SIGINT, SIGTERM,
/// `rosnode kill`), roscpp closes all topics before any nodelet hears of it. So the request is held back until `say`
/// has been called and what it published has had the time to leave; then it goes on to whom it was for.
///
/// The process keeps what answers its signals: a library with this in it must not be unloaded.
class LastWord {
 public:
  explicit LastWord(std::function<void()> say);
  ~LastWord();
  LastWord(const LastWord&) = delete;
  LastWord& operator=(const LastWord&) = delete;

 private:
  std::function<void()> say_;
};

}  // namespace safety_control_cloud
