// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "camera_pose.hpp"
#include "kept.hpp"

namespace safety_control_cloud {

/// What is near or lost, as text that outlives the process.
class Written {
 public:
  Written() = default;
  /// What another process wrote, of anything near or lost, or of nothing.
  Written(std::string text, bool any) : text_(std::move(text)), is_any_lost_(any), is_any_near_(any) {}

  /// In some kilobytes; empty if nothing is near or lost.
  const std::string& text() const { return text_; }

  /// Whether anything was near, or lost, when it was written.
  bool is_any_near() const { return is_any_near_; }
  bool is_any_lost() const { return is_any_lost_; }

  /// Four times a second, and at once when something is lost or found or nothing is near any more; once a second if all
  /// that is near is seen and stays where it was: whoever keeps the text has to take it each time. `kept` tells of all
  /// things; those count that are nearer than `near` [m] ahead of the camera. `now` [s] steady.
  template <class MakeKept>
  void bring_up_to_date(const std::vector<Remembered>& things, float near, bool lost, double now, MakeKept kept) {
    const bool any_near = is_any_near_in(things, near);
    if (!is_due(lost, any_near, now)) return;
    auto told = told_of(things, near);
    if (lost == is_any_lost_ && says(told, now)) return;
    write(kept(), near);
    written_at_ = now;
    is_any_lost_ = lost;
    is_any_near_ = any_near;
    told_ = std::move(told);
  }

 private:
  /// A thing that is seen, as far as it counts whether that changes.
  struct Told {
    float nearest;           ///< [m] ahead of the camera
    Eigen::Vector3f middle;  ///< of its spots, in the cloud's frame [m]
    double size;             ///< [m2]
    CameraPose camera;

    bool is_as(const Told& other) const;
  };

  static bool is_any_near_in(const std::vector<Remembered>& things, float near);
  static std::vector<Told> told_of(const std::vector<Remembered>& things, float near);
  bool is_due(bool lost, bool any_near, double now) const;
  bool says(const std::vector<Told>& told, double now) const;
  void write(Kept kept, float near);

  std::string text_;
  double written_at_ = 0.0;  ///< [s]
  bool is_any_lost_ = false, is_any_near_ = false;
  std::vector<Told> told_;
};

}  // namespace safety_control_cloud
