# SPDX-License-Identifier: BSD-3-Clause
"""TUTORIAL.md as steps: its commands, what is to be seen of each, and the picture that shows it.

What a command is, its block says: `sh` ends by itself, `sh stays` runs on to the end, `sh window` needs a screen, and
`sh once` has been done before.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import List, Optional, Tuple

PAGE = Path(__file__).resolve().parents[2] / "safety_control_cloud" / "TUTORIAL.md"
KINDS = ("", "stays", "window", "once")
PART = re.compile(r"^```(sh|text) ?(\w*)\n(.*?)^```$|^!\[[^\]]*\]\(([^)]+)\)$", re.MULTILINE | re.DOTALL)


@dataclass
class Step:
    command: str
    kind: str
    shown: Tuple[str, ...] = ()  # parts of lines, one after the other; numbers stand for any
    picture: Optional[str] = None  # as the page links it


def steps_of(text: str) -> List[Step]:
    """Raises ValueError for a block that says of itself what nobody knows."""
    steps: List[Step] = []
    for language, kind, content, picture in PART.findall(text):
        if picture:
            steps[-1].picture = picture
        elif language == "text":
            steps[-1].shown = tuple(content.strip().splitlines())
        elif kind in KINDS:
            steps.append(Step(content.strip(), kind))
        else:
            raise ValueError(f"nobody knows what a block {kind} is")
    return steps


def missing_in(output: str, shown: Tuple[str, ...]) -> Optional[str]:
    """The first that is not there, below the one before it; None if all are."""
    rest = output
    for part in shown:
        pattern = re.sub(r"\d+(?:\\\.\d+)?", r"[\\d.]+", re.escape(part))
        found = re.search(pattern, rest)
        if not found:
            return part
        rest = rest[found.end():]
    return None
