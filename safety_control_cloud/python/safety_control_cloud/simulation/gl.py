# SPDX-License-Identifier: BSD-3-Clause
"""MuJoCo, told which OpenGL to use: the choice is read when mujoco is imported, so all modules import it from here."""
import os

os.environ.setdefault("MUJOCO_GL", "osmesa")  # draws without a display or a graphics card

try:
    import mujoco
except ModuleNotFoundError as missing:
    where = "scripts/setup installs MuJoCo into a clone's .venv/; of an installed package, pip does"
    raise ModuleNotFoundError(f"{missing}: {where}", name=missing.name) from missing

__all__ = ["mujoco"]
