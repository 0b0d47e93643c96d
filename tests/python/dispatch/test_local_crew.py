# SPDX-License-Identifier: BSD-3-Clause
import multiprocessing
import random
import threading
import time

import jobs
import pytest

from safety_control_cloud.dispatch import DEATHS, Fatal, shared_out
from safety_control_cloud.local_crew import LocalCrew


def test_every_job_has_its_result():
    with LocalCrew(2) as crew:
        assert dict(shared_out(range(10), jobs.square, crew)) == {number: number**2 for number in range(10)}


def test_a_job_that_ends_its_worker_is_given_to_three_and_the_others_are_done():
    with LocalCrew(2) as crew:
        results = dict(shared_out([1, 2, -1, 3, 4, -2, 5], jobs.square, crew))

    assert results == {**{number: number**2 for number in range(1, 6)}, -1: Fatal(DEATHS), -2: Fatal(DEATHS)}


def test_jobs_whose_workers_are_killed_are_done_by_others():
    with LocalCrew(3) as crew:
        done = threading.Event()

        def kill() -> None:
            chance = random.Random(7)
            for _ in range(6):
                done.wait(0.7)
                workers = multiprocessing.active_children()
                if workers and not done.is_set():
                    chance.choice(workers).kill()

        killer = threading.Thread(target=kill)
        killer.start()
        results = dict(shared_out(range(100), jobs.square, crew))
        done.set()
        killer.join()

    assert results == {number: number**2 for number in range(100)}


def test_what_a_job_raises_is_raised_here():
    with LocalCrew(1) as crew, pytest.raises(ZeroDivisionError):
        list(shared_out([1], jobs.fail, crew))


def test_no_process_outlives_the_crew():
    with LocalCrew(2) as crew:
        results = shared_out(range(1000), jobs.square, crew)
        next(results)

    deadline = time.monotonic() + 10
    while multiprocessing.active_children() and time.monotonic() < deadline:
        time.sleep(0.05)
    assert multiprocessing.active_children() == []
