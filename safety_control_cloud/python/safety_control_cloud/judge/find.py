# SPDX-License-Identifier: BSD-3-Clause
"""From what a user names - files, folders, globs, s3:// - to bags."""
from __future__ import annotations

import fnmatch
import re
from pathlib import Path
from typing import Iterator, List, Sequence

from safety_control_cloud.replay.bags import ENDINGS, METADATA

REMOTE = re.compile(r"^[a-z][a-z0-9+.-]+://")
WILD = re.compile(r"[*?\[]")


class NoBags(ValueError):
    """str() has a line for each name."""


def path_of(name: str) -> Path:
    """A local path, or an object that a store holds (needs universal_pathlib, and s3fs for s3://)."""
    if not REMOTE.match(name):
        return Path(name)
    from upath import UPath

    return UPath(name)


def bags_in(names: Sequence[str]) -> List[str]:
    """In the order of the names, each once. A name without bags stands for itself: judged, it says what is wrong."""
    found = [bag for name in names for bag in (_there(name) or [name])]
    return list(dict.fromkeys(found))


def refuse_nothing(names: Sequence[str]) -> None:
    """Raises NoBags if not one of the names stands for a bag. What a store has is only known to who reads it."""
    reasons = []
    for name in names:
        reasons.append(_without_bags(name))
        if not reasons[-1]:
            return
    raise NoBags("\n".join(reasons))


def _without_bags(name: str) -> str:
    """A line that says why there is none; empty: there may be."""
    try:
        if REMOTE.match(name) or _of(name):
            return ""
    except OSError as error:
        return f"cannot read {name}: {error.strerror}"
    if WILD.search(name):
        return f"{name}: nothing has such a name, or no bag in it"
    return f"{name}: no bag in it" if Path(name).is_dir() else f"{name}: no such file"


def _there(name: str) -> List[str]:
    try:
        return _of(name)
    except Exception:  # of a disk or a store: clients of stores raise what they like
        return []


def _of(name: str) -> List[str]:
    if WILD.search(name):
        return [bag for path in _matching(name) for bag in _below(path)]
    return list(_below(path_of(name)))


def _matching(pattern: str) -> Iterator[Path]:
    parts = pattern.split("/")
    fixed = next(number for number, part in enumerate(parts) if WILD.search(part))
    base = path_of("/".join(parts[:fixed]) or ("/" if pattern.startswith("/") else "."))
    yield from sorted(base.glob("/".join(parts[fixed:])), key=str)


def _below(path: Path) -> Iterator[str]:
    """The bags in a folder at any depth; a folder with metadata.yaml is one bag."""
    if not path.is_dir():
        if path.exists():
            yield _name(path)
        return
    if (path / METADATA).exists():
        yield _name(path)
        return
    for below in sorted(path.iterdir(), key=str):
        if below.is_dir():
            yield from _below(below)
        elif any(fnmatch.fnmatch(below.name, "*" + ending) for ending in ENDINGS):
            yield _name(below)


def _name(path: Path) -> str:
    """As path_of() takes it, from whatever folder a worker runs in."""
    return str(path.absolute()) if isinstance(path, type(Path())) else str(path)
