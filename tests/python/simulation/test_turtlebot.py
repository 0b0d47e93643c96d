# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest

from rooms import box, room, wall_at
from safety_control_cloud.simulation.base import INSTANT, Pose, Velocity
from safety_control_cloud.simulation.robot import BODY_RADIUS
from safety_control_cloud.simulation.sensor import Xtion
from safety_control_cloud.simulation.turtlebot import TICK, TurtleBot
from safety_control_cloud.simulation.world import World


def drive_on(robot: TurtleBot, velocity: Velocity, seconds: float) -> None:
    for _ in range(round(seconds / 0.1)):
        robot.command(velocity)
        robot.advance(0.1)


def test_a_commanded_robot_drives_and_stops_0_6_s_after_the_last_command():
    robot = TurtleBot(room(), INSTANT)
    robot.command(Velocity(0.2))
    robot.advance(3.0)
    assert robot.pose.x == pytest.approx(0.12, abs=0.2 * TICK)
    assert robot.velocity == Velocity()


def test_a_wall_stops_the_robot_and_the_contact_is_reported():
    robot = TurtleBot(room(wall_at(0.5)), INSTANT)
    drive_on(robot, Velocity(0.2), 4.0)
    assert {contact.obstacle for contact in robot.contacts} == {"wall"}
    assert robot.pose.x == pytest.approx(0.5 - BODY_RADIUS, abs=0.003)
    assert robot.velocity == Velocity() and robot.base.velocity.linear == 0.2  # the wheels slip


def test_a_robot_at_a_wall_can_back_off():
    robot = TurtleBot(room(wall_at(0.5)), INSTANT)
    drive_on(robot, Velocity(0.2), 4.0)
    drive_on(robot, Velocity(-0.2), 1.0)
    assert robot.contacts == ()
    assert robot.pose.x < 0.15


def test_a_robot_hit_by_a_moving_thing_reports_it_and_can_drive_away():
    cart = '<body name="cart" mocap="true" pos="2 0 0.3"><geom name="cart" type="box" size="0.2 0.2 0.3"/></body>'
    robot = TurtleBot(room(cart), INSTANT)
    robot.world.move("cart", Pose(0.36))
    robot.step()
    assert {contact.obstacle for contact in robot.contacts} == {"cart"}
    drive_on(robot, Velocity(-0.2), 1.0)
    assert robot.contacts == () and robot.pose.x == pytest.approx(-0.2, abs=0.01)


def test_reset_brings_the_robot_back_and_takes_the_boxes_away_but_not_the_time_back():
    robot = TurtleBot(room(), INSTANT)
    robot.world.drop_box(2.0, 0.0)
    drive_on(robot, Velocity(0.2), 1.0)
    robot.reset(seed=0)
    assert robot.pose == robot.world.start
    assert robot.world.clearance(5.0) == 5.0
    assert robot.time == pytest.approx(1.0)


def test_a_robot_put_down_stands():
    robot = TurtleBot(room(), INSTANT)
    robot.command(Velocity(0.2))
    robot.place(Pose(1, 1, 1))
    robot.advance(0.3)
    assert robot.pose == Pose(1, 1, 1)


def pictures(seed: int | None) -> list[np.ndarray]:
    robot = TurtleBot(room(box("b", 2, 0, (0.2, 0.2, 0.5)), xtion=Xtion(width=320, height=240)), seed=seed)
    taken = []
    for _ in range(3):
        drive_on(robot, Velocity(0.2), 0.5)
        taken.append(robot.depth())
    robot.close()
    return taken


def test_the_same_seed_gives_the_same_pictures_and_another_seed_others():
    first, again, other = pictures(5), pictures(5), pictures(6)
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(first, again))
    assert not any(np.array_equal(a, b, equal_nan=True) for a, b in zip(first, other))


def test_a_reset_robot_sees_what_a_new_one_with_that_seed_sees():
    robot = TurtleBot(World.load("cabinet"), seed=1)
    first = robot.depth()
    drive_on(robot, Velocity(0.2), 1.0)
    robot.reset(seed=1)
    assert np.array_equal(robot.depth(), first, equal_nan=True)
    robot.close()


def test_without_a_seed_the_depth_has_no_noise():
    robot = TurtleBot(room(wall_at(2.0)), seed=None)
    picture = robot.depth()
    robot.close()
    assert np.array_equal(pictures(None)[0], pictures(None)[0], equal_nan=True)
    assert np.ptp(picture[10]) < 0.0001  # a row of a wall is one distance
