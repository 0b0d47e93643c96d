# SPDX-License-Identifier: BSD-3-Clause
"""The simulated TurtleBot as a ROS node: topics, frames and clock of the real robot and of Gazebo."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import count

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Empty as EmptyService
from std_srvs.srv import EmptyResponse
from tf2_msgs.msg import TFMessage

from ..simulation.base import Pose
from ..simulation.turtlebot import TICK, TurtleBot
from . import messages
from .camera_topics import CameraTopics
from .life import Life
from .node_memory import NodeMemory
from .orders import Orders
from .pace import Pace
from .rviz_tools import listen_to_rviz

_ODOMETRY_EVERY = 2  # ticks: 50 Hz, as kobuki_node


@dataclass(frozen=True)
class Options:
    rate: float = 1.0  # simulated seconds a second; 0: as many as the computer manages
    depth_encoding: str = "32FC1"  # or 16UC1
    seed: int | None = 0


class TurtlebotSim:
    """Runs in the thread that calls `run`; what comes in from outside waits for the next tick."""

    def __init__(self, robot: TurtleBot, options: Options = Options()) -> None:
        self._robot = robot
        self._options = options
        self._orders = Orders()
        self._node_memory = NodeMemory()
        self._touched: str | None = None
        self._advertise()
        self._camera = CameraTopics(robot, options.depth_encoding)
        self._subscribe()

    def run(self, life: Life, draw: Callable[[], None] = lambda: None) -> None:
        """For as long as the node lives; `draw` is called whenever the camera may take a picture."""
        picture_every = round(1 / (self._robot.world.xtion.rate * TICK))
        pace = Pace(self._options.rate)
        for tick in count(1):
            if not life.goes_on():
                break
            self._orders.obey()
            self._robot.step()
            stamp = messages.time_of(self._robot.time)
            self._clock.publish(Clock(stamp))
            self._publish_contacts()
            if tick % _ODOMETRY_EVERY == 0:
                self._publish_odometry(stamp)
            if tick % picture_every == 0:
                self._camera.publish(stamp)
                draw()
            pace.keep(TICK)
        self._robot.close()

    def _advertise(self) -> None:
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10, tcp_nodelay=True)
        self._odometry = rospy.Publisher("/odom", Odometry, queue_size=10)
        self._joints = rospy.Publisher("/joint_states", JointState, queue_size=10)
        self._transforms = rospy.Publisher("/tf", TFMessage, queue_size=100)
        self._contacts = rospy.Publisher("~contacts", String, queue_size=10, latch=True)

    def _subscribe(self) -> None:
        rospy.Subscriber("/mobile_base/commands/velocity", Twist, self._on_velocity, queue_size=10, tcp_nodelay=True)
        listen_to_rviz(
            place=partial(self._orders.put, self._place),
            drop=partial(self._orders.put, self._robot.world.drop_box))
        rospy.Service("~reset", EmptyService, self._on_reset)

    def _on_velocity(self, twist: Twist) -> None:
        self._orders.put(self._robot.command, messages.to_velocity(twist))

    def _on_reset(self, _request) -> EmptyResponse:
        self._orders.put(self._start_over)
        return EmptyResponse()

    def _place(self, pose: Pose) -> None:
        self._robot.place(pose)
        self._node_memory.forget()

    def _start_over(self) -> None:
        self._robot.reset(self._options.seed)
        self._node_memory.forget()

    def _publish_contacts(self) -> None:
        touched = ", ".join(sorted({contact.obstacle for contact in self._robot.contacts}))
        if touched != self._touched:
            self._touched = touched
            self._contacts.publish(touched)

    def _publish_odometry(self, stamp: rospy.Time) -> None:
        pose, velocity = self._robot.pose, self._robot.velocity
        self._odometry.publish(messages.to_odometry(pose, velocity, stamp))
        self._transforms.publish([messages.to_transform(pose, stamp)])
        self._joints.publish(messages.to_joint_state(self._robot.base.rolled, stamp))
