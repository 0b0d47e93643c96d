# SPDX-License-Identifier: BSD-3-Clause
"""The package's own files."""
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "safety_control_cloud"
CORE = SOURCES / "core"
PYTHON = SOURCES / "python" / "safety_control_cloud"


def files(folder, *endings):
    return [
        pytest.param(file, id=str(file.relative_to(ROOT)))
        for file in sorted(folder.rglob("*"))
        if file.suffix in endings and file.is_file()
    ]


def tracked_files():
    try:
        listing = subprocess.run(
            ["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "ls-files"], stdout=subprocess.PIPE, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("not a git clone")
    return listing.stdout.splitlines()
