# SPDX-License-Identifier: BSD-3-Clause
"""A publisher that says the same until it is told otherwise."""
from __future__ import annotations

import threading
from typing import Any, Callable

import rospy


class Repeated:
    """Publishes what it is given, again and again, from a thread of its own."""

    def __init__(self, topic: str, kind: type, rate: float, made_of: Callable[[Any], Any] = lambda message: message) -> None:
        self._publisher = rospy.Publisher(topic, kind, queue_size=1, tcp_nodelay=True)
        self._period, self._message, self._made_of = 1.0 / rate, None, made_of
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def say(self, message: Any) -> None:
        self._message = message
        if message is not None:
            self._publisher.publish(self._made_of(message))

    def end(self) -> None:
        self._ended.set()
        self._thread.join()
        self._publisher.unregister()

    def _run(self) -> None:
        while not self._ended.wait(self._period):
            message = self._message
            if message is not None:
                self._publisher.publish(self._made_of(message))
