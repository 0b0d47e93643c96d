// SPDX-License-Identifier: BSD-3-Clause
#include "switch_word.hpp"

#include <array>
#include <stdexcept>

namespace safety_control_cloud {
namespace {

/// Whose first byte is 0, 1 or 2 for left, center or right, and whose second is 1 if it is touched.
struct KobukiEvent {
  const char* type;
  std::size_t size;
};

constexpr std::array<KobukiEvent, 2> kobuki_events = {{{"kobuki_msgs/BumperEvent", 2}, {"kobuki_msgs/CliffEvent", 4}}};
constexpr std::array<Edge, 3> kobuki_edges = {Edge::FrontLeft, Edge::Front, Edge::FrontRight};

}  // namespace

SwitchWord word_in(const std::string& type, const std::vector<std::uint8_t>& bytes) {
  if (type == "std_msgs/Bool" && bytes.size() == 1) return {std::nullopt, bytes[0] != 0};
  for (const KobukiEvent& event : kobuki_events) {
    if (type == event.type && bytes.size() == event.size && bytes[0] < kobuki_edges.size())
      return {kobuki_edges[bytes[0]], bytes[1] != 0};
  }
  throw std::invalid_argument("a message of " + type +
                              " is no std_msgs/Bool and no event of a Kobuki's bumper or cliff");
}

}  // namespace safety_control_cloud
