# SPDX-License-Identifier: BSD-3-Clause
"""Two drives of every family with the compiled decision, on seeds that never change."""
from __future__ import annotations

import pytest

from safety_control_cloud.trials.deciders import Tutorial
from safety_control_cloud.trials.families import FAMILIES, WITH_FAULTS, scenario_of
from safety_control_cloud.trials.outcome import Outcome
from safety_control_cloud.trials.run import Job, drive, drive_all, jobs_for
from safety_control_cloud.trials.scenario import XTION
from safety_control_cloud.trials.summary import is_collision

pytest.importorskip("safety_control_cloud.core")

DRIVES, FIRST_SEED = 2, 1


@pytest.fixture(scope="module")
def outcomes() -> dict[str, list[Outcome]]:
    jobs = jobs_for(DRIVES * len(FAMILIES), FIRST_SEED, ["ours"])
    driven = drive_all(jobs, workers=2)
    return {family: [one for one in driven if one.family == family] for family in FAMILIES}


@pytest.mark.slow
@pytest.mark.parametrize("family", FAMILIES)
def test_the_robot_runs_into_nothing_that_its_camera_could_have_shown(family, outcomes):
    assert len(outcomes[family]) == DRIVES
    assert [f"{one.name} with {one.collision.thing}" for one in outcomes[family] if is_collision(one)] == []


@pytest.mark.slow
def test_the_robot_seldom_stands_before_free_ground(outcomes):
    sound = [one for family in FAMILIES if family not in WITH_FAULTS for one in outcomes[family]]
    assert len([one.name for one in sound if one.stuck]) <= 0.03 * len(sound)


@pytest.mark.slow
@pytest.mark.parametrize("family", [family for family in FAMILIES if family not in WITH_FAULTS])
def test_no_family_is_one_in_which_the_robot_stands_for_ever(family, outcomes):
    """All of one family's drives are fewer than 3 % of all."""
    assert [one.name for one in outcomes[family] if one.stuck] == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", [900, 910, 1700])
def test_the_robot_goes_on_when_a_post_that_crossed_a_hall_at_the_end_of_its_memory_has_gone(seed):
    outcome = drive(Job("slides_out_again", seed, "ours"))
    assert not outcome.stuck and outcome.false_stop is None and outcome.collision is None


@pytest.mark.slow
def test_the_robot_stands_for_a_post_at_the_border_of_its_first_picture_that_is_too_near_to_return():
    assert drive(Job("turned_onto_a_near_post", 1702, "ours")).collision is None


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_the_robot_stands_before_a_kerb_that_lies_below_the_tutorials_corridor(seed):
    assert drive(Job("kerb", seed, "tutorial")).collision
    for family in ("kerb", "kerb_in_a_lower_corridor"):
        ours = drive(Job(family, seed, "ours"))
        assert ours.collision is None and ours.false_stop is None and ours.clearance > 0.3, family


@pytest.mark.slow
def test_the_robot_stands_for_who_walks_up_into_its_blind_zone():
    for seed in range(1, 6):
        outcome = drive(Job("person_walks_up", seed, "ours"))
        assert outcome.collision is None and not outcome.stuck, outcome.name


@pytest.mark.parametrize("family", FAMILIES)
def test_a_seed_draws_one_scenario_and_another_seed_another(family):
    assert scenario_of(family, 7) == scenario_of(family, 7)
    assert scenario_of(family, 7).things != scenario_of(family, 8).things


@pytest.mark.parametrize("family", FAMILIES)
def test_things_have_names_of_their_own(family):
    names = [thing.name for thing in scenario_of(family, 3).things]
    assert len(names) == len(set(names))


def test_the_same_seeds_give_the_same_drives_on_any_number_of_processes():
    jobs = [Job("wall_in_the_blind_zone", 1, "ours"), Job("camera_dies", 1, "tutorial"), Job("person_walks_up", 2, "ours")]
    alone = drive_all(jobs, workers=1)
    assert alone == drive_all(jobs, workers=3) == [drive(job) for job in jobs]
    assert [(one.family, one.seed, one.method) for one in alone] == [(job.family, job.seed, job.method) for job in jobs]


def test_the_episodes_are_shared_out_evenly():
    jobs = jobs_for(5, 10, ["tutorial", "ours"], ["wall", "post"])
    assert [job.seed for job in jobs if job.method == "ours"] == [10, 10, 11, 11, 12]
    assert len(jobs) == 10


def test_the_tutorial_drives_into_a_post_in_its_blind_zone_and_this_node_does_not():
    tutorial, ours = (drive(Job("post_in_the_blind_zone", 4, method)) for method in ("tutorial", "ours"))
    assert is_collision(tutorial) and not is_collision(ours)


def test_the_tutorial_reads_an_empty_cloud_as_safe():
    import numpy as np

    nothing = np.full((XTION.height, XTION.width), np.nan, np.float32)
    assert Tutorial().decide(nothing, 0.0, 0.0).speed == 0.2
