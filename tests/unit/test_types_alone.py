"""Laws ask what a type can do; only its own file, and the formulas of the standards, name it."""

from __future__ import annotations

import ast
from pathlib import Path

import rolamento
from rolamento.solved.notes import CHECKS
from rolamento.types import BALL, TYPES

HOUSE = Path(rolamento.__file__).parent
KEYS = {key for one in TYPES.values() for key in (one.key, one.grooves, one.element) if key} - {
    BALL
}
"""Whether balls or rollers roll is asked by name: the words for them differ."""
FORMULAS = {"ratings/balls.py", "ratings/rollers.py"}
"""ISO 281 and ISO 76 have formulas of their own for thrust and self-aligning ones."""
OTHER_WORDS = {
    "case/hints.py": "a thrust is a force",
    "pages/speed.py": "a thrust is a force",
    "analysis/speed_limits.py": "a thrust is a force",
    "verification/standards.py": "a table of two rows",
}


def named(path: Path) -> list[str]:
    """The keys of types among the texts of a module, but for what its docstrings say."""
    tree = ast.parse(path.read_text("utf-8"))
    said = {
        id(node.value) for node in ast.walk(tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }  # fmt: skip
    return [
        f"{node.lineno}: {node.value}"
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and node.value in KEYS and id(node) not in said
    ]


def test_nothing_names_a_type() -> None:
    found = {
        name: lines
        for path in HOUSE.rglob("*.py")
        if not (name := path.relative_to(HOUSE).as_posix()).startswith("types/")
        and (lines := named(path))
    }
    assert {*found} == FORMULAS | {*OTHER_WORDS}, found


def test_a_type_stands_in_a_file_of_its_own() -> None:
    files = {path.stem for path in (HOUSE / "types").glob("[a-z]*.py")}
    assert len(files) == len(TYPES) - 1  # drawn cups stand with the needle roller bearings


def test_the_notes_that_types_bring_are_known() -> None:
    assert {note for one in TYPES.values() for note in one.notes} <= CHECKS.keys()
