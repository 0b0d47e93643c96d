# SPDX-License-Identifier: BSD-3-Clause
"""Where the bag's transforms say that the robot is, in a frame that rests, or base_frame, in the frame of odometry: what
ros/input/tf_odometry.cpp and odometry_input.cpp do."""
from __future__ import annotations

from math import hypot, remainder, tau
from typing import Any, Optional, Tuple

from safety_control_cloud.headings import heading_of
from safety_control_cloud.replay.places import Places

Pose = Tuple[float, float, float]  # x, y [m], heading [rad]
MOST_MOVED = 0.03  # [m] and [rad], of what is fixed on the robot


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


class BasePlace:
    def __init__(self, places: Places, base_frame: str) -> None:
        self._places, self._base = places, base_frame
        self._first: Optional[Pose] = None
        self.why_unknown: Optional[str] = None  # by the latest that was asked

    def within(self, frame: str, told_in: str) -> Optional[Pose]:
        """Of odometry of this frame, told in another; None: nobody says, or it is not fixed there."""
        frame = frame.lstrip("/")
        if frame in ("", self._base):
            return (0.0, 0.0, 0.0)
        known = self._places.latest(frame, self._base) if frame != told_in.lstrip("/") else None
        place = self._fixed(pose_in(known)) if known else None
        self.why_unknown = None if place else f"odometry is of {frame}, and no transform tells where {self._base} is fixed in it: no odometry"
        return place

    def _fixed(self, place: Pose) -> Optional[Pose]:
        first = self._first = self._first or place
        turned = remainder(place[2] - first[2], tau)
        return place if hypot(place[0] - first[0], place[1] - first[1]) + abs(turned) <= MOST_MOVED else None


def pose_in(transform: Any) -> Pose:
    """Of a TransformStamped, from above."""
    at = transform.transform.translation
    return (at.x, at.y, heading_of(transform.transform.rotation))
