# SPDX-License-Identifier: BSD-3-Clause
"""Where something looks, from above."""
from __future__ import annotations

from math import atan2
from typing import Any


def heading_of(turn: Any) -> float:
    """[rad] of a quaternion with x, y, z and w, whoever's message it is; as in ros/input/poses.cpp."""
    return atan2(2.0 * (turn.w * turn.z + turn.x * turn.y), 1.0 - 2.0 * (turn.y * turn.y + turn.z * turn.z))
