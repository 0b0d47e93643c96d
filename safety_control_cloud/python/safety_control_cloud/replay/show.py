# SPDX-License-Identifier: BSD-3-Clause
"""Answers as moments for the viewer."""
from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import Callable, Dict, Iterator, Optional, Sequence

from safety_control_cloud import core
from safety_control_cloud.replay.eyes import Sighting
from safety_control_cloud.replay.lockstep import Answer
from safety_control_cloud.replay.recording import RecordedCloud
from safety_control_cloud.replay.silence import Silence, silences
from safety_control_cloud.replay.wire import Image
from safety_control_cloud.replay.xyz import metres_of, points_of
from safety_control_cloud.view.memory import spots_in
from safety_control_cloud.view.moment import Moment, Picture
from safety_control_cloud.view.picture import depth_of, picture_of

Show = Callable[[RecordedCloud, Answer, Sequence[str]], None]


@contextmanager
def shown_in(file: Path, settings: core.Settings, topics: Sequence[str]) -> Iterator[Show]:
    """What to call with each cloud, its answer and what its node remembers then. Raises OSError."""
    from safety_control_cloud.view.sink import sensors_into_file

    last: Dict[str, Moment] = {}
    answered: Dict[str, Answer] = {}

    def show(cloud: RecordedCloud, answer: Answer, remembered: Sequence[str]) -> None:
        topic = answer.topic
        sink = sinks[topic if len(topics) > 1 else ""]
        for silence in silences([answered[topic]], answer.time, settings.source_timeout) if topic in answered else ():
            sink.show(silent(silence))
        moment = moment_of(cloud, answer, remembered, last[topic].picture if topic in last else None)
        sink.show(moment)
        last[topic], answered[topic] = moment, answer

    with sensors_into_file(file, settings, topics if len(topics) > 1 else [""]) as sinks:
        yield show


def moment_of(cloud: RecordedCloud, answer: Answer, remembered: Sequence[str], before: Optional[Picture] = None) -> Moment:
    return Moment(
        answer.time / 1e9, answer.zone, answer.cause, answer.reason, answer.nearest, answer.nearest_point, answer.speed,
        stamp=answer.stamp, picture=_picture(cloud, before), remembered=spots_in(remembered))


def silent(silence: Silence) -> Moment:
    lasts = (silence.end - silence.start) / 1e9
    return Moment(silence.start / 1e9, "Danger", "SILENT", f"{lasts:.3f} s more without a cloud", None, None, 0.0)


def _picture(cloud: RecordedCloud, before: Optional[Picture]) -> Optional[Picture]:
    return shown_of(cloud.sighting, before) if cloud.sighting else None


def shown_of(sighting: Sighting, before: Optional[Picture]) -> Optional[Picture]:
    if sighting.cloud.unreadable is not None:
        return None
    if isinstance(sighting.content, Image) and sighting.camera:
        return depth_of(metres_of(sighting.content), sighting.camera)
    points = points_of(sighting)
    return None if points is None else picture_of(points, before)
