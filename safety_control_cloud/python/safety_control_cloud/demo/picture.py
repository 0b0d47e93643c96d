# SPDX-License-Identifier: BSD-3-Clause
"""A drive as a picture: what the camera saw, how near the obstacle was, how fast the robot went."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..zone_colours import PALE, WRITTEN as COLOURS
from .record import Approach, Sample

DANGER, WARNING = 0.5, 1.0  # [m] the node's defaults
_INK, _GREY, _BLUE = "#22303c", "#6b7c8c", "#1f5fa8"


def draw(approaches: Sequence[Approach], world: str, path: Path) -> None:
    """Write a PNG of the approaches, one after the other on one time axis."""
    figure = Figure(figsize=(12, 9), facecolor="white", constrained_layout=True)
    FigureCanvasAgg(figure)
    figure.suptitle(f"World “{world}”: the robot slows down, and stands", color=_INK, weight="bold", fontsize=15)
    grid = figure.add_gridspec(3, 3, height_ratios=(3.2, 3, 2))
    for place, zone in enumerate(COLOURS):
        _draw_view(figure.add_subplot(grid[0, place]), approaches[0], zone)
    distance = figure.add_subplot(grid[1, :])
    speed = figure.add_subplot(grid[2, :], sharex=distance)
    origin = approaches[0].samples[0].time
    _draw_distance(distance, approaches, origin)
    _draw_speed(speed, approaches, origin)
    for axes in (distance, speed):
        _tidy(axes, approaches, origin)
    figure.savefig(path, dpi=100)


def _draw_view(axes: Axes, approach: Approach, zone: str) -> None:
    axes.set_xticks([])
    axes.set_yticks([])
    for side in axes.spines.values():
        side.set(color=COLOURS[zone], linewidth=3)
    if zone in approach.views:
        axes.imshow(approach.views[zone])
    first = next((sample for sample in approach.samples if sample.zone == zone), None)
    if first:
        axes.set_title(_caption(first), color=COLOURS[zone], weight="bold", fontsize=12)


def _caption(sample: Sample) -> str:
    where = f"obstacle at {sample.nearest:.2f} m" if np.isfinite(sample.nearest) else "nothing in the corridor"
    return f"{sample.zone} zone: {where}"


def _draw_distance(axes: Axes, approaches: Sequence[Approach], origin: float) -> None:
    nearest = [_series(approach, origin, "nearest") for approach in approaches]
    top = max(1.5, 1.08 * max(np.nan_to_num(values).max() for _, values in nearest))
    for zone, low, high in (("Danger", 0, DANGER), ("Warning", DANGER, WARNING), ("Safe", WARNING, top)):
        axes.axhspan(low, high, color=PALE[zone], linewidth=0)
        axes.text(0.01, low + 0.06, zone, transform=axes.get_yaxis_transform(), color=COLOURS[zone], weight="bold")
    for approach, (times, values) in zip(approaches, nearest):
        axes.plot(times, values, color=_INK, linewidth=2)
        if approach.stood_at is not None:
            axes.annotate(f"stands {approach.stood_at:.2f} m before it", (times[-1], values[-1]), xytext=(-16, 44),
                          textcoords="offset points", ha="right", color=_INK,
                          arrowprops={"arrowstyle": "->", "color": _INK})
    axes.set(ylabel="nearest obstacle [m]", ylim=(0, top))
    axes.tick_params(labelbottom=False)


def _draw_speed(axes: Axes, approaches: Sequence[Approach], origin: float) -> None:
    for turn, approach in enumerate(approaches):
        hidden = "_" * bool(turn)  # matplotlib leaves such labels out: one entry a line is enough
        axes.step(*_series(approach, origin, "commanded"), where="post", color=_GREY, linewidth=2,
                  linestyle=(0, (4, 2)), label=hidden + "commanded")
        axes.plot(*_series(approach, origin, "speed"), color=_BLUE, linewidth=2, label=hidden + "driven")
    axes.set(ylabel="speed [m/s]", xlabel="time [s]", ylim=(-0.01, 0.26))
    axes.legend(loc="upper right", frameon=False, ncol=2)


def _series(approach: Approach, origin: float, what: str) -> tuple[np.ndarray, np.ndarray]:
    times = np.array([sample.time - origin for sample in approach.samples])
    values = np.array([getattr(sample, what) for sample in approach.samples])
    return times, np.where(np.isfinite(values), values, np.nan)


def _tidy(axes: Axes, approaches: Sequence[Approach], origin: float) -> None:
    axes.set_xlim(0, approaches[-1].samples[-1].time - origin + 0.3)
    axes.grid(color=_INK, alpha=0.12, linewidth=0.8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for approach in approaches[1:]:
        at = approach.samples[0].time - origin
        axes.axvline(at, color=_INK, linewidth=1, linestyle=":")
        axes.text(at, 0.96, " moved back", transform=axes.get_xaxis_transform(), va="top", color=_INK, fontsize=9)
