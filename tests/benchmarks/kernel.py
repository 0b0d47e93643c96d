# SPDX-License-Identifier: BSD-3-Clause
"""What one look() costs, beside only reading the bytes and beside PCL."""
import json
import subprocess
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Dict, Iterator, List, Tuple

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "tests" / "benchmarks" / "kernel_benchmark"
WAYS = (
    *("read_fresh", "one_pass_fresh", "near_loss", "near_loss_placed"),
    *("read_cached", "one_pass_cached", "pcl_indices", "tutorial"),
)
VGA = 640 * 480


@dataclass(frozen=True, order=True)
class Case:
    """A size, layout and scene, as the program names them."""

    width: int
    height: int
    step: int
    scene: str
    nan: int

    @property
    def name(self) -> str:
        return f"{self.width}x{self.height}/step_{self.step}/{self.scene}/nan_{self.nan}"

    @property
    def layout(self) -> Tuple[int, int, int]:
        return self.width, self.height, self.step

    @property
    def points(self) -> int:
        return self.width * self.height


def cases(quick: bool) -> Iterator[Case]:
    for width, height in [(640, 480)] if quick else [(320, 240), (640, 480), (1280, 720), (4096, 3072)]:
        for step in (12, 16, 20, 32):
            for scene in ("wall_0.6m", "wall_2m", "mixed"):
                for nan in (0, 30):
                    yield Case(width, height, step, scene, nan)


def times_of(case: Case) -> Dict[str, float]:
    """[ms] of CPU time by way, all in one process."""
    command = [PROGRAM, f"--benchmark_filter=/{case.name}$", "--benchmark_min_time=0.02", "--benchmark_format=json"]
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    return {run["name"].split("/")[0]: run["cpu_time"] for run in json.loads(result.stdout)["benchmarks"]}


@dataclass(frozen=True)
class Timing:
    """[ms] of CPU time."""

    median: float
    fastest: float
    slowest: float


Table = Dict[Case, Dict[str, Timing]]


def measure(quick: bool, repetitions: int, done=lambda: None) -> Table:
    """Every case once, then every case again: what disturbs the machine for a while disturbs all a little."""
    times: Dict[Case, Dict[str, List[float]]] = defaultdict(lambda: defaultdict(list))
    for _ in range(repetitions):
        for case in cases(quick):
            for way, time in times_of(case).items():
                times[case][way].append(time)
            done()
    return {
        case: {way: Timing(median(all_), min(all_), max(all_)) for way, all_ in by_way.items()}
        for case, by_way in times.items()
    }


def worst_and_median(ratios: List[float], worst=max) -> Dict[str, float]:
    return {"worst": round(worst(ratios), 3), "median": round(median(ratios), 3)}


def ratios(table: Table, slow: str, fast: str, points: int = 0) -> List[float]:
    return [by[slow].median / by[fast].median for case, by in table.items() if case.points >= points]


def scene_spread(table: Table) -> List[float]:
    """For every size and step, how much longer the slowest scene takes than the fastest."""
    by_layout = defaultdict(list)
    for case, by in table.items():
        by_layout[case.layout].append(by["one_pass_cached"].median)
    return [max(times) / min(times) for times in by_layout.values()]


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    """Against reading: VGA and larger. A fresh cloud is in no cache, as a camera's next one; a cached one always is,
    and so is PCL's."""
    return {
        "kernel_vs_read": worst_and_median(ratios(table, "one_pass_fresh", "read_fresh", VGA)),
        "kernel_vs_read_near_loss": worst_and_median(ratios(table, "near_loss", "read_fresh", VGA)),
        "kernel_vs_read_near_loss_placed": worst_and_median(ratios(table, "near_loss_placed", "read_fresh", VGA)),
        "kernel_vs_read_cached": worst_and_median(ratios(table, "one_pass_cached", "read_cached", VGA)),
        "kernel_vs_tutorial": worst_and_median(ratios(table, "tutorial", "one_pass_cached"), min),
        "kernel_vs_pcl_indices": worst_and_median(ratios(table, "pcl_indices", "one_pass_cached"), min),
        "kernel_scene_spread": worst_and_median(scene_spread(table)),
    }


def rows(table: Table) -> Iterator[str]:
    yield f"{'CPU time [ms], median':44}" + "".join(f"{way:>17}" for way in WAYS) + "   spread"
    for case in sorted(table):
        by = table[case]
        spread = max((by[way].slowest - by[way].fastest) / by[way].median for way in WAYS)
        yield f"{case.name:44}" + "".join(f"{by[way].median:17.4f}" for way in WAYS) + f"{spread:8.0%}"


def as_json(table: Table) -> List[Dict[str, object]]:
    return [{"case": case.name, **{way: vars(timing) for way, timing in by.items()}} for case, by in sorted(table.items())]
