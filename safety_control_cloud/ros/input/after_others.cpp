// SPDX-License-Identifier: BSD-3-Clause
#include "after_others.hpp"

#include <boost/make_shared.hpp>
#include <utility>

namespace safety_control_cloud {
namespace {

/// When its turn comes first, it goes to the end of the queue.
class SecondTime : public ros::CallbackInterface {
 public:
  explicit SecondTime(ros::CallbackInterfacePtr callback) : callback_(std::move(callback)) {}

  CallResult call() override { return std::exchange(waited_, true) ? callback_->call() : TryAgain; }
  bool ready() override { return callback_->ready(); }

 private:
  ros::CallbackInterfacePtr callback_;
  bool waited_ = false;
};

}  // namespace

void AfterOthers::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  queue_.addCallback(boost::make_shared<SecondTime>(callback), owner);
}

}  // namespace safety_control_cloud
