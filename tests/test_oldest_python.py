# SPDX-License-Identifier: BSD-3-Clause
"""Every Python file is Python 3.8, Ubuntu 20.04's: its syntax, and what changed later and is easily written unawares."""
import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
OLDEST = (3, 8)
FOLDERS = ("safety_control_cloud", "scripts", "tests")
BUILTIN = {"dict", "frozenset", "list", "set", "tuple", "type"}
LATER_METHODS = {"hardlink_to", "is_relative_to", "pairwise", "removeprefix", "removesuffix", "with_stem"}
LATER_NAMES = {
    "functools": {"cache"},
    "itertools": {"batched", "pairwise"},
    "math": {"lcm", "nextafter", "ulp"},
    "typing": {"Annotated", "ParamSpec", "Self", "TypeAlias", "assert_never"},
    "dataclasses": {"KW_ONLY"},
}
LATER_ARGUMENTS = {"zip": {"strict"}, "dataclass": {"slots", "kw_only"}}


class Later(ast.NodeVisitor):
    """Collects what Python 3.8 cannot run. Annotations do not run where the file postpones them."""

    def __init__(self, tree):
        self.found = []
        self._generic = set(BUILTIN)
        self._postponed = any(isinstance(node, ast.ImportFrom) and node.module == "__future__" for node in tree.body)
        self.visit(tree)

    def visit_ImportFrom(self, node):
        if (node.module or "").startswith("collections"):
            self._generic |= {alias.asname or alias.name for alias in node.names}
        later = LATER_NAMES.get(node.module, set())
        self.found += [(node.lineno, alias.name) for alias in node.names if alias.name in later]

    def visit_FunctionDef(self, node):
        self._visit_all(node, {"returns"})

    def visit_arg(self, node):
        self._visit_all(node, {"annotation"})

    def visit_AnnAssign(self, node):
        self._visit_all(node, {"annotation"})

    def visit_Subscript(self, node):
        if isinstance(node.value, ast.Name) and node.value.id in self._generic:
            self.found.append((node.lineno, f"{node.value.id}[]"))
        self.generic_visit(node)

    def visit_BinOp(self, node):
        sides = (node.left, node.right)
        if isinstance(node.op, ast.BitOr) and any(isinstance(side, (ast.Dict, ast.DictComp)) or none(side) for side in sides):
            self.found.append((node.lineno, "|"))
        self.generic_visit(node)

    def visit_Attribute(self, node):
        module = node.value.id if isinstance(node.value, ast.Name) else None
        if node.attr in LATER_METHODS or node.attr in LATER_NAMES.get(module, set()):
            self.found.append((node.lineno, node.attr))
        self.generic_visit(node)

    def visit_Call(self, node):
        later = LATER_ARGUMENTS.get(getattr(node.func, "id", None), set())
        self.found += [(node.lineno, f"{keyword.arg}=") for keyword in node.keywords if keyword.arg in later]
        self.generic_visit(node)

    def _visit_all(self, node, annotations):
        for name, value in ast.iter_fields(node):
            if not (self._postponed and name in annotations):
                for child in value if isinstance(value, list) else [value]:
                    if isinstance(child, ast.AST):
                        self.visit(child)


def none(node):
    return isinstance(node, ast.Constant) and node.value is None


def later_in(text):
    return Later(ast.parse(text, feature_version=OLDEST)).found


def python_files():
    for path in sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file()):
        if path.suffix in (".py", ".pyi", ".cfg") or (path.parent.name == "scripts" and "python" in first_line(path)):
            yield pytest.param(path, id=str(path.relative_to(ROOT)))


def first_line(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.readline()


@pytest.mark.parametrize("file", python_files())
def test_a_file_runs_on_the_oldest_python(file):
    assert later_in(file.read_text()) == []


@pytest.mark.parametrize(
    "line, what",
    [
        ("for a, b in zip(x, y, strict=True): pass", "strict="),
        ("name.removeprefix('a')", "removeprefix"),
        ("from functools import cache", "cache"),
        ("math.lcm(2, 3)", "lcm"),
        ("Names = list[str]", "list[]"),
        ("from collections.abc import Callable\nSteer = Callable[[float], None]", "Callable[]"),
        ("def f(x: list[int]): pass", "list[]"),
        ("x: int | None = 1", "|"),
        ("both = one | {'a': 1}", "|"),
        ("@dataclass(slots=True)\nclass A: pass", "slots="),
    ],
)
def test_what_the_oldest_python_cannot_run_is_found(line, what):
    assert [found for _, found in later_in(line)] == [what]


def test_an_annotation_that_is_postponed_does_not_run():
    assert later_in("from __future__ import annotations\ndef f(x: list[int] | None) -> dict[str, int]:\n    y: set[int] = set()") == []


def test_syntax_that_the_oldest_python_does_not_know_is_refused():
    with pytest.raises(SyntaxError):
        later_in("match x:\n    case 1: pass")
