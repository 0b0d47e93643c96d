# SPDX-License-Identifier: BSD-3-Clause
"""Where the bag's transforms say that the robot is, in a frame that rests: what ros/input/tf_odometry.cpp does."""
from __future__ import annotations

from typing import Any, Optional, Tuple

from safety_control_cloud.headings import heading_of
from safety_control_cloud.replay.places import Places

Pose = Tuple[float, float, float]  # x, y [m], heading [rad]


class Poses:
    def __init__(self, places: Places, odom_frame: str, base_frame: str) -> None:
        self._places, self._frames = places, (odom_frame, base_frame)
        self._told = 0.0  # [s]

    def next(self) -> Optional[Tuple[float, Pose]]:
        """The latest and its stamp [s], if it was not told yet."""
        latest = self._places.latest(*self._frames)
        if latest is None or latest.header.stamp.to_sec() == self._told:
            return None
        self._told = latest.header.stamp.to_sec()
        return self._told, pose_in(latest)


def pose_in(transform: Any) -> Pose:
    """Of a TransformStamped, from above."""
    at = transform.transform.translation
    return (at.x, at.y, heading_of(transform.transform.rotation))
