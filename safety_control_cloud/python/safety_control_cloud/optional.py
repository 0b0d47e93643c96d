# SPDX-License-Identifier: BSD-3-Clause
"""PyPI packages that only some commands need: named, with what installs them, where they are missing."""
from __future__ import annotations

import sys
from importlib.util import find_spec
from typing import Dict, Sequence, Tuple

GROUPS: Dict[str, Sequence[str]] = {  # modules of each `scripts/setup --with GROUP`
    "judge": ("rosbags", "rich", "pyarrow", "xxhash"),
    "s3": ("fsspec", "upath", "s3fs"),
    "cluster": ("distributed",),
    "view": ("rerun",),
}
WITH_ANY_SETUP: Dict[str, Sequence[str]] = {  # modules that scripts/setup always brings to a clone, by command
    "replay": ("rosbags", "rich"),
    "demo": ("rich",),
    "trials": ("rich", "mujoco"),
}
OLDEST_PYTHON: Dict[str, Tuple[int, int]] = {"s3": (3, 10), "cluster": (3, 10), "view": (3, 11)}  # that PyPI has them for


class MissingPackages(RuntimeError):
    """str() names them and the command that installs them."""


def require(group: str) -> None:
    """Raises MissingPackages."""
    missing = [name for name in {**GROUPS, **WITH_ANY_SETUP}[group] if find_spec(name) is None]
    oldest = OLDEST_PYTHON.get(group, sys.version_info[:2])
    if missing and sys.version_info[:2] < oldest:
        raise MissingPackages(f"this needs {', '.join(missing)}, and these Python {oldest[0]}.{oldest[1]} or newer: this is {sys.version.split()[0]}")
    if missing and group in WITH_ANY_SETUP:
        raise MissingPackages(f"this needs {', '.join(missing)}: scripts/setup, or pip where the package is installed")
    if missing:
        raise MissingPackages(f"this needs {', '.join(missing)}: scripts/setup --with {group}")
