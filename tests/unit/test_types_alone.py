"""Laws ask what a type can do; only its own file, and the formulas of the standards, name it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import rolamento
from rolamento.types import BALL, TYPES

HOUSE = Path(rolamento.__file__).parent
KEYS = {key for one in TYPES.values() for key in (one.key, one.grooves, one.element) if key} - {
    BALL
}
"""Whether balls or rollers roll is asked by name: the words for them differ."""
FORMULAS = ("ratings/balls.py", "life/equivalent_load.py", "life/iso16281.py",
            "life/iso281_modified.py", "life/row_ratings.py")  # fmt: skip
"""ISO 281, ISO 76 and ISO/TS 16281 have formulas of their own for thrust and self-aligning ones."""
OF_BORES = ("catalogue/designation.py",)
"""A tapered bore is no tapered bearing."""


def compared(path: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Compare | ast.MatchValue):
            words = {one.value for one in ast.walk(node) if isinstance(one, ast.Constant)}
            if words & KEYS:
                yield f"{node.lineno}: {ast.unparse(node)}"


def test_nothing_is_decided_by_the_name_of_a_type() -> None:
    found: dict[str, list[str]] = {}
    for path in HOUSE.rglob("*.py"):
        name = path.relative_to(HOUSE).as_posix()
        if not name.startswith("types/") and (lines := list(compared(path))):
            found[name] = lines
    assert {*found} == {*FORMULAS, *OF_BORES}, found


def test_a_type_stands_in_a_file_of_its_own() -> None:
    files = {path.stem for path in (HOUSE / "types").glob("[a-z]*.py")}
    assert len(files) == len(TYPES) - 1  # drawn cups stand with the needle roller bearings
