# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that several command lines read in the same way."""
from __future__ import annotations


def picture_size(text: str) -> tuple[int, int]:
    """[px] of `640x480`."""
    width, height = text.split("x")
    return int(width), int(height)


def yes(text: str) -> bool:
    """roslaunch hands over `true` or `false`."""
    return text.strip().lower() in ("1", "true", "yes")
