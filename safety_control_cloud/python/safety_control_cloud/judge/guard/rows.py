# SPDX-License-Identifier: BSD-3-Clause
"""What is written in mode guard: answers, and a row for each bag."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence

import pyarrow as pa

from safety_control_cloud.judge.table import BAG, COUNTS, KEY, TIME, WORD, AnyBag, Mode
from safety_control_cloud.replay.guard.counts import Counts, zone_of
from safety_control_cloud.replay.guard.drive import Answer

MOTIONS = [(f"{what}_{part}", pa.float64()) for what in ("wanted", "given", "driven") for part in ("x", "y", "turn")]
ANSWERS = pa.schema([
    *KEY, ("number", pa.int64()), ("time", TIME), ("asked_by", WORD), *MOTIONS, ("factor", pa.float64()),
    ("time_to_contact", pa.float64()), ("zone", WORD), ("cause", WORD), ("reason", pa.string()), ("sensor", WORD),
    ("x", pa.float64()), ("y", pa.float64()), ("differs", pa.bool_()), ("stuck", pa.bool_())])
BAGS = pa.schema([
    *BAG, ("answers", pa.int64()), ("commands", pa.int64()), ("early", pa.int64()), ("passed", pa.int64()),
    ("scaled", pa.int64()), ("stopped", pa.int64()), ("causes", COUNTS), ("differs_at", TIME), ("differs_cause", pa.string()),
    ("differs_sensor", pa.string()), ("differs_for", pa.float64()), ("stopped_for", pa.float64()),
    ("warnings", pa.list_(pa.string()))])


@dataclass
class GuardedBag(AnyBag):
    """What became of a bag's commands: those after the first picture, as replay/guard counts them."""

    answers: int = 0
    commands: int = 0
    early: int = 0  # commands before the first picture
    passed: int = 0
    scaled: int = 0
    stopped: int = 0
    causes: Dict[str, int] = field(default_factory=dict)  # of all answers
    differs_at: Optional[int] = None  # [ns] of the bag, where something else is given than is wanted first
    differs_cause: Optional[str] = None
    differs_sensor: Optional[str] = None
    differs_for: float = 0.0  # [s] in all
    stopped_for: float = 0.0  # [s] of them, in which nothing is given
    warnings: List[str] = field(default_factory=list)

    @property
    def rows(self) -> int:
        return self.answers

    def note(self, counts: Counts) -> None:
        for name in ("answers", "commands", "early", "passed", "scaled", "stopped"):
            setattr(self, name, getattr(counts, name))
        self.causes = dict(counts.causes)
        self.differs_for, self.stopped_for = counts.differing / 1e9, counts.standing / 1e9
        if counts.first:
            self.differs_at, self.differs_cause = counts.first.time, counts.first.cause
            self.differs_sensor = counts.first.sensor or None


def row_of(number: int, answer: Answer) -> Sequence[Any]:
    driven, point = answer.driven or (None,) * 3, answer.point or (None,) * 2
    return (
        number, answer.time, answer.asked_by, *_planar(answer.wanted), *_planar(answer.given), *driven, answer.factor,
        answer.time_to_contact, zone_of(answer), answer.cause, answer.reason, answer.sensor or None, *point, answer.differs,
        answer.stuck)


def _planar(numbers: Sequence[float]) -> Sequence[float]:
    return (numbers[0], numbers[1], numbers[5])


GUARD = Mode("guard", "guard", "answers", "answers", GuardedBag, BAGS)
