# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.trials.camera_faults import CameraFaults, Spell
from safety_control_cloud.trials.scenario import Scenario
from safety_control_cloud.trials.stage import Stage
from safety_control_cloud.trials.things import Path, Surface, Thing, post, wall

CAMERA_X = -0.087  # [m] in the world while the robot stands at its start


@pytest.fixture
def staged():
    stages = []

    def stage(*things: Thing) -> Stage:
        stages.append(Stage(Scenario("test", 0, things)))
        return stages[-1]

    yield stage
    for one in stages:
        one.close()


def test_a_path_leads_from_waypoint_to_waypoint_and_rests_at_both_ends():
    path = Path(((1.0, 0.0, 0.0), (3.0, 2.0, 0.0), (4.0, 2.0, 1.0)))
    assert [path.at(time) for time in (0.0, 2.0, 3.5, 9.0)] == [(0.0, 0.0), (1.0, 0.0), (2.0, 0.5), (2.0, 1.0)]


def test_a_foot_swings_about_its_path_and_ends_where_it_ends():
    path = Path(((0.0, 0.0, 0.0), (2.0, 2.0, 0.0)), stride=0.15)
    times = np.arange(0.0, 2.0, 0.01)
    swings = [path.at(time)[0] - time for time in times]
    assert 0.1 < max(swings) <= 0.15
    assert path.at(2.0) == (2.0, 0.0)
    assert max(abs(np.diff(swings))) < 0.03, "it does not jump"


def test_the_feet_come_together_where_who_walks_stands_for_a_while():
    ways = ((0.0, 0.0, 0.0), (2.0, 2.0, 0.0), (3.0, 2.0, 0.0), (5.0, 2.0, 2.0))
    feet = [Path(ways, stride=0.15, phase=phase) for phase in (0.0, np.pi)]
    for path in feet:
        assert {path.at(time) for time in np.arange(2.0, 3.0, 0.1)} == {(2.0, 0.0)}
        assert {path.at(time)[1] for time in np.arange(0.0, 2.0, 0.1)} == {0.0}, "they swing to where he goes"
    assert abs(feet[0].at(4.1)[1] - feet[1].at(4.1)[1]) > 0.05


@pytest.mark.parametrize("yaw", [0.0, 0.5, -1.0])
def test_a_wall_has_its_front_where_it_was_asked_for(yaw, staged):
    stage = staged(wall("wall", 0.6 * np.cos(yaw), 0.6 * np.sin(yaw), yaw))
    assert stage.clearance() == pytest.approx(0.6 - 0.178, abs=1e-3)


@pytest.mark.parametrize("x, y, free", [(1.0, 0.0, False), (1.3, 0.0, True), (0.8, 0.45, True), (0.8, 0.33, False)])
def test_the_truth_about_the_corridor_comes_from_where_things_are(x, y, free, staged):
    assert staged(post("post", x, y, 0.05)).corridor_is_free() is free


def test_the_truth_about_the_corridor_turns_with_the_robot(staged):
    stage = staged(post("post", 0.0, 0.8, 0.05))
    assert stage.corridor_is_free()
    stage.robot.place(Pose(yaw=np.pi / 2))
    assert not stage.corridor_is_free()


def test_glass_shows_what_is_behind_it(staged):
    depth = staged(wall("pane", 1.0, surface=Surface.GLASS), wall("behind", 2.0)).picture()
    assert depth[100, 160] == pytest.approx(2.0 - CAMERA_X, abs=0.05)


def test_a_black_thing_returns_nothing_and_hides_what_is_behind_it(staged):
    depth = staged(wall("black", 1.0, length=0.4, surface=Surface.BLACK), wall("behind", 2.0)).picture()
    assert np.isnan(depth[100, 160])
    assert depth[100, 20] == pytest.approx(2.0 - CAMERA_X, abs=0.05)


def test_glass_and_black_things_are_in_the_way_all_the_same(staged):
    for surface in Surface:
        assert not staged(wall("wall", 0.9, surface=surface)).corridor_is_free()


def test_speckle_changes_its_share_of_the_pixels():
    depth = np.full((240, 320), 2.0, np.float32)
    marred = CameraFaults(speckle=0.01).marred(depth, np.random.default_rng(1))
    assert (marred != depth).mean() == pytest.approx(0.01, rel=0.2)


def test_flying_pixels_lie_between_the_two_sides_of_an_edge():
    depth = np.full((240, 320), 3.0, np.float32)
    depth[:, :160] = 1.0
    marred = CameraFaults(flying=0.5).marred(depth, np.random.default_rng(1))
    rows, columns = np.nonzero(marred != depth)
    assert set(columns) == {159} and 80 < len(rows) < 160
    assert ((marred >= 1.0) & (marred <= 3.0)).all()


def test_a_fault_that_passes_is_over_when_its_last_spell_ends():
    assert CameraFaults(dropouts=(Spell(1.0, 2.0), Spell(0.0, 0.5))).over_at == 3.0
