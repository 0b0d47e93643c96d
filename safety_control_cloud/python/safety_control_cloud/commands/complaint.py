# SPDX-License-Identifier: BSD-3-Clause
"""How a command says in a line why it does not go on."""
from __future__ import annotations

import sys

UNUSABLE = 2  # exit code; argparse too says 2


def complain(command: str, why: object, code: int = UNUSABLE) -> int:
    """On stderr; returns the exit code."""
    print(f"{command}: {why}", file=sys.stderr)
    return code
