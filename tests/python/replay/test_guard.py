# SPDX-License-Identifier: BSD-3-Clause
"""replay --mode guard: recorded commands beside what the guard would have given of them."""
from __future__ import annotations

import json
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List

import numpy as np
import pytest
from drives import SECOND, START, camera, depth, wall, write_drive, write_drive2
from guard_drives import SPEED, camera_placed, commanded, driven_at_wall, hall_with_wall, laser_placed, odometry, scan, wall_and_floor
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import StoragePlugin

from safety_control_cloud import core
from safety_control_cloud.replay.bags import BagError
from safety_control_cloud.replay.options import request_of
from safety_control_cloud.replay.parameters import BadSettings, parameters_in, settings_of
from safety_control_cloud.replay.replay import replay as replay_in_process

LIVE = Path(__file__).with_name("live_guard.py")
BOTH = ("camera", "laser")
SENSORS = [{"name": "camera_depth_points", "type": "cloud", "topic": "/camera/depth/points"},
           {"name": "scan", "type": "scan", "topic": "/scan"}]


def replay(*arguments: Any) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "safety_control_cloud.replay", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def told(folder: Path, *arguments: Any) -> List[Dict[str, Any]]:
    """Every answer; in this process, which takes no second."""
    file = folder / "guarded.json"
    replay_in_process(request_of([*map(str, arguments), "--mode", "guard", "--json", str(file)]))
    return json.loads(file.read_text())


def to_commands(answers: List[Dict[str, Any]]) -> List[Dict[str, Any]]:
    return [answer for answer in answers if answer["asked_by"] == "command"]


def numbers(twist: Dict[str, List[float]]) -> List[float]:
    return [*twist["linear"], *twist["angular"]]


def bits(values: List[float]) -> bytes:
    return struct.pack("6d", *values)


def write_mcap(path: Path, records: List[Any]) -> Path:
    return write_drive2(path, records, StoragePlugin.MCAP)


@pytest.mark.parametrize("write, name", [(write_drive, "drive.bag"), (write_drive2, "drive"), (write_mcap, "drive")])
def test_a_laser_scales_and_stops_who_drives_at_a_wall_from_every_kind_of_bag(tmp_path, write, name):
    answers = to_commands(told(tmp_path, write(tmp_path / name, driven_at_wall(sensors=["laser"]))))

    moving = [answer for answer in answers if answer["wanted"]["linear"][0] > 0]
    factors = [answer["factor"] for answer in moving]
    assert factors[0] == 1.0 and factors[-1] == 0.0 and any(0.0 < factor < 1.0 for factor in factors)
    for answer in moving:
        assert answer["differs"] == (answer["given"] != answer["wanted"]) == (answer["factor"] < 1.0)
        assert answer["given"]["linear"][0] == pytest.approx(SPEED * answer["factor"])
    last = moving[-1]
    assert (last["cause"], last["sensor"], last["stuck"], last["driven"]) == ("SEEN", "scan", True, [SPEED, 0.0, 0.0])
    assert last["point"][0] == pytest.approx(0.9 - (last["time"] - START / 1e9 - 0.6) * SPEED, abs=0.03)


def by_hand(bag: Path) -> List[core.Guarded]:
    """What a GuardControl says to each command, of a camera whose place is known."""
    place = np.array([[0, 0, 1, -0.087], [-1, 0, 0, 0], [0, -1, 0, 0.2972]], np.float64)
    control, said = core.GuardControl(core.Settings(mode="guard")), []
    with AnyReader([bag]) as reader:
        start = None
        for connection, time, raw in reader.messages():
            message = reader.deserialize(raw, connection.msgtype)
            start = time if start is None else start
            now, ros = (time - start) / 1e9, time // SECOND + 1e-9 * (time % SECOND)
            if connection.topic == "/camera/depth/points":
                fields = [(field.name, field.offset, field.datatype, field.count) for field in message.fields]
                cloud = core.Cloud.of_bytes(message.data.tobytes(), message.height, message.width, fields, False, 12, message.row_step)
                control.see(cloud, now, seconds(message), ros, place, "/camera", message.header.frame_id)
                control.answer(now, ros)
            elif connection.topic == "/odom":
                control.note_odometry(seconds(message), (message.pose.pose.position.x, 0.0, 0.0), (message.twist.twist.linear.x, 0.0, 0.0))
            elif connection.topic == "/cmd_vel":
                control.want((message.linear.x, 0.0, 0.0), (0.0, 0.0, message.angular.z), now, None, ros)
                said.append(control.answer(now, ros))
    return said


