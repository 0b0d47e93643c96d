# SPDX-License-Identifier: BSD-3-Clause
"""A robot with something lost, whose master is started anew. A script, because rospy knows one master in its life."""
import os
import signal
import xmlrpc.client
from contextlib import ExitStack

import rosgraph
import rospy
from lost_board import robot_that_lost_a_board
from masters import master_again
from robot import NODE, eventually

from safety_control_cloud.ros_session import roscore

with roscore() as uri, ExitStack() as until_the_end:
    rospy.init_node("forgetful_master", disable_signals=True, disable_rosout=True)
    with robot_that_lost_a_board() as robot:
        os.kill(xmlrpc.client.ServerProxy(uri).getPid("/forgetful_master")[2], signal.SIGKILL)
        until_the_end.enter_context(master_again(uri))
        server = rosgraph.Master("/forgetful_master")
        eventually(lambda: server.hasParam(NODE + "_lost/things"))
        eventually(lambda: "the ROS master has forgotten what was near" in robot.process.output())
        robot.camera.changes()
        robot.stops("NEAR_LOSS")
    rospy.signal_shutdown("tested")
