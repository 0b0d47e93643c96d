# SPDX-License-Identifier: BSD-3-Clause
"""scripts/demo: a TurtleBot drives up to a cabinet, slows down and stands; it is moved back, and does it again.

As `guard`: somebody tries to hit things with it for two minutes, and the node stands between him and the base."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from ..commands.arguments import positive, seed
from ..commands.complaint import complain
from ..optional import MissingPackages, require
from ..processes import ProcessError, end_on_sigterm
from ..simulation.world_files import world_argument, world_names
from ..view.options import add_to, make, recorded_in

if TYPE_CHECKING:
    from .run import Options

SECONDS, SEED = 120.0, 1  # of the guard's drive


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="demo", description=__doc__.split(": ", 1)[1],
        epilog="Ends with 0 only if the robot stood in Danger, having touched nothing, both times; as guard, if it touched "
        "nothing.")
    parser.add_argument("what", nargs="?", default="approach", choices=("approach", "guard"), help="(%(default)s)")
    parser.add_argument("--world", type=world_argument,
                        help=f"{', '.join(world_names())}, or an MJCF file (cabinet; as guard, playground)")
    parser.add_argument("--seconds", type=positive, help=f"as guard: so long [s] somebody drives ({SECONDS:g})")
    parser.add_argument("--seed", type=seed, help=f"as guard: of what he tries ({SEED})")
    parser.add_argument("--simulator", default="mujoco", choices=("mujoco", "gazebo"), help="(%(default)s)")
    parser.add_argument("--rviz", action="store_true", help="open rviz beside it")
    parser.add_argument("--out", type=Path, default=Path("safety_demo"), help="folder for the picture and the bag")
    parser.add_argument("--patience", type=positive, default=60.0, help="[s] a drive may take (%(default)s)")
    add_to(parser)
    arguments = parser.parse_args(argv)
    guards = arguments.what == "guard"
    if guards and arguments.simulator == "gazebo":
        parser.error("guard goes with --simulator mujoco")
    for name in ("seconds", "seed"):
        if getattr(arguments, name) is not None and not guards:
            parser.error(f"--{name} goes with guard")
    try:
        require("demo")
    except MissingPackages as error:
        return complain("demo", error)
    make(arguments.out, parser)
    import rospy  # after the arguments: --help needs Python alone

    from ..gazebo_ros import gazebo_ros_executable
    from .run import Options, run

    end_on_sigterm()
    if arguments.simulator == "gazebo":
        try:
            gazebo_ros_executable("gzserver")
        except ProcessError as missing:
            return complain("demo", missing)
    try:
        with recorded_in(arguments.rrd, arguments.view) as rrd:
            options = Options(arguments.world or ("playground" if guards else "cabinet"), arguments.simulator, arguments.out,
                              arguments.rviz, arguments.patience, rrd)
            if guards:
                return _guard(options, arguments)
            return 0 if run(options) else 1
    except MissingPackages as error:
        return complain("demo", error)
    except (ProcessError, rospy.ROSException) as error:
        return complain("demo", f"{error}; see {arguments.out / 'roslaunch.log'}")
    except KeyboardInterrupt:
        return 130


def _guard(options: Options, arguments: argparse.Namespace) -> int:
    from .guarded import BadWorld, run_guarded

    try:
        seconds, seed = arguments.seconds or SECONDS, SEED if arguments.seed is None else arguments.seed
        return 0 if run_guarded(options, seconds, seed) else 1
    except BadWorld as error:
        return complain("demo", error)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
