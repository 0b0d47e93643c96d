# SPDX-License-Identifier: BSD-3-Clause
"""Several robots' worth of cameras on one machine, each with a node of its own, all at once."""
from dataclasses import asdict
from typing import Callable, Dict, List

from exchange import Stream, exchanges
from nodes import Cost, cells, cost_of
from repetitions import Plan, in_turn, worst_and_median
from rich.table import Table as RichTable

STREAM = Stream(640, 480, 10.0)

Table = Dict[int, Cost]


def cases(plan: Plan) -> List[int]:
    return [1, 2, 4]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    """A cloud's cost by the number of cameras. Needs a master."""
    met = in_turn(cases(plan), plan, lambda count: exchanges("ours", STREAM, plan.clouds, count), done)
    return {count: cost_of([one for together in all_ for one in together]) for count, all_ in met.items()}


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    """Beside one camera."""
    alone = table[1].cpu_ms.median
    growth = [cost.cpu_ms.median / alone for count, cost in table.items() if count > 1]
    return {"cameras_cpu_growth": worst_and_median(growth)}


def table_of(table: Table) -> RichTable:
    each = f"each {STREAM.name} at {STREAM.rate:g} Hz with a node of its own"
    shown = RichTable("cameras", title=f"Cameras at once, {each}")
    for heading in ("latency [ms]", "spread", "p99", "CPU [ms/cloud]", "spread", "nodes' CPU [of a core]"):
        shown.add_column(heading, justify="right")
    for count, cost in table.items():
        load = count * STREAM.rate * cost.cpu_ms.median / 1e3
        used = (*cells(cost.cpu_ms), f"{load:.1%}")
        shown.add_row(str(count), *cells(cost.latency_ms), f"{cost.latency_p99_ms:.2f}", *used)
    return shown


def as_json(table: Table) -> List[Dict[str, object]]:
    return [{"cameras": count, **asdict(cost)} for count, cost in table.items()]
