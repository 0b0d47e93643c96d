# SPDX-License-Identifier: BSD-3-Clause
"""From bags to what the guard would have given."""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, Mapping, Optional

from safety_control_cloud.replay.bags import Bags, opened
from safety_control_cloud.replay.guard.inputs import Inputs, inputs_in
from safety_control_cloud.replay.guard.report import print_guarded, write_json
from safety_control_cloud.replay.guard.run import Guarded, guarded
from safety_control_cloud.replay.guard.show import shown_in
from safety_control_cloud.replay.options import Request
from safety_control_cloud.replay.parameters import BadSettings
from safety_control_cloud.view.options import recorded_in


def replay_guarded(request: Request, parameters: Mapping[str, Any]) -> None:
    """Raises parameters.BadSettings, bags.BagError, optional.MissingPackages."""
    if request.around is not None:
        raise BadSettings("--around is of mode drive")
    with recorded_in(request.rrd, request.view) as rrd:
        _replay(request, parameters, rrd)


def _replay(request: Request, parameters: Mapping[str, Any], rrd: Optional[Path]) -> None:
    with opened(request.bags) as bags:
        inputs = inputs_in(bags, parameters, request.topics, request.cmd_vel, request.odom)
        found, end = _guarded(bags, inputs, rrd), bags.end
    for warning in found.warnings:
        print(f"replay: {warning}", file=sys.stderr)
    title = f"{', '.join(bag.name for bag in request.bags)}  {_told(inputs)}"
    print_guarded(found, end, title)
    if request.json:
        write_json(found, request.json)
    if request.plot:
        from safety_control_cloud.replay.guard.plot import write_plot  # matplotlib takes half a second to load

        write_plot(found, end, request.plot, title)


def _guarded(bags: Bags, inputs: Inputs, rrd: Optional[Path]) -> Guarded:
    if not rrd:
        return guarded(bags, inputs)
    with shown_in(rrd, inputs) as show:
        return guarded(bags, inputs, show)


def _told(inputs: Inputs) -> str:
    frame = inputs.settings.odom_frame
    odometry = inputs.odometry.name if inputs.odometry else f"{frame} by TF" if frame else "no odometry"
    switches = dict.fromkeys(switch.topic.name for switch in inputs.switches)
    return ", ".join([inputs.commands.name, odometry, *switches, *(source.topic.name for source in inputs.sensors)])
