// SPDX-License-Identifier: BSD-3-Clause
// What a decision looks at in one VGA picture of scenes.hpp, for callgrind to count:
// kernel_instructions POINT_STEP INSTRUCTION_SET WAY
// The way is look; or near_loss: with the memory of what came near, of which some has been lost; or gather: what a
// guard does in the same pass, the returns around the robot and their cells. Without arguments it prints the compiler
// and its instruction sets, a line each.
#include <cstdlib>
#include <iostream>
#include <string>

#include "../../safety_control_cloud/core/guard/surroundings.hpp"
#include "../../safety_control_cloud/core/look/kernel/scan.hpp"
#include "../../safety_control_cloud/core/look/look.hpp"
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
[[gnu::noinline]] void counted(const View& view, const Outlook& outlook, Surroundings& surroundings) {
  const Alongside alongside = surroundings.begin(outlook);
  look_alongside(view, outlook, Crop::Skip, Rows::Joined, &alongside);
  surroundings.finish();
}

void gather(const View& view) {
  const Outlook outlook({}, Placement{{{{1, 0, 0, 0}, {0, 1, 0, -0.3f}, {0, 0, 1, 0.1f}}}});  // 0.3 m up, 0.1 m ahead
  const Footprint circle{{}, 0.178, 0.05};
  Surroundings surroundings(Outline(circle), {0.05, 0.55, 2.0, {}});
  counted(view, outlook, surroundings);
}

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
  const std::string way = argv[3];
  NearLossLimits limits;
  if (way != "near_loss") limits.distance = 0.0;
  NearLoss near_loss(limits);
  CameraPicture before = picture;
  before.nan_share = 0.0;
  const auto all_return = bytes_of(before), some_do_not = bytes_of(picture);
  if (way == "gather") {
    gather(view_of(picture, some_do_not.data()));
    return 0;
  }
  look_and_judge(view_of(before, all_return.data()), near_loss);
  counted(view_of(picture, some_do_not.data()), near_loss);
}
