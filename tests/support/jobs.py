# SPDX-License-Identifier: BSD-3-Clause
"""What workers are given in these tests; in a module of its own, so that they find it."""
import os
import time


def square(number: int) -> int:
    if number < 0:
        os._exit(9)  # as a segmentation fault would
    time.sleep(0.05)
    return number * number


def fail(number: int) -> int:
    raise ZeroDivisionError(number)


def other_version() -> str:
    return f"version of process {os.getpid()}"
