# SPDX-License-Identifier: BSD-3-Clause
"""What comes in from rospy's threads waits here for the thread that simulates."""
from __future__ import annotations

from functools import partial
from queue import Empty, SimpleQueue
from typing import Callable


class Orders:
    def __init__(self) -> None:
        self._waiting: SimpleQueue[Callable[[], object]] = SimpleQueue()

    def put(self, order: Callable[..., object], *arguments: object) -> None:
        self._waiting.put(partial(order, *arguments))

    def obey(self) -> None:
        """Carry out all that have come, in their order."""
        try:
            while True:
                self._waiting.get_nowait()()
        except Empty:
            pass
