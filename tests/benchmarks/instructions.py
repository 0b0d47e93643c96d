# SPDX-License-Identifier: BSD-3-Clause
"""Instructions that one look() at a VGA cloud takes, counted by callgrind: the figure that moves with no machine.

The way "near_loss" is with the memory of what came near, and NearLoss::judge().
"""
import itertools
import json
import re
import subprocess
from pathlib import Path
from typing import Dict, List, Tuple

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build" / "tests" / "benchmarks" / "kernel_instructions"
STORED = Path(__file__).with_name("instructions.json")
POINTS = 640 * 480
STEPS = (2, 4, 12, 16, 20, 32)  # [byte] of a point; 2 and 4 are depth images
WAYS = ("look", "near_loss")
COUNTED_BY_CALLGRIND = ("AVX2", "SSE4", "PORTABLE")  # of what the kernel has, what valgrind can run


def built_with() -> Tuple[str, List[str]]:
    """The compiler with its major version, and the instruction sets that can be counted."""
    compiler, *sets = subprocess.run([PROGRAM], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    return compiler, [name for name in sets if name in COUNTED_BY_CALLGRIND]


def instructions_per_point(step: int, instruction_set: str, way: str) -> float:
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*counted(*"]
    result = subprocess.run([*command, PROGRAM, str(step), instruction_set, way], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    collected = re.search(r"Collected : (\d+)", result.stderr)
    if result.returncode != 0 or not collected or collected[1] == "0":
        raise RuntimeError(f"callgrind counted nothing:\n{result.stderr}")
    return int(collected[1]) / POINTS


def count() -> Dict[str, float]:
    """"SET/step_N/WAY" -> instructions per point."""
    _, sets = built_with()
    cases = itertools.product(sets, STEPS, WAYS)
    return {f"{name}/step_{step}/{way}": round(instructions_per_point(step, name, way), 3) for name, step, way in cases}


def stored() -> Dict[str, Dict[str, float]]:
    """The counts to hold the kernel to, by compiler."""
    return json.loads(STORED.read_text())


def store() -> None:
    compiler, _ = built_with()
    STORED.write_text(json.dumps({**stored(), compiler: count()}, indent=2, sort_keys=True) + "\n")
