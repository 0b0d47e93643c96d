# SPDX-License-Identifier: BSD-3-Clause
"""scripts/view_node: shows a running safety node in browsers, on any computer that reaches this one, or records it."""
from __future__ import annotations

import argparse
import socket
import sys

from ..optional import MissingPackages, require
from ..view.options import recording_file
from .arguments import positive
from .complaint import complain
from .remappings import without_remappings


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="view_node", description=__doc__.split(": ", 1)[1])
    parser.add_argument("--node", default="safety_control_cloud", help="the safety node's name [%(default)s]")
    parser.add_argument("--rate", type=positive, default=5.0, help="[Hz] at most [%(default)s]")
    parser.add_argument("--host", default=socket.gethostname(), help="this machine's name, as the browser knows it [%(default)s]")
    parser.add_argument("--port", type=int, default=9090, help="of the page [%(default)s]")
    parser.add_argument("--data-port", type=int, default=9876, help="of what it shows [%(default)s]")
    parser.add_argument("--odometry", metavar="TOPIC", help="where the base tells its speed")
    parser.add_argument("--rrd", metavar="F.rrd", type=recording_file, help="record in place of showing")
    given = parser.parse_args(without_remappings(argv[1:]))
    try:
        require("view")
    except MissingPackages as error:
        return complain("view_node", error)
    import rospy  # after the arguments: --help needs Python alone

    from ..nodes.life import Life
    from ..nodes.view import Viewer
    from ..view.sink import into_file, to_browsers

    life = Life("safety_view")
    viewer = Viewer(given.node, given.rate, given.odometry)
    if given.rrd:
        with into_file(given.rrd, viewer.settings) as sink:
            viewer.run(sink, life)
        return 0
    with to_browsers(viewer.settings, given.host, given.port, given.data_port) as (sink, address):
        rospy.loginfo(f"the safety node in a browser: {address}")
        viewer.run(sink, life)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
