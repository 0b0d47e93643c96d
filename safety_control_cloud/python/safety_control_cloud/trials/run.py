# SPDX-License-Identifier: BSD-3-Clause
"""Many drives, in as many processes as one likes: the outcomes are the same."""
from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import safety_control_cloud

from .families import FAMILIES
from .outcome import Outcome


@dataclass(frozen=True)
class Job:
    family: str
    seed: int
    method: str


def jobs_for(episodes: int, seed: int, methods: Sequence[str], families: Sequence[str] = ()) -> tuple[Job, ...]:
    """`episodes` of each method, shared out evenly among the families; in each, seeds from `seed` upward."""
    names = tuple(families) or tuple(FAMILIES)
    scenarios = [(names[i % len(names)], seed + i // len(names)) for i in range(episodes)]
    return tuple(Job(family, number, method) for family, number in scenarios for method in methods)


def drive(job: Job) -> Outcome:
    from .episode import episode  # brings MuJoCo: only where it is needed
    from .families import scenario_of

    return episode(scenario_of(job.family, job.seed), job.method)


def drive_all(
    jobs: Sequence[Job], workers: int, on_outcome: Callable[[Outcome], None] = lambda outcome: None
) -> list[Outcome]:
    """The outcomes in the order of the jobs. `on_outcome` hears of each as soon as it is there, in any order."""
    outcomes: dict[int, Outcome] = {}
    context, package = multiprocessing.get_context("spawn"), list(safety_control_cloud.__path__)
    with context.Pool(min(workers, len(jobs)) or 1, _be_a_worker, (package,)) as pool:
        for place, outcome in pool.imap_unordered(_numbered, list(enumerate(jobs))):
            outcomes[place] = outcome
            on_outcome(outcome)
    return [outcomes[place] for place in range(len(jobs))]


def _numbered(numbered: tuple[int, Job]) -> tuple[int, Outcome]:
    place, job = numbered
    return place, drive(job)


def _be_a_worker(package: list[str]) -> None:
    """`package`: where the parent has it. In a catkin devel space a spawned process finds the sources alone."""
    safety_control_cloud.__path__ = package
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's to hear
    os.environ.setdefault("LP_NUM_THREADS", "1")  # Mesa would take every core for each process
