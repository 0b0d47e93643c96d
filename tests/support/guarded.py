# SPDX-License-Identifier: BSD-3-Clause
"""A robot that somebody drives and the real node guards: a camera, a driver, and a base that obeys."""
from __future__ import annotations

import signal
import struct
import time
from contextlib import contextmanager
from typing import Any, Callable, ContextManager, Iterator, Optional, Sequence, Type

import rospy
from camera import TOPIC, Camera
from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Twist, TwistStamped, Vector3
from listening import Heard
from nav_msgs.msg import Odometry
from repeated import Repeated
from robot import GRACE, after, flat, node_under_test
from scenes import FRAME, View, hall, wall
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

from safety_control_cloud.msg import Blocked, SafetyState
from safety_control_cloud.processes import Process, process

FRONT_BUMPER = {"name": "front", "type": "bumper", "topic": "bumper", "side": "front"}  # of the parameter switches
CAMERA_TO_FRONT = 0.265  # [m] by which a TurtleBot's round hull sticks out before its camera
SETTLED = 3.0  # [s]
IN_PASSING = 0.05  # [s] by which ~state may come later than the command that it tells of
Clock = Callable[[], rospy.Time]


def twist(x: float = 0.0, w: float = 0.0) -> Twist:
    command = Twist()
    command.linear.x, command.angular.z = x, w
    return command


def bits(command: Twist) -> bytes:
    return struct.pack("6d", *flat(command))


ZERO = bits(Twist())


class Guarded:
    """`namespace`: "" or as "/robot1"; its frames bear the same prefix. `stamped`: its driver's commands, by `stamp`."""

    def __init__(
        self, process: Process, view: Optional[View] = None, namespace: str = "", clock: Clock = rospy.Time.now, stamped: bool = False,
        others: Sequence[TransformStamped] = (), camera: Type[Camera] = Camera,
    ) -> None:
        self.process, self.namespace = process, namespace
        prefix = namespace.strip("/") + "/" if namespace else ""
        self._transforms = rospy.Publisher("/tf_static", TFMessage, queue_size=10, latch=True)
        self._transforms.publish(TFMessage([camera_on(prefix + "base_footprint", prefix + FRAME), *others]))
        self.states = Heard(namespace + "/safety_control_cloud/state", SafetyState)
        self.blocked = Heard(namespace + "/safety_control_cloud/blocked", Blocked)
        self.commands = Heard(namespace + "/cmd_vel", Twist)
        self.stamp: Clock = rospy.Time.now
        said = (TwistStamped, 50.0, self.stamped) if stamped else (Twist, 50.0)
        self.driver = Repeated(namespace + "/cmd_vel_in", *said)
        self.camera = camera(view or hall(frame=prefix + FRAME), clock, topic=namespace + TOPIC)

    def rests(self) -> None:
        """In a hall that is seen to be free, and without a driver."""
        self.camera.clock = rospy.Time.now
        self.camera.show(hall())
        self.driver.say(twist(0.3))
        self.gives(lambda state: state.cause_text == "SEEN" and state.factor == 1.0, lasts=0.2)
        self.driver.say(None)

    def gives(self, fits: Callable[[SafetyState], bool], within: float = SETTLED, lasts: float = 0.3) -> SafetyState:
        """The robot comes to an answer that fits, and stays with such for a while, on ~state and on cmd_vel.

        A machine that is busy for a moment may make it stand meanwhile, or keep it silent: then it comes to that answer
        again.
        """
        end = time.monotonic() + within + GRACE
        while True:
            state = self._comes_to(fits, end - time.monotonic())
            since = time.monotonic()
            time.sleep(lasts)
            said = {bits(command) for _, command in after(since + 0.1, self.commands)}
            time.sleep(IN_PASSING)
            assert self.process.exit_code is None, self.process.output()
            later = [state for _, state in after(since, self.states)]
            others = [state for state in later if not fits(state)]
            assert all(bits(state.given) == ZERO for state in others), others[:1]
            if said and later and not others:
                break
        # Where the node is late, another of its threads says zero.
        assert said - {ZERO} <= {bits(state.given) for state in later}, "cmd_vel says what ~state says"
        return state

    def stands(self, cause: str, within: float = SETTLED) -> SafetyState:
        return self.gives(lambda state: state.cause_text == cause and bits(state.given) == ZERO, within)

    def slows(self) -> SafetyState:
        """Before a wall. That of a robot which does not obey comes nearer in all pictures that come late, by what it was
        told to drive since: such a robot says that it rests (`odometry_at_rest`)."""
        return self.gives(lambda state: 0.1 < state.factor < 0.9)

    def passes(self, command: Twist, within: float = SETTLED) -> SafetyState:
        command_bits = bits(command)
        return self.gives(
            lambda state: state.cause_text == "SEEN" and bits(state.wanted) == bits(state.given) == command_bits, within)

    def stamped(self, command: Twist) -> TwistStamped:
        return TwistStamped(Header(0, self.stamp(), ""), command)

    def last_given(self) -> Twist:
        return self.commands.all()[-1]

    def end(self) -> None:
        for part in (self.camera, self.driver):
            part.end()
        for heard in (self.states, self.blocked, self.commands):
            heard.close()
        self._transforms.unregister()

    def _comes_to(self, fits: Callable[[SafetyState], bool], within: float) -> SafetyState:
        since, asked = time.monotonic(), 0.0
        while True:
            states = after(since, self.states)
            if states and fits(states[-1][1]):
                return states[-1][1]
            if asked >= within:
                break
            time.sleep(0.005)
            asked = time.monotonic() - since
            assert self.process.exit_code is None, self.process.output()
        raise AssertionError(f"not within {within} s; the last was\n{self.states.all()[-1:]}")


