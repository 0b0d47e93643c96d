# SPDX-License-Identifier: BSD-3-Clause
"""The demo from start to end."""
from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import rosgraph
import rospy
from rich.console import Console

from .bag import Recorder
from .picture import COLOURS, draw
from .record import Approach, Sample
from .stack import Stack, launched
from .watch import Watch

APPROACHES = 2  # as in the tutorial: it is moved back, and does it again


@dataclass(frozen=True)
class Options:
    world: str
    folder: Path  # for picture, bag and log
    rviz: bool
    patience: float  # [s] of simulated time for a drive


def run(options: Options) -> bool:
    """Did the robot stand in Danger, having touched nothing, every time?"""
    options.folder.mkdir(parents=True, exist_ok=True)
    console = Console(highlight=False)
    arguments = [f"world:={options.world}", f"rviz:={str(options.rviz).lower()}"]
    with launched("demo.launch", arguments, options.folder / "roslaunch.log") as stack:
        _join(stack)
        recorder = Recorder(options.folder / "run.bag")
        try:
            approaches = _drive(stack, options.patience, console)
        finally:
            recorder.close()
        rospy.signal_shutdown("the demo is over")
    return _report(approaches, options, console)


def _join(stack: Stack) -> None:
    """Become a node once roslaunch has said that time is simulated; rospy asks only once."""
    master = rosgraph.Master("/safety_demo")
    give_up = time.monotonic() + 30
    while time.monotonic() < give_up and stack.is_running:
        try:
            if master.getParam("/use_sim_time"):
                rospy.init_node("safety_demo", disable_signals=True)
                return
        except (OSError, rosgraph.MasterException):
            time.sleep(0.1)
    raise RuntimeError("ROS did not come up; see roslaunch.log")


def _drive(stack: Stack, patience: float, console: Console) -> list[Approach]:
    watch = Watch(lambda sample: console.print(_line(sample)))
    start = watch.reset()
    approaches: list[Approach] = []
    for turn in range(APPROACHES):
        if turn:
            console.print("\n[bold]The robot is moved back, and does it again[/]")
            watch.move_to(start)
        approaches.append(watch.approach(patience, lambda: stack.is_running))
    return approaches


def _line(sample: Sample) -> str:
    zone = f"{sample.zone} zone"
    return (
        f"{sample.time:7.2f} s   [bold {COLOURS.get(sample.zone, 'white')}]{zone:<12}[/]   nearest {sample.nearest:5.2f} m   "
        f"/mobile_base/commands/velocity linear.x {sample.commanded:.1f}   driven {sample.speed:.2f} m/s"
    )


def _report(approaches: list[Approach], options: Options, console: Console) -> bool:
    console.print()
    for turn, approach in enumerate(approaches, start=1):
        if approach.problem:
            console.print(f"[bold red]Drive {turn}: {approach.problem}[/]")
        else:
            console.print(f"[bold green]Drive {turn}: {' > '.join(approach.zones)}; stands {approach.stood_at:.2f} m before the obstacle, touched nothing[/]")
    if all(approach.samples for approach in approaches):
        draw(approaches, Path(options.world).stem, options.folder / "run.png")
    console.print(f"Picture, bag and log: {options.folder}/run.png, run.bag, roslaunch.log")
    return not any(approach.problem for approach in approaches)
