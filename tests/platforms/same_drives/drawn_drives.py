# SPDX-License-Identifier: BSD-3-Clause
"""Which drives both simulators do: the trials' walls and furniture, and none whose end a centimetre decides."""
from __future__ import annotations

from dataclasses import replace
from itertools import count, cycle, islice
from math import cos, sin
from typing import Iterator

from safety_control_cloud.simulation.furniture import Place, Shape
from safety_control_cloud.simulation.furniture import Thing as Furniture
from safety_control_cloud.trials.families import furniture, scenario_of, walls
from safety_control_cloud.trials.families.draft import CORRIDOR
from safety_control_cloud.trials.scenario import Scenario
from safety_control_cloud.trials.things import Thing

# In the others somebody walks or turns the robot, things move, surfaces or the camera return nothing, or the way is free.
FAMILIES = (*walls.FAMILIES, *furniture.FAMILIES)
EDGE = 0.06  # [m] from the corridor's sides: what ends there is in the way or not by what the robot strays
SECONDS = 30.0  # the longest that a drive may last: it is to end by standing


def drawn(episodes: int, seed: int) -> list[Scenario]:
    """`episodes`, shared out among FAMILIES; in each, the seeds from `seed` upward that fit."""
    fitting = {family: _fitting(family, seed) for family in FAMILIES}
    return [next(fitting[family]) for family in islice(cycle(FAMILIES), episodes)]


def without_faults(scenario: Scenario) -> Scenario:
    """With a camera like Gazebo's, that returns nothing from what is too near."""
    return replace(scenario, stray=0.0, seconds=SECONDS)


def is_clear_of_the_edge(scenario: Scenario) -> bool:
    """Whether nothing ends within EDGE of the corridor's sides, as seen from above."""
    return all(abs(y - edge) > EDGE for thing in scenario.things for y in _ends(thing) for edge in CORRIDOR)


def scene_of(scenario: Scenario) -> Furniture:
    """All that stands in it, as one model for Gazebo."""
    return Furniture(scenario.name.replace(":", "_"), Place(), tuple(map(_shape, scenario.things)))


def _fitting(family: str, seed: int) -> Iterator[Scenario]:
    scenarios = (without_faults(scenario_of(family, number)) for number in count(seed))
    return filter(is_clear_of_the_edge, scenarios)


def _ends(thing: Thing) -> Iterator[float]:
    """y [m] in the world of a box's corners, and of a cylinder's sides."""
    _, y = thing.place(0.0)
    length, width, _ = thing.size
    for side in (-0.5, 0.5):
        if thing.round:
            yield y + side * length
        else:
            for end in (-0.5, 0.5):
                yield y + end * length * sin(thing.at.yaw) + side * width * cos(thing.at.yaw)


def _shape(thing: Thing) -> Shape:
    length, width, height = thing.size
    x, y = thing.place(0.0)
    place = Place(x, y, thing.bottom + height / 2, thing.at.yaw)
    if thing.round:
        return Shape(thing.name, "cylinder", (length / 2, height / 2), place)
    return Shape(thing.name, "box", (length / 2, width / 2, height / 2), place)
