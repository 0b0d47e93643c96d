# SPDX-License-Identifier: BSD-3-Clause
"""scripts/trials: options.py has the arguments, command.py what is done with them."""
from __future__ import annotations

import sys

from ..dispatch import ClusterError, Lost
from ..optional import MissingPackages, require
from .options import options

LOST, UNUSABLE, INTERRUPTED = 3, 2, 130  # exit codes; argparse too says 2


def main() -> int:
    given = options()
    try:
        require("trials")
        if given.scheduler:
            require("cluster")
        from .command import run  # after the arguments: --help needs Python alone

        return run(given)
    except Lost as error:
        return _complain(error, LOST)
    except (ClusterError, MissingPackages) as error:
        return _complain(error, UNUSABLE)
    except KeyboardInterrupt:
        return INTERRUPTED


def _complain(error: Exception, code: int) -> int:
    print(f"trials: {error}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
