# SPDX-License-Identifier: BSD-3-Clause
"""A bag is known by all of its bytes, however many blocks they fill."""
from __future__ import annotations

import ast
import hashlib
from pathlib import Path
from typing import Iterator

import pytest
import xxhash
from tree import PYTHON

from safety_control_cloud.judge.identity import BLOCK, JUDGES, LENGTH, hash_of_bag


@pytest.mark.parametrize("size", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK + 7])
def test_a_bag_is_known_by_the_hash_of_its_bytes(tmp_path, size):
    content = bytes(number % 251 for number in range(size))
    (tmp_path / "a.bag").write_bytes(content)

    whole = hashlib.sha256(f" {xxhash.xxh3_128(content).hexdigest()}\n".encode()).hexdigest()
    assert hash_of_bag(tmp_path / "a.bag") == whole[:LENGTH]


@pytest.mark.parametrize("at", [0, BLOCK - 1, BLOCK, 2 * BLOCK + 6])
def test_one_other_byte_makes_another_bag(tmp_path, at):
    content = bytearray(2 * BLOCK + 7)
    (tmp_path / "a.bag").write_bytes(content)
    content[at] = 1
    (tmp_path / "b.bag").write_bytes(content)

    assert hash_of_bag(tmp_path / "a.bag") != hash_of_bag(tmp_path / "b.bag")


def test_a_folder_is_known_by_its_files_and_their_names(tmp_path):
    for folder, name in (("a", "0.db3"), ("b", "1.db3"), ("c", "0.db3")):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / name).write_bytes(b"content")

    known = [hash_of_bag(tmp_path / folder) for folder in "abc"]
    assert known[0] == known[2] != known[1]

DECIDE_NOTHING = {  # what of the judge's own imports no row depends on
    "__init__.py", "judge/__init__.py", "judge/choice.py", "judge/find.py", "judge/guard/__init__.py", "judge/identity.py",
    "judge/memory.py", "replay/__init__.py", "replay/guard/__init__.py"}


def test_the_version_is_of_all_modules_that_a_row_depends_on():
    found, waiting = set(), [PYTHON / "judge" / "bag.py"]
    while waiting:
        file = waiting.pop()
        found.add(str(file.relative_to(PYTHON)))
        waiting += [module for module in imported_by(file) if str(module.relative_to(PYTHON)) not in found]

    assert found - DECIDE_NOTHING == set(JUDGES)


def imported_by(file: Path) -> Iterator[Path]:
    """Modules of the package, but for those that only types are checked by."""
    tree = ast.parse(file.read_text())
    checked = [node for node in tree.body if isinstance(node, ast.If)]
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and not any(node in block.body for block in checked):
            places = [node.module, *(f"{node.module}.{name.name}" for name in node.names)]
            modules = [PYTHON.joinpath(*place.split(".")[1:]) for place in places if place.split(".")[0] == PYTHON.name]
            yield from (module.with_suffix(".py") for module in modules if module.with_suffix(".py").exists())
