// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "../../safety_control_cloud/core/input/layout.hpp"

namespace safety_control_cloud {

/// The fuzzer's bytes as values, from the front; beyond the end there are zeros.
class Tape {
 public:
  Tape(const std::uint8_t* bytes, std::size_t size) : at_(bytes), end_(bytes + size) {}

  template <class Value>
  void operator()(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    value = Value{};
    const std::size_t size = std::min(sizeof value, left());
    std::memcpy(&value, at_, size);
    at_ += size;
  }

  void operator()(std::vector<std::uint8_t>& bytes) {
    std::uint16_t size = 0;
    (*this)(size);
    const auto taken = std::min<std::ptrdiff_t>(size, static_cast<std::ptrdiff_t>(left()));
    bytes.assign(at_, at_ + taken);
    at_ += taken;
  }

  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  const std::uint8_t *at_, *end_;
};

/// The same the other way round: makes a seed of a scenario.
class Recording {
 public:
  template <class Value>
  void operator()(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* from = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), from, from + sizeof value);
  }

  void operator()(const std::vector<std::uint8_t>& content) {
    (*this)(static_cast<std::uint16_t>(content.size()));
    bytes.insert(bytes.end(), content.begin(), content.end());
  }

  std::vector<std::uint8_t> bytes;
};

/// Which of a few values each setting has.
struct Choice {
  std::uint8_t min_points = 0, release_clouds = 0, release_time = 0, stamp_tolerance = 0, min_valid_ratio = 0;
  std::uint8_t near_loss_distance = 0, near_loss_timeout = 0, frozen_clouds = 0, range_min = 0, target_frame = 0;
};

enum class Event : std::uint8_t { Picture, Claims, Quiet, Forget, Settings, Restart, Outside };

/// One thing that happens to the node.
struct Step {
  Event event = Event::Picture;
  std::uint16_t elapsed = 50;     ///< [ms] on the steady clock
  std::int16_t ros_elapsed = 50;  ///< [ms] in ROS time
  std::int16_t stamp_age = 0;     ///< [ms]
  std::uint8_t crop = 0, placing = 0, source = 0;

  std::uint8_t width = 0, height = 0;  ///< of a picture: one byte a pixel in `bytes`, see depth_of()
  Layout claims;                       ///< of a cloud that may contradict its `bytes`
  std::vector<std::uint8_t> bytes;

  Choice choice;  ///< of other settings
};

template <class Archive, class Field>
void travel_field(Archive& archive, Field& field) {
  constexpr const char* names[] = {"x", "y", "z", "rgb", "", "X"};
  std::uint8_t name = 0;
  while (name < std::size(names) - 1 && field.name != names[name]) ++name;
  archive(name);
  field.name = names[name % std::size(names)];
  archive(field.offset);
  archive(field.datatype);
  archive(field.count);
}

template <class Archive>
void travel(Archive& archive, Layout& layout) {
  auto count = static_cast<std::uint8_t>(layout.fields.size());
  archive(count);
  layout.fields.resize(count % 8);
  for (auto& field : layout.fields) travel_field(archive, field);
  archive(layout.height);
  archive(layout.width);
  std::uint8_t big = layout.is_bigendian;  // a bool of the fuzzer's bytes would be undefined
  archive(big);
  layout.is_bigendian = big % 2 == 1;
  archive(layout.point_step);
  archive(layout.row_step);
}

/// Which of so many events a step is, and when it happens.
template <class Archive, class AnyStep>
void travel_moment(Archive& archive, AnyStep& step, std::uint8_t events) {
  auto event = static_cast<std::uint8_t>(step.event);
  archive(event);
  step.event = static_cast<decltype(step.event)>(event % events);
  archive(step.elapsed);
  archive(step.ros_elapsed);
  archive(step.stamp_age);
}

/// Reads a step from a Tape, or writes it to a Recording.
template <class Archive>
void travel(Archive& archive, Step& step) {
  travel_moment(archive, step, 7);
  if (step.event == Event::Settings) archive(step.choice);
  if (step.event != Event::Picture && step.event != Event::Claims) return;
  archive(step.crop);
  archive(step.placing);
  archive(step.source);
  if (step.event == Event::Claims) travel(archive, step.claims);
  if (step.event == Event::Picture) archive(step.width), archive(step.height);
  archive(step.bytes);
}

/// What a tape's bytes say happens in a world: first which one, and then step by step.
template <class World, class Choice, class Step>
int happen_as_told(const std::uint8_t* bytes, std::size_t size, int most_steps) {
  Tape tape(bytes, size);
  Choice choice;
  tape(choice);
  World world(choice);
  for (int steps = 0; tape.left() > 0 && steps < most_steps; ++steps) {
    Step step;
    travel(tape, step);
    world.go_on(step);
  }
  world.end_in_silence();
  return 0;
}

}  // namespace safety_control_cloud
