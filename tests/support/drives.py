# SPDX-License-Identifier: BSD-3-Clause
"""Bags of whole drives for tests: clouds, depth images, transforms, each with the time and the node that it came from."""
from __future__ import annotations

import io
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, Sequence, Tuple

import numpy as np
from PIL import Image as Picture
from recordings import CLOUD, FRAME, MadeCloud, cloud_message, wall_at
from ros2_bags import MCAP, SQLITE, names_of, ros2_writer
from rosbags.rosbag1 import Writer as Ros1Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

SECOND = 10**9
START = 1_600_000_000 * SECOND
DEPTH, COMPRESSED = "/camera/depth/image_rect", "/camera/depth/image_rect/compressedDepth"
CAMERA = "/camera/depth/camera_info"
IMAGE, PACKED, INFO, TF = (f"{name}" for name in (
    "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage", "sensor_msgs/msg/CameraInfo", "tf2_msgs/msg/TFMessage"))


@dataclass(frozen=True)
class Record:
    time: int  # [ns] after START
    topic: str
    kind: str
    make: Callable[[Any], Any]  # the message of a typestore
    source: str = "/camera"


def cloud(time: float, topic: str, made: MadeCloud, source: str = "/camera") -> Record:
    """Recorded at `time` [s] after START."""
    return Record(round(time * SECOND), topic, CLOUD, lambda store: cloud_message(made, store), source)


def wall(time: float, distance: float, topic: str = "/camera/depth/points", age: float = 0.0, source: str = "/camera") -> Record:
    """A wall, `age` [s] old when it was recorded."""
    return cloud(time, topic, wall_at(distance, START + round((time - age) * SECOND)), source)


def depth(time: float, pixels: np.ndarray, topic: str = DEPTH) -> Record:
    """uint16 [mm] or float32 [m]."""
    encoding = {2: "16UC1", 4: "32FC1"}[pixels.dtype.itemsize]

    def make(store: Any) -> Any:
        height, width = pixels.shape
        return store.types[IMAGE](
            header=header(store, time), height=height, width=width, encoding=encoding, is_bigendian=0,
            step=width * pixels.dtype.itemsize, data=np.frombuffer(pixels.tobytes(), np.uint8))
    return Record(round(time * SECOND), topic, IMAGE, make)


def packed(time: float, pixels: np.ndarray) -> Record:
    """The same by compressedDepth; float32 as its inverse."""
    a, b = 100.0 * 101.0, 101.0 - 1.0  # what image_transport makes of depth_max 10, depth_quantization 100

    def make(store: Any) -> Any:
        stored, encoding = pixels, "16UC1"
        if pixels.dtype == np.float32:
            stored, encoding = np.where(pixels > 0, a / np.maximum(pixels, 0.1) + b, 0).astype(np.uint16), "32FC1"
        png = io.BytesIO()
        Picture.fromarray(stored).save(png, "PNG")
        data = struct.pack("<iff", 0, a, b) + png.getvalue()
        return store.types[PACKED](
            header=header(store, time), format=f"{encoding}; compressedDepth", data=np.frombuffer(data, np.uint8))
    return Record(round(time * SECOND), COMPRESSED, PACKED, make)


def camera(time: float, width: int, height: int, focal: float, late: float = 0.0) -> Record:
    """Stamped `time`, and recorded so much later."""
    k = [focal, 0, width / 2 - 0.5, 0, focal, height / 2 - 0.5, 0, 0, 1]

    def make(store: Any) -> Any:
        names = "DKRP" if "K" in names_of(store, INFO) else "dkrp"
        values = (np.zeros(5), np.array(k), np.eye(3).ravel(), np.array([*k[:3], 0, *k[3:6], 0, *k[6:], 0]))
        roi = store.types["sensor_msgs/msg/RegionOfInterest"](0, 0, 0, 0, False)
        return store.types[INFO](
            header=header(store, time), height=height, width=width, distortion_model="plumb_bob",
            **{name: value.astype(float) for name, value in zip(names, values)}, binning_x=0, binning_y=0, roi=roi)
    return Record(round((time + late) * SECOND), CAMERA, INFO, make)


def placed(time: float, at: Sequence[float], turn: Sequence[float], static: bool = False, parent: str = "base") -> Record:
    """The camera's frame in another one: position [m] and quaternion x, y, z, w."""
    def make(store: Any) -> Any:
        types = store.types
        transform = types["geometry_msgs/msg/Transform"](
            types["geometry_msgs/msg/Vector3"](*at), types["geometry_msgs/msg/Quaternion"](*turn))
        one = types["geometry_msgs/msg/TransformStamped"](header(store, time, parent), FRAME, transform)
        return types[TF]([one])
    return Record(round(time * SECOND), "/tf_static" if static else "/tf", TF, make)


def header(store: Any, time: float, frame: str = FRAME) -> Any:
    types = store.types
    stamp = types["builtin_interfaces/msg/Time"](*divmod(START + round(time * SECOND), SECOND))
    seq = {"seq": 0} if "seq" in names_of(store, "std_msgs/msg/Header") else {}
    return types["std_msgs/msg/Header"](stamp=stamp, frame_id=frame, **seq)


def write_drive(path: Path, records: Sequence[Record]) -> Path:
    """A ROS 1 bag; in the order of recording."""
    store, connections = get_typestore(Stores.ROS1_NOETIC), {}  # type: Any, Dict[Tuple[str, str], Any]
    store.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms\n", TF))
    with Ros1Writer(path) as writer:
        for record in sorted(records, key=lambda record: record.time):
            key = record.topic, record.source
            if key not in connections:
                connections[key] = writer.add_connection(
                    record.topic, record.kind, typestore=store, callerid=record.source)
            message = store.serialize_ros1(record.make(store), record.kind)
            writer.write(connections[key], START + record.time, message)
    return path


def write_drive2(path: Path, records: Sequence[Record], storage: str = SQLITE) -> Path:
    """The same as a ROS 2 bag; who sent is lost."""
    store, connections = get_typestore(Stores.ROS2_HUMBLE), {}  # type: Any, Dict[str, Any]
    with ros2_writer(path, storage) as writer:
        for record in sorted(records, key=lambda record: record.time):
            if record.topic not in connections:
                connections[record.topic] = writer.add_connection(record.topic, record.kind, typestore=store)
            message = store.serialize_cdr(record.make(store), record.kind)
            writer.write(connections[record.topic], START + record.time, message)
    return path


def write_mcap(path: Path, records: Sequence[Record]) -> Path:
    return write_drive2(path, records, MCAP)
