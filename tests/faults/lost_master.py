# SPDX-License-Identifier: BSD-3-Clause
"""A robot whose ROS master is killed and started again. A script, because rospy knows one master in its life.

What is true: connections outlive the master, so the robot drives, stops and drives again as if nothing had happened. But
ROS 1 nodes do not register again: a camera that is started after the new master is not found, and the robot stands until
the node is started again.
"""
import os
import signal
import sys
import xmlrpc.client
from contextlib import ExitStack

import camera
import rosgraph
import rospy
from masters import master_again
from robot import NODE, SOURCE_TIMEOUT, driving_robot
from scenes import hall, wall

from safety_control_cloud.processes import process
from safety_control_cloud.ros_session import roscore


def check_stops_and_drives(robot):
    robot.camera.show(hall(wall(0.45)))
    robot.stops("SEEN")
    robot.camera.pause()
    robot.stops("SILENT", within=SOURCE_TIMEOUT)
    robot.camera.show(hall())
    robot.drives()


with roscore() as uri, ExitStack() as until_the_end:
    rospy.init_node("lost_master", disable_signals=True, disable_rosout=True)
    with driving_robot() as robot:
        os.kill(xmlrpc.client.ServerProxy(uri).getPid("/lost_master")[2], signal.SIGKILL)
        robot.keeps(0.2)
        check_stops_and_drives(robot)

        until_the_end.enter_context(master_again(uri))
        check_stops_and_drives(robot)

        robot.camera.pause()
        robot.stops("SILENT", within=SOURCE_TIMEOUT)
        with process([sys.executable, camera.__file__, "3.0"]):
            robot.keeps(0.0, seconds=3.0)
        assert NODE not in [node for _, nodes in rosgraph.Master(NODE).getSystemState()[1] for node in nodes]
    rospy.signal_shutdown("tested")
