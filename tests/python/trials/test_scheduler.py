# SPDX-License-Identifier: BSD-3-Clause
"""Drives on a cluster: the outcomes that this machine's own processes have."""
from __future__ import annotations

import subprocess
import sys

import pytest

from safety_control_cloud.trials.run import drive_all, jobs_for

distributed = pytest.importorskip("distributed", reason="Dask is not installed (scripts/setup --with cluster)")


@pytest.mark.slow
def test_a_cluster_drives_as_one_process_does():
    jobs = jobs_for(2, 1, ["ours"], ["wall", "post"])
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        there = drive_all(jobs, 1, scheduler=cluster.scheduler_address)

    assert there == drive_all(jobs, 1)


def test_a_scheduler_that_is_not_there_is_exit_code_2_and_one_line():
    result = subprocess.run(
        [sys.executable, "-m", "safety_control_cloud.trials", "--episodes", "1", "--scheduler", "tcp://127.0.0.1:9"],
        capture_output=True, text=True, timeout=120)

    assert result.returncode == 2 and "trials: no scheduler at tcp://127.0.0.1:9" in result.stderr
    assert "Traceback" not in result.stderr
