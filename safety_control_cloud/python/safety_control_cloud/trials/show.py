# SPDX-License-Identifier: BSD-3-Clause
"""A drive of ours or the tutorial's as moments for the viewer."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..pinhole import Pinhole
from ..view.memory import spots_in
from ..view.moment import Depth, Moment
from ..view.picture import depth_of
from .deciders import Decider, decider_for
from .episode import episode
from .outcome import Truth
from .scenario import XTION, Scenario

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

    from ..core import Decision


class Watched:
    """The same decider, and what it has decided on last."""

    def __init__(self, decider: Decider) -> None:
        self._decider = decider
        self.repeats = decider.repeats
        self.picture: Depth | None = None

    def decide(self, depth: NDArray[np.float32], stamp: float, now: float):
        column, row = XTION.centre
        self.picture = depth_of(depth, Pinhole(XTION.focal, XTION.focal, column, row))
        return self._decider.decide(depth, stamp, now)

    def without_cloud(self, now: float):
        return self._decider.without_cloud(now)

    @property
    def decision(self) -> Decision | None:
        """The tutorial's says no more than its verdict."""
        return getattr(self._decider, "decision", None)

    @property
    def remembered(self) -> list[str]:
        control = getattr(self._decider, "control", None)
        return control.remembered() if control else []


def record(scenario: Scenario, method: str, file: Path) -> None:
    """Drives it once more. Raises OSError."""
    from .. import core
    from ..view.sink import into_file

    watched = Watched(decider_for(method, scenario))
    with into_file(file, core.Settings(**dict(scenario.settings))) as sink:
        episode(scenario, method, lambda stage, truth: sink.show(moment_of(truth, watched)), watched)


def moment_of(truth: Truth, watched: Watched) -> Moment:
    decision, verdict = watched.decision, truth.verdict
    nearest = decision.nearest if decision else None
    reason = decision.reason if decision else "by the tutorial's algorithm" if watched.picture else "no cloud yet"
    return Moment(
        truth.time, verdict.zone, verdict.cause, reason, nearest.distance if nearest else None,
        nearest.point if nearest and np.isfinite(nearest.point).all() else None, verdict.speed, driven=truth.speed,
        picture=watched.picture, remembered=spots_in(watched.remembered))
