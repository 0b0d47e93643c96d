# SPDX-License-Identifier: BSD-3-Clause
"""Jobs shared out among workers that may die. One at a time to each: so it is known whose death was which job's."""
from __future__ import annotations

import queue
from collections import Counter, deque
from dataclasses import dataclass
from typing import Any, Callable, Dict, Generic, Iterable, Iterator, Protocol, Set, Tuple, TypeVar, Union

PATIENCE = 0.5  # [s] between two looks at who is still there
DEATHS = 3  # of workers that a job may cost

JobT = TypeVar("JobT")
ResultT = TypeVar("ResultT")


class WorkerDied(RuntimeError):
    """And its job with it."""


class ClusterError(RuntimeError):
    """The workers cannot be used. str() is one line that says why."""


class Lost(RuntimeError):
    """A job without a result. str() is one line that says why."""


@dataclass(frozen=True)
class Fatal:
    """In place of a result: the job has ended so many workers."""

    deaths: int


class Future(Protocol):
    def add_done_callback(self, callback: Callable[[Any], None]) -> Any: ...


class Crew(Protocol):
    """Workers, known by their names."""

    def present(self) -> Set[str]:
        """Those that can be given work; a name never comes back once it is gone."""

    def start(self, worker: str, function: Callable[[JobT], ResultT], job: JobT) -> Future: ...

    def result(self, worker: str, future: Any) -> Any:
        """Of a future that is done. Raises WorkerDied, or what the job raised."""

    def abandon(self, future: Any) -> None:
        """Its worker is gone."""


def shared_out(
    jobs: Iterable[JobT], function: Callable[[JobT], ResultT], crew: Crew
) -> Iterator[Tuple[JobT, Union[ResultT, Fatal]]]:
    """Each job with its result, in the order in which they are done. Raises what a job raises."""
    yield from _Sharing(jobs, function, crew).results()


class _Sharing(Generic[JobT, ResultT]):
    def __init__(self, jobs: Iterable[JobT], function: Callable[[JobT], ResultT], crew: Crew) -> None:
        self._waiting = deque(enumerate(jobs))
        self._function, self._crew = function, crew
        self._busy: Dict[str, Tuple[int, JobT, Any]] = {}
        self._done: "queue.SimpleQueue[str]" = queue.SimpleQueue()
        self._deaths: "Counter[int]" = Counter()

    def results(self) -> Iterator[Tuple[JobT, Union[ResultT, Fatal]]]:
        while self._waiting or self._busy:
            present = self._crew.present()
            for worker in [worker for worker in self._busy if worker not in present]:
                self._crew.abandon(self._busy[worker][2])
                yield from self._died(worker)
            for worker in sorted(present - set(self._busy))[: len(self._waiting)]:
                self._give(worker)
            try:
                worker = self._done.get(timeout=PATIENCE)
            except queue.Empty:
                continue
            if worker in self._busy:
                yield from self._taken_from(worker)

    def _give(self, worker: str) -> None:
        number, job = self._waiting.popleft()
        future = self._crew.start(worker, self._function, job)
        self._busy[worker] = number, job, future
        future.add_done_callback(lambda future: self._done.put(worker))

    def _taken_from(self, worker: str) -> Iterator[Tuple[JobT, Union[ResultT, Fatal]]]:
        _, job, future = self._busy[worker]
        try:
            result = self._crew.result(worker, future)
        except WorkerDied:
            yield from self._died(worker)
            return
        del self._busy[worker]
        yield job, result

    def _died(self, worker: str) -> Iterator[Tuple[JobT, Union[ResultT, Fatal]]]:
        number, job, _ = self._busy.pop(worker)
        self._deaths[number] += 1
        if self._deaths[number] >= DEATHS:
            yield job, Fatal(self._deaths[number])
        else:
            self._waiting.append((number, job))
