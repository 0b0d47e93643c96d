# SPDX-License-Identifier: BSD-3-Clause
"""scripts/judge: options.py has the arguments, command.py what is done with them."""
from __future__ import annotations

import sys

from safety_control_cloud.judge.options import options
from safety_control_cloud.optional import MissingPackages, require

UNUSABLE, INTERRUPTED = 2, 130  # exit codes; argparse too says 2


def main() -> int:
    given = options()
    try:
        require("judge")
        if given.scheduler:
            require("cluster")
        if any("://" in bag for bag in given.bags):
            require("s3")
        from safety_control_cloud.judge.command import Unusable, run  # after the arguments: --help needs Python alone

        try:
            return run(given)
        except Unusable as error:
            return _complain(error)
    except MissingPackages as error:
        return _complain(error)
    except KeyboardInterrupt:
        return INTERRUPTED


def _complain(error: Exception) -> int:
    print("\n".join(f"judge: {line}" for line in str(error).splitlines()), file=sys.stderr)
    return UNUSABLE


if __name__ == "__main__":
    sys.exit(main())
