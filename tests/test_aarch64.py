# SPDX-License-Identifier: BSD-3-Clause
"""The kernel for the processors of small robots, which differ from those that this runs on: does it compile?"""
import shutil
import subprocess
from pathlib import Path

import pytest

KERNEL = Path(__file__).resolve().parent.parent / "safety_control_cloud" / "core" / "look" / "kernel" / "scan_simd.cpp"
COMPILER = "aarch64-linux-gnu-g++"
HEADERS = Path("/usr/include")
PORTABLE_HEADERS = ("boost", "eigen3", "hwy")  # and PCL's; all else there is for this machine's processor


@pytest.fixture
def headers(tmp_path):
    """A folder with those headers that fit every processor."""
    for name in PORTABLE_HEADERS:
        if not (HEADERS / name).is_dir():
            pytest.skip(f"{HEADERS / name} is not installed")
        (tmp_path / name).symlink_to(HEADERS / name)
    (tmp_path / "pcl").symlink_to(max(HEADERS.glob("pcl-1.*")))
    return tmp_path


@pytest.mark.skipif(shutil.which(COMPILER) is None, reason=f"{COMPILER} is not installed")
def test_the_kernel_compiles_for_neon(headers, tmp_path):
    search = [f"-I{KERNEL.parent}", *(f"-isystem{headers / folder}" for folder in ("", "pcl", "eigen3"))]
    target = tmp_path / "scan_simd.o"
    result = subprocess.run([COMPILER, "-std=c++17", "-O1", "-c", *search, KERNEL, "-o", target], stderr=subprocess.PIPE, text=True)
    assert result.returncode == 0, result.stderr[-5000:]
    assert b"N_NEON" in target.read_bytes()
