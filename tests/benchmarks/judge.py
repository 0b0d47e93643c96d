# SPDX-License-Identifier: BSD-3-Clause
"""A bag of VGA clouds on this disk: judged, and only read. Each in a process of its own, as a worker does it."""
import json
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path
from typing import Callable, Dict, List

import numpy as np
from repetitions import Plan, Timing, in_turn, timing_of, worst_and_median
from rich.table import Table as RichTable

SIDES = ("read", "judge")
LENGTHS = (20, 40)  # clouds of a bag; the second shows whether memory grows with it
TOPIC, CLOUD = "/camera/depth/points", "sensor_msgs/msg/PointCloud2"
FOLDER = tempfile.TemporaryDirectory(prefix="bench_judge_")
READ = """
from rosbags.highlevel import AnyReader
def work(bag):
    with AnyReader([Path(bag)]) as reader:
        return sum(1 for _ in reader.messages())
"""
JUDGED = """
from safety_control_cloud.judge.bag import Job, judge_bag
def work(bag):
    return judge_bag(Job(bag, ({"stamp_tolerance": 0.0},))).rows[0].clouds
"""
MEASURED = """
import json, resource, sys, time
from pathlib import Path
{work}
cpu, wall = time.process_time(), time.perf_counter()
clouds = work(sys.argv[1])
cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(json.dumps({{"cpu": 1e3 * cpu / clouds, "wall": 1e3 * wall / clouds, "memory": memory}}))
"""


@dataclass(frozen=True)
class Cost:
    cpu_ms: Timing  # a cloud
    wall_ms: Timing
    memory_mb: Timing  # at most


Case = tuple  # side and length
Table = Dict[Case, Cost]


def cases(plan: Plan) -> List[Case]:
    return [(side, length) for length in LENGTHS for side in SIDES]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    met = in_turn(cases(plan), plan, run, done)
    return {case: Cost(*(timing_of([one[name] for one in all_]) for name in ("cpu", "wall", "memory")))
            for case, all_ in met.items()}


def run(case: Case) -> Dict[str, float]:
    side, length = case
    program = MEASURED.format(work=READ if side == "read" else JUDGED)
    done = subprocess.run([sys.executable, "-c", program, str(bag_of(length))], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


@lru_cache(maxsize=None)
def bag_of(length: int) -> Path:
    return write_bag(Path(FOLDER.name) / f"{length}.bag", length)


def write_bag(path: Path, length: int, camera: str = "/camera") -> Path:
    """A wall that comes nearer over a floor, 32 bytes a point, 30 % without return."""
    from rosbags.rosbag1 import Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS1_NOETIC)
    types = store.types
    fields = [types["sensor_msgs/msg/PointField"](name, 4 * place, 7, 1) for place, name in enumerate("xyz")]
    with Writer(path) as writer:
        connection = writer.add_connection(TOPIC, CLOUD, typestore=store, callerid=camera)
        for number in range(length):
            time = 10**18 + number * 50_000_000
            stamp = types["builtin_interfaces/msg/Time"](*divmod(time, 10**9))
            message = types[CLOUD](
                header=types["std_msgs/msg/Header"](seq=number, stamp=stamp, frame_id="camera"), height=480, width=640,
                fields=fields, is_bigendian=False, point_step=32, row_step=32 * 640, data=points(number), is_dense=False)
            writer.write(connection, time, store.serialize_ros1(message, CLOUD))
    return path


def points(number: int) -> np.ndarray:
    v, u = np.indices((480, 640), np.float32)
    z = np.minimum(2.5 - 0.02 * number, 0.3 * 554 / np.maximum(v - 239.5, 1e-3)).astype(np.float32)
    z[np.random.default_rng(number).random(z.shape) < 0.3] = np.nan
    made = np.zeros((480, 640, 8), np.float32)
    made[..., 0], made[..., 1], made[..., 2] = (u - 319.5) / 554 * z, (v - 239.5) / 554 * z, z
    return made.reshape(-1).view(np.uint8)


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    short, long = LENGTHS
    return {
        "judge_vs_read": worst_and_median(
            table["judge", length].cpu_ms.median / table["read", length].cpu_ms.median for length in LENGTHS),
        "judge_memory_growth": worst_and_median([table["judge", long].memory_mb.median / table["judge", short].memory_mb.median]),
    }


def table_of(table: Table) -> RichTable:
    shown = RichTable("side", "clouds", title="A bag of VGA clouds from this disk, one process")
    for heading in ("CPU [ms/cloud]", "spread", "wall [ms/cloud]", "clouds/s", "memory [MB]"):
        shown.add_column(heading, justify="right")
    for (side, length), cost in table.items():
        shown.add_row(side, str(length), f"{cost.cpu_ms.median:.2f}", f"{cost.cpu_ms.spread:.0%}", f"{cost.wall_ms.median:.2f}",
                      f"{1e3 / cost.wall_ms.median:.0f}", f"{cost.memory_mb.median:.0f}")
    return shown


def as_json(table: Table) -> List[Dict[str, object]]:
    return [{"case": f"{side}, {length} clouds", **asdict(cost)} for (side, length), cost in table.items()]
