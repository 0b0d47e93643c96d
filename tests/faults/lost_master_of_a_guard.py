# SPDX-License-Identifier: BSD-3-Clause
"""A guard with a bumper whose ROS master is killed, and started again before or after the bumper's driver is killed.

A script, because rospy knows one master in its life; `before` or `after` is its argument. Connections outlive the
master: the robot is driven on as long as the driver lives, and stands once that was killed. Once there is a master the
driver's successor is heard, though the guard is not known to that master.
"""
import os
import signal
import sys
import time
import xmlrpc.client
from contextlib import ExitStack

import rospy
from guarded import FRONT_BUMPER, driver_of_the_bumper, guarded_robot, twist
from masters import master_again
from robot import NODE

from safety_control_cloud.ros_session import roscore

AHEAD = twist(0.3)
ASKED = 2.5  # [s] by which the guard has asked the master who the driver is, and where


def is_driven_on(robot):
    robot.gives(lambda state: state.cause_text == "SEEN" and state.factor == 1.0, within=10.0, lasts=ASKED)


def stands_once_it_is_killed(robot, driver):
    driver.send(signal.SIGKILL)
    assert robot.stands("SILENT", within=5.0).sensor == "front"


with roscore() as uri, ExitStack() as until_the_end:
    rospy.init_node("lost_master", disable_signals=True, disable_rosout=True)
    rospy.set_param(NODE + "/switches", [FRONT_BUMPER])
    with driver_of_the_bumper() as driver, guarded_robot() as robot:
        robot.driver.say(AHEAD)
        is_driven_on(robot)
        os.kill(xmlrpc.client.ServerProxy(uri).getPid("/lost_master")[2], signal.SIGKILL)
        is_driven_on(robot)
        if sys.argv[1] == "before":
            until_the_end.enter_context(master_again(uri))
            is_driven_on(robot)
            stands_once_it_is_killed(robot, driver)
        else:
            stands_once_it_is_killed(robot, driver)
            time.sleep(ASKED)
            until_the_end.enter_context(master_again(uri))
        with driver_of_the_bumper():
            is_driven_on(robot)
    rospy.signal_shutdown("tested")
