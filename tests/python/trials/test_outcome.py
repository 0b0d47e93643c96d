# SPDX-License-Identifier: BSD-3-Clause
"""What counts as what, on drives made up by hand."""
from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.trials.deciders import Verdict
from safety_control_cloud.trials.outcome import BESIDE_THE_VIEW, SIDE_ENTRY, Hit, Judge, Truth
from safety_control_cloud.trials.scenario import Scenario
from safety_control_cloud.trials.summary import row, rows, to_json
from safety_control_cloud.trials.table import table_of, verdict_of
from safety_control_cloud.trials.things import Path, Thing, post, wall

WALL = Scenario("wall", 0, (wall("wall", 2.0),))
CART = Thing("cart", Pose(), (0.2, 0.2, 1.0), path=Path(((0.0, 1.0, 2.0), (2.0, 1.0, 0.0))))


def moment(time: float, speed: float = 0.2, zone: str = "Safe", free: bool = True, hits=(), clearance: float = 0.5) -> Truth:
    return Truth(time, Pose(), speed, Verdict(zone, speed, "SEEN"), free, clearance, tuple(hits))


def judged(moments, scenario: Scenario = WALL):
    judge = Judge(scenario, "ours")
    for one in moments:
        judge.see(one)
        if judge.is_over:
            break
    return judge.outcome()


def standing(seconds: float, free: bool, zone: str = "Danger"):
    return [moment(i * 0.05, 0.0, zone, free) for i in range(round(seconds / 0.05))]


def test_driving_into_a_wall_is_a_collision():
    outcome = judged([moment(0.0, free=False), moment(0.05, free=False, hits=[Hit(0.04, "wall", 0.2)])])
    assert outcome.collision == Hit(0.04, "wall", 0.2)
    assert outcome.limit == ""


@pytest.mark.parametrize("approach", [0.0, 0.01, -0.2])
def test_being_run_into_is_no_collision_that_the_robot_caused(approach):
    assert judged([moment(0.0), moment(0.05, hits=[Hit(0.04, "cart", approach)])]).collision is None


def test_what_comes_from_the_side_sooner_than_the_robot_can_brake_is_a_limit_of_the_sensor():
    scenario = Scenario("person_crosses", 0, (CART,))
    late = [moment(0.0), moment(0.05), moment(0.1, free=False, hits=[Hit(0.2, "cart", 0.2)])]
    assert judged(late, scenario).limit == SIDE_ENTRY
    early = [moment(0.05 * i, free=False) for i in range(60)] + [moment(3.0, free=False, hits=[Hit(3.0, "cart", 0.2)])]
    assert judged(early, scenario).limit == ""


@pytest.mark.parametrize("shown_at, limit", [(None, BESIDE_THE_VIEW), (0.5, ""), (1.7, BESIDE_THE_VIEW)])
def test_what_comes_from_beside_the_view_was_to_be_seen_only_if_it_was_in_the_picture_in_time(shown_at, limit):
    """A shelf that comes to the robot's shoulder is in the corridor for long, and perhaps never in a picture."""
    shelf = Thing("shelf", Pose(), (0.3, 0.5, 0.05), path=Path(((0.0, 0.05, 1.0), (2.0, 0.05, 0.45))))
    drive = [moment(0.05 * i, free=i < 16) for i in range(40)]
    toward = [replace(one, pose=Pose(yaw=1.57)) if one.time == shown_at else one for one in drive]
    last = moment(2.0, free=False, hits=[Hit(2.0, "shelf", 0.2)])
    assert judged([*toward, last], Scenario("shelf_slides_in", 0, (shelf,))).limit == limit


@pytest.mark.parametrize("x, y, limit", [
    (0.12, 0.24, BESIDE_THE_VIEW),  # it was never in the picture
    (0.25, 0.24, BESIDE_THE_VIEW),  # only its edge was
    (0.3, 0.0, ""),
])
def test_what_stands_beside_the_view_is_a_limit_of_the_sensor(x, y, limit):
    scenario = Scenario("post", 0, (post("post", x, y, 0.05),))
    drive = [moment(0.05 * i, free=False) for i in range(60)]
    assert judged([*drive, moment(3.0, free=False, hits=[Hit(3.0, "post", 0.2)])], scenario).limit == limit


@pytest.mark.parametrize("seconds, limit", [(0.3, BESIDE_THE_VIEW), (1.0, "")])
def test_what_the_robot_is_turned_to_counts_once_there_was_time_to_brake(seconds, limit):
    scenario = Scenario("post", 0, (post("post", 0.3, 0.0, 0.05),))
    away = [replace(moment(0.05 * i), pose=Pose(yaw=1.6)) for i in range(20)]
    toward = [moment(1.0 + 0.05 * i, free=False) for i in range(round(seconds / 0.05))]
    last = moment(1.0 + seconds, free=False, hits=[Hit(1.0 + seconds, "post", 0.2)])
    assert judged([*away, *toward, last], scenario).limit == limit


def test_what_was_only_seen_beside_the_corridor_was_not_shown_in_the_way():
    scenario = Scenario("post", 0, (post("post", 0.12, 0.24, 0.05),))
    beside = [replace(moment(0.05 * i), pose=Pose(yaw=1.1)) for i in range(20)]
    last = moment(3.0, free=False, hits=[Hit(3.0, "post", 0.2)])
    assert judged([*beside, *(moment(1.0 + 0.05 * i, free=False) for i in range(40)), last], scenario).limit


def test_standing_in_danger_before_a_free_corridor_for_two_seconds_is_a_false_stop():
    assert judged(standing(2.2, free=True)).false_stop == 0.0
    assert judged(standing(1.9, free=True)).false_stop is None
    assert judged(standing(3.0, free=False)).false_stop is None


def test_who_stands_to_the_end_though_nothing_is_in_the_way_is_stuck():
    assert judged(standing(4.0, free=True)).stuck
    assert not judged(standing(4.0, free=False)).stuck
    assert not judged([*standing(2.5, free=True), *(moment(2.5 + i * 0.05) for i in range(20))]).stuck


def test_a_drive_is_over_when_the_robot_has_stood_for_long():
    assert judged(standing(16.0, free=False)).seconds < 4.0


def test_clearance_counts_while_the_robot_moves():
    assert judged([moment(0.0, clearance=0.3), moment(0.05, 0.0, clearance=0.01)]).clearance == 0.3
    assert judged(standing(1.0, free=False)).clearance == inf


def test_a_row_counts_collisions_and_limits_apart():
    hit = judged([moment(0.0, free=False), moment(0.05, free=False, hits=[Hit(0.04, "wall", 0.2)])])
    pane = replace(WALL, seed=1, limit="glass")
    limited = judged([moment(0.0), moment(0.05, hits=[Hit(0.04, "wall", 0.2)])], pane)
    free = judged([moment(0.05 * i) for i in range(20)])
    one = row("wall", "ours", [hit, limited, free])
    assert (one.episodes, one.collisions, one.at_limits) == (3, 1, 1)
    assert one.free_speed == pytest.approx(0.2)


def test_the_summary_can_be_shown_and_written():
    hit = judged([moment(0.0, free=False), moment(0.05, hits=[Hit(0.04, "wall", 0.2)])])
    outcomes = [judged(standing(4.0, free=True)), hit]
    assert [one.family for one in rows(outcomes)] == ["wall", "all"]
    assert table_of(outcomes).row_count == 2
    assert verdict_of(outcomes)[0].startswith("ours: 1 collisions, and 0 touches at a limit of the camera, in 2 drives")
    assert '"clearance": null' in to_json(outcomes)
