# SPDX-License-Identifier: BSD-3-Clause
"""What stands in a world, read from its MJCF without MuJoCo: boxes and cylinders that stand upright, and the floor.

A small part of MJCF, for where MuJoCo is not: what lies outside it is refused, not passed over.
"""
from __future__ import annotations

from dataclasses import dataclass
from math import cos, radians, sin
from pathlib import Path
from typing import Iterator
from xml.etree import ElementTree

from .base import Pose
from .world_files import START

Element = ElementTree.Element
Colour = "tuple[float, float, float, float]"

BOXES = 8  # how many dropped boxes can stand about; the next one takes the oldest's place
BOX_SIDE = 0.3  # [m]
BOX_COLOUR = (0.80, 0.55, 0.28, 1.0)
GREY = (0.6, 0.6, 0.6, 1.0)  # of what has no colour of its own, or a texture
_TURNED_OTHERWISE = ("quat", "axisangle", "xyaxes", "zaxis", "fromto")
_SIZES = {"box": 3, "cylinder": 2, "plane": 3}  # how many numbers; a plane's are only those of its looks


@dataclass(frozen=True)
class Place:
    """Upright, turned about z only."""

    x: float = 0.0  # [m]
    y: float = 0.0  # [m]
    z: float = 0.0  # [m]
    yaw: float = 0.0  # [rad]

    def of(self, inner: Place) -> Place:
        """Where `inner`, given in this place's frame, is in the frame of this place."""
        c, s = cos(self.yaw), sin(self.yaw)
        return Place(
            self.x + c * inner.x - s * inner.y, self.y + s * inner.x + c * inner.y,
            self.z + inner.z, self.yaw + inner.yaw)


@dataclass(frozen=True)
class Shape:
    name: str
    kind: str  # box, cylinder or plane
    size: tuple[float, ...]  # [m] half lengths in x, y, z; or radius and half length
    place: Place  # of its centre, in its thing
    colour: Colour = GREY


@dataclass(frozen=True)
class Thing:
    """Shapes that move together."""

    name: str
    place: Place
    shapes: tuple[Shape, ...]


@dataclass(frozen=True)
class Furniture:
    start: Pose  # where the world wants the robot
    things: tuple[Thing, ...]


def furniture_of(mjcf: Path) -> Furniture:
    """Raises ValueError for what this module does not understand, and ElementTree.ParseError for what is no XML."""
    roots = list(_with_includes(mjcf))
    in_radians = any(compiler.get("angle") == "radian" for root in roots for compiler in root.iter("compiler"))
    if any(root.find("default") is not None for root in roots):
        raise ValueError(f"{mjcf}: <default> is not understood")
    reader = _Reader(1.0 if in_radians else radians(1), _colours(roots))
    bodies = [element for root in roots for world in root.findall("worldbody") for element in world]
    starts = [body for body in bodies if body.tag == "site" and body.get("name") == START]
    place = reader.place(starts[0]) if starts else Place()
    return Furniture(Pose(place.x, place.y, place.yaw), tuple(reader.things(bodies)))


def _with_includes(path: Path) -> Iterator[Element]:
    root = ElementTree.parse(path).getroot()
    for include in root.iter("include"):
        yield from _with_includes(path.parent / include.get("file", ""))
    yield root


def _colours(roots: list[Element]) -> dict[str, Colour]:
    materials = [material for root in roots for material in root.iter("material")]
    return {material.get("name", ""): _numbers(material, "rgba", GREY) for material in materials}


def _numbers(element: Element, name: str, default: tuple[float, ...]) -> tuple[float, ...]:
    text = element.get(name)
    return default if text is None else tuple(map(float, text.split()))


@dataclass(frozen=True)
class _Reader:
    angle: float  # [rad] that a unit of the file's angles is
    colours: dict[str, Colour]

    def things(self, elements: list[Element]) -> Iterator[Thing]:
        """A geom that stands in the world itself is a thing of its own, as each body is."""
        for element in elements:
            if element.tag == "geom":
                shape = self.shape(element, Place())
                yield Thing(shape.name, Place(), (shape,))
            elif element.tag == "body":
                yield Thing(element.get("name", "thing"), self.place(element), tuple(self.shapes(element, Place())))

    def shapes(self, body: Element, at: Place) -> Iterator[Shape]:
        for element in body:
            if element.tag == "geom":
                yield self.shape(element, at)
            elif element.tag == "body":
                yield from self.shapes(element, at.of(self.place(element)))

    def shape(self, geom: Element, at: Place) -> Shape:
        kind, name = geom.get("type", "sphere"), geom.get("name", "thing")
        size = _numbers(geom, "size", ())
        if kind not in _SIZES or len(size) != _SIZES[kind]:
            raise ValueError(f"{name}: only a box, a cylinder or a plane with its size is understood, not a {kind}")
        colour = _numbers(geom, "rgba", self.colours.get(geom.get("material", ""), GREY))
        return Shape(name, kind, size, at.of(self.place(geom)), colour)

    def place(self, element: Element) -> Place:
        turn = _numbers(element, "euler", (0.0, 0.0, 0.0))
        if any(element.get(name) for name in _TURNED_OTHERWISE) or any(turn[:2]):
            raise ValueError(f"{element.get('name')}: only what stands upright is understood, turned by euler about z")
        return Place(*_numbers(element, "pos", (0.0, 0.0, 0.0)), turn[2] * self.angle)
