# SPDX-License-Identifier: BSD-3-Clause
"""The safety node remembers what was near, and does not know of a hand that puts the robot elsewhere."""
from __future__ import annotations

import time
from threading import Event, Thread

import rospy
from std_srvs.srv import Trigger

SERVICE = "safety_control_cloud/reset"  # of the node; remap it where that has another name
_UNDER_WAY = 0.3  # [s] of real time, until the last clouds of the old place are through
_ONCE_IN = 1.1  # [s] the node forgets no more often


class NodeMemory:
    def __init__(self) -> None:
        self._reset = rospy.ServiceProxy(SERVICE, Trigger)
        self._elsewhere = Event()
        Thread(target=self._run, daemon=True).start()

    def forget(self) -> None:
        """The robot is in a new place: the node's ~reset will be called. Returns at once."""
        self._elsewhere.set()

    def _run(self) -> None:
        while self._elsewhere.wait():
            self._elsewhere.clear()
            time.sleep(_UNDER_WAY)
            self._tell()

    def _tell(self) -> None:
        try:
            if not self._reset().success:
                time.sleep(_ONCE_IN)
                self._reset()
        except rospy.ServiceException:
            pass  # no such node drives the robot
