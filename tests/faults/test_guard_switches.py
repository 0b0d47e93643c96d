# SPDX-License-Identifier: BSD-3-Clause
"""Bumpers and cliff sensors close a side of a guarded robot, whatever the camera shows."""
import signal
import time

import pytest
import rospy
from commanders import is_of
from genpy.dynamic import generate_dynamic
from guarded import FRONT_BUMPER, ZERO, bits, driver_of_the_bumper, guarded_robot, twist
from robot import GRACE, Heard, after, eventually
from std_msgs.msg import Bool, Int8
from std_srvs.srv import Trigger

from safety_control_cloud.processes import process

NODE = "/safety_control_cloud"
PARAMETERS = NODE + "/"
# As kobuki_msgs has it, which Debian has not.
BUMPER_EVENT = generate_dynamic("kobuki_msgs/BumperEvent", "uint8 bumper\nuint8 state\n")["kobuki_msgs/BumperEvent"]
SWITCHES = [
    FRONT_BUMPER,
    {"name": "edge", "type": "cliff", "topic": "cliff", "side": "rear", "timeout": 0.5},
    {"name": "kobuki", "type": "bumper", "topic": "mobile_base/events/bumper"},
]
AHEAD, BACK = twist(0.3), twist(-0.3)
RELEASE = 0.5  # [s] for which a switch that has been released still closes its side: switch_release_time
PROMPT = 0.4 * GRACE  # [s] which a busy machine may exceed, but not each time


class Switch:
    """Publishes what a switch says; one that has a timeout, again and again."""

    def __init__(self, topic, kind, said=None):
        self.publisher = rospy.Publisher(topic, kind, queue_size=10)
        self.said = said
        self.timer = rospy.Timer(rospy.Duration(0.1), lambda event: self.publisher.publish(self.said)) if said is not None else None

    def say(self, *said):
        eventually(self.publisher.get_num_connections)
        if self.timer:
            self.said = said[0]
        self.publisher.publish(*said)

    def end(self):
        if self.timer:
            self.timer.shutdown()
        self.publisher.unregister()


@pytest.fixture(scope="module")
def robot(master):
    rospy.set_param(PARAMETERS + "switches", SWITCHES)
    rospy.set_param(PARAMETERS + "mode", "guard")
    switches = [Switch("/bumper", Bool), Switch("/cliff", Bool, False), Switch("/mobile_base/events/bumper", BUMPER_EVENT)]
    with guarded_robot() as robot:
        robot.front, robot.edge, robot.kobuki = switches
        yield robot
    for switch in switches:
        switch.end()


def drives(robot):
    robot.driver.say(AHEAD)
    robot.passes(AHEAD)


def stands_without(robot, name):
    """Who drove until the switch's publisher left; what it says then."""
    drives(robot)
    getattr(robot, name).end()
    state = robot.stands("SILENT")
    assert state.sensor == name
    return state


def gives(robot, speed):
    return robot.gives(lambda state: abs(state.given.linear.x - speed) < 1e-9)


def test_a_bumper_that_is_pressed_leaves_the_way_back_at_escape_speed(robot):
    drives(robot)
    robot.front.say(True)
    state = robot.stands("BUMPER")
    assert (state.sensor, state.open, state.stuck) == ("front", 2, True)
    robot.driver.say(BACK)
    gives(robot, -0.1)
    robot.front.say(False)
    drives(robot)


def test_the_first_command_after_a_touch_is_zero(robot):
    late = []
    for _ in range(3):
        drives(robot)
        robot.front.say(True)
        touched = time.monotonic()
        robot.stands("BUMPER")
        said = [(arrival, bits(command)) for arrival, command in after(touched, robot.commands)]
        robot.front.say(False)
        assert {command for _, command in said} <= {bits(AHEAD), ZERO}
        late.append(max((arrival - touched for arrival, command in said if command != ZERO), default=0.0))
    robot.passes(AHEAD)
    assert max(late) < GRACE and min(late) < PROMPT, late


