# SPDX-License-Identifier: BSD-3-Clause
"""Looks on while the robot drives, says what the tutorial says, and moves the robot as rviz's mouse would."""
from __future__ import annotations

import time
from collections.abc import Callable
from math import inf
from threading import Lock

import numpy as np
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Image
from std_msgs.msg import String
from std_srvs.srv import Empty

from safety_control_cloud.msg import SafetyState

from .record import Approach, Sample

STANDS_FOR = 1.0  # [s] until the robot is believed to stand
SLOW = 60.0  # [s] a simulator may take for an answer; a busy machine is slow, not broken
SIMULATOR = "/turtlebot_sim"


class Watch:
    """`say` is called with a Sample whenever the zone changes and once a second."""

    def __init__(self, say: Callable[[Sample], None]) -> None:
        self._say = say
        self._lock = Lock()
        self._begin(at=inf)
        self._commanded = 0.0
        self._odometry = Odometry()
        self._picture: np.ndarray | None = None
        self._move = rospy.Publisher("/initialpose", PoseWithCovarianceStamped, queue_size=1)
        for topic, kind, heard in (
            ("/mobile_base/commands/velocity", Twist, self._on_command),
            ("/odom", Odometry, self._on_odometry),
            ("/camera/rgb/image_raw", Image, self._on_picture),
            (f"{SIMULATOR}/contacts", String, self._on_contacts),
            ("/safety_control_cloud/state", SafetyState, self._on_state),
        ):
            rospy.Subscriber(topic, kind, heard, queue_size=10)

    def reset(self) -> Odometry:
        """Put the robot at the world's start; returns where that is."""
        rospy.wait_for_service(f"{SIMULATOR}/reset", timeout=SLOW)
        rospy.ServiceProxy(f"{SIMULATOR}/reset", Empty)()
        rospy.wait_for_message("/odom", Odometry, timeout=SLOW)
        return rospy.wait_for_message("/odom", Odometry, timeout=SLOW)

    def move_to(self, place: Odometry) -> None:
        """As rviz's "2D Pose Estimate" does."""
        pose = PoseWithCovarianceStamped(header=place.header)
        pose.pose.pose = place.pose.pose
        self._move.publish(pose)
        rospy.sleep(0.3)  # the last clouds of the old place are still under way

    def approach(self, patience: float, goes_on: Callable[[], bool]) -> Approach:
        """Until the robot stands in Danger or touches something; at most `patience` [s] of simulated time."""
        self._begin()
        end = rospy.get_time() + patience
        while goes_on() and rospy.get_time() < end and not self._contacts and not self._stands():
            time.sleep(0.05)
        with self._lock:
            self._begun_at = inf
            return Approach(tuple(self._samples), frozenset(self._contacts), dict(self._views))

    def _begin(self, at: float | None = None) -> None:
        with self._lock:
            self._begun_at = rospy.get_time() if at is None else at
            self._samples: list[Sample] = []
            self._contacts: set[str] = set()
            self._views: dict[str, np.ndarray] = {}
            self._said_at, self._said_zone = -inf, ""

    def _stands(self) -> bool:
        with self._lock:
            if not self._samples:
                return False
            now = self._samples[-1].time
            last = [sample for sample in self._samples if sample.time > now - STANDS_FOR]
            return now - self._samples[0].time > STANDS_FOR and all(sample.stands_before_something for sample in last)

    def _on_state(self, state: SafetyState) -> None:
        stamp = state.header.stamp.to_sec()
        if stamp < self._begun_at:
            return  # of before, or latched
        sample = Sample(stamp, state.zone_text, state.nearest, self._commanded, self._odometry.twist.twist.linear.x)
        with self._lock:
            self._samples.append(sample)
            if self._picture is not None:
                self._views.setdefault(sample.zone, self._picture)
            speaks = sample.zone != self._said_zone or sample.time >= self._said_at + 1.0
            if speaks:
                self._said_zone, self._said_at = sample.zone, sample.time
        if speaks:
            self._say(sample)

    def _on_command(self, twist: Twist) -> None:
        self._commanded = twist.linear.x

    def _on_odometry(self, odometry: Odometry) -> None:
        self._odometry = odometry

    def _on_picture(self, image: Image) -> None:
        self._picture = np.frombuffer(image.data, np.uint8).reshape(image.height, image.width, 3)

    def _on_contacts(self, touched: String) -> None:
        if touched.data:
            with self._lock:
                self._contacts.update(touched.data.split(", "))
