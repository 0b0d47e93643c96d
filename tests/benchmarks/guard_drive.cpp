// SPDX-License-Identifier: BSD-3-Clause
// Two cameras and a laser at 20 Hz, somebody's commands at 50 Hz, and the time from each to what the base is told.
// With the processes' ids: they guard. Without: a nodelet does, in this process.
#include <geometry_msgs/Twist.h>
#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <array>
#include <boost/make_shared.hpp>
#include <cmath>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "process_use.hpp"
#include "scene_message.hpp"
#include "serialised.hpp"

namespace safety_control_cloud {
namespace {

constexpr double tick = 0.01;  ///< [s]
constexpr int ticks_a_command = 2, ticks_a_look = 5;
constexpr int warm_up = 50;        ///< commands
constexpr double patience = 20.0;  ///< [s]
constexpr int most_unanswered = 10;

sensor_msgs::PointCloud2 cloud_of(const std::string& frame) {
  Picture picture;
  picture.point_step = 32;
  picture.nan_share = 0.3;
  auto message = message_of(picture);
  message.header.frame_id = frame;
  return message;
}

sensor_msgs::LaserScan scan_of(const std::string& frame) {
  sensor_msgs::LaserScan scan;
  scan.header.frame_id = frame;
  scan.ranges.assign(720, 3.0f);
  scan.angle_increment = static_cast<float>(2.0 * M_PI / 720.0);
  scan.angle_min = static_cast<float>(-M_PI);
  scan.angle_max = static_cast<float>(M_PI) - scan.angle_increment;
  scan.scan_time = 0.05f, scan.range_min = 0.1f, scan.range_max = 10.0f;
  return scan;
}

/// A sensor's place in base_footprint; the rows of its rotation.
geometry_msgs::TransformStamped placed(const std::string& frame, const std::array<double, 4>& turn, double x) {
  geometry_msgs::TransformStamped place;
  place.header.stamp = ros::Time::now();
  place.header.frame_id = "base_footprint";
  place.child_frame_id = frame;
  place.transform.translation.x = x;
  place.transform.translation.z = 0.3;
  auto& rotation = place.transform.rotation;
  rotation.x = turn[0], rotation.y = turn[1], rotation.z = turn[2], rotation.w = turn[3];
  return place;
}

/// One sensor's messages, all the same but for their stamps: serialised once for another process, as a message of
/// their own for this one.
template <class Message>
class Sent {
 public:
  Sent(const std::string& topic, const Message& message, bool in_process)
      : message_(message), publisher_(ros::NodeHandle().advertise<Message>(topic, 1)) {
    if (!in_process) bytes_.emplace(message, publisher_);
  }
  void publish() {
    if (bytes_) return bytes_->publish(ros::Time::now());
    const auto next = boost::make_shared<Message>(message_);
    next->header.stamp = ros::Time::now();
    publisher_.publish(next);
  }

 private:
  Message message_;
  ros::Publisher publisher_;
  std::optional<Serialised> bytes_;
};

class Drive {
 public:
  explicit Drive(bool in_process)
      : front_("front/points", cloud_of("front"), in_process),
        rear_("rear/points", cloud_of("rear"), in_process),
        laser_("scan", scan_of("laser"), in_process),
        wishes_(handle_.advertise<geometry_msgs::Twist>("cmd_vel_in", 1)),
        answers_(handle_.subscribe("cmd_vel", 10, &Drive::on_answer, this, ros::TransportHints().tcpNoDelay())) {
    places_.sendTransform({placed("front", {-0.5, 0.5, -0.5, 0.5}, 0.1), placed("rear", {0.5, 0.5, -0.5, -0.5}, -0.1),
                           placed("laser", {0.0, 0.0, 0.0, 1.0}, 0.0)});
  }

  /// Shows clouds and asks until a first command passes. Throws if none does.
  void meet() {
    const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(patience);
    for (waits_ = true; waits_;) {
      if (ros::SteadyTime::now() > end) throw std::runtime_error("a command that is safe was not passed");
      for (int i = 0; i < ticks_a_command; ++i) look_around();
      wish_.linear.x = 0.1;
      wishes_.publish(wish_);
    }
  }

