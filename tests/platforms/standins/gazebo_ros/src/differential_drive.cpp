// SPDX-License-Identifier: BSD-3-Clause
// Two wheels obey the last command, for ever; odometry is the model's true pose or what the wheels have rolled.
#include <cmath>
#include <string>
#include <vector>

#include <gazebo/common/common.hh>
#include <gazebo/physics/physics.hh>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include "conversions.hpp"
#include "parameters.hpp"

namespace standin {

const std::vector<std::string> KNOWN = {
    "robotNamespace", "commandTopic", "odometryTopic", "odometryFrame", "odometrySource", "robotBaseFrame", "leftJoint",
    "rightJoint", "wheelSeparation", "wheelDiameter", "wheelTorque", "wheelAcceleration", "updateRate", "publishTf",
    "publishOdomTF", "publishWheelTF", "publishWheelJointState"};

class DifferentialDrive : public gazebo::ModelPlugin {
 public:
  void Load(gazebo::physics::ModelPtr model, sdf::ElementPtr plugin) override {
    const Parameters parameters(plugin, KNOWN);
    model_ = model;
    wheels_ = {model->GetJoint(parameters.value<std::string>("leftJoint", "left_joint")),
               model->GetJoint(parameters.value<std::string>("rightJoint", "right_joint"))};
    separation_ = parameters.value("wheelSeparation", 0.34);
    radius_ = parameters.value("wheelDiameter", 0.15) / 2;
    torque_ = parameters.value("wheelTorque", 5.0);
    acceleration_ = parameters.value("wheelAcceleration", 0.0);
    period_ = 1 / parameters.value("updateRate", 100.0);
    odometry_frame_ = parameters.value<std::string>("odometryFrame", "odom");
    base_frame_ = parameters.value<std::string>("robotBaseFrame", "base_footprint");
    publishes_odometry_ = parameters.value("publishTf", true);
    publishes_transform_ = parameters.value("publishOdomTF", true);
    if (parameters.value<std::string>("odometrySource", "world") != "world" || parameters.value("publishWheelTF", false)) {
      gzthrow("this stand-in publishes the world's odometry, and no transforms of wheels");
    }
    connect(parameters);
  }

 private:
  void connect(const Parameters& parameters) {
    node_ = std::make_unique<ros::NodeHandle>(parameters.value<std::string>("robotNamespace", model_->GetName()));
    node_->setCallbackQueue(&queue_);
    command_ = node_->subscribe(parameters.value<std::string>("commandTopic", "cmd_vel"), 1, &DifferentialDrive::on_command, this);
    odometry_ = node_->advertise<nav_msgs::Odometry>(parameters.value<std::string>("odometryTopic", "odom"), 1);
    transforms_ = node_->advertise<tf2_msgs::TFMessage>("/tf", 10);
    if (parameters.value("publishWheelJointState", false)) {
      joints_ = node_->advertise<sensor_msgs::JointState>("joint_states", 10);
    }
    update_ = gazebo::event::Events::ConnectWorldUpdateBegin([this](const auto& info) { on_update(info.simTime); });
  }

  void on_command(const geometry_msgs::Twist& twist) {
    const double half = twist.angular.z * separation_ / 2;
    wanted_[0] = (twist.linear.x - half) / radius_;
    wanted_[1] = (twist.linear.x + half) / radius_;
  }

  void on_update(const gazebo::common::Time& now) {
    if (now < last_) last_ = now;
    if ((now - last_).Double() < period_) return;
    const double elapsed = (now - last_).Double();
    last_ = now;
    queue_.callAvailable();
    for (size_t side = 0; side < wheels_.size(); ++side) {
      turn_[side] = towards(wanted_[side], turn_[side], elapsed);
      wheels_[side]->SetParam("fmax", 0, torque_);
      wheels_[side]->SetParam("vel", 0, turn_[side]);
    }
    if (publishes_odometry_) publish_odometry(to_ros(now));
    if (joints_) publish_joints(to_ros(now));
  }

  /// [rad/s] At once if the acceleration is 0.
  double towards(double wanted, double now, double elapsed) const {
    if (acceleration_ <= 0) return wanted;
    const double most = acceleration_ / radius_ * elapsed;
    return std::abs(wanted - now) <= most ? wanted : now + std::copysign(most, wanted - now);
  }

  void publish_odometry(const ros::Time& stamp) {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = stamp;
    odometry.header.frame_id = odometry_frame_;
    odometry.child_frame_id = base_frame_;
    odometry.pose.pose = to_ros(model_->WorldPose());
    const auto ahead = model_->WorldPose().Rot().RotateVectorReverse(model_->WorldLinearVel());
    odometry.twist.twist = to_ros(ahead, model_->WorldAngularVel());
    odometry_.publish(odometry);
    if (!publishes_transform_) return;
    geometry_msgs::TransformStamped transform;
    transform.header = odometry.header;
    transform.child_frame_id = base_frame_;
    transform.transform.translation = to_ros(model_->WorldPose().Pos());
    transform.transform.rotation = odometry.pose.pose.orientation;
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform);
    transforms_.publish(message);
  }

  void publish_joints(const ros::Time& stamp) {
    sensor_msgs::JointState state;
    state.header.stamp = stamp;
    for (const auto& wheel : wheels_) {
      state.name.push_back(wheel->GetName());
      state.position.push_back(wheel->Position(0));
    }
    joints_.publish(state);
  }

  gazebo::physics::ModelPtr model_;
  std::vector<gazebo::physics::JointPtr> wheels_;  // left, right
  double separation_, radius_, torque_, acceleration_, period_;  // [m, m, Nm, m/s2, s]
  std::string odometry_frame_, base_frame_;
  bool publishes_odometry_, publishes_transform_;
  double wanted_[2] = {0, 0}, turn_[2] = {0, 0};  // [rad/s]
  gazebo::common::Time last_;
  ros::CallbackQueue queue_;
  std::unique_ptr<ros::NodeHandle> node_;
  ros::Subscriber command_;
  ros::Publisher odometry_, transforms_, joints_;
  gazebo::event::ConnectionPtr update_;  // last: nothing is called after it is gone
};

GZ_REGISTER_MODEL_PLUGIN(DifferentialDrive)

}  // namespace standin
