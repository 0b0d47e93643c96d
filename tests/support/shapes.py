# SPDX-License-Identifier: BSD-3-Clause
"""Random footprints, twists and points, and a distance to a footprint that is written for nothing but being plain."""
from dataclasses import dataclass
from math import pi
from typing import Tuple

import numpy as np

from safety_control_cloud import core

Corners = Tuple[Tuple[float, float], ...]


@dataclass(frozen=True)
class Shape:
    """A polygon, or a circle around the origin if it has no corners [m]."""

    corners: Corners = ()
    radius: float = 0.0
    margin: float = 0.0

    def footprint(self) -> core.Footprint:
        return core.Footprint(self.corners, self.radius, self.margin)


def distance(shape: Shape, points: np.ndarray) -> np.ndarray:
    """(N,) [m] from the shape without its margin, negative inside, of (N, 2) points."""
    if not shape.corners:
        return np.hypot(*points.T) - shape.radius
    nearest, crossings = np.full(len(points), np.inf), np.zeros(len(points), int)
    for start, end in zip(np.array(shape.corners), np.roll(shape.corners, -1, axis=0)):
        side = end - start
        share = np.clip((points - start) @ side / (side @ side), 0, 1)
        nearest = np.minimum(nearest, np.hypot(*(points - start - share[:, None] * side).T))
        with np.errstate(divide="ignore", invalid="ignore"):
            at = start[0] + (points[:, 1] - start[1]) / side[1] * side[0]
        crossings += ((start[1] > points[:, 1]) != (end[1] > points[:, 1])) & (points[:, 0] < at)
    return np.where(crossings % 2, -nearest, nearest)


def corners_of(array: np.ndarray) -> Corners:
    return tuple((float(x), float(y)) for x, y in array)


def star(random: np.random.Generator) -> Corners:
    """Convex or not, and the robot's origin inside or not."""
    count = random.integers(3, 9)
    angles = 2 * pi * (np.arange(count) + random.uniform(-0.4, 0.4, count)) / count
    radii = np.full(count, random.uniform(0.2, 1.0)) if random.random() < 0.4 else random.uniform(0.15, 1.0, count)
    middle = random.uniform(-1.5, 1.5, 2) if random.random() < 0.5 else np.zeros(2)
    corners = middle + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    return corners_of(corners[:: random.choice([-1, 1])])


def horseshoe(random: np.random.Generator) -> Corners:
    """Open at one side: a point may be in it and not touch it."""
    width, depth, wall = random.uniform(0.6, 1.2), random.uniform(0.6, 1.5), random.uniform(0.05, 0.2)
    half = width / 2
    corners = np.array(
        [(0, -half), (depth, -half), (depth, wall - half), (wall, wall - half)]
        + [(wall, half - wall), (depth, half - wall), (depth, half), (0, half)]
    )
    angle = random.uniform(-pi, pi)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return corners_of((corners + random.uniform(-1, 0.2, 2)) @ turn)


def random_shape(random: np.random.Generator) -> Shape:
    margin = float(random.choice([0.0, random.uniform(0, 0.3)]))
    kind = random.choice(["circle", "star", "horseshoe"], p=[0.2, 0.5, 0.3])
    if kind == "circle":
        return Shape(radius=random.uniform(0.05, 0.8), margin=margin)
    return Shape(star(random) if kind == "star" else horseshoe(random), margin=margin)


def random_twist(random: np.random.Generator) -> Tuple[float, float, float]:
    forward, left, turning = random.uniform(-2, 2, 3)
    forward = random.choice([forward, 0.0], p=[0.8, 0.2])
    left = random.choice([left, 0.0, 1e-9], p=[0.4, 0.5, 0.1])
    tiny = 10.0 ** random.uniform(-17, -3) * random.choice([-1, 1])
    turning = random.choice([turning, 0.0, tiny], p=[0.6, 0.2, 0.2])
    return float(forward), float(left), float(turning)
