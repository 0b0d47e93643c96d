# SPDX-License-Identifier: BSD-3-Clause
"""The Xtion's pictures of a World, rendered by MuJoCo."""
from __future__ import annotations

from typing import TYPE_CHECKING
import weakref
from dataclasses import dataclass

import numpy as np

from .gl import mujoco
from .robot import CAMERA, GROUP
from .sensor import Xtion, noisy, returned, with_strays
from .world import World

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04


@dataclass(frozen=True)
class Picture:
    """Depth and colour of one moment from one viewpoint: the driver registers the two."""

    depth: NDArray[np.float32]  # (height, width) [m] along z of the optical frame, NaN where nothing returned
    colour: NDArray[np.uint8]  # (height, width, 3) red, green, blue


class Camera:
    """Make, use and `close` it in one thread: OpenGL's context belongs to it.

    mujoco.Renderer can do the same, but draws the scene twice for depth and colour; that takes as long again.
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._frame = mujoco.MjrRect(0, 0, world.xtion.width, world.xtion.height)
        self._shaded, self._flat = _scene(world.model), _scene(world.model)
        for flag in (mujoco.mjtRndFlag.mjRND_SEGMENT, mujoco.mjtRndFlag.mjRND_IDCOLOR):
            self._flat.flags[flag] = 1  # no light, texture and sky; the depth is the same, bit by bit
        self._shown = _only_solid_things()
        self._eye = mujoco.MjvCamera()
        self._eye.type, self._eye.fixedcamid = mujoco.mjtCamera.mjCAMERA_FIXED, world.model.camera(CAMERA).id
        self._open()

    def depth(self, random: np.random.Generator | None = None) -> NDArray[np.float32]:
        """As in a Picture. `random` is the source of the Xtion's noise; None gives the true depth."""
        self._draw(self._flat)
        window = self._window()
        mujoco.mjr_readPixels(None, window, self._frame, self._buffers)
        return self._measured(window, random)

    def colour(self) -> NDArray[np.uint8]:
        """As in a Picture."""
        self._draw(self._shaded)
        colour = self._blank()
        mujoco.mjr_readPixels(colour, None, self._frame, self._buffers)
        return np.ascontiguousarray(colour[::-1])

    def picture(self, random: np.random.Generator | None = None) -> Picture:
        """What `depth` and `colour` would give, drawn once."""
        self._draw(self._shaded)
        colour, window = self._blank(), self._window()
        mujoco.mjr_readPixels(colour, window, self._frame, self._buffers)
        return Picture(self._measured(window, random), np.ascontiguousarray(colour[::-1]))

    def close(self) -> None:
        self._end()

    def _open(self) -> None:
        xtion = self._world.xtion
        self._context = mujoco.GLContext(xtion.width, xtion.height)
        self._context.make_current()
        self._buffers = mujoco.MjrContext(self._world.model, mujoco.mjtFontScale.mjFONTSCALE_100)
        self._end = weakref.finalize(self, _free, self._context, self._buffers)
        self._buffers.readDepthMap = mujoco.mjtDepthMap.mjDEPTH_ZEROFAR
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, self._buffers)

    def _draw(self, scene: mujoco.MjvScene) -> None:
        everything = mujoco.mjtCatBit.mjCAT_ALL
        mujoco.mjv_updateScene(
            self._world.model, self._world.data, self._shown, None, self._eye, everything, scene)
        self._context.make_current()
        mujoco.mjr_render(self._frame, scene, self._buffers)

    def _blank(self) -> NDArray[np.uint8]:
        return np.empty((self._frame.height, self._frame.width, 3), np.uint8)

    def _window(self) -> NDArray[np.float32]:
        return np.empty((self._frame.height, self._frame.width), np.float32)

    def _measured(self, window: NDArray[np.float32], random: np.random.Generator | None) -> NDArray[np.float32]:
        xtion = self._world.xtion
        depth = _metres(window, xtion)
        if random is None:
            return returned(depth, xtion)
        measured = returned(noisy(depth, random), xtion)
        return with_strays(measured, depth, xtion, random) if xtion.stray else measured


def _scene(model: mujoco.MjModel) -> mujoco.MjvScene:
    scene = mujoco.MjvScene(model, maxgeom=2 * model.ngeom + 100)
    for flag in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
        scene.flags[flag] = 0  # they cost time
    return scene


def _only_solid_things() -> mujoco.MjvOption:
    """Marks and the robot itself are no part of what the Xtion sees."""
    shown = mujoco.MjvOption()
    shown.sitegroup[:] = 0
    shown.geomgroup[GROUP] = 0
    return shown


def _metres(window: NDArray[np.float32], xtion: Xtion) -> NDArray[np.float32]:
    """The depth [m] from OpenGL's buffer, whose lowest row comes first: 1 at the near end of the clip, 0 at the far."""
    near, far = xtion.clip
    depth = window[::-1] + np.float32(near / (far - near))
    return np.divide(np.float32(near * far / (far - near)), depth, out=depth)


def _free(context: mujoco.GLContext, buffers: mujoco.MjrContext) -> None:
    context.make_current()
    buffers.free()
    context.free()
