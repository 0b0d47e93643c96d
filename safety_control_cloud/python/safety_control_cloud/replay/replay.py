# SPDX-License-Identifier: BSD-3-Clause
"""From bags to a table."""
from __future__ import annotations

from pathlib import Path
from typing import Dict, List, Mapping, Optional

from safety_control_cloud import core
from safety_control_cloud.replay.bags import BagError
from safety_control_cloud.replay.lockstep import Answer
from safety_control_cloud.replay.nodes import safety_nodes
from safety_control_cloud.replay.options import GUARD, Request
from safety_control_cloud.replay.parameters import BadSettings, parameters_in, refuse_two_modes, settings_of
from safety_control_cloud.replay.recording import Recording, recording
from safety_control_cloud.replay.report import print_table, with_progress, write_json
from safety_control_cloud.replay.show import shown_in
from safety_control_cloud.replay.silence import silences
from safety_control_cloud.replay.topics import INPUTS
from safety_control_cloud.view.options import recorded_in

LISTS = ("sensors", "switches")  # which no argument of a node can be


def replay(request: Request) -> None:
    """Raises parameters.BadSettings, bags.BagError, lockstep.BadParameters, lockstep.NoAnswer, processes.ProcessError,
    optional.MissingPackages."""
    refuse_two_modes(request.mode, request.parameters)
    given = {**(parameters_in(request.settings) if request.settings else {}), **request.parameters}
    if request.mode:
        given["mode"] = request.mode
    if given.get("mode") == GUARD:
        from safety_control_cloud.replay.guard.replay import replay_guarded

        return replay_guarded(request, given)
    if request.cmd_vel or request.odom:
        raise BadSettings("--cmd-vel and --odom are of --mode guard")
    for name in LISTS:
        if given.pop(name, None):
            raise BadSettings(f"{name} are of mode guard: --mode guard")
    with recorded_in(request.rrd, request.view) as rrd:
        _replay(request, {name: str(value) for name, value in given.items()}, rrd)


def _replay(request: Request, parameters: Mapping[str, str], rrd: Optional[Path]) -> None:
    moving = bool(parameters.get("target_frame"))
    wanted = parameters.get("input", INPUTS[0])
    wanted = wanted if wanted in INPUTS else INPUTS[0]  # the node itself refuses others
    with recording(request.bags, request.topics, wanted, moving) as recorded:
        clouds = max(source.topic.count for source in recorded.sources)
        if request.around is not None and not 0 <= request.around < clouds:
            raise BagError(f"there is no cloud {request.around}: they are numbered from 0 to {clouds - 1}")
        answers = answers_to(recorded, parameters, rrd)
        title = f"{', '.join(bag.name for bag in request.bags)}  {', '.join(recorded.topics)}"
        end = recorded.end
    settings = settings_of(_known(parameters))
    silent = silences(answers, end, settings.source_timeout)
    print_table(answers, title, silent, request.around)
    if request.json:
        write_json(answers, request.json)
    if request.plot:
        from safety_control_cloud.replay.plot import write_plot  # matplotlib takes half a second to load

        write_plot(answers, request.plot, title, settings, silent)


def answers_to(recorded: Recording, parameters: Mapping[str, str], rrd: Optional[Path] = None) -> List[Answer]:
    clouds = with_progress(recorded.clouds, recorded.count)
    with safety_nodes(parameters, recorded.sources) as nodes:
        if not rrd:
            return [nodes.answer_to(cloud) for cloud in clouds]
        with shown_in(rrd, settings_of(_known(parameters)), recorded.topics) as show:
            answers = []
            for cloud in clouds:
                answers.append(nodes.answer_to(cloud))
                show(cloud, answers[-1], nodes.remembered(cloud.topic))
            return answers


def _known(parameters: Mapping[str, str]) -> Dict[str, str]:
    """The node has accepted them all; those that are no settings are of its transport."""
    return {name: value for name, value in parameters.items() if name in core.Settings().as_dict()}
