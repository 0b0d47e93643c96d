# SPDX-License-Identifier: BSD-3-Clause
"""Where moments go: into a file, or to viewers that connect."""
from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import Iterator, Optional
from urllib.parse import quote

import numpy as np
import rerun as rr

from safety_control_cloud import core
from safety_control_cloud.view.blueprint import TIMELINE, blueprint
from safety_control_cloud.view.entities import Entities, entities_of, lasting
from safety_control_cloud.view.moment import Moment

APPLICATION = "safety_control_cloud"
MEMORY = "256MiB"  # of what viewers that come later are told


class Sink:
    """Takes the moments of one drive, in their order."""

    def __init__(self, stream: rr.RecordingStream, settings: core.Settings) -> None:
        self._stream, self._settings = stream, settings
        self._start: Optional[float] = None
        self._before: Optional[Moment] = None
        self._log(lasting(settings), lasts=True)

    def adopt(self, settings: core.Settings) -> None:
        """Goes on with other limits."""
        if settings.as_dict() != self._settings.as_dict():
            self._settings = settings
            self._log(lasting(settings), lasts=True)

    def show(self, moment: Moment) -> None:
        if self._start is None:
            self._start = moment.time
        self._stream.set_time(TIMELINE, duration=moment.time - self._start)
        if moment.stamp is not None:
            self._stream.set_time("stamp", timestamp=np.datetime64(moment.stamp, "ns"))
        self._log(entities_of(moment, self._settings, self._before))
        self._before = moment

    def _log(self, entities: Entities, lasts: bool = False) -> None:
        for path, content in entities:
            self._stream.log(path, content, static=lasts)


@contextmanager
def into_file(path: Path, settings: core.Settings) -> Iterator[Sink]:
    """Raises OSError if it cannot be written."""
    path.touch()
    stream = _stream()
    stream.save(path, default_blueprint=blueprint(settings))
    try:
        yield Sink(stream, settings)
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
