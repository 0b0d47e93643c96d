# SPDX-License-Identifier: BSD-3-Clause
"""What another guard would have given of the same commands."""
from __future__ import annotations

from dataclasses import dataclass
from heapq import merge
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from safety_control_cloud.judge.store import Store
from safety_control_cloud.judge.table import AnyBag, rows_in
from safety_control_cloud.replay.guard.counts import NOT_YET

GIVEN = ("given_x", "given_y", "given_turn")
SAID = ("zone", "cause", *GIVEN)
Said = Optional[Dict[str, Any]]  # None: nothing yet


@dataclass(frozen=True)
class Difference:
    """A bag by whose end two guards have not done the same all the time."""

    path: str
    start: int  # [ns] of the bag
    time: int  # [ns] of the first moment
    before: Dict[str, Any]  # said at that moment
    after: Dict[str, Any]
    lasting: int  # [ns] in all
    stretches: int  # in which something else is said of it, by zone or cause


def differences(store: Store, rows: Sequence[AnyBag], before: str, after: str) -> List[Difference]:
    """Between the answers by two settings (their hashes); the longest first. An answer holds until the next."""
    found = []
    for row in sorted({row.path: row for row in rows if row.bag}.values(), key=lambda row: row.path):
        assert row.bag
        apart = _Apart(row.path)
        for time, said in _steps(store.file_of(row.bag, before), store.file_of(row.bag, after)):
            apart.note(time, said)
        if difference := apart.ended(row.end):
            found.append(difference)
    return sorted(found, key=lambda one: (-one.lasting, one.path))


class _Apart:
    """Without the start, in which one of them has not seen yet, unless one never sees."""

    def __init__(self, path: str) -> None:
        self._path, self._time, self._start = path, 0, 0  # [ns] of the latest and the first answer
        self._have_seen = [False, False]
        self._begin()

    def note(self, time: int, said: List[Said]) -> None:
        one, other = said
        self._start = self._start or time
        if one is None or other is None:
            return
        for place, its in enumerate((one, other)):
            if not self._have_seen[place] and its["cause"] not in NOT_YET:
                self._have_seen[place] = True
                self._begin()
        self._lasting += time - self._time if self._kind else 0
        kind = None if all(one[name] == other[name] for name in SAID) else (one["zone"], one["cause"], other["zone"], other["cause"])
        self._stretches += kind is not None and kind != self._kind
        if kind and not self._first:
            self._first = time, one, other
        self._time, self._kind = time, kind

    def ended(self, end: Optional[int]) -> Optional[Difference]:
        if not self._first:
            return None
        lasting = self._lasting + ((end or self._time) - self._time if self._kind else 0)
        return Difference(self._path, self._start, *self._first, lasting, self._stretches)

    def _begin(self) -> None:
        self._first: Optional[Tuple[int, Dict[str, Any], Dict[str, Any]]] = None
        self._kind: Optional[tuple] = None
        self._lasting = self._stretches = 0


def _steps(*files: Path) -> Iterator[Tuple[int, List[Said]]]:
    """What both say from each moment on."""
    said: List[Said] = [None, None]
    answers = merge(*(_answers(file, place) for place, file in enumerate(files)), key=itemgetter(0))
    for time, its in groupby(answers, key=itemgetter(0)):
        for _, place, answer in its:
            said[place] = answer
        yield time, said


def _answers(file: Path, place: int) -> Iterator[Tuple[int, int, Dict[str, Any]]]:
    for answer in rows_in(file, ("time", *SAID)):
        yield answer["time"], place, answer
