# SPDX-License-Identifier: BSD-3-Clause
"""replay --mode guard: what of a bag, and of the settings, the guard is given; and what cannot be."""
from __future__ import annotations

import json
import math
from dataclasses import replace as changed
from pathlib import Path

import numpy as np
import pytest
from drives import SECOND, START, camera, depth, placed, write_drive, write_drive2
from guard_answers import SENSORS, replay, to_commands, told
from guard_drives import at, camera_placed, commanded, driven_at_wall, hall_with_wall, moved, odometry, scan, touched, wall_and_floor

from safety_control_cloud import core
from safety_control_cloud.replay.bags import BagError
from safety_control_cloud.replay.parameters import BadSettings, parameters_in, settings_of


def test_a_depth_image_is_a_sensor_and_its_own_cloud_beside_it_stands_for_it(tmp_path):
    records = [camera_placed(), *(commanded(0.1 * n + 0.01, 0.2) for n in range(1, 15))]
    for number in range(15):
        picture = np.full((48, 64), 3000, np.uint16) + np.random.default_rng(number).integers(0, 9, (48, 64)).astype(np.uint16)
        records += [depth(0.1 * number, picture), camera(0.1 * number, 64, 48, 50.0)]

    alone = told(tmp_path, write_drive(tmp_path / "depth.bag", records))
    assert (alone[-1]["cause"], alone[-1]["factor"]) == ("SEEN", 1.0)

    records += [wall_and_floor(0.1 * number + 0.05, 0.3) for number in range(15)]
    beside = told(tmp_path, write_drive(tmp_path / "both.bag", records))
    assert {answer["sensor"] for answer in beside} <= {"", "cloud"} and beside[-1]["factor"] == 0.0


def test_sensors_are_those_of_the_settings_and_one_that_is_not_required_may_be_in_doubt(tmp_path):
    records = [record for record in driven_at_wall(sensors=("camera", "laser")) if record.source != "/laser_place"]
    bag = write_drive(tmp_path / "drive.bag", records)
    (tmp_path / "guard.yaml").write_text(json.dumps(
        {"mode": "guard", "sensors": [{**SENSORS[0], "name": "front"}, {**SENSORS[1], "required": False}]}))

    result = replay(bag, "--settings", tmp_path / "guard.yaml", "--json", tmp_path / "answers.json")

    assert result.returncode == 0 and "no transform in the bag leads from laser (/scan) to base_footprint" in result.stderr
    answers = json.loads((tmp_path / "answers.json").read_text())
    assert answers[-1]["sensor"] == "front" and answers[-1]["factor"] == 0.0


def test_topics_with_one_name_are_told_apart(tmp_path):
    records = [*driven_at_wall(seconds=1.0, sensors=["laser"]), *(
        scan(0.1 * n + 0.05, hall_with_wall(0.3, n), topic=name) for n in range(10) for name in ("/a/b", "/a_b"))]

    sensors = {answer["sensor"] for answer in told(tmp_path, write_drive(tmp_path / "drive.bag", records))}

    assert sensors & {"a_b", "a_b_1"}
    chosen = told(tmp_path, tmp_path / "drive.bag", "--topic", "/scan")
    assert {answer["sensor"] for answer in chosen} <= {"", "scan"} and chosen[-1]["factor"] == 1.0


@pytest.mark.parametrize("turns, cause", [(0.0, "SEEN"), (0.8, "NO_TRANSFORM")])
def test_a_camera_that_turns_has_no_place_by_a_transform_that_is_late(tmp_path, turns, cause):
    def head(time: float):
        half = 0.5 * turns * max(0.0, time - 0.75)
        ahead, aside = 0.5 * math.cos(half), 0.5 * math.sin(half)
        turn = (-ahead - aside, ahead - aside, -ahead + aside, ahead + aside)
        late = round((time + 0.08) * SECOND)
        return changed(placed(time, (-0.087, 0.0, 0.2972), turn, parent="base_footprint"), time=late)

    records = [head(0.02 * n) for n in range(75)]
    records += [commanded(0.1 * n + 0.01, 0.2) for n in range(2, 15)]
    records += [wall_and_floor(0.1 * n + 0.005, 3.0) for n in range(2, 15)]

    answers = told(tmp_path, write_drive(tmp_path / "drive.bag", records))

    assert answers[-1]["cause"] == cause, answers[-1]
    assert cause == "SEEN" or "moves in base_footprint, and its newest transform is" in answers[-1]["reason"]


