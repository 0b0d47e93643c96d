# SPDX-License-Identifier: BSD-3-Clause
"""The workers of a Dask cluster, wherever they run."""
from __future__ import annotations

import time
import uuid
from typing import Any, Callable, Dict, Set

from distributed import Client, Future, TimeoutError
from distributed.client import FutureCancelledError, FuturesCancelledError
from distributed.scheduler import KilledWorker

from safety_control_cloud.dispatch import ClusterError, WorkerDied

ANSWERS = 10.0  # [s] within which a scheduler does
NONE_LEFT = 60.0  # [s] that a cluster may be without a worker
TAKING = 30.0  # [s] that a result may take from its worker to here
LOOK = 1.0  # [s] after which it is asked whether the worker is still there


class DaskCrew:
    """Those workers of a cluster that have the same version; the others are refused, and `refused` names them."""

    def __init__(self, address: str, version: Callable[[], str], on_refusal: Callable[[str], None]) -> None:
        """Raises ClusterError."""
        try:
            self._client = Client(address, timeout=ANSWERS)
        except (OSError, ValueError) as error:
            raise ClusterError(f"no scheduler at {address}: {error}") from error
        self._version, self._on_refusal = version, on_refusal
        self._usable: Dict[str, bool] = {}
        self._last_seen = time.monotonic()

    def __enter__(self) -> DaskCrew:
        return self

    def __exit__(self, *error: Any) -> None:
        self._client.close()

    def present(self) -> Set[str]:
        """Raises ClusterError if there has been none for long."""
        there = set(self._client.nthreads())
        self._check([worker for worker in there if worker not in self._usable])
        usable = {worker for worker in there if self._usable.get(worker)}
        if usable:
            self._last_seen = time.monotonic()
        elif time.monotonic() - self._last_seen > NONE_LEFT or there and not self._one_may_come(there):
            raise ClusterError("the cluster has no worker with this version" if there else "the cluster has no worker")
        return usable

    def start(self, worker: str, function: Callable[[Any], Any], job: Any) -> Future:
        return self._client.submit(function, job, workers=[worker], allow_other_workers=False, pure=False,
                                   key=f"{function.__name__}-{uuid.uuid4().hex}")

    def result(self, worker: str, future: Future) -> Any:
        try:
            return self._taken_from(worker, future)
        except (KilledWorker, FutureCancelledError, FuturesCancelledError, TimeoutError) as error:
            self.abandon(future)
            raise WorkerDied(worker) from error
        finally:
            future.release()

    def _taken_from(self, worker: str, future: Future) -> Any:
        """A worker may die with what it has done; the scheduler would wait for another to do it."""
        deadline = time.monotonic() + TAKING
        while True:
            try:
                return future.result(timeout=LOOK)
            except TimeoutError:
                late = time.monotonic() > deadline or future.status == "error"  # the second: it is what the job raised
                if late or worker not in self._client.nthreads():
                    raise

    def abandon(self, future: Future) -> None:
        future.cancel()

    def _one_may_come(self, there: Set[str]) -> bool:
        return any(self._usable.get(worker, True) for worker in there)

    def _check(self, new: list) -> None:
        if not new:
            return
        own = self._version()
        for worker, its in self._client.run(self._version, workers=new, on_error="return").items():
            if isinstance(its, OSError):
                continue  # it is gone already, or not yet there
            self._usable[worker] = its == own
            if its != own:
                what = f"it has version {its}" if isinstance(its, str) else f"it has not this package: {its}"
                self._on_refusal(f"worker {worker} is refused: {what}, here it is {own}")
