# SPDX-License-Identifier: BSD-3-Clause
"""What a rostest sees of the whole stack, and how it waits: for the robot, never for a number of seconds."""
from __future__ import annotations

import os
import signal
import time
import xmlrpc.client
from collections.abc import Callable
from itertools import groupby

import rosgraph
import rosnode
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import String
from std_srvs.srv import Empty

from safety_control_cloud.demo.record import STANDING
from safety_control_cloud.msg import SafetyState

BRAKING = 0.36  # [m/s2] of the driver
COMMAND_TIMEOUT = 0.6  # [s] of the base
FRONT = 2.5  # [m] the cabinet's front in odom
CAMERA_X = -0.087  # [m] in base_footprint


class Observer:
    def __init__(self) -> None:
        rospy.init_node("observer")
        self.states: list[SafetyState] = []
        self.commands: list[Twist] = []  # as they reached the base
        self.wishes: list[Twist] = []  # of the node
        self.odometry = Odometry()
        self.holder = self.touched = ""
        self.draws_slowly = rospy.get_param("~draws_slowly", False)  # less than two pictures a second
        self._pose = rospy.Publisher("/initialpose", PoseWithCovarianceStamped, queue_size=1)
        rospy.Subscriber("/safety_control_cloud/state", SafetyState, self.states.append)
        rospy.Subscriber("/mobile_base/commands/velocity", Twist, self.commands.append)
        rospy.Subscriber("/cmd_vel_mux/input/teleop", Twist, self.wishes.append)
        rospy.Subscriber("/odom", Odometry, lambda odometry: setattr(self, "odometry", odometry))
        rospy.Subscriber("/cmd_vel_mux/active", String, lambda name: setattr(self, "holder", name.data))
        rospy.Subscriber("/turtlebot_sim/contacts", String, lambda name: setattr(self, "touched", name.data))

    @property
    def speed(self) -> float:
        return self.odometry.twist.twist.linear.x

    @property
    def x(self) -> float:
        return self.odometry.pose.pose.position.x

    @property
    def camera_to_front(self) -> float:
        return FRONT - (self.x + CAMERA_X)

    @property
    def zones(self) -> list[str]:
        """Of what it saw, where the simulator draws slowly; then it may be SILENT between two pictures."""
        told = (state for state in self.states if not (self.draws_slowly and state.cause_text == "SILENT"))
        return [zone for zone, _ in groupby(state.zone_text for state in told)]

    def until(self, what: str, true: Callable[[], bool], seconds: float = 60.0) -> None:
        """Raises AssertionError if `what` is still not so after so many simulated seconds, or real ones without a simulated one."""
        begun = at = rospy.get_time()
        moved = time.monotonic()
        while not true():
            if rospy.get_time() != at:
                at, moved = rospy.get_time(), time.monotonic()
                begun = begun or at  # 0: nobody had told the time yet
            assert at < begun + seconds and time.monotonic() < moved + seconds, f"waited {seconds} s in vain: {what}"
            time.sleep(0.01)

    def until_it_drives(self) -> None:
        self.until("the robot drives at 0.2 m/s", lambda: self.speed > 0.195)

    def until_it_stands(self) -> None:
        self.until("the robot stands", lambda: abs(self.speed) < STANDING)

    def reset(self) -> None:
        rospy.wait_for_service("/turtlebot_sim/reset", timeout=30)
        rospy.ServiceProxy("/turtlebot_sim/reset", Empty)()
        self.until("the robot is back", lambda: abs(self.x) < 0.3)

    def place(self, x: float, frame: str = "odom") -> None:
        self.until("the simulator listens", lambda: self._pose.get_num_connections() > 0)
        message = PoseWithCovarianceStamped()
        message.header.frame_id = frame
        message.pose.pose.position.x = x
        message.pose.pose.orientation.w = 1.0
        self._pose.publish(message)


def kill(node: str) -> None:
    """kill -9, of the process behind a node's name."""
    uri = rosnode.get_api_uri(rosgraph.Master("/observer"), node)
    os.kill(xmlrpc.client.ServerProxy(uri).getPid("/observer")[2], signal.SIGKILL)
