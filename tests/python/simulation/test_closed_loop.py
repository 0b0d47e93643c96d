# SPDX-License-Identifier: BSD-3-Clause
"""Closed-loop drives with the tutorial's decision; no ROS, no waiting."""
from __future__ import annotations

from itertools import groupby

import pytest

from rooms import room, tutorial_steering, wall_at
from safety_control_cloud.simulation.base import DRIVER, INSTANT, LIMITS, Pose, Velocity
from safety_control_cloud.simulation.closed_loop import Situation, drive
from safety_control_cloud.simulation.sensor import Xtion
from safety_control_cloud.simulation.turtlebot import TurtleBot
from safety_control_cloud.simulation.world import World

QVGA = Xtion(width=320, height=240)
CAMERA_X = Xtion().mount[0]  # [m] in base_footprint
GAZEBO_START = 1.887  # [m] camera to the front, as in the Gazebo 11 reference run
GAZEBO_STOP = (0.46, 0.50)  # [m] camera to the front, where the robot came to stand there


def tutorial_drive(robot: TurtleBot, seconds: float, latency: float = 0.05) -> list[Situation]:
    moments = list(drive(robot, tutorial_steering(robot.world.xtion), seconds, latency))
    robot.close()
    return moments


def wanted_speeds(moments: list[Situation]) -> list[float]:
    return [speed for speed, _ in groupby(moment.wanted.linear for moment in moments)]


@pytest.mark.parametrize("world", ["cabinet", "closed_cabinet"])
@pytest.mark.parametrize("wheels", LIMITS)
@pytest.mark.parametrize("xtion", [Xtion(), QVGA], ids=["VGA", "QVGA"])
def test_the_robot_slows_and_stands_before_the_cabinet_where_it_did_in_gazebo(world, wheels, xtion):
    robot = TurtleBot(World.load(world, xtion), LIMITS[wheels])
    front = robot.world.site("front")[0]
    robot.place(Pose(front - GAZEBO_START - CAMERA_X))
    moments = tutorial_drive(robot, 13.0)
    assert wanted_speeds(moments) == [0.2, 0.1, 0.0]
    assert not any(moment.contacts for moment in moments)
    assert moments[-1].velocity == Velocity()
    assert GAZEBO_STOP[0] <= front - (robot.pose.x + CAMERA_X) <= GAZEBO_STOP[1]


def test_a_drive_is_the_same_for_the_same_seed():
    def poses(seed: int) -> list[Pose]:
        return [moment.pose for moment in tutorial_drive(TurtleBot(World.load("cabinet", QVGA), seed=seed), 12.0)]

    assert poses(1) == poses(1)


def test_a_steering_that_falls_silent_leaves_the_robot_standing_within_0_6_s_and_the_way_to_brake():
    def dies(depth, now):
        return Velocity(0.2) if now < 2.0 else None

    robot = TurtleBot(room(xtion=QVGA), DRIVER)
    moments = list(drive(robot, dies, 4.0))
    robot.close()
    standing = next(moment.time for moment in moments if moment.time > 2.0 and moment.velocity == Velocity())
    assert standing <= 2.0 + 0.6 + 0.2 / 0.36 + 0.05


def test_latency_delays_the_stop_by_the_way_driven_meanwhile():
    def stop_at_1_s(depth, now):
        return Velocity(0.2 if now < 1.0 else 0.0)

    def way(latency: float) -> float:
        robot = TurtleBot(room(xtion=QVGA), INSTANT)
        list(drive(robot, stop_at_1_s, 3.0, latency))
        robot.close()
        return robot.pose.x + 0.2 * latency  # the start is as late as the stop

    assert way(0.3) - 0.2 * 0.3 == pytest.approx(way(0.0), abs=0.005)


def test_something_that_steps_in_the_way_during_the_drive_stops_the_robot():
    cart = '<body name="cart" mocap="true" pos="1.5 3 0.5"><geom name="cart" type="box" size="0.2 0.2 0.5"/></body>'
    robot = TurtleBot(room(cart, wall_at(9.0), xtion=QVGA))
    moments = []
    for moment in drive(robot, tutorial_steering(QVGA), 12.0, latency=0.05):
        if moment.time == pytest.approx(2.0):
            robot.world.move("cart", Pose(1.5, 0.0))
        moments.append(moment)
    robot.close()
    assert moments[-1].velocity == Velocity()
    assert not any(moment.contacts for moment in moments)
    assert 0 < robot.world.clearance() < 0.4
