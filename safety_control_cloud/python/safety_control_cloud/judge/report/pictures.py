# SPDX-License-Identifier: BSD-3-Clause
"""What the camera saw in one cloud of a bag: an organised one as it looks, another one from above."""
from __future__ import annotations

import base64
import io
from typing import Any, Dict, Optional

import numpy as np
from PIL import Image, ImageDraw

from safety_control_cloud import core
from safety_control_cloud.judge.find import path_of
from safety_control_cloud.judge.report.facts import Call
from safety_control_cloud.replay.bags import BagError, Bags, opened
from safety_control_cloud.replay.eyes import Sighting, eye_for
from safety_control_cloud.replay.topics import chosen
from safety_control_cloud.replay.xyz import points_of

FAR = 4.0  # [m] what is farther is dark
BEFORE = 2_000_000_000  # [ns] in which the other half of a depth image may have come
SIDE = 320  # [px]
NEAR_COLOUR, FAR_COLOUR, NOTHING = np.array([255, 236, 150]), np.array([28, 40, 92]), np.array([18, 18, 22])
RING = "#ff2b2b"


def picture_of(call: Call, settings: core.Settings) -> Optional[str]:
    """As a data: address; None where the bag is not to be had from here."""
    try:
        with opened([path_of(call.path)]) as bags:
            sighting = _sighting(bags, call.row)
    except (BagError, OSError):
        return None
    points = points_of(sighting) if sighting else None
    if points is None or not points.size:
        return None
    picture = _seen(points, call.row, settings) if points.shape[0] > 1 else _from_above(points[0], call.row, settings)
    stream = io.BytesIO()
    picture.save(stream, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(stream.getvalue()).decode()


def _sighting(bags: Bags, row: Dict[str, Any]) -> Optional[Sighting]:
    (source,) = chosen(bags, [row["topic"]])
    eye = eye_for(bags, source)
    for message in bags.messages(source.topics, start=row["time"] - (BEFORE if source.camera else 0)):
        sighting = eye.sighting_of(message)
        if sighting and sighting.time == row["time"] and sighting.header.stamp == row["stamp"]:
            return sighting
        if message.time > row["time"]:
            break
    return None


def _seen(points: np.ndarray, row: Dict[str, Any], settings: core.Settings) -> Image.Image:
    """By depth; what lies in the corridor is brighter, and there is a ring round the point that decides."""
    step = max(points.shape[1] // SIDE, 1)
    x, y, z = np.moveaxis(points[::step, ::step], -1, 0)
    seen = np.isfinite(z) & (z > 0)
    near = np.where(seen, 1.0 - np.clip(z / FAR, 0.0, 1.0), 0.0)[..., None]
    colours = np.where(seen[..., None], near * NEAR_COLOUR + (1.0 - near) * FAR_COLOUR, NOTHING)
    inside = seen & (x >= settings.x_min) & (x <= settings.x_max) & (y >= settings.y_min) & (y <= settings.y_max)
    if not settings.target_frame:
        colours[inside] = 0.45 * colours[inside] + 0.55 * np.array([60, 220, 120])
    picture = Image.fromarray(colours.astype(np.uint8))
    if row["x"] is not None and not settings.target_frame:
        away = np.where(seen, (x - row["x"]) ** 2 + (y - row["y"]) ** 2 + (z - row["z"]) ** 2, np.inf)
        v, u = np.unravel_index(int(np.argmin(away)), away.shape)
        ImageDraw.Draw(picture).ellipse((u - 9, v - 9, u + 9, v + 9), outline=RING, width=3)
    return picture


def _from_above(points: np.ndarray, row: Dict[str, Any], settings: core.Settings) -> Image.Image:
    """The robot below, looking up the page; the corridor's sides as lines."""
    picture = Image.new("RGB", (SIDE, SIDE), tuple(int(value) for value in NOTHING))
    draw = ImageDraw.Draw(picture)
    scale = SIDE / FAR  # [px/m]
    for side in (settings.x_min, settings.x_max):
        draw.line((SIDE / 2 + side * scale, 0, SIDE / 2 + side * scale, SIDE), fill="#3cdc78")
    shown = points[np.isfinite(points).all(axis=1) & (points[:, 2] > 0) & (points[:, 2] < FAR)]
    u, v = (SIDE / 2 + shown[:, 0] * scale).astype(int), (SIDE - 1 - shown[:, 2] * scale).astype(int)
    within = (u >= 0) & (u < SIDE) & (v >= 0)
    pixels = np.asarray(picture).copy()
    dot = 1 if within.sum() > 5000 else 2
    for right in range(dot):
        for down in range(dot):
            pixels[np.minimum(v[within] + down, SIDE - 1), np.minimum(u[within] + right, SIDE - 1)] = NEAR_COLOUR
    picture = Image.fromarray(pixels)
    if row["x"] is not None and not settings.target_frame:
        u, v = SIDE / 2 + row["x"] * scale, SIDE - row["z"] * scale
        ImageDraw.Draw(picture).ellipse((u - 9, v - 9, u + 9, v + 9), outline=RING, width=3)
    return picture
