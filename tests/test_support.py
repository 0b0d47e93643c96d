# SPDX-License-Identifier: BSD-3-Clause
"""What tests share lies in tests/support, which .pytest.ini names: nobody looks for it elsewhere."""
import ast
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parent
SUPPORT = TESTS / "support"
# Programs of their own, whose tests import their parts by .pytest.ini too; and one that is run by hand.
PROGRAMS = {
    TESTS / "benchmarks", TESTS / "tutorial", TESTS / "platforms" / "same_drives", TESTS / "python" / "judge" / "thousand.py",
}


def shared_outside(tests, support, programs):
    """The modules of the tests' own that a file imports though they do not lie in support/."""
    own = {file.stem: file for file in tests.rglob("*.py") if support not in file.parents and not programs & {file, *file.parents}}
    for file in own.values():
        for module in sorted(set(imported_by(file)) & set(own)):
            yield f"{file.name} imports {module}"


def imported_by(file):
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module


def touches_the_path(text):
    names = (node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Attribute) and node.attr == "path")
    return any(isinstance(node.value, ast.Name) and node.value.id == "sys" for node in names)


def test_what_a_test_imports_of_the_tests_lies_in_support():
    assert list(shared_outside(TESTS, SUPPORT, PROGRAMS)) == []


def test_names_in_support_are_of_no_other_module():
    folders = [SUPPORT, TESTS / "benchmarks", TESTS / "tutorial", TESTS / "platforms" / "same_drives"]
    names = [file.stem for folder in folders for file in folder.glob("*.py") if not file.stem.startswith(("test_", "__"))]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("file", sorted(TESTS.rglob("*.py")), ids=lambda file: str(file.relative_to(TESTS)))
def test_no_test_touches_the_path_of_modules(file):
    assert not touches_the_path(file.read_text())


def test_what_is_shared_elsewhere_is_found(tmp_path):
    (tmp_path / "support").mkdir()
    for name, line in {"support/eyes.py": "", "ears.py": "", "test_a.py": "import eyes\nfrom ears import hear", "test_b.py": "from .ears import x"}.items():
        (tmp_path / name).write_text(line)
    assert list(shared_outside(tmp_path, tmp_path / "support", set())) == ["test_a.py imports ears"]


def test_a_path_that_is_touched_is_found():
    assert touches_the_path("import sys\nsys.path.insert(0, 'x')") and not touches_the_path("text = 'sys.path'")
