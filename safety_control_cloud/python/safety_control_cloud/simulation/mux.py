# SPDX-License-Identifier: BSD-3-Clause
"""The TurtleBot's velocity multiplexer: who may drive now. Behaves like, and is configured like, yocs_cmd_vel_mux."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import inf

IDLE = "idle"  # the holder's name when there is none


@dataclass(frozen=True)
class Input:
    name: str
    topic: str
    priority: int  # the higher takes over
    timeout: float  # [s] of silence after which this input no longer holds the mux
    short_desc: str = ""


TURTLEBOT_INPUTS = (
    Input("Safe reactive controller", "/cmd_vel_mux/input/safety_controller", 10, 0.2),
    Input("Teleoperation", "/cmd_vel_mux/input/teleop", 7, 1.0),
    Input("Switch", "/cmd_vel_mux/input/switch", 6, 1.0),
    Input("Navigation", "/cmd_vel_mux/input/navi", 5, 1.0),
)


@dataclass(frozen=True)
class Table:
    inputs: tuple[Input, ...]
    publisher: str  # the output's topic


def table_from(document: object) -> Table:
    """A table in yocs_cmd_vel_mux's YAML format: `subscribers`, a list of inputs, and `publisher`.

    Raises ValueError with every problem found.
    """
    if not isinstance(document, Mapping):
        raise ValueError("must be a mapping with subscribers and publisher")
    entries = document.get("subscribers") or []
    if not isinstance(entries, list):
        raise ValueError("subscribers must be a list of inputs")
    problems = [] if entries else ["no subscribers"]
    inputs: list[Input] = []
    for place, entry in enumerate(entries):
        try:
            inputs.append(
                Input(
                    name=str(entry["name"]),
                    topic=str(entry["topic"]),
                    priority=int(entry["priority"]),
                    timeout=float(entry["timeout"]),
                    short_desc=str(entry.get("short_desc", "")),
                )
            )
        except (KeyError, TypeError, ValueError) as error:
            problems.append(f"subscriber {place}: {error!r}")
    problems += _problems_of(inputs)
    if problems:
        raise ValueError("; ".join(problems))
    return Table(tuple(inputs), str(document.get("publisher", "output/cmd_vel")))


def _problems_of(inputs: Iterable[Input]) -> list[str]:
    inputs = list(inputs)
    problems = [f"{one.name}: timeout must be above 0" for one in inputs if not one.timeout > 0]
    for what in ("name", "topic", "priority"):
        counted = Counter(getattr(one, what) for one in inputs)
        problems += [f"{what} {value!r} is there {n} times" for value, n in counted.items() if n > 1]
    return problems


class Mux:
    """Lets one input at a time through. On a timeout it says nothing: the base stops by itself.

    Time is an argument [s].
    """

    def __init__(self, inputs: Iterable[Input] = TURTLEBOT_INPUTS) -> None:
        self._inputs = {one.name: one for one in inputs}
        self._holder: Input | None = None
        self._heard_at = -inf

    def passes(self, name: str, now: float) -> bool:
        """A message of input `name` has come: does it go through to the base?"""
        sender = self._inputs[name]
        holder = self._holding(now)
        if holder is not None and holder is not sender and sender.priority <= holder.priority:
            return False
        self._holder, self._heard_at = sender, now
        return True

    def holder(self, now: float) -> str:
        """The name of the input that holds the mux, or IDLE."""
        holding = self._holding(now)
        return holding.name if holding else IDLE

    def _holding(self, now: float) -> Input | None:
        if self._holder is not None and not 0 <= now - self._heard_at < self._holder.timeout:
            self._holder = None  # silent too long, or the clock has gone back
        return self._holder
