// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/time/queue_thread.hpp"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../../safety_control_cloud/ros/time/later.hpp"

namespace safety_control_cloud {
namespace {

/// What is done in a queue's thread of which some throws.
struct Work {
  ros::CallbackQueue queue;
  std::atomic<int> done{0};
  std::vector<std::string> caught;

  void add(const std::string& thrown = "") {
    queue.addCallback(boost::make_shared<Later>([this, thrown] {
      if (!thrown.empty()) throw std::runtime_error(thrown);
      ++done;
    }));
  }
  QueueThread thread(bool goes_on) {
    return QueueThread(queue, [this, goes_on](const std::exception& problem) {
      caught.push_back(problem.what());
      return goes_on;
    });
  }
  bool comes_to(int wanted) {
    for (int i = 0; i < 500 && done < wanted; ++i) ros::WallDuration(0.01).sleep();
    return done == wanted;
  }
};

TEST(QueueThread, GoesOnWithWhatComesAfterAnException) {
  Work work;
  for (const char* thrown : {"", "one", "", "two", ""}) work.add(thrown);
  {
    const QueueThread thread = work.thread(true);
    EXPECT_TRUE(work.comes_to(3));
  }
  EXPECT_EQ(work.caught, (std::vector<std::string>{"one", "two"}));
}

TEST(QueueThread, LeavesIfItIsTold) {
  Work work;
  for (const char* thrown : {"", "one", "", "two"}) work.add(thrown);
  {
    const QueueThread thread = work.thread(false);
    EXPECT_TRUE(work.comes_to(1));
    ros::WallDuration(0.2).sleep();
  }
  EXPECT_EQ(work.done, 1);
  EXPECT_EQ(work.caught, std::vector<std::string>{"one"});
}

}  // namespace
}  // namespace safety_control_cloud
