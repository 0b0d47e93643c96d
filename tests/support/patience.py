# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for what comes about by itself."""
import time
from typing import Callable, TypeVar

T = TypeVar("T")


def eventually(condition: Callable[[], T], patience: float = 30.0, pause: float = 0.05) -> T:
    """What the condition answers once that is true. Asks after each pause [s], for so long [s]."""
    deadline = time.monotonic() + patience
    while time.monotonic() < deadline:
        result = condition()
        if result:
            return result
        time.sleep(pause)
    raise AssertionError(f"it did not come about within {patience:g} s")
