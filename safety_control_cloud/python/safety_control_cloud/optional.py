# SPDX-License-Identifier: BSD-3-Clause
"""PyPI packages that only some commands need: named, with the command that installs them, where they are missing."""
from __future__ import annotations

from importlib.util import find_spec
from typing import Dict, Sequence

GROUPS: Dict[str, Sequence[str]] = {  # modules of each `scripts/setup --with GROUP`
    "judge": ("rosbags", "rich", "pyarrow", "xxhash"),
    "s3": ("fsspec", "upath", "s3fs"),
    "cluster": ("distributed",),
    "view": ("rerun",),
}


class MissingPackages(RuntimeError):
    """str() names them and the command that installs them."""


def require(group: str) -> None:
    """Raises MissingPackages."""
    missing = [name for name in GROUPS[group] if find_spec(name) is None]
    if missing:
        raise MissingPackages(f"this needs {', '.join(missing)}: scripts/setup --with {group}")
