# SPDX-License-Identifier: BSD-3-Clause
"""Processes on this machine."""
from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from concurrent.futures import Future
from multiprocessing.connection import Connection
from typing import Any, Callable, Dict, List, Set, Tuple

import safety_control_cloud
from safety_control_cloud.dispatch import WorkerDied


class LocalCrew:
    """So many processes for as long as the block lasts; one that dies is replaced."""

    def __init__(self, size: int) -> None:
        self._size, self._born = size, 0
        self._workers: Dict[str, _Worker] = {}

    def __enter__(self) -> LocalCrew:
        return self

    def __exit__(self, *error: Any) -> None:
        for worker in self._workers.values():
            worker.end()

    def present(self) -> Set[str]:
        while len(self._workers) < self._size:
            self._born += 1
            self._workers[f"process {self._born}"] = _Worker()
        return set(self._workers)

    def start(self, worker: str, function: Callable[[Any], Any], job: Any) -> Future:
        return self._workers[worker].start(function, job)

    def result(self, worker: str, future: Future) -> Any:
        try:
            return future.result()
        except WorkerDied:
            self._workers.pop(worker).end()
            raise

    def abandon(self, future: Future) -> None:
        """Nothing of it is left."""


class _Worker:
    """One process, and a thread that waits for its answers."""

    def __init__(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._connection, its_end = context.Pipe()
        self._process = context.Process(
            target=_serve, args=(its_end, list(safety_control_cloud.__path__)), daemon=True)
        self._process.start()
        its_end.close()  # so that the end of the process is the end of what can be read

    def start(self, function: Callable[[Any], Any], job: Any) -> Future:
        future: Future = Future()
        threading.Thread(target=self._wait, args=(future, (function, job)), daemon=True).start()
        return future

    def end(self) -> None:
        self._process.kill()
        self._process.join()

    def _wait(self, future: Future, order: Tuple[Callable[[Any], Any], Any]) -> None:
        try:
            self._connection.send(order)
            fine, answer = self._connection.recv()
        except (EOFError, OSError):
            future.set_exception(WorkerDied("its process has ended"))
            return
        if fine:
            future.set_result(answer)
        else:
            future.set_exception(answer)


def _serve(connection: Connection, package: List[str]) -> None:
    be_a_worker(package)
    while True:
        try:
            function, job = connection.recv()
        except EOFError:
            return  # nobody asks any more
        try:
            answer = True, function(job)
        except Exception as error:
            answer = False, error
        connection.send(answer)


def be_a_worker(package: List[str]) -> None:
    """`package`: where the parent has it. In a catkin devel space a spawned process finds the sources alone."""
    safety_control_cloud.__path__ = package
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's to hear
    os.environ.setdefault("LP_NUM_THREADS", "1")  # Mesa would take every core for each process
