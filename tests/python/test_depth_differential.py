# SPDX-License-Identifier: BSD-3-Clause
"""A depth image == the cloud that depth_image_proc makes of it, by one pass, PCL and numpy, on random images."""
from dataclasses import dataclass
from typing import Tuple

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import sights
from safety_control_cloud import core

pytestmark = pytest.mark.usefixtures("best_instruction_set_afterwards")

LIMITS = core.Settings(depth_minus_inf="nothing")  # the one point in which the node means something else by default


@dataclass(frozen=True)
class Camera:
    """Without distortion [px]."""

    fx: float
    fy: float
    cx: float
    cy: float

    def cloud_of(self, image: np.ndarray) -> core.Cloud:
        return core.Cloud.of_depth(image, self.fx, self.fy, self.cx, self.cy)

    def points_of(self, image: np.ndarray) -> np.ndarray:
        """(H, W, 3) float32: the operations of depth_image_proc 1.17, float32 in every step."""
        f32 = np.float32
        millimetres = image.dtype.kind == "u"
        unit = f32(0.001) if millimetres else f32(1)
        x_scale, y_scale = f32(float(unit) / self.fx), f32(float(unit) / self.fy)
        depth = np.where(image != 0 if millimetres else np.isfinite(image), image, np.nan).astype(f32)
        v, u = np.indices(image.shape).astype(f32)
        with np.errstate(over="ignore", invalid="ignore"):
            x, y = (u - f32(self.cx)) * depth * x_scale, (v - f32(self.cy)) * depth * y_scale
        return np.stack([x, y, depth * unit if millimetres else depth], axis=-1)

    def edges(self, shape: Tuple[int, int]) -> np.ndarray:
        """(4, H, W) float64: the depths at which each pixel's ray meets a limit of the corridor."""
        v, u = np.indices(shape)
        with np.errstate(divide="ignore", over="ignore"):
            across = [limit * self.fx / (u - self.cx) for limit in (LIMITS.x_min, LIMITS.x_max)]
            down = [limit * self.fy / (v - self.cy) for limit in (LIMITS.y_min, LIMITS.y_max)]
        return np.stack(across + down)


@dataclass(frozen=True)
class Picture:
    """As a camera would send it, with every other pixel on an edge of the corridor or one number beside it."""

    seed: int
    shape: Tuple[int, int]
    dtype: str
    camera: Camera

    def image(self) -> np.ndarray:
        random = np.random.default_rng(self.seed)
        edge = np.choose(random.integers(0, 4, self.shape), self.camera.edges(self.shape))
        odd = random.choice([np.nan, np.inf, -np.inf, 0.0, -0.0, -1.0, 1e-45, 3.4e38], self.shape)
        plain = random.uniform(0.2, 3.0, self.shape)
        metres = np.choose(random.integers(0, 4, self.shape), [plain, edge, edge, odd])
        beside = random.integers(-1, 2, self.shape)
        if np.dtype(self.dtype).kind == "u":
            millimetres = np.nan_to_num(np.rint(metres * 1000), nan=0, posinf=65535, neginf=0)
            return np.clip(millimetres + beside, 0, 65535).astype(self.dtype)
        with np.errstate(over="ignore"):
            metres = metres.astype(np.float32)
            return np.where(beside == 0, metres, np.nextafter(metres, np.float32(9) * beside)).astype(self.dtype)


cameras = st.builds(
    Camera,
    fx=st.sampled_from([554.254691191187, 525.0, 30.0]),
    fy=st.sampled_from([554.254691191187, 525.0, 41.5]),
    cx=st.sampled_from([319.5, 31.5, 12.0]) | st.floats(-5, 700),
    cy=st.sampled_from([239.5, 2.5, 3.0]) | st.floats(-5, 500),
)
pictures = st.builds(
    Picture,
    seed=st.integers(0, 2**32 - 1),
    shape=st.tuples(st.integers(0, 9), st.integers(0, 70) | st.integers(630, 650) | st.integers(1000, 1100)),
    dtype=st.sampled_from(["<f4", "<u2", ">f4", ">u2"]),
    camera=cameras,
)


