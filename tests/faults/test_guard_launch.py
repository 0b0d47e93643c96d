# SPDX-License-Identifier: BSD-3-Clause
"""guard.launch: who speaks to whom between a driver and the base."""
from pathlib import Path

import rosgraph
import rospy
from geometry_msgs.msg import Twist
from guarded import Guarded, Repeated, bits, twist
from listening import Heard
from robot import eventually
from scenes import hall

from safety_control_cloud.processes import OF_ROSLAUNCH, process

LAUNCH = Path(__file__).resolve().parents[2] / "safety_control_cloud/launch/guard.launch"
BASE = "/mobile_base/commands/velocity"


def speakers_to(topic):
    publishers, _, _ = rosgraph.Master("/test_guard_launch").getSystemState()
    return next((set(nodes) for name, nodes in publishers if name == topic), set())


def obeys(base, command):
    return [bits(latest) for latest in base.all()[-1:]] == [bits(command)]


def test_teleop_and_navigation_reach_the_base_through_the_guard_and_nothing_else_does(master):
    with process(["roslaunch", str(LAUNCH), "footprint:=[[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]"], OF_ROSLAUNCH) as running:
        robot, base = Guarded(running), Heard(BASE, Twist)
        teleop, navigation = Repeated("/teleop/cmd_vel", Twist, 50.0), Repeated("/move_base/cmd_vel", Twist, 20.0)
        try:
            robot.states.until(lambda state: state.cause_text == "NO_COMMAND")
            assert len(rospy.get_param("/safety_control_cloud/footprint")) == 4
            navigation.say(twist(0.2, 0.1))
            eventually(lambda: obeys(base, twist(0.2, 0.1)))
            teleop.say(twist(0.1, -0.1))
            eventually(lambda: obeys(base, twist(0.1, -0.1)))
            assert speakers_to(BASE) == {"/safety_control_cloud"}
            assert speakers_to("/guard_mux/output") == {"/guard_mux"}
            robot.camera.pause()
            robot.states.until(lambda state: state.cause_text == "SILENT")
            eventually(lambda: obeys(base, Twist()))
            robot.camera.show(hall())
            eventually(lambda: obeys(base, twist(0.1, -0.1)))
        finally:
            for part in (teleop, navigation, robot, base):
                part.close() if isinstance(part, Heard) else part.end()
    rospy.delete_param("/safety_control_cloud")
