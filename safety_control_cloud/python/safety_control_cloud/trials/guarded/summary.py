# SPDX-License-Identifier: BSD-3-Clause
"""What many guarded drives come to, family by family."""
from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from math import nan

import numpy as np

from ..summary import by_family, without_nan
from .outcome import IN_VIEW, KINDS, Outcome


@dataclass(frozen=True)
class Row:
    """Of one method in one family."""

    family: str
    method: str
    drives: int
    metres: float  # driven
    touches: dict[str, int]  # by kind
    share: float  # mean of given over greatest safe factor, where it was to go forward
    share_seeing: float  # the same, at moments at which nothing was lost from sight
    share_elsewhere: float  # where it was to turn in place or go backward
    whole: float  # of the moments at which all of a wish to go forward was safe: passed equal in every bit
    whole_seeing: float  # the same, without those at which something was lost from sight
    polite: int  # drives in which the driver alone arrives and keeps the margin
    stuck: int  # of them, those that did not arrive
    time_lost_median: float  # of the time without a guard, as a share
    time_lost_p90: float


def rows(outcomes: Sequence[Outcome]) -> list[Row]:
    """One for each family and method, in the order in which they come, and last those of ALL."""
    return by_family(outcomes, row)


def row(family: str, method: str, outcomes: Sequence[Outcome]) -> Row:
    kinds = [touch.kind for one in outcomes for touch in one.touches]
    late = [one.time_lost for one in outcomes if one.time_lost is not None]
    safe, whole, lost = (sum(getattr(one, name) for one in outcomes) for name in ("safe", "whole", "lost"))
    return Row(
        family, method, len(outcomes), sum(one.metres for one in outcomes), {kind: kinds.count(kind) for kind in KINDS},
        _mean(one.shares for one in outcomes), _mean(one.shares_seeing for one in outcomes),
        _mean(one.shares_elsewhere for one in outcomes), whole / safe if safe else nan,
        whole / (safe - lost) if safe > lost else nan, sum(one.is_polite for one in outcomes),
        sum(one.is_stuck for one in outcomes), float(np.median(late)) if late else nan,
        float(np.percentile(late, 90)) if late else nan)


def is_failure(outcome: Outcome) -> bool:
    """What no guard may let happen: a touch of what is in view, or that a polite driver does not arrive."""
    return outcome.is_stuck or any(touch.kind == IN_VIEW for touch in outcome.touches)


def to_json(outcomes: Sequence[Outcome]) -> str:
    """Rows and outcomes; what is not finite becomes null."""
    document = {"families": [asdict(one) for one in rows(outcomes)],
                "episodes": [{**asdict(one), "time_lost": one.time_lost} for one in outcomes]}
    return json.dumps(without_nan(document), indent=1, allow_nan=False)


def _mean(groups) -> float:
    values = [value for group in groups for value in group]
    return float(np.mean(values)) if values else nan
