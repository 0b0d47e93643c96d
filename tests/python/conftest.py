# SPDX-License-Identifier: BSD-3-Clause
import pytest


@pytest.fixture
def best_instruction_set_afterwards():
    """For tests that look with others."""
    yield
    from safety_control_cloud import core  # compiled; most tests do without

    core.use_instruction_set("")
