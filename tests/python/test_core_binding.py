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


def test_bytes_that_are_looked_at_cannot_be_moved_away():
    data = bytearray(np.array([[0, 0, 2]], np.float32).tobytes())
    cloud = core.Cloud.of_bytes(data, 1, 1, [("x", 0, 7, 1), ("y", 4, 7, 1), ("z", 8, 7, 1)], False, 12, 12)
    with pytest.raises(BufferError):
        data.extend(bytes(1 << 20))
    assert core.look(cloud).returns == 1


def test_a_parameter_that_does_not_exist_is_no_setting():
    with pytest.raises(AttributeError, match="danger_distanse"):
        core.Settings(danger_distanse=0.6)
    with pytest.raises(AttributeError):
        core.Settings().danger_distanse = 0.6


@pytest.mark.parametrize(
    "name, value, kind",
    [("danger_distance", "x", "a number"), ("min_points", 1.5, "a whole number"), ("min_points", -1, "a whole number"),
     ("x_min", None, "a number"), ("target_frame", 3, "a name")])
def test_a_value_of_another_kind_is_refused_by_the_parameters_name(name, value, kind):
    with pytest.raises(TypeError, match=f"{name} must be {kind}"):
        core.Settings(**{name: value})
    with pytest.raises(TypeError, match=f"{name} must be {kind}"):
        setattr(core.Settings(), name, value)


@pytest.mark.parametrize("name, value", [("method", "fast"), ("method", 3), ("input", None)])
def test_a_choice_that_does_not_exist_is_refused_by_the_parameters_name(name, value):
    with pytest.raises(ValueError, match=f"{name} must be"):
        core.Settings(**{name: value})


def test_unfit_settings_are_refused_with_every_problem():
    unfit = core.Settings(x_min=1.0, publish_rate=0.0)
    assert len(unfit.problems()) == 2
    with pytest.raises(ValueError, match="x_min must be less.*publish_rate"):
        core.SafetyControl(unfit)


IN_FRAME = core.Settings(target_frame="base_footprint")
# A camera 0.3 m above the frame's origin that looks along its x axis.
CAMERA = np.array([[0, 0, 1, 0], [-1, 0, 0, 0], [0, -1, 0, 0.3]], np.float64)


def test_a_corridor_in_a_frame_is_judged_there_or_not_at_all():
    """0.2 m below the optical axis, 0.45 m ahead: 10 cm above the floor, inside the corridor of the frame alone."""
    cloud = np.array([[0, 0.24, 0.45], [2, 0, 3]], np.float32)
    unplaced = core.SafetyControl(IN_FRAME).decide(cloud, now=0.0)
    assert (unplaced.cause, unplaced.speed) == (core.Cause.NO_TRANSFORM, 0.0)
    assert "base_footprint" in unplaced.reason
    placed = core.SafetyControl(IN_FRAME).decide(cloud, now=0.0, camera=CAMERA)
    assert (placed.cause, placed.zone) == (core.Cause.SEEN, core.Zone.DANGER)
    assert placed.nearest.point == pytest.approx((0, -0.06, 0.45))
    in_no_frame = core.SafetyControl().decide(cloud, now=0.0, camera=CAMERA)
    assert in_no_frame.cause == core.Cause.NO_TRANSFORM


@pytest.mark.parametrize("look", [core.look, core.passthrough])
def test_looking_down_a_corridor_in_a_frame_needs_the_cameras_place(look):
    cloud = np.array([[0, 0.24, 0.45]], np.float32)
    assert look(cloud, IN_FRAME, camera=CAMERA).inside == 1
    assert look(cloud).inside == 0
    with pytest.raises(ValueError, match="base_footprint"):
        look(cloud, IN_FRAME)
    with pytest.raises(ValueError, match="shape"):
        look(cloud, IN_FRAME, camera=CAMERA[:2])


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


def test_what_the_stub_says_is_told_at_run_time_too():
    assert "taken for `now`" in core.SafetyControl.__doc__
    assert "The decision for a cloud that has just arrived" in core.SafetyControl.decide.__doc__
    assert "sensor_msgs/PointCloud2" in core.Cloud.of_bytes.__doc__ and "One pass over the bytes" in core.look.__doc__
    assert core.Decision.speed.__doc__ == "[m/s] forward" and "DANGER 0" in core.Zone.__doc__


def test_results_can_be_read_where_they_are_printed():
    assert repr(core.SafetyControl().without_cloud(1.0)) == (
        "Decision(zone=Danger, speed=0, cause=NO_CLOUD, nearest=None, reason='no cloud has arrived yet')")
    seen = core.look(np.array([[0.0, 0.0, 0.75]], dtype=np.float32))
    assert repr(seen) == (
        "Sight(nearest=Obstacle(distance=0.750, point=(0.000, 0.000, 0.750)), inside=1, too_close=0, returns=1, total=1)")


def test_a_value_of_another_type_is_refused_by_its_parameters_name():
    with pytest.raises(TypeError, match="danger_distance must be a number"):
        core.Settings(danger_distance="x")


def test_a_speed_beyond_every_bound_is_a_problem():
    assert core.Settings(safe_speed=5.0).problems() == ["safe_speed must be at most 1.5"]
