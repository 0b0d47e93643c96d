// SPDX-License-Identifier: BSD-3-Clause
#include "depth_pairs.hpp"

#include <algorithm>
#include <utility>

namespace safety_control_cloud {
namespace {

const ros::Time& stamp_of(const CameraEvent& camera) { return camera.getConstMessage()->header.stamp; }

}  // namespace

DepthPairs::DepthPairs(OnPair on_pair) : on_pair_(std::move(on_pair)) {}

void DepthPairs::add(const DepthImage& image) {
  const auto its = [&](const CameraEvent& camera) { return stamp_of(camera) == image.header.stamp; };
  const auto found = std::find_if(cameras_.begin(), cameras_.end(), its);
  if (found == cameras_.end()) return keep(image);
  const CameraEvent camera = *found;
  forget_until(image.header.stamp);
  on_pair_(image, camera);
}

void DepthPairs::add(const CameraEvent& camera) {
  const auto its = [&](const Kept& kept) { return kept.image.header.stamp == stamp_of(camera); };
  const auto found = std::find_if(images_.rbegin(), images_.rend(), its);  // of two with one stamp the later
  if (found == images_.rend()) {
    if (cameras_.size() == waiting) cameras_.pop_front();
    cameras_.push_back(camera);
    return;
  }
  Kept kept = std::move(*found);
  forget_until(stamp_of(camera));
  on_pair_(kept.image, camera);
  spare_ = std::move(kept.copy);
}

void DepthPairs::keep(const DepthImage& image) {
  if (images_.size() == waiting) {
    spare_ = std::move(images_.front().copy);
    images_.pop_front();
  }
  Kept kept{image, {}};
  if (!image.owner) {
    kept.copy = std::move(spare_);
    kept.copy.assign(image.bytes.first, image.bytes.first + image.bytes.size);
    kept.image.bytes.first = kept.copy.data();
  }
  images_.push_back(std::move(kept));
}

void DepthPairs::forget_until(const ros::Time& stamp) {
  const auto old_camera = [&](const CameraEvent& camera) { return stamp_of(camera) <= stamp; };
  const auto old_image = [&](const Kept& kept) { return kept.image.header.stamp <= stamp; };
  cameras_.erase(std::remove_if(cameras_.begin(), cameras_.end(), old_camera), cameras_.end());
  images_.erase(std::remove_if(images_.begin(), images_.end(), old_image), images_.end());
}

}  // namespace safety_control_cloud
