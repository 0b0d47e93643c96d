# SPDX-License-Identifier: BSD-3-Clause
"""A scenario set up: its world, its robot, its camera, and the truth about the corridor."""
from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..simulation.base import Pose, pitch_at
from ..simulation.gl import mujoco
from ..simulation.robot import GROUP
from ..simulation.turtlebot import TurtleBot
from ..simulation.world import World
from .scenario import XTION, Scenario, random_of
from .things import Surface

if TYPE_CHECKING:
    from numpy.typing import NDArray  # not in the numpy of Ubuntu 20.04

FREE_TO = 1.2  # [m] from the camera: nothing in the corridor nearer than this, and standing in Danger is wrong
_CORRIDOR = "true_corridor"
_HALF_WIDTH = 0.305  # [m] the corridor's 0.30 and the camera's noise
_HIGH = 0.57  # [m] above the floor: y from -0.25 and what the pitch makes of it
_LOW = 0.03  # [m] above the floor: lower than what the robot is to stand for, higher than what it climbs
_UNSEEN = 4  # MuJoCo's camera does not draw this group
# No textures and no buffer for shadows, which the camera does not draw: making the renderer takes a tenth of the time.
_SCENERY = '<visual><headlight ambient="0.5 0.5 0.5"/><quality shadowsize="0"/></visual>'
_FLOOR = '<geom name="floor" type="plane" size="20 20 1" rgba="0.62 0.61 0.58 1"/>'
_HIDES = 0.95  # a picture nearer than this share of another has something before it


class Stage:
    """Use it in one thread, and `close` it."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._world = World.from_xml(_mjcf(scenario), replace(XTION, stray=scenario.stray), scenario.hull)
        model = self._world.model
        self._geoms = {thing.name: model.geom(thing.name).id for thing in scenario.things}
        self._mocaps = [(thing, model.body(thing.name).mocapid[0]) for thing in scenario.things if thing.path]
        self._corridor = model.geom(_CORRIDOR).id
        self._group(Surface.GLASS, _UNSEEN)
        self._random = random_of(scenario.family, scenario.seed, purpose=1)
        self.robot = TurtleBot(self._world, seed=scenario.seed)
        self.robot.place(scenario.start)

    def close(self) -> None:
        self.robot.close()

    def move_things(self, time: float) -> None:
        """To where they are at `time` [s]; the robot's next step sees them there."""
        for thing, mocap in self._mocaps:
            self._world.data.mocap_pos[mocap, :2] = thing.place(time)

    def picture(self) -> NDArray[np.float32]:
        """What the camera measures now [m], with what the scenario lets go wrong."""
        self._pitch_over_bumps()
        depth = self.robot.depth()
        if any(thing.surface is Surface.BLACK for thing in self._scenario.things):
            depth = self._without_black(depth)
        return self._scenario.faults.marred(depth, self._random)

    def colour(self) -> NDArray[np.uint8]:
        """(height, width, 3) red, green, blue, from the camera."""
        return self.robot.colour()

    def corridor_is_free(self) -> bool:
        """To FREE_TO, whatever the camera makes of it: glass and black things are there too."""
        x, y, _ = XTION.mount
        pose, ahead = self.robot.pose, XTION.mount[0] + FREE_TO / 2
        cos, sin = np.cos(pose.yaw), np.sin(pose.yaw)
        self._world.move(_CORRIDOR, Pose(pose.x + ahead * cos - y * sin, pose.y + ahead * sin + y * cos, pose.yaw))
        return all(self._distance(geom) > 0 for geom in self._geoms.values())

    def clearance(self) -> float:
        """[m] from the robot's hull to the nearest thing; at most 1."""
        return self._world.clearance()

    def _distance(self, geom: int) -> float:
        return mujoco.mj_geomDistance(self._world.model, self._world.data, self._corridor, geom, 1e-3, None)

    def _pitch_over_bumps(self) -> None:
        pitch = self._scenario.faults.pitch(self.robot.time)
        if abs(pitch) > 1e-4:
            base = self.robot.base
            self._world.place_robot(base.pose, pitch_at(base.velocity.linear, base.pitch_phase) + pitch)

    def _without_black(self, depth: NDArray[np.float32]) -> NDArray[np.float32]:
        """Nothing where the picture without the black things shows something farther away, or nothing."""
        self._group(Surface.BLACK, _UNSEEN)
        beyond = self.robot.depth()
        self._group(Surface.BLACK, 0)
        hidden = (depth < _HIDES * beyond) | np.isnan(beyond)
        return np.where(hidden, np.float32(np.nan), depth)

    def _group(self, surface: Surface, group: int) -> None:
        for thing in self._scenario.things:
            if thing.surface is surface:
                self._world.model.geom_group[self._geoms[thing.name]] = group


def _mjcf(scenario: Scenario) -> str:
    half = f"{FREE_TO / 2} {_HALF_WIDTH} {(_HIGH - _LOW) / 2}"
    corridor = (
        f'<body name="{_CORRIDOR}" mocap="true" pos="0 0 {(_LOW + _HIGH) / 2}"><geom name="{_CORRIDOR}" type="box" '
        f'size="{half}" contype="0" conaffinity="0" group="{GROUP}"/></body>'
    )
    bodies = "".join(thing.mjcf for thing in scenario.things)
    return f"<mujoco>{_SCENERY}<worldbody>{_FLOOR}{corridor}{bodies}</worldbody></mujoco>"
