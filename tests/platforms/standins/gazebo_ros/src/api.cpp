// SPDX-License-Identifier: BSD-3-Clause
// Gazebo's server as the ROS node "gazebo": its clock, and models that are spawned, placed and deleted.
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <gazebo/common/common.hh>
#include <gazebo/msgs/msgs.hh>
#include <gazebo/physics/physics.hh>
#include <gazebo/transport/transport.hh>
#include <gazebo_msgs/DeleteModel.h>
#include <gazebo_msgs/ModelStates.h>
#include <gazebo_msgs/SetModelState.h>
#include <gazebo_msgs/SpawnModel.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>

#include "conversions.hpp"

namespace standin {

class Api : public gazebo::SystemPlugin {
 public:
  ~Api() override {
    update_.reset();
    if (spinner_) spinner_->stop();
    ros::shutdown();
  }

  void Load(int argc, char** argv) override {
    ros::init(argc, argv, "gazebo", ros::init_options::NoSigintHandler);
    created_ = gazebo::event::Events::ConnectWorldCreated([this](const std::string& world) { begin(world); });
  }

 private:
  void begin(const std::string& world) {
    world_ = gazebo::physics::get_world(world);
    gazebo_ = boost::make_shared<gazebo::transport::Node>();
    gazebo_->Init(world);
    requests_ = gazebo_->Advertise<gazebo::msgs::Request>("~/request");
    node_ = std::make_unique<ros::NodeHandle>("~");
    ros::param::set("/use_sim_time", true);
    clock_ = node_->advertise<rosgraph_msgs::Clock>("/clock", 10);
    states_ = node_->advertise<gazebo_msgs::ModelStates>("model_states", 10);
    spawn_ = node_->advertiseService("spawn_sdf_model", &Api::on_spawn, this);
    delete_ = node_->advertiseService("delete_model", &Api::on_delete, this);
    place_ = node_->advertiseService("set_model_state", &Api::on_place, this);
    spinner_ = std::make_unique<ros::AsyncSpinner>(1);
    spinner_->start();
    update_ = gazebo::event::Events::ConnectWorldUpdateBegin([this](const auto&) { publish(); });
  }

  void publish() {
    const auto now = world_->SimTime();
    if (now >= said_ && now < said_ + gazebo::common::Time(0.005)) return;  // 200 Hz; a world set back starts anew
    said_ = now;
    rosgraph_msgs::Clock clock;
    clock.clock = to_ros(now);
    clock_.publish(clock);
    if (states_.getNumSubscribers() > 0) states_.publish(states());
  }

  gazebo_msgs::ModelStates states() const {
    gazebo_msgs::ModelStates states;
    for (const auto& model : world_->Models()) {
      states.name.push_back(model->GetName());
      states.pose.push_back(to_ros(model->WorldPose()));
      states.twist.push_back(to_ros(model->WorldLinearVel(), model->WorldAngularVel()));
    }
    return states;
  }

  bool on_spawn(gazebo_msgs::SpawnModel::Request& wanted, gazebo_msgs::SpawnModel::Response& answer) {
    sdf::SDF parsed;
    parsed.SetFromString(wanted.model_xml);
    const auto model = parsed.Root() ? parsed.Root()->GetElement("model") : nullptr;
    if (!model || world_->ModelByName(wanted.model_name)) {
      answer.status_message = model ? "there is a model of this name" : "no SDF with a model";
      return true;
    }
    model->GetAttribute("name")->SetFromString(wanted.model_name);
    model->GetElement("pose")->Set(to_gazebo(wanted.initial_pose));
    world_->InsertModelSDF(parsed);
    answer.success = becomes(wanted.model_name, true);
    return true;
  }

  bool on_delete(gazebo_msgs::DeleteModel::Request& wanted, gazebo_msgs::DeleteModel::Response& answer) {
    if (!world_->ModelByName(wanted.model_name)) {
      answer.status_message = "there is no such model";
      return true;
    }
    // By the world's own thread: RemoveModel() in this one walks through a list to which the physics adds meanwhile.
    const auto& name = wanted.model_name;
    const std::unique_ptr<gazebo::msgs::Request> request(gazebo::msgs::CreateRequest("entity_delete", name));
    requests_->Publish(*request);
    answer.success = becomes(wanted.model_name, false);
    return true;
  }

  /// Waits until the model is there, or is not.
  bool becomes(const std::string& model, bool there) const {
    for (int turn = 0; turn < 1000 && (world_->ModelByName(model) != nullptr) != there; ++turn) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return (world_->ModelByName(model) != nullptr) == there;
  }

  bool on_place(gazebo_msgs::SetModelState::Request& wanted, gazebo_msgs::SetModelState::Response& answer) {
    const auto& state = wanted.model_state;
    const auto model = world_->ModelByName(state.model_name);
    if (!model || (!state.reference_frame.empty() && state.reference_frame != "world")) {
      answer.status_message = model ? "this stand-in knows the frame \"world\" only" : "there is no such model";
      return true;
    }
    const boost::recursive_mutex::scoped_lock lock(*world_->Physics()->GetPhysicsUpdateMutex());
    model->SetWorldPose(to_gazebo(state.pose));
    model->SetWorldTwist(to_gazebo(state.twist.linear), to_gazebo(state.twist.angular));
    answer.success = true;
    return true;
  }

  gazebo::event::ConnectionPtr created_, update_;
  gazebo::physics::WorldPtr world_;
  gazebo::transport::NodePtr gazebo_;
  gazebo::transport::PublisherPtr requests_;
  gazebo::common::Time said_{-1.0};
  std::unique_ptr<ros::NodeHandle> node_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
  ros::Publisher clock_, states_;
  ros::ServiceServer spawn_, delete_, place_;
};

GZ_REGISTER_SYSTEM_PLUGIN(Api)

}  // namespace standin
