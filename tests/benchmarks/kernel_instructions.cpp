// SPDX-License-Identifier: BSD-3-Clause
// One look() at one VGA cloud, for callgrind to count: kernel_instructions POINT_STEP INSTRUCTION_SET
// Without arguments it prints the compiler and its instruction sets, a line each.
#include <cstdlib>
#include <iostream>

#include "../../safety_control_cloud/core/corridor.hpp"
#include "../../safety_control_cloud/core/scan.hpp"
#include "scenes.hpp"

namespace {

using namespace safety_control_cloud;

#ifdef __clang__
constexpr const char* compiler = "clang";
constexpr int version = __clang_major__;
#else
constexpr const char* compiler = "gcc";
constexpr int version = __GNUC__;
#endif

int describe() {
  std::cout << compiler << ' ' << version << '\n';
  for (const auto& name : instruction_sets()) std::cout << name << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) return describe();
  if (argc != 3) return 2;
  Picture picture;
  picture.scene = "mixed";
  picture.nan_share = 0.3;
  picture.point_step = static_cast<std::size_t>(std::strtoul(argv[1], nullptr, 10));
  const auto bytes = bytes_of(picture);
  use_instruction_set(argv[2]);
  const Sight sight = look(view_of(picture, bytes.data()), Corridor{});
  std::cout << sight.inside << " points inside\n";
}
