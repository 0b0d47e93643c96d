# SPDX-License-Identifier: BSD-3-Clause
"""Depth images: taken by our node as they are, made clouds by depth_image_proc before, or only answered."""
from typing import Callable, Dict, List

import nodes
from nodes import Case, Table
from repetitions import Plan, worst_and_median
from rich.table import Table as RichTable

SIDES = ("depth", "depth_floor", "chain")


def cases(plan: Plan) -> List[Case]:
    return [(stream, side) for stream in nodes.streams(plan) for side in SIDES]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    """Needs a master."""
    return nodes.measure_cases(cases(plan), plan, done)


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    def share(side: str, of: str) -> Dict[str, float]:
        return worst_and_median(by[side].cpu_ms.median / by[of].cpu_ms.median for by in table.values())

    return {
        "depth_cpu_vs_chain": share("depth", "chain"),
        "depth_floor_cpu_vs_chain": share("depth_floor", "chain"),
        "depth_cpu_vs_floor": share("depth", "depth_floor"),
    }


def table_of(table: Table) -> RichTable:
    return nodes.table_with_title(table, "From depth image to Twist: our node, and depth_image_proc with our node, and one that only answers")


as_json = nodes.as_json
