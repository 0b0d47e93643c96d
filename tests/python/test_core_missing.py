# SPDX-License-Identifier: BSD-3-Clause
"""Who takes the package from the sources alone is told what is missing."""
import subprocess
from pathlib import Path

import pytest

SOURCES = Path(__file__).resolve().parents[2] / "safety_control_cloud" / "python"


@pytest.mark.parametrize("folder", [SOURCES.parents[1], Path("/")], ids=["in_the_clone", "elsewhere"])
@pytest.mark.parametrize("line", ["from safety_control_cloud import core", "import safety_control_cloud.core"])
def test_without_its_compiled_core_the_package_names_the_command_that_makes_it(line, folder):
    result = subprocess.run(
        ["/usr/bin/python3", "-B", "-c", line], env={"PYTHONPATH": str(SOURCES)}, cwd=folder, stderr=subprocess.PIPE, text=True)

    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError: the compiled core") and "scripts/setup" in last
