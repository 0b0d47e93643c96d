# SPDX-License-Identifier: BSD-3-Clause
"""Stamps and clocks that are wrong."""
import threading

import pytest
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from listening import Heard
from robot import GRACE, driving_robot
from rosgraph_msgs.msg import Clock
from scenes import hall

LAST_SECOND = 2**32 - 1  # that a stamp can hold


def shifted(seconds):
    return lambda: rospy.Time.now() + rospy.Duration(seconds)


@pytest.mark.parametrize(
    "clock, cause",
    [
        pytest.param(shifted(-5), "STALE", id="5_s_old"),
        pytest.param(shifted(60), "FUTURE", id="60_s_ahead"),
        pytest.param(lambda: rospy.Time(0), "STALE", id="zero"),
        pytest.param(lambda: rospy.Time(LAST_SECOND, 999_999_999), "FUTURE", id="the_last_there_is"),
        pytest.param(lambda: rospy.Time(2**31, 0), "FUTURE", id="beyond_31_bits"),
    ],
)
def test_a_cloud_with_a_wrong_stamp_shows_what_is_not_there_now(robot, clock, cause):
    robot.camera.clock = clock
    robot.camera.show(hall())
    robot.stops(cause)
    robot.camera.clock = rospy.Time.now
    robot.camera.show(hall())
    robot.drives()


class SimulatedTime:
    """/clock, a hundred times a second."""

    def __init__(self, start):
        self._now = start
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._publisher = rospy.Publisher("/clock", Clock, queue_size=1)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def now(self):
        with self._lock:
            return rospy.Time(self._now)

    def jump(self, seconds):
        with self._lock:
            self._now += seconds

    def end(self):
        self._ended.set()
        self._thread.join()
        self._publisher.unregister()

    def _run(self):
        while not self._ended.wait(0.01):
            self.jump(0.01)
            self._publisher.publish(Clock(self.now()))


@pytest.fixture
def simulated_time(master):
    rospy.set_param("/use_sim_time", True)
    time = SimulatedTime(1000.0)
    yield time
    time.end()
    rospy.delete_param("/use_sim_time")


@pytest.fixture
def replayed(simulated_time):
    """A robot whose time is simulated."""
    with driving_robot(clock=simulated_time.now, source_timeout=3) as robot:
        yield robot


def test_time_that_jumps_back_stops_the_robot_until_a_fresh_cloud(replayed, simulated_time):
    camera = replayed.camera
    camera.pause()
    replayed.keeps(0.2)
    camera.changes()
    simulated_time.jump(-100.0)
    replayed.stops("CLOCK_JUMP", within=0.1 + GRACE)  # no cloud wakes it, only its own period
    camera.show(hall())
    replayed.drives()


def test_clouds_from_before_a_jump_back_are_from_the_future(replayed, simulated_time):
    replayed.camera.clock = lambda: simulated_time.now() + rospy.Duration(100)
    simulated_time.jump(-100.0)
    replayed.camera.show(hall())
    replayed.stops("FUTURE")
    replayed.camera.clock = simulated_time.now
    replayed.camera.show(hall())
    replayed.drives()


def test_time_that_jumps_ahead_makes_old_clouds_stale(replayed, simulated_time):
    replayed.camera.clock = lambda: simulated_time.now() - rospy.Duration(100)
    simulated_time.jump(100.0)
    replayed.camera.show(hall())
    replayed.stops("STALE")
    replayed.camera.clock = simulated_time.now
    replayed.camera.show(hall())
    replayed.drives()


def test_simulated_time_that_stands_still_does_not_hide_a_silent_camera(replayed, simulated_time):
    simulated_time.end()
    replayed.camera.pause()
    replayed.stops("SILENT", within=3.25)


def test_simulated_time_that_stands_still_does_not_silence_diagnostics(replayed, simulated_time):
    heard = Heard("/diagnostics", DiagnosticArray)
    simulated_time.end()
    replayed.camera.pause()
    replayed.stops("SILENT", within=3.25)
    heard.until(lambda said: "no cloud for" in said.status[0].message)
    heard.close()
