# SPDX-License-Identifier: BSD-3-Clause
"""safety_limiter (at-wat/neonavigation) beside the guard: one VGA camera at 20 Hz, commands at 50 Hz, one node at a time.

At its own defaults, and at the guard's wherever it has a setting of the same meaning. A node that hears the same and
passes every command is what the transport takes of both. The camera's clouds are depth_image_proc's: of 16 bytes a
point, as a TurtleBot's camera/depth/points are, and of 32, with colours.
"""
from dataclasses import asdict, dataclass
from math import cos, pi, sin
from typing import Any, Callable, Dict, Iterator, List, Mapping, Sequence, Tuple

import guard
from peer_checkout import PACKAGE as PEER
from repetitions import Plan, Timing, in_turn, timing_of, worst_and_median
from rich.table import Table as RichTable

POINT_STEPS = (16, guard.WITH_COLOURS)  # [byte]
SIDES = ("ours", "floor", "peer", "peer_as_ours")
PEERS = SIDES[2:]
NAMES = {"ours": "the guard", "floor": "passes all", "peer": PEER, "peer_as_ours": f"{PEER}, set as the guard"}
CAMERA = {"mode": "guard", "sensors": guard.PARAMETERS["sensors"][:1]}
CORNERS = 16  # of the polygon in place of the guard's circle
LEAST = 0.01  # [ms] less is not told from the floor


@dataclass(frozen=True)
class Cost:
    """Timings are of the repetitions' medians, p99s and means."""

    latency_ms: Timing  # from command to answer
    latency_p99_ms: Timing
    cpu_ms: Timing  # a cloud, commands included
    unanswered: float  # share of the commands, passed over for a later one


Costs = Dict[str, Cost]  # of each side
Table = Dict[int, Costs]  # by point step [byte]


def cases(plan: Plan) -> Sequence[Tuple[int, str]]:
    return [(point_step, side) for point_step in POINT_STEPS for side in SIDES]


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    """Needs a master."""
    from safety_control_cloud import core

    values = parameters_of(core.Settings(mode="guard").as_dict())

    def drive(case: Tuple[int, str]) -> Mapping[str, Any]:
        point_step, side = case
        command = [[str(plan.peer), "cloud:=front/points"]] if side in PEERS else guard.commands_of(side)
        with guard.parameters(values[side]):
            return guard.driven(command, plan.clouds * guard.COMMANDS_A_CLOUD, 1, point_step)

    met = in_turn(cases(plan), plan, drive, done)
    return {point_step: {side: cost_of(met[point_step, side]) for side in SIDES} for point_step in POINT_STEPS}


def parameters_of(settings: Mapping[str, Any]) -> Dict[str, Dict[str, Any]]:
    """Of each side. safety_limiter has no default of its footprint; compatible 1 are its topics of today."""
    body = {"footprint": polygon(settings["radius"])}
    today = {"/neonavigation_compatible": 1}
    return {
        "ours": {guard.NODE: CAMERA},
        "floor": {},
        "peer": {f"/{PEER}": body, **today},
        "peer_as_ours": {f"/{PEER}": {**body, **as_guard(settings)}, **today},
    }


def polygon(radius: float) -> List[List[float]]:
    """Around the circle."""
    outer = radius / cos(pi / CORNERS)
    turns = [2.0 * pi * corner / CORNERS for corner in range(CORNERS)]
    return [[outer * cos(turn), outer * sin(turn)] for turn in turns]


def as_guard(settings: Mapping[str, Any]) -> Dict[str, Any]:
    """Its parameters of the guard's meaning."""
    return {
        "base_frame": settings["base_frame"],
        "freq": 1.0 / settings["sensor_period"],  # the guard judges each cloud
        "cloud_timeout": settings["source_timeout"],
        "lin_vel": settings["max_speed"],
        "lin_acc": settings["base_deceleration"],
        "max_linear_vel": settings["max_speed"],
        "ang_vel": settings["max_turn"],
        "ang_acc": settings["angular_deceleration"],
        "max_angular_vel": settings["max_turn"],
        "z_range_min": settings["bottom"],
        "z_range_max": settings["top"],
        "d_margin": settings["margin"],
    }


def cost_of(met: Sequence[Mapping[str, Any]]) -> Cost:
    return Cost(
        latency_ms=timing_of([timing_of(one["latency_ms"]).median for one in met]),
        latency_p99_ms=timing_of([guard.p99(one["latency_ms"]) for one in met]),
        cpu_ms=timing_of([one["cpu_ms"] for one in met]),
        unanswered=1.0 - sum(len(one["latency_ms"]) for one in met) / sum(one["said"] for one in met),
    )


def above_floor(costs: Costs, side: str) -> float:
    """[ms] of CPU a cloud."""
    return max(costs[side].cpu_ms.median - costs["floor"].cpu_ms.median, LEAST)


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    beside = [(costs, peer) for costs in table.values() for peer in PEERS]
    return {
        "peer_cpu_vs_guard": worst_and_median((costs[peer].cpu_ms.median / costs["ours"].cpu_ms.median for costs, peer in beside), min),
        "peer_cpu_vs_guard_above_floor": worst_and_median((above_floor(costs, peer) / above_floor(costs, "ours") for costs, peer in beside), min),
        "guard_vga_p99_ms": worst_and_median(costs["ours"].latency_p99_ms.median for costs in table.values()),
        "peer_p99_ms": worst_and_median(costs[peer].latency_p99_ms.median for costs, peer in beside),
    }


def table_of(table: Table) -> RichTable:
    shown = RichTable("bytes a point", "node", title="The guard and its peer: a VGA camera at 20 Hz, commands at 50 Hz")
    for heading in ("command to answer [ms]", "p99", "never", "CPU a cloud [ms]", "x the guard's", "above passing all [ms]", "x the guard's"):
        shown.add_column(heading, justify="right")
    for point_step, costs in table.items():
        for row in rows_of(costs):
            shown.add_row(str(point_step), *row)
    return shown


def rows_of(costs: Costs) -> Iterator[Sequence[str]]:
    for side, cost in costs.items():
        above, ours = above_floor(costs, side), above_floor(costs, "ours")
        rest = ("-", "-") if side == "floor" else (f"{above:.2f}", f"{above / ours:.1f}")
        times = f"{cost.cpu_ms.median / costs['ours'].cpu_ms.median:.1f}"
        yield (NAMES[side], f"{cost.latency_ms.median:.2f}", ranged(cost.latency_p99_ms), f"{cost.unanswered:.0%}",
               ranged(cost.cpu_ms), times, *rest)


def ranged(timing: Timing) -> str:
    return f"{timing.median:.2f} ({timing.fastest:.2f}-{timing.slowest:.2f})"


def as_json(table: Table) -> List[Dict[str, object]]:
    return [{"point_step": point_step, "side": side, **asdict(cost)} for point_step, costs in table.items() for side, cost in costs.items()]
