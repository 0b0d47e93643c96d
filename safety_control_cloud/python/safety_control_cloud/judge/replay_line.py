# SPDX-License-Identifier: BSD-3-Clause
"""The command that shows a bag by the settings that it was judged by."""
from __future__ import annotations

import argparse
import shlex
from typing import Optional


def replay_line(path: str, given: argparse.Namespace, place: Optional[int], *more: str) -> str:
    """`place`: of several settings; `more`: what else scripts/replay is to be told."""
    settings = given.compare[place or 0] if given.compare else given.settings
    words = ["scripts/replay", path, *more, *(["--settings", str(settings)] if settings else [])]
    for name, value in given.param:
        words += ["--param", f"{name}={value}"]
    return " ".join(map(shlex.quote, words))
