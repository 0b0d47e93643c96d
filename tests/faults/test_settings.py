# SPDX-License-Identifier: BSD-3-Clause
"""Settings that are unfit to drive with, sent to the running node: refused whole, and the robot goes on as before."""
import math

import pytest
from dynamic_reconfigure.client import Client
from robot import NODE, driving_robot
from scenes import hall, wall


@pytest.fixture(scope="module")
def robot(master):
    with driving_robot() as robot:
        yield robot


@pytest.fixture
def settings(robot):
    client = Client(NODE, timeout=10.0)
    yield client
    client.close()


@pytest.mark.parametrize(
    "unfit, reason",
    [
        pytest.param(dict(danger_distance=math.nan), "danger_distance must be finite", id="nan"),
        pytest.param(dict(x_max=math.nan), "x_max must be finite", id="nan_limit"),
        pytest.param(dict(warning_distance=math.inf), "warning_distance must be finite", id="infinite"),
        pytest.param(dict(danger_distance=-0.5), "danger_distance must be positive", id="negative"),
        pytest.param(dict(safe_speed=-0.2), "safe_speed must not be less than warning_speed", id="backwards"),
        pytest.param(dict(min_points=-1), "min_points must not be negative", id="negative_count"),
        pytest.param(dict(source_timeout=0.0), "source_timeout must be positive", id="never_silent"),
        pytest.param(dict(publish_rate=0.0), "publish_rate must lie between", id="never_published"),
        pytest.param(dict(source_timeout=3600.0), "source_timeout must be at most 10", id="hardly_ever_silent"),
        pytest.param(dict(min_points=2147483647), "min_points must be at most 1000", id="nothing_is_an_obstacle"),
        pytest.param(dict(safe_speed=5.0), "safe_speed must be at most 1.5", id="too_fast"),
        pytest.param(
            dict(danger_distance=1.0, warning_distance=0.5), "warning_distance must be more than danger_distance",
            id="swapped_zones"),
        pytest.param(dict(x_min=0.3, x_max=-0.3), "x_min must be less than x_max", id="swapped_corridor"),
    ],
)
def test_unfit_settings_are_refused_whole_and_the_robot_goes_on_as_before(robot, settings, unfit, reason):
    in_force = settings.get_configuration(timeout=5.0)

    answer = settings.update_configuration({**unfit, "warning_speed": 0.15})

    assert reason in answer["refusal"]
    numbers = [name for name, value in in_force.items() if isinstance(value, (int, float))]
    assert [answer[name] for name in numbers] == [in_force[name] for name in numbers]
    robot.camera.show(hall(wall(0.8)))
    robot.drives(0.1)
    robot.camera.show(hall(wall(0.45)))
    robot.stops("SEEN")
    robot.camera.show(hall())
    robot.drives()


def test_fit_settings_hold_from_the_next_cloud_on_and_the_refusal_is_gone(robot, settings):
    settings.update_configuration({"danger_distance": math.nan})
    answer = settings.update_configuration({"warning_distance": 0.7, "danger_distance": 0.6})
    assert (answer["refusal"], answer["danger_distance"]) == ("", 0.6)
    robot.camera.show(hall(wall(0.8)))
    robot.drives()
    robot.camera.show(hall(wall(0.55)))
    robot.stops("SEEN")
