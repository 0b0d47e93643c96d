# SPDX-License-Identifier: BSD-3-Clause
"""The demo from start to end."""
from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from threading import Thread

import rosgraph
import rospy
from rich.console import Console

from ..processes import OF_ROSLAUNCH, Process, ProcessError, process
from ..ros_session import roscore
from .picture import COLOURS, draw
from .record import Approach, Sample
from .watch import Watch

APPROACHES = 2  # as in the tutorial: it is moved back, and does it again
_START_TIMEOUT = 30.0  # [s]


@dataclass(frozen=True)
class Options:
    world: str
    simulator: str  # mujoco or gazebo
    folder: Path  # for picture, bag and logs
    rviz: bool
    patience: float  # [s] of simulated time for a drive
    rrd: Path | None = None  # a recording for the viewer


def run(options: Options) -> bool:
    """Did the robot stand in Danger, having touched nothing, every time?

    Raises ProcessError if ROS does not come up.
    """
    options.folder.mkdir(parents=True, exist_ok=True)
    console = Console(highlight=False, soft_wrap=True)
    with stage(options) as launch:
        approaches = _drive(launch, options.patience, console)
    return _report(approaches, options, console)


@contextmanager
def stage(options: Options, *more: str) -> Iterator[Process]:
    """The whole stack, joined and recorded for as long as the block lasts; `more` arguments of demo.launch."""
    with roscore(), _launched(options, *more) as launch, _watched(launch):
        _join(launch)
        with ExitStack() as recorders:
            recorders.enter_context(
                process([sys.executable, "-m", "safety_control_cloud.demo.bag", str(options.folder / "run.bag")]))
            if options.rrd:
                recorders.enter_context(process([sys.executable, "-m", "safety_control_cloud.commands.view_node",
                                                 "--rrd", str(options.rrd.absolute()), "--odometry", "/odom"]))
            yield launch
        rospy.signal_shutdown("the demo is over")


@contextmanager
def _launched(options: Options, *more: str) -> Iterator[Process]:
    """What it says is kept in roslaunch.log."""
    arguments = [f"simulator:={options.simulator}", f"world:={options.world}", f"rviz:={str(options.rviz).lower()}"]
    launch = Process(["roslaunch", "safety_control_cloud", "demo.launch", *arguments, *more], OF_ROSLAUNCH)
    try:
        yield launch
    finally:
        launch.end()
        (options.folder / "roslaunch.log").write_text(launch.output())


@contextmanager
def _watched(launch: Process) -> Iterator[None]:
    """Who waits in the block for something of ROS waits no longer once roslaunch has ended.

    It ends with the simulator, and with it the simulated time that rospy sleeps by. Raises ProcessError then.
    """
    Thread(target=_shut_down_after, args=(launch,), daemon=True).start()
    try:
        yield
    except (rospy.ROSInterruptException, rospy.ServiceException) as interrupted:
        if launch.exit_code is None:
            raise
        raise ProcessError(_why_ended(launch)) from interrupted


def _shut_down_after(launch: Process) -> None:
    while launch.exit_code is None:
        time.sleep(0.1)
    rospy.signal_shutdown("roslaunch has ended")


def _why_ended(launch: Process) -> str:
    """In the simulator's words, if it has said any."""
    said = [line for line in launch.output().splitlines() if line.startswith("turtlebot_sim: ")]
    return said[-1] if said else "roslaunch has ended, and with it the simulator"


def _join(launch: Process) -> None:
    """Become a node once roslaunch has said that time is simulated; rospy asks only once."""
    master = rosgraph.Master("/safety_demo")
    give_up = time.monotonic() + _START_TIMEOUT
    while time.monotonic() < give_up and launch.exit_code is None:
        try:
            if master.getParam("/use_sim_time"):
                rospy.init_node("safety_demo", disable_signals=True)
                return
        except rosgraph.MasterException:
            time.sleep(0.1)
    raise ProcessError("ROS did not come up" if launch.exit_code is None else _why_ended(launch))


def _drive(launch: Process, patience: float, console: Console) -> list[Approach]:
    watch = Watch(lambda sample: console.print(_line(sample)))
    start = watch.reset()
    console.print("[dim]   time   zone           nearest   /mobile_base/commands/velocity   driven[/]")
    approaches: list[Approach] = []
    for turn in range(APPROACHES):
        if turn:
            console.print("\n[bold]The robot is moved back, and does it again[/]")
            watch.move_to(start)
        approaches.append(watch.approach(patience, lambda: launch.exit_code is None))
    return approaches


def _line(sample: Sample) -> str:
    zone = f"[bold {COLOURS.get(sample.zone, 'white')}]{sample.zone + ' zone':<12}[/]"
    where, speeds = f"{sample.nearest:6.2f} m", f"linear.x {sample.commanded:.1f} m/s{sample.speed:21.2f} m/s"
    return f"{sample.time:6.2f} s  {zone}  {where}   {speeds}"


def _report(approaches: Sequence[Approach], options: Options, console: Console) -> bool:
    console.print()
    for turn, approach in enumerate(approaches, start=1):
        console.print(f"Drive {turn}: {_verdict(approach)}")
    if all(approach.samples for approach in approaches):
        draw(approaches, Path(options.world).stem, options.folder / "run.png")
    console.print(f"Picture {options.folder / 'run.png'}, bag {options.folder / 'run.bag'}")
    return not any(approach.problem for approach in approaches)


def _verdict(approach: Approach) -> str:
    if approach.problem:
        return f"[bold red]{approach.problem}[/]"
    zones = ", ".join(approach.zones)
    return f"[bold green]{zones}; stands {approach.stood_at:.2f} m before the obstacle and touched nothing[/]"
