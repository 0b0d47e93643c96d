# SPDX-License-Identifier: BSD-3-Clause
"""scripts/gazebo_world: Gazebo 11 with a world and the TurtleBot in it, by gazebo_ros' own gzserver."""
from __future__ import annotations

import argparse
import os
import signal
import socket
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import urlsplit
from xml.etree.ElementTree import ParseError

from ..processes import ProcessError
from ..simulation.furniture import furniture_of
from ..simulation.sdf import write_world
from ..simulation.world_files import world_file, world_names
from ..virtual_screen import virtual_screen
from .arguments import not_negative, picture_size, seed
from .remappings import without_remappings

_PATIENCE = 300.0  # [s] of the window, for Gazebo to come up


def main(argv: list[str]) -> int:
    arguments, remappings = _parsed(argv[1:])
    from ..gazebo_ros import gazebo_ros_executable  # after the arguments: --help needs Python alone

    try:
        if arguments.window:
            window = gazebo_ros_executable("gzclient")
            _wait_for_gazebo()
            return _run([window, *remappings])
        server = gazebo_ros_executable("gzserver")
        furniture = furniture_of(world_file(arguments.world))
        with ExitStack() as held:
            folder = Path(held.enter_context(TemporaryDirectory(prefix="gazebo_world_")))
            world = write_world(furniture, arguments.urdf, arguments.size, arguments.rate, folder)
            if not os.environ.get("DISPLAY"):  # Gazebo's cameras draw on a screen, like its window
                os.environ.update(DISPLAY=held.enter_context(virtual_screen()), LIBGL_ALWAYS_SOFTWARE="1")
            return _run([server, *_in_lockstep(), "--seed", str(arguments.seed), str(world), *remappings])
    except (ProcessError, FileNotFoundError, ValueError, ParseError) as error:
        print(f"gazebo_world: {error}", file=sys.stderr)
        return 2


def _parsed(argv: list[str]) -> tuple[argparse.Namespace, list[str]]:
    """The arguments, and what roslaunch adds: those are for Gazebo's own node."""
    parser = argparse.ArgumentParser(
        prog="gazebo_world", description=__doc__.split(": ", 1)[1],
        formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--world", default="cabinet", help=f"{', '.join(world_names())}, or an MJCF file")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--urdf", type=Path, default=argparse.SUPPRESS, help="the robot, with its plugins for Gazebo")
    what.add_argument("--window", action="store_true", help="only open Gazebo's window, for one that runs")
    parser.add_argument("--size", default="640x480", type=picture_size, help="of the camera's pictures [px]")
    parser.add_argument("--rate", default=1.0, type=not_negative, help="simulated seconds a real one; 0: as fast as it goes")
    parser.add_argument("--seed", default=0, type=seed, help="of Gazebo's random numbers")
    return parser.parse_args(without_remappings(argv)), [text for text in argv if ":=" in text]


def _wait_for_gazebo() -> None:
    """gzclient waits for some seconds only, and Gazebo may take longer to come up. Raises ProcessError."""
    master = urlsplit(os.environ.get("GAZEBO_MASTER_URI") or "http://localhost:11345")
    give_up = time.monotonic() + _PATIENCE
    while time.monotonic() < give_up:
        try:
            socket.create_connection((master.hostname, master.port), timeout=1.0).close()
            return
        except OSError:
            time.sleep(0.5)
    raise ProcessError(f"no Gazebo answers at {master.geturl()}")


def _in_lockstep() -> list[str]:
    """The option that lets Gazebo wait for its camera, which Gazebo 11.0, Ubuntu 20.04's own, does not have yet."""
    offered = subprocess.run(["gzserver", "--help"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return ["--lockstep"] if "--lockstep" in offered.stdout else []


def _run(command: list[str]) -> int:
    """Until it ends; roslaunch's signals reach it by themselves, and what was made for it stays until then."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: None)
    os.environ.setdefault("GAZEBO_MODEL_DATABASE_URI", "")  # else it looks for models on the network
    return subprocess.call(command)


if __name__ == "__main__":
    sys.exit(main(sys.argv))
