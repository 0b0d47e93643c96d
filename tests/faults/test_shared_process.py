# SPDX-License-Identifier: BSD-3-Clause
"""The node in a process that it shares with others, as a nodelet does: they end it, block it, and command beside it."""
import os
import signal
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path

import dynamic_reconfigure.client
import pytest
import rospy
from commanders import ITS_END, first, is_doubted, mean_speed
from listening import Heard
from robot import AGAIN, GRACE, NODE, SOURCE_TIMEOUT, START, after, eventually, is_sending, robot_with
from scenes import always, cloud_of, hall, points_of, wall
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import Float64

from safety_control_cloud.processes import process

BUILT = Path(__file__).resolve().parents[2] / "build/tests/ros"
SHARED, BUSY_MANAGER = BUILT / "shared_process", BUILT / "busy_manager"
NODELET = ["rosrun", "nodelet", "nodelet", "standalone", "safety_control_cloud/SafetyControlNodelet",
           "__name:=safety_control_cloud"]
BLOCKED = 6.0  # [s]
LATE = 0.15  # [s] after source_timeout until a thread of its own commands zero
ENDS = {"SIGINT": signal.SIGINT, "SIGTERM": signal.SIGTERM, "SIGHUP": signal.SIGHUP, "rosnode_kill": None}


@contextmanager
def robot_in(command):
    with process(command) as running, robot_with(running, hall()) as robot:
        robot.drives(within=START)
        yield robot


@pytest.fixture
def a_terminal():
    """nohup, under which these tests may run, lets those who are started ignore that it closes."""
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGHUP, before)


@pytest.fixture
def nodelet(master, a_terminal):
    with robot_in(NODELET) as robot:
        yield robot


@pytest.fixture(params=[None, 1.0], ids=["publish_rate", "publish_rate_1"])
def shared(request, master):
    if request.param:
        rospy.set_param(NODE + "/publish_rate", request.param)
    with robot_in([str(SHARED)]) as robot:
        yield robot


def says(topic, value):
    publisher = rospy.Publisher(topic, Float64, queue_size=1)
    eventually(lambda: publisher.get_num_connections() > 0)
    publisher.publish(value)
    return publisher


@pytest.mark.parametrize("number", ENDS.values(), ids=ENDS)
def test_the_last_command_of_a_manager_that_is_ended_is_zero(nodelet, number):
    if number:
        nodelet.process.send(number)
    else:
        subprocess.run(["rosnode", "kill", NODE], check=True, stdout=subprocess.DEVNULL)
    assert nodelet.process.wait(10.0) in (0, -signal.SIGTERM, -signal.SIGHUP), nodelet.process.output()
    assert nodelet.commands.until_silence()[-1].linear.x == 0.0


def test_the_last_command_of_a_nodelet_that_is_unloaded_is_zero(master):
    with process(["rosrun", "nodelet", "nodelet", "manager", "__name:=manager"]) as manager:
        load = ["rosrun", "nodelet", "nodelet", "load", "safety_control_cloud/SafetyControlNodelet", "manager"]
        with process([*load, "__name:=safety_control_cloud"]) as loaded, robot_with(manager, hall()) as robot:
            robot.drives(within=START)
            loaded.send(signal.SIGINT)
            assert robot.commands.until_silence()[-1].linear.x == 0.0
            assert manager.exit_code is None, manager.output()


def test_a_nodelet_has_its_own_topics_wherever_its_manager_lives(master):
    """The managers of openni2 and RealSense live in the camera's namespace."""
    with process(["rosrun", "nodelet", "nodelet", "manager", "__name:=manager", "__ns:=/camera"]) as manager:
        load = ["rosrun", "nodelet", "nodelet", "load", "safety_control_cloud/SafetyControlNodelet", "/camera/manager"]
        with process([*load, "__name:=safety_control_cloud", "output:=cropped"]), robot_with(manager, hall()) as robot:
            robot.drives(within=START)
            cropped = Heard("/cropped", PointCloud2)
            eventually(cropped.all)
            cropped.close()


