# SPDX-License-Identifier: BSD-3-Clause
"""What a bag, a setting and a judge are known by: three hashes."""
from __future__ import annotations

import hashlib
import json
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator, List, Mapping, Tuple

import xxhash

import safety_control_cloud
from safety_control_cloud import core
from safety_control_cloud.judge.choice import Choice
from safety_control_cloud.replay.guard.inputs import WANTED_IF_GIVEN

BLOCK = 1 << 18  # [byte] of a file at once: they are hashed while they lie in the cache
LENGTH = 16  # hexadecimal digits that are shown of a hash
JUDGES = (  # the modules that a verdict or an answer depends on, besides the core
    "headings.py", "judge/bag.py", "judge/drive.py", "judge/guard/reading.py", "judge/guard/rows.py", "judge/reading.py",
    "judge/rows.py", "judge/table.py", "pinhole.py", "replay/bags.py", "replay/compressed.py", "replay/eyes.py", "replay/guard/counts.py",
    "replay/guard/drive.py", "replay/guard/inputs.py", "replay/guard/poses.py", "replay/guard/reading.py",
    "replay/guard/scans.py", "replay/guard/seen.py", "replay/guard/switches.py", "replay/parameters.py", "replay/places.py",
    "replay/topics.py", "replay/wire.py")

Stat = Tuple[Tuple[str, int, str], ...]  # of each file: name, size, and the time of its last change or its ETag


def stat_of(bag: Path) -> Stat:
    """As long as it stays the same, so does the content. Raises OSError."""
    return tuple(_stat(file) for file in files_of(bag))


def files_of(bag: Path) -> Iterator[Path]:
    if not bag.is_dir():
        yield bag
        return
    yield from sorted((file for file in bag.iterdir() if file.is_file()), key=str)


def hash_of_bag(bag: Path) -> str:
    """Of all its bytes; on a store that has a checksum of its own, of that. Raises OSError."""
    whole = hashlib.sha256()
    for file in files_of(bag):
        whole.update(f"{file.name if bag.is_dir() else ''} {_content_of(file)}\n".encode())
    return whole.hexdigest()[:LENGTH]


def hash_of_settings(given: Mapping[str, Any], choice: Choice = Choice()) -> str:
    """By what differs from the defaults; and of the topics, where they were chosen."""
    settings = core.Settings(**given).as_dict()
    content: List[Any] = [settings, sorted(choice.topics)]
    if settings["mode"] == "guard":
        content = [settings, choice.topics, choice.cmd_vel, choice.odom, sorted({*WANTED_IF_GIVEN} & {*given})]
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:LENGTH]


@lru_cache(maxsize=None)
def version() -> str:
    """Of the compiled core and of the modules that read and judge: other ones may judge differently."""
    whole = hashlib.sha256(Path(core.__file__).read_bytes())
    folders = [Path(place) for place in safety_control_cloud.__path__]
    for module in JUDGES:
        whole.update(next(folder / module for folder in folders if (folder / module).exists()).read_bytes())
    return whole.hexdigest()[:LENGTH]


def _stat(file: Path) -> Tuple[str, int, str]:
    found = file.stat()
    tag = _etag(file)
    return (file.name, int(found.st_size), tag or str(getattr(found, "st_mtime_ns", found.st_mtime)))


def _etag(file: Path) -> str:
    """What an object store says of the content; "" where there is none."""
    filesystem = getattr(file, "fs", None)
    if filesystem is None or isinstance(file, _local()):
        return ""
    return str(filesystem.info(file.path).get("ETag", "")).strip('"')


def _local() -> type:
    return type(Path())


def _content_of(file: Path) -> str:
    tag = _etag(file)
    if tag:
        return tag
    whole, block = xxhash.xxh3_128(), bytearray(BLOCK)
    with file.open("rb") as stream:
        while count := stream.readinto(block):
            whole.update(memoryview(block)[:count])
    return whole.hexdigest()
