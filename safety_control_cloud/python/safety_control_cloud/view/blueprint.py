# SPDX-License-Identifier: BSD-3-Clause
"""How the viewer is laid out: the scene, the picture, the plots, what was decided and why."""
from __future__ import annotations

from typing import List, Sequence

import rerun.blueprint as rrb

from safety_control_cloud import core
from safety_control_cloud.view.entities import CAUSE, DISTANCE, LOG, SPEED, ZONE, below, camera_path, guards

TIMELINE = "time"


def blueprint(settings: core.Settings, sensors: Sequence[str] = ("",)) -> rrb.Blueprint:
    """Of several sensors, each has a column."""
    return rrb.Blueprint(
        _alone(settings) if len(sensors) == 1 else rrb.Horizontal(*(_column(settings, sensor) for sensor in sensors)),
        rrb.TimePanel(timeline=TIMELINE, state="collapsed"),
        rrb.SelectionPanel(state="hidden"), rrb.BlueprintPanel(state="hidden"))


def _alone(settings: core.Settings) -> rrb.Horizontal:
    return rrb.Horizontal(
        rrb.Vertical(*_scene_and_picture(settings), row_shares=(3, 2)),
        rrb.Vertical(*_plots(), row_shares=(3, 2, 2, 2)),
        column_shares=(3, 2))


def _column(settings: core.Settings, sensor: str) -> rrb.Vertical:
    views = [*_scene_and_picture(settings, sensor), *_plots(sensor)]
    return rrb.Vertical(*views, row_shares=(4, 3, 2, 2, 1, 1), name=sensor)


def _scene_and_picture(settings: core.Settings, sensor: str = "") -> List[rrb.View]:
    at, called = below(sensor), f"{sensor} " if sensor else ""
    camera = at + camera_path(settings)
    return [rrb.Spatial3DView(origin=f"{at}world", name=f"{called}scene", eye_controls=_behind(settings)),
            rrb.Spatial2DView(origin=camera, contents=[f"{camera}/**", f"{at}world/nearest"], name=f"{called}picture")]


def _plots(sensor: str = "") -> List[rrb.View]:
    at = below(sensor)
    return [rrb.TimeSeriesView(origin=at + DISTANCE, name="nearest obstacle [m]"),
            rrb.TimeSeriesView(origin=at + SPEED, name="speed [m/s]"),
            rrb.StateTimelineView(origin=f"{at}decision", contents=[at + ZONE, at + CAUSE], name="zone and cause"),
            rrb.TextLogView(origin=at + LOG, name="why")]


def _behind(settings: core.Settings) -> rrb.EyeControls3D:
    """Over the robot's shoulder."""
    if settings.target_frame or guards(settings):
        return rrb.EyeControls3D(position=(-1.6, -0.9, 1.5), look_target=(1.0, 0.0, 0.2), eye_up=(0.0, 0.0, 1.0))
    return rrb.EyeControls3D(position=(0.9, -1.2, -1.6), look_target=(0.0, 0.1, 1.0), eye_up=(0.0, -1.0, 0.0))
