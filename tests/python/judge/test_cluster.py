# SPDX-License-Identifier: BSD-3-Clause
"""Bags on an S3 server, judged by a cluster whose workers are killed: the same rows as one process gives."""
from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Dict, Iterator, List

import pyarrow.parquet as pq
import pytest
from drives import wall, write_drive
from guard_drives import driven_at_wall

distributed = pytest.importorskip("distributed", reason="Dask is not installed (scripts/setup --with cluster)")
s3fs = pytest.importorskip("s3fs", reason="s3fs is not installed (scripts/setup --with s3)")
pytest.importorskip("upath", reason="universal_pathlib is not installed (scripts/setup --with s3)")

COMMAND = [sys.executable, "-m", "safety_control_cloud.judge"]
COMPARED = ("topic", "number", "time", "stamp", "zone", "cause", "reason", "nearest", "speed", "inside", "returns", "total")
BAGS, DAMAGED = 40, 3


@pytest.fixture(scope="module")
def server() -> Iterator[Dict[str, str]]:
    """What leads to an S3 server that runs here, in the environment; it has a bucket."""
    server = pytest.importorskip("moto.server", reason="moto is not installed (scripts/setup --checks)").ThreadedMotoServer(
        ip_address="127.0.0.1", port=0)
    server.start()
    host, port = server.get_host_and_port()
    environment = {"AWS_ENDPOINT_URL": f"http://{host}:{port}", "AWS_ACCESS_KEY_ID": "test",
                   "AWS_SECRET_ACCESS_KEY": "test", "AWS_DEFAULT_REGION": "us-east-1"}
    with pytest.MonkeyPatch.context() as patch:
        for name, value in environment.items():
            patch.setenv(name, value)
        s3fs.S3FileSystem().mkdir("bags")
    yield environment
    server.stop()


@pytest.fixture
def bucket(server, monkeypatch) -> str:
    for name, value in server.items():
        monkeypatch.setenv(name, value)
    return "s3://bags"


