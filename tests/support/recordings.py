# SPDX-License-Identifier: BSD-3-Clause
"""Clouds and bags for tests, made with rosbags and no other part of ROS."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, Sequence

import numpy as np
from ros2_bags import MCAP, SQLITE, names_of, ros2_writer
from rosbags.rosbag1 import Writer as Ros1Writer
from rosbags.typesys import Stores, get_typestore

TOPIC = "/camera/depth/points"
FRAME = "camera_depth_optical_frame"
CLOUD = "sensor_msgs/msg/PointCloud2"
FLOAT32 = 7


@dataclass(frozen=True)
class MadeCloud:
    """An unorganised xyz float32 cloud; `changes` makes the message contradict its points, as a broken driver does."""

    points: np.ndarray  # (N, 3) float32 [m], optical frame
    stamp: int  # [ns]
    changes: Sequence[Any] = ()  # pairs of a PointCloud2 field's name and its value


def wall_at(distance: float, stamp: int, **changes: Any) -> MadeCloud:
    """A wall across the corridor and beyond, with one unmeasured point and one behind the wall."""
    x, y = np.meshgrid(np.linspace(-0.6, 0.6, 13), np.linspace(-0.5, 0.5, 11))
    points = np.stack([x.ravel(), y.ravel(), np.full(x.size, distance)], axis=1).astype(np.float32)
    points[0], points[1, 2] = np.nan, distance + 1.0
    return MadeCloud(points, stamp, tuple(changes.items()))


def inside(points: np.ndarray) -> np.ndarray:
    """The points that the tutorial's crop keeps, float32 limits inclusive, in their order."""
    low, high = np.float32([-0.30, -0.25]), np.float32([0.30, 0.20])
    xy = points[:, :2]
    return points[np.all((xy >= low) & (xy <= high), axis=1) & np.isfinite(points[:, 2])]


def write_ros1(path: Path, clouds: Dict[str, Sequence[MadeCloud]]) -> Path:
    """A ROS 1 bag with these clouds by topic, recorded at their stamps."""
    store = get_typestore(Stores.ROS1_NOETIC)
    with Ros1Writer(path) as writer:
        for topic, made in clouds.items():
            connection = writer.add_connection(topic, CLOUD, typestore=store)
            for number, cloud in enumerate(made):
                message = cloud_message(cloud, store, seq=number)
                writer.write(connection, cloud.stamp, store.serialize_ros1(message, CLOUD))
    return path


def write_ros2(path: Path, clouds: Dict[str, Sequence[MadeCloud]]) -> Path:
    """The same as a ROS 2 bag (a folder), stored in SQLite."""
    return _write_ros2(path, clouds, SQLITE)


def write_mcap(path: Path, clouds: Dict[str, Sequence[MadeCloud]]) -> Path:
    """The same as a ROS 2 bag (a folder), stored as MCAP."""
    return _write_ros2(path, clouds, MCAP)


def _write_ros2(path: Path, clouds: Dict[str, Sequence[MadeCloud]], storage: str) -> Path:
    store = get_typestore(Stores.ROS2_HUMBLE)
    with ros2_writer(path, storage) as writer:
        for topic, made in clouds.items():
            connection = writer.add_connection(topic, CLOUD, typestore=store)
            for cloud in made:
                writer.write(connection, cloud.stamp, store.serialize_cdr(cloud_message(cloud, store), CLOUD))
    return path


def write_without_clouds(path: Path) -> Path:
    """A ROS 1 bag with a string on /chatter."""
    store = get_typestore(Stores.ROS1_NOETIC)
    with Ros1Writer(path) as writer:
        connection = writer.add_connection("/chatter", "std_msgs/msg/String", typestore=store)
        text = store.types["std_msgs/msg/String"]("hello")
        writer.write(connection, 1, store.serialize_ros1(text, "std_msgs/msg/String"))
    return path


def cloud_message(cloud: MadeCloud, store: Any, seq: int = 0) -> Any:
    """As the typestore's ROS has it: ROS 1 numbers its messages."""
    types = store.types
    numbered = {"seq": seq} if "seq" in names_of(store, "std_msgs/msg/Header") else {}
    stamp = types["builtin_interfaces/msg/Time"](*divmod(cloud.stamp, 10**9))
    field = types["sensor_msgs/msg/PointField"]
    count = len(cloud.points)
    parts: Dict[str, Any] = dict(
        header=types["std_msgs/msg/Header"](stamp=stamp, frame_id=FRAME, **numbered), height=1, width=count,
        fields=[field(name, 4 * i, FLOAT32, 1) for i, name in enumerate("xyz")], is_bigendian=False, point_step=12,
        row_step=12 * count, data=np.frombuffer(cloud.points.tobytes(), np.uint8), is_dense=False)
    return types[CLOUD](**{**parts, **dict(cloud.changes)})
