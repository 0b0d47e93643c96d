// SPDX-License-Identifier: BSD-3-Clause
#include "../../../safety_control_cloud/ros/input/after_others.hpp"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>

#include <boost/make_shared.hpp>
#include <string>

namespace safety_control_cloud {
namespace {

struct Saying : ros::CallbackInterface {
  Saying(std::string& said, char word) : said_(said), word_(word) {}
  CallResult call() override {
    said_ += word_;
    return Success;
  }

 private:
  std::string& said_;
  char word_;
};

/// One queue, and the way into it for images.
struct Callbacks {
  std::string called;
  ros::CallbackQueue queue;
  AfterOthers after_others{queue};

  void image() { after_others.addCallback(boost::make_shared<Saying>(called, 'i'), 1); }
  void camera() { queue.addCallback(boost::make_shared<Saying>(called, 'c'), 2); }
  void call() {
    while (!queue.isEmpty()) queue.callAvailable();
  }
};

TEST(AfterOthers, WhatCameLaterGoesFirst) {
  Callbacks callbacks;
  callbacks.image();
  callbacks.camera();
  callbacks.call();
  EXPECT_EQ(callbacks.called, "ci");
}

TEST(AfterOthers, NothingWaitsForWhatDoesNotCome) {
  Callbacks callbacks;
  callbacks.image();
  callbacks.call();
  EXPECT_EQ(callbacks.called, "i");
}

TEST(AfterOthers, NothingWaitsForeverForWhatComesAgainAndAgain) {
  Callbacks callbacks;
  callbacks.image();
  for (int i = 0; i < 3; ++i) {
    callbacks.camera();
    callbacks.queue.callAvailable();
  }
  EXPECT_EQ(callbacks.called, "cicc");
}

TEST(AfterOthers, OrderAmongThemselvesStays) {
  Callbacks callbacks;
  callbacks.after_others.addCallback(boost::make_shared<Saying>(callbacks.called, '1'), 1);
  callbacks.after_others.addCallback(boost::make_shared<Saying>(callbacks.called, '2'), 1);
  callbacks.call();
  EXPECT_EQ(callbacks.called, "12");
}

TEST(AfterOthers, WhoHasGoneIsNotCalled) {
  Callbacks callbacks;
  callbacks.image();
  callbacks.after_others.removeByID(1);
  callbacks.call();
  EXPECT_EQ(callbacks.called, "");
}

}  // namespace
}  // namespace safety_control_cloud
