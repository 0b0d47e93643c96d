# SPDX-License-Identifier: BSD-3-Clause
"""From bags to a table."""
from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import List, Mapping, Optional, Sequence

from safety_control_cloud import core
from safety_control_cloud.replay.bags import Recording, recording
from safety_control_cloud.replay.lockstep import Answer, safety_node
from safety_control_cloud.replay.report import print_table, with_progress, write_json


@dataclass(frozen=True)
class Request:
    """What to replay, and where to write it besides the table on stdout."""

    bags: Sequence[Path]
    topic: Optional[str] = None  # None: the only one that has clouds
    parameters: Mapping[str, str] = field(default_factory=dict)  # private ones of the node
    json: Optional[Path] = None
    plot: Optional[Path] = None


def replay(request: Request) -> List[Answer]:
    """Raises bags.BagError, lockstep.BadParameters, lockstep.NoAnswer, processes.ProcessError."""
    with recording(request.bags, request.topic) as recorded:
        answers = answers_to(recorded, request.parameters)
        title = f"{', '.join(bag.name for bag in request.bags)}  {recorded.topic}"
    print_table(answers, title)
    if request.json:
        write_json(answers, request.json)
    if request.plot:
        from safety_control_cloud.replay.plot import write_plot  # matplotlib takes half a second to load

        write_plot(answers, request.plot, title, settings_of(request.parameters))
    return answers


def answers_to(recorded: Recording, parameters: Mapping[str, str]) -> List[Answer]:
    with safety_node(parameters) as node:
        return [node.answer_to(cloud) for cloud in with_progress(recorded.clouds, recorded.count)]


def settings_of(parameters: Mapping[str, str]) -> core.Settings:
    """The settings the node had: it has accepted these parameters, so the numbers among them are numbers."""
    defaults = core.Settings().as_dict()
    return core.Settings(**{name: type(defaults[name])(value) for name, value in parameters.items() if name in defaults})
