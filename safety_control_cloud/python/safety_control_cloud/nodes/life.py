# SPDX-License-Identifier: BSD-3-Clause
"""A node that ends between two of its steps.

rospy's own signal handler closes every connection in the middle of whatever the main thread does. Where that is a
publish(), it holds the connection's lock, for which the handler then waits for ever.
"""
from __future__ import annotations

import signal
import sys

import rospy

from ..processes import INTERRUPTS


class Life:
    def __init__(self, name: str) -> None:
        """Becomes a node, as rospy.init_node(): it waits for a master, and a signal ends it meanwhile."""
        self._asked = 0  # number of the signal
        for number in INTERRUPTS:
            signal.signal(number, lambda number, frame: sys.exit(128 + number))
        rospy.init_node(name, disable_signals=True)
        for number in INTERRUPTS:
            signal.signal(number, self._on_signal)

    def goes_on(self) -> bool:
        """Asked before each step. ROS shuts down in here when a signal has come."""
        if self._asked:
            rospy.signal_shutdown(f"signal {self._asked}")
        return not rospy.is_shutdown()

    def _on_signal(self, number: int, frame: object) -> None:
        self._asked = number
        for each in INTERRUPTS:
            signal.signal(each, signal.SIG_DFL)  # whoever asks again does not want to wait for the step
