# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that several command lines read in the same way."""
from __future__ import annotations

import argparse
from math import inf

from ..simulation.world_files import world_file, world_names


def picture_size(text: str) -> tuple[int, int]:
    """[px] of `640x480`."""
    width, height = text.split("x")
    return int(width), int(height)


def yes(text: str) -> bool:
    """roslaunch hands over `true` or `false`."""
    return text.strip().lower() in ("1", "true", "yes")


def count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return number


def positive(text: str) -> float:
    number = float(text)
    if not 0.0 < number < inf:
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return number


def camera_rate(text: str) -> float:
    """No more than one picture a tick of the simulators."""
    rate = positive(text)
    if rate > 100.0:
        raise argparse.ArgumentTypeError(f"{text} is more than 100")
    return rate


def not_negative(text: str) -> float:
    number = float(text)
    if not 0.0 <= number < inf:
        raise argparse.ArgumentTypeError(f"{text} is not 0 or a number above")
    return number


def world(name: str) -> str:
    """A user's file by its full path: roslaunch runs its nodes elsewhere."""
    try:
        return name if name in world_names() else str(world_file(name).resolve())
    except FileNotFoundError as error:
        raise argparse.ArgumentTypeError(str(error)) from error
