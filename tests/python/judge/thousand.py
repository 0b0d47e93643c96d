# SPDX-License-Identifier: BSD-3-Clause
"""A thousand bags on a cluster whose workers are killed at random: the same rows as one process gives.

By hand, as it takes minutes (in a shell with devel/setup.bash and .venv/bin in PATH): PYTHONPATH=tests/support:$PYTHONPATH python tests/python/judge/thousand.py
"""
from __future__ import annotations

import argparse
import random
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any, Dict, List

import distributed
import pyarrow as pa
import pyarrow.parquet as pq
from drives import wall, write_drive
from test_cluster import COMPARED, judge

SHARED = Path(__file__).resolve().parents[4] / "shared"
LONG, CLOUDS_OF_A_LONG_ONE, DAMAGED = 0.1, 500, 0.03
PAUSE = (8.0, 20.0)  # [s] between two deaths


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--bags", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    chance = random.Random(given.seed)
    with tempfile.TemporaryDirectory(prefix="thousand_") as name:
        folder = Path(name)
        real = make(folder / "bags", given.bags, chance)
        started = time.monotonic()
        judge(folder / "bags", "--out", folder / "one", "--jobs", 1)
        alone = time.monotonic() - started
        deaths, many = on_a_cluster(folder, given.workers, chance)
        one, other = clouds(folder / "one"), clouds(folder / "many")
        errors = sum(rows[0] == "error" for rows in one.values())
        print(f"{len(one)} bags, {real} of them of real recordings, {sum(rows[1] for rows in one.values()):,} clouds, "
              f"{errors} bags with errors; seed {given.seed}")
        print(f"one process {alone:.0f} s; {given.workers} workers, {deaths} of them killed, {many:.0f} s")
        different = [name for name in one if one[name] != other.get(name)]
        print("the rows are the same" if not different and len(one) == len(other) == given.bags else f"different: {different}")
        return 1 if different or len(one) != given.bags or len(other) != given.bags else 0


def clouds(out: Path) -> Dict[str, list]:
    """Of each bag by its name: status, number of clouds, and all rows; times to the nanosecond."""
    found = {}
    for row in pq.read_table(out / "bags.parquet", columns=["path", "bag", "status", "clouds"]).to_pylist():
        (file,) = (out / "clouds").glob(f"{row['bag']}-*.parquet")
        content = pq.read_table(file, columns=list(COMPARED))
        columns = [column.cast("int64") if pa.types.is_timestamp(column.type) else column for column in content.columns]
        found[Path(row["path"]).name] = [row["status"], row["clouds"], *zip(*(column.to_pylist() for column in columns))]
    return found


def make(folder: Path, bags: int, chance: random.Random) -> int:
    """The bags. How many of them are of real recordings."""
    folder.mkdir()
    real = recordings(folder)
    for number in range(bags - real):
        count = CLOUDS_OF_A_LONG_ONE if number < LONG * bags else chance.randint(5, 60)
        start, pace = chance.uniform(0.5, 2.5), chance.uniform(-0.01, 0.01)
        gap = chance.randint(0, count)
        write_drive(folder / f"{number:04}.bag", [
            wall(0.05 * n + (1.0 if n > gap else 0.0), max(start + pace * n, 0.2)) for n in range(count)])
    for file in chance.sample(sorted(folder.iterdir()), round(DAMAGED * bags)):
        damage(file, chance)
    return real


def recordings(folder: Path) -> int:
    for number, pcd in enumerate(sorted((SHARED / "data").rglob("*.pcd"))):
        bag = folder / f"real_{number}_{pcd.stem}.bag"
        subprocess.run([sys.executable, SHARED / "tools" / "pcd2bag.py", bag, "native", "camera", "/camera/depth/points", pcd],
                       check=True, capture_output=True)
    for bag in sorted((SHARED / "data").rglob("*.bag")):
        (folder / f"real_{bag.name}").write_bytes(bag.read_bytes())
    return len(list(folder.iterdir()))


def damage(file: Path, chance: random.Random) -> None:
    """Its end is missing, or a part of it is zero."""
    content = bytearray(file.read_bytes())
    at = chance.randint(0, len(content) - 1)
    if chance.random() < 0.5:
        del content[at:]
    else:
        content[at : at + 400] = bytes(len(content[at : at + 400]))
    file.write_bytes(content)


def on_a_cluster(folder: Path, workers: int, chance: random.Random) -> Any:
    """How many workers were killed, and how long it took [s]."""
    killed: List[int] = []
    done = threading.Event()
    with distributed.LocalCluster(n_workers=0, dashboard_address=None) as cluster:
        address = cluster.scheduler_address
        killer = threading.Thread(target=kill_some, args=(address, workers, done, chance, killed))
        started = time.monotonic()
        killer.start()
        result = judge(folder / "bags", "--out", folder / "many", "--scheduler", address)
        took = time.monotonic() - started
        done.set()
        killer.join()
    assert result.returncode == 1, result.stderr
    return len(killed), took


def kill_some(address: str, workers: int, done: threading.Event, chance: random.Random, killed: List[int]) -> None:
    """One after the other, each replaced at once, as a cluster's own keeper would."""
    command = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard"]
    running = [subprocess.Popen(command, stderr=subprocess.DEVNULL) for _ in range(workers)]
    while not done.wait(chance.uniform(*PAUSE)):
        place = chance.randrange(workers)
        running[place].kill()
        killed.append(running[place].pid)
        running[place].wait()
        running[place] = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    for worker in running:
        worker.kill()
        worker.wait()


if __name__ == "__main__":
    sys.exit(main())
