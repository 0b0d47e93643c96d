# SPDX-License-Identifier: BSD-3-Clause
"""What to replay, by the command line; needs Python alone."""
from __future__ import annotations

import argparse
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, Mapping, Optional, Sequence

from safety_control_cloud.commands.arguments import parameter
from safety_control_cloud.view import options as view

PURPOSE = "Tells what the safety node would have said to every cloud of a bag, or of every command in it (--mode guard)."
EPILOG = """\
--mode guard: the guard's own decision in the bag's own time, on all of its sensors (PointCloud2, depth images with
their CameraInfo, LaserScan), odometry, transforms and the commands that were recorded: what of them it would have
given, beside what was driven. The table has a row for each span in which it did the same, --json each answer.

exit codes: 1 the node failed, 2 nothing to replay, or not to be told what, 130 interrupted"""
GUARD = "guard"
MODES = ("drive", GUARD)
PICTURES = (".png", ".pdf", ".svg")


@dataclass(frozen=True)
class Request:
    """What to replay, and where to write it besides the table on stdout."""

    bags: Sequence[Path]
    topics: Sequence[str] = ()  # none: the node's own, or else all
    parameters: Mapping[str, str] = field(default_factory=dict)  # private ones of the node
    json: Optional[Path] = None
    plot: Optional[Path] = None
    around: Optional[int] = None  # only the clouds next to this one, from 0, stand in the table
    settings: Optional[Path] = None  # a file of parameters; `parameters` go before
    rrd: Optional[Path] = None
    view: bool = False
    mode: Optional[str] = None  # as the parameters have it
    cmd_vel: Optional[str] = None  # topic of the commands, in mode guard
    odom: Optional[str] = None


def request_of(arguments: Optional[Sequence[str]] = None) -> Request:
    parser = argparse.ArgumentParser(prog="replay", description=PURPOSE, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bags", metavar="BAG", nargs="+", type=Path, help="a ROS 1 bag, or a ROS 2 bag (a folder, *.mcap, *.db3)")
    parser.add_argument("--topic", metavar="T", action="append", default=[],
                        help="of clouds, or of depth images that have a CameraInfo beside them; may be repeated, and each "
                        "is then a robot of its own [the node's own, else all]; in mode guard one of its sensors [all]")
    parser.add_argument("--mode", choices=MODES, help="of the node [drive]")
    parser.add_argument("--cmd-vel", metavar="T", help="mode guard: Twist or TwistStamped [the one named cmd_vel*]")
    parser.add_argument("--odom", metavar="T", help="mode guard: nav_msgs/Odometry [odom, else the only one]")
    parser.add_argument("--method", choices=("one_pass", "pcl"), help="how the node searches the corridor")
    parser.add_argument("--param", metavar="NAME=VALUE", type=parameter, action="append", default=[],
                        help="a private parameter of the node, e.g. --param danger_distance=0.6; may be repeated")
    parser.add_argument("--settings", metavar="F.yaml", type=Path, help="parameters, as in config/default.yaml")
    parser.add_argument("--around", metavar="N", type=int, help="show only the clouds next to this one of each topic, from 0")
    parser.add_argument("--json", metavar="F", type=view.writable, help="write the table as a list of objects")
    parser.add_argument("--plot", metavar="F.png", type=_picture, help="draw distance and speed over time")
    view.add_to(parser)
    given = parser.parse_args(arguments)
    parameters: Dict[str, str] = dict(given.param)
    if given.method:
        parameters["method"] = given.method
    return Request(tuple(given.bags), tuple(given.topic), parameters, given.json, given.plot, given.around,
                   given.settings, given.rrd, given.view, given.mode, given.cmd_vel, given.odom)


def _picture(text: str) -> Path:
    if Path(text).suffix not in PICTURES:
        raise argparse.ArgumentTypeError(f"{text!r} does not end in {', '.join(PICTURES)}")
    return view.writable(text)
