# SPDX-License-Identifier: BSD-3-Clause
"""A robot with something lost, whose master is started anew. A script, because rospy knows one master in its life."""
import os
import signal
import xmlrpc.client
from contextlib import ExitStack

import rosgraph
import rospy
from masters import master_again
from robot import NODE, START, eventually, node_under_test, robot_with
from scenes import hall, wall
from test_restart import BOARD, FREE, PASSED

from safety_control_cloud.ros_session import roscore

with roscore() as uri, ExitStack() as until_the_end:
    rospy.init_node("forgetful_master", disable_signals=True, disable_rosout=True)
    with node_under_test() as first, robot_with(first, FREE) as robot:
        robot.drives(within=START)
        robot.camera.show(hall(BOARD, wall(3.0)))
        robot.stops("SEEN")
        robot.camera.show(hall(PASSED))
        robot.stops("NEAR_LOSS")
        os.kill(xmlrpc.client.ServerProxy(uri).getPid("/forgetful_master")[2], signal.SIGKILL)
        until_the_end.enter_context(master_again(uri))
        server = rosgraph.Master("/forgetful_master")
        eventually(lambda: server.hasParam(NODE + "_lost/things"))
        eventually(lambda: "the ROS master has forgotten what was near" in first.output())
        robot.camera.changes()
        robot.stops("NEAR_LOSS")
    rospy.signal_shutdown("tested")
