# SPDX-License-Identifier: BSD-3-Clause
"""Measuring several things in turn, and what several measurements of one thing come to."""
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Callable, Dict, Hashable, Iterable, List, Optional, Sequence, TypeVar

Case = TypeVar("Case", bound=Hashable)
Result = TypeVar("Result")


@dataclass(frozen=True)
class Plan:
    """How much is measured."""

    quick: bool  # VGA only
    repetitions: int
    clouds: int  # of one repetition, where processes exchange them
    highway: bool = True  # in the kernel, if it is installed
    peer: Optional[Path] = None  # safety_limiter's program, to be measured beside the guard


def in_turn(
    cases: Sequence[Case], plan: Plan, measure: Callable[[Case], Result], done: Callable[[], None]
) -> Dict[Case, List[Result]]:
    """Every case once, then every case again: what disturbs the machine for a while disturbs all a little."""
    results: Dict[Case, List[Result]] = defaultdict(list)
    for _ in range(plan.repetitions):
        for case in cases:
            results[case].append(measure(case))
            done()
    return results


@dataclass(frozen=True)
class Timing:
    """[ms], or what else was measured several times."""

    median: float
    fastest: float
    slowest: float

    @property
    def spread(self) -> float:
        """Between the fastest and the slowest, as a share of the median."""
        return (self.slowest - self.fastest) / self.median if self.median else 0.0


def timing_of(values: Sequence[float]) -> Timing:
    return Timing(median(values), min(values), max(values))


def worst_and_median(ratios: Iterable[float], worst: Callable[[List[float]], float] = max) -> Dict[str, float]:
    """Of all cases. `worst` is min where more is better."""
    cases = list(ratios)
    return {"worst": round(worst(cases), 3), "median": round(median(cases), 3)}
