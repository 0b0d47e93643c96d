# SPDX-License-Identifier: BSD-3-Clause
"""What was recorded for one node or more, as the bytes that ROS 1 publishers would send them."""
from __future__ import annotations

import struct
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

from safety_control_cloud.replay.bags import Bags, opened
from safety_control_cloud.replay.eyes import Sighting, eye_for
from safety_control_cloud.replay.topics import COMPRESSED, INPUTS, Source, chosen, transforms_in
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
    topic: str = ""  # as recorded

    @property
    def message(self) -> bytes:
        return self.parts[0]


@dataclass(frozen=True)
class Recording:
    """The clouds of one topic or more, in the order in which they were recorded."""

    sources: Sequence[Source]
    end: int  # [ns] of the bag's last message
    clouds: Iterator[RecordedCloud]  # raises BagError where the bag is damaged

    @property
    def topics(self) -> List[str]:
        return [source.topic.name for source in self.sources]

    @property
    def count(self) -> int:
        """Of depth images, those without a CameraInfo too."""
        return sum(source.topic.count for source in self.sources)


@contextmanager
def recording(
    bags: Sequence[Path], topics: Sequence[str] = (), wanted: str = INPUTS[0], transforms: bool = False
) -> Iterator[Recording]:
    """Without topics, the node's own is taken, or else all of the `wanted` input, or else all. Raises BagError."""
    with opened(bags) as there:
        sources = list({source.name: source for source in chosen(there, topics, wanted)}.values())
        yield Recording(sources, there.end, _clouds(there, sources, transforms))


def _clouds(bags: Bags, sources: Sequence[Source], with_transforms: bool) -> Iterator[RecordedCloud]:
    eyes = {source.name: eye_for(bags, source) for source in sources}
    moving = transforms_in(bags) if with_transforms else []
    since: List[Tuple[str, bytes]] = []
    looking: Dict[str, List[Source]] = {}
    for source in sources:
        for topic in source.topics:
            looking.setdefault(topic.name, []).append(source)
    seen = [topic for source in sources for topic in source.topics]
    for message in bags.messages([*seen, *moving]):
        if message.topic not in looking:
            since.append((message.topic, bags.as_ros1(message)))
        for source in looking.get(message.topic, ()):
            with bags.understanding(message):
                sighting = eyes[source.name].sighting_of(message)
            if sighting:
                yield RecordedCloud(message.time, sighting.header.stamp, _parts(bags, sighting), tuple(since), sighting,
                                    source.topic.name)
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
