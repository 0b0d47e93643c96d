# SPDX-License-Identifier: BSD-3-Clause
"""scripts/trials: options.py has the arguments, command.py what is done with them."""
from __future__ import annotations

import sys

from .options import options

INTERRUPTED = 130  # exit code; argparse says 2


def main() -> int:
    given = options()
    from .command import run  # after the arguments: --help needs Python alone

    try:
        return run(given)
    except KeyboardInterrupt:
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
