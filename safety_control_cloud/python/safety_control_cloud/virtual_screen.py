# SPDX-License-Identifier: BSD-3-Clause
"""A screen that nobody sees, for what draws only on one."""
from __future__ import annotations

import os
import subprocess
from contextlib import contextmanager
from typing import Iterator

from .processes import ProcessError


@contextmanager
def virtual_screen(width: int = 1280, height: int = 1024) -> Iterator[str]:
    """Gives its DISPLAY for as long as the block lasts: who draws there has to end before. Raises ProcessError.

    It is in a session of its own: Ctrl-C reaches who draws first.
    """
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"]
    try:
        screen = subprocess.Popen(
            command, pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    except FileNotFoundError as missing:
        os.close(reading)
        raise ProcessError("there is no screen to draw on, and no Xvfb (apt package xvfb) to stand for one") from missing
    finally:
        os.close(writing)
    try:
        with os.fdopen(reading) as number:
            yield ":" + number.readline().strip()
    finally:
        screen.terminate()
        screen.wait()
