# SPDX-License-Identifier: BSD-3-Clause
"""Drives on a cluster: the outcomes that this machine's own processes have."""
from __future__ import annotations

import sys

import pytest

from safety_control_cloud.trials.__main__ import main
from safety_control_cloud.trials.run import drive_all, jobs_for

distributed = pytest.importorskip("distributed", reason="Dask is not installed (scripts/setup --with cluster)")

from safety_control_cloud import dask_crew


@pytest.mark.slow
def test_a_cluster_drives_as_one_process_does():
    jobs = jobs_for(2, 1, ["ours"], ["wall", "post"])
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        there = drive_all(jobs, 1, scheduler=cluster.scheduler_address)

    assert there == drive_all(jobs, 1)


def test_a_scheduler_that_is_not_there_is_exit_code_2_and_one_line(monkeypatch, capsys):
    monkeypatch.setattr(dask_crew, "ANSWERS", 1.0)
    monkeypatch.setattr(sys, "argv", ["trials", "--episodes", "1", "--scheduler", "tcp://127.0.0.1:9"])

    code = main()

    (said,) = filter(None, capsys.readouterr().err.splitlines())
    assert code == 2 and said.startswith("trials: no scheduler at tcp://127.0.0.1:9")
