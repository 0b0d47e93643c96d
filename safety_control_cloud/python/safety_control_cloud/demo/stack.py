# SPDX-License-Identifier: BSD-3-Clause
"""A ROS of one's own: roslaunch with its own master on a free port, ended as a whole."""
from __future__ import annotations

import os
import signal
import socket
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

_PATIENCE = 10.0  # [s] for a process to end by itself


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


@contextmanager
def running(command: Sequence[str], log: Path) -> Iterator[subprocess.Popen]:
    """Run a command with its children for as long as the block lasts; what they say goes to `log`."""
    with log.open("w") as output:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            yield process
        finally:
            _end(process)


@contextmanager
def launched(launch_file: str, arguments: Sequence[str], log: Path) -> Iterator[subprocess.Popen]:
    """Run a launch file of this package with a master of its own, to which it leads this process too."""
    port = free_port()
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    with running(["roslaunch", "-p", str(port), "safety_control_cloud", launch_file, *arguments], log) as process:
        yield process


def _end(process: subprocess.Popen) -> None:
    for how in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        if process.poll() is not None:
            return
        os.killpg(process.pid, how)
        try:
            process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            continue
