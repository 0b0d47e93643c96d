# SPDX-License-Identifier: BSD-3-Clause
"""Where the camera was, by the transforms that a bag has held so far; tf2 itself looks them up, as in the node."""
from __future__ import annotations

import math
from typing import Any, Union

import numpy as np

from safety_control_cloud.replay.bags import Bags, Recorded
from safety_control_cloud.replay.topics import TRANSFORMS, rooted
from safety_control_cloud.replay.wire import Header, header_in

CACHE = 10  # [s] as tf2_ros keeps
# As in ros/input/camera_place.cpp.
TOLERANCE = 0.1  # [s] by which the newest transform may be older than a cloud
MOST_TURNED, MOST_MOVED = 0.02, 0.01  # [rad], [m] by which a frame may have moved in as long before

ENDS = (2**31 - 1) * 10**9  # [ns] tf2_py takes later stamps for negative ones, and ends the process

Place = Union[np.ndarray, str]  # as core.SafetyControl.decide() takes it


class Places:
    def __init__(self, bags: Bags) -> None:
        import tf2_py  # part of ROS, and the only one; needed with a target_frame alone
        from genpy import Duration

        self._bags, self._tf2 = bags, tf2_py
        self._buffer = tf2_py.BufferCore(Duration(CACHE))

    def add(self, message: Recorded) -> None:
        """Raises bags.BagError."""
        is_static = TRANSFORMS[rooted(message.topic)]
        add = self._buffer.set_transform_static if is_static else self._buffer.set_transform
        for transform in self._bags.content_of(message).transforms:
            if is_static or has_time(header_in(transform).stamp):
                add(_ros(transform), "bag")

    def at(self, target_frame: str, cloud: Header) -> Place:
        from genpy import Duration, Time

        if not has_time(cloud.stamp):
            return self._at_any_time(target_frame, cloud)
        stamp = Time(*divmod(cloud.stamp, 10**9))
        try:
            try:
                found = self._buffer.lookup_transform_core(target_frame, cloud.frame, stamp)
            except self._tf2.ExtrapolationException:
                found = self._buffer.lookup_transform_core(target_frame, cloud.frame, Time())
                late = cloud.seconds - found.header.stamp.to_sec()
                if not 0.0 <= late <= TOLERANCE:
                    raise
                before = self._buffer.lookup_transform_core(target_frame, cloud.frame, found.header.stamp - Duration.from_sec(late))
                if has_moved(before.transform, found.transform):
                    return f"{cloud.frame} moves in {target_frame}, and its newest transform is {late:.3f} s older than the cloud"
        except self._tf2.TransformException as problem:
            return str(problem)
        return matrix_of(found.transform)

    def _at_any_time(self, target_frame: str, cloud: Header) -> Place:
        """Where nothing moves, any stamp will do."""
        found = self.latest(target_frame, cloud.frame)
        if found is None or not found.header.stamp.is_zero():
            return f"no transform from {cloud.frame} to {target_frame} at {cloud.seconds:.0f} s"
        return matrix_of(found.transform)

    def latest(self, target_frame: str, frame: str) -> Any:
        """The newest TransformStamped between them; None if there is none."""
        from genpy import Time

        try:
            return self._buffer.lookup_transform_core(target_frame, frame, Time())
        except self._tf2.TransformException:
            return None


def has_time(stamp: int) -> bool:
    """[ns] a stamp that tf2_py takes."""
    return 0 <= stamp < ENDS


def has_moved(before, now) -> bool:
    """Written so that NaN has moved."""
    turns = [np.array([part.rotation.x, part.rotation.y, part.rotation.z, part.rotation.w]) for part in (before, now)]
    places = [np.array([part.translation.x, part.translation.y, part.translation.z]) for part in (before, now)]
    turned = 2.0 * math.acos(min(abs(float(turns[0] @ turns[1])), 1.0))
    return not (turned <= MOST_TURNED and float(np.linalg.norm(places[1] - places[0])) <= MOST_MOVED)


def matrix_of(transform) -> Place:
    """(3, 4), [rotation | translation in m]; Eigen's formula, as in ros/input/camera_place.cpp."""
    at, turn = transform.translation, transform.rotation
    norm = math.sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w)
    if not abs(norm - 1.0) < 1e-3:
        return "the transform's rotation is not a unit quaternion"
    x, y, z, w = turn.x / norm, turn.y / norm, turn.z / norm, turn.w / norm
    return np.array([
        [1.0 - (2 * y * y + 2 * z * z), 2 * y * x - 2 * z * w, 2 * z * x + 2 * y * w, at.x],
        [2 * y * x + 2 * z * w, 1.0 - (2 * x * x + 2 * z * z), 2 * z * y - 2 * x * w, at.y],
        [2 * z * x - 2 * y * w, 2 * z * y + 2 * x * w, 1.0 - (2 * x * x + 2 * y * y), at.z]])


def _ros(recorded):
    """The same as a message of ROS 1, which tf2 takes."""
    from genpy import Time
    from geometry_msgs.msg import TransformStamped

    transform = TransformStamped()
    stamp = header_in(recorded).stamp
    transform.header.stamp = Time(*divmod(stamp if has_time(stamp) else 0, 10**9))
    transform.header.frame_id, transform.child_frame_id = recorded.header.frame_id, recorded.child_frame_id
    for part, names in (("translation", "xyz"), ("rotation", "xyzw")):
        for name in names:
            value = getattr(getattr(recorded.transform, part), name)
            setattr(getattr(transform.transform, part), name, float(value))
    return transform
