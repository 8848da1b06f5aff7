"""What people save has the field's words: fields, outputs, statuses, notes, and keys of JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from rolamento import Case
from rolamento.case.former import FIELDS, OUTPUTS, STATUSES
from rolamento.status import STATUS_NUMBERS
from rolamento.studies.outputs import catalogue
from rolamento.words.sentences import sentences

DIALECT = re.compile(
    r"(?:^|[_.])(wanted|wish|holds?|below|endless|least|greatest|told|tells?|asked|unheld|knowing"
    r"|nobody|firm|dirt|little)(?:$|[_.])"
)
"""Words that the program has used in a sense of its own."""
AS_OTHERS_SAY = {
    "at_least", "below_fatigue_limit", "load_below_minimum", "ribs_do_not_hold",
    "sphere_holds_no_moment", "torque_below_models",
}  # fmt: skip
"""Names in which such a word means what it means to everybody."""
GOLDEN = Path(__file__).parents[1] / "regression" / "golden"


def keys_of(tree: Any) -> Iterator[str]:
    """All keys of parsed JSON."""
    if isinstance(tree, dict):
        yield from tree
        for value in tree.values():
            yield from keys_of(value)
    elif isinstance(tree, list):
        for value in tree:
            yield from keys_of(value)


def dialect_in(names: Iterator[str] | list[str]) -> list[str]:
    return sorted({name for name in names if DIALECT.search(name)} - AS_OTHERS_SAY)


@pytest.mark.parametrize(
    "names",
    [list(Case.fields()), list(catalogue()), list(STATUS_NUMBERS), list(sentences())],
    ids=["fields", "outputs", "statuses", "notes"],
)
def test_names(names: list[str]) -> None:
    assert len(names) > 5
    assert dialect_in(names) == []


def test_keys_of_json() -> None:
    """Of all commands that are run for the golden files."""
    files = sorted(GOLDEN.glob("*.json"))
    assert len(files) > 100
    found = {
        path.name: own
        for path in files
        if (own := dialect_in(keys_of(json.loads(path.read_text("utf-8")))))
    }
    assert found == {}


def test_former_names_are_the_dialect() -> None:
    assert all(DIALECT.search(name) for name in (*FIELDS, *OUTPUTS, *STATUSES))
