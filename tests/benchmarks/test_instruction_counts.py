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
    if not all(program.exists() for program in instructions.PROGRAMS):
        pytest.skip("not built: cmake --build build --target safety_control_benchmarks")
    compiler = instructions.compiler()
    if compiler not in instructions.stored():
        pytest.skip(f"no counts are stored for {compiler}")
    return instructions.stored()[compiler]


@pytest.mark.parametrize("name, step, way", instructions.CASES)
def test_the_kernel_takes_no_more_instructions_than_it_did(allowed, name, step, way):
    program = instructions.counted_sets().get(name)
    if program is None:
        pytest.skip(f"{name} is not in this build")
    key = f"{name}/step_{step}/{way}"
    if key not in allowed:
        pytest.skip(f"no count of {key} is stored for {instructions.compiler()}")
    counted = instructions.instructions_per_point(program, step, name, way)
    assert counted <= GROWTH * allowed[key]
