# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench: everything side by side in one run."""
import argparse
import json
import sys
from pathlib import Path

import instructions
import kernel


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/bench", description="Measures what a decision costs, and beside what.")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures there")
    parser.add_argument("--quick", action="store_true", help="VGA only: about a minute")
    parser.add_argument("--repetitions", type=int, default=5, metavar="N", help="of every case; medians are shown (5)")
    parser.add_argument("--store-instructions", action="store_true", help="hold the kernel to today's counts from now on")
    return parser.parse_args()


def progress(total: int):
    done = 0

    def step() -> None:
        nonlocal done
        done += 1
        if sys.stderr.isatty():
            print(f"\r{done}/{total}", end="\n" if done == total else "", file=sys.stderr, flush=True)

    return step


def main() -> None:
    given = arguments()
    if given.store_instructions:
        return instructions.store()
    total = given.repetitions * len(list(kernel.cases(given.quick)))
    table = kernel.measure(given.quick, given.repetitions, progress(total))
    figures = {**kernel.figures(table), "instructions_per_point": instructions.count()}
    print(*kernel.rows(table), "", *(f"{name:34} {value}" for name, value in figures.items()), sep="\n")
    if given.json:
        given.json.write_text(json.dumps({**figures, "kernel": kernel.as_json(table)}, indent=2) + "\n")


if __name__ == "__main__":
    main()
