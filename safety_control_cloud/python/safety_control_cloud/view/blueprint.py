# SPDX-License-Identifier: BSD-3-Clause
"""How the viewer is laid out: the scene, the picture, the plots, what was decided and why."""
from __future__ import annotations

import rerun.blueprint as rrb

from safety_control_cloud import core
from safety_control_cloud.view.entities import CAUSE, DISTANCE, LOG, SPEED, ZONE, camera_path

TIMELINE = "time"


def blueprint(settings: core.Settings) -> rrb.Blueprint:
    camera = camera_path(settings)
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(
                rrb.Spatial3DView(origin="world", name="scene", eye_controls=_behind(settings)),
                rrb.Spatial2DView(origin=camera, contents=[f"{camera}/**", "world/nearest"], name="picture"),
                row_shares=(3, 2)),
            rrb.Vertical(
                rrb.TimeSeriesView(origin=DISTANCE, name="nearest obstacle [m]"),
                rrb.TimeSeriesView(origin=SPEED, name="speed [m/s]"),
                rrb.StateTimelineView(origin="decision", contents=[ZONE, CAUSE], name="zone and cause"),
                rrb.TextLogView(origin=LOG, name="why"),
                row_shares=(3, 2, 2, 2)),
            column_shares=(3, 2)),
        rrb.TimePanel(timeline=TIMELINE, state="collapsed"),
        rrb.SelectionPanel(state="hidden"), rrb.BlueprintPanel(state="hidden"))


def _behind(settings: core.Settings) -> rrb.EyeControls3D:
    """Over the robot's shoulder."""
    if settings.target_frame:
        return rrb.EyeControls3D(position=(-1.6, -0.9, 1.5), look_target=(1.0, 0.0, 0.2), eye_up=(0.0, 0.0, 1.0))
    return rrb.EyeControls3D(position=(0.9, -1.2, -1.6), look_target=(0.0, 0.1, 1.0), eye_up=(0.0, -1.0, 0.0))
