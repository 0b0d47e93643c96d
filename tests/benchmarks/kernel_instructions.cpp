// SPDX-License-Identifier: BSD-3-Clause
// What a decision looks at in one VGA picture of scenes.hpp, for callgrind to count:
// kernel_instructions POINT_STEP INSTRUCTION_SET WAY
// The way is look, or near_loss: with the memory of what came near, of which some has been lost.
// Without arguments it prints the compiler and its instruction sets, a line each.
#include <cstdlib>
#include <iostream>

#include "../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "look_and_judge.hpp"
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

/// Callgrind counts what happens in here.
[[gnu::noinline]] void counted(const View& view, NearLoss& near_loss) { look_and_judge(view, near_loss); }

int describe() {
  std::cout << compiler << ' ' << version << '\n';
  for (const auto& name : instruction_sets()) std::cout << name << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) return describe();
  if (argc != 4) return 2;
  CameraPicture picture;
  picture.scene = "mixed";
  picture.nan_share = 0.3;
  picture.point_step = static_cast<std::size_t>(std::strtoul(argv[1], nullptr, 10));
  use_instruction_set(argv[2]);
  NearLossLimits limits;
  if (argv[3] != std::string("near_loss")) limits.distance = 0.0;
  NearLoss near_loss(limits);
  CameraPicture before = picture;
  before.nan_share = 0.0;
  const auto all_return = bytes_of(before), some_do_not = bytes_of(picture);
  look_and_judge(view_of(before, all_return.data()), near_loss);
  counted(view_of(picture, some_do_not.data()), near_loss);
}
