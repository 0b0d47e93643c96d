# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that several command lines read in the same way."""
from __future__ import annotations

import argparse
from math import inf

LARGEST_SIDE = 4096  # [px] of a simulated picture, whose cloud is then of half a gigabyte


def picture_size(text: str) -> tuple[int, int]:
    """[px] of `640x480`."""
    width, height = map(count, text.split("x"))
    if max(width, height) > LARGEST_SIDE:
        raise argparse.ArgumentTypeError(f"{text} is more than {LARGEST_SIDE}x{LARGEST_SIDE}")
    return width, height


def yes(text: str) -> bool:
    """roslaunch hands over `true` or `false`."""
    return text.strip().lower() in ("1", "true", "yes")


def count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return number


def seed(text: str) -> int:
    """Of random numbers, which numpy wants from no other."""
    number = int(text)
    if number < 0:
        raise argparse.ArgumentTypeError(f"{text} is below 0")
    return number


def positive(text: str) -> float:
    number = float(text)
    if not 0.0 < number < inf:
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return number


def not_negative(text: str) -> float:
    number = float(text)
    if not 0.0 <= number < inf:
        raise argparse.ArgumentTypeError(f"{text} is not 0 or a number above")
    return number


def parameter(text: str) -> tuple[str, str]:
    """A private parameter of a node, as `danger_distance=0.6`."""
    name, equals, value = text.partition("=")
    if not (name and equals and value):
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE")
    return name.lstrip("~_"), value
