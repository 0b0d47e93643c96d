# SPDX-License-Identifier: BSD-3-Clause
"""The robot's hull, and what it touches among upright things, by geometry: for Gazebo, which tells ROS of no contact."""
from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, sin
from typing import Iterable, Iterator

from .base import Pose
from .furniture import Shape, Thing

BASE_LINK = 0.0102  # [m] above base_footprint
BODY_RADIUS = 0.178  # [m] Kobuki
BODY_HEIGHT = 0.109  # [m]
BODY_CENTRE = BASE_LINK + 0.0595  # [m] above the floor: 15 mm of ground clearance
TOWER_RADIUS = 0.16  # [m] of all that stands on the Kobuki
PLATES = (0.142, 0.199, 0.402)  # [m] above the floor; the Xtion stands on the middle one, the top one lies above it

_CYLINDERS = (  # radius, lowest, highest [m]: the Kobuki, and the tower of plates upon it
    (BODY_RADIUS, BODY_CENTRE - BODY_HEIGHT / 2, BODY_CENTRE + BODY_HEIGHT / 2),
    (TOWER_RADIUS, PLATES[0], PLATES[-1]),
)


@dataclass(frozen=True)
class Rectangle:
    """Another hull than the TurtleBot's two cylinders: as high as they, seen from above in base_footprint [m]."""

    back: float  # x
    front: float  # x
    half_width: float

    @property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """Anticlockwise, as the parameter `footprint` has them."""
        return ((self.front, self.half_width), (self.back, self.half_width),
                (self.back, -self.half_width), (self.front, -self.half_width))


def touched(things: Iterable[Thing], robot: Pose, nearer_than: float = 0.0) -> tuple[str, ...]:
    """Names of the shapes whose distance from the hull is at most `nearer_than` [m]; the floor is none of them."""
    return tuple(name for name, distance in distances(things, robot) if distance <= nearer_than)


def distances(things: Iterable[Thing], robot: Pose) -> Iterator[tuple[str, float]]:
    """[m] over the floor from the hull to each shape as high as it; 0 or less: they overlap."""
    for thing in things:
        for shape in thing.shapes:
            if shape.kind == "plane":
                continue
            place = thing.place.of(shape.place)
            half = shape.size[-1]
            for radius, lowest, highest in _CYLINDERS:
                if place.z - half < highest and place.z + half > lowest:
                    yield shape.name, _from_axis(shape, place, robot) - radius


def _from_axis(shape: Shape, place: Place, robot: Pose) -> float:
    """[m] over the floor from the robot's axis to the shape; 0 within it."""
    x, y = robot.x - place.x, robot.y - place.y
    if shape.kind == "cylinder":
        return max(0.0, hypot(x, y) - shape.size[0])
    c, s = cos(place.yaw), sin(place.yaw)
    return hypot(max(0.0, abs(c * x + s * y) - shape.size[0]), max(0.0, abs(c * y - s * x) - shape.size[1]))
