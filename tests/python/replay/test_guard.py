# SPDX-License-Identifier: BSD-3-Clause
"""replay --mode guard: recorded commands beside what the guard would have given of them."""
from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List

import numpy as np
import pytest
from drives import SECOND, START, write_drive, write_drive2
from guard_answers import SENSORS, bits, numbers, replay, to_commands, told
from guard_drives import SPEED, commanded, driven_at_wall, hall_with_wall, laser_placed, scan
from ros2_bags import MCAP
from rosbags.highlevel import AnyReader

from safety_control_cloud import core

LIVE = Path(__file__).with_name("live_guard.py")
FEW = 2  # of 60 commands, where a millisecond decides between a little and nothing


def write_mcap(path: Path, records: List[Any]) -> Path:
    return write_drive2(path, records, MCAP)


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


def said_live(bag: Path) -> Dict[bytes, List[Any]]:
    """The live node's first answer to each command, by the command: no two are equal."""
    settings = {"mode": "guard", "sensors": SENSORS}
    result = subprocess.run([sys.executable, LIVE, bag, json.dumps(settings)], capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stderr
    live: Dict[bytes, List[Any]] = {}
    for state in json.loads(result.stdout.splitlines()[-1]):
        live.setdefault(bits(state[3]), state)
    return live


def otherwise_live(answer: Dict[str, Any], live: Dict[bytes, List[Any]]) -> bool:
    """The live node goes by its machine's clock too, which is not the bag's in every bit."""
    cause, factor, sensor, _, _ = live.get(bits(numbers(answer["wanted"])), ["", 0.0, "", [], []])
    return (answer["cause"], answer["sensor"]) != (cause, sensor) or abs(answer["factor"] - factor) > 0.02


@pytest.mark.slow
def test_the_live_node_gives_the_same(tmp_path):
    bag = write_drive(tmp_path / "drive.bag", driven_at_wall(sensors=("camera", "laser"), topic="/wanted"))

    replayed = to_commands(told(tmp_path, bag, "--cmd-vel", "wanted"))
    for _ in range(3):  # a machine that is busy for a moment hands the node a message late
        live = said_live(bag)
        others = [answer for answer in replayed if otherwise_live(answer, live)]
        if len(others) <= FEW:
            break

    assert len(replayed) == 60 and len(others) <= FEW, others
    equal = [bits(numbers(answer["given"])) == bits(live[bits(numbers(answer["wanted"]))][4]) for answer in replayed]
    assert sum(equal) >= 50
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
    assert "59 commands: " in result.stdout and "1 before the first picture" in result.stdout
    assert (tmp_path / "guard.png").read_bytes().startswith(b"\x89PNG")


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
