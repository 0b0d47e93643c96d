# SPDX-License-Identifier: BSD-3-Clause
"""Instructions that one look() at a VGA cloud takes, counted by callgrind: the figure that moves with no machine.

The way "near_loss" is with the memory of what came near, and NearLoss::judge(); "gather" with what a guard does in the
same pass.
"""
import json
import re
import subprocess
from pathlib import Path
from typing import Dict, List, Tuple

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = [ROOT / "build" / "tests" / "benchmarks" / name for name in ("kernel_instructions", "kernel_instructions_portable")]
STORED = Path(__file__).with_name("instructions.json")
POINTS = 640 * 480
STEPS = (2, 4, 12, 16, 20, 32)  # [byte] of a point; 2 and 4 are depth images
WAYS = ("look", "near_loss", "gather")
COUNTED = {"AVX2": WAYS, "SSE4": WAYS, "GNU_AVX2": ("look", "gather")}  # of what valgrind can run; the memory is the same without Highway
CASES = [(name, step, way) for name, ways in COUNTED.items() for step in STEPS for way in ways]


def compiled(program: Path) -> Tuple[str, List[str]]:
    """By which compiler, with its major version, and for which instruction sets."""
    compiler, *sets = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
    return compiler, sets


def compiler() -> str:
    return compiled(PROGRAMS[0])[0]


def counted_sets() -> Dict[str, Path]:
    """Each instruction set that can be counted, and the program that has it."""
    return {name: program for program in PROGRAMS for name in compiled(program)[1] if name in COUNTED}


def instructions_per_point(program: Path, step: int, instruction_set: str, way: str) -> float:
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*counted(*"]
    result = subprocess.run([*command, program, str(step), instruction_set, way], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    collected = re.search(r"Collected : (\d+)", result.stderr)
    if result.returncode != 0 or not collected or collected[1] == "0":
        raise RuntimeError(f"callgrind counted nothing:\n{result.stderr}")
    return int(collected[1]) / POINTS


def count() -> Dict[str, float]:
    """"SET/step_N/WAY" -> instructions per point."""
    programs = counted_sets()
    return {
        f"{name}/step_{step}/{way}": round(instructions_per_point(programs[name], step, name, way), 3)
        for name, step, way in CASES
        if name in programs
    }


def stored() -> Dict[str, Dict[str, float]]:
    """The counts to hold the kernel to, by compiler."""
    return json.loads(STORED.read_text())


def store() -> None:
    STORED.write_text(json.dumps({**stored(), compiler(): count()}, indent=2, sort_keys=True) + "\n")
