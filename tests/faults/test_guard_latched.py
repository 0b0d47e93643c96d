# SPDX-License-Identifier: BSD-3-Clause
"""A command that its publisher has latched may be of long ago: whoever connects is sent it anew."""
import signal
import time

import rospy
from guarded import ZERO, bits, guarded_robot, twist
from listening import eventually

from safety_control_cloud.processes import process

def driver(*options):
    return process(["rostopic", "pub", *options, "/cmd_vel_in", "geometry_msgs/Twist", "{linear: {x: 0.3}}", "__name:=latching_driver"])


def is_published(name):
    return any(name in nodes for topic, nodes in rospy.get_master().getSystemState()[2][0] if topic == "/cmd_vel_in")


def test_what_was_wanted_long_ago_is_not_obeyed_by_a_guard_that_starts(master):
    with driver():
        eventually(lambda: is_published("/latching_driver"))
        with guarded_robot() as robot:
            eventually(lambda: "/latching_driver latches its commands" in robot.process.output())
            time.sleep(1.0)
            robot.stands("NO_COMMAND")
            assert {bits(command) for command in robot.commands.all()} == {ZERO}


def test_nor_by_one_that_is_connected_again(master):
    with guarded_robot() as robot, driver() as latching:
        eventually(lambda: "/latching_driver latches its commands" in robot.process.output())
        latching.send(signal.SIGKILL)
        with driver():
            eventually(lambda: robot.process.output().count("latches its commands") == 2)
            robot.stands("NO_COMMAND")
            assert {bits(command) for command in robot.commands.all()} == {ZERO}


def test_what_comes_after_it_is(master):
    with guarded_robot() as robot, driver("-l", "-r", "10"):
        robot.passes(twist(0.3), within=10.0)
