# SPDX-License-Identifier: BSD-3-Clause
"""The compiled decision drives the robot through every world; no ROS, no waiting."""
from __future__ import annotations

from itertools import groupby

import pytest

from safety_control_cloud.simulation.base import Pose, Velocity
from safety_control_cloud.simulation.closed_loop import Situation, drive, steered_by
from safety_control_cloud.simulation.sensor import Xtion
from safety_control_cloud.simulation.turtlebot import TurtleBot
from safety_control_cloud.simulation.world import World
from safety_control_cloud.simulation.world_files import world_names

core = pytest.importorskip("safety_control_cloud.core")

QVGA = Xtion(width=320, height=240)


def drives(world: str, seconds: float) -> list[Situation]:
    robot = TurtleBot(World.load(world, QVGA))
    moments = list(drive(robot, steered_by(core.SafetyControl(), QVGA), seconds, latency=0.05))
    robot.close()
    return moments


def wanted_speeds(moments: list[Situation]) -> list[float]:
    return [speed for speed, _ in groupby(moment.wanted.linear for moment in moments)]


@pytest.mark.parametrize("world", [name for name in world_names() if name != "hall"])
def test_from_the_start_of_each_world_the_robot_slows_and_stands_without_touching(world):
    moments = drives(world, 18.0)
    assert wanted_speeds(moments) == [0.2, 0.1, 0.0]
    assert moments[-1].velocity == Velocity()
    assert not any(moment.contacts for moment in moments)


def test_started_so_near_to_a_closed_door_that_it_returns_nothing_the_robot_stands():
    """The tutorial's node, put there in Gazebo, says Safe and drives into the door."""
    robot = TurtleBot(World.load("closed_cabinet", QVGA))
    door = robot.world.site("front")[0]
    robot.place(Pose(x=door - 0.34 + 0.087))  # the camera sits 0.087 m behind base_footprint
    moments = list(drive(robot, steered_by(core.SafetyControl(), QVGA), 5.0, latency=0.05))
    robot.close()
    assert wanted_speeds(moments) == [0.0]
    assert moments[-1].pose.x == moments[0].pose.x


def test_in_the_hall_the_robot_drives_on():
    moments = drives("hall", 10.0)
    assert wanted_speeds(moments) == [0.2]
    assert moments[-1].pose.x == pytest.approx(0.2 * 10, abs=0.2)
