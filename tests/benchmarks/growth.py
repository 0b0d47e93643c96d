# SPDX-License-Identifier: BSD-3-Clause
"""How the times grow with the points of a cloud, as a table and as a picture."""
from pathlib import Path
from typing import Dict

import kernel
import nodes
from matplotlib.figure import Figure
from rich.table import Table as RichTable

Curve = Dict[int, float]  # [ms] by points
LOOKS = {"read_fresh": "only reading", "one_pass_fresh": "one look", "tutorial": "tutorial's filters"}
PROCESSES = {
    "floor": "a node that only answers",
    "ours": "our node",
    "ours_pcl": "our node, method pcl",
    "tutorial": "tutorial's node",
}
GREY, GREEN, BLUE, RED, VIOLET = "0.6", "C2", "C0", "C3", "C4"
COLOURS = {
    **{"read_fresh": GREY, "floor": GREY, "one_pass_fresh": GREEN},
    **{"ours": GREEN, "ours_pcl": BLUE, "tutorial": RED, "nodelet": VIOLET},
}


def of_looks(table: kernel.Table) -> Dict[str, Curve]:
    """CPU time of the kernel's scene that the nodes see too."""
    seen = {case.points: by for case, by in table.items() if (case.step, case.scene, case.nan) == (32, "mixed", 30)}
    return {way: {points: by[way].median for points, by in seen.items()} for way in LOOKS}


def of_nodes(table: nodes.Table) -> Dict[str, Curve]:
    """CPU time a cloud."""
    return {side: {stream.points: by[side].cpu_ms.median for stream, by in table.items()} for side in PROCESSES}


def of_latencies(table: nodes.Table) -> Dict[str, Curve]:
    return {side: {stream.points: by[side].latency_ms.median for stream, by in table.items()} for side in nodes.SIDES}


def table_of(looks: kernel.Table, processes: nodes.Table) -> RichTable:
    shown = RichTable("points", title="How time grows with points, 32 bytes each [ms]")
    curves = [(f"{name}, CPU", of_looks(looks)[way]) for way, name in LOOKS.items()]
    curves += [(f"{name}, CPU", of_nodes(processes)[side]) for side, name in PROCESSES.items()]
    for side, name in {"ours": "our node", "nodelet": "our nodelet"}.items():
        curves.append((f"{name}, latency", of_latencies(processes)[side]))
    for name, _ in curves:
        shown.add_column(name, justify="right")
    for points in sorted({points for _, curve in curves for points in curve}):
        shown.add_row(f"{points:,}", *(f"{curve[points]:.2f}" if points in curve else "-" for _, curve in curves))
    return shown


def draw(looks: kernel.Table, processes: nodes.Table, path: Path) -> None:
    """A panel for looking at a cloud in memory, one for whole nodes, one for the time until the Twist."""
    figure = Figure(figsize=(11, 3.6), constrained_layout=True)
    looking, working, waiting = figure.subplots(1, 3)
    draw_curves(looking, "Looking at a cloud in memory", "CPU time [ms]", of_looks(looks), LOOKS)
    draw_curves(working, "A node with all it does", "CPU time per cloud [ms]", of_nodes(processes), PROCESSES)
    latencies = {**PROCESSES, "nodelet": "our nodelet"}
    draw_curves(waiting, "From cloud to Twist", "latency [ms]", of_latencies(processes), latencies)
    figure.savefig(path, dpi=100)


def draw_curves(axes, title: str, quantity: str, curves: Dict[str, Curve], names: Dict[str, str]) -> None:
    for side, name in names.items():
        points, times = zip(*sorted(curves[side].items()))
        style = "s--" if COLOURS[side] == GREY else "o-"  # both to be seen where they meet
        axes.loglog(points, times, style, color=COLOURS[side], label=name, markersize=4)
    axes.set(title=title, xlabel="points", ylabel=quantity)
    axes.set_ylim(top=10 * axes.get_ylim()[1])  # room for the legend
    axes.grid(True, which="major", alpha=0.3)
    axes.legend(loc="upper left", frameon=False, fontsize="small")
