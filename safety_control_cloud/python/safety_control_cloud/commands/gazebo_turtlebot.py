# SPDX-License-Identifier: BSD-3-Clause
"""scripts/gazebo_turtlebot: what the real TurtleBot has and gazebo_ros' differential drive lacks, beside Gazebo."""
from __future__ import annotations

import argparse
import sys
from xml.etree.ElementTree import ParseError

from ..simulation.base import LIMITS
from ..simulation.world_files import world_file, world_names
from .complaint import complain
from .remappings import without_remappings


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="gazebo_turtlebot", description=__doc__.split(": ", 1)[1],
        formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--world", default="cabinet", help=f"{', '.join(world_names())}, or an MJCF file")
    parser.add_argument("--wheels", default="driver", choices=sorted(LIMITS),
                        help="with the driver's acceleration limits, or obeying at once as Gazebo's own")
    arguments = parser.parse_args(without_remappings(argv[1:]))
    from ..gazebo_ros import MISSING  # after the arguments: --help needs Python alone
    from ..simulation.furniture import furniture_of

    try:
        furniture = furniture_of(world_file(arguments.world))
        from ..nodes.gazebo_turtlebot import GazeboTurtlebot
        from ..nodes.life import Life
    except (FileNotFoundError, ValueError, ParseError) as error:
        return complain("gazebo_turtlebot", error)
    except ModuleNotFoundError as missing:
        if not str(missing.name).startswith("gazebo_msgs"):
            raise
        return complain("gazebo_turtlebot", MISSING)
    life = Life("turtlebot_sim")
    GazeboTurtlebot(furniture, LIMITS[arguments.wheels]).run(life)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
