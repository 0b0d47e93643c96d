# SPDX-License-Identifier: BSD-3-Clause
"""rviz's mouse: "2D Pose Estimate" puts the robot elsewhere, "Publish Point" drops a box."""
from __future__ import annotations

from math import isfinite
from typing import Callable, Sequence

import rospy
from geometry_msgs.msg import PointStamped, PoseWithCovarianceStamped

from ..simulation.base import Pose
from . import messages


def listen_to_rviz(place: Callable[[Pose], object], drop: Callable[[float, float], object]) -> None:
    """`place` and `drop`, x and y [m], are called in rospy's threads."""

    def on_pose(message: PoseWithCovarianceStamped) -> None:
        pose = messages.to_pose(message.pose.pose)
        if _is_meant("2D Pose Estimate", message.header.frame_id, (pose.x, pose.y, pose.yaw)):
            place(pose)

    def on_point(message: PointStamped) -> None:
        point = message.point.x, message.point.y
        if _is_meant("Publish Point", message.header.frame_id, point):
            drop(*point)

    rospy.Subscriber("/initialpose", PoseWithCovarianceStamped, on_pose, queue_size=1)
    rospy.Subscriber("/clicked_point", PointStamped, on_point, queue_size=10)


def _is_meant(tool: str, frame: str, numbers: Sequence[float]) -> bool:
    """Whether it is a place in the world; if not, that it is ignored is said."""
    if frame.lstrip("/") != messages.WORLD_FRAME:
        rospy.logwarn("%s in frame '%s' was ignored: choose %s as rviz's fixed frame", tool, frame, messages.WORLD_FRAME)
        return False
    if not all(map(isfinite, numbers)):
        rospy.logwarn("%s was ignored: not every number of it is finite", tool)
        return False
    return True
