// SPDX-License-Identifier: BSD-3-Clause
#include "log.hpp"

#include <utility>

namespace safety_control_cloud {
namespace {

constexpr std::size_t most = 100;  ///< lines that may wait

}  // namespace

Log::Log() : thread_([this] { write(); }) {}

Log::~Log() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  added_.notify_all();
  thread_.join();
}

void Log::add(ros::console::Level level, std::string text) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_.size() >= most) {
      ++dropped_;
      return;
    }
    if (dropped_ > 0)
      text += " (" + std::to_string(std::exchange(dropped_, 0)) + " lines before this one were dropped)";
    waiting_.push_back(Line{level, std::move(text)});
  }
  added_.notify_all();
}

void Log::write() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_ || !waiting_.empty()) {
    if (waiting_.empty()) {
      added_.wait(lock);
      continue;
    }
    const Line line = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    ROS_LOG(line.level, ROSCONSOLE_DEFAULT_NAME, "%s", line.text.c_str());
    lock.lock();
  }
}

}  // namespace safety_control_cloud
