# SPDX-License-Identifier: BSD-3-Clause
"""The kernel does not grow slower unnoticed. After a change that is meant: scripts/bench --store-instructions."""
import shutil

import instructions
import pytest

GROWTH = 1.10


@pytest.fixture(scope="module")
def allowed():
    if shutil.which("valgrind") is None:
        pytest.skip("valgrind is not installed")
    if not instructions.PROGRAM.exists():
        pytest.skip("not built: cmake --build build --target safety_control_benchmarks")
    compiler, _ = instructions.built_with()
    if compiler not in instructions.stored():
        pytest.skip(f"no counts are stored for {compiler}")
    return instructions.stored()[compiler]


@pytest.mark.parametrize("way", instructions.WAYS)
@pytest.mark.parametrize("step", instructions.STEPS)
@pytest.mark.parametrize("name", instructions.COUNTED_BY_CALLGRIND)
def test_the_kernel_takes_no_more_instructions_than_it_did(allowed, name, step, way):
    if name not in instructions.built_with()[1]:
        pytest.skip(f"{name} is not in this build")
    assert instructions.instructions_per_point(step, name, way) <= GROWTH * allowed[f"{name}/step_{step}/{way}"]
