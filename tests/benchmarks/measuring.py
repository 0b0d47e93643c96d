# SPDX-License-Identifier: BSD-3-Clause
"""Everything side by side in one run."""
import json
import sys
from argparse import Namespace
from typing import Any, Dict, Sequence

import cameras
import depth
import growth
import guard
import instructions
import judge
import kernel
import nodes
import peer
import peer_build
import workers
from repetitions import Plan
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from safety_control_cloud.ros_session import roscore

PARTS = {"kernel": kernel, "nodes": nodes, "depth": depth, "cameras": cameras, "guard": guard, "peer": peer, "judge": judge, "workers": workers}
Figures = Dict[str, Dict[str, float]]
MEANINGS = {
    "kernel_vs_read": "a look / only reading the bytes, a fresh cloud of VGA or more",
    "kernel_vs_read_near_loss": "the same, with the memory of what came near",
    "kernel_vs_read_near_loss_placed": "the same, with the corridor in another frame",
    "kernel_vs_read_cached": "a look / only reading, the same cloud again and again",
    "kernel_vs_tutorial": "the tutorial's filters / a look, cached; more is better",
    "kernel_vs_pcl_indices": "PCL at its best / a look, cached; more is better",
    "kernel_scene_spread": "the slowest scene / the fastest",
    "node_cpu_vs_tutorial": "CPU of our node / of the tutorial's",
    "node_cpu_vs_floor": "CPU of our node / of one that only answers",
    "node_latency_vs_floor": "cloud to Twist, our node / one that only answers",
    "node_faults_per_cloud": "minor page faults of our node",
    "nodelet_latency_ms": "cloud to Twist inside one process [ms]",
    "depth_cpu_vs_chain": "CPU an image, our node / depth_image_proc and our node",
    "depth_floor_cpu_vs_chain": "the same of a node that only answers the image",
    "depth_cpu_vs_floor": "CPU an image, our node / one that only answers",
    "cameras_cpu_growth": "CPU a cloud with 2 and 4 cameras and nodes / with one",
    "guard_latency_ms": "command to answer, as a guard [ms]",
    "guard_latency_p99_ms": "the same, of a hundred the slowest",
    "guard_nodelet_latency_ms": "the same inside one process",
    "guard_nodelet_with_one_camera_latency_ms": "the same with one VGA camera and no laser",
    "guard_cpu_vs_floor": "CPU of the guard / of a node that hears the same and passes all",
    "peer_cpu_vs_guard": "CPU a VGA cloud, safety_limiter / the guard; more is better",
    "peer_cpu_vs_guard_above_floor": "the same, each less a node that passes all; more is better",
    "guard_vga_p99_ms": "command to answer, the guard with one VGA camera, of a hundred the slowest [ms]",
    "peer_p99_ms": "the same, safety_limiter",
    "judge_vs_read": "CPU a cloud of a bag, judged / only read by rosbags",
    "judge_memory_growth": "memory of the judge, a bag twice as long / one",
    "judge_two_workers": "clouds judged a second, by two worker processes / by one; more is better",
    "judge_two_apart": "the same of processes that share nothing: all that this machine gives",
    "judge_dispatch_cpu": "CPU of the process that shares the bags out / of its two workers",
}


def plan_of(given: Namespace) -> Plan:
    repetitions, clouds = (2, 20) if given.quick else (3, 50)
    beside = peer_build.program_of(given.peer) if given.peer else None
    return Plan(given.quick, given.repetitions or repetitions, given.clouds or clouds, not given.without_highway, beside)


def parts_of(given: Namespace) -> Sequence[str]:
    only = given.only or [name for name in PARTS if name != "peer"]
    with_it = {"workers": "judge" in only, "peer": given.peer is not None}
    return [name for name in PARTS if name in only or with_it.get(name)]


def measure(parts: Sequence[str], plan: Plan) -> Dict[str, Any]:
    """The table of each part. The bars stand on stderr, if that is a terminal."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with roscore(), Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        tasks = {name: progress.add_task(name, total=plan.repetitions * len(PARTS[name].cases(plan))) for name in parts}
        return {name: PARTS[name].measure(plan, lambda: progress.advance(tasks[name])) for name in parts}


def figures_table(figures: Figures) -> Table:
    shown = Table("figure", "worst", "median", "what it is", title="Figures, of all cases")
    for name, figure in figures.items():
        shown.add_row(name, f"{figure['worst']:g}", f"{figure['median']:g}", MEANINGS[name])
    return shown


def print_tables(tables: Dict[str, Any], figures: Figures, counts: Dict[str, float]) -> None:
    console = Console(width=None if sys.stdout.isatty() else 160, markup=False)
    shown = [PARTS[name].table_of(table) for name, table in tables.items()]
    if {"kernel", "nodes"} <= set(tables):
        shown.append(growth.table_of(tables["kernel"], tables["nodes"]))
    console.print(*shown, figures_table(figures), sep="\n\n")
    for name, count in counts.items():
        console.print(f"instructions per point, {name}: {count:g}", highlight=False)


def bench(given: Namespace) -> None:
    if given.store_instructions:
        instructions.store()
        return
    tables = measure(parts_of(given), plan_of(given))
    figures = {name: figure for part, table in tables.items() for name, figure in PARTS[part].figures(table).items()}
    counts = instructions.count() if "kernel" in tables and not given.quick else {}
    print_tables(tables, figures, counts)
    if given.plot:
        growth.draw(tables["kernel"], tables["nodes"], given.plot)
    if given.json:
        cases = {part: PARTS[part].as_json(table) for part, table in tables.items()}
        given.json.write_text(json.dumps({**figures, "instructions_per_point": counts, **cases}, indent=2) + "\n")
