# SPDX-License-Identifier: BSD-3-Clause
"""A camera's projection."""
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Pinhole:
    """Focal lengths and the middle [px]: column = fx x / z + cx, row = fy y / z + cy."""

    fx: float
    fy: float
    cx: float
    cy: float
