# SPDX-License-Identifier: BSD-3-Clause
"""What the viewer is told of a moment: entities, by their paths."""
from __future__ import annotations

from math import nan
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np
import rerun as rr

from safety_control_cloud import core
from safety_control_cloud.view.guarded import footprint_of, swept
from safety_control_cloud.view.moment import Depth, Moment, Picture, Points

COLOURS = {"Safe": (46, 158, 91), "Warning": (232, 163, 23), "Danger": (214, 69, 69)}
UNKNOWN, INK, GREY, LOST = (135, 149, 161), (90, 170, 250), (150, 150, 150), (255, 120, 255)
CAMERA, CORRIDOR, FOOTPRINT, LIMITS, PATH, POINT, POINTS, REMEMBERED, WANTED = (
    f"world/{name}" for name in ("camera", "corridor", "footprint", "limits", "path", "nearest", "points", "remembered", "wanted"))
CAMERA_ELSEWHERE = "camera"  # whose place in the target_frame is not told
DISTANCE, SPEED, ZONE, CAUSE, LOG = "distance", "speed", "decision/zone", "decision/cause", "log"
HELD = (f"{SPEED}/commanded", f"{SPEED}/wanted")
THIN = 0.004  # [m] of a plane

Entities = List[Tuple[str, Any]]


def below(sensor: str) -> str:
    """Where the entities of one sensor of several stand."""
    return f"{sensor.strip('/')}/" if sensor else ""


def guards(settings: core.Settings) -> bool:
    return settings.mode == "guard"


def camera_path(settings: core.Settings) -> str:
    return CAMERA_ELSEWHERE if settings.target_frame and not guards(settings) else CAMERA


def lasting(settings: core.Settings) -> Entities:
    """What holds for the whole drive."""
    axes = rr.ViewCoordinates.FLU if settings.target_frame or guards(settings) else rr.ViewCoordinates.RDF
    return [("world", axes), *([] if guards(settings) else _limits(settings)), *_styles(settings)]


def _limits(settings: core.Settings) -> Entities:
    limits = {"warning": settings.warning_distance, "danger": settings.danger_distance}
    boxes = [_corridor(settings, at - THIN / 2, at + THIN / 2) for at in limits.values()]
    planes = rr.Boxes3D(
        centers=[box[0] for box in boxes], half_sizes=[box[1] for box in boxes],
        colors=[COLOURS[zone.capitalize()] for zone in limits], labels=[f"{zone} {at:g} m" for zone, at in limits.items()])
    return [(LIMITS, planes)]


def _styles(settings: core.Settings) -> Entities:
    lines = {f"{DISTANCE}/nearest": INK, f"{SPEED}/commanded": INK, f"{SPEED}/driven": GREY}
    if guards(settings):
        lines[f"{SPEED}/wanted"] = UNKNOWN
    else:
        lines.update({f"{DISTANCE}/warning": COLOURS["Warning"], f"{DISTANCE}/danger": COLOURS["Danger"],
                      f"{SPEED}/safe": COLOURS["Safe"], f"{SPEED}/warning": COLOURS["Warning"]})
    found: Entities = []
    for path, colour in lines.items():
        steps = "StepAfter" if path in HELD else "Linear"  # a command holds until the next
        found.append((path, rr.SeriesLines(colors=[colour], names=path.rpartition("/")[2], interpolation_mode=steps)))
    values = list(COLOURS)
    found.append((ZONE, rr.StateConfiguration(values=values, labels=values, colors=_packed(COLOURS.values()))))
    return found


def entities_of(moment: Moment, settings: core.Settings, before: Optional[Moment] = None) -> Entities:
    """Of one moment; the picture is left out where it has none, and what goes on from the moment before is not said again."""
    scene = _floor(moment, settings) if guards(settings) else _corridor_ahead(moment, settings)
    return [*_gone(moment, before, settings), *_picture(moment, before, settings), *scene, *_plots(moment, settings), *_said(moment, before)]


def _gone(moment: Moment, before: Optional[Moment], settings: core.Settings) -> Entities:
    """A picture of another kind does not take the place of the one before."""
    if before is None or type(before.picture) is type(moment.picture):
        return []
    return [(f"{camera_path(settings)}/depth", rr.Clear(recursive=False)), (_points_path(settings), rr.Clear(recursive=False))]


def _picture(moment: Moment, before: Optional[Moment], settings: core.Settings) -> Entities:
    """The same object as before is the same picture."""
    picture, camera = moment.picture, camera_path(settings)
    if before is not None and picture is before.picture:
        picture = None
    if guards(settings):
        if moment.place is None:
            return []  # where it belongs is not known
        placed = rr.Transform3D(mat3x3=moment.place[:, :3], translation=moment.place[:, 3])
        return [(camera, placed), *_picture_of(picture, settings)]
    return _picture_of(picture, settings)


