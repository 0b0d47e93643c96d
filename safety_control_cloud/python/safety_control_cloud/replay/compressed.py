# SPDX-License-Identifier: BSD-3-Clause
"""Depth images as image_transport's compressedDepth packs them: 12 bytes of its own, then a PNG of 16 bits."""
from __future__ import annotations

import io
import struct
from typing import Any, Tuple

import numpy as np
from PIL import Image as Picture

from safety_control_cloud.replay.wire import Header, Image, WireError, header_in

PREFIX = struct.Struct("<iff")  # the format, and the two numbers by which floating depths were quantised


def image_of(message: Any) -> Tuple[Header, Image]:
    """The depths in a sensor_msgs/CompressedImage. Raises WireError."""
    header = header_in(message)
    encoding, _, how = message.format.partition(";")
    if "compressedDepth" not in how or "rvl" in how.lower():
        raise WireError(f"its format is {message.format!r}, not that of a PNG by compressedDepth")
    data = bytes(message.data)
    if len(data) <= PREFIX.size:
        raise WireError("it ends before its picture")
    stored = _unpacked(data[PREFIX.size :])
    if encoding.strip() == "32FC1":
        stored = _metres(stored, *PREFIX.unpack_from(data)[1:])
    height, width = stored.shape
    return header, Image(height, width, encoding.strip(), False, stored.strides[0], memoryview(stored.tobytes()))


def _unpacked(png: bytes) -> np.ndarray:
    try:
        with Picture.open(io.BytesIO(png), formats=["PNG"]) as picture:
            return np.asarray(picture).astype("<u2")
    except Exception as error:  # whatever the decoder stumbles over
        raise WireError(f"its picture is damaged: {error}") from error


def _metres(stored: np.ndarray, a: float, b: float) -> np.ndarray:
    """The inverse of the depth was stored; 0 is no return."""
    with np.errstate(divide="ignore"):
        depth = np.float32(a) / (stored.astype(np.float32) - np.float32(b))
    return np.where(stored == 0, np.float32(np.nan), depth).astype("<f4")
