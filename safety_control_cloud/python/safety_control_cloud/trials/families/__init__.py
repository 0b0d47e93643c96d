# SPDX-License-Identifier: BSD-3-Clause
"""The families of scenarios, by name. Each draws a scenario from a random generator."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from ..scenario import Scenario, random_of
from . import furniture, nothing_returned, people, places, polite, rude, sensor, side, walls
from .draft import Draft, Draw

MODULES = (walls, furniture, side, people, nothing_returned, sensor, places)
FAMILIES: dict[str, Callable[[Draw], Draft]] = {
    name: draw for module in MODULES for name, draw in module.FAMILIES.items()
}
DRIVEN: dict[str, dict[str, Callable[[Draw], Draft]]] = {"rude": rude.FAMILIES, "polite": polite.FAMILIES}
"""By the driver, who is somebody else."""
WITH_FAULTS = frozenset(sensor.FAMILIES)  # here the robot may stand though the corridor is free


def scenario_of(family: str, seed: int) -> Scenario:
    """The scenario number `seed` of a family. Raises KeyError for a family that is not there."""
    draw = Draw(random_of(family, seed))
    draft = {**FAMILIES, **DRIVEN["rude"], **DRIVEN["polite"]}[family](draw)
    parts = {name: value for name, value in vars(draft).items() if value is not None}
    drawn = Scenario(family, seed, processing=draw.between(0.005, 0.03), stray=_stray(family, seed), **parts)
    return replace(drawn, facts=draw.facts)


def _stray(family: str, seed: int) -> float:
    """From one in a thousand, as often as one in ten."""
    return float(10 ** random_of(family, seed, purpose=3).uniform(-3.0, -1.0))
