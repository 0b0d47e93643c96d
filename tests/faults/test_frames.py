# SPDX-License-Identifier: BSD-3-Clause
"""A corridor in the robot's frame, and transforms that are missing, stop, or make no sense.

Every test has a camera frame of its own: what was once said on /tf_static stays said.
"""
import math
import threading
import time

import pytest
import rospy
import tf2_msgs.msg
from geometry_msgs.msg import TransformStamped
from robot import driving_robot, eventually
from scenes import hall, wall

BASE = "base_footprint"
AHEAD = 0.4  # [s] by which the transform of what moves is dated ahead, so that a busy machine leaves no gap


def camera_in_base(frame, qx=-0.5):
    """The Xtion on a TurtleBot."""
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = BASE, frame
    transform.header.stamp = rospy.Time.now()
    transform.transform.translation.x, transform.transform.translation.z = -0.087, 0.2972
    rotation = transform.transform.rotation
    rotation.x, rotation.y, rotation.z, rotation.w = qx, 0.5, -0.5, 0.5
    return transform


def turn(rotation, heading):
    """By so much to the left."""
    c, s = math.cos(heading / 2), math.sin(heading / 2)
    x, y, z, w = rotation.x, rotation.y, rotation.z, rotation.w
    rotation.x, rotation.y, rotation.z, rotation.w = c * x - s * y, c * y + s * x, c * z + s * w, c * w - s * z


class Frames:
    """Publishes where a camera is: once for all, or again and again for as long as it moves."""

    def __init__(self):
        self._static = rospy.Publisher("/tf_static", tf2_msgs.msg.TFMessage, queue_size=1, latch=True)
        self._dynamic = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=1)
        self._stopped = threading.Event()

    def stays(self, transform):
        self._static.publish([transform])

    def says(self, transform):
        self._dynamic.publish([transform])

    def moves(self, frame):
        self._stopped.clear()

        def run():
            while not self._stopped.wait(0.02):
                transform = camera_in_base(frame)
                transform.header.stamp += rospy.Duration(AHEAD)
                self._dynamic.publish([transform])

        threading.Thread(target=run, daemon=True).start()

    def turns(self, frame, late):
        self._stopped.clear()

        def run():
            while not self._stopped.wait(0.01):
                transform = camera_in_base(frame)
                transform.header.stamp -= rospy.Duration(late)
                turn(transform.transform.rotation, 0.3 * math.sin(10.0 * transform.header.stamp.to_sec()))
                self._dynamic.publish([transform])

        threading.Thread(target=run, daemon=True).start()

    def stops(self):
        self._stopped.set()

    def end(self):
        self.stops()
        self._static.unregister()
        self._dynamic.unregister()


@pytest.fixture
def frames(master):
    frames = Frames()
    yield frames
    frames.end()


def test_a_camera_whose_place_is_not_known_stops_the_robot_until_it_is_known(frames):
    frame = "camera_without_place"
    with driving_robot(cause="NO_TRANSFORM", view=hall(frame=frame), target_frame=BASE) as robot:
        assert BASE in robot.states.all()[-1].reason
        frames.stays(camera_in_base(frame))
        robot.camera.show(hall(frame=frame))
        robot.drives()


def test_a_camera_whose_place_is_not_known_any_more_stops_the_robot(frames):
    frame = "camera_on_an_arm"
    frames.moves(frame)
    with driving_robot(view=hall(frame=frame), target_frame=BASE) as robot:
        frames.stops()
        robot.camera.changes()
        robot.stops("NO_TRANSFORM", within=AHEAD + 0.1 + 0.3)  # the tolerance, and one cloud
        frames.moves(frame)
        robot.camera.show(hall(frame=frame))
        robot.drives()


def test_a_camera_that_turns_has_no_place_by_a_transform_that_is_late(frames):
    frame = "camera_on_a_head"
    frames.moves(frame)
    with driving_robot(view=hall(frame=frame), target_frame=BASE) as robot:
        frames.stops()
        rospy.sleep(AHEAD + 0.2)
        frames.turns(frame, late=0.05)
        robot.camera.changes()
        until = time.monotonic() + 20.0
        while not any(" moves in " in state.reason for state in robot.states.all()):
            assert time.monotonic() < until, robot.states.all()[-1]
            time.sleep(0.05)


@pytest.mark.parametrize(
    "frame", ["", "/", "/camera_with_a_slash", "camera of another robot", "x" * 4096], ids=lambda name: name[:20])
def test_a_frame_that_cannot_be_has_no_place(frames, frame):
    frames.stays(camera_in_base("camera_that_changes_its_name"))
    good = hall(frame="camera_that_changes_its_name")
    with driving_robot(view=good, target_frame=BASE) as robot:
        robot.camera.show(hall(frame=frame))
        robot.stops("NO_TRANSFORM")
        robot.camera.show(good)
        robot.drives()


def test_a_transform_that_is_no_rotation_leaves_the_place_unknown(frames):
    frame = "camera_turned_by_nan"
    with driving_robot(cause="NO_TRANSFORM", view=hall(frame=frame), target_frame=BASE) as robot:
        frames.stays(camera_in_base(frame, qx=math.nan))
        robot.camera.show(hall(frame=frame))
        robot.stops("NO_TRANSFORM")
        frames.stays(camera_in_base(frame))
        robot.camera.show(hall(frame=frame))
        robot.drives()


def test_the_last_stamp_there_is_ends_no_lookup(frames):
    frames.stays(camera_in_base("camera_of_the_last_day"))
    frames.moves("camera_of_the_last_day_on_an_arm")
    good = hall(frame="camera_of_the_last_day")
    with driving_robot(view=good, target_frame=BASE, stamp_tolerance=0) as robot:
        robot.camera.clock = lambda: rospy.Time(2**32 - 1, 0)
        robot.camera.show(hall(frame="camera_of_the_last_day_on_an_arm"))
        robot.stops("NO_TRANSFORM")
        robot.camera.clock = rospy.Time.now
        robot.camera.show(good)
        robot.drives()


def test_a_transform_of_the_last_day_does_not_keep_others_from_being_heard(frames):
    """Of whatever frame: tf2 counts back from there, and throws what it does not catch."""
    frame = "camera_beside_the_last_day"
    frames.moves(frame)
    with driving_robot(view=hall(frame=frame), target_frame=BASE) as robot:
        for _ in range(3):
            of_the_last_day = camera_in_base("something_of_the_last_day")
            of_the_last_day.header.stamp = rospy.Time(2**32 - 1, 0)
            frames.says(of_the_last_day)
            time.sleep(0.1)
        eventually(lambda: "cannot be taken" in robot.process.output())
        time.sleep(AHEAD + 0.5)
        assert robot.process.exit_code is None
        robot.camera.changes()
        robot.drives()


def test_an_obstacle_is_found_in_the_robots_frame(frames):
    frame = "camera_on_the_robot"
    frames.stays(camera_in_base(frame))
    with driving_robot(view=hall(frame=frame), target_frame=BASE) as robot:
        robot.camera.show(hall(wall(0.55), frame=frame))
        assert abs(robot.stops("SEEN").nearest - (0.55 - 0.087)) < 0.01
        robot.camera.show(hall(frame=frame))
        robot.drives()
