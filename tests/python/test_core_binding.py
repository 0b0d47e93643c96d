# SPDX-License-Identifier: BSD-3-Clause
"""The binding hands numpy's memory to C++ as it is, or says why it cannot."""
import threading

import numpy as np
import pytest

from safety_control_cloud import core


def wall_at(distance: float, shape=(48, 64)) -> np.ndarray:
    """(H, W, 3) float32: a wall across the whole view, `distance` [m] ahead."""
    y, x = np.meshgrid(np.linspace(-0.4, 0.4, shape[0]), np.linspace(-0.5, 0.5, shape[1]), indexing="ij")
    return np.stack([x, y, np.full(shape, distance)], axis=-1).astype(np.float32)


@pytest.mark.parametrize("distance, zone, speed", [(1.5, "SAFE", 0.2), (0.8, "WARNING", 0.1), (0.4, "DANGER", 0.0)])
def test_a_wall_ahead_gives_its_zone_and_speed(distance, zone, speed):
    decision = core.SafetyControl().decide(wall_at(distance), now=0.0)
    assert (decision.zone.name, decision.speed, decision.cause) == (zone, speed, core.Cause.SEEN)


def test_organised_and_unorganised_points_are_the_same_points():
    wall = wall_at(0.7)
    assert core.look(wall).inside == core.look(wall.reshape(-1, 3)).inside > 0


@pytest.mark.parametrize(
    "part",
    [
        lambda a: a[::2],
        lambda a: a[:, ::3],
        lambda a: a[5:7, 11:13],
        lambda a: np.asfortranarray(a),
        lambda a: np.moveaxis(np.ascontiguousarray(np.moveaxis(a, -1, 0)), 0, -1),
        lambda a: np.concatenate([a, a], axis=-1)[..., :3],
        lambda a: a[:0],
        lambda a: np.broadcast_to(a[:1], a.shape),
    ],
    ids=["rows", "columns", "window", "fortran", "planes", "padded", "empty", "broadcast"],
)
def test_a_view_into_an_array_is_read_where_it_lies(part):
    view = part(wall_at(0.7))
    for look in (core.look, core.passthrough):
        seen, copied = look(view), look(np.ascontiguousarray(view))
        assert (seen.inside, seen.returns, seen.total) == (copied.inside, copied.returns, copied.total)


def test_points_are_not_copied():
    wall = wall_at(2.0)
    cloud = core.Cloud(wall)
    wall[20, 30, 2] = 0.3
    assert core.look(cloud).nearest.distance == pytest.approx(0.3)


def test_the_crop_outlives_the_sight_it_came_from():
    crop = core.look(wall_at(0.7), crop=True).crop
    assert crop.dtype == np.float32 and crop.shape[1] == 3 and (crop[:, 2] == np.float32(0.7)).all()


@pytest.mark.parametrize(
    "points, error",
    [
        (np.zeros((4, 3)), TypeError),
        (np.zeros((4, 3), ">f4"), TypeError),
        (np.zeros((4, 3), np.int32), TypeError),
        (np.zeros((4, 4), np.float32), ValueError),
        (np.zeros(3, np.float32), ValueError),
        (np.zeros((1, 2, 4, 3), np.float32), ValueError),
        (np.zeros((4, 3), np.float32)[::-1], ValueError),
    ],
)
def test_an_array_that_is_no_cloud_is_refused(points, error):
    with pytest.raises(error, match="points must"):
        core.SafetyControl().decide(points, now=0.0)


def test_an_unreadable_cloud_stops_the_robot_and_says_why():
    cloud = core.Cloud.of_bytes(b"\0" * 12, 1, 1, [("x", 0, 7, 1), ("y", 4, 7, 1)], False, 12, 12)
    assert cloud.unreadable == "no field z"
    decision = core.SafetyControl().decide(cloud, now=0.0)
    assert (decision.cause, decision.speed, decision.reason) == (core.Cause.UNREADABLE, 0.0, "no field z")
    with pytest.raises(ValueError, match="no field z"):
        core.look(cloud)


def test_a_parameter_that_does_not_exist_is_no_setting():
    with pytest.raises(AttributeError, match="danger_distanse"):
        core.Settings(danger_distanse=0.6)
    with pytest.raises(AttributeError):
        core.Settings().danger_distanse = 0.6


def test_unfit_settings_are_refused_with_every_problem():
    unfit = core.Settings(x_min=1.0, publish_rate=0.0)
    assert len(unfit.problems()) == 2
    with pytest.raises(ValueError, match="x_min must be less.*publish_rate"):
        core.SafetyControl(unfit)


def test_the_interpreter_runs_on_while_a_cloud_is_looked_at():
    """With the lock held, the counting thread could not count between the start and the end of one look."""
    points = np.zeros((4000, 4000, 3), np.float32)
    counted, done = 0, threading.Event()

    def look():
        core.passthrough(points)
        done.set()

    thread = threading.Thread(target=look)
    thread.start()
    while not done.is_set():
        counted += 1
    thread.join()
    assert counted > 1000
