# SPDX-License-Identifier: BSD-3-Clause
"""Drives by somebody else: what is counted as what, on scenes made up by hand, and a few drives."""
from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from rich.console import Console

from safety_control_cloud.simulation.base import Pose, Velocity
from safety_control_cloud.simulation.hull import BODY_RADIUS, Rectangle
from safety_control_cloud.trials.__main__ import main
from safety_control_cloud.trials.families import DRIVEN, scenario_of
from safety_control_cloud.trials.guarded.drive import guarded_drive
from safety_control_cloud.trials.guarded.drivers import driver_of
from safety_control_cloud.trials.guarded.guards import Passed, TutorialGuard
from safety_control_cloud.trials.guarded.outcome import (
    FORGOTTEN, IN_VIEW, LATE, LEFT, NEVER, Hit, Judge, Moment, law_for)
from safety_control_cloud.trials.guarded.replay import draw_to, replay
from safety_control_cloud.trials.guarded.summary import is_failure, row, to_json
from safety_control_cloud.trials.guarded.table import table_of, verdict_of
from safety_control_cloud.trials.guarded.truth import Ground, Law, from_hull, point_speed
from safety_control_cloud.trials.names import DRIVERS
from safety_control_cloud.trials.options import options
from safety_control_cloud.trials.report import STYLE
from safety_control_cloud.trials.run import Job, drive, jobs_for
from safety_control_cloud.trials.scenario import XTION, Scenario
from safety_control_cloud.trials.things import post, wall

WALL = Scenario("wall", 0, (wall("wall", 1.0),), settings=(("mode", "guard"),))
BOX = Rectangle(-0.3, 0.2, 0.2)
STOPPED = Passed(Velocity(0.3, 0.0), Velocity(), 0.0, "SEEN")