def driver_of_the_bumper(said: str = "false", kind: str = "Bool", name: str = "bumper_driver") -> ContextManager[Process]:
    """Of FRONT_BUMPER, in a process of its own: it says this once, and lives on."""
    return process(["rostopic", "pub", "/bumper", f"std_msgs/{kind}", said, f"__name:={name}"])


def camera_on(base: str, camera: str) -> TransformStamped:
    """Where a TurtleBot's Xtion is."""
    place = Transform(Vector3(-0.087, 0.0, 0.2972), Quaternion(-0.5, 0.5, -0.5, 0.5))
    return TransformStamped(Header(0, rospy.Time.now(), base), camera, place)


def odometry_of(x: float, speed: float) -> Odometry:
    odometry = Odometry(header=Header(0, rospy.Time.now(), "odom"), child_frame_id="base_footprint")
    odometry.pose.pose.position.x = x
    odometry.pose.pose.orientation.w = 1.0
    odometry.twist.twist.linear.x = speed
    return odometry


@contextmanager
def odometry_at_rest(namespace: str = "") -> Iterator[None]:
    odometry = Repeated(namespace + "/odom", Odometry, 50.0, lambda x: odometry_of(x, 0.0))
    odometry.say(0.0)
    try:
        yield
    finally:
        odometry.end()


class Base:
    """A base that obeys at once, on a line before a wall, and says where it is; its camera shows the wall."""

    def __init__(self, robot: Guarded, gap: float) -> None:
        self.robot, self.gap = robot, gap  # [m] between front and wall
        self.nearest, self.start = gap, gap
        self._odometry = rospy.Publisher(robot.namespace + "/odom", Odometry, queue_size=1, tcp_nodelay=True)

    def runs(self, seconds: float) -> None:
        until, last, shown = time.monotonic() + seconds, time.monotonic(), 0.0
        while time.monotonic() < until:
            time.sleep(0.01)
            now = time.monotonic()
            speed = self.robot.last_given().linear.x
            self.gap -= speed * (now - last)
            self.nearest, last = min(self.nearest, self.gap), now
            self._odometry.publish(odometry_of(self.start - self.gap, speed))
            if now > shown + 0.045:
                self.robot.camera.show(hall(wall(self.gap + CAMERA_TO_FRONT))[:1])
                shown = now

    def end(self) -> None:
        self._odometry.unregister()


@contextmanager
def guarded_robot(
    *remappings: str, namespace: str = "", started: Optional[ContextManager[Process]] = None, others: Sequence[TransformStamped] = (),
    camera: Type[Camera] = Camera, **parameters: Any
) -> Iterator[Guarded]:
    """A robot in a free hall whose camera has been seen; nobody drives it yet. `others`: where its other sensors are.

    What its camera shows does not move when it drives, so that it is not to remember where things were.
    """
    given = [f"_{name}:={value}" for name, value in {"mode": "guard", "memory_distance": 0.0, **parameters}.items()]
    ours = [f"__ns:={namespace}"] if namespace else []
    with started or node_under_test(*given, *ours, *remappings) as process:
        stamped = parameters.get("command_type") == "twist_stamped"
        robot = Guarded(process, namespace=namespace, stamped=stamped, others=others, camera=camera)
        try:
            robot.stands("NO_COMMAND", within=20.0)
            yield robot
            if process.exit_code is None:
                process.send(signal.SIGINT)
                assert process.wait(10.0) == 0, process.output()
        finally:
            robot.end()
            name = namespace + "/safety_control_cloud"
            for left in (name, name + "_lost"):  # the next one is another robot
                if rospy.has_param(left):
                    rospy.delete_param(left)
