# SPDX-License-Identifier: BSD-3-Clause
"""The real node, asked about one cloud at a time: none is dropped, however fast or slow this machine is."""
from __future__ import annotations

import math
import queue
import re
import struct
import time
from dataclasses import dataclass
from typing import Dict, List, Mapping, Optional, Sequence, Tuple, Type

import rospy
from genpy import Message
from sensor_msgs.msg import CameraInfo, Image, PointCloud2

from safety_control_cloud import core
from safety_control_cloud.msg import SafetyState
from safety_control_cloud.processes import Process
from safety_control_cloud.replay.recording import RecordedCloud

ANSWER_TIMEOUT = 30.0  # [s]
REMEMBERED = "_lost/things"  # after the node's name
REFUSAL = "cannot start with these parameters"  # as the node says it

ON_THE_SERVER = re.compile(r" \(it stays on the parameter server until: rosparam delete [^)]*\)")  # of a master that has ended by then


class NoAnswer(RuntimeError):
    """The node ended, or was silent about a cloud."""


class BadParameters(ValueError):
    """The node refused to start. str() is its list of problems."""


@dataclass(frozen=True)
class Answer:
    """What the node made of one cloud: its ~state, with the cloud's own stamp."""

    stamp: int  # [ns]
    zone: str
    cause: str
    reason: str
    nearest: Optional[float]  # [m]; None: nothing there if the cause is SEEN, else could not look
    nearest_point: Optional[Tuple[float, float, float]]  # [m]; None also for one that was lost from sight
    inside: int
    returns: int
    total: int
    speed: float  # [m/s]
    time: int = 0  # [ns] of the bag
    topic: str = ""  # as recorded


def raw(kind: Type[Message]) -> Type[rospy.AnyMsg]:
    """A message that is published as the bytes it was recorded in; rospy would write a new `seq` into it."""

    class Raw(rospy.AnyMsg):
        _md5sum, _type, _full_text = kind._md5sum, kind._type, kind._full_text

        def __init__(self, message: bytes) -> None:
            super().__init__()
            self._buff = message

    return Raw


def parameters_for_replay(chosen: Mapping[str, str]) -> Dict[str, str]:
    """The node's private parameters: a recording is old and has no clock, so silence and age are not judged.

    What the caller has chosen goes before.
    """
    timeless = {"source_timeout": "10.0", "stamp_tolerance": "0.0"}  # the longest patience that the node takes
    known = core.Settings().as_dict()
    return {**{name: value for name, value in timeless.items() if name in known}, **chosen}


class Lockstep:
    """Hands clouds to the node, each after the answer to the one before."""

    def __init__(self, process: Process, name: str, topics: Sequence[str]) -> None:
        """`name` of the node; `topics`: of the clouds; or of the depth images, and of their cameras."""
        self._process, self._name = process, name
        self._states: "queue.Queue[SafetyState]" = queue.Queue()
        rospy.Subscriber(f"{name}/state", SafetyState, self._states.put, tcp_nodelay=True)
        kinds = (PointCloud2,) if len(topics) == 1 else (Image, CameraInfo)
        self._parts = [rospy.Publisher(topic, raw(kind), queue_size=1) for topic, kind in zip(topics, kinds)]
        self._recorded = 0  # [ns] stamp of the last cloud; before the first, the node's states have an empty header
        self._sent = 0  # [ns] the stamp that it was given
        self._state_of(self._sent, "its start")
        while not all(part.get_num_connections() for part in self._parts):
            self._state_of(self._sent, "its start")  # it repeats its state, so this waits and watches over the node

    def answer_to(self, cloud: RecordedCloud) -> Answer:
        """Raises NoAnswer."""
        # The node repeats its last state when it waits long for a cloud. So that a repetition is not taken for the
        # answer, no two clouds in a row have the same stamp.
        self._sent = distinct(cloud.stamp, self._recorded, self._sent)
        self._recorded = cloud.stamp
        for publisher, part in zip(self._parts, cloud.parts):
            publisher.publish(_stamped(part, cloud.stamp, self._sent))
        return _answer(cloud, self._state_of(self._sent, f"the cloud of {cloud.stamp / 1e9:.3f} s"))

    def remembered(self) -> List[str]:
        """What the node last wrote down of what is near or lost; at most half a second old."""
        return list(rospy.get_param(self._name + REMEMBERED, []))

    def _state_of(self, stamp: int, asked: str) -> SafetyState:
        deadline = time.monotonic() + ANSWER_TIMEOUT
        while time.monotonic() < deadline:
            try:
                state = self._states.get(timeout=0.1)
            except queue.Empty:
                self.check_alive(asked)
                continue
            if state.header.stamp.to_nsec() == stamp:
                return state
        raise NoAnswer(f"the node gave no answer to {asked} within {ANSWER_TIMEOUT:g} s\n{self._said()}")

    def check_alive(self, asked: str) -> None:
        """Raises NoAnswer or BadParameters if the node has ended."""
        if self._process.exit_code is None:
            return
        _, refusal, problems = self._said().partition(REFUSAL)
        if refusal:
            raise BadParameters(ON_THE_SERVER.sub("", refusal + problems).strip())
        raise NoAnswer(f"the node ended with exit code {self._process.exit_code} at {asked}\n{self._said()}")

    def _said(self) -> str:
        return re.sub("\x1b\\[[0-9;]*m", "", self._process.output())


def distinct(stamp: int, before: int, before_sent: int) -> int:
    """Forward where the recording goes forward or stands: stamps that run to and fro would be those of two cameras."""
    return stamp if stamp < before else max(stamp, before_sent + 1)


def _stamped(message: bytes, own: int, stamp: int) -> bytes:
    if stamp == own:
        return message
    return b"".join((message[:4], struct.pack("<II", *divmod(stamp, 10**9)), memoryview(message)[12:]))


def _answer(cloud: RecordedCloud, state: SafetyState) -> Answer:
    point = (state.nearest_point.x, state.nearest_point.y, state.nearest_point.z)
    return Answer(
        cloud.stamp, state.zone_text, state.cause_text, state.reason, state.nearest if math.isfinite(state.nearest) else None,
        point if all(map(math.isfinite, point)) else None, state.inside, state.returns, state.total, state.speed,
        cloud.time, cloud.topic)
