# SPDX-License-Identifier: BSD-3-Clause
"""What a node would be handed: each cloud, and each depth image together with the CameraInfo of its stamp."""
from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import Any, Deque, Optional, Tuple, Union

from safety_control_cloud import core
from safety_control_cloud.pinhole import Pinhole
from safety_control_cloud.replay.bags import BagError, Bags, Recorded
from safety_control_cloud.replay.compressed import image_of
from safety_control_cloud.replay.topics import CAMERA, COMPRESSED, Source
from safety_control_cloud.replay.wire import Header, Image, WireError, header_in, image_in, points_in

WAITING = 5  # of each kind at most wait for the other one; as in the node


@dataclass(frozen=True)
class Sighting:
    """A cloud, or a depth image with its camera, at the moment when the node has it."""

    number: int  # of its topic, from 0
    time: int  # [ns] of the bag
    header: Header
    source: str
    cloud: core.Cloud
    messages: Tuple[Recorded, ...]  # what it was made of
    content: Any  # wire.Points, wire.Image, or guard.scans.Scan
    camera: Optional[Pinhole] = None  # of depths


class CloudEye:
    def __init__(self, bags: Bags) -> None:
        self._bags, self._seen = bags, 0

    def sighting_of(self, message: Recorded) -> Optional[Sighting]:
        """Raises BagError."""
        try:
            header, points = points_in(message.raw, message.is_cdr)
        except WireError as error:
            raise BagError(f"cannot read cloud {self._seen + 1} of {self._bags.names}: {error}") from error
        self._seen += 1
        return Sighting(self._seen - 1, message.time, header, message.source, points.cloud(), (message,), points)


@dataclass(frozen=True)
class _Waiting:
    """An image, or a CameraInfo."""

    stamp: int
    message: Recorded
    header: Header
    content: object


class DepthEye:
    """Brings images and cameras together as the node does (ros/input/depth_pairs.hpp)."""

    def __init__(self, bags: Bags, topic: str) -> None:
        self._bags, self._seen = bags, 0
        self._rectified = "_rect" in topic.rpartition("/")[2]
        self._images: Deque[_Waiting] = deque(maxlen=WAITING)
        self._cameras: Deque[_Waiting] = deque(maxlen=WAITING)

    def sighting_of(self, message: Recorded) -> Optional[Sighting]:
        """None as long as the other half has not come. Raises BagError."""
        new = self._read(message)
        is_camera = message.kind == CAMERA
        own, others = (self._cameras, self._images) if is_camera else (self._images, self._cameras)
        matching = [one for one in others if one.stamp == new.stamp]
        if not matching:
            own.append(new)
            return None
        other = matching[-1 if is_camera else 0]
        image, camera = (other, new) if is_camera else (new, other)
        for waiting in (self._images, self._cameras):
            kept = [one for one in waiting if one.stamp > new.stamp]
            waiting.clear()
            waiting.extend(kept)
        return self._pair(image, camera, message.time)

    def _read(self, message: Recorded) -> _Waiting:
        if message.kind == CAMERA:
            content = self._bags.content_of(message)
            header = header_in(content)
            return _Waiting(header.stamp, message, header, content)
        try:
            if message.kind == COMPRESSED:
                header, image = image_of(self._bags.content_of(message))
            else:
                header, image = image_in(message.raw, message.is_cdr)
        except WireError as error:
            raise BagError(f"cannot read image {self._seen + 1} of {self._bags.names}: {error}") from error
        return _Waiting(header.stamp, message, header, image)

    def _pair(self, one: _Waiting, camera: _Waiting, time: int) -> Sighting:
        image, info = one.content, camera.content
        assert isinstance(image, Image)
        # Over another transport than the raw one, the node knows only who sent the camera's half.
        source = camera.message.source if one.message.kind == COMPRESSED else one.message.source
        cloud = core.Cloud.of_image(image.data, image.height, image.width, image.encoding, image.is_bigendian,
                                    image.step, self._rectified, claims_of(info))
        self._seen += 1
        return Sighting(self._seen - 1, time, one.header, source, cloud, (one.message, camera.message), image,
                        pinhole_of(info))


def claims_of(info) -> core.CameraClaims:
    d, k, p = ((getattr(info, name) if hasattr(info, name) else getattr(info, name.lower())) for name in "DKP")
    roi = (info.roi.x_offset, info.roi.y_offset, info.roi.height, info.roi.width)
    return core.CameraClaims(info.height, info.width, list(d), list(k), list(p), info.binning_x, info.binning_y, roi)


def pinhole_of(info) -> Pinhole:
    """Of the image as it was sent: the region first, because it counts in pixels before binning."""
    p = info.P if hasattr(info, "P") else info.p
    x, y = max(info.binning_x, 1), max(info.binning_y, 1)
    return Pinhole(p[0] / x, p[5] / y, (p[2] - info.roi.x_offset) / x, (p[6] - info.roi.y_offset) / y)


def eye_for(bags: Bags, source: Source) -> Union[CloudEye, DepthEye]:
    return DepthEye(bags, source.name) if source.camera else CloudEye(bags)
