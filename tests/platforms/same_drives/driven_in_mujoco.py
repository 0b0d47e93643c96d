# SPDX-License-Identifier: BSD-3-Clause
"""A drive by the trials' own stage and loop, with what Gazebo has not taken out of them."""
from __future__ import annotations

from dataclasses import replace
from math import nan

from driven import AT_REST, Driven, Moment, last_moved
from drawn_drives import scene_of

from safety_control_cloud.simulation.hull import distances
from safety_control_cloud.trials.deciders import decider_for
from safety_control_cloud.trials.episode import moments
from safety_control_cloud.trials.scenario import Scenario
from safety_control_cloud.trials.stage import Stage


def drive(scenario: Scenario, latency: float) -> Driven:
    """`latency` [s] from a picture to the wheels."""
    stage = Stage(scenario)
    try:
        stage.robot.reset(None)  # neither noise nor rocking
        return _drive(replace(scenario, transport=latency, processing=0.0), stage)
    finally:
        stage.close()


def _drive(scenario: Scenario, stage: Stage) -> Driven:
    first, scene, track, clearance = stage.robot.depth(), scene_of(scenario), [], []
    for moment in moments(scenario, stage, decider_for("ours", scenario)):
        track.append(Moment(moment.time, moment.pose, moment.speed))
        clearance.append(min(distance for _, distance in distances((scene,), moment.pose)))
        cause = moment.verdict.cause
        if moment.time - last_moved(track) > AT_REST:
            break
    return Driven(tuple(track), min(clearance), cause, nan, first, stage.robot.depth())
