# SPDX-License-Identifier: BSD-3-Clause
"""What the real TurtleBot has and gazebo_ros' differential drive lacks, as a ROS node beside Gazebo.

Commands time out and the motor driver limits the acceleration, as on the robot; rviz's tools move the robot and drop
boxes, and contacts are told, as by turtlebot_sim. The odometry, which is Gazebo's truth, says where the robot is; the
furniture counts as standing where its world has it.
"""
from __future__ import annotations

import time
from functools import partial
from math import inf
from threading import Event

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import String
from std_srvs.srv import Empty as EmptyService
from std_srvs.srv import EmptyResponse

from ..gazebo_ros import WHEELS_TOPIC
from ..simulation.base import Base, Limits, Pose
from ..simulation.furniture import Furniture
from ..simulation.hull import touched
from . import messages
from .gazebo_models import DroppedBoxes, place_robot
from .life import Life
from .node_memory import NodeMemory
from .orders import Orders
from .rviz_tools import listen_to_rviz

TICK = 0.01  # [s]
TOUCH = 0.002  # [m] from the furniture: Gazebo's things overlap a little, or not quite, when they touch
_PLACED = 0.1  # [s] after which odometry tells of the robot's new place
_PATIENCE = 30.0  # [s] of real time, for Gazebo to come up


class GazeboTurtlebot:
    """Runs in the thread that calls `run`; what comes in from outside waits for the next tick."""

    def __init__(self, furniture: Furniture, limits: Limits) -> None:
        self._furniture = furniture
        self._base = Base(limits)
        self._boxes = DroppedBoxes()
        self._orders = Orders()
        self._node_memory = NodeMemory()
        self._touched: str | None = None
        self._blind_until = -inf  # [s] to contacts
        self._wheels = rospy.Publisher(WHEELS_TOPIC, Twist, queue_size=1, tcp_nodelay=True)
        self._contacts = rospy.Publisher("~contacts", String, queue_size=10, latch=True)
        rospy.Subscriber("/mobile_base/commands/velocity", Twist, self._on_velocity, queue_size=10, tcp_nodelay=True)
        rospy.Subscriber("/odom", Odometry, self._on_odometry, queue_size=1, tcp_nodelay=True)
        listen_to_rviz(
            place=partial(self._orders.put, self._place), drop=partial(self._orders.put, self._boxes.drop))
        rospy.Service("~reset", EmptyService, self._on_reset)

    def run(self, life: Life) -> None:
        """For as long as the node lives."""
        last = rospy.get_time()
        while life.goes_on():
            try:
                self._orders.obey()
            except rospy.ServiceException as error:
                rospy.logerr("Gazebo: %s", error)
            now = rospy.get_time()
            if now < last:  # Gazebo's time was set back
                self._base.stand_at(Pose())
                last = now
            if now - last >= TICK:
                self._base.next_pose(now, now - last)
                self._wheels.publish(messages.to_twist(self._base.velocity))
                last = now
            time.sleep(TICK / 4)  # real time: Gazebo's may come in leaps, or stand still

    def _on_velocity(self, twist: Twist) -> None:
        self._orders.put(self._base.command, messages.to_velocity(twist), rospy.get_time())

    def _on_odometry(self, odometry: Odometry) -> None:
        pose, now = messages.to_pose(odometry.pose.pose), odometry.header.stamp.to_sec()
        self._orders.put(self._tell_contacts, pose, now)

    def _on_reset(self, _request) -> EmptyResponse:
        """Answers when the robot is back."""
        done = Event()
        for order in (self._boxes.clear, partial(self._place, self._furniture.start), done.set):
            self._orders.put(order)
        done.wait(_PATIENCE)
        return EmptyResponse()

    def _place(self, pose: Pose) -> None:
        self._base.stand_at(Pose())
        self._wheels.publish(Twist())
        place_robot(pose)
        self._node_memory.forget()
        self._blind_until = rospy.get_time() + _PLACED

    def _tell_contacts(self, pose: Pose, now: float) -> None:
        if now < self._blind_until:
            return
        names = ", ".join(sorted(set(touched((*self._furniture.things, *self._boxes.things), pose, TOUCH))))
        if names != self._touched:
            self._touched = names
            self._contacts.publish(names)
