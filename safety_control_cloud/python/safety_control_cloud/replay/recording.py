# SPDX-License-Identifier: BSD-3-Clause
"""What was recorded for one node, as the bytes that ROS 1 publishers would send it."""
from __future__ import annotations

import struct
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator, List, Optional, Sequence, Tuple

from safety_control_cloud.replay.bags import Bags, opened
from safety_control_cloud.replay.eyes import Sighting, eye_for
from safety_control_cloud.replay.topics import COMPRESSED, Source, only, transforms_in
from safety_control_cloud.replay.wire import Image

Transforms = Tuple[Tuple[str, bytes], ...]  # topic and message


@dataclass(frozen=True)
class RecordedCloud:
    """A sensor_msgs/PointCloud2, or an Image with its CameraInfo, as it was recorded, however malformed its content."""

    time: int  # [ns] of the bag
    stamp: int  # [ns] the header's
    parts: Tuple[bytes, ...]  # the messages, serialised for ROS 1
    transforms: Transforms = ()  # recorded since the cloud before
    sighting: Optional[Sighting] = None

    @property
    def message(self) -> bytes:
        return self.parts[0]


@dataclass(frozen=True)
class Recording:
    """The clouds of one topic, in the order in which they were recorded."""

    source: Source
    end: int  # [ns] of the bag's last message
    clouds: Iterator[RecordedCloud]  # raises BagError where the bag is damaged

    @property
    def topic(self) -> str:
        return self.source.topic.name

    @property
    def count(self) -> int:
        """Of depth images, those without a CameraInfo too."""
        return self.source.topic.count


@contextmanager
def recording(bags: Sequence[Path], topic: Optional[str] = None, transforms: bool = False) -> Iterator[Recording]:
    """Without a topic, the node's own is taken, or else the only one. Raises BagError."""
    with opened(bags) as there:
        source = only(there, topic)
        yield Recording(source, there.end, _clouds(there, source, transforms))


def _clouds(bags: Bags, source: Source, with_transforms: bool) -> Iterator[RecordedCloud]:
    eye = eye_for(bags, source)
    moving = transforms_in(bags) if with_transforms else []
    since: List[Tuple[str, bytes]] = []
    names = {topic.name for topic in source.topics}
    for message in bags.messages([*source.topics, *moving]):
        if message.topic not in names:
            since.append((message.topic, bags.as_ros1(message)))
            continue
        sighting = eye.sighting_of(message)
        if sighting:
            yield RecordedCloud(message.time, sighting.header.stamp, _parts(bags, sighting), tuple(since), sighting)
            since.clear()


def _parts(bags: Bags, sighting: Sighting) -> Tuple[bytes, ...]:
    return tuple(_raw_image(sighting) if one.kind == COMPRESSED else bags.as_ros1(one) for one in sighting.messages)


def _raw_image(sighting: Sighting) -> bytes:
    """The sensor_msgs/Image that image_transport would make of a compressed one."""
    image, frame = sighting.content, sighting.header.frame.encode()
    assert isinstance(image, Image)
    encoding, data = image.encoding.encode(), bytes(image.data)
    return b"".join((
        struct.pack("<III", 0, *divmod(sighting.header.stamp, 10**9)), struct.pack("<I", len(frame)), frame,
        struct.pack("<III", image.height, image.width, len(encoding)), encoding,
        struct.pack("<BII", image.is_bigendian, image.step, len(data)), data))
