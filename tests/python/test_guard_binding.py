# SPDX-License-Identifier: BSD-3-Clause
"""The guard from Python: what C++'s tests show of it, and that no number is lost on the way."""
import numpy as np
import pytest

from safety_control_cloud import core

CAMERA = np.array([[0, 0, 1, -0.087], [-1, 0, 0, 0], [0, -1, 0, 0.2972]], np.float64)  # a TurtleBot's, in base_footprint
GUARD = core.Settings(mode="guard")


def wall_at(distance: float) -> np.ndarray:
    """(H, W, 3) float32: a wall across the whole view, `distance` [m] ahead of the camera; the floor below it."""
    across, down = np.meshgrid(np.linspace(-0.57, 0.57, 64), np.linspace(-0.43, 0.43, 48))
    depth = np.minimum(distance, np.where(down > 0, 0.2972 / np.maximum(down, 1e-6), np.inf))
    return np.stack([across * depth, down * depth, depth], axis=-1).astype(np.float32)


def drives_at(control: core.GuardControl, distance: float, linear, angular, begins: float = 0.0) -> core.Guarded:
    """As somebody says it again and again before a wall."""
    for tick in range(10):
        now = begins + 0.05 * tick
        control.see(wall_at(distance), now=now, ros_now=1000.0 + now, camera=CAMERA)
        control.want(linear, angular, now=now)
        said = control.answer(now=now, ros_now=1000.0 + now)
    return said


def test_a_safe_command_passes_equal_in_every_bit():
    linear, angular = [0.1 + 0.2, -0.0, 1e-300], [-0.0, 5e-324, 0.1 / 3.0]
    said = drives_at(core.GuardControl(GUARD), 3.0, linear, angular)
    for given, wanted in ((said.given.linear, linear), (said.given.angular, angular)):
        assert np.array(given).tobytes() == np.array(wanted).tobytes()
    assert (said.factor, said.cause, said.stuck_since, said.point, said.sensor) == (1.0, core.Cause.SEEN, None, None, "")


def test_before_a_wall_it_is_scaled_as_a_whole_and_says_by_what():
    said = drives_at(core.GuardControl(GUARD), 0.7, (0.6, 0, 0), (0, 0, 0.3))
    assert 0 < said.factor < 1
    assert said.given.linear[0] == pytest.approx(0.6 * said.factor) and said.given.angular[2] == pytest.approx(0.3 * said.factor)
    assert said.point[0] == pytest.approx(0.613, abs=0.05) and said.sensor == "cloud" and said.time_to_contact > 0
    assert repr(said).startswith("Guarded(factor=0.") and "cause=SEEN, point=(0.6" in repr(said)


def test_what_was_answered_does_not_change_with_the_next_answer():
    control = core.GuardControl(GUARD)
    before = drives_at(control, 0.7, (0.6, 0, 0), (0, 0, 0))
    factor, after = before.factor, drives_at(control, 3.0, (0.1, 0, 0), (0, 0, 0), begins=0.5)
    assert after.factor != factor == before.factor


def test_nobody_drives_before_a_cloud_and_it_says_since_when():
    control = core.GuardControl(GUARD)
    control.want((0.2, 0, 0), (0, 0, 0), now=7.0)
    said = control.answer(now=7.0)
    assert (said.factor, said.cause.name, said.stuck_since, said.open) == (0.0, "NO_CLOUD", 7.0, 0)


def test_odometry_tells_how_far_an_old_cloud_is_behind():
    def after(moves: float) -> float:
        control = core.GuardControl(GUARD)
        drives_at(control, 0.72, (0.4, 0, 0), (0, 0, 0))
        for tick in range(30):
            now = 0.3 + 0.01 * tick
            control.note_odometry(1000.0 + now, (moves * max(0.0, now - 0.45), 0, 0), (moves, 0, 0))
        control.want((0.4, 0, 0), (0, 0, 0), now=0.58)
        return control.answer(now=0.58, ros_now=1000.58).factor

    assert after(0.6) < after(0.0)


def test_settings_that_are_unfit_for_a_guard_are_refused_and_others_adopted():
    with pytest.raises(ValueError, match="footprint"):
        core.GuardControl(core.Settings(mode="guard", footprint="[[0, 0]]"))
    control = core.GuardControl(GUARD)
    with pytest.raises(ValueError, match="max_speed"):
        control.adopt(core.Settings(mode="guard", max_speed=0.0))
    control.adopt(core.Settings(mode="guard", max_speed=0.1))
    assert drives_at(control, 3.0, (0.4, 0, 0), (0, 0, 0)).given.linear[0] == pytest.approx(0.1)


