# SPDX-License-Identifier: BSD-3-Clause
"""rviz's mouse: "2D Pose Estimate" puts the robot elsewhere, "Publish Point" drops a box."""
from __future__ import annotations

from typing import Callable

import rospy
from geometry_msgs.msg import PointStamped, PoseWithCovarianceStamped

from ..simulation.base import Pose
from . import messages


def listen_to_rviz(place: Callable[[Pose], object], drop: Callable[[float, float], object]) -> None:
    """`place` and `drop`, x and y [m], are called in rospy's threads."""

    def on_pose(message: PoseWithCovarianceStamped) -> None:
        if _is_in_world(message.header.frame_id, "2D Pose Estimate"):
            place(messages.to_pose(message.pose.pose))

    def on_point(message: PointStamped) -> None:
        if _is_in_world(message.header.frame_id, "Publish Point"):
            drop(message.point.x, message.point.y)

    rospy.Subscriber("/initialpose", PoseWithCovarianceStamped, on_pose, queue_size=1)
    rospy.Subscriber("/clicked_point", PointStamped, on_point, queue_size=10)


def _is_in_world(frame: str, tool: str) -> bool:
    if frame.lstrip("/") == messages.WORLD_FRAME:
        return True
    rospy.logwarn("%s is understood in %s, not in '%s': rviz's fixed frame", tool, messages.WORLD_FRAME, frame)
    return False
