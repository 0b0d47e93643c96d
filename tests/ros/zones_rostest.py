#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tutorial's zones and speeds, from a bag that is played to the running node."""
import math
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import Twist
from listening import Heard, by_stamp, play, runs
from recordings import MadeCloud, wall_at

from safety_control_cloud.msg import SafetyState

STEP = 300_000_000  # [ns]
BESIDE = np.tile(np.float32([[5.0, 0.0, 0.4]]), (1000, 1))  # one point would be a cloud that shrank
NOTHING = MadeCloud(BESIDE, 8 * STEP)
BLIND = MadeCloud(np.full((50, 3), np.nan, np.float32), 9 * STEP)
EXPECTED = [  # cloud, zone, cause, nearest, speed
    (wall_at(1.5, 1 * STEP), "Safe", "SEEN", 1.5, 0.2),
    (wall_at(1.0, 2 * STEP), "Warning", "SEEN", 1.0, 0.1),
    (wall_at(0.75, 3 * STEP), "Warning", "SEEN", 0.75, 0.1),
    (wall_at(0.5, 4 * STEP), "Danger", "SEEN", 0.5, 0.0),
    (wall_at(0.4, 5 * STEP), "Danger", "SEEN", 0.4, 0.0),
    (wall_at(np.nextafter(np.float32(0.5), np.float32(1.0)), 6 * STEP), "Warning", "SEEN", 0.5, 0.1),
    (wall_at(np.nextafter(np.float32(1.0), np.float32(2.0)), 7 * STEP), "Safe", "SEEN", 1.0, 0.2),
    (NOTHING, "Safe", "SEEN", math.inf, 0.2),
    (BLIND, "Danger", "BLIND", math.nan, 0.0),
    (wall_at(1.5, 10 * STEP), "Safe", "SEEN", 1.5, 0.2),
    (wall_at(1.5, 11 * STEP, fields=[]), "Danger", "UNREADABLE", math.nan, 0.0),
    (wall_at(0.75, 12 * STEP), "Warning", "SEEN", 0.75, 0.1),
]


class Zones(unittest.TestCase):
    def test_every_cloud_gets_its_zone_and_its_speed(self):
        states, commands = Heard("/safety_control_cloud/state", SafetyState), Heard("/cmd_vel_mux/input/teleop", Twist)
        commands.until(lambda command: True)

        play([cloud for cloud, *_ in EXPECTED])

        last = EXPECTED[-1][0].stamp
        states.until(lambda state: state.header.stamp.to_nsec() == last)
        commands.until(lambda command: command.linear.x == 0.1, after=len(commands.all()) - 1)
        self.check_states(by_stamp(states.all()))
        self.check_commands(commands.all())

    def check_states(self, states):
        for cloud, zone, cause, nearest, speed in EXPECTED:
            state = states[cloud.stamp]
            self.assertEqual((state.zone_text, state.cause_text, state.speed), (zone, cause, speed))
            self.assertEqual(state.header.frame_id, "camera_depth_optical_frame")
            np.testing.assert_allclose(state.nearest, nearest, atol=1e-6)
            np.testing.assert_equal(state.nearest_point.z, state.nearest if math.isfinite(nearest) else math.nan)

    def check_commands(self, commands):
        self.assertEqual(runs([command.linear.x for command in commands]),
                         [0.0, *runs([speed for *_, speed in EXPECTED])])
        for command in commands:
            rest = (command.linear.y, command.linear.z, command.angular.x, command.angular.y, command.angular.z)
            self.assertEqual(rest, (0.0,) * 5)


if __name__ == "__main__":
    rospy.init_node("zones")
    rostest.rosrun("safety_control_cloud", "zones", Zones)
