# SPDX-License-Identifier: BSD-3-Clause
"""Clouds out of ROS 1 and ROS 2 bags, as the bytes that a ROS 1 publisher would send."""
from __future__ import annotations

import struct
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence

from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore

CLOUD = "sensor_msgs/msg/PointCloud2"


class BagError(ValueError):
    """These bags cannot be replayed. str() is one line that says why."""


@dataclass(frozen=True)
class RecordedCloud:
    """A sensor_msgs/PointCloud2 as it was recorded, however malformed its content."""

    message: bytes  # serialised for ROS 1

    @property
    def stamp(self) -> int:
        """[ns] the header's."""
        seconds, nanoseconds = struct.unpack_from("<II", self.message, 4)
        return seconds * 1_000_000_000 + nanoseconds


@dataclass(frozen=True)
class Recording:
    """The clouds of one topic, in the order in which they were recorded."""

    topic: str
    count: int
    clouds: Iterator[RecordedCloud]  # raises BagError where the bag is damaged


@contextmanager
def recording(bags: Sequence[Path], topic: Optional[str] = None) -> Iterator[Recording]:
    """Opens ROS 1 bags (files) or ROS 2 bags (folders); several are merged by time of recording.

    Without a topic, the one that has clouds is taken. Raises BagError.
    """
    reader = _opened(bags)
    try:
        connections = [connection for connection in reader.connections if connection.msgtype == CLOUD]
        if not any(connection.msgcount for connection in connections):
            raise BagError(f"no sensor_msgs/PointCloud2 in {_names(bags)}; there is: {_contents(reader)}")
        chosen = _chosen(_counts(connections), topic, bags)
        of_topic = [connection for connection in connections if connection.topic == chosen]
        yield Recording(chosen, _counts(of_topic)[chosen], _clouds(reader, of_topic, bags))
    finally:
        reader.close()


def _opened(bags: Sequence[Path]) -> AnyReader:
    for bag in bags:
        if not bag.exists():
            raise BagError(f"{bag}: no such file")
        if bag.is_file() and bag.suffix != ".bag":
            raise BagError(f"{bag}: not a bag; ROS 1 bags are files named *.bag, ROS 2 bags folders with metadata.yaml")
    if len({bag.is_dir() for bag in bags}) > 1:
        raise BagError("ROS 1 and ROS 2 bags cannot be replayed together")
    try:
        # Bags from before 2023 name their ROS 2 types without defining them.
        reader = AnyReader(bags, default_typestore=get_typestore(Stores.ROS2_HUMBLE))
        reader.open()
    except Exception as error:  # whatever the reader stumbles over in a damaged file
        raise BagError(f"cannot read {_names(bags)}: {_line(error)}") from error
    return reader


def _clouds(reader: AnyReader, connections: Sequence[Any], bags: Sequence[Path]) -> Iterator[RecordedCloud]:
    messages = reader.messages(connections=connections)
    number = 0
    while True:
        number += 1
        try:
            _, _, raw = next(messages)
            cloud = RecordedCloud(_as_ros1(reader, raw))
        except StopIteration:
            return
        except Exception as error:  # as above
            raise BagError(f"cannot read cloud {number} of {_names(bags)}: {_line(error)}") from error
        yield cloud


def _as_ros1(reader: AnyReader, raw: bytes) -> bytes:
    if reader.is2:
        return bytes(reader.typestore.cdr_to_ros1(raw, CLOUD))
    reader.deserialize(raw, CLOUD)  # raises if the message is shorter or longer than its parts say
    return raw


def _counts(connections: Sequence[Any]) -> Dict[str, int]:
    counts: Dict[str, int] = {}
    for connection in connections:
        counts[connection.topic] = counts.get(connection.topic, 0) + connection.msgcount
    return {topic: count for topic, count in counts.items() if count}


def _contents(reader: AnyReader) -> str:
    contents = {f"{connection.topic} ({connection.msgtype.replace('/msg/', '/')})" for connection in reader.connections}
    return ", ".join(sorted(contents)) or "nothing"


def _chosen(counts: Dict[str, int], topic: Optional[str], bags: Sequence[Path]) -> str:
    there = ", ".join(f"{name} ({count})" for name, count in sorted(counts.items()))
    if topic is None:
        if len(counts) > 1:
            raise BagError(f"several topics with clouds in {_names(bags)}, choose one with --topic: {there}")
        return next(iter(counts))
    matching: List[str] = [name for name in counts if name.strip("/") == topic.strip("/")]
    if not matching:
        raise BagError(f"no sensor_msgs/PointCloud2 on {topic} in {_names(bags)}; there is: {there}")
    return matching[0]


def _names(bags: Sequence[Path]) -> str:
    return ", ".join(map(str, bags))


def _line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
