# SPDX-License-Identifier: BSD-3-Clause
"""The guard's answers as moments for the viewer, and with each picture where its sensor was."""
from __future__ import annotations

import math
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator, Optional

import numpy as np

from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.guard.counts import zone_of
from safety_control_cloud.replay.guard.drive import Answer, Numbers
from safety_control_cloud.replay.guard.inputs import Inputs
from safety_control_cloud.replay.guard.scans import Scan
from safety_control_cloud.replay.places import Place
from safety_control_cloud.replay.show import shown_of
from safety_control_cloud.view.moment import Guarded, Moment, Motion, Picture, Points


@contextmanager
def shown_in(file: Path, inputs: Inputs) -> Iterator["Show"]:
    """Raises OSError."""
    from safety_control_cloud.view.sink import sensors_into_file

    names = list(inputs.names) if len(inputs.names) > 1 else [""]
    with sensors_into_file(file, inputs.settings, names) as sinks:
        yield Show([sinks[name] for name in names])


@dataclass(frozen=True)
class _Seen:
    """The latest of one sensor. A picture lasts until the next."""

    picture: Optional[Picture] = None
    stamp: Optional[int] = None  # [ns]
    place: Optional[np.ndarray] = None


class Show:
    """A column for each sensor; what was decided stands in all of them."""

    def __init__(self, sinks: list) -> None:
        self._sinks = sinks
        self._seen = [_Seen() for _ in sinks]

    def answer(self, answer: Answer) -> None:
        for sink, seen in zip(self._sinks, self._seen):
            sink.show(_moment(answer, answer.time, seen))

    def picture(self, sensor: int, sighting: Sighting, place: Place, answer: Answer) -> None:
        """What the sensor saw, with the answer that holds then."""
        picture = _picture(sighting, self._seen[sensor].picture)
        self._seen[sensor] = _Seen(picture, sighting.header.stamp, place if isinstance(place, np.ndarray) else None)
        self._sinks[sensor].show(_moment(answer, sighting.time, self._seen[sensor]))


def _picture(sighting: Sighting, before: Optional[Picture]) -> Optional[Picture]:
    if not isinstance(sighting.content, Scan):
        return shown_of(sighting, before)
    return None if sighting.cloud.unreadable is not None else Points(sighting.content.points())


def _moment(answer: Answer, time: int, seen: _Seen) -> Moment:
    point = None if answer.point is None else (*answer.point, 0.0)
    return Moment(
        time / 1e9, zone_of(answer), answer.cause, answer.reason, None if point is None else math.hypot(*answer.point), point,
        answer.given[0], None if answer.driven is None else answer.driven[0], seen.stamp, seen.picture,
        Guarded(_motion(answer.wanted), _motion(answer.given)), seen.place)


def _motion(numbers: Numbers) -> Motion:
    """What is no number is not drawn."""
    return tuple(value if math.isfinite(value) else 0.0 for value in (numbers[0], numbers[1], numbers[5]))
