# SPDX-License-Identifier: BSD-3-Clause
"""All that a guard answers to a bag."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, List, Optional

from safety_control_cloud.replay.bags import Bags
from safety_control_cloud.replay.guard.drive import Answer
from safety_control_cloud.replay.guard.inputs import Inputs
from safety_control_cloud.replay.guard.reading import Reading
from safety_control_cloud.replay.report import with_progress

if TYPE_CHECKING:
    from safety_control_cloud.replay.guard.show import Show


@dataclass(frozen=True)
class Guarded:
    answers: List[Answer]
    start: int  # [ns] of the bag
    warnings: List[str]


def guarded(bags: Bags, inputs: Inputs, show: Optional[Show] = None) -> Guarded:
    """Raises BagError also where nothing of a required sensor can be believed."""
    answers: List[Answer] = []

    def told(answer: Answer) -> None:
        answers.append(answer)
        if show:
            show.answer(answer)

    reading = Reading(bags, inputs, told, show)
    count = sum(topic.count for topic in reading.topics)
    for message in with_progress(bags.messages(reading.topics), count, "messages"):
        reading.take(message)
    warnings = reading.end()
    return Guarded(answers, reading.start, warnings)
