# SPDX-License-Identifier: BSD-3-Clause
"""The page: what stands on it, and what a real browser shows of it."""
from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from drives import camera, depth, wall, write_drive
from PIL import Image

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
ZONES = {"Safe": (46, 158, 91), "Warning": (232, 163, 23), "Danger": (214, 69, 69)}
RING, CORRIDOR_GREEN = (255, 43, 43), 40


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Path:
    """Of a drive by depth images, one by clouds with a gap, and a bag that cannot be read; by two settings."""
    folder = tmp_path_factory.mktemp("page")
    bags = folder / "bags & more"
    bags.mkdir()
    records = []
    for number in range(16):
        picture = np.full((120, 160), 2000 - 100 * number, np.uint16)
        picture[:, :30] = 3500
        records += [depth(0.1 * number, picture), camera(0.1 * number, 160, 120, 140.0)]
    write_drive(bags / "depth.bag", records)
    write_drive(bags / "clouds.bag", [wall(0.1 * n + (2.0 if n > 20 else 0.0), 2.0 - 0.04 * n) for n in range(36)])
    (bags / "broken.bag").write_bytes((bags / "clouds.bag").read_bytes()[:-50])
    for name, distance in (("now", 0.5), ("wider", 0.8)):
        (folder / f"{name}.yaml").write_text(f"danger_distance: {distance}\n")
    result = subprocess.run(
        [sys.executable, "-m", "safety_control_cloud.judge", bags, "--out", folder / "out", "--report", folder / "page",
         "--param", "min_points=4", "--compare", folder / "now.yaml", folder / "wider.yaml"], capture_output=True, text=True, timeout=300)
    assert result.returncode == 1 and "report:" in result.stdout, result.stderr
    return folder / "page" / "index.html"


def test_the_page_needs_nothing_but_itself(page):
    text = page.read_text()

    assert "<script" not in text and "http" not in re.sub(r"data:[^\"]*", "", text)
    assert set(re.findall(r'src="([^:]*):', text)) == {"data"}
    assert [file.name for file in page.parent.iterdir()] == ["index.html"]


def test_the_page_has_bags_causes_distances_calls_and_changes(page):
    text = page.read_text()

    assert "bags &amp; more/broken.bag" in text and 'class="error"' in text
    assert text.count("<h2>The nearest calls</h2>") == 2 and "What changes" in text
    assert "<th>SEEN</th>" in text and "<th>SILENT</th>" in text
    calls = [float(found) for found in re.findall(r">(\d\.\d{3}) m, (?:Safe|Warning|Danger)", text.split("<h2>")[4])]
    assert calls == sorted(calls) and calls[0] == pytest.approx(0.5)
    commands = re.findall(r"<code>scripts/replay (.*?)</code>", text)
    assert commands and all("--around" in command and "--settings" in command and "--param min_points=4" in command for command in commands)


@pytest.mark.skipif(CHROMIUM is None, reason="no chromium")
def test_a_browser_shows_zones_and_what_the_camera_saw(page, tmp_path):
    picture = tmp_path / "page.png"
    subprocess.run(
        [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
         f"--user-data-dir={tmp_path / 'profile'}", "--window-size=1280,2400", f"--screenshot={picture}", page.as_uri()],
        capture_output=True, timeout=240, check=True)

    shown = np.asarray(Image.open(picture).convert("RGB")).astype(int)
    for zone, colour in ZONES.items():
        assert (np.abs(shown - colour).sum(axis=-1) < 6).sum() > 1000, zone
    assert (np.abs(shown - RING).sum(axis=-1) < 30).sum() > 100  # round the point that decides
    assert (shown[..., 1] - np.maximum(shown[..., 0], shown[..., 2]) > CORRIDOR_GREEN).sum() > 20_000  # the corridor
