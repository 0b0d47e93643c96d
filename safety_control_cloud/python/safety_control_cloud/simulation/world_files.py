# SPDX-License-Identifier: BSD-3-Clause
"""Where the worlds lie: MJCF files, which MuJoCo loads as they are and Gazebo as `sdf.py` puts them."""
from __future__ import annotations

import argparse
from pathlib import Path

WORLDS = Path(__file__).parent / "worlds"
START = "start"  # the site at which a world wants the robot; the origin if there is none


def world_names() -> tuple[str, ...]:
    """The worlds that come with the package; a name that begins with _ is a part of others."""
    return tuple(sorted(path.stem for path in WORLDS.glob("*.xml") if not path.stem.startswith("_")))


def world_file(name: str | Path) -> Path:
    """The MJCF file of one of `world_names()`, or the user's own. Raises FileNotFoundError with what there is."""
    path = WORLDS / f"{name}.xml" if str(name) in world_names() else Path(name).expanduser()
    if not path.is_file():
        raise FileNotFoundError(f"no world {str(name)!r}: an MJCF file, or one of {', '.join(world_names())}")
    return path


def world_argument(name: str) -> str:
    """For argparse: a user's file by its full path, for roslaunch runs its nodes elsewhere."""
    try:
        return name if name in world_names() else str(world_file(name).resolve())
    except FileNotFoundError as error:
        raise argparse.ArgumentTypeError(str(error)) from error
