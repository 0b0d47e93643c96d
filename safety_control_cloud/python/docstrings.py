# SPDX-License-Identifier: BSD-3-Clause
"""core.pyi's docstrings, and its comments beside attributes, as a C++ header: what they say is written once."""
from __future__ import annotations

import ast
import sys
from pathlib import Path
from typing import Iterator, List, Tuple

HEADER = """// Made of core.pyi by docstrings.py.
#pragma once

struct Docstring {
  const char *owner, *name, *text;  ///< owner: a class, or "" for what stands in the module
};

constexpr Docstring docstrings[] = {
"""


def docstrings_in(nodes: List[ast.stmt], lines: List[str], owner: str = "") -> Iterator[Tuple[str, str, str]]:
    """Owner, name and text."""
    for node in nodes:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            text = ast.get_docstring(node)
            if text:
                yield owner, node.name, text
            if isinstance(node, ast.ClassDef):
                yield from docstrings_in(node.body, lines, node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            comment = lines[node.lineno - 1].partition("  # ")[2]
            if comment:
                yield owner, node.target.id, comment


def main(stub: Path, header: Path) -> None:
    text = stub.read_text(encoding="utf-8")
    rows = docstrings_in(ast.parse(text).body, text.splitlines())
    body = "".join(f'    {{"{owner}", "{name}", R"doc({text})doc"}},\n' for owner, name, text in rows)
    header.parent.mkdir(parents=True, exist_ok=True)
    header.write_text(HEADER + body + "};\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