def picture(distance: float) -> np.ndarray:
    """[m] a wall across the upper half of the view, down to the horizon and a little below."""
    depth = np.full((XTION.height, XTION.width), np.nan, np.float32)
    depth[: XTION.height // 2 + 20] = distance
    return depth


def moment(time: float, x: float = 0.0, yaw: float = 0.0, passed: Passed = STOPPED, hits=(), seen: float | None = None) -> Moment:
    return Moment(time, Pose(x, 0.0, yaw), Velocity(0.1), passed, None if seen is None else picture(seen), tuple(hits))


def touched(*moments: Moment):
    judge = Judge(WALL, "ours")
    for one in moments:
        judge.see(one)
    return [touch.kind for touch in judge.outcome().touches]


def hit(time: float, approach: float = 0.1, depth: float = 0.0) -> Hit:
    return Hit(time, "wall", (1.0, 0.0), approach, depth)


@pytest.mark.parametrize("when, kind", [
    ({"seen": 1.087}, IN_VIEW),  # from the camera, 8.7 cm behind the middle
    ({"seen": 2.5}, NEVER),  # something else
    ({"seen": 2.087, "x": -1.0}, FORGOTTEN),  # from farther than 1.5 m
])
def test_a_contact_is_judged_by_when_that_place_returned_something(when, kind):
    assert touched(moment(0.0, **when), moment(3.0, 0.8, hits=[hit(3.0)])) == [kind]


def test_what_lies_beside_the_picture_when_it_is_touched_has_left_the_view():
    assert touched(moment(0.0, seen=1.087), moment(2.9, 0.8, yaw=pi / 2), moment(3.0, 0.8, yaw=pi / 2, hits=[hit(3.0)])) == [LEFT]


def test_what_returned_for_less_time_than_it_takes_to_stop_came_too_late():
    assert touched(moment(0.0, 0.6), moment(2.65, 0.6, seen=0.487), moment(3.0, 0.8, hits=[hit(3.0, 0.3)])) == [LATE]
    assert touched(moment(0.0, 0.6), moment(2.9, 0.6, seen=0.487), moment(3.0, 0.8, hits=[hit(3.0, 0.3)])) == [NEVER]


def test_being_run_into_is_no_contact_of_the_robots_and_pushing_on_is_one():
    assert touched(moment(0.0, seen=1.087), moment(3.0, hits=[hit(3.0, 0.01)])) == []
    pushing = [hit(3.0 + 0.01 * tick) for tick in range(100)]
    assert len(touched(moment(0.0, seen=1.087), moment(4.0, 0.8, hits=pushing))) == 1
    assert len(touched(moment(0.0, seen=1.087), moment(4.0, 0.8, hits=[*pushing, hit(5.0)]))) == 2


def test_who_has_walked_into_a_robot_that_stood_is_not_touched_by_its_leaving():
    walks_in = [hit(2.0 + 0.01 * tick, 0.0, 0.005 * tick) for tick in range(50)]
    leaving = [hit(2.5 + 0.01 * tick, 0.1, 0.25 - 0.005 * tick) for tick in range(50)]
    assert touched(moment(0.0, seen=1.087), moment(4.0, 0.8, hits=[*walks_in, *leaving])) == []
    assert len(touched(moment(0.0, seen=1.087), moment(4.0, 0.8, hits=[*walks_in, *leaving, hit(3.6)]))) == 1
    assert len(touched(moment(0.0, seen=1.087), moment(4.0, 0.8, hits=[hit(1.9, 0.1, 0.02), *walks_in]))) == 1


def test_the_greatest_safe_factor_is_that_of_stopping_before_the_wall():
    ground, law = Ground(WALL), Law(0.2, 0.05)
    way = 1.0 - BODY_RADIUS - 0.05
    at = [ground.greatest_factor(Velocity(speed), Pose(), 0.0, law) for speed in (0.2, 0.7)]
    assert at[0] == 1.0
    assert 0.7 * at[1] * 0.2 + (0.7 * at[1]) ** 2 / 0.72 == pytest.approx(way, abs=0.01)
    assert ground.greatest_factor(Velocity(-0.7), Pose(), 0.0, law) == 1.0
    assert ground.greatest_factor(Velocity(), Pose(), 0.0, law) is None
    assert ground.greatest_factor(Velocity(0.1), Pose(x=0.8), 0.0, law) is None, "within the margin"
    assert ground.greatest_factor(Velocity(0.7), Pose(yaw=pi / 2), 0.0, law) == 1.0, "along it"


def test_what_the_guard_is_told_may_approach_may_do_so_until_the_robot_stands():
    told = replace(WALL, settings=(("obstacle_speed", 0.3),))
    assert (law_for(WALL).approach, law_for(told).approach) == (0.0, 0.3)
    ground, wanted = Ground(told), Velocity(0.7)
    factor, braking = ground.greatest_factor(wanted, Pose(), 0.0, law_for(told)), 0.7 / 0.36
    driven = 0.7 * (factor * 0.2 + factor ** 2 * braking / 2)
    assert driven + 0.3 * (0.2 + factor * braking) == pytest.approx(1.0 - BODY_RADIUS - 0.05, abs=0.01)
    assert factor < ground.greatest_factor(wanted, Pose(), 0.0, law_for(WALL)) - 0.1
    assert ground.greatest_factor(Velocity(-0.7), Pose(x=0.2), 0.0, law_for(told)) < 1.0, "it comes from behind too"
    assert ground.greatest_factor(wanted, Pose(x=0.76), 0.0, law_for(told)) == 0.0, "nothing keeps it away"


def test_a_rectangle_that_turns_sweeps_what_a_circle_does_not():
    beside = Scenario("post", 0, (post("post", -0.28, 0.3, 0.06),), hull=BOX)
    assert Ground(beside).greatest_factor(Velocity(0.0, -2.0), Pose(), 0.0, law_for(beside)) < 1.0
    assert Ground(replace(beside, hull=None)).greatest_factor(Velocity(0.0, -2.0), Pose(), 0.0, law_for(beside)) == 1.0


def test_distances_from_a_hull_and_the_speed_of_its_points():
    points = np.array([(0.5, 0.0), (0.0, -0.5), (-0.05, 0.0), (0.5, 0.6)])
    assert from_hull(BOX, points) == pytest.approx([0.3, 0.3, -0.2, 0.5])
    assert point_speed(Velocity(0.2, 1.0), Pose(), (0.2, 0.2), (0.0, 1.0)) == pytest.approx(0.2)
    assert point_speed(Velocity(-0.2, 0.0), Pose(yaw=pi), (1.0, 0.0), (2.0, 0.0)) == pytest.approx(0.2)
    for normal in ((1.0, 0.0), (-1.0, 0.0)):
        assert point_speed(Velocity(-0.05), Pose(), (0.12, 0.04), normal) == pytest.approx(-0.05), "it backs away from who walks into it"


@pytest.mark.parametrize("driver, family", [(driver, family) for driver in DRIVEN for family in DRIVEN[driver]])
def test_a_seed_draws_one_scene_in_which_nothing_touches_the_robot_yet(driver, family):
    assert DRIVERS[driver] == tuple(DRIVEN[driver])
    for seed in range(20):
        scenario = scenario_of(family, seed)
        assert scenario == scenario_of(family, seed)
        assert len({thing.name for thing in scenario.things}) == len(scenario.things)
        wish = Velocity(0.01, 3.0)
        assert Ground(scenario).greatest_factor(wish, scenario.start, 0.0, Law(0.0, 0.0)) is not None
        assert bool(scenario.route) == (driver == "polite")


def test_the_rude_driver_goes_forward_backward_and_turns():
    driver = driver_of(scenario_of("rude_boxes", 3))
    wishes = [driver.wants(0.05 * i, Pose(), Velocity(0.1)) for i in range(2000)]
    speeds, turns = [one.linear for one in wishes], [one.angular for one in wishes]
    assert min(speeds) < -0.3 and max(speeds) > 0.3 and min(turns) < -1 and max(turns) > 1
    assert any(abs(one.linear) < 1e-9 and abs(one.angular) > 0.3 for one in wishes)


def test_the_tutorial_guards_forward_motion_alone():
    guard = TutorialGuard(WALL)
    guard.see(picture(0.7), 0.0, 0.0)
    for wanted, factor in ((Velocity(0.4, 1.0), 0.25), (Velocity(0.1), 1.0), (Velocity(-0.5, 2.0), 1.0)):
        guard.want(wanted, 0.0)
        assert guard.answer(0.0).factor == pytest.approx(factor)
        assert guard.answer(0.0).is_whole == (factor == 1.0)


def test_a_polite_driver_goes_through_a_doorway_as_without_a_guard():
    outcome = drive(Job("polite_doorway", 2, "ours", "polite"))
    assert not is_failure(outcome) and outcome.touches == () and outcome.time_lost < 0.1


def test_a_rude_driver_runs_into_nothing_in_view_and_into_things_without_a_guard():
    scenario = replace(scenario_of("rude_posts", 1), seconds=4.0)
    ours, alone = (guarded_drive(scenario, method) for method in ("ours", "nobody"))
    assert not is_failure(ours)
    assert alone.touches != ()
    assert guarded_drive(scenario, "ours") == ours
    one = row("rude_posts", "ours", [ours])
    assert one.drives == 1 and sum(one.touches.values()) == len(ours.touches) and 0 < one.share <= 1
    assert '"family": "all"' in to_json([ours, alone])
    assert table_of([ours]).row_count == 2
    assert verdict_of([ours])[0].startswith("ours: in 1 drives, contacts while moving with what was 0 in view")
    told = verdict_of([replace(ours, shares=(0.5, 1.0), odometry=True), replace(ours, shares=(0.25,), odometry=False)])[1]
    assert told == "  given / safe: 0.75 with odometry (1 drives), 0.25 without (1 drives)"


def test_the_command_writes_a_table_a_page_and_numbers(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("sys.argv", ["trials", "--driver", "polite", "--family", "polite_passage", "--episodes", "1", "--method",
                                     "ours", "--jobs", "1", "--json", str(tmp_path / "a.json"), "--report", str(tmp_path / "page")])
    assert main() == 0
    assert "polite_passage" in capsys.readouterr().out
    assert '"time_lost"' in (tmp_path / "a.json").read_text()
    page = (tmp_path / "page" / "index.html").read_text()
    assert "A polite driver" in page and STYLE in page


def test_a_drive_is_told_and_drawn(tmp_path):
    console = Console(record=True, width=160)
    replay("polite_passage", 2, ["ours"], console)
    told = console.export_text()
    assert "polite_passage:2" in told and "arrived" in told
    draw_to(tmp_path / "a.png", replace(scenario_of("rude_people", 1), seconds=2.0), "ours")
    assert (tmp_path / "a.png").stat().st_size > 20_000


def test_the_episodes_of_a_driver_are_shared_out_among_his_families():
    jobs = jobs_for(7, 1, ["ours"], driver="rude")
    assert [job.family for job in jobs] == list(DRIVERS["rude"]) and {job.driver for job in jobs} == {"rude"}


@pytest.mark.parametrize("arguments", [
    ["--driver", "drunk"], ["--driver", "rude", "--family", "wall"], ["--family", "rude_boxes"], ["--replay", "rude_boxes:1"],
    ["--driver", "polite", "--replay", "rude_boxes:1"], ["--driver", "rude", "--replay", "rude_boxes:1", "--video", "a.gif"]])
def test_what_no_driver_drives_is_refused(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        options(arguments)
    assert ended.value.code == 2
    assert "usage" in capsys.readouterr().err
