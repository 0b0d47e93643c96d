# SPDX-License-Identifier: BSD-3-Clause
"""The parts of same_drives that need no Gazebo; the drives themselves are the step gazebo's."""
from __future__ import annotations

import subprocess
import sys
from math import isnan, nan
from pathlib import Path

import driven_in_mujoco
import numpy as np
import pytest
from drawn_drives import EDGE, FAMILIES, drawn, is_clear_of_the_edge, scene_of, without_faults
from drives_told import is_well, to_json
from driven import Driven, Moment, Pair
from two_simulators import assert_same_shapes, shapes_in_gazebo, shapes_in_mujoco

from safety_control_cloud.simulation.base import DRIVER, Pose
from safety_control_cloud.simulation.furniture import Furniture
from safety_control_cloud.simulation.sdf import to_world
from safety_control_cloud.trials.camera_faults import CameraFaults
from safety_control_cloud.trials.families.draft import CORRIDOR
from safety_control_cloud.trials.scenario import Scenario
from safety_control_cloud.trials.stage import Stage
from safety_control_cloud.trials.things import Surface, post, wall

PICTURE = np.ones((2, 2), np.float32)


def driven(x=1.0, latency=0.0, clearance=0.2, speed=0.1, picture=PICTURE):
    """Drives at `speed` [m/s], sees at 1 s that it must stand, and brakes `latency` [s] later; ends at `x` [m]."""
    braked = speed * latency + speed**2 / (2 * DRIVER.deceleration)
    moving = tuple(Moment(time, Pose(x - braked + speed * (time - 1.0)), speed) for time in (0.9, 1.0))
    return Driven((*moving, Moment(6.0, Pose(x), 0.0)), clearance, "SEEN", 1.0, picture, picture)


def pair(mujoco, gazebo):
    return Pair(Scenario("wall", 1, ()), mujoco, gazebo)


@pytest.mark.parametrize("tag", ["collision", "visual"])
@pytest.mark.parametrize("scenario", drawn(len(FAMILIES), 1), ids=lambda scenario: scenario.family)
def test_gazebos_scene_has_the_shapes_of_the_trials(scenario, tag):
    gazebos = shapes_in_gazebo(to_world(Furniture(Pose(), (scene_of(scenario),)), "file:///robot"), tag)
    stage = Stage(scenario)
    mujocos = shapes_in_mujoco(stage.robot.world)
    stage.close()
    assert_same_shapes(gazebos, {thing.name: mujocos[thing.name] for thing in scenario.things})


def test_no_drive_needs_a_person_or_a_fault_or_has_something_at_the_corridors_edge():
    scenarios = drawn(60, 7)
    assert len({scenario.name for scenario in scenarios}) == 60
    for scenario in scenarios:
        assert scenario.faults == CameraFaults() and scenario.stray == 0.0 and not scenario.turns
        assert all(thing.path is None and thing.surface is Surface.PLAIN for thing in scenario.things)
        assert is_clear_of_the_edge(scenario)


@pytest.mark.parametrize("edge", CORRIDOR)
@pytest.mark.parametrize("side", [-1, 1])
def test_what_ends_at_the_corridors_edge_is_not_drawn(edge, side):
    def ends_beyond(reach):
        return Scenario("post", 1, (post("post", 1.0, edge + side * (reach + 0.02), 0.04),))

    assert is_clear_of_the_edge(ends_beyond(EDGE + 0.001)) and not is_clear_of_the_edge(ends_beyond(EDGE - 0.001))
    assert not is_clear_of_the_edge(Scenario("wall", 1, (wall("wall", 1.0, edge + side * (1.0 + EDGE / 2), length=2.0),)))


def test_the_latency_is_what_the_driver_s_braking_leaves_of_the_way():
    assert driven(latency=0.07).latency == pytest.approx(0.07)
    assert isnan(Driven(driven().track, 0.2, "SEEN", nan, PICTURE, PICTURE).latency)


def test_mujocos_robot_drives_with_the_latency_that_it_is_given():
    (scenario,) = (without_faults(Scenario("wall", 1, (wall("wall", 1.0),))),)
    quick, slow = driven_in_mujoco.drive(scenario, 0.02), driven_in_mujoco.drive(scenario, 0.27)
    assert quick.stands and slow.stands
    assert slow.end.x - quick.end.x == pytest.approx(0.25 * 0.1, abs=1e-3), "at 0.1 m/s"


def test_robots_that_stand_three_centimetres_apart_are_near_and_one_that_touches_is_never_well():
    near, far = pair(driven(1.0), driven(1.029)), pair(driven(1.0), driven(1.031))
    assert near.is_near and not far.is_near
    assert is_well([near] * 57 + [far] * 3) and not is_well([near] * 56 + [far] * 4)
    assert not is_well([near] * 59 + [pair(driven(), driven(clearance=0.0))])


def test_pictures_are_alike_where_depths_agree_and_where_neither_camera_has_one():
    seen = np.array([[1.0, 2.0], [nan, nan]], np.float32)
    other = np.array([[1.005, 2.1], [nan, 3.0]], np.float32)
    assert pair(driven(picture=seen), driven(picture=other)).unlike == 0.5


def test_a_robot_that_never_set_out_has_no_latency_in_the_json():
    standing = Driven((Moment(0.0, Pose(), 0.0), Moment(4.0, Pose(), 0.0)), 0.02, "BLIND", nan, PICTURE, PICTURE)
    (drive,) = to_json([pair(standing, standing)], 0.05)["drives"]
    assert drive["gazebo"]["latency"] is None and drive["gazebo"]["stands"]


def test_help_needs_python_alone():
    program = Path(__file__).parent
    assert "--episodes" in subprocess.run([sys.executable, "-S", program, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
