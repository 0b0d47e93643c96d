# SPDX-License-Identifier: BSD-3-Clause
"""A command that its publisher has latched may be of long ago: whoever connects is sent it anew."""
import signal
import sys
import time

import rospy
from guarded import ZERO, bits, guarded_robot, twist
from listening import eventually

from safety_control_cloud.processes import process

DRIVER = """
import rospy
from geometry_msgs.msg import Twist
rospy.init_node("latching_driver", disable_rosout=True)
publisher = rospy.Publisher("/cmd_vel_in", Twist, queue_size=1, latch=True)
command = Twist()
command.linear.x = 0.3
publisher.publish(command)
while {again} and not rospy.is_shutdown():
    rospy.sleep(0.1)
    publisher.publish(command)
rospy.spin()
"""


def driver(again=False):
    return process([sys.executable, "-c", DRIVER.format(again=again)])


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
            assert {bits(command) for command in robot.commands.all()} == {ZERO}


def test_what_comes_after_it_is(master):
    with guarded_robot() as robot, driver(again=True):
        robot.passes(twist(0.3), within=10.0)
