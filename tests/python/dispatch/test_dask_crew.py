# SPDX-License-Identifier: BSD-3-Clause
"""Against a real cluster of worker processes on this machine, some of which are killed."""
from __future__ import annotations

import os
import random
import signal
import threading
import time
from typing import Any, Iterator, List

import jobs
import pytest

distributed = pytest.importorskip("distributed", reason="Dask is not installed (scripts/setup --with cluster)")

from safety_control_cloud import dask_crew
from safety_control_cloud.dask_crew import TAKING, ClusterError, DaskCrew
from safety_control_cloud.dispatch import DEATHS, Fatal, shared_out


def version() -> str:
    return "1"


@pytest.fixture
def cluster() -> Iterator[Any]:
    with distributed.LocalCluster(n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None) as started:
        yield started


def crew_of(cluster: Any, refused: List[str]) -> DaskCrew:
    return DaskCrew(cluster.scheduler_address, version, refused.append)


def test_every_job_has_its_result(cluster):
    refused: List[str] = []
    with crew_of(cluster, refused) as crew:
        assert dict(shared_out(range(30), jobs.square, crew)) == {number: number**2 for number in range(30)}
    assert refused == []


def test_a_job_that_ends_its_worker_is_given_to_three_and_the_others_are_done(cluster):
    with crew_of(cluster, []) as crew:
        results = dict(shared_out([1, 2, -1, 3, 4], jobs.square, crew))

    assert results == {1: 1, 2: 4, 3: 9, 4: 16, -1: Fatal(DEATHS)}


@pytest.mark.slow
def test_jobs_whose_workers_are_killed_are_done_by_others(cluster):
    done = threading.Event()

    def kill() -> None:
        chance = random.Random(3)
        with distributed.Client(cluster) as client:
            for _ in range(5):
                done.wait(1.0)
                pids = list(client.run(os.getpid, on_error="ignore").values())
                if pids and not done.is_set():
                    os.kill(chance.choice(pids), signal.SIGKILL)

    killer = threading.Thread(target=kill)
    killer.start()
    with crew_of(cluster, []) as crew:
        results, times = {}, [time.monotonic()]
        for number, result in shared_out(range(200), jobs.square, crew):
            results[number] = result
            times.append(time.monotonic())
    done.set()
    killer.join()

    assert results == {number: number**2 for number in range(200)}
    assert max(later - earlier for earlier, later in zip(times, times[1:])) < TAKING / 2  # none waits for what a dead one had done


def test_workers_with_another_version_are_refused_by_name(cluster):
    refused: List[str] = []
    with DaskCrew(cluster.scheduler_address, jobs.other_version, refused.append) as crew:
        with pytest.raises(ClusterError, match="no worker with this version"):
            list(shared_out([1], jobs.square, crew))

    assert len(refused) == 3 and all("version of process" in line for line in refused)


def test_a_cluster_that_is_not_there_is_named(monkeypatch):
    monkeypatch.setattr(dask_crew, "ANSWERS", 1.0)
    with pytest.raises(ClusterError, match="tcp://127.0.0.1:9"):
        DaskCrew("tcp://127.0.0.1:9", version, print)


def test_a_cluster_without_workers_is_not_waited_for_without_end(monkeypatch):
    monkeypatch.setattr(dask_crew, "NONE_LEFT", 1.0)
    with distributed.LocalCluster(n_workers=0, dashboard_address=None) as empty, crew_of(empty, []) as crew:
        with pytest.raises(ClusterError, match="no worker"):
            list(shared_out([1], jobs.square, crew))