LASER_ALONE = driven_at_wall(seconds=1.0, sensors=["laser"])
SECOND_COMMANDS = [commanded(0.5, 0.1, topic="/base/cmd_vel_out")]
LATE = [record if record.topic != "/scan" else scan(record.time / SECOND, hall_with_wall(3.0, record.time), age=3600.0)
        for record in LASER_ALONE]
UNUSABLE = {
    "no commands": (without := [r for r in LASER_ALONE if r.topic != "/cmd_vel"], [], "no geometry_msgs/Twist"),
    "two topics of them": ([*LASER_ALONE, *SECOND_COMMANDS], [], "say which by --cmd-vel; there is: /base/cmd_vel_out (geometry_msgs/Twist, 1), /cmd_vel"),
    "none of that name": (LASER_ALONE, ["--cmd-vel", "/teleop"], "on /teleop in"),
    "none of that type": ([*without, *SECOND_COMMANDS], ["--param", "command_type=twist_stamped"], "no geometry_msgs/TwistStamped"),
    "two odometries": ([*LASER_ALONE, odometry(0.1, 0, 0, "/a"), odometry(0.1, 0, 0, "/b")], ["--odom", "/c"], "no nav_msgs/Odometry on /c"),
    "no sensor": ([r for r in LASER_ALONE if r.topic != "/scan"], [], "no LaserScan"),
    "no such sensor": (LASER_ALONE, ["--topic", "/points"], "no cloud, depth image with its CameraInfo, or scan on /points"),
    "no place of the laser": ([r for r in LASER_ALONE if r.source != "/laser_place"], [], "no transform in the bag leads from laser (/scan) to base_footprint"),
    "another base": (LASER_ALONE, ["--param", "base_frame=base_link"], "from laser (/scan) to base_link"),
    "another clock": (LATE, [], "the stamps of /scan are of another clock, 3600.000 s behind the bag's time or more"),
    "a wrong parameter": (LASER_ALONE, ["--param", "margn=0.1"], "there is no parameter margn"),
    "what is of mode drive": (LASER_ALONE, ["--around", "3"], "--around"),
}


@pytest.mark.parametrize("case", UNUSABLE)
def test_what_cannot_be_guarded_is_told_in_a_line(tmp_path, case):
    records, arguments, words = UNUSABLE[case]

    with pytest.raises((BagError, BadSettings)) as refused:
        told(tmp_path, write_drive(tmp_path / "drive.bag", records), *arguments)

    assert words in str(refused.value) and "\n" not in str(refused.value)


def test_and_its_exit_code_is_2(tmp_path):
    result = replay(write_drive(tmp_path / "drive.bag", UNUSABLE["no commands"][0]), "--mode", "guard")

    assert (result.returncode, result.stdout, len(result.stderr.splitlines())) == (2, "", 1)
    assert result.stderr.startswith("replay: no geometry_msgs/Twist or geometry_msgs/TwistStamped on a topic named cmd_vel*")


def test_in_mode_drive_a_laser_is_pointed_to_mode_guard(tmp_path):
    bag = write_drive(tmp_path / "laser.bag", LASER_ALONE)

    assert "scripts/replay --mode guard looks at a LaserScan too: /scan (10)" in replay(bag).stderr
    assert replay(bag, "--cmd-vel", "/cmd_vel").returncode == 2


def test_stamps_that_jump_and_long_pauses_are_told_and_the_guard_says_what_they_mean(tmp_path):
    records = [record if record.topic != "/scan" or record.time < 2 * SECOND else
               scan(record.time / SECOND, hall_with_wall(4.0, record.time), age=5.0) for record in driven_at_wall(gap=4.0, sensors=["laser"])]
    records.append(commanded(90_000.0, 0.1))
    bag = write_drive(tmp_path / "jumps.bag", records)

    result = replay(bag, "--mode", "guard", "--json", tmp_path / "answers.json")

    assert result.returncode == 0
    assert "the stamps of /scan jump by -5.000 s against the bag's time at 2.0" in result.stderr
    assert "nothing was recorded for 89996.9 s from 3.057 s on: " in result.stderr and "a pause, or a clock that jumped" in result.stderr
    causes = {answer["cause"] for answer in json.loads((tmp_path / "answers.json").read_text())}
    assert {"SEEN", "STALE", "SILENT"} <= causes


DEFAULTS = Path(__file__).resolve().parents[3] / "safety_control_cloud" / "config" / "default.yaml"


