# SPDX-License-Identifier: BSD-3-Clause
"""One pass == PCL == numpy, on random clouds of every layout."""
from dataclasses import dataclass, field
from typing import Callable, Iterator, Optional, Tuple

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from sights import facts_of
from safety_control_cloud import core

pytestmark = pytest.mark.usefixtures("best_instruction_set_afterwards")

FLOAT32, FLOAT64 = 7, 8
LIMITS = core.Settings()
ON_THE_LIMITS = [LIMITS.x_min, LIMITS.x_max, LIMITS.y_min, LIMITS.y_max, 0.5, 1.0]
BESIDE_THE_LIMITS = [np.nextafter(np.float32(v), np.float32(t)) for v in ON_THE_LIMITS for t in (-9, 9)]
ODD = [np.nan, np.inf, -np.inf, 0.0, -0.0, 1e-45, -1e-45, 3.4e38, -3.4e38, -1.0]


@dataclass(frozen=True)
class LayoutUnderTest:
    """Where x, y, z lie in a point, and what lies around them."""

    scalar: str  # numpy type without byte order: f4 or f8
    offsets: Tuple[int, int, int]
    point_step: int
    row_padding: int = 0
    is_bigendian: bool = False

    def cloud(self, points: np.ndarray, noise: np.random.Generator) -> core.Cloud:
        """(H, W, 3) float32 points laid out so, with noise in every byte that is not theirs."""
        height, width, _ = points.shape
        row_step = width * self.point_step + self.row_padding
        data = noise.integers(0, 256, height * row_step, dtype=np.uint8)
        dtype = np.dtype((">" if self.is_bigendian else "<") + self.scalar)
        for axis, offset in enumerate(self.offsets if points.size else ()):
            np.ndarray(points.shape[:2], dtype, data, offset, (row_step, self.point_step))[:] = points[..., axis]
        code = FLOAT64 if self.scalar == "f8" else FLOAT32
        fields = [(name, offset, code, 1) for name, offset in zip("xyz", self.offsets)]
        return core.Cloud.of_bytes(data, height, width, fields, self.is_bigendian, self.point_step, row_step)


LAYOUTS = [
    LayoutUnderTest("f4", (0, 4, 8), 12),
    LayoutUnderTest("f4", (0, 4, 8), 16),
    LayoutUnderTest("f4", (0, 4, 8), 20),
    LayoutUnderTest("f4", (0, 4, 8), 32),
    LayoutUnderTest("f4", (0, 4, 8), 48),
    LayoutUnderTest("f4", (16, 20, 24), 32),
    LayoutUnderTest("f4", (8, 4, 0), 12),
    LayoutUnderTest("f4", (3, 7, 11), 15),
    LayoutUnderTest("f4", (20, 1, 9), 26),
    LayoutUnderTest("f4", (0, 4, 8), 12, row_padding=5),
    LayoutUnderTest("f4", (0, 4, 8), 16, row_padding=64),
    LayoutUnderTest("f4", (0, 4, 8), 16, is_bigendian=True),
    LayoutUnderTest("f8", (0, 8, 16), 24),
    LayoutUnderTest("f8", (17, 1, 9), 25, row_padding=3, is_bigendian=True),
]


@dataclass(frozen=True)
class Scene:
    """Points as a real camera would send them, and as none should."""

    seed: int
    height: int
    width: int
    odd_share: float
    min_points: int
    layout: LayoutUnderTest = field(default=LAYOUTS[0])

    def points(self) -> np.ndarray:
        """(height, width, 3) float32."""
        random = np.random.default_rng(self.seed)
        points = random.uniform((-0.6, -0.5, 0.2), (0.6, 0.4, 3.0), (self.height, self.width, 3)).astype(np.float32)
        special = random.choice(np.array(ODD + ON_THE_LIMITS + BESIDE_THE_LIMITS, np.float32), points.shape)
        return np.where(random.random(points.shape) < self.odd_share, special, points)

    def parameters(self) -> core.Settings:
        return core.Settings(min_points=self.min_points)


scenes = st.builds(
    Scene,
    seed=st.integers(0, 2**32 - 1),
    height=st.integers(0, 7),
    width=st.integers(0, 70) | st.integers(1000, 2100),
    odd_share=st.sampled_from([0.0, 0.02, 0.3, 1.0]),
    min_points=st.sampled_from([1, 1, 2, 5, 50]),
    layout=st.sampled_from(LAYOUTS),
)


