# SPDX-License-Identifier: BSD-3-Clause
"""A drive in a Gazebo that runs, by the real node: the scene is spawned and taken away, the robot put back."""
from __future__ import annotations

import time
from math import nan
from threading import Event, Lock, Thread
from typing import Callable

import numpy as np
import rospy
from driven import AT_REST, Driven, Moment, last_moved
from drawn_drives import scene_of
from dynamic_reconfigure.client import Client
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Image
from std_srvs.srv import Empty, Trigger

from safety_control_cloud.msg import SafetyState
from safety_control_cloud.nodes import messages
from safety_control_cloud.nodes.gazebo_models import delete, spawn
from safety_control_cloud.simulation.furniture import Thing
from safety_control_cloud.simulation.hull import distances
from safety_control_cloud.trials.scenario import Scenario

NODE = "/safety_control_cloud"
SLOW = 120.0  # [s] of real time for an answer; a busy machine is slow, not broken
HELD_EVERY = 0.05  # [s] of real time, oftener than the multiplexer forgets who holds it
SETTLED = 1.0  # [s] until the clouds under way are those of the new scene, and the robot has come to rest


class Gazebo:
    def __init__(self) -> None:
        self._lock, self._held = Lock(), Event()
        self._scene: Thing | None = None
        self._track: list[Moment] = []
        self._states: list[SafetyState] = []
        self._depth = Image()
        rospy.Subscriber("/odom", Odometry, self._on_odometry, queue_size=100)
        rospy.Subscriber(f"{NODE}/state", SafetyState, self._on_state, queue_size=100)
        rospy.Subscriber("/camera/depth/image_raw", Image, self._on_depth, queue_size=1)
        self._settings = Client(NODE, timeout=SLOW)
        usual = self._settings.get_configuration(timeout=SLOW)
        self._usual = {name: value for name, value in usual.items() if name != "groups"}
        self._stop = rospy.Publisher("/cmd_vel_mux/input/safety_controller", Twist, queue_size=1)
        Thread(target=self._hold, daemon=True).start()

    def drive(self, scenario: Scenario) -> Driven:
        """Raises ROSException or ServiceException where Gazebo or the node do not answer."""
        self._held.set()
        first = self._prepare(scenario)
        with self._lock:
            self._track.clear()
            self._states.clear()
        self._held.clear()
        self._until("the drive did not end", lambda: self._is_over(scenario.seconds))
        return self._driven(first)

    def _prepare(self, scenario: Scenario) -> np.ndarray:
        """Gives a picture of the scene that stands."""
        if self._scene:
            delete(self._scene.name)
        _call("/turtlebot_sim/reset", Empty)
        self._scene = scene_of(scenario)
        spawn(self._scene)
        self._settings.update_configuration({**self._usual, **dict(scenario.settings)})
        rospy.sleep(SETTLED)
        while not _call(f"{NODE}/reset", Trigger).success:  # it forgets no more often than once a second
            rospy.sleep(0.1)
        rospy.sleep(SETTLED)
        return self._picture()

    def _is_over(self, seconds: float) -> bool:
        with self._lock:
            if not self._track:
                return False
            now = self._track[-1].time
            return now - last_moved(self._track) > AT_REST or now - self._track[0].time > seconds

    def _driven(self, first: np.ndarray) -> Driven:
        with self._lock:
            track, states = tuple(self._track), tuple(self._states)
        scene = self._scene
        clearance = min(distance for moment in track for _, distance in distances((scene,), moment.pose))
        return Driven(track, clearance, states[-1].cause_text, _decided_at(states), first, self._picture())

    def _until(self, otherwise: str, true: Callable[[], object]) -> None:
        give_up = time.monotonic() + SLOW
        while not true():
            if time.monotonic() > give_up or rospy.is_shutdown():
                raise rospy.ROSException(f"{otherwise} within {SLOW:.0f} s")
            time.sleep(0.02)

    def _hold(self) -> None:
        """Somebody of higher priority than the node lets the robot stand."""
        while self._held.wait():
            self._stop.publish(Twist())
            time.sleep(HELD_EVERY)

    def _picture(self) -> np.ndarray:
        """One that is taken from now on."""
        now = rospy.Time.now()
        self._until("no picture came", lambda: self._depth.header.stamp >= now and self._depth.height)
        depth = self._depth
        return np.frombuffer(depth.data, np.float32).reshape(depth.height, depth.width)

    def _on_odometry(self, odometry: Odometry) -> None:
        pose, speed = messages.to_pose(odometry.pose.pose), odometry.twist.twist.linear.x
        with self._lock:
            self._track.append(Moment(odometry.header.stamp.to_sec(), pose, speed))

    def _on_state(self, state: SafetyState) -> None:
        with self._lock:
            self._states.append(state)

    def _on_depth(self, image: Image) -> None:
        self._depth = image


def _decided_at(states: tuple[SafetyState, ...]) -> float:
    """[s] stamp of the first of the closing run of states that say stand; NaN if there is none before it."""
    moving = [place for place, state in enumerate(states) if state.speed > 0]
    return states[moving[-1] + 1].header.stamp.to_sec() if moving and moving[-1] + 1 < len(states) else nan


def _call(service: str, kind: type):
    rospy.wait_for_service(service, timeout=SLOW)
    return rospy.ServiceProxy(service, kind)()
