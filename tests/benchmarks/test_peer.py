# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench --peer: what it takes for a checkout, what it says of one that lacks something, and what it tells of both."""
from argparse import Namespace
from math import hypot
from pathlib import Path

import measuring
import options
import peer
import peer_build
import pytest
from peer_checkout import checkout_of
from repetitions import Plan, Timing

from safety_control_cloud import core
from safety_control_cloud.processes import ProcessError

MSGS = "safety_limiter_msgs"
PROGRAM = """
cmake_minimum_required(VERSION 3.0.2)
project(safety_limiter CXX)
find_package(catkin REQUIRED COMPONENTS {needs})
catkin_package()
add_executable(safety_limiter main.cpp)
"""
USES_PLACEHOLDERS = "int main() { return boost::bind(+[](int, int) { return 0; }, _1, _2)(1, 2); }\n"  # which Debian's ROS leaves out


def package(folder: Path, name: str, *needs: str, buildtool: str = "catkin") -> Path:
    folder.mkdir(parents=True)
    depends = "".join(f"<depend>{need}</depend>" for need in needs)
    about = "<version>0.1.0</version><description>.</description><maintainer email='a@example.org'>a</maintainer><license>BSD</license>"
    built = f"<buildtool_depend>{buildtool}</buildtool_depend>"
    (folder / "package.xml").write_text(f"<package format='2'><name>{name}</name>{about}{built}{depends}</package>")
    return folder


@pytest.fixture
def src(tmp_path):
    """A workspace's, with a package that safety_limiter does not need."""
    folder = tmp_path / "src"
    package(folder / "neonavigation" / "safety_limiter", "safety_limiter", "roscpp", "neonavigation_common", MSGS)
    package(folder / "neonavigation" / "neonavigation_common", "neonavigation_common", "roscpp")
    package(folder / "neonavigation" / "planner", "planner")
    package(folder / "msgs" / MSGS, MSGS, "std_msgs")
    return folder


def refused(capsys, *words: str) -> str:
    with pytest.raises(SystemExit) as ended:
        options.arguments(words)
    assert ended.value.code == 2
    return capsys.readouterr().err


def test_a_workspace_has_what_safety_limiter_needs_and_nothing_else_is_taken(src):
    checkout = options.arguments(["--only", "guard", "--peer", str(src)]).peer
    assert set(checkout.packages) == {"safety_limiter", "neonavigation_common", MSGS} and not checkout.missing
    assert checkout.packages[MSGS] == src / "msgs" / MSGS


def test_the_package_itself_is_a_checkout_that_lacks_its_neighbours(src):
    checkout = checkout_of(str(src / "neonavigation" / "safety_limiter"))
    assert set(checkout.packages) == {"safety_limiter"}
    assert checkout.missing == {MSGS: "at-wat/neonavigation_msgs", "neonavigation_common": "at-wat/neonavigation"}


def test_a_clone_finds_the_messages_cloned_beside_it(src):
    (src / "msgs").rename(src / "neonavigation_msgs")
    package(src / "neonavigation_msgs" / "planner_msgs", "planner_msgs")
    checkout = checkout_of(str(src / "neonavigation"))
    assert checkout.packages[MSGS] == src / "neonavigation_msgs" / MSGS and not checkout.missing
    assert "planner_msgs" not in checkout.packages


def test_what_lies_in_the_given_folder_counts_before_a_clone_beside_it(src):
    package(src / "neonavigation_msgs" / MSGS, MSGS)
    package(src / "neonavigation" / MSGS, MSGS)
    assert checkout_of(str(src / "neonavigation")).packages[MSGS] == src / "neonavigation" / MSGS


def test_a_branch_for_ros_2_is_refused_at_once(tmp_path, capsys):
    package(tmp_path / "safety_limiter", "safety_limiter", "rclcpp", buildtool="ament_cmake_auto")
    assert "is not of ROS 1" in refused(capsys, "--only", "guard", "--peer", str(tmp_path))


def test_a_repository_that_is_linked_into_the_workspace_counts(src, tmp_path):
    (tmp_path / "linked").mkdir()
    (tmp_path / "linked" / "neonavigation").symlink_to(src / "neonavigation")
    assert "safety_limiter" in checkout_of(str(tmp_path / "linked")).packages


def test_of_two_the_one_that_lies_less_deep_is_taken(src):
    package(src / "old" / "copy" / "safety_limiter", "safety_limiter")
    assert checkout_of(str(src)).packages["safety_limiter"].parent.name == "neonavigation"


def test_what_catkin_ignores_is_not_there(src):
    package(src / "safety_limiter", "safety_limiter")
    (src / "safety_limiter" / "CATKIN_IGNORE").write_text("")
    assert checkout_of(str(src)).packages["safety_limiter"].parent.name == "neonavigation"


@pytest.mark.parametrize("place, reason", [("nowhere", "is not a folder"), ("", "no package safety_limiter"), ("file", "is not a folder")])
def test_what_is_no_checkout_is_refused_at_once_with_the_reason(place, reason, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "package.xml").write_text("<package>")
    assert reason in refused(capsys, "--only", "guard", "--peer", str(tmp_path / place))


def test_a_peer_needs_the_guard(src, capsys):
    assert "--peer needs --only guard" in refused(capsys, "--only", "kernel", "--peer", str(src))


