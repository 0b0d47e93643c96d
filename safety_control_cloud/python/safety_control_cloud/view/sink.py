# SPDX-License-Identifier: BSD-3-Clause
"""Where moments go: into a file, or to viewers that connect."""
from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import Dict, Iterator, Optional, Sequence
from urllib.parse import quote

import numpy as np
import rerun as rr

from safety_control_cloud import core
from safety_control_cloud.view.blueprint import TIMELINE, blueprint
from safety_control_cloud.view.entities import Entities, below, entities_of, lasting
from safety_control_cloud.view.moment import Moment

APPLICATION = "safety_control_cloud"
MEMORY = "256MiB"  # of what viewers that come later are told


class _Clock:
    """That of the drive: it starts with the first moment of all sensors."""

    def __init__(self) -> None:
        self._start: Optional[float] = None

    def since_start(self, time: float) -> float:
        if self._start is None:
            self._start = time
        return time - self._start


class Sink:
    """Takes the moments of one sensor's drive, in their order."""

    def __init__(self, stream: rr.RecordingStream, settings: core.Settings, sensor: str = "", clock: Optional[_Clock] = None) -> None:
        self._stream, self._settings = stream, settings
        self._below, self._clock = below(sensor), clock or _Clock()
        self._before: Optional[Moment] = None
        self._log(lasting(settings), lasts=True)

    def adopt(self, settings: core.Settings) -> None:
        """Goes on with other limits."""
        if settings.as_dict() != self._settings.as_dict():
            self._settings = settings
            self._log(lasting(settings), lasts=True)

    def show(self, moment: Moment) -> None:
        self._stream.set_time(TIMELINE, duration=self._clock.since_start(moment.time))
        if moment.stamp is not None:
            self._stream.set_time("stamp", timestamp=np.datetime64(moment.stamp, "ns"))
        self._log(entities_of(moment, self._settings, self._before))
        self._before = moment

    def _log(self, entities: Entities, lasts: bool = False) -> None:
        for path, content in entities:
            self._stream.log(self._below + path, content, static=lasts)


@contextmanager
def into_file(path: Path, settings: core.Settings) -> Iterator[Sink]:
    """Raises OSError if it cannot be written."""
    with sensors_into_file(path, settings, [""]) as sinks:
        yield sinks[""]


@contextmanager
def sensors_into_file(path: Path, settings: core.Settings, names: Sequence[str]) -> Iterator[Dict[str, Sink]]:
    """A sink for each, side by side in one recording. Raises OSError if it cannot be written."""
    path.touch()
    stream, clock = _stream(), _Clock()
    stream.save(path, default_blueprint=blueprint(settings, names))
    try:
        yield {name: Sink(stream, settings, name, clock) for name in names}
    finally:
        stream.flush()
        stream.disconnect()


@contextmanager
def to_browsers(settings: core.Settings, host: str, web_port: int, data_port: int) -> Iterator[tuple[Sink, str]]:
    """A sink, and the address at which a browser sees it; `host` is this machine's name to the browser's."""
    stream = _stream()
    stream.serve_grpc(
        grpc_port=data_port, default_blueprint=blueprint(settings), server_memory_limit=MEMORY,
        cors_allow_origin=[f"http://{host}:{web_port}"])
    rr.serve_web_viewer(web_port=web_port, open_browser=False)
    try:
        yield Sink(stream, settings), address(host, web_port, data_port)
    finally:
        stream.disconnect()


def address(host: str, web_port: int, data_port: int) -> str:
    return f"http://{host}:{web_port}/?url={quote(f'rerun+http://{host}:{data_port}/proxy', safe='')}"


def _stream() -> rr.RecordingStream:
    stream = rr.RecordingStream(APPLICATION)
    stream.set_log_time_enabled(False)
    stream.set_log_tick_enabled(False)
    return stream
