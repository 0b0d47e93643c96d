# SPDX-License-Identifier: BSD-3-Clause
"""ROS 2 bags, written by whichever rosbags is there: the last one for Python 3.8 and 3.9 writes SQLite alone."""
from __future__ import annotations

from dataclasses import dataclass, field, fields
from pathlib import Path
from struct import pack
from typing import Any, List, Set, Tuple

import rosbags.rosbag2 as rosbag2
import yaml

SQLITE, MCAP = "sqlite3", "mcap"
MAGIC = b"\x89MCAP0\r\n"


def names_of(store: Any, kind: str) -> Set[str]:
    """The fields of a message, as the typestore's ROS has it."""
    return {one.name for one in fields(store.types[kind])}


def ros2_writer(path: Path, storage: str = SQLITE) -> Any:
    if hasattr(rosbag2, "StoragePlugin"):
        return rosbag2.Writer(path, version=9, storage_plugin=rosbag2.StoragePlugin[storage.upper()])
    return rosbag2.Writer(path) if storage == SQLITE else McapWriter(path)


@dataclass(frozen=True)
class Channel:
    number: int
    topic: str
    kind: str
    definition: str


@dataclass
class McapWriter:
    """As rosbags' own, as far as tests need it: https://mcap.dev/spec, without chunks and index."""

    path: Path
    channels: List[Channel] = field(default_factory=list)
    messages: List[Tuple[int, Channel, bytes]] = field(default_factory=list)

    def __enter__(self) -> McapWriter:
        self.path.mkdir(parents=True)
        return self

    def add_connection(self, topic: str, kind: str, typestore: Any) -> Channel:
        definition, _ = typestore.generate_msgdef(kind, ros_version=2)
        self.channels.append(Channel(len(self.channels) + 1, topic, kind, definition))
        return self.channels[-1]

    def write(self, channel: Channel, time: int, data: bytes) -> None:
        self.messages.append((time, channel, bytes(data)))

    def __exit__(self, *_: Any) -> None:
        self.messages.sort(key=lambda message: message[0])
        file = self.path / f"{self.path.name}.mcap"
        file.write_bytes(b"".join([MAGIC, *self._records(), MAGIC]))
        (self.path / "metadata.yaml").write_text(yaml.safe_dump({"rosbag2_bagfile_information": self._metadata(file.name)}))

    def _records(self) -> List[bytes]:
        opened = [record(0x01, text("ros2"), text("tests"))]
        for one in self.channels:
            opened.append(record(0x03, pack("<H", one.number), text(one.kind), text("ros2msg"), text(one.definition)))
            opened.append(record(0x04, pack("<HH", one.number, one.number), text(one.topic), text("cdr"), pack("<I", 0)))
        said = [record(0x05, pack("<HIQQ", one.number, 0, time, time), data) for time, one, data in self.messages]
        return [*opened, *said, record(0x0F, pack("<I", 0)), record(0x02, pack("<QQI", 0, 0, 0))]

    def _metadata(self, file: str) -> Any:
        times = [time for time, _, _ in self.messages] or [0]
        return {
            "version": 8, "storage_identifier": MCAP, "relative_file_paths": [file], "compression_format": "",
            "compression_mode": "", "message_count": len(self.messages),
            "duration": {"nanoseconds": times[-1] - times[0]}, "starting_time": {"nanoseconds_since_epoch": times[0]},
            "topics_with_message_count": [
                {"message_count": sum(channel == one for _, channel, _ in self.messages),
                 "topic_metadata": {"name": one.topic, "type": one.kind, "serialization_format": "cdr", "offered_qos_profiles": ""}}
                for one in self.channels]}


def record(kind: int, *parts: bytes) -> bytes:
    content = b"".join(parts)
    return pack("<BQ", kind, len(content)) + content


def text(words: str) -> bytes:
    return pack("<I", len(words.encode())) + words.encode()
