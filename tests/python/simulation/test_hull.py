# SPDX-License-Identifier: BSD-3-Clause
"""What the hull touches, by geometry, is what MuJoCo finds."""
import mujoco
import numpy as np
import pytest

from safety_control_cloud.simulation.base import Pose
from safety_control_cloud.simulation.furniture import Place, Shape, Thing, furniture_of
from safety_control_cloud.simulation.hull import BODY_RADIUS, TOWER_RADIUS, distances, touched
from safety_control_cloud.simulation.world import World
from safety_control_cloud.simulation.world_files import world_file, world_names

VERSION = tuple(int(part) for part in mujoco.__version__.split(".")[:2])
PRECISION = 1e-5 if VERSION >= (3, 3) else 5e-3  # [m] 3.2.3, that of older Pythons, tells cylinders up to 4 mm too far apart


def standing(z, half=0.05):
    """A board of 1 m x 1 m, 2 * half thick, its centre at z [m], its edge 1 m ahead."""
    return [Thing("board", Place(1.5, 0, z), (Shape("board", "box", (0.5, 0.5, half), Place()),))]


@pytest.mark.parametrize("name", world_names())
def test_the_hull_is_as_far_from_the_furniture_as_in_mujoco(name):
    world, furniture = World.load(name), furniture_of(world_file(name))
    random = np.random.default_rng(0)
    nearer = 0
    for x, y, yaw in zip(random.uniform(-4, 4, 300), random.uniform(-4, 4, 300), random.uniform(-3, 3, 300)):
        pose = Pose(x, y, yaw)
        world.place_robot(pose)
        theirs = world.clearance(2.0)
        ours = min([2.0, *(distance for _, distance in distances(furniture.things, pose))])
        nearer += theirs < 2.0
        if theirs > 0:
            assert ours == pytest.approx(theirs, abs=PRECISION), pose
        else:
            assert ours <= 0, pose
    assert name == "hall" or nearer > 30


def test_a_board_touches_the_kobuki_the_tower_or_passes_over_both():
    at_kobuki, at_tower = Pose(1.0 - BODY_RADIUS + 0.001), Pose(1.0 - TOWER_RADIUS + 0.001)
    assert touched(standing(0.07), at_kobuki) == ("board",)
    assert touched(standing(0.3), at_kobuki) == ()
    assert touched(standing(0.3), at_tower) == ("board",)
    assert touched(standing(0.46), at_tower) == ()


def test_what_is_nearly_touched_counts_if_asked_for():
    short_of = Pose(1.0 - BODY_RADIUS - 0.001)
    assert touched(standing(0.07), short_of) == ()
    assert touched(standing(0.07), short_of, nearer_than=0.002) == ("board",)


def test_a_moved_thing_is_touched_where_it_is():
    moved = Thing("cart", Place(0, 3, 0, 0.7), (Shape("cart", "cylinder", (0.1, 0.5), Place(1, 0, 0.5)),))
    beside = Pose(np.cos(0.7), 3 + np.sin(0.7) - 0.1 - BODY_RADIUS + 0.001)
    assert touched([moved], beside) == ("cart",)
