# SPDX-License-Identifier: BSD-3-Clause
"""What one look() costs, beside only reading the bytes and beside PCL."""
import json
import subprocess
from collections import defaultdict
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Callable, Dict, List, Tuple

from repetitions import Plan, Timing, in_turn, timing_of, worst_and_median
from rich.table import Column
from rich.table import Table as RichTable

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "build" / "tests" / "benchmarks"
WAYS = (
    *("read_fresh", "one_pass_fresh", "near_loss", "near_loss_placed"),
    *("read_cached", "one_pass_cached", "pcl_indices", "tutorial"),
)
VGA = 640 * 480
SIZES = ((320, 240), (640, 480), (1280, 720), (4096, 3072))
SCENES = ("wall_0.6m", "wall_2m", "mixed")


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


def cases(plan: Plan) -> List[Case]:
    """The largest clouds, which take most of a full run, only of one scene."""
    return [
        Case(width, height, step, scene, nan)
        for width, height in ([(640, 480)] if plan.quick else SIZES)
        for step in (12, 16, 20, 32)
        for scene in (SCENES[-1:] if width == 4096 else SCENES)
        for nan in (0, 30)
    ]


def times_of(case: Case, program: str = "kernel_benchmark") -> Dict[str, float]:
    """[ms] of CPU time by way, all in one process."""
    command = [PROGRAMS / program, f"--benchmark_filter=/{case.name}$", "--benchmark_min_time=0.02", "--benchmark_format=json"]
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    return {run["name"].split("/")[0]: run["cpu_time"] for run in json.loads(result.stdout)["benchmarks"]}


Table = Dict[Case, Dict[str, Timing]]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    program = "kernel_benchmark" if plan.highway else "kernel_benchmark_portable"
    times = in_turn(cases(plan), plan, partial(times_of, program=program), done)
    return {case: {way: timing_of([one[way] for one in all_]) for way in WAYS} for case, all_ in times.items()}


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


def table_of(table: Table) -> RichTable:
    title = "One look at a cloud: CPU time [ms], median of the repetitions"
    shown = RichTable(Column("cloud", no_wrap=True), *WAYS, "spread", title=title)
    for column in shown.columns[1:]:
        column.justify = "right"
    for case in sorted(table):
        by = table[case]
        spread = max(timing.spread for timing in by.values())
        shown.add_row(case.name, *(f"{by[way].median:.4f}" for way in WAYS), f"{spread:.0%}")
    return shown


def as_json(table: Table) -> List[Dict[str, object]]:
    return [
        {"case": case.name, **{way: vars(timing) for way, timing in by.items()}} for case, by in sorted(table.items())
    ]
