// SPDX-License-Identifier: BSD-3-Clause
// Somebody's commands at 50 Hz, and the time from each to what the base is told, beside two cameras and a laser at 20
// Hz, or the first camera alone. With the processes' ids: they guard, and the cameras are a process of their own, as on
// a robot: `guard_drive cameras SENSORS [POINT_STEP]`. Without: a nodelet guards, in this process, and so do the
// cameras send.
#include <geometry_msgs/Twist.h>
#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "guard_scene.hpp"
#include "process_use.hpp"
#include "serialised.hpp"

namespace safety_control_cloud {
namespace {

constexpr double tick = 0.01;  ///< [s]
constexpr long ticks_a_command = 2, ticks_a_look = 5;
constexpr double speed = 0.1;      ///< [m/s] of each command
constexpr double step = 1e-6;      ///< [rad/s] from one to the next
constexpr int warm_up = 50;        ///< commands
constexpr double patience = 20.0;  ///< [s]
constexpr int most_said = 5;       ///< commands for one that is answered

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

/// Moments that all processes of a machine count alike.
class Ticks {
 public:
  /// The next moment's number, once it has come. None is left out.
  long next() {
    ros::SteadyTime::sleepUntil(ros::SteadyTime(tick * static_cast<double>(++number_)));
    return number_;
  }
  long latest() const { return number_; }

 private:
  long number_ = static_cast<long>(ros::SteadyTime::now().toSec() / tick);
};

class Cameras {
 public:
  /// The first so many sensors send, the cameras `point_step` [byte] a point.
  Cameras(int sensors, bool in_process, std::size_t point_step = with_colours)
      : sensors_(sensors),
        front_("front/points", cloud_of("front", point_step), in_process),
        rear_("rear/points", cloud_of("rear", point_step), in_process),
        laser_("scan", scan_of("laser"), in_process) {}

  void look(long moment) {
    const long phase = moment % ticks_a_look;
    if (phase == 0) front_.publish();
    if (phase == 2 && sensors_ > 1) rear_.publish();
    if (phase == 4 && sensors_ > 2) laser_.publish();
  }

 private:
  int sensors_;
  Sent<sensor_msgs::PointCloud2> front_, rear_;
  Sent<sensor_msgs::LaserScan> laser_;
};

class Drive {
 public:
  /// `cameras` of the same process, if they are.
  explicit Drive(std::optional<Cameras> cameras)
      : cameras_(std::move(cameras)), wishes_(handle_.advertise<geometry_msgs::Twist>("cmd_vel_in", 1)) {
    places_.sendTransform(places());
    base_.setCallbackQueue(&heard_);
    answers_ = base_.subscribe("cmd_vel", 10, &Drive::on_answer, this, ros::TransportHints().tcpNoDelay());
    hearing_.start();
  }
  ~Drive() { hearing_.stop(); }

  /// Shows clouds and asks until a first command passes. Throws if none does.
  void meet() {
    const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(patience);
    while (answered() == 0) {
      if (ros::SteadyTime::now() > end) throw std::runtime_error("a command that is safe was not passed");
      say();
    }
  }

  long clouds() const { return ticks_.latest() / ticks_a_look; }  ///< of the first camera, since some moment
  long said() const { return number_; }                           ///< commands, so far

  /// Says commands until so many are answered, however late, and gives for each of these the time [s] from just before
  /// it to what is given of it. Throws if few are.
  std::vector<double> command(int commands) {
    const auto enough = static_cast<std::size_t>(commands);
    const long last = number_ + most_said * (commands + 1);
    forget();
    while (answered() < enough) {
      if (number_ == last) throw std::runtime_error("commands that are safe were not passed");
      say();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    return {latencies_.begin(), latencies_.begin() + commands};
  }

 private:
  void forget() {
    const std::lock_guard<std::mutex> lock(mutex_);
    latencies_.clear();
    said_.clear();
  }

  std::size_t answered() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return latencies_.size();
  }

  void say() {
    geometry_msgs::Twist wish;
    wish.linear.x = speed;
    wish.angular.x = step * static_cast<double>(++number_);  // tells one from the other, and moves nothing
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      said_[number_] = ros::SteadyTime::now();
    }
    wishes_.publish(wish);
    do {
      if (cameras_) cameras_->look(ticks_.latest());
      ticks_.next();
    } while (ticks_.latest() % ticks_a_command != 0);
  }

