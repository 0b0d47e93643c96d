# SPDX-License-Identifier: BSD-3-Clause
"""What a cloud becomes before it is shown; without the viewer."""
from __future__ import annotations

import argparse

import numpy as np
import pytest

from safety_control_cloud import core, optional
from safety_control_cloud.optional import MissingPackages
from safety_control_cloud.view import open as view_open
from safety_control_cloud.view.memory import spots_in
from safety_control_cloud.pinhole import Pinhole
from safety_control_cloud.view.moment import Depth, Points
from safety_control_cloud.view.options import make, recorded_in, writable
from safety_control_cloud.view.picture import camera_of, depth_of, picture_of, thinned


def seen(metres: np.ndarray, lens: Pinhole) -> np.ndarray:
    v, u = np.indices(metres.shape, np.float32)
    return np.stack([(u - lens.cx) / lens.fx * metres, (v - lens.cy) / lens.fy * metres, metres], -1).astype(np.float32)


def room() -> np.ndarray:
    metres = np.random.default_rng(3).uniform(0.5, 4.0, (48, 64)).astype(np.float32)
    metres[10:20, 5:30] = np.nan
    return metres


LENS = Pinhole(55.0, 54.0, 31.0, 23.5)


def test_an_organised_cloud_becomes_the_depth_image_it_was_made_of():
    picture = picture_of(seen(room(), LENS))

    assert isinstance(picture, Depth)
    assert np.allclose([picture.camera.fx, picture.camera.fy, picture.camera.cx, picture.camera.cy], [55.0, 54.0, 31.0, 23.5], atol=1e-3)
    assert np.abs(picture.millimetres - 1000 * np.nan_to_num(room())).max() <= 0.51


@pytest.mark.parametrize("spoil", [lambda p: p.reshape(1, -1, 3), lambda p: p[:, ::-1], lambda p: p[..., ::-1], lambda p: p + np.float32(0.1)])
def test_what_is_no_pinhole_cameras_stays_points(spoil):
    points = np.ascontiguousarray(spoil(seen(room(), LENS)))

    picture = picture_of(points)

    assert isinstance(picture, Points) and np.isfinite(picture.xyz).all()
    assert len(picture.xyz) == np.isfinite(points).all(axis=-1).sum()


def test_a_picture_that_returns_nothing_is_of_the_camera_of_the_one_before():
    empty = np.full((48, 64, 3), np.nan, np.float32)

    assert isinstance(picture_of(empty), Points)
    after = picture_of(empty, picture_of(seen(room(), LENS)))
    assert isinstance(after, Depth) and not after.millimetres.any()


@pytest.mark.parametrize("nowhere", [0.0, -1.0, np.nan, np.inf, -np.inf, 70.0])
def test_no_return_is_0_and_never_another_distance(nowhere):
    assert not depth_of(np.full((2, 2), nowhere, np.float32), LENS).millimetres.any()


def test_a_thinned_picture_is_of_the_same_camera():
    small = thinned(picture_of(seen(room(), LENS)), 500)

    assert small.millimetres.size <= 500
    wide = camera_of(seen(np.where(small.millimetres, small.millimetres / 1000, np.nan).astype(np.float32), small.camera))
    assert wide.fx == pytest.approx(small.camera.fx, rel=1e-3) and wide.cx == pytest.approx(small.camera.cx, abs=1e-2)
    assert len(thinned(Points(np.zeros((1001, 3), np.float32)), 500).xyz) <= 500


def test_what_the_core_remembers_is_where_it_was_seen():
    control = core.SafetyControl()
    assert len(spots_in(control.remembered())) == 0
    for number in range(5):
        metres = np.full((48, 64), 3.0, np.float32)
        metres[15:35, 20:40] = 0.6
        control.decide(seen(metres, LENS), now=1.0 + 0.1 * number)

    spots = spots_in(control.remembered())

    assert len(spots) and np.allclose(spots[:, 2], 0.6, atol=0.02) and (np.abs(spots[:, :2]) < 0.3).all()
    assert np.array_equal(spots_in([f"front\nfacing 0.8 {text}" for text in control.remembered()]), spots)
    assert np.array_equal(spots_in([*control.remembered(), "touched-1 1 bumper front end", "places-3 1 1 0 0 0 0 end"]), spots)


@pytest.mark.parametrize("text", ["", "things-2 1 1 1", "things-4", "things-4 64 48 0.4 1 2 0 1 3 4", "things-4 64 48 0.4 x"])
def test_a_text_that_is_not_understood_is_nothing(text):
    assert spots_in([text]).shape == (0, 3)


def test_what_is_missing_is_named_with_its_command(monkeypatch, tmp_path):
    monkeypatch.setattr(optional, "find_spec", lambda name: None)

    with pytest.raises(MissingPackages, match="rerun.*scripts/setup --with view"):
        with recorded_in(tmp_path / "a.rrd", False):
            raise AssertionError("it went on")


def test_a_window_where_there_is_a_screen_and_a_browser_where_there_is_none(tmp_path, monkeypatch):
    monkeypatch.setattr(view_open, "viewer", lambda: "rerun")

    assert "--serve-web" not in view_open.command(tmp_path, {"DISPLAY": ":0"}) and "--serve-web" in view_open.command(tmp_path, {"DISPLAY": ""})


def test_what_can_be_written_is_left_as_it_was(tmp_path):
    (tmp_path / "there").write_text("content")

    assert writable(str(tmp_path / "there")).read_text() == "content"
    assert not writable(str(tmp_path / "new")).exists()
    make(tmp_path / "a" / "b", argparse.ArgumentParser())
    assert (tmp_path / "a" / "b").is_dir()
