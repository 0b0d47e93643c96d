# SPDX-License-Identifier: BSD-3-Clause
"""Shows a running node: what its camera sees, what it decides and why.

It subscribes to ~state, which the node publishes whether or not somebody listens, and to the camera itself.
"""
from __future__ import annotations

import math
from threading import Lock
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import rospy
import tf2_ros
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

from safety_control_cloud import core
from safety_control_cloud.msg import SafetyState
from safety_control_cloud.nodes.camera_view import CameraView
from safety_control_cloud.nodes.life import Life
from safety_control_cloud.replay.places import matrix_of
from safety_control_cloud.view.memory import spots_in
from safety_control_cloud.view.moment import Guarded, Moment, Motion
from safety_control_cloud.view.sink import Sink

BLIND_CAUSES = ("SILENT", "NO_CLOUD", "UNREADABLE")  # there is no picture that belongs to them


class Viewer:
    def __init__(self, name: str, rate: float, odometry: Optional[str]) -> None:
        """`name` of the node; `rate` [Hz] at most."""
        self._name, self._period = name, 1.0 / rate
        self._lock = Lock()
        self._waiting: List[SafetyState] = []
        self._last: Optional[Moment] = None
        self._shown_at = -math.inf  # [s]
        self._driven: Optional[float] = None
        self.settings = settings_of(rospy.get_param(name, {}))
        self._camera = CameraView(self.settings.input, self._period)
        self._transforms = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._transforms) if self.settings.mode == "guard" else None
        rospy.Subscriber(f"{name}/state", SafetyState, self._on_state, queue_size=20)
        if odometry:
            rospy.Subscriber(odometry, Odometry, self._on_odometry, queue_size=1)

    def run(self, sink: Sink, life: Life) -> None:
        """For as long as the node lives."""
        while life.goes_on():
            with self._lock:
                states, self._waiting = self._waiting, []
            for state in states:
                self._show(state, sink)
            rospy.rostime.wallsleep(self._period / 4)

    def _show(self, state: SafetyState, sink: Sink) -> None:
        now = rospy.get_time()
        changed = self._last is None or (self._last.zone, self._last.cause) != (state.zone_text, state.cause_text)
        if not changed and 0.0 <= now - self._shown_at < self._period:
            return
        sink.adopt(settings_of(rospy.get_param(self._name, {})))
        self._last, self._shown_at = self._moment(state, now), now
        sink.show(self._last)

    def _moment(self, state: SafetyState, now: float) -> Moment:
        point = (state.nearest_point.x, state.nearest_point.y, state.nearest_point.z)
        picture = None if state.cause_text in BLIND_CAUSES else self._camera.picture()
        return Moment(
            now, state.zone_text, state.cause_text, state.reason, state.nearest if math.isfinite(state.nearest) else None,
            point if all(map(math.isfinite, point)) else None, state.speed, self._driven, state.header.stamp.to_nsec(),
            picture, *self._guarding(state), spots_in(rospy.get_param(f"{self._name}_lost/things", [])))

    def _guarding(self, state: SafetyState) -> Tuple[Optional[Guarded], Optional[np.ndarray]]:
        """In mode guard: what it lets through, and where the camera is."""
        if not self._listener:
            return None, None
        return Guarded(_motion(state.wanted), _motion(state.given)), self._place()

    def _place(self) -> Optional[np.ndarray]:
        try:
            found = self._transforms.lookup_transform(self.settings.base_frame, self._camera.frame, rospy.Time())
        except tf2_ros.TransformException:
            return None
        place = matrix_of(found.transform)
        return place if isinstance(place, np.ndarray) else None

    def _on_state(self, state: SafetyState) -> None:
        with self._lock:
            self._waiting.append(state)

    def _on_odometry(self, odometry: Odometry) -> None:
        self._driven = odometry.twist.twist.linear.x


def _motion(twist: Twist) -> Motion:
    return twist.linear.x, twist.linear.y, twist.angular.z


def settings_of(parameters: Dict[str, Any]) -> core.Settings:
    """Of what stands on the parameter server; the node has found it fit."""
    known = core.Settings().as_dict()
    return core.Settings(**{name: type(known[name])(value) for name, value in parameters.items() if name in known})
