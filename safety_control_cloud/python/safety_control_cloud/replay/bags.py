# SPDX-License-Identifier: BSD-3-Clause
"""ROS 1 and ROS 2 bags, message by message in the order in which they were recorded."""
from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Collection, Dict, Iterator, List, Optional, Sequence

import rosbags.rosbag2
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore

ENDINGS = (".bag", ".db3", ".mcap")
METADATA = "metadata.yaml"  # what makes a folder a ROS 2 bag
OPENS_FILES = hasattr(rosbags.rosbag2, "StoragePlugin")  # the last rosbags for Python 3.8 and 3.9 asks for the folder


class BagError(ValueError):
    """These bags cannot be replayed. str() is one line that says why."""


@dataclass(frozen=True)
class Recorded:
    """A message as it was recorded, however malformed its content."""

    topic: str
    kind: str  # as sensor_msgs/msg/PointCloud2
    time: int  # [ns] at which it was recorded
    source: str  # the node that sent it; ROS 2 bags do not tell
    raw: bytes
    is_cdr: bool  # serialised by ROS 2


@dataclass(frozen=True)
class Topic:
    name: str
    kind: str
    count: int


class Bags:
    """Opened by `opened`."""

    def __init__(self, reader: AnyReader, names: str) -> None:
        self._reader = reader
        self.names = names

    @property
    def end(self) -> int:
        """[ns] the time of the last message."""
        return int(self._reader.end_time) - 1

    def topics(self) -> List[Topic]:
        """Those with messages, by name."""
        counts: Dict[Any, int] = {}
        for connection in self._reader.connections:
            key = (connection.topic, connection.msgtype)
            counts[key] = counts.get(key, 0) + connection.msgcount
        return [Topic(name, kind, count) for (name, kind), count in sorted(counts.items()) if count]

    def contents(self) -> str:
        kinds = {f"{one.topic} ({one.msgtype.replace('/msg/', '/')})" for one in self._reader.connections}
        return ", ".join(sorted(kinds)) or "nothing"

    def messages(self, topics: Collection[Topic], start: Optional[int] = None) -> Iterator[Recorded]:
        """Those from a time on [ns]. Raises BagError where the bag is damaged."""
        wanted = {(topic.name, topic.kind) for topic in topics}
        chosen = [one for one in self._reader.connections if (one.topic, one.msgtype) in wanted]
        messages = self._reader.messages(connections=chosen, start=start) if chosen else iter(())
        number = 0
        while True:
            number += 1
            with self._reading(f"message {number}"):
                try:
                    connection, time, raw = next(messages)
                except StopIteration:
                    return
                source = getattr(connection.ext, "callerid", None) or ""
            yield Recorded(connection.topic, connection.msgtype, time, source, raw, self._reader.is2)

    def content_of(self, message: Recorded) -> Any:
        """Its fields by their names. Raises BagError."""
        with self._reading(f"a message of {message.topic}"):
            return self._reader.deserialize(message.raw, message.kind)

    def as_ros1(self, message: Recorded) -> bytes:
        """The bytes that a ROS 1 publisher would send. Raises BagError if it is shorter or longer than its parts say."""
        with self._reading(f"a message of {message.topic}"):
            if message.is_cdr:
                return bytes(self._reader.typestore.cdr_to_ros1(message.raw, message.kind))
            self._reader.deserialize(message.raw, message.kind)
            return message.raw

    @contextmanager
    def understanding(self, message: Recorded) -> Iterator[None]:
        """Raises BagError for whatever a message lacks whose very definition is damaged."""
        with self._reading(f"a message of {message.topic}"):
            yield

    @contextmanager
    def _reading(self, what: str) -> Iterator[None]:
        try:
            yield
        except BagError:
            raise
        except Exception as error:  # whatever the reader stumbles over in a damaged file
            raise BagError(f"cannot read {what} of {self.names}: {_line(error)}") from error


@contextmanager
def opened(bags: Sequence[Path]) -> Iterator[Bags]:
    """Opens ROS 1 bags (files) or ROS 2 bags (folders, .mcap, .db3); several are merged by time of recording.

    Raises BagError.
    """
    reader = _reader(bags)
    try:
        yield Bags(reader, _names(bags))
    finally:
        reader.close()


def _reader(bags: Sequence[Path]) -> AnyReader:
    for bag in bags:
        if not bag.exists():
            raise BagError(f"{bag}: no such file")
        if bag.is_dir() and not (bag / METADATA).exists():
            raise BagError(f"{bag}: no bag in it: a folder is one with {METADATA}")
        if bag.is_file() and bag.suffix not in ENDINGS:
            raise BagError(f"{bag}: not a bag; ROS 1 bags are files named *.bag, ROS 2 bags folders with {METADATA}, "
                           "*.mcap or *.db3")
        if bag.is_file() and bag.suffix != ".bag" and not OPENS_FILES:
            raise BagError(f"{bag}: with Python before 3.10 a ROS 2 bag is read by its folder, with {METADATA} in it")
    if len({bag.suffix == ".bag" for bag in bags}) > 1:
        raise BagError("ROS 1 and ROS 2 bags cannot be replayed together")
    try:
        # Bags from before 2023 name their ROS 2 types without defining them.
        reader = AnyReader(bags, default_typestore=get_typestore(Stores.ROS2_HUMBLE))
        reader.open()
    except Exception as error:  # whatever the reader stumbles over in a damaged file
        raise BagError(f"cannot read {_names(bags)}: {_line(error)}") from error
    return reader


def _names(bags: Sequence[Path]) -> str:
    return ", ".join(map(str, bags))


def _line(error: BaseException) -> str:
    return " ".join(str(error).split()) or type(error).__name__
