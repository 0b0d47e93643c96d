# SPDX-License-Identifier: BSD-3-Clause
"""scripts/trials: options.py has the arguments, command.py what is done with them."""
from __future__ import annotations

import sys

from ..commands.complaint import complain
from ..dispatch import ClusterError, Lost
from ..optional import MissingPackages, require
from .options import options

LOST, INTERRUPTED = 3, 130  # exit codes


def main() -> int:
    given = options()
    try:
        require("trials")
        if given.scheduler:
            require("cluster")
        from .command import run  # after the arguments: --help needs Python alone

        return run(given)
    except Lost as error:
        return complain("trials", error, LOST)
    except (ClusterError, MissingPackages) as error:
        return complain("trials", error)
    except KeyboardInterrupt:
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
