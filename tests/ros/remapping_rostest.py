#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The node on a robot with names of its own."""
import unittest

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import Twist
from listening import Heard, playing
from recordings import FRAME, wall_at
from sensor_msgs.msg import PointCloud2

from safety_control_cloud.msg import SafetyState


class Remapping(unittest.TestCase):
    def test_every_topic_can_be_renamed(self):
        states, commands = Heard("/robot/guard/state", SafetyState), Heard("/robot/cmd_vel", Twist)
        output = Heard("/robot/near_points", PointCloud2)

        with playing([wall_at(0.75, 1 + n * 100_000_000) for n in range(50)], "/camera/depth/points:=/robot/front"):
            state = states.until(lambda state: state.cause_text == "SEEN")
            commands.until(lambda command: command.linear.x == 0.1)
            self.assertEqual(output.until(lambda cloud: True).header.frame_id, FRAME)

        self.assertEqual(state.zone_text, "Warning")

    def test_no_topic_keeps_its_old_name(self):
        Heard("/robot/guard/state", SafetyState).until(lambda state: True)
        published, subscribed, _ = rosgraph.Master("/remapping").getSystemState()

        topics = {topic for topic, nodes in published + subscribed if "/robot/guard" in nodes}

        common = {"/rosout", "/diagnostics", "/clock", "/tf", "/tf_static"}  # the same for every node of a robot
        self.assertEqual({topic for topic in topics - common if not topic.startswith("/robot/guard/")}, {
            "/robot/cmd_vel", "/robot/near_points", "/robot/front"})


if __name__ == "__main__":
    rospy.init_node("remapping")
    rostest.rosrun("safety_control_cloud", "remapping", Remapping)
