// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace safety_control_cloud {

/// The node's lines, written by a thread of its own: a terminal that takes none (Ctrl-S, a full pipe) must not keep the
/// robot waiting. What comes while many lines wait is dropped, and counted in the next line.
class Log {
 public:
  Log();
  ~Log();  ///< once all lines are written

  void info(std::string line) { add(ros::console::levels::Info, std::move(line)); }
  void warn(std::string line) { add(ros::console::levels::Warn, std::move(line)); }
  void error(std::string line) { add(ros::console::levels::Error, std::move(line)); }

  /// For who is to say something without knowing where.
  std::function<void(const std::string&)> informer() {
    return [this](const std::string& line) { info(line); };
  }
  std::function<void(const std::string&)> warner() {
    return [this](const std::string& line) { warn(line); };
  }

 private:
  struct Line {
    ros::console::Level level;
    std::string text;
  };

  void add(ros::console::Level level, std::string text);
  void write();

  std::mutex mutex_;
  std::condition_variable added_;
  std::deque<Line> waiting_;
  std::size_t dropped_ = 0;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace safety_control_cloud
