# SPDX-License-Identifier: BSD-3-Clause
"""The ASUS Xtion PRO Live in numbers: depth images, their noise, and the clouds its driver makes of them."""
from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import atan, radians, tan
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

DISPARITY_FOCAL = 575.8  # [px] of the sensor's own infrared camera
DISPARITY_BASELINE = 0.075  # [m] projector to infrared camera
DISPARITY_STEPS = 8  # a pixel's disparity comes in eighths
DISPARITY_NOISE = 0.5  # [steps] standard deviation

POINT = np.dtype(
    {"names": ["x", "y", "z", "rgb"], "formats": ["<f4"] * 4, "offsets": [0, 4, 8, 16], "itemsize": 32}
)  # as openni2_camera and Gazebo lay a point out


@dataclass(frozen=True)
class Xtion:
    width: int = 640  # [px]
    height: int = 480  # [px]
    rate: float = 20.0  # [Hz]
    horizontal_view: float = radians(60)
    nearest: float = 0.4  # [m] along z: nothing is returned at or below
    farthest: float = 5.0  # [m] along z: nothing is returned at or beyond
    stray: float = 0.0  # share of what is too near that returns any depth, as a stereo camera's does
    clip: tuple[float, float] = (0.05, 60.0)  # [m] along z: what is drawn; colour reaches farther than depth
    mount: tuple[float, float, float] = (-0.087, 0.0475, 0.2972)  # [m] the depth frame in base_footprint

    @property
    def focal(self) -> float:
        """[px] 554.26 at 640 columns; pixels are square."""
        return self.width / 2 / tan(self.horizontal_view / 2)

    @property
    def centre(self) -> tuple[float, float]:
        """[px] column and row of the optical axis: between the two middle pixels."""
        return (self.width - 1) / 2, (self.height - 1) / 2

    @property
    def vertical_view(self) -> float:
        return 2 * atan(self.height / 2 / self.focal)


@lru_cache(maxsize=8)
def rays(xtion: Xtion) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """x / z for each column and y / z for each row, in the optical frame (x right, y down, z ahead)."""
    column, row = xtion.centre
    across = (np.arange(xtion.width) - column) / xtion.focal
    down = (np.arange(xtion.height) - row) / xtion.focal
    return across.astype(np.float32), down.astype(np.float32)


def noisy(depth: NDArray[np.float32], random: np.random.Generator) -> NDArray[np.float32]:
    """The depth [m] as the sensor measures it: disparity, off by a normal error, rounded to eighths of a pixel.

    Standard deviation 1.7 mm at 1 m, 6.7 at 2, 14.9 at 3: it grows with the square of the distance, as in
    Khoshelham and Oude Elberink, Sensors 2012, 12(2):1437.
    """
    scale = np.float32(DISPARITY_STEPS * DISPARITY_FOCAL * DISPARITY_BASELINE)
    disparity = random.standard_normal(depth.shape, dtype=np.float32)
    disparity *= np.float32(DISPARITY_NOISE)
    disparity += scale / depth
    np.rint(disparity, out=disparity)
    np.maximum(disparity, np.float32(1), out=disparity)
    return np.divide(scale, disparity, out=disparity)


def returned(depth: NDArray[np.float32], xtion: Xtion) -> NDArray[np.float32]:
    """The depth [m] where the sensor returns one, NaN elsewhere."""
    seen = (depth > xtion.nearest) & (depth < xtion.farthest)
    return np.where(seen, depth, np.float32(np.nan))


def with_strays(
    measured: NDArray[np.float32], depth: NDArray[np.float32], xtion: Xtion, random: np.random.Generator
) -> NDArray[np.float32]:
    """What was `measured` [m] of a true `depth` [m], with returns somewhere in the range, evenly, from what is too near."""
    (near,) = np.nonzero(depth.ravel() <= xtion.nearest)
    stray = near[random.random(near.shape, dtype=np.float32) < xtion.stray]
    marred = measured.copy()
    marred.ravel()[stray] = random.uniform(xtion.nearest, xtion.farthest, stray.shape).astype(np.float32)
    return marred


def points(depth: NDArray[np.float32], xtion: Xtion) -> NDArray[np.float32]:
    """(height, width, 3) [m] in the optical frame; a pixel without a return is NaN in all three."""
    across, down = rays(xtion)
    return np.stack((depth * across, depth * down[:, None], depth), axis=-1)


def new_cloud(xtion: Xtion) -> NDArray[np.void]:
    """An organised cloud for `fill_cloud` to fill again and again: 10 MB at VGA are costly to find each time."""
    return np.zeros((xtion.height, xtion.width), dtype=POINT)


def fill_cloud(cloud: NDArray[np.void], depth: NDArray[np.float32], xtion: Xtion) -> None:
    """Write the points of a depth image [m] into an organised cloud of the same size."""
    across, down = rays(xtion)
    np.multiply(depth, across, out=cloud["x"])
    np.multiply(depth, down[:, None], out=cloud["y"])
    cloud["z"] = depth


def fill_colour(cloud: NDArray[np.void], colour: NDArray[np.uint8]) -> None:
    """Write an image (height, width, 3) of red, green, blue into a cloud, as PCL packs it: 0x00RRGGBB in a float32."""
    packed = np.zeros((*cloud.shape, 4), np.uint8)
    for place, channel in enumerate((2, 1, 0)):  # the lowest byte, blue, comes first
        packed[..., place] = colour[..., channel]
    cloud["rgb"] = packed.view("<f4")[..., 0]


def millimetres(depth: NDArray[np.float32]) -> NDArray[np.uint16]:
    """A depth image as the driver's 16UC1: whole millimetres, 0 for no return."""
    return np.rint(np.nan_to_num(depth) * np.float32(1000)).astype(np.uint16)
