# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a drive in both simulators: from above, what both cameras see at its end, and the speeds."""
from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from driven import Driven, Pair
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.simulation.hull import BODY_RADIUS
from safety_control_cloud.trials.drawing import box_about

COLOURS = {"MuJoCo": "#2e6fb7", "Gazebo": "#e0882b"}


def draw(pair: Pair, path: Path) -> None:
    """In the format of the path's ending."""
    figure = Figure(figsize=(12, 7), constrained_layout=True)
    (plan, speeds), pictures = figure.subplots(2, 2)
    _draw_things(plan, pair)
    for (name, driven), picture in zip((("MuJoCo", pair.mujoco), ("Gazebo", pair.gazebo)), pictures):
        colour = COLOURS[name]
        plan.add_patch(Circle((driven.end.x, driven.end.y), BODY_RADIUS, fill=False, ec=colour, lw=2, label=name))
        _draw_speed(speeds, driven, colour)
        picture.imshow(driven.last, cmap="viridis", vmin=0.4, vmax=3.0)
        picture.set_title(f"{name}: {driven.cause}, x {driven.end.x:.3f} m", fontsize=9)
    plan.legend(fontsize=8)
    plan.set(aspect="equal", xlim=(-0.4, 3.2), ylim=(-1.2, 1.2))
    speeds.set(xlabel="time [s]", ylabel="speed [m/s]")
    figure.suptitle(f"{pair.scenario.name}: {100 * pair.apart:.1f} cm apart")
    figure.savefig(path, dpi=90)


def _draw_things(axes: Axes, pair: Pair) -> None:
    for thing in pair.scenario.things:
        x, y = thing.place(0.0)
        length, width, _ = thing.size
        if thing.round:
            axes.add_patch(Circle((x, y), length / 2, color="#9c6b3e"))
        else:
            axes.add_patch(box_about(Pose(x, y, thing.at.yaw), length, width, color="#9c6b3e"))


def _draw_speed(axes: Axes, driven: Driven, colour: str) -> None:
    begins = driven.track[0].time
    axes.plot([moment.time - begins for moment in driven.track], [moment.speed for moment in driven.track], color=colour, lw=1)