def facts_of(sight: core.Sight) -> Tuple[object, ...]:
    """With the crop."""
    return (*sights.facts_of(sight), sight.crop.tobytes())


def numpy_facts(points: np.ndarray) -> Tuple[object, ...]:
    flat = points.reshape(-1, 3)
    x, y, z = flat.T
    returns = np.isfinite(flat).all(axis=1) & (z > 0)
    low_x, high_x, low_y, high_y = (np.float32(getattr(LIMITS, name)) for name in ("x_min", "x_max", "y_min", "y_max"))
    inside = flat[returns & (x >= low_x) & (x <= high_x) & (y >= low_y) & (y <= high_y)]
    nearest = tuple(inside[np.argmin(inside[:, 2])].tolist()) if len(inside) else None
    return (nearest, len(inside), 0, int(returns.sum()), len(flat), inside.tobytes())


@given(pictures)
@settings(max_examples=300, deadline=None, print_blob=True)
def test_an_image_shows_what_its_cloud_shows(picture):
    image = picture.image()
    points = picture.camera.points_of(image)
    expected = numpy_facts(points)
    assert facts_of(core.passthrough(points, crop=True)) == expected
    assert facts_of(core.passthrough(picture.camera.cloud_of(image), LIMITS, crop=True)) == expected
    for name in [*core.instruction_sets(), ""]:
        core.use_instruction_set(name)
        assert facts_of(core.look(picture.camera.cloud_of(image), LIMITS, crop=True)) == expected, name


@given(pictures)
@settings(max_examples=300, deadline=None, print_blob=True)
def test_minus_inf_is_too_close_and_all_else_as_ever(picture):
    image = picture.image()
    *seen, too_close, returns, total, crop = numpy_facts(picture.camera.points_of(image))
    too_close = int(np.isneginf(image).sum()) if image.dtype.kind == "f" else 0
    expected = ((0.0, 0.0, 0.0) if too_close else seen[0], seen[1], too_close, returns, total, crop)
    assert facts_of(core.passthrough(picture.camera.cloud_of(image), crop=True)) == expected
    for name in [*core.instruction_sets(), ""]:
        core.use_instruction_set(name)
        assert facts_of(core.look(picture.camera.cloud_of(image), crop=True)) == expected, name


@pytest.mark.parametrize("method", ["one_pass", "pcl"])
def test_a_sequence_of_images_is_decided_as_its_clouds_are(method):
    camera = Camera(55.4, 55.4, 31.5, 23.5)
    by_depth, by_cloud = (core.SafetyControl(core.Settings(method=method)) for _ in range(2))
    causes = set()
    for seed in range(60):
        random = np.random.default_rng(seed)
        image = np.full((48, 64), 2.0, np.float32)
        row, column = random.integers(0, 32, 2)
        image[row : row + 16, column : column + 20] = random.choice([0.45, 0.6, np.nan, 2.0])
        image[random.random(image.shape) < random.choice([0.0, 0.2, 0.95])] = np.nan
        seen = by_depth.decide(camera.cloud_of(image), now=seed / 20)
        expected = by_cloud.decide(camera.points_of(image), now=seed / 20)
        assert (seen.cause.name, seen.zone.name, seen.reason) == (expected.cause.name, expected.zone.name, expected.reason)
        causes.add(seen.cause.name)
    assert causes == {"SEEN", "BLIND", "NEAR_LOSS"}


@pytest.mark.parametrize("image", [np.zeros((4, 4), np.float64), np.zeros((4, 4), np.uint8), np.zeros((4, 4), np.int16)])
def test_pixels_that_are_no_depths_are_refused(image):
    with pytest.raises(TypeError):
        core.Cloud.of_depth(image, 1, 1, 0, 0)


@pytest.mark.parametrize("image", [np.zeros(4, np.uint16), np.zeros((4, 8), np.uint16)[:, ::2], np.zeros((4, 4), np.uint16)[::-1]])
def test_an_image_that_cannot_be_borrowed_is_refused(image):
    with pytest.raises(ValueError):
        core.Cloud.of_depth(image, 1, 1, 0, 0)
