# SPDX-License-Identifier: BSD-3-Clause
"""A camera that sends depth images and their CameraInfo, on /camera/depth/image_rect and beside it."""
from __future__ import annotations

from typing import Any, Callable

import numpy as np
import rospy
from camera import Camera
from scenes import FOCAL, WIDTH
from sensor_msgs.msg import CameraInfo, Image, PointCloud2

Damage = Callable[[Image, CameraInfo], None]


class DepthCamera(Camera):
    """Shows what a Camera would, as images; `damage` alters each pair before it is sent."""

    def __init__(self, *shown: Any, topic: str = "", **how: Any) -> None:
        self.damage: Damage = lambda image, info: None
        self.has_info = True
        self._image = rospy.Publisher("/camera/depth/image_rect", Image, queue_size=2, tcp_nodelay=True)
        self._info = rospy.Publisher("/camera/depth/camera_info", CameraInfo, queue_size=2, tcp_nodelay=True)
        super().__init__(*shown, **how)

    def end(self) -> None:
        super().end()
        self._image.unregister()
        self._info.unregister()

    def _publish(self, cloud: PointCloud2) -> None:
        image = image_of(cloud)
        info = info_of(image)
        self.damage(image, info)
        if self.has_info:
            self._info.publish(info)
        self._image.publish(image)


def image_of(cloud: PointCloud2) -> Image:
    """The depths [m] of an organised cloud with the fields x, y, z."""
    numbers = np.frombuffer(cloud.data, np.float32).reshape(cloud.height, cloud.width, -1)
    pixels = np.ascontiguousarray(numbers[..., 2])
    return Image(cloud.header, cloud.height, cloud.width, "32FC1", 0, 4 * cloud.width, pixels.tobytes())


def info_of(image: Image) -> CameraInfo:
    focal, cx, cy = FOCAL * image.width / WIDTH, (image.width - 1) / 2, (image.height - 1) / 2
    info = CameraInfo(header=image.header, height=image.height, width=image.width, distortion_model="plumb_bob", D=[0.0] * 5)
    info.K = [focal, 0, cx, 0, focal, cy, 0, 0, 1]
    info.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    info.P = [focal, 0, cx, 0, 0, focal, cy, 0, 0, 0, 1, 0]
    return info
