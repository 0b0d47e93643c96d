# SPDX-License-Identifier: BSD-3-Clause
"""What mode guard cannot judge of a bag: a bag that has not what it needs, stamps of another clock, damaged definitions."""
from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from drives import SECOND, header, write_drive, write_drive2, write_mcap
from guard_answers import SENSORS
from guard_drives import BASE, LASER_ALONE, commanded, hall_with_wall, laser_placed, scan
from judge_rows import judged, rows_in

from safety_control_cloud.judge.bag import Job, judge_bag
from safety_control_cloud.replay.bags import OPENS_FILES

GUARD = {"mode": "guard"}
UNUSABLE = {
    "no commands": ([record for record in LASER_ALONE if record.topic != "/cmd_vel"], {}, "no geometry_msgs/Twist"),
    "two topics of them": ([*LASER_ALONE, commanded(0.5, 0.1, topic="/base/cmd_vel")], {}, "say which by --cmd-vel"),
    "no sensor": ([record for record in LASER_ALONE if record.topic != "/scan"], {}, "no LaserScan"),
    "no place": ([record for record in LASER_ALONE if record.source != "/laser_place"], {}, "no transform in the bag leads"),
    "another clock": ([record if record.topic != "/scan" else scan(record.time / SECOND, hall_with_wall(3.0, 1), age=3600.0)
                       for record in LASER_ALONE], {}, "are of another clock"),
    "another sensor": (LASER_ALONE, {"sensors": SENSORS}, "no cloud on /camera/depth/points"),
    "nothing": ([], {}, "no geometry_msgs/Twist"),
}


@pytest.mark.parametrize("case", UNUSABLE)
def test_a_bag_that_cannot_be_guarded_has_a_row_that_says_why(tmp_path, case):
    records, settings, words = UNUSABLE[case]

    (row,) = judged(write_drive(tmp_path / "drive.bag", records), {**GUARD, **settings}).rows

    assert row.status == "error" and words in row.error and "\n" not in row.error


def test_what_one_of_two_guards_cannot_be_given_costs_the_other_nothing(tmp_path):
    bag = write_drive(tmp_path / "drive.bag", LASER_ALONE)

    both = judge_bag(Job(str(bag), ({**GUARD, "base_frame": "elsewhere"}, {**GUARD, "sensors": SENSORS}, GUARD)))

    assert [row.status for row in both.rows] == ["error", "error", "judged"]
    alone = rows_in(judged(bag, GUARD).files[0])
    assert rows_in(both.files[2]) == alone


FAR = 2**31 - 1.6e9  # [s] after START, where tf2_py's stamps end


@pytest.mark.parametrize("age, cause", [(1.6e9 + 5.0, "STALE"), (2.2 - FAR, "FUTURE"), (1.1 - FAR, "FUTURE")])
@pytest.mark.parametrize("tolerance", [0.2, 0.0])
def test_a_stamp_from_before_1970_or_after_2038_is_one_of_another_clock(tmp_path, age, cause, tolerance):
    records = [record if record.topic != "/scan" else scan(record.time / SECOND, hall_with_wall(3.0, record.time), age=age)
               for record in LASER_ALONE]

    answer = judged(write_drive2(tmp_path / "odd", records), {**GUARD, "stamp_tolerance": tolerance})

    causes = {row["cause"] for row in rows_in(answer.files[0])} - {"NO_CLOUD"}
    assert causes == ({cause} if tolerance else {"SEEN"}) and answer.rows[0].status == ("error" if tolerance else "judged")


def test_the_last_stamp_of_all_does_not_end_the_process(tmp_path):
    def last(record: Any) -> Any:
        def make(store: Any) -> Any:
            message = record.make(store)
            message.header.stamp.sec, message.header.stamp.nanosec = 2**31 - 1, 999_999_999
            return message
        return replace(record, make=make)

    records = [last(record) if record.topic == "/scan" else record for record in LASER_ALONE]

    answer = judged(write_drive2(tmp_path / "last", records), GUARD)

    assert rows_in(answer.files[0])[-1]["cause"] == "FUTURE" and "547483646.9" in answer.rows[0].error


@pytest.mark.parametrize("topic, field", [
    ("/scan", b"angle_min"), ("/odom", b"pose"), ("/odom", b"linear"), ("/tf_static", b"header"), ("/tf_static", b"transforms")])
def test_a_message_whose_definition_is_damaged_costs_its_bag_alone(tmp_path, topic, field):
    bag = write_mcap(tmp_path / "drive", LASER_ALONE)  # a ROS 1 bag has a checksum of it
    (file,) = bag.glob("*.mcap")
    words = b" " + field + b"\n"
    file.write_bytes(file.read_bytes().replace(words, words.replace(field[:1], b"x", 1)))

    (row,) = judged(file if OPENS_FILES else bag, GUARD).rows  # where a file is opened, the folder has a checksum too

    assert row.status == "error" and f"cannot read a message of {topic} of" in row.error


@pytest.mark.parametrize("time", [-1.6e9 - 5.0, FAR - 0.5])
def test_a_transform_of_such_a_time_is_none_unless_nothing_moves(tmp_path, time):
    still = [record for record in LASER_ALONE if record.source != "/laser_place"]
    turning = laser_placed()
    moving = replace(turning, topic="/tf", make=stamped_at(turning, time))
    static = replace(turning, make=stamped_at(turning, time))

    one, other = (judged(write_drive2(tmp_path / name, [*still, record]), GUARD).rows[0]
                  for name, record in (("moving", moving), ("static", static)))

    assert one.status == "error" and "no transform in the bag leads from laser" in one.error
    assert (other.status, other.passed) == ("judged", 19)


def stamped_at(record: Any, time: float) -> Any:
    def make(store: Any) -> Any:
        message = record.make(store)
        message.transforms[0].header = header(store, time, BASE)
        return message
    return make
