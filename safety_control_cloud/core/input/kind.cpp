// SPDX-License-Identifier: BSD-3-Clause
#include "kind.hpp"

#include "../text/choice.hpp"

namespace safety_control_cloud {

const char* name_of(InputKind input) {
  switch (input) {
    case InputKind::Depth:
      return "depth";
    case InputKind::Scan:
      return "scan";
    case InputKind::Cloud:
      break;
  }
  return "cloud";
}

std::optional<InputKind> input_named(const std::string& name) {
  return choice_named(name, {InputKind::Cloud, InputKind::Depth, InputKind::Scan});
}

}  // namespace safety_control_cloud