def test_a_kobuki_says_which_of_its_bumpers(robot):
    drives(robot)
    robot.kobuki.say(0, 1)
    assert "front_left" in robot.stands("BUMPER").reason
    robot.kobuki.say(1, 1)
    robot.kobuki.say(1, 0)
    robot.gives(lambda state: state.cause_text == "BUMPER" and bits(state.given) == ZERO, lasts=2 * RELEASE)
    robot.kobuki.say(0, 0)
    robot.passes(AHEAD)


def test_a_cliff_behind_closes_the_way_back(robot):
    robot.driver.say(BACK)
    robot.edge.say(True)
    robot.stands("CLIFF")
    robot.driver.say(AHEAD)
    gives(robot, 0.1)
    robot.edge.say(False)
    robot.passes(AHEAD)


def test_one_that_should_speak_and_does_not_stops_the_robot(robot):
    stands_without(robot, "edge")
    robot.edge = Switch("/cliff", Bool, False)
    robot.passes(AHEAD)
    robot.edge.end()
    robot.edge = Switch("/cliff", Int8, 0)
    assert "std_msgs/Int8" in robot.stands("UNREADABLE").reason
    robot.edge.end()
    robot.edge = Switch("/cliff", Bool, False)
    robot.passes(AHEAD)


def test_one_that_nobody_publishes_stops_the_robot_and_is_named(robot):
    assert "/bumper" in stands_without(robot, "front").reason
    robot.front = Switch("/bumper", Bool)
    robot.passes(AHEAD)


def test_one_whose_driver_was_killed_stops_the_robot_and_its_successor_is_heard_whatever_type_it_has(robot):
    robot.front.end()
    with driver_of_the_bumper() as driver:
        robot.passes(AHEAD, within=10.0)
        time.sleep(2.5)  # the master is asked once a second who it is
        robot.passes(AHEAD)
        driver.send(signal.SIGKILL)
        assert robot.stands("SILENT", within=5.0).sensor == "front"
    with driver_of_the_bumper("0", "Int8"):
        assert "std_msgs/Int8" in robot.gives(lambda state: state.cause_text == "UNREADABLE", within=10.0).reason
    robot.front = Switch("/bumper", Bool)
    robot.passes(AHEAD)


def test_what_a_driver_touched_that_was_killed_holds_beside_another_until_reset(robot):
    drives(robot)
    with driver_of_the_bumper("true") as driver:
        robot.stands("BUMPER", within=10.0)
        robot.front.say(False)
        robot.gives(lambda state: state.cause_text == "BUMPER" and bits(state.given) == ZERO, lasts=2 * RELEASE)
        driver.send(signal.SIGKILL)
        assert "~reset" in robot.gives(lambda state: state.cause_text == "BUMPER" and state.hint, within=10.0).hint
    robot.front.say(False)
    robot.gives(lambda state: state.cause_text == "BUMPER" and bits(state.given) == ZERO, lasts=2 * RELEASE)
    assert rospy.ServiceProxy(NODE + "/reset", Trigger)().success
    robot.passes(AHEAD)


def test_a_touch_while_the_node_is_stopped_is_not_lost_behind_the_words_of_another(robot):
    drives(robot)
    robot.front.say(False)
    said = Heard("/bumper", Bool)
    with process(["rostopic", "pub", "-r", "100", "/bumper", "std_msgs/Bool", "false", "__name:=steady"]):
        said.until(is_of("/steady"))
        time.sleep(1.0)
        robot.passes(AHEAD)
        robot.process.send(signal.SIGSTOP)
        robot.front.say(True)
        time.sleep(3.0)
        robot.process.send(signal.SIGCONT)
        robot.stands("BUMPER", within=10.0)
        robot.front.say(False)
        robot.passes(AHEAD)
    said.close()
