# SPDX-License-Identifier: BSD-3-Clause
"""A planar range finder on /scan, 0.2 m above the floor in the middle of the robot.

As a script it is a node of its own that sees a hall: laser.py
"""
from __future__ import annotations

import math
from typing import Any

import numpy as np
import rospy
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from repeated import Repeated
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header

TOPIC, FRAME = "/scan", "laser"
BEAMS = 360
HEIGHT = 0.2  # [m] above base_footprint


def scan_of(ranges: np.ndarray, **claims: Any) -> LaserScan:
    """Anticlockwise from behind; `claims` contradict it, as a broken driver does."""
    step = 2.0 * math.pi / BEAMS
    scan = LaserScan(
        angle_min=-math.pi, angle_max=math.pi - step, angle_increment=step, scan_time=0.1, range_min=0.1, range_max=10.0,
        ranges=np.asarray(ranges, np.float32).tolist())
    scan.header.frame_id = FRAME
    for name, value in claims.items():
        setattr(scan, name, value)
    return scan


def hall() -> np.ndarray:
    """A round one, with the noise that no two turns share."""
    return np.float32(4.0) + np.random.default_rng().normal(0.0, 0.005, BEAMS).astype(np.float32)


def with_post(bearing: float, distance: float) -> np.ndarray:
    """Of 7 degrees, at a bearing [degree] from ahead to the left."""
    ranges = hall()
    ranges[(np.arange(-3, 4) + 180 + int(bearing)) % BEAMS] = distance
    return ranges


class Laser:
    """Turns ten times a second. `show` takes what makes a scan, each time anew."""

    def __init__(self, topic: str = TOPIC) -> None:
        self.clock = rospy.Time.now
        self._repeated = Repeated(topic, LaserScan, 10.0, self._stamped)
        self.show(lambda: scan_of(hall()))

    def show(self, made: Any) -> None:
        self._repeated.say(made)

    def pause(self) -> None:
        self._repeated.say(None)

    def end(self) -> None:
        self._repeated.end()

    def _stamped(self, made: Any) -> LaserScan:
        scan = made()
        scan.header.stamp = self.clock()
        return scan


def laser_on(base: str) -> TransformStamped:
    return TransformStamped(Header(0, rospy.Time.now(), base), FRAME, Transform(Vector3(0.0, 0.0, HEIGHT), Quaternion(w=1.0)))


if __name__ == "__main__":
    rospy.init_node("another_laser", disable_rosout=True)
    Laser()
    rospy.spin()
