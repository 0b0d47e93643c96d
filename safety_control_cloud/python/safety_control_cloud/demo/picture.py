# SPDX-License-Identifier: BSD-3-Clause
"""A drive as a picture: what the camera saw, how near the obstacle was, how fast the robot went."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from .record import Approach

DANGER, WARNING = 0.5, 1.0  # [m] the node's defaults
COLOURS = {"Safe": "#2e7d4f", "Warning": "#c77700", "Danger": "#c0322b"}
_PALE = {"Safe": "#e3f1e8", "Warning": "#fdf0d9", "Danger": "#f9dfdd"}
_INK = "#22303c"


def draw(approaches: Sequence[Approach], world: str, path: Path) -> None:
    """Write a PNG of the approaches, one after the other on one time axis."""
    figure = Figure(figsize=(12, 9), facecolor="white", layout="constrained")
    FigureCanvasAgg(figure)
    views, distance, speed = figure.subfigures(3, 1, height_ratios=(3.2, 3, 2.2))
    views.suptitle(f"safety_control_cloud in the world “{world}”: the robot slows, and stands", color=_INK, weight="bold", fontsize=14)
    _draw_views(views, approaches[0])
    origin = approaches[0].samples[0].time
    distance_axes, speed_axes = distance.subplots(), speed.subplots()
    _draw_distance(distance_axes, approaches, origin)
    _draw_speed(speed_axes, approaches, origin)
    for axes in (distance_axes, speed_axes):
        _mark_moves(axes, approaches, origin)
    figure.savefig(path, dpi=100)


def _draw_views(figure: Figure, approach: Approach) -> None:
    firsts = {zone: next(sample for sample in approach.samples if sample.zone == zone) for zone in approach.zones}
    for axes, zone in zip(figure.subplots(1, 3), COLOURS):
        axes.set_xticks([])
        axes.set_yticks([])
        for side in axes.spines.values():
            side.set(color=COLOURS[zone], linewidth=3)
        if zone in approach.views:
            axes.imshow(approach.views[zone])
        if zone in firsts:
            axes.set_title(f"{zone} zone: {_metres(firsts[zone].nearest)}", color=COLOURS[zone], weight="bold", fontsize=12)


def _metres(nearest: float) -> str:
    return f"nearest {nearest:.2f} m" if np.isfinite(nearest) else "nothing in the corridor"


def _series(approach: Approach, origin: float, what: str) -> tuple[np.ndarray, np.ndarray]:
    times = np.array([sample.time - origin for sample in approach.samples])
    values = np.array([getattr(sample, what) for sample in approach.samples])
    return times, np.where(np.isfinite(values), values, np.nan)


def _draw_distance(axes: Axes, approaches: Sequence[Approach], origin: float) -> None:
    all_nearest = np.concatenate([_series(approach, origin, "nearest")[1] for approach in approaches])
    top = max(1.5, 1.08 * np.nanmax(all_nearest, initial=0.0))
    for zone, low, high in (("Danger", 0, DANGER), ("Warning", DANGER, WARNING), ("Safe", WARNING, top)):
        axes.axhspan(low, high, color=_PALE[zone], linewidth=0)
        axes.text(0.995, (low + high) / 2, zone, transform=axes.get_yaxis_transform(), ha="right", va="center", color=COLOURS[zone], weight="bold")
    for approach in approaches:
        times, nearest = _series(approach, origin, "nearest")
        axes.plot(times, nearest, color=_INK, linewidth=2)
        if approach.stood_at is not None:
            axes.annotate(f"stands {approach.stood_at:.2f} m before it", (times[-1], nearest[-1]), xytext=(-10, 34), textcoords="offset points",
                          ha="right", color=_INK, arrowprops={"arrowstyle": "->", "color": _INK})
    axes.set(ylabel="nearest obstacle [m]", ylim=(0, top))
    _tidy(axes)


def _draw_speed(axes: Axes, approaches: Sequence[Approach], origin: float) -> None:
    for turn, approach in enumerate(approaches):
        times, commanded = _series(approach, origin, "commanded")
        axes.step(times, commanded, where="post", color="#6b7c8c", linewidth=2, linestyle=(0, (4, 2)), label=None if turn else "commanded")
        axes.plot(*_series(approach, origin, "speed"), color="#1f5fa8", linewidth=2, label=None if turn else "driven")
    axes.set(ylabel="speed [m/s]", xlabel="time [s]", ylim=(-0.01, 0.25))
    axes.legend(loc="upper right", frameon=False, ncols=2)
    _tidy(axes)


def _mark_moves(axes: Axes, approaches: Sequence[Approach], origin: float) -> None:
    axes.set_xlim(0, approaches[-1].samples[-1].time - origin)
    for approach in approaches[1:]:
        at = approach.samples[0].time - origin
        axes.axvline(at, color=_INK, linewidth=1, linestyle=":")
        axes.text(at, 0.97, " moved back", transform=axes.get_xaxis_transform(), va="top", color=_INK, fontsize=9)


def _tidy(axes: Axes) -> None:
    axes.grid(color="#00000014")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
