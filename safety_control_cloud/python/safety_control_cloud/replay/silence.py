# SPDX-License-Identifier: BSD-3-Clause
"""Where the node would have said SILENT: the lockstep hands it one cloud after the other, without the time between."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Sequence

from safety_control_cloud.replay.lockstep import Answer


@dataclass(frozen=True)
class Silence:
    """No cloud for longer than source_timeout; times as those of the clouds around it [ns, of the bag]."""

    after: int  # the number of the cloud before it on its topic, from 0
    start: int  # the timeout after that cloud
    end: int  # the next cloud of the topic, or the end of the bag
    topic: str = ""


def silences(answers: Sequence[Answer], end: int, timeout: float) -> List[Silence]:
    """`end` [ns] of the bag, `timeout` [s]."""
    patience = round(timeout * 1e9)
    found = []
    for topic, its in by_topic(answers).items():
        times = [*(answer.time for answer in its), end]
        found += [Silence(number, time + patience, later, topic)
                  for number, (time, later) in enumerate(zip(times, times[1:])) if later - time > patience]
    return found


def by_topic(answers: Sequence[Answer]) -> Dict[str, List[Answer]]:
    """In the order in which the topics appear."""
    found: Dict[str, List[Answer]] = {}
    for answer in answers:
        found.setdefault(answer.topic, []).append(answer)
    return found
