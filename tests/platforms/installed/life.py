# SPDX-License-Identifier: BSD-3-Clause
"""The installed package, in a Debian that has nothing but it: programs, launch files, Python. By what it brings itself."""
import subprocess
import sys
import time
from contextlib import ExitStack, contextmanager

import numpy as np
import rospy
from geometry_msgs.msg import Twist

from safety_control_cloud import core
from safety_control_cloud.cfg import SafetyControlConfig
from safety_control_cloud.msg import SafetyState
from safety_control_cloud.processes import OF_ROSLAUNCH, process
from safety_control_cloud.ros_session import roscore

PATIENCE = 60.0  # [s]
PROGRAMS = ("cmd_vel_mux", "gazebo_turtlebot", "gazebo_world", "judge", "replay", "turtlebot_sim", "view_node")


@contextmanager
def heard(topic, kind):
    """A list of what comes on a topic, the first message included."""
    messages = []
    listener = rospy.Subscriber(topic, kind, messages.append)
    yield messages
    listener.unregister()


def until(true, what, running):
    end = time.monotonic() + PATIENCE
    while not true():
        assert running.exit_code is None, f"{what}: it ended\n{running.output()}"
        assert time.monotonic() < end, f"{what}: not within {PATIENCE:g} s\n{running.output()}"
        time.sleep(0.05)


def says_stop_without_a_camera(*command, beside=()):
    """The first command that it gives is zero, and it says why."""
    with ExitStack() as stack:
        if beside:
            stack.enter_context(process(beside))
        commands = stack.enter_context(heard("/cmd_vel_mux/input/teleop", Twist))
        states = stack.enter_context(heard("/safety_control_cloud/state", SafetyState))
        running = stack.enter_context(process(command))
        until(lambda: commands and states, " ".join(command), running)
        assert (commands[0].linear.x, commands[0].angular.z) == (0.0, 0.0), commands[0]
        assert states[0].cause_text == "NO_CLOUD", states[0]
    print("says stop:", *command, flush=True)


def guards():
    """A person's wish goes through the multiplexer to the guard, which lets no one drive without a camera."""
    wish = rospy.Publisher("/teleop/cmd_vel", Twist, queue_size=1)
    with heard("/mobile_base/commands/velocity", Twist) as obeyed, heard("/guard_mux/output", Twist) as wanted, \
            process(["roslaunch", "safety_control_cloud", "guard.launch"], OF_ROSLAUNCH) as running:
        ahead = Twist()
        ahead.linear.x = 0.2

        def is_wanted():
            wish.publish(ahead)
            return wanted and obeyed

        until(is_wanted, "guard.launch", running)
        assert wanted[-1].linear.x == 0.2 and {command.linear.x for command in obeyed} == {0.0}
    print("guards: guard.launch", flush=True)


def decides():
    ahead = np.full((480, 640, 3), (0.0, 0.0, 3.0), dtype=np.float32)
    ahead[200:280, 300:340] = (0.0, 0.0, 0.8)
    decision = core.SafetyControl().decide(ahead, now=0.0)
    assert abs(decision.nearest.distance - 0.8) < 1e-6 and decision.speed == 0.1, decision
    assert SafetyControlConfig.defaults["danger_distance"] == core.Settings().as_dict()["danger_distance"]
    print("decides:", decision, flush=True)


def programs_answer():
    for program in PROGRAMS:
        told = subprocess.run(
            ["rosrun", "safety_control_cloud", program, "--help"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            timeout=PATIENCE)
        assert told.returncode == 0 and told.stdout.lower().startswith("usage: "), f"{program}: {told.stdout}"
    print("answer:", *PROGRAMS, flush=True)


def names_what_is_missing():
    """No Debian has MuJoCo: the launch file ends, and says where to get it."""
    told = subprocess.run(
        ["timeout", str(PATIENCE), "roslaunch", "safety_control_cloud", "demo.launch"], stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True)
    assert told.returncode != 124 and "No module named 'mujoco'" in told.stdout, told.stdout
    print("names what is missing: demo.launch", flush=True)


def the_node_says_stop():
    says_stop_without_a_camera("rosrun", "safety_control_cloud", "safety_control_node")


def the_launch_file_says_stop():
    says_stop_without_a_camera("roslaunch", "safety_control_cloud", "safety_control.launch")


def the_nodelet_says_stop():
    says_stop_without_a_camera(
        "roslaunch", "safety_control_cloud", "safety_control_nodelet.launch", "manager:=/manager",
        beside=("rosrun", "nodelet", "nodelet", "manager", "__name:=manager"))


WITHOUT_ROS = (decides, programs_answer)
WITH_ROS = (names_what_is_missing, the_node_says_stop, the_launch_file_says_stop, the_nodelet_says_stop, guards)


def main(name=None):
    """Each that wants a master in a process of its own: rospy knows one master in its life."""
    if name:
        with roscore():
            if name != names_what_is_missing.__name__:
                rospy.init_node("life", disable_signals=True)
            globals()[name]()
        return
    for check in WITHOUT_ROS:
        check()
    for check in WITH_ROS:
        subprocess.run([sys.executable, "-B", __file__, check.__name__], check=True, timeout=5 * PATIENCE)


if __name__ == "__main__":
    main(*sys.argv[1:])