def _picture_of(picture: Optional[Picture], settings: core.Settings) -> Entities:
    camera = camera_path(settings)
    if isinstance(picture, Depth):
        height, width = picture.millimetres.shape
        lens = picture.camera
        pinhole = rr.Pinhole(
            focal_length=(lens.fx, lens.fy), principal_point=(lens.cx + 0.5, lens.cy + 0.5), width=width, height=height,
            camera_xyz=rr.ViewCoordinates.RDF, image_plane_distance=0.3)
        shown = rr.DepthImage(picture.millimetres, meter=1000.0, depth_range=(0.0, 4000.0), colormap="turbo")
        return [(camera, pinhole), (f"{camera}/depth", shown)]
    if isinstance(picture, Points):
        return [(_points_path(settings), rr.Points3D(picture.xyz, colors=_by_depth(picture.xyz[:, 2]), radii=rr.Radius.ui_points(2.0)))]
    return []


def _points_path(settings: core.Settings) -> str:
    return f"{camera_path(settings)}/points" if settings.target_frame or guards(settings) else POINTS


def _corridor_ahead(moment: Moment, settings: core.Settings) -> Entities:
    colour = COLOURS.get(moment.zone, UNKNOWN)
    centre, half = _corridor(settings, 0.0, settings.warning_distance)
    text = moment.zone if moment.nearest is None else f"{moment.zone} {moment.nearest:.2f} m"
    corridor = rr.Boxes3D(
        centers=[centre], half_sizes=[half], colors=[colour], fill_mode="TransparentFillMajorWireframe",
        labels=[text if moment.cause == "SEEN" else f"{text}, {moment.cause}"])
    remembered = f"{camera_path(settings)}/remembered" if settings.target_frame else REMEMBERED
    return [(CORRIDOR, corridor), _decider(moment),
            (remembered, rr.Points3D(moment.remembered, colors=[LOST], radii=[0.02]))]


def _floor(moment: Moment, settings: core.Settings) -> Entities:
    """The footprint, what it would sweep, and what it sweeps."""
    colour, guarded = COLOURS.get(moment.zone, UNKNOWN), moment.guarded
    given = swept(settings, guarded.given) if guarded else []
    wanted = swept(settings, guarded.wanted) if guarded and guarded.wanted != guarded.given else []
    return [(FOOTPRINT, rr.LineStrips3D([footprint_of(settings)], colors=[colour], radii=[0.008])), _decider(moment),
            (WANTED, rr.LineStrips3D(wanted, colors=[UNKNOWN], radii=[0.002])),
            (PATH, rr.LineStrips3D(given, colors=[colour], radii=[0.004]))]


def _decider(moment: Moment) -> Tuple[str, Any]:
    return POINT, rr.Points3D([moment.point] if moment.point else [], colors=[COLOURS.get(moment.zone, UNKNOWN)], radii=[0.03])


def _plots(moment: Moment, settings: core.Settings) -> Entities:
    values: Dict[str, float] = {
        f"{DISTANCE}/nearest": nan if moment.nearest is None else moment.nearest, f"{SPEED}/commanded": moment.speed}
    if not guards(settings):
        values.update({
            f"{DISTANCE}/warning": settings.warning_distance, f"{DISTANCE}/danger": settings.danger_distance,
            f"{SPEED}/safe": settings.safe_speed, f"{SPEED}/warning": settings.warning_speed})
    elif moment.guarded:
        values[f"{SPEED}/wanted"] = moment.guarded.wanted[0]
    if moment.driven is not None:
        values[f"{SPEED}/driven"] = moment.driven
    return [(path, rr.Scalars(value)) for path, value in values.items()]


def _said(moment: Moment, before: Optional[Moment]) -> Entities:
    if before and (before.zone, before.cause) == (moment.zone, moment.cause):
        return []
    level = rr.TextLogLevel.INFO if moment.cause == "SEEN" else rr.TextLogLevel.WARN
    return [(ZONE, rr.StateChange(state=moment.zone)), (CAUSE, rr.StateChange(state=moment.cause)),
            (LOG, rr.TextLog(f"{moment.zone}, {moment.cause}: {moment.reason}", level=level))]


def _corridor(settings: core.Settings, start: float, end: float) -> Tuple[Tuple[float, ...], Tuple[float, ...]]:
    """Centre and half size of a stretch of it."""
    if settings.target_frame:
        low, high = (start, -settings.right, settings.bottom), (end, settings.left, settings.top)
    else:
        low, high = (settings.x_min, settings.y_min, start), (settings.x_max, settings.y_max, end)
    return tuple((a + b) / 2 for a, b in zip(low, high)), tuple((b - a) / 2 for a, b in zip(low, high))


def _by_depth(z: np.ndarray) -> np.ndarray:
    near = 1.0 - np.clip(z / 4.0, 0.0, 1.0)
    return np.stack([255 * near, 90 + 60 * near, 255 * (1.0 - near)], axis=1).astype(np.uint8)


def _packed(colours: Iterable[Tuple[int, int, int]]) -> np.ndarray:
    return np.array([(red << 24) + (green << 16) + (blue << 8) + 255 for red, green, blue in colours], np.uint32)
