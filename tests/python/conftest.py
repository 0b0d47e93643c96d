# SPDX-License-Identifier: BSD-3-Clause
"""Lets these tests import sights.py, whatever pytest's import mode."""
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))


@pytest.fixture
def best_instruction_set_afterwards():
    """For tests that look with others."""
    yield
    from safety_control_cloud import core  # compiled; most tests do without

    core.use_instruction_set("")
