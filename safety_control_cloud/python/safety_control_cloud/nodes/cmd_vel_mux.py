# SPDX-License-Identifier: BSD-3-Clause
"""The TurtleBot's velocity multiplexer as a ROS node; the rules stand in `simulation/mux.py`."""
from __future__ import annotations

import time
from threading import Lock

import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import String

from ..simulation.mux import Mux, Table
from .life import Life

_LOOK_EVERY = 0.02  # [s] for a holder that has fallen silent
_STOPPED = 0.1  # [s] without a look, at least, of a process that was stopped


def _resolved(topic: str) -> str:
    """Relative topics are relative to the node's own name, as in yocs_cmd_vel_mux."""
    return topic if topic.startswith(("/", "~")) else "~" + topic


class CmdVelMux:
    def __init__(self, table: Table) -> None:
        self._mux = Mux(table.inputs)
        self._lock = Lock()  # rospy calls back from one thread for each publisher
        self._timeouts = {one.name: one.timeout for one in table.inputs}
        self._beat = time.monotonic()
        self._deaf_until = dict.fromkeys(self._timeouts, self._beat)
        self._announced: str | None = None
        self._active = rospy.Publisher("~active", String, queue_size=10, latch=True)
        self._output = rospy.Publisher(_resolved(table.publisher), Twist, queue_size=10, tcp_nodelay=True)
        self._inputs = [
            rospy.Subscriber(_resolved(one.topic), Twist, self._on_twist, one.name, queue_size=10, tcp_nodelay=True)
            for one in table.inputs
        ]

    def run(self, life: Life) -> None:
        while life.goes_on():
            with self._lock:
                self._note_beat()
                self._announce(rospy.get_time())
            time.sleep(_LOOK_EVERY)  # real time: a simulated clock may stand still

    def _on_twist(self, twist: Twist, name: str) -> None:
        now = rospy.get_time()
        with self._lock:
            self._note_beat()
            if self._mux.passes(name, now) and self._beat >= self._deaf_until[name]:  # it holds the mux in any case
                self._output.publish(twist)
            self._announce(now)

    def _note_beat(self) -> None:
        """What comes after this process was stopped may have waited in its socket, and who said it be dead by then."""
        now = time.monotonic()
        stopped_for, self._beat = now - self._beat, now
        for name, timeout in self._timeouts.items():
            if stopped_for > max(timeout, _STOPPED):
                self._deaf_until[name] = now + timeout

    def _announce(self, now: float) -> None:
        holder = self._mux.holder(now)
        if holder != self._announced:
            self._announced = holder
            self._active.publish(holder)


def run(table: Table) -> None:
    life = Life("cmd_vel_mux")
    CmdVelMux(table).run(life)
