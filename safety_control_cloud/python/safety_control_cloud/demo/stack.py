# SPDX-License-Identifier: BSD-3-Clause
"""A ROS of one's own: roslaunch with its own master on a free port, ended as a whole."""
from __future__ import annotations

import os
import signal
import socket
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

_PATIENCE = 15.0  # [s] for the nodes to end by themselves


@dataclass(frozen=True)
class Stack:
    master: str  # ROS_MASTER_URI
    process: subprocess.Popen

    @property
    def is_running(self) -> bool:
        return self.process.poll() is None


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


@contextmanager
def launched(launch_file: str, arguments: Sequence[str], log: Path) -> Iterator[Stack]:
    """Run a launch file of this package; sets ROS_MASTER_URI of this process too, for rospy to find it."""
    port = free_port()
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    command = ["roslaunch", "-p", str(port), "safety_control_cloud", launch_file, *arguments]
    with log.open("w") as output:
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            yield Stack(os.environ["ROS_MASTER_URI"], process)
        finally:
            _end(process)


def _end(process: subprocess.Popen) -> None:
    for how in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        if process.poll() is not None:
            return
        os.killpg(process.pid, how)
        try:
            process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            continue
