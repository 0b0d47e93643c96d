# SPDX-License-Identifier: BSD-3-Clause
"""What a guard did in a drive, counted answer by answer: nothing of it grows with the drive."""
from __future__ import annotations

from collections import Counter
from typing import Counter as Counted, Optional

from safety_control_cloud.replay.guard.drive import COMMAND, Answer

NOT_YET = ("NO_CLOUD", "NO_TRANSFORM")  # of a guard that has just started
PASSES, LESS, NOTHING = "passes", "less", "nothing"
ZONES = {PASSES: "Safe", LESS: "Warning", NOTHING: "Danger"}


def does(answer: Answer) -> str:
    if not answer.differs and answer.factor > 0.0:
        return PASSES
    return LESS if answer.factor > 0.0 else NOTHING


def zone_of(answer: Answer) -> str:
    """As the node's ~state has it."""
    return ZONES[does(answer)]


class Counts:
    """Without the start: a guard that had run before the bag began would have seen by then. All, if nothing is ever seen."""

    def __init__(self) -> None:
        self.answers = 0  # the start among them
        self.causes: Counted[str] = Counter()  # of those
        self.early = 0  # commands before the first picture
        self._seen = False
        self._begin()

    def add(self, answer: Answer) -> None:
        self.answers += 1
        self.causes[answer.cause] += 1
        if not self._seen and answer.cause not in NOT_YET:
            self.early = self.commands
            self._seen = True
            self._begin()
        self.end(answer.time)
        self._latest = answer
        if answer.asked_by == COMMAND:
            self.commands += 1
            self.scaled += answer.differs and answer.factor > 0.0
            self.stopped += answer.differs and answer.factor == 0.0
        if answer.differs and self.first is None:
            self.first = answer

    def end(self, time: int) -> None:
        """The latest answer lasts until then [ns]."""
        if self._latest and self._latest.differs:
            lasts = time - self._latest.time
            self.differing += lasts
            self.standing += lasts if self._latest.factor == 0.0 else 0
        self._latest = None

    @property
    def passed(self) -> int:
        return self.commands - self.scaled - self.stopped

    def _begin(self) -> None:
        self.commands = self.scaled = self.stopped = 0
        self.differing = self.standing = 0  # [ns] in which less is given than wanted, and nothing of it
        self.first: Optional[Answer] = None  # that gave something else than was wanted
        self._latest: Optional[Answer] = None
