# SPDX-License-Identifier: BSD-3-Clause
"""scripts/cmd_vel_mux: the TurtleBot's velocity multiplexer, with yocs_cmd_vel_mux's rules and file format."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path

from ..simulation.mux import TURTLEBOT_INPUTS, Table, table_from
from .remappings import without_remappings

TURTLEBOT = Table(TURTLEBOT_INPUTS, "/mobile_base/commands/velocity")


def main(argv: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="cmd_vel_mux", description=__doc__.split(": ", 1)[1])
    parser.add_argument("--table", type=Path, help="YAML with inputs, priorities and timeouts (the TurtleBot's)")
    arguments = parser.parse_args(without_remappings(argv[1:]))
    import yaml  # after the arguments: --help needs Python alone

    from ..nodes.cmd_vel_mux import run

    run(table_from(yaml.safe_load(arguments.table.read_text())) if arguments.table else TURTLEBOT)


if __name__ == "__main__":
    main(sys.argv)
