# SPDX-License-Identifier: BSD-3-Clause
"""The Kobuki as a differential drive: from commanded velocities to the way it goes over the floor."""
from __future__ import annotations

from dataclasses import dataclass
from math import cos, inf, isfinite, pi, radians, sin

COMMAND_TIMEOUT = 0.6  # [s] without a command, then the base stops by itself (kobuki_node's cmd_vel_timeout)
TOP_SPEED = 0.7  # [m/s] of either wheel over the floor
WHEEL_SEPARATION = 0.230  # [m]
WHEEL_RADIUS = 0.035  # [m]

RESTING_PITCH = -radians(0.46)  # [rad] about y of base_footprint, nose up; measured in Gazebo 11
ROCKING = radians(0.265)  # [rad] to either side while driving: -0.73 .. -0.20 deg in Gazebo 11
ROCKING_FULL_AT = 0.1  # [m/s]


@dataclass(frozen=True)
class Velocity:
    linear: float = 0.0  # [m/s] along x of base_footprint
    angular: float = 0.0  # [rad/s] about its z

    @property
    def is_finite(self) -> bool:
        return isfinite(self.linear) and isfinite(self.angular)


@dataclass(frozen=True)
class Pose:
    """Of base_footprint in odom, which is the world's frame here."""

    x: float = 0.0  # [m]
    y: float = 0.0  # [m]
    yaw: float = 0.0  # [rad]


@dataclass(frozen=True)
class Limits:
    """What the motor driver allows; a speed nearer to zero, or of the other sign, counts as braking."""

    acceleration: float  # [m/s2]
    deceleration: float  # [m/s2]
    angular: float  # [rad/s2]


DRIVER = Limits(acceleration=0.3, deceleration=0.36, angular=3.5)
INSTANT = Limits(acceleration=inf, deceleration=inf, angular=inf)  # Gazebo's wheels
LIMITS = {"driver": DRIVER, "instant": INSTANT}


def stepped(current: float, target: float, most: float) -> float:
    """`target`, or as far towards it as a change of `most` leads."""
    return target if abs(target - current) <= most else current + (most if target > current else -most)


def obeyed(current: Velocity, target: Velocity, limits: Limits, dt: float) -> Velocity:
    """The velocity `dt` [s] later, on the way from `current` to `target`."""
    braking = abs(target.linear) < abs(current.linear) or target.linear * current.linear < 0
    rate = limits.deceleration if braking else limits.acceleration
    return Velocity(
        stepped(current.linear, target.linear, rate * dt),
        stepped(current.angular, target.angular, limits.angular * dt),
    )


def wheel_speeds(velocity: Velocity) -> tuple[float, float]:
    """[m/s] of the left and the right wheel over the floor."""
    half = velocity.angular * WHEEL_SEPARATION / 2
    return velocity.linear - half, velocity.linear + half


def within_wheels(velocity: Velocity) -> Velocity:
    """The same curve, no wheel above TOP_SPEED; not a number means stand."""
    if not velocity.is_finite:
        return Velocity()
    fastest = max(abs(speed) for speed in wheel_speeds(velocity))
    if fastest <= TOP_SPEED:
        return velocity
    return Velocity(velocity.linear * TOP_SPEED / fastest, velocity.angular * TOP_SPEED / fastest)


def moved(pose: Pose, velocity: Velocity, dt: float) -> Pose:
    """After `dt` [s] along the arc of `velocity`; exact, however long the step."""
    turn = velocity.angular * dt
    chord = velocity.linear * dt * (sin(turn / 2) / (turn / 2) if abs(turn) > 1e-9 else 1.0)
    heading = pose.yaw + turn / 2
    return Pose(
        pose.x + chord * cos(heading),
        pose.y + chord * sin(heading),
        (pose.yaw + turn + pi) % (2 * pi) - pi,
    )


def pitch_at(speed: float, phase: float) -> float:
    """[rad] The casters let the body rock while it drives; TF does not know, the camera does.

    Gazebo gave the range only; that it rocks once per turn of the wheels, of which `phase` [rad] tells, is assumed.
    """
    return RESTING_PITCH + ROCKING * min(1.0, abs(speed) / ROCKING_FULL_AT) * sin(phase)


class Base:
    """Remembers the last command and obeys it for COMMAND_TIMEOUT. Time is an argument [s]."""

    def __init__(self, limits: Limits = DRIVER, pose: Pose = Pose()) -> None:
        self.limits = limits
        self.stand_at(pose)

    def stand_at(self, pose: Pose) -> None:
        """Put down at `pose` at rest, with no command."""
        self.pose = pose
        self.velocity = Velocity()  # of the wheels
        self.rolled = (0.0, 0.0)  # [m] the left and the right wheel
        self.commanded = Velocity()
        self._commanded_at = -inf

    def command(self, velocity: Velocity, now: float) -> None:
        self.commanded = within_wheels(velocity)
        self._commanded_at = now

    @property
    def pitch_phase(self) -> float:
        """[rad] The mean turn of the wheels."""
        return sum(self.rolled) / 2 / WHEEL_RADIUS

    def next_pose(self, now: float, dt: float) -> Pose:
        """Turn the wheels for `dt` up to `now` and say where they lead; the caller sets `pose`: walls may forbid it."""
        target = self.commanded if now - self._commanded_at <= COMMAND_TIMEOUT else Velocity()
        self.velocity = obeyed(self.velocity, target, self.limits, dt)
        left, right = wheel_speeds(self.velocity)
        self.rolled = (self.rolled[0] + left * dt, self.rolled[1] + right * dt)
        return moved(self.pose, self.velocity, dt)
