# SPDX-License-Identifier: BSD-3-Clause
"""MJCF into an MjSpec, also by MuJoCo 3.2.3: the last for Python 3.8 and 3.9."""
from __future__ import annotations

from pathlib import Path
from shutil import copy
from tempfile import TemporaryDirectory

from .gl import mujoco
from .world_files import WORLDS

NATIVE_CCD = int(getattr(mujoco.mjtEnableBit, "mjENBL_NATIVECCD", 0))  # 3.2.3 finds wrong distances without; later ones always have it
_FILLS_AN_EMPTY_SPEC = tuple(map(int, mujoco.__version__.split(".")[:3])) < (3, 2, 5)


def spec_of_file(path: Path) -> mujoco.MjSpec:
    """Raises ValueError for what is no MJCF."""
    if not _FILLS_AN_EMPTY_SPEC:
        return mujoco.MjSpec.from_file(str(path))
    spec = mujoco.MjSpec()
    spec.from_file(str(path))
    return spec


def spec_of_text(text: str) -> mujoco.MjSpec:
    """The text may include the worlds' own files, such as `_scenery.xml`."""
    if not _FILLS_AN_EMPTY_SPEC:
        return mujoco.MjSpec.from_string(text, include={path.name: path.read_bytes() for path in WORLDS.glob("*.xml")})
    with TemporaryDirectory() as folder:  # an include is looked for beside its file alone
        for path in WORLDS.glob("*.xml"):
            copy(path, folder)
        world = Path(folder) / "text.xml"
        world.write_text(text)
        return spec_of_file(world)
