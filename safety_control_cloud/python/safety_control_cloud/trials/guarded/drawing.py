# SPDX-License-Identifier: BSD-3-Clause
"""Where a guarded robot went, seen from above, and what was taken from its driver."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import cos, hypot, sin
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

from ...simulation.base import Pose, Velocity
from ...simulation.hull import BODY_RADIUS, Rectangle
from ..drawing import box_about

INK, GREY, BLUE, RED, WOOD = "#22303c", "#8795a1", "#1f5fa8", "#c0322b", "#9c6b3e"
_STANDS_APART = 0.25  # [m] between two stops that are drawn


@dataclass(frozen=True)
class Spot:
    """At one moment."""

    time: float  # [s]
    pose: Pose
    wanted: Velocity
    given: Velocity
    factor: float

    @property
    def is_stopped(self) -> bool:
        return self.factor < 0.02 and (abs(self.wanted.linear) > 0.02 or abs(self.wanted.angular) > 0.05)


@dataclass(frozen=True)
class Block:
    """Upright, seen from above: a box, or a cylinder if `round`."""

    x: float
    y: float
    yaw: float
    length: float
    width: float
    round: bool = False


def draw(path: Path, title: str, spots: Sequence[Spot], blocks: Iterable[Block], hull: Rectangle | None,
         touched: Sequence[tuple[float, float]] = ()) -> None:
    """A file in the format of the path's ending."""
    figure = Figure(figsize=(12, 6.6), facecolor="white", constrained_layout=True)
    FigureCanvasAgg(figure)
    figure.suptitle(title, color=INK, weight="bold", fontsize=14)
    grid = figure.add_gridspec(3, 2, width_ratios=(1.15, 1))
    _draw_plan(figure.add_subplot(grid[:, 0]), spots, blocks, hull, touched)
    linear, angular, factor = (figure.add_subplot(grid[row, 1]) for row in range(3))
    times = [spot.time for spot in spots]
    for axes, what, unit in ((linear, "linear", "forward [m/s]"), (angular, "angular", "turning [rad/s]")):
        wanted, given = ([getattr(getattr(spot, whose), what) for spot in spots] for whose in ("wanted", "given"))
        axes.fill_between(times, wanted, given, step="post", color=RED, alpha=0.25, lw=0, label="taken")
        axes.step(times, wanted, where="post", color=GREY, lw=1, label="wanted")
        axes.step(times, given, where="post", color=BLUE, lw=1.3, label="given")
        axes.set_ylabel(unit)
    linear.legend(loc="lower right", ncol=3, fontsize=8, frameon=False)
    factor.fill_between(times, [spot.factor for spot in spots], step="post", color=BLUE, alpha=0.3, lw=0)
    factor.set(ylabel="given of wanted", xlabel="time [s]", ylim=(0, 1.02))
    for axes in (linear, angular, factor):
        axes.set_xlim(times[0], times[-1])
        axes.grid(color=INK, alpha=0.12, linewidth=0.8)
    figure.savefig(path, dpi=100)


def _draw_plan(axes: Axes, spots: Sequence[Spot], blocks: Iterable[Block], hull: Rectangle | None,
               touched: Sequence[tuple[float, float]]) -> None:
    for one in blocks:
        if one.round:
            axes.add_patch(Circle((one.x, one.y), one.length / 2, color=WOOD))
        else:
            axes.add_patch(box_about(Pose(one.x, one.y, one.yaw), one.length, one.width, color=WOOD))
    way = np.array([(spot.pose.x, spot.pose.y) for spot in spots])
    pieces = LineCollection(np.stack([way[:-1], way[1:]], axis=1), cmap="RdYlBu", linewidth=2)
    pieces.set_array(np.array([spot.factor for spot in spots[:-1]]))
    pieces.set_clim(0, 1)
    axes.add_collection(pieces)
    for spot in _stops(spots):
        axes.add_patch(_outline(hull, spot.pose, facecolor="none", edgecolor=RED, lw=0.8, alpha=0.7))
        axes.add_patch(_arrow(spot))
    axes.add_patch(_outline(hull, spots[-1].pose, facecolor=BLUE, edgecolor=INK, alpha=0.5))
    if touched:
        axes.plot(*np.array(touched).T, "x", color="black", ms=9, mew=2, label="touched")
        axes.legend(loc="upper right")
    low, high = way.min(axis=0) - 1.2, way.max(axis=0) + 1.2
    axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x [m]", ylabel="y [m]")
    axes.set_title("red: most was taken; outlined: where it was stopped, and which way it was to go", fontsize=8, color=INK)


def _stops(spots: Sequence[Spot]) -> list[Spot]:
    """Where it stood although somebody wanted it to move."""
    found: list[Spot] = []
    for spot in spots:
        if spot.is_stopped and all(hypot(spot.pose.x - one.pose.x, spot.pose.y - one.pose.y) > _STANDS_APART for one in found):
            found.append(spot)
    return found


def _outline(hull: Rectangle | None, pose: Pose, **looks):
    if hull is None:
        return Circle((pose.x, pose.y), BODY_RADIUS, **looks)
    c, s = cos(pose.yaw), sin(pose.yaw)
    return Polygon([(pose.x + c * x - s * y, pose.y + s * x + c * y) for x, y in hull.corners], closed=True, **looks)


def _arrow(spot: Spot) -> Polygon:
    """A slim triangle, as long as half a second of what was wanted."""
    ahead, bent = 0.5 * spot.wanted.linear, 0.25 * spot.wanted.angular
    heading = spot.pose.yaw + bent
    tip = (spot.pose.x + ahead * cos(heading), spot.pose.y + ahead * sin(heading))
    aside = (-0.02 * sin(heading), 0.02 * cos(heading))
    ends = [(spot.pose.x + side * aside[0], spot.pose.y + side * aside[1]) for side in (1, -1)]
    return Polygon([*ends, tip], closed=True, color=RED, alpha=0.6, lw=0)