def test_the_packages_own_settings_are_taken_in_either_mode(tmp_path):
    bag = write_drive(tmp_path / "drive.bag", driven_at_wall(seconds=1.0))

    assert to_commands(told(tmp_path, bag, "--settings", DEFAULTS))[-1]["cause"] == "SEEN"
    result = replay(bag, "--settings", DEFAULTS)
    assert (result.returncode, result.stderr) == (0, "") and "10 clouds: " in result.stdout
    assert settings_of(parameters_in(DEFAULTS)).as_dict() == core.Settings().as_dict()


@pytest.mark.parametrize("given, taken", [(True, True), ("true", True), ("False", False), ("no", None), (1, None), ([], None)])
def test_a_truth_is_written_as_for_roscpp(given, taken):
    if taken is not None:
        assert settings_of({"inf_is_free": given}).inf_is_free is taken
        return
    with pytest.raises(BadSettings, match="inf_is_free cannot be"):
        settings_of({"inf_is_free": given})


def test_help_tells_of_the_guard():
    words = " ".join(replay("--help").stdout.split())
    assert "--mode guard: the guard's own decision in the bag's own time" in words and "--cmd-vel T" in words


def test_with_an_odom_frame_the_bags_transforms_tell_where_the_robot_went(tmp_path):
    drive = driven_at_wall()
    by_tf = [record for record in drive if record.topic != "/odom"] + [
        moved(record.time / SECOND, at(record.time / SECOND)) for record in drive if record.topic == "/odom"]
    by_topic = to_commands(told(tmp_path, write_drive(tmp_path / "odom.bag", drive)))

    answers = to_commands(told(tmp_path, write_drive(tmp_path / "tf.bag", by_tf), "--param", "odom_frame=odom"))
    blind = to_commands(told(tmp_path, tmp_path / "tf.bag"))

    assert [answer["driven"] for answer in answers] == [None] * 60
    off = [abs(one["factor"] - other["factor"]) for one, other in zip(answers, by_topic)]
    assert sum(off) < sum(abs(one["factor"] - other["factor"]) for one, other in zip(blind, by_topic))
    assert [answer["cause"] for answer in answers] == [answer["cause"] for answer in by_topic]


@pytest.mark.parametrize("write, name", [(write_drive, "drive.bag"), (write_drive2, "drive")])
def test_a_bumper_closes_its_side_and_one_that_never_spoke_is_told(tmp_path, write, name):
    records = [*driven_at_wall(gap=4.0), touched(1.5, True), touched(2.0, False)]
    (tmp_path / "guard.yaml").write_text(json.dumps({"mode": "guard", "switches": [
        {"name": "front", "type": "bumper", "topic": "bumper", "side": "front"},
        {"name": "rear", "type": "bumper", "topic": "rear", "side": "rear"}]}))

    result = replay(write(tmp_path / name, records), "--settings", tmp_path / "guard.yaml", "--json", tmp_path / "answers.json")

    assert (result.returncode, result.stderr) == (0, "replay: nothing of the switch rear was recorded: it is taken for released\n")
    answers = json.loads((tmp_path / "answers.json").read_text())
    bumped = [answer["time"] - START / 1e9 for answer in answers if answer["cause"] == "BUMPER"]
    assert bumped[0] == pytest.approx(1.5) and 2.4 < bumped[-1] < 2.55  # released for switch_release_time
    assert next(answer for answer in answers if answer["cause"] == "BUMPER")["asked_by"] == "front"


def test_two_switches_may_hear_one_topic(tmp_path):
    (tmp_path / "guard.yaml").write_text(json.dumps({"switches": [
        {"name": side, "type": "bumper", "topic": "bumper", "side": side} for side in ("rear", "front")]}))
    bag = write_drive(tmp_path / "drive.bag", [*driven_at_wall(gap=4.0), touched(1.5, True), touched(2.0, False)])

    answers = told(tmp_path, bag, "--settings", tmp_path / "guard.yaml")

    assert [side for side in ("rear", "front") if any(f"touches the {side}" in answer["reason"] for answer in answers)] == ["rear", "front"]


def test_what_no_side_is_said_of_is_refused(tmp_path):
    bag = write_drive(tmp_path / "drive.bag", [*LASER_ALONE, touched(0.5, True)])
    (tmp_path / "guard.yaml").write_text(json.dumps({"switches": [{"name": "front", "type": "bumper", "topic": "bumper"}]}))

    with pytest.raises(BagError, match="bumper is of std_msgs/msg/Bool, which do not say a side"):
        told(tmp_path, bag, "--settings", tmp_path / "guard.yaml")
