# SPDX-License-Identifier: BSD-3-Clause
"""Bags of VGA clouds on this disk, judged by one worker process and by two, the time of the dispatch counted.

Beside them the same by processes that know nothing of each other: what a second one gains on this machine at all.
"""
import json
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path
from typing import Callable, Dict, List, Sequence, Tuple

from judge import FOLDER, JUDGED, write_bag
from repetitions import Plan, Timing, in_turn, timing_of, worst_and_median
from rich.table import Table as RichTable

SIDES = ("dispatched", "apart")
PROCESSES = (1, 2)
LENGTH, BAGS = 40, 4  # clouds of a bag, and different bags
ROUNDS, FEW_ROUNDS = 6, 2  # so often each bag is judged, so that the start of a process counts little
DISPATCHED = """
import json, resource, sys, tempfile, time
from pathlib import Path
from safety_control_cloud.dispatch import shared_out
from safety_control_cloud.judge.bag import Job, judge_bag
from safety_control_cloud.judge.store import Store
from safety_control_cloud.local_crew import LocalCrew
jobs = [Job(bag, ({"stamp_tolerance": 0.0},)) for bag in sys.argv[2:]]
before, wall, clouds = resource.getrusage(resource.RUSAGE_SELF), time.perf_counter(), 0
with tempfile.TemporaryDirectory() as out, LocalCrew(int(sys.argv[1])) as crew:
    store = Store(Path(out), {})
    for job, judged in shared_out(jobs, judge_bag, crew):
        store.keep(judged)
        clouds += judged.rows[0].clouds
wall, after = time.perf_counter() - wall, resource.getrusage(resource.RUSAGE_SELF)
workers = resource.getrusage(resource.RUSAGE_CHILDREN)
print(json.dumps({
    "clouds": clouds, "wall": wall, "workers": workers.ru_utime + workers.ru_stime,
    "parent": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}))
"""
APART = """
import json, sys, time
{judged}
clouds = sum(map(work, sys.argv[1:]))
print(json.dumps({{"clouds": clouds, "workers": time.process_time(), "parent": 0.0}}))
"""


@dataclass(frozen=True)
class Cost:
    """[ms/cloud]"""

    wall: Timing
    workers: Timing  # CPU of all of them
    parent: Timing  # CPU of the one that shares the bags out


Case = Tuple[str, int]  # side, processes
Table = Dict[Case, Cost]


def cases(plan: Plan) -> List[Case]:
    return [(side, processes) for side in SIDES for processes in PROCESSES]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    bags = bags_made() * (FEW_ROUNDS if plan.quick else ROUNDS)
    met = in_turn(cases(plan), plan, lambda case: run(case, bags), done)
    return {case: Cost(*(timing_of([1e3 * one[name] / one["clouds"] for one in all_]) for name in ("wall", "workers", "parent")))
            for case, all_ in met.items()}


def run(case: Case, bags: Sequence[Path]) -> Dict[str, float]:
    side, processes = case
    if side == "dispatched":
        return _answers([[sys.executable, "-c", DISPATCHED, str(processes), *map(str, bags)]])[0]
    program, started = APART.format(judged=JUDGED), time.perf_counter()
    answers = _answers([[sys.executable, "-c", program, *map(str, bags[first::processes])] for first in range(processes)])
    return {**{name: sum(one[name] for one in answers) for name in answers[0]}, "wall": time.perf_counter() - started}


def _answers(commands: Sequence[Sequence[str]]) -> List[Dict[str, float]]:
    """Of programs that run at once."""
    running = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True) for command in commands]
    said = [one.communicate()[0] for one in running]
    assert not any(one.returncode for one in running)
    return [json.loads(text) for text in said]


@lru_cache(maxsize=None)
def bags_made() -> List[Path]:
    return [write_bag(Path(FOLDER.name) / f"camera_{number}.bag", LENGTH, f"/camera_{number}") for number in range(BAGS)]


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    def gain(side: str) -> Dict[str, float]:
        return worst_and_median([table[side, 1].wall.median / table[side, 2].wall.median])

    two = table["dispatched", 2]
    return {"judge_two_workers": gain("dispatched"), "judge_two_apart": gain("apart"),
            "judge_dispatch_cpu": worst_and_median([two.parent.median / two.workers.median])}


def table_of(table: Table) -> RichTable:
    shown = RichTable("processes", title="Bags of VGA clouds from this disk, shared out among worker processes")
    for heading in ("wall [ms/cloud]", "spread", "clouds/s", "CPU of the workers [ms/cloud]", "CPU of their parent [ms/cloud]"):
        shown.add_column(heading, justify="right")
    for (side, processes), cost in table.items():
        shown.add_row(f"{processes} {side}", f"{cost.wall.median:.2f}", f"{cost.wall.spread:.0%}", f"{1e3 / cost.wall.median:.0f}",
                      f"{cost.workers.median:.2f}", f"{cost.parent.median:.3f}")
    return shown


def as_json(table: Table) -> List[Dict[str, object]]:
    return [{"case": f"{processes} {side}", **asdict(cost)} for (side, processes), cost in table.items()]