def numpy_sight(points: np.ndarray, parameters: core.Settings) -> Tuple[Optional[Tuple[float, ...]], int, int, int, int, np.ndarray]:
    """Written from DESIGN section 3 with numpy alone: nearest point, inside, too_close, returns, total, crop."""
    flat = points.reshape(-1, 3)
    x, y, z = flat.T
    low_x, high_x, low_y, high_y = (np.float32(getattr(parameters, n)) for n in ("x_min", "x_max", "y_min", "y_max"))
    beside = (np.isfinite(x) & ((x < low_x) | (x > high_x))) | (np.isfinite(y) & ((y < low_y) | (y > high_y)))
    too_close = int((np.isneginf(z) & ~beside).sum())
    returns = np.isfinite(flat).all(axis=1) & (z > np.float32(parameters.range_min))
    inside = flat[returns & ~beside]
    in_order = np.concatenate([np.zeros((too_close, 3), np.float32), inside[np.argsort(inside[:, 2], kind="stable")]])
    nearest = None
    if len(in_order) >= parameters.min_points:
        depth = in_order[parameters.min_points - 1, 2]
        nearest = (0.0, 0.0, 0.0) if parameters.min_points <= too_close else tuple(inside[inside[:, 2] == depth][0].tolist())
    return nearest, len(inside), too_close, int(returns.sum()), len(flat), inside


def looks() -> Iterator[Tuple[str, Callable[..., core.Sight]]]:
    """Every way to look, with its name; the last of the instruction sets is the best again."""
    yield "PCL", core.passthrough
    for name in [*core.instruction_sets(), ""]:
        core.use_instruction_set(name)
        yield f"one pass {name}", core.look


def assert_all_see_the_same(scene: Scene) -> None:
    points = scene.points()
    cloud = scene.layout.cloud(points, np.random.default_rng(scene.seed))
    *expected, crop = numpy_sight(points, scene.parameters())
    for name, look in looks():
        sight = look(cloud, scene.parameters(), crop=True)
        assert facts_of(sight) == tuple(expected), (name, scene)
        assert sight.crop.tobytes() == crop.tobytes(), (name, scene)
        assert facts_of(look(cloud, scene.parameters())) == tuple(expected), (name, "without the crop", scene)


@given(scenes)
@settings(max_examples=500, deadline=None, print_blob=True)
def test_one_pass_with_every_instruction_set_and_pcl_and_numpy_see_the_same(scene):
    assert_all_see_the_same(scene)


@pytest.mark.slow
def test_not_one_of_ten_thousand_random_clouds_is_seen_differently():
    for seed in range(10_000):
        random = np.random.default_rng(seed)
        height, width = (int(random.integers(limit)) for limit in random.permutation([8, 90]))
        if seed % 20 == 0:
            height, width = 2, int(random.integers(1000, 2100))  # more than a run
        odd_share, min_points = random.choice([0.0, 0.02, 0.3, 1.0]), int(random.choice([1, 1, 2, 5, 50]))
        assert_all_see_the_same(Scene(seed, height, width, odd_share, min_points, LAYOUTS[seed % len(LAYOUTS)]))


@given(scenes)
@settings(max_examples=200, deadline=None, print_blob=True)
def test_the_layout_of_a_cloud_never_changes_what_is_seen(scene):
    points = scene.points()
    seen = {
        facts_of(look(layout.cloud(points, np.random.default_rng(scene.seed)), scene.parameters()))
        for layout in LAYOUTS
        for look in (core.look, core.passthrough)
    }
    assert len(seen) == 1


@given(near=st.floats(2**-10, 8, width=32), far=st.floats(2**-10, 8, width=32))
def test_a_nearer_obstacle_never_means_a_faster_robot(near, far):
    near, far = sorted((near, far))
    speed = [core.SafetyControl().decide(np.array([[0, 0, z]], np.float32), now=1.0).speed for z in (near, far)]
    assert speed[0] <= speed[1]


@pytest.mark.parametrize("method", ["one_pass", "pcl"])
def test_every_decision_is_made_by_the_method_that_was_asked_for(method):
    points = Scene(seed=7, height=24, width=32, odd_share=0.2, min_points=1).points()
    decision = core.SafetyControl(core.Settings(method=method)).decide(points, now=1.0)
    *expected, _ = numpy_sight(points, core.Settings())
    assert facts_of(decision.sight) == tuple(expected)
