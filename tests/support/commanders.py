# SPDX-License-Identifier: BSD-3-Clause
"""Others that command the robot: started, and what is heard of them."""
import sys
from contextlib import contextmanager
from pathlib import Path

from robot import AGAIN, GRACE, after

from safety_control_cloud.processes import process

COMMANDER = Path(__file__).with_name("commander.py")
NOTICED = 0.2 + GRACE  # [s]
ITS_END = 1.0 + AGAIN  # [s] of silence until it counts as gone, and until the robot drives


@contextmanager
def commander(speed, rate, *arguments, name="teleop"):
    with process([sys.executable, str(COMMANDER), str(speed), str(rate), *arguments, f"__name:={name}"]) as running:
        yield running


def is_of(name):
    return lambda command: command._connection_header["callerid"] == name


def mean_speed(commands, since):
    """Of a base that obeys the latest command [m/s]."""
    heard = [(arrival, command.linear.x) for arrival, command in commands.timed() if arrival >= since]
    driven = sum((later - arrival) * speed for (arrival, speed), (later, _) in zip(heard, heard[1:]))
    return driven / (heard[-1][0] - heard[0][0])


def first(heard, fits, since):
    heard.until(lambda message: any(fits(later) for _, later in after(since, heard)))
    return next(arrival for arrival, message in after(since, heard) if fits(message))


def is_doubted(state):
    return state.cause_text == "TWO_COMMANDERS" and state.speed == 0.0
