#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A camera that says nothing stops the robot."""
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from listening import Heard, play
from recordings import wall_at

from safety_control_cloud.msg import SafetyState

STEP = 100_000_000  # [ns]
SOURCE_TIMEOUT = 0.5  # [s] the node's default
GRACE = 0.4  # [s] for a busy machine


def is_of(cloud, state):
    return state.header.stamp.to_nsec() == cloud.stamp


class Silence(unittest.TestCase):
    def setUp(self):
        self.states = Heard("/safety_control_cloud/state", SafetyState)
        self.commands = Heard("/cmd_vel_mux/input/teleop", Twist)

    def tearDown(self):
        self.states.close()
        self.commands.close()

    def test_1_before_the_first_cloud_the_robot_is_told_to_stand(self):
        state = self.states.until(lambda state: True)
        for _ in range(5):
            self.commands.until(lambda command: True, after=len(self.commands.all()))

        self.assertEqual((state.cause_text, state.zone_text, state.speed), ("NO_CLOUD", "Danger", 0.0))
        self.assertEqual((state.header.frame_id, state.nearest == state.nearest), ("", False))
        self.assertEqual({command.linear.x for command in self.commands.all()}, {0.0})

    def test_2_when_the_clouds_end_the_robot_stops_and_when_they_return_it_goes_on(self):
        for first in (1, 101):
            clouds = [wall_at(1.5, (first + n) * STEP) for n in range(5)]
            commanded = len(self.commands.all())

            play(clouds)

            silent = self.states.until(lambda state: is_of(clouds[-1], state) and state.cause_text == "SILENT")
            self.assertEqual((silent.zone_text, silent.speed), ("Danger", 0.0))
            self.check_time_to_stop(self.states.timed(), clouds[-1])
            self.commands.until(lambda command: command.linear.x == 0.2, after=commanded)
            self.commands.until(lambda command: command.linear.x == 0.0, after=len(self.commands.all()))

    def check_time_to_stop(self, states, last):
        of_last = [(time, state.cause_text) for time, state in states if is_of(last, state)]
        seen = next(time for time, cause in of_last if cause == "SEEN")
        silent = next(time for time, cause in of_last if cause == "SILENT")
        self.assertGreater(silent - seen, SOURCE_TIMEOUT - GRACE)
        self.assertLess(silent - seen, SOURCE_TIMEOUT + GRACE)

    def test_3_whoever_comes_late_hears_the_last_state_at_once(self):
        self.assertEqual(self.states.until(lambda state: True)._connection_header["latching"], "1")


if __name__ == "__main__":
    rospy.init_node("silence")
    rostest.rosrun("safety_control_cloud", "silence", Silence)
