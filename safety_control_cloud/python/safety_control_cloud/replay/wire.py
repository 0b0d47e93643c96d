# SPDX-License-Identifier: BSD-3-Clause
"""The large messages where they lie, as ROS 1 or ROS 2 serialised them: their pixels and points are never copied."""
from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any, List, Tuple, Union

from safety_control_cloud import core

Bytes = Union[bytes, memoryview]
CDR_PREFIX, CDR_PADDING = 4, 3  # [byte]


class WireError(ValueError):
    """The message is shorter or longer than its parts say."""


@dataclass(frozen=True)
class Header:
    stamp: int  # [ns]
    frame: str

    @property
    def seconds(self) -> float:
        """[s] in the double that roscpp makes of it."""
        return seconds_of(self.stamp)


def seconds_of(time: int) -> float:
    """[s] of a time [ns], in the double that roscpp makes of it."""
    return time // 10**9 + 1e-9 * (time % 10**9)


def header_in(message: Any) -> Header:
    """That of a message which rosbags has read."""
    stamp = message.header.stamp
    return Header(stamp.sec * 10**9 + stamp.nanosec, message.header.frame_id)


@dataclass(frozen=True)
class Image:
    """sensor_msgs/Image after its header; in the order of its definition."""

    height: int
    width: int
    encoding: str
    is_bigendian: bool
    step: int
    data: Bytes


@dataclass(frozen=True)
class Points:
    """sensor_msgs/PointCloud2 after its header; fields are (name, offset [byte], datatype code, count)."""

    height: int
    width: int
    fields: List[Tuple[str, int, int, int]]
    is_bigendian: bool
    point_step: int
    row_step: int
    data: Bytes

    def cloud(self) -> core.Cloud:
        """Borrowed from the message."""
        return core.Cloud.of_bytes(
            self.data, self.height, self.width, self.fields, self.is_bigendian, self.point_step, self.row_step)


def points_in(raw: bytes, is_cdr: bool) -> Tuple[Header, Points]:
    """A sensor_msgs/PointCloud2, borrowed from its bytes. Raises WireError."""
    wire = _Wire(raw, is_cdr)
    header = wire.header()
    height, width, count = wire.number(), wire.number(), wire.number()
    if count > len(raw):
        raise WireError("it ends before its fields")
    fields: List[Tuple[str, int, int, int]] = []
    for _ in range(count):
        fields.append((wire.text(), wire.number(), wire.byte(), wire.number()))
    is_bigendian, point_step, row_step, data = bool(wire.byte()), wire.number(), wire.number(), wire.bytes()
    wire.byte()  # is_dense, which is not believed
    wire.expect_end()
    return header, Points(height, width, fields, is_bigendian, point_step, row_step, data)


def image_in(raw: bytes, is_cdr: bool) -> Tuple[Header, Image]:
    """A sensor_msgs/Image, borrowed from its bytes. Raises WireError."""
    wire = _Wire(raw, is_cdr)
    header = wire.header()
    image = Image(wire.number(), wire.number(), wire.text(), bool(wire.byte()), wire.number(), wire.bytes())
    wire.expect_end()
    return header, image


class _Wire:
    """Reads from the first byte to the last. CDR aligns numbers, and ends texts with a zero."""

    def __init__(self, raw: bytes, is_cdr: bool) -> None:
        self._raw, self._cdr = memoryview(raw), is_cdr
        self._at = self._start = CDR_PREFIX if is_cdr else 0
        little = not is_cdr or len(raw) > 1 and raw[1] == 1
        self._number = struct.Struct("<I" if little else ">I")

    def number(self) -> int:
        if self._cdr:
            self._at += (self._start - self._at) % 4
        self._need(4)
        (value,) = self._number.unpack_from(self._raw, self._at)
        self._at += 4
        return int(value)

    def byte(self) -> int:
        self._need(1)
        self._at += 1
        return self._raw[self._at - 1]

    def bytes(self) -> memoryview:
        size = self.number()
        self._need(size)
        self._at += size
        return self._raw[self._at - size : self._at]

    def text(self) -> str:
        text = bytes(self.bytes())
        try:
            return (text[:-1] if self._cdr else text).decode()
        except UnicodeDecodeError as error:
            raise WireError(f"a text is not UTF-8: {error}") from error

    def header(self) -> Header:
        if not self._cdr:
            self.number()  # seq
        seconds, nanoseconds = self.number(), self.number()
        return Header(seconds * 10**9 + nanoseconds, self.text())

    def expect_end(self) -> None:
        over = len(self._raw) - self._at
        if over > (CDR_PADDING if self._cdr else 0):
            raise WireError(f"it goes on for {over} bytes after its contents")

    def _need(self, size: int) -> None:
        if self._at + size > len(self._raw):
            raise WireError("it ends before its contents")
