# SPDX-License-Identifier: BSD-3-Clause
"""A master that is started anew: it knows nothing of before."""
from __future__ import annotations

from contextlib import contextmanager
from typing import Iterator

import rosgraph
from robot import eventually

from safety_control_cloud.processes import process


@contextmanager
def master_again(uri: str) -> Iterator[None]:
    with process(["rosmaster", "--core", "-p", uri.rstrip("/").rpartition(":")[2]]) as master:
        eventually(rosgraph.is_master_online)
        yield