  /// [s] from just before each command to what is given of it. Throws if nothing is, of more than a few.
  std::vector<double> command(int commands) {
    std::vector<double> latencies;
    for (int unanswered = 0; latencies.size() < static_cast<std::size_t>(commands);) {
      wish_.linear.x = 0.1;
      wish_.angular.x += 1e-6;  // tells one from the other, and moves nothing
      said_ = ros::SteadyTime::now();
      waits_ = true;
      wishes_.publish(wish_);
      for (int i = 0; i < ticks_a_command; ++i) look_around();
      if (!waits_) {
        latencies.push_back(latency_);
      } else if (++unanswered > most_unanswered + commands / 10) {
        throw std::runtime_error("commands that are safe were not passed");
      }
    }
    return latencies;
  }

 private:
  void look_around() {
    const int phase = ticks_++ % ticks_a_look;
    if (phase == 0) front_.publish();
    if (phase == 2) rear_.publish();
    if (phase == 4) laser_.publish();
    due_ = std::max(due_ + ros::WallDuration(tick), ros::SteadyTime::now());
    hear_until(due_, [] { return false; });
  }

  void on_answer(const geometry_msgs::Twist& answer) {
    const double factor = answer.linear.x / wish_.linear.x;  // whatever is given of it keeps its shape
    if (!waits_ || !(factor > 0.0) || std::abs(answer.angular.x - factor * wish_.angular.x) > 1e-12) return;
    latency_ = (ros::SteadyTime::now() - said_).toSec();
    waits_ = false;
  }

  template <class Enough>
  void hear_until(const ros::SteadyTime& end, Enough enough) {
    while (!enough()) {
      const ros::WallDuration left = end - ros::SteadyTime::now();
      if (left <= ros::WallDuration(0.0)) return;
      ros::getGlobalCallbackQueue()->callAvailable(std::min(left, ros::WallDuration(tick)));
    }
  }

  ros::NodeHandle handle_;
  tf2_ros::StaticTransformBroadcaster places_;
  Sent<sensor_msgs::PointCloud2> front_, rear_;
  Sent<sensor_msgs::LaserScan> laser_;
  ros::Publisher wishes_;
  ros::Subscriber answers_;
  geometry_msgs::Twist wish_;
  ros::SteadyTime said_, due_ = ros::SteadyTime::now();
  double latency_ = 0.0;
  bool waits_ = false;
  int ticks_ = 0;
};

void report(const std::vector<double>& latencies, double cpu, double seconds) {
  std::cout << "{\"latency_ms\": [";
  for (std::size_t i = 0; i < latencies.size(); ++i) std::cout << (i == 0 ? "" : ", ") << 1e3 * latencies[i];
  std::cout << "], \"cpu_share\": " << cpu / seconds << '}' << std::endl;
}

void run(int commands, const std::vector<pid_t>& guards) {
  nodelet::Loader manager;  // what the program `nodelet manager` consists of
  const bool in_process = guards.empty();
  Drive drive(in_process);
  if (in_process && !manager.load("/safety_control_cloud", "safety_control_cloud/SafetyControlNodelet", {}, {}))
    throw std::runtime_error("the nodelet could not be loaded");
  drive.meet();
  drive.command(warm_up);
  const double before = use_of(guards).cpu;
  const ros::SteadyTime begun = ros::SteadyTime::now();
  const auto latencies = drive.command(commands);
  report(latencies, use_of(guards).cpu - before, (ros::SteadyTime::now() - begun).toSec());
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  ros::init(argc, argv, "guard_drive", ros::init_options::NoRosout);
  if (argc < 2) {
    std::cerr << "Usage: " << argv[0] << " COMMANDS [PID...]\n";
    return 2;
  }
  const ros::NodeHandle keeps_the_threads_running;
  std::vector<pid_t> guards;
  for (int i = 2; i < argc; ++i) guards.push_back(std::stoi(argv[i]));
  safety_control_cloud::run(std::stoi(argv[1]), guards);
}
