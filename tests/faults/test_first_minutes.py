# SPDX-License-Identifier: BSD-3-Clause
"""What a new user meets first: nothing comes, a name is wrong, two are started. Each time the node says which."""
import rospy
from geometry_msgs.msg import Twist
from robot import NODE, Heard, eventually, node_under_test
from sensor_msgs.msg import Image, PointCloud2

from safety_control_cloud.msg import SafetyState


def reason_until(words):
    states = Heard(NODE + "/state", SafetyState)
    try:
        return states.until(lambda state: words in state.reason)
    finally:
        states.close()


def test_a_topic_of_another_type_and_the_place_of_the_right_one_are_named(master):
    image = rospy.Publisher("/robot/points", Image, queue_size=1)
    cloud = rospy.Publisher("/robot/depth/points", PointCloud2, queue_size=1)
    with node_under_test("camera/depth/points:=/robot/points"):
        state = reason_until("/robot/points as sensor_msgs/Image, not as sensor_msgs/PointCloud2")
        assert (state.cause_text, state.speed) == ("NO_CLOUD", 0.0)
        assert "is published on /robot/depth/points" in state.reason
    image.unregister(), cloud.unregister()


def test_a_topic_that_nobody_publishes_is_named_and_so_is_a_publisher_that_says_nothing(master):
    with node_under_test("camera/depth/points:=/robot/front"):
        reason_until("nobody publishes /robot/front")
        silent = rospy.Publisher("/robot/front", PointCloud2, queue_size=1)
        reason_until("/robot/front has 1 publisher, /faults, and nothing has come from there")
        silent.unregister()


def test_the_one_that_is_ended_by_a_second_of_its_name_says_so(master):
    with node_under_test() as first:
        Heard("/cmd_vel_mux/input/teleop", Twist).until(lambda command: True)
        with node_under_test():
            assert first.wait(10.0) == 0
            eventually(lambda: "another node has started as /safety_control_cloud" in first.output())


def test_a_parameter_without_its_underscore_is_told_from_a_topic(master):
    with node_under_test("danger_distance:=0.7") as node:
        assert node.wait(10.0) != 0
        assert "the parameter is set by _danger_distance:=0.7" in node.output()


def test_who_asks_for_help_gets_it_and_commands_no_robot(master):
    commands = Heard("/cmd_vel_mux/input/teleop", Twist)
    for word in ("-h", "--help"):
        with node_under_test(word) as node:
            assert node.wait(10.0) == 0
            assert "safety_control_node [_PARAMETER:=VALUE]" in node.output()
    assert commands.all() == []
    commands.close()


def test_a_guard_that_would_hear_itself_does_not_start(master):
    for remapping in (("cmd_vel_in:=/cmd_vel",), ("cmd_vel:=/wanted", "cmd_vel_in:=wanted")):
        with node_under_test("_mode:=guard", *remapping) as node:
            assert node.wait(10.0) != 0
            assert "cmd_vel_in and cmd_vel are both /" in node.output()
    rospy.delete_param(NODE)  # the next one is another robot


def test_a_guard_two_of_whose_sensors_have_one_topic_does_not_start_however_that_is_spelt(master):
    sensors = [{"name": "front", "type": "cloud", "topic": "front/points"}, {"name": "rear", "type": "cloud", "topic": "rear/points"}]
    for other, remapping in (("/front/points", ()), ("rear/points", ("rear/points:=front/points",))):
        rospy.set_param(NODE + "/sensors", [sensors[0], {**sensors[1], "topic": other}])
        with node_under_test("_mode:=guard", *remapping) as node:
            assert node.wait(10.0) != 0
            assert "front and rear have the same topic, /front/points" in node.output()
        rospy.delete_param(NODE)
