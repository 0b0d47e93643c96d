# SPDX-License-Identifier: BSD-3-Clause
"""Commands with stamps: nothing old moves the robot, nor what nobody knows the age of."""
import time

import pytest
import rospy
from geometry_msgs.msg import Twist
from guarded import bits, guarded_robot, twist
from robot import after, eventually

from safety_control_cloud.processes import process

AHEAD = twist(0.3)
AGE = 0.3  # [s]


@pytest.fixture(scope="module")
def robot(master):
    with guarded_robot(command_type="twist_stamped", command_max_age=AGE) as robot:
        yield robot


@pytest.fixture(autouse=True)
def in_time(robot):
    robot.stamp = rospy.Time.now
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)
    yield
    robot.driver.say(None)


@pytest.mark.parametrize("off, words", [(-0.5, "old"), (-1e6, "old"), (60.0, "ahead"), (None, "stamp is 0")])
def test_a_stamp_that_cannot_be_ends_at_zero_and_recovers(robot, off, words):
    robot.stamp = rospy.Time if off is None else lambda: rospy.Time.now() + rospy.Duration(off)
    assert words in robot.stands("BAD_COMMAND").reason
    robot.stamp = rospy.Time.now
    robot.passes(AHEAD)


def test_a_little_late_is_in_time(robot):
    robot.stamp = lambda: rospy.Time.now() - rospy.Duration(AGE / 2)
    robot.passes(AHEAD)


def test_a_burst_after_a_gap_drives_nothing_old(robot):
    robot.driver.say(None)
    robot.stands("NO_COMMAND")
    begun, gap = time.monotonic(), rospy.Time.now()
    for i in range(100):
        robot.stamp = lambda i=i: gap - rospy.Duration(2.0 - 0.015 * i)
        robot.driver.say(AHEAD)
    robot.driver.say(None)
    eventually(lambda: any(state.cause_text == "BAD_COMMAND" for _, state in after(begun, robot.states)))
    time.sleep(0.7)
    assert {bits(command) for _, command in after(begun, robot.commands)} == {bits(Twist())}


def test_a_command_without_a_stamp_is_not_even_received(robot):
    robot.driver.say(None)
    robot.stands("NO_COMMAND")
    with process(["rostopic", "pub", "-r", "20", "/cmd_vel_in", "geometry_msgs/Twist", "{linear: {x: 0.3}}"]):
        robot.gives(lambda state: state.cause_text == "NO_COMMAND", lasts=2.0)
