# SPDX-License-Identifier: BSD-3-Clause
"""The command as a user runs it: a bag in, the real node, a table out."""
from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, Sequence

import numpy as np
import pytest
from drives import camera, depth, placed, wall, write_drive
from judge_rows import rows_of
from patience import eventually
from recordings import TOPIC, wall_at, write_ros1, write_ros2

SECOND = 10**9
SHARED = Path(__file__).resolve().parents[4] / "shared"
DRIVE = [wall_at(1.5, 10 * SECOND), wall_at(0.75, 11 * SECOND), wall_at(0.4, 12 * SECOND)]
SAID = ("zone", "cause", "reason", "nearest", "inside", "returns", "total", "speed")
COMMAND = [sys.executable, "-m", "safety_control_cloud.replay"]


def replay(*arguments: Any) -> subprocess.CompletedProcess:
    return subprocess.run([*COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def answers(folder: Path, *arguments: Any) -> List[Dict[str, Any]]:
    result = replay(*arguments, "--json", folder / "answers.json")
    assert (result.returncode, result.stderr) == (0, "")
    return json.loads((folder / "answers.json").read_text())


def of(objects: Sequence[Dict[str, Any]], *names: str) -> list:
    return [tuple(answer[name] for name in names) for answer in objects]


@pytest.mark.parametrize("method", ["one_pass", "pcl"])
@pytest.mark.parametrize("write, name", [(write_ros1, "drive.bag"), (write_ros2, "drive")])
def test_a_drive_towards_a_wall_slows_and_stops(tmp_path, write, name, method):
    bag = write(tmp_path / name, {TOPIC: DRIVE})

    drive = answers(tmp_path, bag, "--method", method)

    assert of(drive, "stamp", "zone", "cause", "speed") == [
        (10.0, "Safe", "SEEN", 0.2), (11.0, "Warning", "SEEN", 0.1), (12.0, "Danger", "SEEN", 0.0)]
    assert [round(answer["nearest"], 6) for answer in drive] == [1.5, 0.75, 0.4]
    assert of(drive, "inside", "returns", "total") == [(35, 142, 143)] * 3
    assert drive[0]["reason"] == "nearest obstacle at 1.500 m"


def test_the_table_and_the_plot_show_the_drive(tmp_path):
    bag = write_ros1(tmp_path / "drive.bag", {TOPIC: DRIVE})

    result = replay(bag, "--plot", tmp_path / "drive.png")

    rows = [" ".join(line.split()) for line in result.stdout.splitlines() if line[:1].isdigit()]
    assert rows[1] == "11.000000000 Warning SEEN 0.750 35/142/143 0.1"
    assert "3 clouds: Safe 1, Warning 1, Danger 1" in result.stdout
    assert (tmp_path / "drive.png").read_bytes().startswith(b"\x89PNG")


def test_no_cloud_is_dropped_and_each_gets_its_own_answer_whatever_its_stamp(tmp_path):
    stamps = [0, 0, 0, 5, 5, 4, 5, 5, SECOND - 1, SECOND - 1, 3, 2, 2] * 20
    distances = [0.3 + 0.01 * number for number in range(len(stamps))]
    made = [wall_at(distance, stamp) for distance, stamp in zip(distances, stamps)]
    bag = write_ros1(tmp_path / "stamps.bag", {TOPIC: made})

    got = answers(tmp_path, bag, "--param", "near_loss_distance=0")  # walls that leap away are no test of that

    by_stamp = sorted(range(len(stamps)), key=lambda number: stamps[number])  # a bag is read in the order of time
    assert [answer["stamp"] for answer in got] == [stamps[number] / 1e9 for number in by_stamp]
    assert {answer["cause"] for answer in got} == {"SEEN"}  # nothing that the replay does looks like a second camera
    assert [round(answer["nearest"], 4) for answer in got] == [round(distances[number], 4) for number in by_stamp]


def test_an_obstacle_lost_from_sight_has_a_distance_and_no_place(tmp_path):
    lost = wall_at(3.0, 2)
    lost.points[:, 0] += 2.0
    bag = write_ros1(tmp_path / "lost.bag", {TOPIC: [wall_at(0.45, 1), lost]})

    got = answers(tmp_path, bag)

    assert of(got[1:], "cause", "zone", "nearest_point", "speed") == [("NEAR_LOSS", "Danger", None, 0.0)]
    assert round(got[1]["nearest"], 4) == 0.45


def test_malformed_clouds_reach_the_node_as_they_are(tmp_path):
    malformed = [wall_at(1.5, 1), wall_at(1.5, 2, fields=[]), wall_at(1.5, 3, point_step=13),
                 wall_at(1.5, 4, row_step=2**32 - 1), wall_at(1.5, 5, width=2**31), wall_at(1.5, 6)]
    bag = write_ros1(tmp_path / "malformed.bag", {TOPIC: malformed})

    got = answers(tmp_path, bag)

    assert [answer["cause"] for answer in got] == ["SEEN", *["UNREADABLE"] * 4, "SEEN"]
    assert got[1]["reason"] == "no field x"
    assert of(got[1:5], "zone", "nearest", "nearest_point", "speed", "total") == [("Danger", None, None, 0.0, 0)] * 4


def test_nothing_in_the_corridor_is_no_distance(tmp_path):
    far_left = wall_at(0.4, 1)
    far_left.points[:, 0] -= 5.0
    bag = write_ros1(tmp_path / "free.bag", {TOPIC: [far_left]})

    assert of(answers(tmp_path, bag), "zone", "cause", "nearest", "inside") == [("Safe", "SEEN", None, 0)]


def test_private_parameters_are_passed_on(tmp_path):
    bag = write_ros1(tmp_path / "drive.bag", {TOPIC: DRIVE})

    drive = answers(tmp_path, bag, "--param", "danger_distance=0.8", "--param", "safe_speed=0.35")

    assert of(drive, "zone", "speed") == [("Safe", 0.35), ("Danger", 0.0), ("Danger", 0.0)]


def test_a_parameter_that_the_node_refuses_ends_the_replay_with_the_nodes_own_words(tmp_path):
    result = replay(write_ros1(tmp_path / "drive.bag", {TOPIC: DRIVE}), "--param", "danger_distnce=0.8")

    assert result.returncode == 2 and result.stderr.splitlines()[-1].endswith("there is no parameter ~danger_distnce; did you mean ~danger_distance?")
    assert "Traceback" not in result.stderr and "\x1b" not in result.stderr


@pytest.mark.parametrize("arguments", [
    ["missing.bag"], ["cut.bag"], ["drive.bag", "--topic", "/nowhere"], ["missing.bag", "drive.bag"],
    ["drive.bag", "--around", "3"], ["drive.bag", "--around", "-1"], ["."],
    ["drive.bag", "--mode", "guard", "--param", "mode=drive"]])
def test_what_cannot_be_replayed_gives_one_line_and_exit_code_2(tmp_path, arguments):
    whole = write_ros1(tmp_path / "drive.bag", {TOPIC: DRIVE})
    (tmp_path / "cut.bag").write_bytes(whole.read_bytes()[:-100])

    result = replay(*(tmp_path / word if word.endswith(".bag") else word for word in arguments))

    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1 and result.stderr.startswith("replay: ")


@pytest.mark.parametrize("arguments", [
    [], ["drive.bag", "--method", "fast"], ["drive.bag", "--json", "/nowhere/a.json"], ["drive.bag", "--param", "x"],
    ["drive.bag", "--plot", "plot.txt"]])
def test_wrong_usage_is_exit_code_2(arguments):
    result = replay(*arguments)

    assert result.returncode == 2 and "Traceback" not in result.stderr


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_an_interrupted_replay_leaves_no_process_behind(tmp_path, number, code):
    bag = write_ros1(tmp_path / "long.bag", {TOPIC: [wall_at(1.0, stamp) for stamp in range(1, 5000)]})
    running = subprocess.Popen([*COMMAND, str(bag)], stderr=subprocess.PIPE, text=True)
    children = eventually(lambda: len(found := children_of(running.pid)) == 2 and found)

    running.send_signal(number)

    assert (running.wait(30), running.stderr.read()) == (code, "")
    assert not [pid for pid in children if Path(f"/proc/{pid}").exists()]


def test_a_node_that_dies_is_named_and_ends_the_replay(tmp_path):
    bag = write_ros1(tmp_path / "long.bag", {TOPIC: [wall_at(1.0, stamp) for stamp in range(1, 5000)]})
    running = subprocess.Popen([*COMMAND, str(bag)], stderr=subprocess.PIPE, text=True)
    children = eventually(lambda: len(found := children_of(running.pid)) == 2 and found)

    os.kill(next(pid for pid in children if "safety_control_node" in Path(f"/proc/{pid}/cmdline").read_text()), 9)

    assert running.wait(60) == 1
    assert "the node ended with exit code -9" in running.stderr.read()


def test_several_sensors_are_each_answered_by_a_node_of_its_own(tmp_path):
    records = [placed(-1.0, (0.1, 0.0, 0.3), (-0.5, 0.5, -0.5, 0.5), static=True)]
    for number in range(6):
        picture = np.full((48, 64), 1600 - 200 * number, np.uint16)
        records += [depth(0.1 * number, picture), camera(0.1 * number, 64, 48, 50.0), wall(0.1 * number + 0.05, 1.4 - 0.2 * number, "/left")]
    bag, topics = write_drive(tmp_path / "two.bag", records), ["/camera/depth/image_rect", "/left"]
    named = ("--topic", topics[1], "--topic", topics[0], "--param", "target_frame=base")

    both = answers(tmp_path, bag, *named, "--plot", tmp_path / "both.png")

    assert [answer["topic"] for answer in both] == topics * 6
    alone = {"target_frame": "base", "source_timeout": 10.0, "stamp_tolerance": 0.0}
    for topic in topics:
        core = rows_of(bag, alone, [topic])
        assert of([answer for answer in both if answer["topic"] == topic], *SAID) == of(core, *SAID) and len(core) == 6
    assert of(both[-1:], "zone", "cause") == [("Danger", "SEEN")] and both[1]["zone"] == "Safe"


def test_the_recorded_kinect_frames_are_in_the_warning_zone(tmp_path):
    frames = sorted((SHARED / "data" / "kinect").glob("frame_2012*.pcd"))
    if not frames:
        pytest.skip(f"no recorded clouds: {SHARED / 'data'} is not there")
    bag = tmp_path / "frames.bag"
    tool = SHARED / "tools" / "pcd2bag.py"
    subprocess.run([sys.executable, tool, bag, "native", "camera", TOPIC, *frames], check=True)

    got = answers(tmp_path, bag)

    assert of(got, "zone", "speed") == [("Warning", 0.1)] * 3
    assert [round(answer["nearest"], 6) for answer in got] == [0.754, 0.752, 0.755]


def children_of(pid: int) -> List[int]:
    """The master and the node; both run in process groups of their own."""
    listing = subprocess.run(["ps", "-o", "pid=", "--ppid", str(pid)], capture_output=True, text=True).stdout
    return [int(child) for child in listing.split()]
