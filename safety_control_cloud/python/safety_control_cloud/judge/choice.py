# SPDX-License-Identifier: BSD-3-Clause
"""Which topics of a bag."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple


@dataclass(frozen=True)
class Choice:
    """As the user names them; what is not named is what the node would look at, or by its type and name."""

    topics: Tuple[str, ...] = ()  # in mode guard of its sensors
    cmd_vel: Optional[str] = None  # mode guard
    odom: Optional[str] = None
