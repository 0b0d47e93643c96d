# SPDX-License-Identifier: BSD-3-Clause
"""What to judge, by the command line; needs Python alone."""
from __future__ import annotations

import argparse
from os import cpu_count
from pathlib import Path
from typing import Optional, Sequence

from safety_control_cloud.commands.arguments import count, parameter
from safety_control_cloud.replay.options import MODES

PURPOSE = "Judges recorded drives by the node's own decision: each cloud or command of each bag, in the bag's own time."
EPILOG = """\
A bag is a ROS 1 bag (*.bag) or a ROS 2 bag (a folder, *.mcap, *.db3) with PointCloud2, or with depth images and their
CameraInfo. Its time is the time at which it was recorded: a cloud is as old as it was then, and where none came for
source_timeout there is a row with the cause SILENT. What has been judged stands in OUT and is not judged again.

--mode guard asks the guard about each command that was recorded, as scripts/replay --mode guard does about one bag, on
all sensors of the bag, LaserScan among them; its rows are below OUT/guard.

exit codes: 0 all bags judged, 1 some could not be read (their rows say why), 2 nothing to judge or to write it to,
130 interrupted (the same command goes on)"""


def options(arguments: Optional[Sequence[str]] = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="judge", description=PURPOSE, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bags", metavar="BAG", nargs="+", help="bags, folders of bags, globs, or s3://bucket/...")
    parser.add_argument("--out", metavar="DIR", type=Path, default=Path("judged"), help="what has been judged [%(default)s]")
    parser.add_argument("--mode", choices=MODES, help="of the node [that of the settings, drive]")
    parser.add_argument("--topic", metavar="T", action="append", default=[],
                        help="only this one; may be repeated [the node's own, else all]; in mode guard one of its sensors [all]")
    parser.add_argument("--cmd-vel", metavar="T", help="mode guard: Twist or TwistStamped [the one named cmd_vel*]")
    parser.add_argument("--odom", metavar="T", help="mode guard: nav_msgs/Odometry [odom, else the only one]")
    parser.add_argument("--settings", metavar="F.yaml", type=Path, help="the node's parameters, as in config/default.yaml")
    parser.add_argument("--param", metavar="NAME=VALUE", type=parameter, action="append", default=[],
                        help="one of them; goes before the file")
    parser.add_argument("--compare", metavar=("A.yaml", "B.yaml"), nargs=2, type=Path,
                        help="judge by both, and show what changes from A to B")
    parser.add_argument("--jobs", metavar="J", type=count, default=cpu_count() or 1, help="processes [%(default)s]")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="judge on the workers of this Dask scheduler")
    parser.add_argument("--report", metavar="DIR", type=Path, help="write a page to read")
    given = parser.parse_args(arguments)
    if given.compare and given.settings:
        parser.error("--compare has its own settings")
    return given
