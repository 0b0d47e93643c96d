# SPDX-License-Identifier: BSD-3-Clause
"""What both simulators made of the drives: in a terminal, as JSON, and whether it is well."""
from __future__ import annotations

import shlex
import sys
from datetime import date
from math import isfinite
from statistics import median
from typing import Sequence

from driven import Driven, Pair
from rich.table import Table
from rich.text import Text

ENOUGH = 0.95  # share of the drives that have to end near each other


def is_well(pairs: Sequence[Pair]) -> bool:
    return not any(pair.touches for pair in pairs) and sum(pair.is_near for pair in pairs) >= ENOUGH * len(pairs)


def table_of(pairs: Sequence[Pair]) -> Table:
    table = Table(title="Where the robot stands")
    for heading in ("drive", "MuJoCo: x, y [m]", "cause", "clear [m]", "Gazebo: x, y [m]", "cause", "clear [m]", "apart [cm]"):
        table.add_column(Text(heading), no_wrap=True)
    for pair in pairs:
        style = None if pair.is_near and not pair.touches else "bold red"
        table.add_row(pair.scenario.name, *_cells(pair.mujoco), *_cells(pair.gazebo), f"{100 * pair.apart:.1f}", style=style)
    return table


def _cells(driven: Driven) -> tuple[str, str, str]:
    moves = "" if driven.stands else " moves"
    return f"{driven.end.x:.3f} {driven.end.y:+.3f}{moves}", driven.cause, f"{driven.clearance:.3f}"


def verdict_of(pairs: Sequence[Pair], latency: float) -> list[str]:
    near, aparts = sum(pair.is_near for pair in pairs), [pair.apart for pair in pairs]
    touching = [pair.scenario.name for pair in pairs if pair.touches]
    return [
        f"{near} of {len(pairs)} stand within 3 cm of MuJoCo's place; apart {100 * median(aparts):.1f} cm (median), "
        f"{100 * max(aparts):.1f} cm (most); {', '.join(touching) or 'none'} touches",
        f"latency in Gazebo {1000 * latency:.0f} ms, given to MuJoCo; of the first pictures' pixels "
        f"{100 * median(pair.unlike for pair in pairs):.2f} % differ (median), {100 * max(pair.unlike for pair in pairs):.2f} % (most)",
    ]


def to_json(pairs: Sequence[Pair], latency: float) -> dict:
    drives = [{
        "drive": pair.scenario.name, "apart": pair.apart, "near": pair.is_near, "touches": pair.touches, "unlike": pair.unlike,
        **{name: {"x": one.end.x, "y": one.end.y, "yaw": one.end.yaw, "stands": one.stands, "cause": one.cause,
                  "clearance": one.clearance, "seconds": one.track[-1].time - one.track[0].time,
                  "latency": one.latency if isfinite(one.latency) else None}
           for name, one in (("mujoco", pair.mujoco), ("gazebo", pair.gazebo))},
    } for pair in pairs]
    return {"command": shlex.join(sys.argv), "date": date.today().isoformat(), "latency": latency, "drives": drives}
