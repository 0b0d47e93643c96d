# SPDX-License-Identifier: BSD-3-Clause
"""What is near or lost from sight, out of the text in which the core keeps it (core/memory/kept.cpp)."""
from __future__ import annotations

from typing import TYPE_CHECKING, Iterator, List, Sequence

import numpy as np

from safety_control_cloud.view.moment import nothing

if TYPE_CHECKING:
    from numpy.typing import NDArray

VERSION = "things-4"
OTHERS = ("places", "touched")  # what a guard remembers around the robot, by odometry, and what it touches
BEFORE_POSES = 3  # width, height, blind range
POSE, BEFORE_SPOTS, SPOT = 9, 2, 10  # words


def spots_in(texts: Sequence[str]) -> NDArray[np.float32]:
    """(N, 3) [m]; empty where a text is not understood."""
    try:
        found = [spot for text in texts if not text.startswith(OTHERS) for spot in _spots(text)]
    except (StopIteration, RuntimeError, ValueError):
        return nothing()
    return np.array(found, np.float32).reshape(-1, 3)


def _spots(text: str) -> List[List[float]]:
    """Before it stands whose it is, of a guard, where its corridor leads, and in which frame its places are."""
    found: List[List[float]] = []
    _, version, rest = text.partition(VERSION)
    if text and not version:
        raise ValueError("another version")
    words = iter(rest.split())
    _take(words, BEFORE_POSES)
    _take(words, POSE * int(next(words, "0")))
    for _ in range(int(next(words, "0"))):
        _take(words, BEFORE_SPOTS)
        for _ in range(int(next(words))):
            found.append([float(word) for word in _take(words, SPOT)[2:5]])
    return found


def _take(words: Iterator[str], count: int) -> List[str]:
    return [word for _, word in zip(range(count), words)]
