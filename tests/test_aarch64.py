# SPDX-License-Identifier: BSD-3-Clause
"""The kernels for the processors of small robots, which differ from those that this runs on: does it compile?"""
import shutil
import subprocess
from pathlib import Path

import pytest

CORE = Path(__file__).resolve().parent.parent / "safety_control_cloud" / "core"
KERNELS = [CORE / "look" / "kernel" / "scan_simd.cpp", *sorted((CORE / "memory" / "kernel").glob("*_simd.cpp"))]
COMPILER = "aarch64-linux-gnu-g++"
HEADERS = Path("/usr/include")
PORTABLE_HEADERS = ("boost", "eigen3")  # and PCL's; all else there is for this machine's processor


@pytest.fixture
def headers(tmp_path):
    """A folder with those headers that fit every processor."""
    for name in PORTABLE_HEADERS:
        (tmp_path / name).symlink_to(HEADERS / name)
    (tmp_path / "pcl").symlink_to(max(HEADERS.glob("pcl-1.*")))
    return tmp_path


@pytest.mark.skipif(shutil.which(COMPILER) is None, reason=f"{COMPILER} is not installed")
@pytest.mark.parametrize("highway", [HEADERS, CORE / "look" / "without_highway"], ids=["highway", "without_highway"])
@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.stem)
def test_a_kernel_compiles_for_neon(kernel, highway, headers, tmp_path):
    if not (highway / "hwy").is_dir():
        pytest.skip(f"{highway / 'hwy'} is not installed")
    (headers / "hwy").symlink_to(highway / "hwy")
    search = [f"-I{kernel.parent}", *(f"-isystem{headers / folder}" for folder in ("", "pcl", "eigen3"))]
    target = tmp_path / "kernel.o"
    result = subprocess.run([COMPILER, "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-c", *search, kernel, "-o", target], stderr=subprocess.PIPE, text=True)
    assert result.returncode == 0, result.stderr[-5000:]
    assert b"_NEON" in target.read_bytes()
