# SPDX-License-Identifier: BSD-3-Clause
"""What many outcomes come to, family by family."""
from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from math import isfinite, nan
from typing import Any

import numpy as np

from .families import WITH_FAULTS
from .outcome import Outcome

ALL = "all"


@dataclass(frozen=True)
class Row:
    """Of one method in one family."""

    family: str
    method: str
    episodes: int
    collisions: int  # that the robot caused and a forward depth camera could have prevented
    at_limits: int  # that it caused, but no such camera shows
    clearance_p1: float  # [m] while the robot moved; nan where it never did
    clearance_median: float  # [m]
    false_stops: int  # episodes
    stuck: int  # episodes
    free_speed: float  # [m/s] mean while nothing was in the corridor


def is_collision(outcome: Outcome) -> bool:
    return outcome.collision is not None and not outcome.limit


def rows(outcomes: Sequence[Outcome]) -> list[Row]:
    """One for each family and method, in the order in which they come, and last those of ALL."""
    return by_family(outcomes, row)


def by_family(outcomes: Sequence[Any], row: Callable[[str, str, Sequence[Any]], Any]) -> list[Any]:
    """What row(family, method, outcomes) makes of the outcomes of each, and last of each method's in ALL."""
    keys = dict.fromkeys((one.family, one.method) for one in outcomes)
    methods = dict.fromkeys(one.method for one in outcomes)
    alike = {key: [one for one in outcomes if (one.family, one.method) == key] for key in keys}
    made = [row(family, method, drives) for (family, method), drives in alike.items()]
    return made + [row(ALL, method, [one for one in outcomes if one.method == method]) for method in methods]


def row(family: str, method: str, outcomes: Sequence[Outcome]) -> Row:
    clearances = [one.clearance for one in outcomes if isfinite(one.clearance)]
    p1, median = np.percentile(clearances, (1, 50)) if clearances else (nan, nan)
    seconds = sum(one.free_seconds for one in outcomes)
    return Row(
        family, method, len(outcomes), sum(map(is_collision, outcomes)),
        sum(one.collision is not None and bool(one.limit) for one in outcomes), float(p1), float(median),
        sum(one.false_stop is not None for one in outcomes), sum(one.stuck for one in outcomes),
        sum(one.free_metres for one in outcomes) / seconds if seconds else nan)


def sound(outcomes: Iterable[Outcome]) -> list[Outcome]:
    """Those of families in which the camera works: here standing without a cause is a fault."""
    return [one for one in outcomes if one.family not in WITH_FAULTS]


def to_json(outcomes: Sequence[Outcome]) -> str:
    """Rows and outcomes; what is not finite becomes null."""
    document = {"families": [asdict(one) for one in rows(outcomes)], "episodes": [asdict(one) for one in outcomes]}
    return json.dumps(without_nan(document), indent=1, allow_nan=False)


def without_nan(value):
    if isinstance(value, dict):
        return {key: without_nan(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [without_nan(one) for one in value]
    return None if isinstance(value, float) and not isfinite(value) else value
