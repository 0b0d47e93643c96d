# SPDX-License-Identifier: BSD-3-Clause
"""From cloud to Twist through real processes: our node and nodelet, the tutorial's node, and one that only answers."""
from collections import defaultdict
from dataclasses import asdict, dataclass
from math import ceil
from typing import Callable, Dict, List, Sequence, Tuple

from exchange import HD, QVGA, VGA, Exchange, Stream, exchange_in_one_process, exchanges
from repetitions import Plan, Timing, in_turn, timing_of, worst_and_median
from rich.table import Table as RichTable

SIDES = ("ours", "ours_pcl", "tutorial", "floor", "nodelet")


@dataclass(frozen=True)
class Cost:
    """Timings are of the repetitions' medians (latency) and means (the rest)."""

    latency_ms: Timing
    latency_p99_ms: float  # of the clouds of all repetitions
    cpu_ms: Timing
    faults: Timing


Case = Tuple[Stream, str]  # and the side
Table = Dict[Stream, Dict[str, Cost]]


def streams(plan: Plan) -> Sequence[Stream]:
    return (VGA,) if plan.quick else (QVGA, VGA, HD)


def cases(plan: Plan) -> List[Case]:
    return [(stream, side) for stream in streams(plan) for side in SIDES]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    """Needs a master."""
    return measure_cases(cases(plan), plan, done)


def measure_cases(chosen: Sequence[Case], plan: Plan, done: Callable[[], None]) -> Table:
    met = in_turn(chosen, plan, lambda case: exchange(*case, plan.clouds), done)
    table: Table = defaultdict(dict)
    for (stream, side), all_ in met.items():
        table[stream][side] = cost_of(all_)
    return table


def exchange(stream: Stream, side: str, clouds: int) -> Exchange:
    return exchange_in_one_process(stream, clouds) if side == "nodelet" else exchanges(side, stream, clouds)[0]


def cost_of(met: Sequence[Exchange]) -> Cost:
    latencies = sorted(latency for one in met for latency in one.latency_ms)
    return Cost(
        latency_ms=timing_of([timing_of(one.latency_ms).median for one in met]),
        latency_p99_ms=latencies[ceil(0.99 * len(latencies)) - 1],
        cpu_ms=timing_of([one.cpu_ms for one in met]),
        faults=timing_of([one.faults for one in met]),
    )


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    ours = [by["ours"] for by in table.values()]
    tutorial = [by["tutorial"] for by in table.values()]
    floor = [by["floor"] for by in table.values()]
    pairs, floors = list(zip(ours, tutorial)), list(zip(ours, floor))
    return {
        "node_cpu_vs_tutorial": worst_and_median(our.cpu_ms.median / its.cpu_ms.median for our, its in pairs),
        "node_cpu_vs_floor": worst_and_median(our.cpu_ms.median / its.cpu_ms.median for our, its in floors),
        "node_latency_vs_floor": worst_and_median(our.latency_ms.median / its.latency_ms.median for our, its in floors),
        "node_faults_per_cloud": worst_and_median(our.faults.median for our in ours),
        "nodelet_latency_ms": worst_and_median(by["nodelet"].latency_ms.median for by in table.values()),
    }


def table_of(table: Table) -> RichTable:
    return table_with_title(table, "From cloud to Twist, through real processes")


def table_with_title(table: Table, title: str) -> RichTable:
    shown = RichTable("picture", "node", title=title)
    for heading in ("latency [ms]", "spread", "p99", "CPU [ms/cloud]", "spread", "faults/cloud"):
        shown.add_column(heading, justify="right")
    for stream, by_side in table.items():
        for side, cost in by_side.items():
            used = used_by_the_node(side, cost)
            shown.add_row(stream.name, side, *cells(cost.latency_ms), f"{cost.latency_p99_ms:.2f}", *used)
        shown.add_section()
    return shown


def cells(timing: Timing) -> Tuple[str, str]:
    return f"{timing.median:.2f}", f"{timing.spread:.0%}"


def used_by_the_node(side: str, cost: Cost) -> Tuple[str, ...]:
    """Of the nodelet nobody knows: it shares its process with the camera."""
    return ("-", "-", "-") if side == "nodelet" else (*cells(cost.cpu_ms), f"{cost.faults.median:.1f}")


def as_json(table: Table) -> List[Dict[str, object]]:
    rows: List[Dict[str, object]] = []
    for stream, by_side in table.items():
        rows.append({"case": stream.name, **{side: known_of(side, cost) for side, cost in by_side.items()}})
    return rows


def known_of(side: str, cost: Cost) -> Dict[str, object]:
    return {name: value for name, value in asdict(cost).items() if side != "nodelet" or name.startswith("latency")}
