# SPDX-License-Identifier: BSD-3-Clause
"""The Xtion's pictures of a World, rendered by MuJoCo."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .gl import mujoco
from .robot import CAMERA, GROUP
from .sensor import noisy, returned
from .world import World

_EYE_CLIP = (0.05, 60.0)  # [m] the colour camera sees farther than the depth is measured


class Camera:
    """Make, use and `close` it in one thread: OpenGL's context belongs to it."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._renderer = mujoco.Renderer(world.model, world.xtion.height, world.xtion.width)
        self._plain()

    def depth(self, random: np.random.Generator | None = None) -> NDArray[np.float32]:
        """(height, width) [m] along z of the optical frame, NaN where the Xtion returns nothing.

        `random` is the source of its noise; None gives the true depth.
        """
        self._renderer.enable_depth_rendering()
        try:
            depth = self._picture(self._world.xtion.clip)
        finally:
            self._renderer.disable_depth_rendering()
        return returned(depth if random is None else noisy(depth, random), self._world.xtion)

    def colour(self) -> NDArray[np.uint8]:
        """(height, width, 3) red, green, blue, from the depth's own viewpoint: the driver registers the two."""
        return self._picture(_EYE_CLIP)

    def close(self) -> None:
        self._renderer.close()

    def _picture(self, clip: tuple[float, float]) -> NDArray:
        drawn = self._world.model.vis.map
        drawn.znear, drawn.zfar = clip
        self._renderer.update_scene(self._world.data, CAMERA, self._options)
        return self._renderer.render()

    def _plain(self) -> None:
        """Nothing drawn but solid things: marks are no part of what the Xtion sees, shadows cost time."""
        self._options = mujoco.MjvOption()
        self._options.sitegroup[:] = 0
        self._options.geomgroup[GROUP] = 0
        for flag in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
            self._renderer.scene.flags[flag] = 0
