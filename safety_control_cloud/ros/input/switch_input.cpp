// SPDX-License-Identifier: BSD-3-Clause
#include "switch_input.hpp"

#include <ros/message_event.h>
#include <ros/serialization.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../graph/named_in.hpp"
#include "switch_word.hpp"

namespace safety_control_cloud {
namespace {

using Event = ros::MessageEvent<const topic_tools::ShapeShifter>;

/// A word that tells of a change must not be lost behind later ones, of whoever says the same fifty times a second to a
/// node that is stopped for half an hour.
constexpr std::uint32_t unread = 100000;

std::vector<std::uint8_t> bytes_of(const topic_tools::ShapeShifter& message) {
  std::vector<std::uint8_t> bytes(message.size());
  ros::serialization::OStream stream(bytes.data(), message.size());
  message.write(stream);
  return bytes;
}

/// Of the message, or of the settings: one of them says it.
Edge edge_of(const SwitchWord& word, const SwitchSettings& settings) {
  if (word.side && settings.side) throw std::invalid_argument("its messages say their side: leave out side");
  if (!word.side && !settings.side) throw std::invalid_argument("its messages say no side: set side");
  return word.side ? *word.side : *settings.side;
}

}  // namespace

SwitchInput::SwitchInput(ros::NodeHandle& handle, const SwitchSettings& settings, OnSwitch on_switch,
                         OnLiving on_living)
    : settings_(settings),
      on_switch_(std::move(on_switch)),
      on_living_(std::move(on_living)),
      handle_(handle),
      publishers_(handle.resolveName(named_in(handle, settings.topic)), Connected::Self::Counts) {
  subscribe();
}

void SwitchInput::subscribe() {
  subscriber_.shutdown();
  subscriber_ = handle_.subscribe<topic_tools::ShapeShifter>(
      named_in(handle_, settings_.topic), unread, boost::function<void(const Event&)>([this](const Event& event) {
        on_message(event.getPublisherName(), *event.getConstMessage());
      }),
      nullptr, ros::TransportHints().tcpNoDelay());
}

void SwitchInput::note_publishers() {
  const bool was_published = is_published_;
  const std::size_t connected = subscriber_.getNumPublishers();
  const auto living = publishers_.living(connected);
  is_published_ = connected > 0 && (!living || !living->names.empty());
  if (living) on_living_(*living);
  if (was_published && !is_published_) {
    unreadable_.reset();
    is_left_ = true;
  }
  if (is_published_ || !is_left_ || !living || !living->is_master_there) return;
  is_left_ = false;
  subscribe();
}

void SwitchInput::on_message(const std::string& who, const topic_tools::ShapeShifter& message) {
  try {
    const SwitchWord word = word_in(message.getDataType(), bytes_of(message));
    const Edge edge = edge_of(word, settings_);
    unreadable_.reset();
    on_switch_(who, edge, word.touched);
  } catch (const std::invalid_argument& problem) {
    unreadable_ = Doubt{Cause::Unreadable, problem.what()};
  }
}

std::optional<Doubt> SwitchInput::doubt() const {
  if (unreadable_) return unreadable_;
  if (is_published_) return std::nullopt;
  return Doubt{Cause::Silent, "nobody publishes " + subscriber_.getTopic()};
}

}  // namespace safety_control_cloud
