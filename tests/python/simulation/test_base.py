# SPDX-License-Identifier: BSD-3-Clause
from math import degrees, hypot, inf, nan, pi

import pytest

from safety_control_cloud.simulation.base import (
    DRIVER, INSTANT, TOP_SPEED, Base, Pose, Velocity, moved, obeyed, pitch_at, wheel_speeds, within_wheels,
)

DT = 0.01


def run(base: Base, start: float, seconds: float) -> float:
    """Let the base drive freely and return the time [s] at which that ends."""
    for tick in range(1, round(seconds / DT) + 1):
        base.pose = base.next_pose(start + tick * DT, DT)
    return start + seconds


def test_the_base_stops_by_itself_0_6_s_after_the_last_command():
    base = Base(INSTANT)
    base.command(Velocity(0.2), 0.0)
    run(base, 0.0, 2.0)
    assert base.pose.x == pytest.approx(0.2 * 0.6, abs=0.2 * DT)


def test_the_base_drives_on_while_commands_keep_coming():
    base = Base(INSTANT)
    now = 0.0
    for _ in range(10):
        base.command(Velocity(0.2), now)
        now = run(base, now, 0.5)
    assert base.pose.x == pytest.approx(0.2 * 5.0)


def test_the_drivers_limits_let_the_robot_gain_0_3_and_lose_0_36_m_per_s_each_second():
    assert obeyed(Velocity(), Velocity(0.7), DRIVER, 1.0).linear == pytest.approx(0.3)
    assert obeyed(Velocity(0.7), Velocity(), DRIVER, 1.0).linear == pytest.approx(0.34)
    assert obeyed(Velocity(-0.7), Velocity(), DRIVER, 1.0).linear == pytest.approx(-0.34)


def test_turning_round_begins_with_braking():
    assert obeyed(Velocity(0.5), Velocity(-0.7), DRIVER, 1.0).linear == pytest.approx(0.14)


def test_the_drivers_limits_let_the_robot_turn_3_5_rad_per_s_faster_each_second():
    assert obeyed(Velocity(), Velocity(0, 3), DRIVER, 0.1).angular == pytest.approx(0.35)


def test_from_0_2_m_per_s_the_driver_needs_56_mm_to_stand():
    base = Base(DRIVER)
    base.command(Velocity(0.2), 0.0)
    now = run(base, 0.0, 0.6)
    base.command(Velocity(0.2), now)
    now = run(base, now, 0.5)
    before = base.pose.x
    base.command(Velocity(), now)
    run(base, now, 2.0)
    assert base.velocity == Velocity()
    assert base.pose.x - before == pytest.approx(0.2**2 / (2 * 0.36), abs=0.002)


def test_instant_wheels_obey_at_once():
    assert obeyed(Velocity(0.2), Velocity(), INSTANT, DT) == Velocity()


def test_the_wheels_of_a_turning_robot_differ_by_its_turn_times_their_separation():
    left, right = wheel_speeds(Velocity(0.2, 1.0))
    assert (left, right) == pytest.approx((0.2 - 0.115, 0.2 + 0.115))


@pytest.mark.parametrize("asked", [Velocity(3, 0), Velocity(-3, 0), Velocity(0.6, 4), Velocity(0, 20)])
def test_no_wheel_turns_faster_than_0_7_m_per_s_and_the_curve_stays_the_same(asked):
    given = within_wheels(asked)
    assert max(map(abs, wheel_speeds(given))) == pytest.approx(TOP_SPEED)
    assert given.linear * asked.angular == pytest.approx(given.angular * asked.linear)


@pytest.mark.parametrize("asked", [Velocity(nan, 0), Velocity(0.2, nan), Velocity(inf, 0), Velocity(0, -inf)])
def test_a_command_that_is_no_number_means_stand(asked):
    assert within_wheels(asked) == Velocity()


def test_a_quarter_circle_ends_a_radius_ahead_and_a_radius_to_the_left():
    end = moved(Pose(), Velocity(0.5, 0.5), pi)
    assert (end.x, end.y, end.yaw) == pytest.approx((1.0, 1.0, pi / 2))


def test_on_the_spot_a_turn_to_the_left_rolls_the_left_wheel_back_and_the_right_one_ahead():
    base = Base(INSTANT)
    base.command(Velocity(0, 1.0), 0.0)
    run(base, 0.0, 0.5)
    assert base.rolled == pytest.approx((-0.0575, 0.0575))


def test_many_small_steps_and_one_long_step_lead_to_the_same_place():
    pose, velocity = Pose(1, 2, 3), Velocity(0.3, -0.8)
    small = pose
    for _ in range(1000):
        small = moved(small, velocity, 0.005)
    long = moved(pose, velocity, 5.0)
    assert hypot(small.x - long.x, small.y - long.y) < 1e-9
    assert small.yaw == pytest.approx(long.yaw)


def test_a_standing_robot_rests_0_46_degrees_nose_up():
    assert degrees(pitch_at(0.0, 12.3)) == pytest.approx(-0.46)


def test_a_driving_robot_rocks_within_the_range_measured_in_gazebo():
    pitches = [degrees(pitch_at(0.2, turn / 100)) for turn in range(1000)]
    assert (min(pitches), max(pitches)) == pytest.approx((-0.73, -0.20), abs=0.01)


def test_a_robot_put_down_elsewhere_has_forgotten_its_command():
    base = Base(INSTANT)
    base.command(Velocity(0.2), 0.0)
    base.stand_at(Pose(5, 5, 0))
    run(base, 0.0, 0.5)
    assert base.pose == Pose(5, 5, 0)
