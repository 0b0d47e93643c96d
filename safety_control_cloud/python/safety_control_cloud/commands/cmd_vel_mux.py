# SPDX-License-Identifier: BSD-3-Clause
"""scripts/cmd_vel_mux: the TurtleBot's velocity multiplexer, with yocs_cmd_vel_mux's rules and file format."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path

from ..simulation.mux import TURTLEBOT_INPUTS, Table, table_from
from .remappings import without_remappings

TURTLEBOT = Table(TURTLEBOT_INPUTS, "/mobile_base/commands/velocity")


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="cmd_vel_mux", description=__doc__.split(": ", 1)[1])
    parser.add_argument("--table", type=Path, help="YAML with inputs, priorities and timeouts (the TurtleBot's)")
    arguments = parser.parse_args(without_remappings(argv[1:]))
    try:
        table = _table_in(arguments.table) if arguments.table else TURTLEBOT
    except ValueError as error:
        print(f"cmd_vel_mux: {error}", file=sys.stderr)
        return 2
    from ..nodes.cmd_vel_mux import run  # after the arguments: --help needs Python alone

    run(table)
    return 0


def _table_in(file: Path) -> Table:
    """Raises ValueError with a line."""
    import yaml

    try:
        document = yaml.safe_load(file.read_text())
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise ValueError(f"cannot read {file}: {' '.join(str(error).split())}") from error
    try:
        return table_from(document)
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from error


if __name__ == "__main__":
    sys.exit(main(sys.argv))
