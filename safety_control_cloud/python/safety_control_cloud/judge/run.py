# SPDX-License-Identifier: BSD-3-Clause
"""From bags to the store, whoever judges them."""
from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, Iterator, List, Mapping, Optional, Sequence

from safety_control_cloud.dispatch import Fatal, shared_out
from safety_control_cloud.judge.bag import Job, Judged, judge_bag, mode_of
from safety_control_cloud.judge.choice import Choice
from safety_control_cloud.judge.identity import hash_of_settings, version
from safety_control_cloud.judge.store import Store
from safety_control_cloud.judge.table import AnyBag
from safety_control_cloud.replay.parameters import settings_of

OnDone = Callable[[Sequence[AnyBag]], None]


@dataclass(frozen=True)
class Request:
    bags: Sequence[str]
    out: Path
    settings: Sequence[Mapping[str, Any]] = field(default_factory=lambda: ({},))  # what differs from the defaults
    choice: Choice = Choice()
    jobs: int = 1
    scheduler: Optional[str] = None


def judge(request: Request, on_done: OnDone, say: Callable[[str], None]) -> List[AnyBag]:
    """A row for each bag and setting; `on_done` hears of each bag's. What has been judged is in the store, however this ends.

    Raises OSError if the store cannot be written, dask_crew.ClusterError.
    """
    whole = {hash_of_settings(given, request.choice): settings_of(given).as_dict() for given in request.settings}
    store = Store(request.out, whole, mode_of(request.settings))
    rows: List[AnyBag] = []
    try:
        with _crew(request, say) as crew:
            for job, judged in shared_out(_jobs(request, store), judge_bag, crew):
                its = _kept(store, job, judged)
                rows += its
                on_done(its)
    finally:
        store.write_bags(rows)
    return rows


def _jobs(request: Request, store: Store) -> Iterator[Job]:
    folder = "" if request.scheduler else str(store.rows.absolute())
    for path in request.bags:
        known = store.known(path)
        yield Job(path, tuple(request.settings), request.choice, known, store.have(known[1]) if known else (), folder)


def _kept(store: Store, job: Job, judged: Any) -> List[AnyBag]:
    if isinstance(judged, Fatal):
        judged = Judged(job.path, error=f"{judged.deaths} workers died over {job.path}")
    store.keep(judged)
    return store.rows_of(judged)


@contextmanager
def _crew(request: Request, say: Callable[[str], None]) -> Iterator[Any]:
    if request.scheduler:
        from safety_control_cloud.dask_crew import DaskCrew  # Dask is needed here alone

        with DaskCrew(request.scheduler, version, say) as crew:
            yield crew
    else:
        from safety_control_cloud.local_crew import LocalCrew

        with LocalCrew(min(request.jobs, len(request.bags)) or 1) as crew:
            yield crew
