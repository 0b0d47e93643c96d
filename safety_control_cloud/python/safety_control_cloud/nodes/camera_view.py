# SPDX-License-Identifier: BSD-3-Clause
"""The latest picture of the node's camera, small enough for a wireless network."""
from __future__ import annotations

import time
from typing import Optional

import rospy
from sensor_msgs.msg import CameraInfo, Image, PointCloud2

from safety_control_cloud.pinhole import Pinhole
from safety_control_cloud.replay.eyes import pinhole_of
from safety_control_cloud.replay.topics import OWN
from safety_control_cloud.replay.wire import Points, WireError, image_in, points_in
from safety_control_cloud.replay.xyz import metres_of, xyz_of
from safety_control_cloud.view.moment import Picture
from safety_control_cloud.view.picture import depth_of, picture_of, thinned

BUFFER = 1 << 24  # [byte] rospy reads a large message in many pieces otherwise
LARGEST = 160 * 120  # points that are shown


class CameraView:
    """Keeps a message every `period` [s]; of the others not even the contents are read."""

    def __init__(self, kind: str, period: float) -> None:
        """`kind` of the node's input: cloud or depth."""
        self._is_depth, self._period = kind == "depth", period
        self._kept_at, self._raw, self._picture = 0.0, None, None  # type: float, Optional[bytes], Optional[Picture]
        self._camera: Optional[Pinhole] = None
        self.frame = ""  # of the picture
        topic = rospy.resolve_name(OWN[int(self._is_depth)])
        rospy.Subscriber(topic, _raw_of(Image if self._is_depth else PointCloud2), self._keep, queue_size=1, buff_size=BUFFER)
        if self._is_depth:
            info = topic.rpartition("/")[0] + "/camera_info"
            rospy.Subscriber(info, CameraInfo, self._on_camera, queue_size=1)

    def picture(self) -> Optional[Picture]:
        """The latest that could be read."""
        raw, self._raw = self._raw, None
        if raw:
            try:
                self._picture = self._picture_in(raw)
            except (WireError, ValueError, KeyError):
                pass  # the node says UNREADABLE of it
        return self._picture

    def _picture_in(self, raw: bytes) -> Optional[Picture]:
        header, content = (image_in if self._is_depth else points_in)(raw, False)
        self.frame = header.frame
        if isinstance(content, Points):
            return thinned(picture_of(xyz_of(content), self._picture), LARGEST)
        return thinned(depth_of(metres_of(content), self._camera), LARGEST) if self._camera else None

    def _keep(self, message: rospy.AnyMsg) -> None:
        if time.monotonic() - self._kept_at >= self._period * 0.8:
            self._kept_at, self._raw = time.monotonic(), message._buff

    def _on_camera(self, info: CameraInfo) -> None:
        self._camera = pinhole_of(info)


def _raw_of(kind: type) -> type:
    class Raw(rospy.AnyMsg):
        _md5sum, _type, _full_text = kind._md5sum, kind._type, kind._full_text

    return Raw
