# SPDX-License-Identifier: BSD-3-Clause
"""Models in a running Gazebo: the robot is put elsewhere, boxes are dropped and taken away."""
from __future__ import annotations

from itertools import count
from xml.etree import ElementTree

import rospy
from gazebo_msgs.msg import ModelState
from gazebo_msgs.srv import DeleteModel, SetModelState, SpawnModel

from ..simulation.base import Pose
from ..simulation.furniture import BOX_COLOUR, BOX_SIDE, BOXES, Place, Shape, Thing
from ..simulation.sdf import ROBOT, to_model
from . import messages

_WORLD = "world"  # the frame that Gazebo calls so


def place_robot(pose: Pose) -> None:
    """Lift the robot and put it down at `pose`, at rest. Raises ServiceException."""
    state = ModelState(model_name=ROBOT, reference_frame=_WORLD)
    state.pose = messages.to_ros_pose(pose)
    _call("set_model_state", SetModelState, state)


def spawn(thing: Thing) -> None:
    """Raises ServiceException, as if there is one of this name."""
    xml = f'<sdf version="1.7">{ElementTree.tostring(to_model(thing), encoding="unicode")}</sdf>'
    at = thing.place
    _call("spawn_sdf_model", SpawnModel, thing.name, xml, "", messages.to_ros_pose(Pose(at.x, at.y, at.yaw), at.z), _WORLD)


def delete(name: str) -> None:
    """Raises ServiceException, as if there is none."""
    _call("delete_model", DeleteModel, name)


class DroppedBoxes:
    """As many as BOXES; the next one takes the oldest's place."""

    def __init__(self) -> None:
        self.things: tuple[Thing, ...] = ()
        self._number = count()

    def drop(self, x: float, y: float) -> None:
        """Stand a box on the floor, its centre above (x, y) [m]. Raises ServiceException."""
        if len(self.things) == BOXES:
            self._take_away(self.things[0])
        box = _box(f"dropped_box_{next(self._number)}", x, y)
        spawn(box)
        self.things += (box,)

    def clear(self) -> None:
        """Raises ServiceException."""
        for box in self.things:
            self._take_away(box)

    def _take_away(self, box: Thing) -> None:
        self.things = tuple(thing for thing in self.things if thing is not box)
        delete(box.name)


def _box(name: str, x: float, y: float) -> Thing:
    half = BOX_SIDE / 2
    return Thing(name, Place(x, y, half), (Shape(name, "box", (half, half, half), Place(), BOX_COLOUR),))


def _call(service: str, kind: type, *arguments) -> None:
    rospy.wait_for_service(f"/gazebo/{service}", timeout=30)
    answer = rospy.ServiceProxy(f"/gazebo/{service}", kind)(*arguments)
    if not answer.success:
        raise rospy.ServiceException(f"{service}: {answer.status_message}")
