# SPDX-License-Identifier: BSD-3-Clause
"""The guard with two VGA cameras and a laser at 20 Hz and commands at 50 Hz: what it costs, and from command to answer.

Beside it, a node that hears the same and passes every command; and the nodelet, in the process of all of them, and with
one camera alone.
"""
import json
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass
from math import ceil
from typing import Any, Callable, Dict, Iterator, List, Mapping, Sequence

import rosgraph
from exchange import PATIENCE, PROGRAMS
from repetitions import Plan, Timing, in_turn, timing_of, worst_and_median
from rich.table import Table as RichTable

from safety_control_cloud.processes import ProcessError, process
from safety_control_cloud.ros_session import PACKAGE, executable_of

ONE_CAMERA = "nodelet_with_one_camera"
NODELETS = ("nodelet", ONE_CAMERA)
SIDES = ("ours", "floor", *NODELETS)
COMMANDS_A_CLOUD = 5
WITH_COLOURS = 32  # [byte] a point
NODE = "/safety_control_cloud"
PARAMETERS: Dict[str, Any] = {
    "mode": "guard",
    "sensors": [
        {"name": "front", "type": "cloud", "topic": "front/points"},
        {"name": "rear", "type": "cloud", "topic": "rear/points"},
        {"name": "laser", "type": "scan", "topic": "scan"},
    ],
}


@dataclass(frozen=True)
class Cost:
    latency_ms: Timing  # of the repetitions' medians
    latency_p99_ms: float  # of the commands of all repetitions
    cpu_share: Timing  # of a core; of the nodelet nobody knows: it shares its process


Table = Dict[str, Cost]


def cases(plan: Plan) -> Sequence[str]:
    return SIDES


def measure(plan: Plan, done: Callable[[], None]) -> Table:
    """Needs a master."""
    met = in_turn(SIDES, plan, lambda side: drive(side, plan.clouds * COMMANDS_A_CLOUD), done)
    return {side: cost_of(all_) for side, all_ in met.items()}


@contextmanager
def parameters(values: Mapping[str, Any]) -> Iterator[None]:
    """On the master for as long."""
    master = rosgraph.Master("/bench")
    for name, value in values.items():
        master.setParam(name, value)
    try:
        yield
    finally:
        for name in values:
            master.deleteParam(name)


def commands_of(side: str) -> List[List[str]]:
    """What guards, in a process of its own; a nodelet does in the driver's."""
    guards = {"floor": [str(PROGRAMS / "floor_node"), "guard"], "ours": [executable_of(PACKAGE, "safety_control_node")]}
    return [guards[side]] if side in guards else []


def drive(side: str, commands: int) -> Mapping[str, Any]:
    sensors = PARAMETERS["sensors"][: 1 if side == ONE_CAMERA else None]
    with parameters({NODE: {**PARAMETERS, "sensors": sensors}}):
        met = driven(commands_of(side), commands, len(sensors))
    if met["said"] > 1.1 * commands + 10:
        raise ProcessError(f"of {met['said']} commands that are safe only {commands} were passed")
    return met


def driven(guards: Sequence[Sequence[str]], commands: int, sensors: int, point_step: int = WITH_COLOURS) -> Mapping[str, Any]:
    """What the driver says of so many commands, with the first so many sensors: guard_drive.cpp.

    A camera that is a process of its own sends so many bytes a point.
    """
    forget()
    cameras = [[str(PROGRAMS / "guard_drive"), "cameras", str(sensors), str(point_step)]] if guards else []
    with ExitStack() as stack:
        for camera in cameras:
            stack.enter_context(process(camera))
        nodes = [stack.enter_context(process(guard)) for guard in guards]
        numbers = [str(number) for number in (commands, sensors, *(node.pid for node in nodes))]
        driver = stack.enter_context(process([str(PROGRAMS / "guard_drive"), *numbers]))
        code = driver.wait(commands / 50.0 + PATIENCE)
        lines = [line for line in driver.output().splitlines() if line.startswith("{")]
        if code != 0 or not lines:
            raise ProcessError("\n".join(one.output() for one in (driver, *nodes)))
    return json.loads(lines[-1])


def forget() -> None:
    """What a node of this name had near before it, in another scene maybe, is on the master: it would be missed in this one."""
    master = rosgraph.Master("/bench")
    if master.hasParam(f"{NODE}_lost"):
        master.deleteParam(f"{NODE}_lost")


def p99(latencies: Sequence[float]) -> float:
    return sorted(latencies)[ceil(0.99 * len(latencies)) - 1]


def cost_of(met: Sequence[Mapping[str, Any]]) -> Cost:
    return Cost(
        latency_ms=timing_of([timing_of(one["latency_ms"]).median for one in met]),
        latency_p99_ms=p99([latency for one in met for latency in one["latency_ms"]]),
        cpu_share=timing_of([one["cpu_share"] for one in met]),
    )


def figures(table: Table) -> Dict[str, Dict[str, float]]:
    return {
        "guard_latency_ms": worst_and_median([table["ours"].latency_ms.median]),
        "guard_latency_p99_ms": worst_and_median([table["ours"].latency_p99_ms]),
        "guard_nodelet_latency_ms": worst_and_median([table["nodelet"].latency_ms.median]),
        "guard_nodelet_with_one_camera_latency_ms": worst_and_median([table[ONE_CAMERA].latency_ms.median]),
        "guard_cpu_vs_floor": worst_and_median([table["ours"].cpu_share.median / table["floor"].cpu_share.median]),
    }


def table_of(table: Table) -> RichTable:
    shown = RichTable("node", title="The guard: two VGA cameras and a laser at 20 Hz, commands at 50 Hz")
    for heading in ("command to answer [ms]", "spread", "p99", "CPU [of a core]", "spread"):
        shown.add_column(heading, justify="right")
    for side, cost in table.items():
        used = ("-", "-") if side in NODELETS else (f"{cost.cpu_share.median:.1%}", f"{cost.cpu_share.spread:.0%}")
        shown.add_row(side, f"{cost.latency_ms.median:.2f}", f"{cost.latency_ms.spread:.0%}", f"{cost.latency_p99_ms:.2f}", *used)
    return shown


def as_json(table: Table) -> List[Dict[str, object]]:
    return [{"side": side, **asdict(cost)} for side, cost in table.items()]
