# SPDX-License-Identifier: BSD-3-Clause
"""Simulated time in step with real time."""
from __future__ import annotations

import time

_PATIENCE = 0.2  # [s] one may fall behind; then the lost time is given up, not made up for


class Pace:
    def __init__(self, rate: float) -> None:
        """`rate`: simulated seconds a real one; 0 waits for nothing."""
        self._rate = rate
        self._due = time.monotonic()

    def keep(self, simulated: float) -> None:
        """Wait until `simulated` [s] more may have passed."""
        if self._rate == 0:
            return
        self._due += simulated / self._rate
        left = self._due - time.monotonic()
        if left > 0:
            time.sleep(left)
        elif left < -_PATIENCE:
            self._due = time.monotonic()
