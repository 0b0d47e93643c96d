# SPDX-License-Identifier: BSD-3-Clause
"""Memory stays flat. SAFETY_CONTROL_SOAK=72000 sends as many clouds as a 20 Hz camera does in an hour."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

CLOUDS = int(os.environ.get("SAFETY_CONTROL_SOAK", "4000"))
WARM_UP = 5  # of twenty samples
GROWTH = 2_000_000  # [byte] allowed between the end of the warm-up and the end


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["binding", "node"])
def test_memory_is_flat(kind):
    soak = [sys.executable, str(Path(__file__).with_name("soak.py")), kind, str(CLOUDS)]
    result = subprocess.run(soak, stdout=subprocess.PIPE, text=True, timeout=60 + CLOUDS / 20)
    assert result.returncode == 0
    memory = [int(line) for line in result.stdout.split()]
    print(f"{CLOUDS} clouds, memory [MB]: {[round(size / 1e6, 1) for size in memory]}")
    assert len(memory) >= 20 and max(memory[WARM_UP:]) - memory[WARM_UP] < GROWTH, memory
