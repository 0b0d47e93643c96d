# SPDX-License-Identifier: BSD-3-Clause
"""A base that obeys late and changes each axis at a rate of its own, driven in small steps."""
from dataclasses import dataclass, field
from math import cos, hypot, sin
from typing import Callable, List, Tuple

import numpy as np

from safety_control_cloud import core

Twist = Tuple[float, float, float]


@dataclass
class Base:
    law: core.Law
    twist: Twist = (0.0, 0.0, 0.0)
    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0
    time: float = 0.0
    commands: List[Tuple[float, Twist]] = field(default_factory=list)

    def command(self, twist: Twist) -> None:
        """Obeyed from latency + base_reaction on."""
        self.commands.append((self.time + self.law.latency + self.law.base_reaction, twist))

    def under_way(self) -> List[Twist]:
        """What it does, and is about to do."""
        return [self.twist, *(twist for when, twist in self.commands if when > self.time - 1e-9)]

    def drive(self, duration: float, dt: float = 0.002) -> None:
        for _ in range(round(duration / dt)):
            before = self.twist
            self.twist = self.next_twist(dt)
            forward, left, turning = ((a + b) / 2 for a, b in zip(before, self.twist))
            heading = self.heading + turning * dt / 2
            self.x += dt * (forward * cos(heading) - left * sin(heading))
            self.y += dt * (forward * sin(heading) + left * cos(heading))
            self.heading += turning * dt
            self.time += dt

    def next_twist(self, dt: float) -> Twist:
        due = [twist for when, twist in self.commands if when <= self.time + 1e-9]
        wanted = due[-1] if due else self.twist
        difference = [b - a for a, b in zip(self.twist, wanted)]
        linear = hypot(*difference[:2]) / (self.law.linear_deceleration * dt)
        angular = abs(difference[2]) / (self.law.angular_deceleration * dt)
        shares = [min(1, 1 / linear) if linear else 1] * 2 + [min(1, 1 / angular) if angular else 1]
        return tuple(a + share * d for a, share, d in zip(self.twist, shares, difference))

    def seen_from(self, points: np.ndarray) -> np.ndarray:
        """(N, 2) resting points of the world, in base_frame."""
        away = points - (self.x, self.y)
        ahead, left = np.array([cos(self.heading), sin(self.heading)]), np.array([-sin(self.heading), cos(self.heading)])
        return np.column_stack([away @ ahead, away @ left])