  /// Of each command the first; what the guard repeats of it afterwards is none.
  void on_answer(const geometry_msgs::Twist& answer) {
    const ros::SteadyTime came = ros::SteadyTime::now();
    const double factor = answer.linear.x / speed;  // whatever is given of it keeps its shape
    if (!(factor > 0.0)) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto said = said_.find(std::lround(answer.angular.x / (factor * step)));
    if (said == said_.end()) return;
    latencies_.push_back((came - said->second).toSec());
    said_.erase(said_.begin(), std::next(said));  // a queue of one: what was said before it was passed over
  }

  std::optional<Cameras> cameras_;
  ros::NodeHandle handle_;
  tf2_ros::StaticTransformBroadcaster places_;
  ros::Publisher wishes_;
  ros::CallbackQueue heard_;  ///< by the base, in a thread of its own: it does not wait for the cameras to write
  ros::AsyncSpinner hearing_{1, &heard_};
  ros::NodeHandle base_;
  ros::Subscriber answers_;
  std::mutex mutex_;
  std::map<long, ros::SteadyTime> said_;  ///< not answered yet, by number
  std::vector<double> latencies_;         ///< [s]
  Ticks ticks_;
  long number_ = 0;
};

struct Spent {
  double cpu, time;   ///< [s]
  long clouds, said;  ///< said: commands
};

void report(const std::vector<double>& latencies, const Spent& spent) {
  std::cout << "{\"latency_ms\": [";
  for (std::size_t i = 0; i < latencies.size(); ++i) std::cout << (i == 0 ? "" : ", ") << 1e3 * latencies[i];
  std::cout << "], \"cpu_share\": " << spent.cpu / spent.time
            << ", \"cpu_ms\": " << 1e3 * spent.cpu / static_cast<double>(spent.clouds) << ", \"said\": " << spent.said
            << '}' << std::endl;
}

void run(int commands, int sensors, const std::vector<pid_t>& guards) {
  nodelet::Loader manager;  // what the program `nodelet manager` consists of
  const bool in_process = guards.empty();
  Drive drive(in_process ? std::optional<Cameras>(std::in_place, sensors, true) : std::nullopt);
  if (in_process && !manager.load("/safety_control_cloud", "safety_control_cloud/SafetyControlNodelet", {}, {}))
    throw std::runtime_error("the nodelet could not be loaded");
  drive.meet();
  drive.command(warm_up);
  const double cpu = use_of(guards).cpu;
  const ros::SteadyTime begun = ros::SteadyTime::now();
  const long clouds = drive.clouds();
  const long said = drive.said();
  const auto latencies = drive.command(commands);
  const double time = (ros::SteadyTime::now() - begun).toSec();
  report(latencies, {use_of(guards).cpu - cpu, time, drive.clouds() - clouds, drive.said() - said});
}

void run_cameras(int sensors, std::size_t point_step) {
  Cameras cameras(sensors, false, point_step);
  Ticks ticks;
  while (ros::ok()) cameras.look(ticks.next());
}

}  // namespace
}  // namespace safety_control_cloud

int main(int argc, char** argv) {
  const bool shows = (argc == 3 || argc == 4) && argv[1] == std::string("cameras");
  ros::init(argc, argv, shows ? "guard_cameras" : "guard_drive", ros::init_options::NoRosout);
  if (argc < 3) {
    std::cerr << "Usage: " << argv[0] << " COMMANDS SENSORS [PID...]\n       " << argv[0]
              << " cameras SENSORS [POINT_STEP]\n";
    return 2;
  }
  const ros::NodeHandle keeps_the_threads_running;
  if (shows) {
    using safety_control_cloud::run_cameras, safety_control_cloud::with_colours;
    run_cameras(std::stoi(argv[2]), argc == 4 ? std::stoul(argv[3]) : with_colours);
    return 0;
  }
  std::vector<pid_t> guards;
  for (int i = 3; i < argc; ++i) guards.push_back(std::stoi(argv[i]));
  safety_control_cloud::run(std::stoi(argv[1]), std::stoi(argv[2]), guards);
}
