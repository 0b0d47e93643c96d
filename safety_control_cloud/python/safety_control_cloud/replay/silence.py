# SPDX-License-Identifier: BSD-3-Clause
"""Where the node would have said SILENT: the lockstep hands it one cloud after the other, without the time between."""
from __future__ import annotations

from dataclasses import dataclass
from typing import List, Sequence

from safety_control_cloud.replay.lockstep import Answer


@dataclass(frozen=True)
class Silence:
    """No cloud for longer than source_timeout; times as those of the clouds around it [ns, of the bag]."""

    after: int  # the number of the cloud before it, from 0
    start: int  # the timeout after that cloud
    end: int  # the next cloud, or the end of the bag


def silences(answers: Sequence[Answer], end: int, timeout: float) -> List[Silence]:
    """`end` [ns] of the bag, `timeout` [s]."""
    patience = round(timeout * 1e9)
    times = [*(answer.time for answer in answers), end]
    return [Silence(number, time + patience, later) for number, (time, later) in enumerate(zip(times, times[1:]))
            if later - time > patience]
