# SPDX-License-Identifier: BSD-3-Clause
"""Others that command the robot on the node's own topic: whoever obeys the latest command obeys them and us in turn."""
import signal
import time

import pytest
from commanders import ITS_END, NOTICED, commander, first, is_doubted, is_of, mean_speed
from diagnostic_msgs.msg import DiagnosticArray
from robot import AGAIN, GRACE, NODE, Heard, after, eventually, node, node_under_test

from safety_control_cloud.msg import SafetyState


@pytest.mark.parametrize("rate", [1.0, 5.0])
def test_each_command_of_somebody_else_is_answered_by_a_zero_and_its_sender_is_named(robot, rate):
    diagnostics = Heard("/diagnostics", DiagnosticArray)
    since = time.monotonic()
    with commander(0.2, rate) as other:
        began = first(robot.commands, is_of("/teleop"), since)
        assert first(robot.states, is_doubted, since) - began < NOTICED
        time.sleep(3.0)
        # A machine that stalls holds up who hears the zero, too: three seconds without that are enough.
        eventually(lambda: mean_speed(robot.commands, time.monotonic() - 3.0) < 0.02)
        assert "/teleop commands the robot on /cmd_vel_mux/input/teleop" in robot.states.all()[-1].reason
        eventually(lambda: any("/teleop" in status.message for status in diagnostics.all()[-1].status))
        other.send(signal.SIGKILL)
        other.wait(5.0)
    time.sleep(GRACE)  # his last command arrives, which is of the speed at which the robot drives again
    robot.camera.changes()
    robot.drives(within=ITS_END + 2.0)
    diagnostics.close()
    eventually(lambda: "TWO_COMMANDERS, /teleop" in robot.process.output())


def test_somebody_who_only_could_command_stops_the_robot_until_he_has_gone(robot):
    since = time.monotonic()
    with commander(0.0, 0.0) as other:
        first(robot.states, is_doubted, since)
        robot.states.until(lambda state: "/teleop is about to command" in state.reason)
        robot.camera.changes()
        robot.stops("TWO_COMMANDERS", within=AGAIN)
        other.send(signal.SIGINT)
        other.wait(5.0)
    robot.camera.changes()
    robot.drives(within=ITS_END)


def test_two_instances_both_stand_and_do_not_answer_each_others_zeros(robot):
    second = Heard("/second/state", SafetyState)
    with node_under_test("__name:=second"):
        first(robot.states, is_doubted, time.monotonic() - 1.0)
        second.until(is_doubted)
        doubted = time.monotonic()
        for name in (NODE, "/second"):
            first(robot.commands, lambda command: is_of(name)(command) and command.linear.x == 0.0, doubted)
        since = time.monotonic()  # what each had said before has arrived: states and commands come by ways of their own
        time.sleep(2.0)
        commands = [command.linear.x for _, command in after(since, robot.commands)]
        assert set(commands) == {0.0}
        assert len(commands) < 2.0 * 2 * (20 + 10 + 10), "clouds, periods and silences of two nodes"
        assert is_doubted(second.all()[-1])
    second.close()
    robot.camera.changes()
    robot.drives(within=ITS_END)


def test_the_other_inputs_of_the_mux_are_no_doubt(robot):
    navigation = Heard("/cmd_vel_mux/input/navi", type(robot.commands.all()[0]))
    with commander(0.5, 10.0, "/cmd_vel_mux/input/navi"):
        navigation.until(lambda command: True)
        robot.keeps(0.2, seconds=1.0)
    navigation.close()


def test_the_mux_passes_nothing_that_waited_while_it_was_stopped(robot):
    """Whoever said it may be dead by then."""
    output = Heard("/mobile_base/commands/velocity", type(robot.commands.all()[0]))
    with node("cmd_vel_mux", "__name:=cmd_vel_mux") as mux:
        with commander(0.5, 20.0, "/cmd_vel_mux/input/safety_controller", name="controller") as other:
            output.until(lambda command: command.linear.x == 0.5)
            mux.send(signal.SIGSTOP)
            time.sleep(1.0)
            other.send(signal.SIGKILL)
            other.wait(5.0)
        time.sleep(2.0)
        since = time.monotonic()
        mux.send(signal.SIGCONT)
        time.sleep(2.0)
        assert {command.linear.x for _, command in after(since, output)} <= {0.0, 0.2}
        with commander(0.5, 20.0, "/cmd_vel_mux/input/safety_controller", name="controller"):
            output.until(lambda command: command.linear.x == 0.5, after=len(output.all()))
    output.close()