def test_a_nodelet_with_unfit_parameters_says_all_that_is_wrong(master):
    try:
        with process([*NODELET, "_danger_distanc:=0.6", "_min_points:=0"]) as running:
            eventually(lambda: "did you mean ~danger_distance?" in running.output())
            assert "min_points must be at least 1" in running.output()
    finally:
        rospy.delete_param(NODE)


@pytest.mark.parametrize("period", [float("nan"), 1e10, -1.0], ids=str)
def test_a_manager_outlives_a_period_of_diagnostics_that_is_none(nodelet, period):
    """diagnostic_updater reads it anew each time."""
    try:
        rospy.set_param(NODE + "/diagnostic_period", period)
        time.sleep(3.0)
        assert nodelet.process.exit_code is None, nodelet.process.output()
        nodelet.camera.changes()
        nodelet.drives()
    finally:
        rospy.delete_param(NODE + "/diagnostic_period")


def test_others_that_keep_the_queue_busy_do_not_keep_the_robot_driving(shared):
    says("/block", 3.0)
    shared.camera.changes()
    stopped = first(shared.commands, lambda command: command.linear.x == 0.0, shared.camera.changed_at)
    assert stopped - shared.camera.changed_at < SOURCE_TIMEOUT + LATE
    time.sleep(1.0)
    assert {command.linear.x for _, command in after(stopped, shared.commands)} == {0.0}
    shared.camera.changes()
    shared.drives(within=4.0 + AGAIN)


def test_nodelets_that_keep_all_workers_busy_do_not_keep_this_one_waiting(master):
    with robot_in([str(BUSY_MANAGER)]) as robot:
        busy = Heard("/busy", Float64)
        eventually(lambda: is_sending("/busy_manager", "/busy"))
        until = time.monotonic() + BLOCKED
        says("/block", BLOCKED)
        eventually(lambda: len(busy.all()) == os.cpu_count())
        robot.camera.show(hall(wall(0.45)))
        robot.stops("SEEN")
        robot.camera.show(hall(wall(3.0)))
        robot.drives()
        assert time.monotonic() < until, "they must have been busy all the while"
        busy.close()


def test_what_commands_from_within_the_same_process_is_somebody_else(shared):
    since = time.monotonic()
    talk = says("/talk", 0.2)
    began = first(shared.states, is_doubted, since)
    for _ in range(20):
        talk.publish(0.2)
        time.sleep(0.1)
    assert mean_speed(shared.commands, began) < 0.02
    assert "another part of /safety_control_cloud commands" in shared.states.all()[-1].reason
    time.sleep(GRACE)  # its last command arrives, which is of the speed at which the robot drives again
    shared.camera.changes()
    shared.drives(within=ITS_END)


def test_a_nodelet_stops_for_every_fault_and_drives_again(nodelet):
    camera = nodelet.camera
    faults = [(hall(wall(0.45)), "SEEN"), (always(cloud_of(points_of(), point_step=0)), "UNREADABLE"),
              (always(cloud_of(points_of() * float("nan"))), "BLIND")]
    for view, cause in faults:
        camera.show(view)
        state = nodelet.stops(cause)
        assert abs((rospy.Time.now() - state.header.stamp).to_sec()) < 2.0, "the stamp of the cloud decided on"
        camera.show(hall(wall(3.0)))
        nodelet.drives()
    camera.pause()
    nodelet.stops("SILENT", within=SOURCE_TIMEOUT)
    camera.show(hall(wall(3.0)))
    nodelet.drives()


def test_a_nodelet_is_reconfigured_and_goes_on(nodelet):
    client = dynamic_reconfigure.client.Client(NODE, timeout=START)
    answer = client.update_configuration({"safe_speed": 0.15})
    assert (answer["safe_speed"], answer["refusal"]) == (0.15, "")
    nodelet.camera.changes()
    nodelet.drives(0.15)
    assert client.update_configuration({"danger_distance": 9.0})["refusal"]
    nodelet.keeps(0.15)
    client.close()
