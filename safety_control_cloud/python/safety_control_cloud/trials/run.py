# SPDX-License-Identifier: BSD-3-Clause
"""Many drives, in as many processes as one likes: the outcomes are the same."""
from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import safety_control_cloud

from ..dispatch import Fatal, Lost, shared_out
from ..local_crew import LocalCrew
from .families import DRIVEN, FAMILIES
from .outcome import Outcome

if TYPE_CHECKING:
    from .guarded.outcome import Outcome as Guarded


@dataclass(frozen=True)
class Job:
    family: str
    seed: int
    method: str
    driver: str = ""  # somebody else, whom the method guards; none: the method drives


class Interrupted(Exception):
    """Somebody ended it. `outcomes`: of the drives that were done, in the order of their jobs."""

    def __init__(self, outcomes: list[Outcome]) -> None:
        super().__init__(f"interrupted after {len(outcomes)} drives")
        self.outcomes = outcomes


def jobs_for(
    episodes: int, seed: int, methods: Sequence[str], families: Sequence[str] = (), driver: str = ""
) -> tuple[Job, ...]:
    """`episodes` of each method, shared out evenly among the families; in each, seeds from `seed` upward."""
    names = tuple(families) or tuple(DRIVEN[driver] if driver else FAMILIES)
    scenarios = [(names[i % len(names)], seed + i // len(names)) for i in range(episodes)]
    return tuple(Job(family, number, method, driver) for family, number in scenarios for method in methods)


def drive(job: Job) -> Outcome | Guarded:
    from .families import scenario_of

    scenario = scenario_of(job.family, job.seed)
    if job.driver:
        from .guarded.drive import guarded_drive

        return guarded_drive(scenario, job.method)
    from .episode import episode  # brings MuJoCo: only where it is needed

    return episode(scenario, job.method)


def drive_all(
    jobs: Sequence[Job], workers: int, on_outcome: Callable[[Outcome], None] = lambda outcome: None,
    scheduler: str | None = None, say: Callable[[str], None] = print
) -> list[Outcome]:
    """The outcomes in the order of the jobs. `on_outcome` hears of each as soon as it is there, in any order.

    Raises dispatch.Lost for a drive that its workers do not survive, dispatch.ClusterError, Interrupted.
    """
    outcomes: dict[Job, Outcome] = {}
    try:
        with _crew(min(workers, len(jobs)) or 1, scheduler, say) as crew:
            for job, outcome in shared_out(jobs, drive, crew):
                if isinstance(outcome, Fatal):
                    raise Lost(f"{outcome.deaths} workers died over {job.family}:{job.seed}, {job.method}")
                outcomes[job] = outcome
                on_outcome(outcome)
    except KeyboardInterrupt:
        raise Interrupted([outcomes[job] for job in jobs if job in outcomes]) from None
    return [outcomes[job] for job in jobs]


def version() -> str:
    """Of what drives: of the compiled core, and of all modules that a drive may come through."""
    from .. import core

    whole = hashlib.sha256(Path(core.__file__).read_bytes())
    for room in ("simulation", "trials"):
        for folder in {Path(place) / room for place in safety_control_cloud.__path__}:
            for file in sorted(folder.rglob("*.py")):
                whole.update(file.read_bytes())
    return whole.hexdigest()[:16]


@contextmanager
def _crew(workers: int, scheduler: str | None, say: Callable[[str], None]) -> Iterator[Any]:
    if scheduler:
        from ..dask_crew import DaskCrew  # Dask is needed here alone

        with DaskCrew(scheduler, version, say) as crew:
            yield crew
    else:
        with LocalCrew(workers) as crew:
            yield crew
