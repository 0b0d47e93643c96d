# SPDX-License-Identifier: BSD-3-Clause
"""The packages of safety_limiter in a folder of the user's, which is only read; needs Python alone."""
import argparse
import os
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List, Mapping, Sequence, Set

PACKAGE = "safety_limiter"
HOMES = {  # where a dependency comes from that no Debian has
    "neonavigation_common": "at-wat/neonavigation",
    "safety_limiter_msgs": "at-wat/neonavigation_msgs",
}
DEPTH = 4  # folders below the given one
DEPENDENCIES = ("depend", "build_depend", "build_export_depend", "run_depend")


@dataclass(frozen=True)
class Checkout:
    packages: Mapping[str, Path]  # safety_limiter, and what it depends on as far as it is there
    missing: Mapping[str, str]  # those of HOMES that are not: good only where they are installed


def checkout_of(text: str) -> Checkout:
    """Raises argparse.ArgumentTypeError."""
    folder = Path(text).expanduser()
    if not folder.is_dir():
        raise argparse.ArgumentTypeError(f"{text} is not a folder")
    there = {**cloned_beside(folder), **packages_in(folder)}
    if PACKAGE not in there:
        raise argparse.ArgumentTypeError(f"no package {PACKAGE} in {text}; it is in a checkout of at-wat/neonavigation (ROS 1)")
    if "catkin" not in named(("buildtool_depend",), there[PACKAGE] / "package.xml"):
        raise argparse.ArgumentTypeError(f"{there[PACKAGE]} is not of ROS 1: its package.xml asks for no catkin; check out another branch or tag")
    names = closure(PACKAGE, there)
    return Checkout({name: there[name].resolve() for name in sorted(names & set(there))},
                    {name: home for name, home in HOMES.items() if name in names and name not in there})


def packages_in(folder: Path) -> Dict[str, Path]:
    return {name_of(file): file.parent for file in manifests(folder)}


def cloned_beside(folder: Path) -> Dict[str, Path]:
    """The packages of HOMES, for who gives one of two clones that lie side by side."""
    homes = (folder.resolve().parent / home.split("/")[1] for home in HOMES.values())
    beside = {name: package for home in homes if home.is_dir() for name, package in packages_in(home).items()}
    return {name: package for name, package in beside.items() if name in HOMES}


def manifests(folder: Path) -> Iterator[Path]:
    """The package.xml files, the deepest first, so that the least deep of two of one name is the one that counts."""
    found: List[Path] = []
    for place, folders, files in os.walk(folder, followlinks=True):
        is_package = "package.xml" in files
        if is_package and "CATKIN_IGNORE" not in files:
            found.append(Path(place) / "package.xml")
        depth = len(Path(place).relative_to(folder).parts)
        ends = depth == DEPTH or is_package or "CATKIN_IGNORE" in files
        folders[:] = [] if ends else [name for name in folders if not name.startswith(".")]
    return iter(sorted(found, key=lambda file: (-len(file.parts), str(file))))


def name_of(manifest: Path) -> str:
    """Empty, if it is none."""
    try:
        return (xml.parse(manifest).getroot().findtext("name") or "").strip()
    except (OSError, xml.ParseError):
        return ""


def closure(name: str, there: Mapping[str, Path]) -> Set[str]:
    """A package and all that it depends on, over those that are there."""
    seen: Set[str] = set()
    waiting = [name]
    while waiting:
        name = waiting.pop()
        if name not in seen:
            seen.add(name)
            waiting += named(DEPENDENCIES, there[name] / "package.xml") if name in there else []
    return seen


def named(tags: Sequence[str], manifest: Path) -> List[str]:
    root = xml.parse(manifest).getroot()
    return [(element.text or "").strip() for tag in tags for element in root.findall(tag)]
