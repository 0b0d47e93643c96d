# SPDX-License-Identifier: BSD-3-Clause
"""What a robot records that somebody drives: commands, odometry, scans, clouds of a wall and its floor, places of sensors."""
from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, List, Optional, Sequence

import numpy as np
from drives import SECOND, START, Record, cloud, header, placed
from recordings import MadeCloud

BASE, LASER = "base_footprint", "laser"
CAMERA_TURN = (-0.5, 0.5, -0.5, 0.5)  # optical frame, looking ahead
SPEED, BEGINS = 0.3, 0.6  # [m/s], [s]
BEAMS = 360


def commanded(time: float, x: float, w: float = 0.0, topic: str = "/cmd_vel", stamp: Optional[float] = None) -> Record:
    """A Twist, or with a stamp [s after START] a TwistStamped."""
    kind = "geometry_msgs/msg/Twist" if stamp is None else "geometry_msgs/msg/TwistStamped"

    def make(store: Any) -> Any:
        types = store.types
        vector = types["geometry_msgs/msg/Vector3"]
        twist = types["geometry_msgs/msg/Twist"](vector(x, 0.0, 0.0), vector(0.0, 0.0, w))
        return twist if stamp is None else types[kind](header(store, stamp, ""), twist)
    return Record(round(time * SECOND), topic, kind, make, "/teleop")


def odometry(time: float, x: float, speed: float, topic: str = "/odom") -> Record:
    kind = "nav_msgs/msg/Odometry"

    def make(store: Any) -> Any:
        types = store.types
        vector, point = types["geometry_msgs/msg/Vector3"], types["geometry_msgs/msg/Point"]
        pose = types["geometry_msgs/msg/Pose"](point(x, 0.0, 0.0), types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0))
        twist = types["geometry_msgs/msg/Twist"](vector(speed, 0.0, 0.0), vector(0.0, 0.0, 0.0))
        return types[kind](
            header(store, time, "odom"), BASE, types["geometry_msgs/msg/PoseWithCovariance"](pose, np.zeros(36)),
            types["geometry_msgs/msg/TwistWithCovariance"](twist, np.zeros(36)))
    return Record(round(time * SECOND), topic, kind, make, "/base")


def scan(time: float, ranges: np.ndarray, topic: str = "/scan", age: float = 0.0, **claims: Any) -> Record:
    """Anticlockwise from behind, `age` [s] old when it was recorded; `claims` contradict it, as a broken driver does."""
    kind, step = "sensor_msgs/msg/LaserScan", 2.0 * math.pi / BEAMS

    def make(store: Any) -> Any:
        fields = dict(
            angle_min=-math.pi, angle_max=math.pi - step, angle_increment=step, time_increment=0.0, scan_time=0.1, range_min=0.1,
            range_max=10.0, ranges=np.asarray(ranges, np.float32), intensities=np.empty(0, np.float32))
        return store.types[kind](header=header(store, time - age, LASER), **{**fields, **claims})
    return Record(round(time * SECOND), topic, kind, make, "/laser")


def hall_with_wall(distance: float, seed: int, radius: float = 4.0) -> np.ndarray:
    """A round hall with the noise that no two turns share, and a wall ahead, `distance` [m] from the laser."""
    bearings = np.arange(BEAMS) * 2.0 * math.pi / BEAMS - math.pi
    ahead = np.cos(bearings)
    wall = np.where(ahead > 0.3, distance / np.maximum(ahead, 1e-6), np.inf)
    return np.minimum(wall, radius) + np.random.default_rng(seed).normal(0.0, 0.003, BEAMS)


def wall_and_floor(time: float, distance: float, age: float = 0.03, topic: str = "/camera/depth/points") -> Record:
    """Organised, 48 x 64: a wall across the view, `distance` [m] ahead of a TurtleBot's camera."""
    across, down = np.meshgrid(np.linspace(-0.57, 0.57, 64), np.linspace(-0.43, 0.43, 48))
    deep = np.minimum(distance, np.where(down > 0, 0.2972 / np.maximum(down, 1e-6), np.inf))
    deep = deep + np.random.default_rng(round(1e6 * time)).normal(0.0, 0.001, deep.shape)
    points = np.stack([across * deep, down * deep, deep], axis=-1).astype(np.float32).reshape(-1, 3)
    shape = (("height", 48), ("width", 64), ("row_step", 64 * 12))
    return cloud(time, topic, MadeCloud(points, START + round((time - age) * SECOND), shape))


def camera_placed(parent: str = BASE) -> Record:
    return placed(0.0, (-0.087, 0.0, 0.2972), CAMERA_TURN, static=True, parent=parent)


def laser_placed(parent: str = BASE) -> Record:
    record = placed(0.0, (0.0, 0.0, 0.2), (0.0, 0.0, 0.0, 1.0), static=True, parent=parent)

    def make(store: Any) -> Any:
        message = record.make(store)
        message.transforms[0].child_frame_id = LASER
        return message
    return replace(record, make=make, source="/laser_place")


def at(time: float) -> float:
    """[m] that the robot has driven."""
    return max(0.0, time - BEGINS) * SPEED


def driven_at_wall(
    seconds: float = 3.0, gap: float = 0.9, sensors: Sequence[str] = ("camera",), topic: str = "/cmd_vel", every: float = 0.05,
) -> List[Record]:
    """Somebody drives at a wall that is `gap` [m] ahead of base_footprint, and never slows down; no two commands are equal."""
    records = [camera_placed()] if "camera" in sensors else []
    records += [laser_placed()] if "laser" in sensors else []
    for number in range(round(seconds * 50)):
        time = 0.02 * number + 0.011
        records.append(odometry(time, at(time), SPEED * (time > BEGINS)))
    for number in range(round(seconds / every)):
        time = every * number + 0.107
        records.append(commanded(time, SPEED * (time > BEGINS), 1e-4 * number, topic))
    for number in range(round(seconds * 10)):
        time = 0.1 * number + 0.123
        if "camera" in sensors:
            records.append(wall_and_floor(time, gap + 0.087 - at(time - 0.03)))
        if "laser" in sensors:
            records.append(scan(time + 0.031, hall_with_wall(gap - at(time + 0.031), number)))
    return records


def moved(time: float, x: float) -> Record:
    """TF's odometry."""
    record = placed(time, (x, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), parent="odom")

    def make(store: Any) -> Any:
        message = record.make(store)
        message.transforms[0].child_frame_id = BASE
        return message
    return replace(record, make=make, source="/base")


def touched(time: float, is_touched: bool, topic: str = "/bumper") -> Record:
    kind = "std_msgs/msg/Bool"
    return Record(round(time * SECOND), topic, kind, lambda store: store.types[kind](data=is_touched), "/base")


LASER_ALONE = driven_at_wall(seconds=1.0, sensors=["laser"])
