# SPDX-License-Identifier: BSD-3-Clause
"""A world for Gazebo: the same furniture as MuJoCo's, written as SDF, and the robot of the URDF in it."""
from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from .base import Pose
from .furniture import Furniture, Place, Shape, Thing

ROBOT = "turtlebot"  # the model's name in Gazebo
STEP = 0.001  # [s] of Gazebo's physics
_SKY = "0.86 0.90 0.94 1"
_SUN = "0.45 -0.35 -0.82"  # as in worlds/_scenery.xml
_EYE, _EYE_PITCH = Place(-0.9, -2.3, 1.5, 0.95), 0.40  # [m, rad] gzclient's, beside the robot's start
_CONFIG = "<model><name>{0}</name><version>1.0</version><sdf version=\"1.7\">{0}.urdf</sdf></model>\n".format(ROBOT)


def write_world(furniture: Furniture, urdf: Path, size: tuple[int, int], rate: float, folder: Path) -> Path:
    """Write what Gazebo loads into `folder`, and return the world's file.

    `size` [px] is that of the camera's pictures, `rate` how many simulated seconds a real one has; 0 means as many as go.
    """
    robot = folder / ROBOT
    robot.mkdir()
    (robot / "model.config").write_text(_CONFIG)
    (robot / f"{ROBOT}.urdf").write_text(_with_pictures_of(urdf, size))
    world = folder / "turtlebot.world"
    world.write_text(to_world(furniture, f"file://{robot}", rate))
    return world


def to_world(furniture: Furniture, robot_uri: str, rate: float = 1.0) -> str:
    """SDF. The robot is included from the folder that `robot_uri` names."""
    root = Element("sdf", version="1.7")
    world = SubElement(root, "world", name="default")
    physics = SubElement(world, "physics", type="ode")
    _tell(physics, max_step_size=STEP, real_time_update_rate=rate / STEP, real_time_factor=rate or 1.0)
    _tell(SubElement(world, "scene"), ambient="0.5 0.5 0.5 1", background=_SKY, shadows="false")
    sun = SubElement(world, "light", type="directional", name="sun")
    _tell(sun, pose="0 0 10 0 0 0", cast_shadows="false", diffuse="0.7 0.7 0.66 1", specular="0.1 0.1 0.1 1", direction=_SUN)
    eye = SubElement(SubElement(world, "gui"), "camera", name="user_camera")
    _tell(eye, pose=_pose(_at(furniture.start).of(_EYE), _EYE_PITCH))
    for thing in furniture.things:
        world.append(to_model(thing))
    robot = SubElement(world, "include")
    _tell(robot, uri=robot_uri, name=ROBOT, pose=_pose(_at(furniture.start)))
    return ElementTree.tostring(root, encoding="unicode")


def to_model(thing: Thing) -> Element:
    """Static: nothing falls or is pushed away, as in MuJoCo."""
    model = Element("model", name=thing.name)
    _tell(model, static="true", pose=_pose(thing.place))
    link = SubElement(model, "link", name="link")
    for shape in thing.shapes:
        for tag in ("collision", "visual"):
            part = SubElement(link, tag, name=shape.name)
            _tell(part, pose=_pose(shape.place))
            part.append(_geometry(shape))
            if tag == "visual":
                colour = _text(shape.colour)
                _tell(SubElement(part, "material"), ambient=colour, diffuse=colour)
    return model


def _geometry(shape: Shape) -> Element:
    geometry = Element("geometry")
    form = SubElement(geometry, shape.kind)
    if shape.kind == "box":
        _tell(form, size=_text(2 * half for half in shape.size))
    elif shape.kind == "cylinder":
        _tell(form, radius=shape.size[0], length=2 * shape.size[1])
    else:
        _tell(form, normal="0 0 1", size=_text(2 * half for half in shape.size[:2]))
    return geometry


def _with_pictures_of(urdf: Path, size: tuple[int, int]) -> str:
    robot = ElementTree.parse(urdf)
    for image in robot.iter("image"):
        for tag, pixels in zip(("width", "height"), size):
            image.find(tag).text = str(pixels)  # type: ignore[union-attr]
    return ElementTree.tostring(robot.getroot(), encoding="unicode")


def _tell(parent: Element, **texts: object) -> None:
    for tag, text in texts.items():
        SubElement(parent, tag).text = str(text)


def _at(pose: Pose) -> Place:
    return Place(pose.x, pose.y, 0.0, pose.yaw)


def _pose(place: Place, pitch: float = 0.0) -> str:
    return _text((place.x, place.y, place.z, 0, pitch, place.yaw))


def _text(numbers) -> str:
    return " ".join(f"{number:.9g}" for number in numbers)
