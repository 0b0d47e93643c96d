// SPDX-License-Identifier: BSD-3-Clause
#include "exchange.hpp"

#include <ros/callback_queue.h>

#include <algorithm>
#include <stdexcept>

namespace safety_control_cloud {
namespace {

const ros::WallDuration patience(10.0);
const ros::WallDuration longest_wait(0.01);  // between two looks at what is no callback

bool never() { return false; }

}  // namespace

Exchange::Exchange(const ros::Publisher& clouds, double rate)
    : clouds_(clouds),
      twists_(ros::NodeHandle().subscribe("cmd_vel_mux/input/teleop", 10, &Exchange::on_twist, this,
                                          ros::TransportHints().tcpNoDelay())),
      period_(1.0 / rate) {}

void Exchange::meet() {
  const auto met = [this] { return clouds_.getNumSubscribers() == 1 && twists_.getNumPublishers() == 1; };
  hear_until(ros::SteadyTime::now() + patience, met);
  if (!met()) throw std::runtime_error("no node listens to the clouds and commands");
}

std::vector<Answer> Exchange::show(int clouds, const CloudSource& source) {
  std::vector<Answer> answers;
  for (ros::SteadyTime due = ros::SteadyTime::now(); clouds > 0 && ros::ok(); --clouds) {
    source.prepare();
    answer_ = Answer();
    published_ = ros::SteadyTime::now();
    source.publish();
    hear_until(published_ + patience, [this] { return answer_.twists > 0; });
    due = std::max(due + period_, ros::SteadyTime::now() + longest_wait);
    hear_until(due, never);
    answers.push_back(answer_);
  }
  return answers;
}

void Exchange::on_twist(const geometry_msgs::Twist& twist) {
  if (answer_.twists++ == 0) answer_.latency = (ros::SteadyTime::now() - published_).toSec();
  answer_.speed = twist.linear.x;
}

void Exchange::hear_until(const ros::SteadyTime& end, const std::function<bool()>& enough) {
  while (!enough()) {
    const ros::WallDuration left = end - ros::SteadyTime::now();
    if (left <= ros::WallDuration(0.0)) return;
    ros::getGlobalCallbackQueue()->callAvailable(std::min(left, longest_wait));
  }
}

}  // namespace safety_control_cloud