@pytest.fixture(scope="module")
def drives(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("drives")
    for number in range(BAGS):
        write_drive(folder / f"{number:03}.bag", [wall(0.05 * n, 1.6 - 0.01 * n - 0.002 * number) for n in range(40)])
    for number in range(DAMAGED):
        whole = bytearray((folder / f"{number:03}.bag").read_bytes())
        whole[len(whole) // 3 : len(whole) // 3 + 500] = bytes(500)
        (folder / f"{number:03}.bag").write_bytes(whole)
    return folder


def judge(*arguments: Any) -> subprocess.CompletedProcess:
    return subprocess.run([*COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=500)


def clouds(out: Path) -> Dict[str, List[tuple]]:
    """The rows of each bag by its name."""
    found = {}
    for row in pq.read_table(out / "bags.parquet").to_pylist():
        (file,) = (out / "clouds").glob(f"{row['bag']}-*.parquet") if row["bag"] else (None,)
        rows = list(zip(*(pq.read_table(file).column(name).to_pylist() for name in COMPARED))) if file else []
        name = row["path"].rpartition("/")[2]
        error = (row["error"] or "").replace(row["path"], name)
        found[name] = [row["status"], error, row["clouds"], *rows]
    return found


BETWEEN_DEATHS = 4  # bags that get their rows


def kill_some(cluster: Any, out: Path, done: threading.Event, killed: List[int]) -> None:
    """A worker whenever some more bags have their rows, however slow the machine is; of the first half, which leaves
    those over which one died to the end: three deaths over one bag would make it an error."""
    chance = random.Random(11)
    judged = 0
    with distributed.Client(cluster) as client:
        while not done.wait(0.05):
            now = len(list(out.glob("clouds/*.parquet")))
            if not judged + BETWEEN_DEATHS <= now <= BAGS // 2:
                continue
            pids = list(client.run(os.getpid, on_error="ignore").values())
            if pids:
                judged = now
                killed.append(chance.choice(pids))
                os.kill(killed[-1], signal.SIGKILL)


@pytest.mark.slow
def test_a_cluster_whose_workers_are_killed_gives_the_rows_that_one_process_gives(tmp_path, drives):
    assert judge(drives, "--out", tmp_path / "one", "--jobs", 1).returncode == 1

    done, killed = threading.Event(), []
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        killer = threading.Thread(target=kill_some, args=(cluster, tmp_path / "many", done, killed))
        killer.start()
        result = judge(drives, "--out", tmp_path / "many", "--scheduler", cluster.scheduler_address)
        done.set()
        killer.join()

    assert result.returncode == 1, result.stderr
    assert len(killed) >= 3
    one, many = clouds(tmp_path / "one"), clouds(tmp_path / "many")
    assert len(one) == BAGS and sum(rows[0] == "error" for rows in one.values()) == DAMAGED
    assert many == one


@pytest.mark.slow
def test_an_interrupted_run_on_a_cluster_goes_on_where_it_was(tmp_path, drives):
    out = tmp_path / "out"
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        command = [*COMMAND, str(drives), "--out", str(out), "--scheduler", cluster.scheduler_address]
        running = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and len(list(out.glob("clouds/*.parquet"))) < 5:
            time.sleep(0.02)
        running.send_signal(signal.SIGINT)
        assert running.wait(60) == 130
        kept = {file: file.stat().st_mtime_ns for file in out.glob("clouds/*.parquet")}
        assert subprocess.run(command, capture_output=True, timeout=300).returncode == 1

    assert 5 <= len(kept) < BAGS and {file: file.stat().st_mtime_ns for file in kept} == kept
    assert len(clouds(out)) == BAGS


@pytest.mark.slow
def test_bags_on_s3_are_judged_where_they_are_and_known_by_their_checksum(tmp_path, bucket, drives):
    filesystem = s3fs.S3FileSystem()
    for number in (0, 10, 11):
        filesystem.put(str(drives / f"{number:03}.bag"), f"bags/fleet/{number:03}.bag")
    here = tmp_path / "here"
    here.mkdir()
    for number in (0, 10, 11):
        shutil.copy(drives / f"{number:03}.bag", here)
    assert judge(here, "--out", tmp_path / "local").returncode == 1

    result = judge(f"{bucket}/fleet", "--out", tmp_path / "remote")
    before = {file: file.stat().st_mtime_ns for file in (tmp_path / "remote").glob("clouds/*.parquet")}
    again = judge(f"{bucket}/*/*.bag", "--out", tmp_path / "remote")

    assert (result.returncode, again.returncode) == (1, 1), result.stderr + again.stderr
    assert clouds(tmp_path / "remote") == clouds(tmp_path / "local")
    assert len(before) == 3 and {file: file.stat().st_mtime_ns for file in before} == before


@pytest.mark.slow
def test_bags_on_s3_are_judged_in_mode_guard_as_they_are_here(tmp_path, bucket):
    here = tmp_path / "here"
    here.mkdir()
    for number in range(2):
        write_drive(here / f"{number}.bag", driven_at_wall(2.0, gap=0.9 + 0.6 * number, sensors=("camera", "laser")))
        s3fs.S3FileSystem().put(str(here / f"{number}.bag"), f"bags/guarded/{number}.bag")

    local, remote = (judge(place, "--mode", "guard", "--out", tmp_path / name) for place, name in
                     ((here, "local"), (f"{bucket}/guarded", "remote")))

    assert (local.returncode, remote.returncode) == (0, 0), local.stderr + remote.stderr
    answers = [pq.read_table(tmp_path / name / "guard" / "answers").to_pydict() for name in ("local", "remote")]
    assert answers[0]["factor"] and min(answers[0]["factor"]) < 1.0
    same = [name for name in answers[0] if name not in ("path", "bag")]
    assert {name: answers[1][name] for name in same} == {name: answers[0][name] for name in same}


def test_a_store_that_cannot_be_reached_costs_the_bags_their_rows(tmp_path, monkeypatch):
    monkeypatch.setenv("AWS_ENDPOINT_URL", "http://127.0.0.1:9")
    monkeypatch.setenv("AWS_MAX_ATTEMPTS", "1")
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "test")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "test")

    result = judge("s3://bags/one.bag", "--out", tmp_path / "out")

    assert result.returncode == 1 and "cannot open s3://bags/one.bag" in result.stdout, result.stderr