def test_doubt_from_outside_an_override_and_what_is_remembered():
    control = core.GuardControl(core.Settings(mode="guard", override_max=5.0))
    drives_at(control, 3.0, (0.2, 0, 0), (0, 0, 0))
    control.note_outside(core.Cause.TWO_COMMANDERS, "somebody else")
    assert control.answer(now=0.46, ros_now=1000.46).cause.name == "TWO_COMMANDERS"
    control.note_outside(None)
    assert control.answer(now=0.47, ros_now=1000.47).factor == 1.0
    assert control.ask_override(9.0, 0.1, now=0.5, ros_now=1000.5)[0] is False
    granted, words = control.ask_override(2.0, 0.05, now=0.5, ros_now=1000.5)
    assert granted and "2" in words
    said = control.answer(now=0.6, ros_now=1000.6)
    assert said.override_left == pytest.approx(1.9) and said.given.linear[0] == pytest.approx(0.05)
    assert control.recall(control.remembered()) and not control.recall(["no memory", "of mine"])
    control.forget_losses()


def test_a_stamped_command_that_is_old_is_not_obeyed():
    control = core.GuardControl(core.Settings(mode="guard", command_type="twist_stamped"))
    drives_at(control, 3.0, (0.2, 0, 0), (0, 0, 0))
    control.want((0.2, 0, 0), (0, 0, 0), now=0.5, stamp=1000.0, ros_now=1000.5)
    assert control.answer(now=0.5, ros_now=1000.5).cause.name == "BAD_COMMAND"


def test_a_wish_is_three_and_three_numbers():
    with pytest.raises(TypeError):
        core.GuardControl(GUARD).want((0.2, 0), (0, 0, 0), now=0.0)
    assert core.Command((0.1, 0, 0)).angular == [0, 0, 0]


SENSORS = [{"name": "front", "type": "cloud", "topic": "points"}, {"name": "laser", "type": "scan", "topic": "scan"}]
LASER = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.2]], np.float64)
TURN = (-np.pi, np.pi - np.pi / 180, np.pi / 180)  # from, to, step


def scan_of(behind: float, **claims: float) -> core.Cloud:
    """Of a round hall with a post behind."""
    ranges = np.full(360, 4.0, np.float32)
    ranges[:5] = behind
    return core.Cloud.of_scan(ranges, *TURN, **{"range_min": 0.1, "range_max": 10.0, "scan_time": 0.1, **claims})


def test_a_laser_among_several_sensors_is_seen_by_its_number():
    control = core.GuardControl(core.Settings(mode="guard", sensors=SENSORS))
    for behind, expected in ((4.0, (1.0, "")), (0.22, (0.0, "laser"))):
        for tick in range(10):
            now = 0.05 * tick + (behind < 1.0)
            control.see(wall_at(3.0 + 1e-3 * tick), now=now, ros_now=1000.0 + now, camera=CAMERA)
            control.see(scan_of(behind + 1e-3 * tick), now=now, ros_now=1000.0 + now, camera=LASER, sensor=1)
            control.want((-0.3, 0, 0), (0, 0, 0), now=now)
            said = control.answer(now=now, ros_now=1000.0 + now)
        assert (said.factor, said.sensor, said.cause.name) == (*expected, "SEEN")
    assert control.until_silent(now + 0.1) == pytest.approx(core.Settings().source_timeout - 0.1)
    with pytest.raises(IndexError):
        control.see(scan_of(4.0), now=3.0, camera=LASER, sensor=2)


@pytest.mark.parametrize("claims, reason", [
    ({"range_min": 10.0, "range_max": 0.1}, "range_min 10 and range_max 0.1"), ({"scan_time": 60.0}, "scan_time 60 s"),
    ({"range_max": np.nan}, "range_min 0.1 and range_max nan")])
def test_a_scan_that_contradicts_itself_is_unreadable_as_in_the_node(claims, reason):
    assert scan_of(4.0, **claims).unreadable == reason
    assert scan_of(4.0).unreadable is None


def test_a_scan_outlives_its_ranges_and_has_one_row():
    held = [core.Cloud.of_scan(np.full(360, 1.0 + n, np.float32), *TURN, 0.1, 10.0) for n in range(50)]
    assert [cloud.unreadable for cloud in held] == [None] * 50
    assert core.Cloud.of_scan(np.zeros(0, np.float32), *TURN, 0.1, 10.0).unreadable == "a scan of 0 ranges"
    with pytest.raises(ValueError):
        core.Cloud.of_scan(np.zeros((2, 180), np.float32), *TURN, 0.1, 10.0)