@pytest.mark.parametrize("given, parts", [
    (Namespace(only=["guard"], peer=None), ["guard"]),
    (Namespace(only=["guard"], peer="a checkout"), ["guard", "peer"]),
])
def test_the_peer_is_measured_if_it_is_asked_for(given, parts):
    assert measuring.parts_of(given) == parts


def test_it_is_no_part_of_a_full_run():
    assert set(measuring.PARTS) - set(measuring.parts_of(Namespace(only=None, peer=None))) == {"peer"}


def test_what_lies_neither_beside_it_nor_is_installed_is_named_with_its_repository(src, tmp_path):
    checkout = checkout_of(str(src / "neonavigation"))
    with pytest.raises(ProcessError, match=r"safety_limiter_msgs \(of at-wat/neonavigation_msgs\): not in the folder"):
        peer_build.refuse_what_is_missing(checkout, [tmp_path])
    package(tmp_path / "share" / MSGS, MSGS)
    peer_build.refuse_what_is_missing(checkout, [tmp_path])


@pytest.fixture
def source(tmp_path, monkeypatch):
    """A package safety_limiter, of one line."""
    monkeypatch.setattr(peer_build, "PROGRAMS", tmp_path / "built")
    folder = package(tmp_path / "safety_limiter", "safety_limiter")
    (folder / "main.cpp").write_text(USES_PLACEHOLDERS)
    return folder


def test_it_is_built_beside_the_checkout_which_stays_as_it_was(source):
    (source / "CMakeLists.txt").write_text(PROGRAM.format(needs=""))
    before = {path: path.stat().st_mtime_ns for path in [source, *source.rglob("*")]}
    program = peer_build.program_of(checkout_of(str(source)))
    assert program.exists() and peer_build.PROGRAMS in program.parents
    assert {path: path.stat().st_mtime_ns for path in [source, *source.rglob("*")]} == before


def test_a_package_that_is_not_installed_is_named_as_apt_knows_it(source):
    (source / "CMakeLists.txt").write_text(PROGRAM.format(needs="no_such_msgs"))
    with pytest.raises(ProcessError, match=r"no_such_msgs is not installed \(Debian: libno-such-msgs-dev"):
        peer_build.program_of(checkout_of(str(source)))


def test_of_a_build_that_fails_the_first_error_is_told():
    assert peer_build.reason_of("all is well\nx.cpp:1:2: error: no\ny.cpp:3: error: neither\n") == "x.cpp:1:2: error: no"


def test_its_body_is_around_the_guards_circle():
    corners = peer.polygon(0.178)
    middles = [hypot(a[0] + b[0], a[1] + b[1]) / 2 for a, b in zip(corners, corners[1:] + corners[:1])]
    assert middles == pytest.approx([0.178] * peer.CORNERS)


def test_it_is_set_as_the_guard_or_left_at_its_own():
    parameters = peer.parameters_of(core.Settings(mode="guard").as_dict())
    assert set(parameters) == set(peer.SIDES)
    assert set(parameters["peer"]["/safety_limiter"]) == {"footprint"}
    given = parameters["peer_as_ours"]["/safety_limiter"]
    assert given["freq"] == 20.0 and given["lin_acc"] == 0.36 and (given["z_range_min"], given["z_range_max"]) == (0.05, 0.55)


def table(**cpu_ms: float) -> peer.Table:
    return {16: costs(**cpu_ms)}


def costs(**cpu_ms: float) -> peer.Costs:
    return {side: peer.Cost(Timing(1, 1, 1), Timing(2, 2, 3), Timing(cpu, cpu, cpu), 0.0) for side, cpu in cpu_ms.items()}


def test_the_worst_figure_is_of_the_settings_that_suit_the_peer_better():
    figures = peer.figures(table(ours=2.0, floor=1.5, peer=14.0, peer_as_ours=20.0))
    assert figures["peer_cpu_vs_guard"] == {"worst": 7.0, "median": 8.5}
    assert figures["peer_cpu_vs_guard_above_floor"]["worst"] == 25.0


def test_the_worst_figure_is_of_the_clouds_that_suit_the_peer_better():
    little, much = costs(ours=2.0, floor=1.5, peer=14.0, peer_as_ours=20.0), costs(ours=4.0, floor=2.0, peer=14.0, peer_as_ours=20.0)
    assert peer.figures({16: little, 32: much})["peer_cpu_vs_guard"]["worst"] == 3.5
    assert peer.figures({16: little, 32: much})["peer_cpu_vs_guard_above_floor"]["worst"] == 6.0


def test_a_guard_that_is_not_told_from_the_floor_has_a_finite_ratio():
    assert peer.figures(table(ours=1.4, floor=1.5, peer=11.5, peer_as_ours=11.5))["peer_cpu_vs_guard_above_floor"]["worst"] == 1000.0


def test_a_command_that_a_later_one_passed_over_counts_as_unanswered():
    met = {"latency_ms": [1.0, 2.0, 3.0], "cpu_ms": 1.0, "said": 4}
    assert peer.cost_of([met, met]).unanswered == 0.25


def test_the_table_has_a_row_for_each_and_a_meaning_for_each_figure():
    of_each = costs(ours=2.0, floor=1.5, peer=14.0, peer_as_ours=20.0)
    shown = {point_step: of_each for point_step in peer.POINT_STEPS}
    assert peer.table_of(shown).row_count == len(peer.as_json(shown)) == len(peer.cases(Plan(quick=True, repetitions=1, clouds=1))) == 2 * len(peer.SIDES)
    assert set(peer.figures(shown)) <= set(measuring.MEANINGS)
