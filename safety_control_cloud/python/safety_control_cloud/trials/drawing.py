# SPDX-License-Identifier: BSD-3-Clause
"""Plans of a drive, seen from above, and speed over time."""
from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.patches import Circle, Rectangle

from ..simulation.base import Pose
from ..simulation.hull import BODY_RADIUS
from ..zone_colours import DRAWN as ZONES
from .outcome import Outcome, Truth
from .scenario import XTION, Scenario
from .stage import FREE_TO
from .things import Surface

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

INK, QUIET = "#22303c", "#8795a1"
SURFACES = {Surface.PLAIN: "#9c6b3e", Surface.GLASS: "#b6d8ee", Surface.BLACK: "#1c1c1e"}


def plan_and_speed(path: Path, scenario: Scenario, method: str, moments: Sequence[Truth], outcome: Outcome) -> None:
    """A file in the format of the path's ending."""
    figure = Figure(figsize=(10, 4), constrained_layout=True)
    plan, speed = figure.subplots(1, 2)
    _draw_plan(plan, scenario, moments)
    times = [moment.time for moment in moments]
    speed.step(times, [moment.speed for moment in moments], where="post", color=INK)
    for zone, colour in ZONES.items():
        during = [moment.verdict.zone == zone for moment in moments]
        speed.fill_between(times, 0, 0.22, where=during, step="post", color=colour, alpha=0.2, lw=0)
    speed.set(xlabel="time [s]", ylabel="speed [m/s]", ylim=(-0.01, 0.22))
    hit = f" - ran into {outcome.collision.thing}" if outcome.collision else ""
    figure.suptitle(f"{scenario.name}, {method}{hit}", color=INK)
    figure.savefig(path, dpi=100)


def plan_picture(scenario: Scenario, moments: Sequence[Truth]) -> NDArray[np.uint8]:
    """(height, width, 3) red, green, blue, as large as the camera's picture."""
    figure = Figure(figsize=(XTION.width / 80, XTION.height / 80), dpi=80, constrained_layout=True)
    canvas = FigureCanvasAgg(figure)
    axes = figure.subplots()
    _draw_plan(axes, scenario, moments)
    now = moments[-1]
    axes.set_title(f"{now.time:.1f} s  {now.verdict.zone}  {now.verdict.cause}", fontsize=8, color=ZONES[now.verdict.zone])
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()


def _draw_plan(axes: Axes, scenario: Scenario, moments: Sequence[Truth]) -> None:
    """World frame: x to the right, y up; things where they are at the last moment, the corridor in green."""
    now = moments[-1]
    for thing in scenario.things:
        x, y = thing.place(now.time)
        colour = SURFACES[thing.surface]
        if thing.round:
            axes.add_patch(Circle((x, y), thing.size[0] / 2, color=colour))
        else:
            length, width, _ = thing.size
            axes.add_patch(box_about(Pose(x, y, thing.at.yaw), length, width, color=colour))
    axes.plot([moment.pose.x for moment in moments], [moment.pose.y for moment in moments], color=QUIET, lw=1)
    axes.add_patch(_corridor(now))
    axes.add_patch(Circle((now.pose.x, now.pose.y), BODY_RADIUS, color=ZONES[now.verdict.zone], alpha=0.8))
    axes.set(aspect="equal", xlim=(-0.6, 3.6), ylim=(-1.6, 1.6))
    axes.tick_params(labelsize=7)


def box_about(centre: Pose, length: float, width: float, color: str) -> Rectangle:
    """Turned about its centre: before 3.6 matplotlib turns it about its corner alone."""
    cos, sin = np.cos(centre.yaw), np.sin(centre.yaw)
    corner = (centre.x - (length * cos - width * sin) / 2, centre.y - (length * sin + width * cos) / 2)
    return Rectangle(corner, length, width, angle=degrees(centre.yaw), color=color)


def _corridor(now: Truth) -> Rectangle:
    x, y, _ = XTION.mount
    cos, sin = np.cos(now.pose.yaw), np.sin(now.pose.yaw)
    left, right = x, y - 0.30
    corner = (now.pose.x + left * cos - right * sin, now.pose.y + left * sin + right * cos)
    return Rectangle(corner, FREE_TO, 0.60, angle=degrees(now.pose.yaw), color="#2e9e5b" if now.free else "#d64545", alpha=0.15)
