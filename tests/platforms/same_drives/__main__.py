# SPDX-License-Identifier: BSD-3-Clause
"""The same drives in Gazebo, by the real node, and in MuJoCo: does the robot stand in the same place?"""
from __future__ import annotations

import argparse
import json
import sys
import time
from contextlib import contextmanager
from math import isfinite
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Iterable, Iterator, Sequence

from safety_control_cloud.commands.arguments import count, seed

if TYPE_CHECKING:
    from driven import Pair
    from rich.console import Console

    from safety_control_cloud.processes import Process
    from safety_control_cloud.trials.scenario import Scenario

FLOOR = '<mujoco><worldbody><geom name="floor" type="plane" size="20 20 1" rgba="0.62 0.61 0.58 1"/></worldbody></mujoco>'
COMES_UP = 120.0  # [s] of real time; a busy machine is slow, not broken


def main() -> int:
    arguments = options()
    from drives_told import is_well, table_of, to_json, verdict_of  # after the arguments: --help needs Python alone
    from rich.console import Console

    from safety_control_cloud.gazebo_ros import gazebo_ros_executable
    from safety_control_cloud.processes import ProcessError, end_on_sigterm

    end_on_sigterm()
    console = Console(width=None if sys.stdout.isatty() else 150, highlight=False)
    try:
        gazebo_ros_executable("gzserver")
        pairs, latency = drive_all(scenarios_of(arguments), arguments)
    except ProcessError as error:
        print(f"same_drives: {error}", file=sys.stderr)
        return 2
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "drives.json").write_text(json.dumps(to_json(pairs, latency), indent=1) + "\n")
    console.print(table_of(pairs))
    for line in verdict_of(pairs, latency):
        console.print(line)
    draw_exceptions(pairs, arguments.out, console)
    return 0 if is_well(pairs) else 1


def options(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="same_drives", description=__doc__, epilog="Exit code 1: it touched something, or stood elsewhere in more than a "
        "twentieth of the drives. Wants Gazebo 11 with gazebo_ros or its stand-ins, and MuJoCo.")
    parser.add_argument("--episodes", metavar="N", type=count, default=60, help="shared out among the families [%(default)s]")
    parser.add_argument("--seed", metavar="S", type=seed, default=1, help="the first of each family [%(default)s]")
    parser.add_argument("--only", metavar="FAMILY:SEED", action="append", default=[], help="this one; may be repeated")
    parser.add_argument("--out", metavar="DIR", type=Path, default=Path("build/same_drives"),
                        help="for drives.json, and a picture of each drive that ends elsewhere [%(default)s]")
    return parser.parse_args(arguments)


def scenarios_of(arguments: argparse.Namespace) -> list[Scenario]:
    from drawn_drives import drawn, without_faults

    from safety_control_cloud.trials.families import scenario_of

    if not arguments.only:
        return drawn(arguments.episodes, arguments.seed)
    named = (name.split(":") for name in arguments.only)
    return [without_faults(scenario_of(family, int(seed))) for family, seed in named]


def drive_all(scenarios: Sequence[Scenario], arguments: argparse.Namespace) -> tuple[list[Pair], float]:
    """First all in Gazebo, then in MuJoCo with the latency that was found there [s]. Raises ProcessError."""
    import driven_in_mujoco
    from driven import Pair

    from safety_control_cloud.ros_session import roscore

    with roscore(), gazebo() as drive:
        gazebos = [drive(one) for one in _with_progress(scenarios, "in Gazebo")]
    latency = median([one.latency for one in gazebos if isfinite(one.latency)] or [0.0])
    mujocos = [driven_in_mujoco.drive(one, latency) for one in _with_progress(scenarios, "in MuJoCo")]
    return [Pair(*pair) for pair in zip(scenarios, mujocos, gazebos)], latency


def _with_progress(scenarios: Sequence[Scenario], where: str) -> Iterable[Scenario]:
    from rich.console import Console
    from rich.progress import track

    return track(scenarios, where, console=Console(stderr=True), transient=True)


@contextmanager
def gazebo() -> Iterator:
    """Gives what drives a scenario there. Raises ProcessError."""
    import rospy

    from safety_control_cloud.processes import OF_ROSLAUNCH, ProcessError, process

    with TemporaryDirectory(prefix="same_drives_") as folder:
        world = Path(folder) / "floor.xml"
        world.write_text(FLOOR)
        launch = ["roslaunch", "safety_control_cloud", "demo.launch", "simulator:=gazebo", f"world:={world}", "size:=320x240"]
        with process(launch, OF_ROSLAUNCH) as running:
            try:
                _join(running)
                from driven_in_gazebo import Gazebo

                yield Gazebo().drive
            except (rospy.ROSException, rospy.ServiceException) as error:
                raise ProcessError(f"{error}\n{running.output()}") from error
            finally:
                rospy.signal_shutdown("the drives are over")


def _join(launch: Process) -> None:
    """Become a node once time is known to be simulated; rospy asks only once."""
    import rosgraph
    import rospy

    from safety_control_cloud.processes import ProcessError

    master, give_up = rosgraph.Master("/same_drives"), time.monotonic() + COMES_UP
    while time.monotonic() < give_up and launch.exit_code is None:
        if master.hasParam("/use_sim_time"):
            rospy.init_node("same_drives", disable_signals=True)
            return
        time.sleep(0.1)
    raise ProcessError(f"ROS did not come up\n{launch.output()}")


def draw_exceptions(pairs: Sequence[Pair], folder: Path, console: Console) -> None:
    from drawn_pairs import draw

    for pair in pairs:
        if not pair.is_near or pair.touches:
            path = folder / f"{pair.scenario.name.replace(':', '_')}.png"
            draw(pair, path)
            console.print(f"picture: {path}")


if __name__ == "__main__":
    sys.exit(main())
