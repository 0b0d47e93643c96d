#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Somebody else who commands the robot, a node of its own: commander.py SPEED [m/s] RATE [Hz; 0: says nothing] [TOPIC]"""
import sys

import rospy
from geometry_msgs.msg import Twist

speed, rate = float(sys.argv[1]), float(sys.argv[2])
topic = sys.argv[3] if len(sys.argv) > 3 and ":=" not in sys.argv[3] else "/cmd_vel_mux/input/teleop"
rospy.init_node("teleop", disable_rosout=True)
publisher = rospy.Publisher(topic, Twist, queue_size=10, tcp_nodelay=True)
command = Twist()
command.linear.x = speed
if rate > 0.0:
    rospy.Timer(rospy.Duration(1.0 / rate), lambda event: publisher.publish(command))
rospy.spin()
