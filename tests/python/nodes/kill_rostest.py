#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""kill -9 of one part while the robot drives; ~victim says which."""
import sys
import unittest

import rospy
import rostest

from observer import BRAKING, COMMAND_TIMEOUT, Observer, kill

LATE = 0.15  # [s] from the last command's way and the odometry's, on a busy computer
TO_STAND = COMMAND_TIMEOUT + 0.2 / BRAKING + LATE  # [s] from 0.2 m/s


class Kill(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seen = Observer()

    def test_when_a_part_dies_the_robot_stands(self):
        self.seen.reset()
        self.seen.until_it_drives()
        tests = {"safety_control_cloud": self.node, "cmd_vel_mux": self.mux, "turtlebot_sim": self.simulator}
        tests[rospy.get_param("~victim")]()

    def node(self):
        """The robot drives its last command out; the multiplexer sends no zero of its own."""
        self.robot_stands_soon_after_the_death_of("/safety_control_cloud")
        self.assertAlmostEqual(self.seen.commands[-1].linear.x, 0.2)
        self.assertEqual(self.seen.holder, "idle")

    def mux(self):
        """The robot drives its last command out, while the node would still like to drive."""
        self.robot_stands_soon_after_the_death_of("/cmd_vel_mux")
        self.assertAlmostEqual(self.seen.wishes[-1].linear.x, 0.2)

    def simulator(self):
        """Camera, clock and base end together: the node says SILENT, and asks for nothing but to stand."""
        kill("/turtlebot_sim")
        self.seen.until("SILENT", lambda: self.seen.states[-1].cause_text == "SILENT", seconds=3)
        self.assertEqual((self.seen.states[-1].zone_text, self.seen.states[-1].speed), ("Danger", 0.0))
        self.seen.wishes.clear()
        self.seen.until("the node still speaks", lambda: len(self.seen.wishes) > 10, seconds=5)
        self.assertEqual({wish.linear.x for wish in self.seen.wishes}, {0.0})

    def robot_stands_soon_after_the_death_of(self, node: str):
        killed_at = rospy.get_time()
        kill(node)
        self.seen.until_it_stands()
        took = rospy.get_time() - killed_at
        print(f"after kill -9 of {node} the robot stood within {took:.2f} s")
        self.assertLessEqual(took, TO_STAND)
        at = self.seen.x
        rospy.sleep(1.5)
        self.assertAlmostEqual(self.seen.x, at, delta=0.002)


if __name__ == "__main__":
    rostest.rosrun("safety_control_cloud", "kill", Kill, sys.argv)
