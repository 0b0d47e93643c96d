#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whoever ends the node stops the robot."""
import signal
import subprocess
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from listening import PATIENCE, Heard, playing
from recordings import wall_at

from safety_control_cloud.ros_session import node

DRIVE = [wall_at(1.5, (1 + n) * 100_000_000) for n in range(600)]


class Shutdown(unittest.TestCase):
    def check_last_command_when(self, ended):
        commands = Heard("/cmd_vel_mux/input/teleop", Twist)
        with node("safety_control_node", "_stamp_tolerance:=0") as running, playing(DRIVE):
            commands.until(lambda command: command.linear.x == 0.2)

            ended(running)

            self.assertEqual(running.wait(PATIENCE), 0, running.output())
            self.assertEqual(commands.until_silence()[-1], Twist())
        commands.close()

    def test_sigint(self):
        self.check_last_command_when(lambda running: running.send(signal.SIGINT))

    def test_sigterm(self):
        self.check_last_command_when(lambda running: running.send(signal.SIGTERM))

    def test_its_terminal_is_closed(self):
        self.check_last_command_when(lambda running: running.send(signal.SIGHUP))

    def test_rosnode_kill(self):
        self.check_last_command_when(lambda _: subprocess.run(
            ["rosnode", "kill", "/safety_control_cloud"], check=True, stdout=subprocess.DEVNULL))


if __name__ == "__main__":
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # under nohup, those who are started would ignore it
    rospy.init_node("shutdown")
    rostest.rosrun("safety_control_cloud", "shutdown", Shutdown)