def seconds(message: Any) -> float:
    return message.header.stamp.sec + 1e-9 * message.header.stamp.nanosec


def test_every_answer_is_the_cores_in_every_bit(tmp_path):
    bag = write_drive(tmp_path / "drive.bag", driven_at_wall(every=0.04))  # often enough that no answer is due between

    answers, core_said = to_commands(told(tmp_path, bag)), by_hand(bag)

    assert len(answers) == len(core_said) == 75
    for answer, said in zip(answers, core_said):
        assert bits(numbers(answer["given"])) == bits([*said.given.linear, *said.given.angular])
        assert (answer["factor"], answer["cause"], answer["sensor"]) == (said.factor, said.cause.name, said.sensor)
    assert {0.0, 1.0} < {answer["factor"] for answer in answers}


@pytest.mark.slow
def test_the_live_node_gives_the_same(tmp_path):
    records = driven_at_wall(sensors=BOTH, topic="/wanted")
    bag = write_drive(tmp_path / "drive.bag", records)
    settings = {"mode": "guard", "sensors": SENSORS}

    replayed = to_commands(told(tmp_path, bag, "--cmd-vel", "wanted"))
    result = subprocess.run([sys.executable, LIVE, bag, json.dumps(settings)], capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stderr

    live: Dict[bytes, List[Any]] = {}
    for state in json.loads(result.stdout.splitlines()[-1]):
        live.setdefault(bits(state[3]), state)  # the first answer to a command: no two are equal
    equal = 0
    for answer in replayed:
        cause, factor, sensor, _, given = live[bits(numbers(answer["wanted"]))]
        assert (answer["cause"], answer["sensor"]) == (cause, sensor)
        assert answer["factor"] == pytest.approx(factor, abs=0.02)  # of its own clock, which the bag's is not in every bit
        equal += bits(numbers(answer["given"])) == bits(given)
    assert len(replayed) == 60 and equal >= 50
    assert {0.0, 1.0} < {answer["factor"] for answer in replayed}


def test_the_table_tells_where_wanted_and_given_differ_first_and_the_plot_is_drawn(tmp_path):
    bag = write_drive(tmp_path / "drive.bag", driven_at_wall())

    result = replay(bag, "--param", "mode=guard", "--plot", tmp_path / "guard.png")

    assert (result.returncode, result.stderr) == (0, "")
    rows = [line.split() for line in result.stdout.splitlines() if line[:1].isdigit() and "commands" not in line]
    assert rows[0][6:9] == ["-", "0.00", "NO_CLOUD,"]  # odometry has not come yet
    assert rows[1][8:10] == ["1.00", "SEEN"] and rows[-1][8:11] == ["0.00", "SEEN,", "cloud:"]
    first = next(row for row in rows[1:] if 0 < float(row[8]) < 1)
    assert first[2:4] == ["0.300", "+0.004"] and 0 < float(first[4]) < 0.3 and first[6] == "0.300"
    assert f"differs first at {first[0]} s: 0.300 +0.004 wanted, {first[4]} {first[5]} given, SEEN by cloud" in result.stdout
    assert "60 commands: " in result.stdout and (tmp_path / "guard.png").read_bytes().startswith(b"\x89PNG")


def test_a_free_way_is_given_as_it_is_wanted(tmp_path):
    records = driven_at_wall(gap=4.0)

    answers = to_commands(told(tmp_path, write_drive(tmp_path / "free.bag", records)))

    assert all(bits(numbers(answer["given"])) == bits(numbers(answer["wanted"])) for answer in answers[1:])
    assert "what was wanted is what the guard gives" in replay(tmp_path / "free.bag", "--mode", "guard").stdout


def test_silences_count_by_the_bags_time(tmp_path):
    records = [record for record in driven_at_wall(gap=4.0, sensors=["laser"])
               if not (record.topic == "/cmd_vel" and 1.0 * SECOND < record.time < 2.0 * SECOND)
               and not (record.topic == "/scan" and record.time > 2.2 * SECOND)]

    answers = told(tmp_path, write_drive(tmp_path / "gaps.bag", records))

    causes = {cause: min(answer["time"] for answer in answers if answer["cause"] == cause) - START / 1e9
              for cause in {answer["cause"] for answer in answers if answer["time"] - START / 1e9 > 0.2}}
    last_command = max(record.time for record in records if record.topic == "/cmd_vel" and record.time < 1.5 * SECOND) / SECOND
    last_scan = max(record.time for record in records if record.topic == "/scan") / SECOND
    defaults = core.Settings()
    assert causes["NO_COMMAND"] == pytest.approx(last_command + defaults.command_timeout, abs=0.06)
    assert causes["SILENT"] == pytest.approx(last_scan + defaults.source_timeout, abs=0.06)
    assert answers[-1]["cause"] == "SILENT" and max(answer["time"] for answer in answers) - START / 1e9 > 2.9


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
    records = [record for record in driven_at_wall(sensors=BOTH) if record.source != "/laser_place"]
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


def test_the_moment_of_the_first_difference_is_that_of_the_first_command_that_is_not_given(tmp_path):
    records = [laser_placed(), *(scan(0.1 * n, []) for n in range(10)), *(commanded(0.1 * n + 0.05, 0.3 * (n > 4)) for n in range(10))]

    result = replay(write_drive(tmp_path / "drive.bag", records), "--mode", "guard")

    assert "10 commands: 5 pass, 0 scaled, 5 stopped" in result.stdout
    assert "differs first at 0.550 s: 0.300 +0.000 wanted, 0.000 +0.000 given, UNREADABLE by scan; for 0.4 s" in result.stdout


def test_a_stamped_command_is_as_old_as_it_was(tmp_path):
    records = [record for record in driven_at_wall(gap=4.0) if record.topic != "/cmd_vel"]
    records += [commanded(0.1 * n + 0.05, 0.2, stamp=0.1 * n + 0.04 - 2.0 * (n > 15)) for n in range(2, 29)]

    answers = to_commands(told(tmp_path, write_drive2(tmp_path / "stamped", records)))

    assert [answer["cause"] for answer in answers] == ["SEEN"] * 14 + ["BAD_COMMAND"] * 13


def test_a_scan_that_contradicts_itself_is_told_as_the_node_does(tmp_path):
    records = [laser_placed(), *(commanded(0.1 * n + 0.05, 0.2) for n in range(10))]
    records += [scan(0.1 * n, hall_with_wall(3.0, n), **({"range_min": 10.0, "range_max": 0.1} if n > 4 else {})) for n in range(10)]

    answers = to_commands(told(tmp_path, write_drive(tmp_path / "broken.bag", records)))

    assert [answer["cause"] for answer in answers] == ["SEEN"] * 5 + ["UNREADABLE"] * 5
    assert answers[-1]["reason"] == "range_min 10 and range_max 0.1"


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


def test_the_judge_leaves_the_guard_to_replay(tmp_path):
    command = [sys.executable, "-m", "safety_control_cloud.judge", tmp_path / "drive.bag", "--out", tmp_path / "judged", "--param", "mode=guard"]

    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=60)

    assert result.returncode == 2 and "a guard is asked about one bag, by scripts/replay --mode guard" in result.stderr


def test_help_tells_of_the_guard():
    words = " ".join(replay("--help").stdout.split())
    assert "--mode guard: the guard's own decision in the bag's own time" in words and "--cmd-vel T" in words
