# SPDX-License-Identifier: BSD-3-Clause
"""The simulated Xtion's topics, as its driver has them."""
from __future__ import annotations

import rospy
from sensor_msgs.msg import CameraInfo, Image, PointCloud2

from ..simulation.turtlebot import TurtleBot
from . import messages


class CameraTopics:
    """A picture is taken only while somebody wants to see it, and its colours only for the cloud and the colour image."""

    def __init__(self, robot: TurtleBot, depth_encoding: str) -> None:
        self._robot = robot
        self._depth_encoding = depth_encoding
        self._cloud = messages.CloudMessage(robot.world.xtion)
        self._points = rospy.Publisher("/camera/depth/points", PointCloud2, queue_size=1, tcp_nodelay=True)
        self._depth = rospy.Publisher("/camera/depth/image_raw", Image, queue_size=1)
        self._colour = rospy.Publisher("/camera/rgb/image_raw", Image, queue_size=1)
        self._infos = [
            rospy.Publisher(f"/camera/{eye}/camera_info", CameraInfo, queue_size=1) for eye in ("depth", "rgb")
        ]

    def publish(self, stamp: rospy.Time) -> None:
        """What the robot sees now."""
        for info in self._infos:
            if info.get_num_connections():
                info.publish(messages.to_camera_info(self._robot.world.xtion, stamp))
        cloud, depth, colour = (topic.get_num_connections() > 0 for topic in (self._points, self._depth, self._colour))
        seen = self._robot.picture() if cloud or colour else None
        if seen and cloud:
            self._points.publish(self._cloud.of(seen.depth, seen.colour, stamp))
        if depth:
            image = seen.depth if seen else self._robot.depth()
            self._depth.publish(messages.to_depth_image(image, self._depth_encoding, stamp))
        if seen and colour:
            self._colour.publish(messages.to_image(seen.colour, "rgb8", stamp))
