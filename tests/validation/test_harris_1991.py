"""Harris (1991): the table of a*, b* and δ*, and examples 6.1 and 6.5 as Radaelli gives them."""

from __future__ import annotations

import pytest

from rolamento.contact.hertz import hertz_coefficients
from rolamento.verification import Check
from rolamento.verification.check import half_unit, published
from rolamento.verification.harris_1991 import SYMBOLS, checks

CHECKS = tuple(checks())
HARRIS, RADAELLI = published("harris_1991"), published("radaelli_2013")
TABLE = HARRIS["hertz_table"]
ENTRIES = [
    (row[0], column, printed)
    for row in TABLE["rows"]
    for column, printed in zip(TABLE["columns"][1:], row[1:], strict=True)
]
MISPRINTS = {(e["curvature_difference"], e["column"]) for e in TABLE["errata"]}
EXAMPLES = (("example_6_1", "table_C1"), ("example_6_5", "table_C2"))


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.source}: {c.quantity} [{c.unit}]")
def test_printed_number(check: Check) -> None:
    assert check.verdict != "fails", check


def test_all_that_is_printed_is_compared() -> None:
    printed = [number for _, _, number in ENTRIES]
    for example, _ in EXAMPLES:
        printed += HARRIS[example]["printed"].values()
    assert [check.printed for check in CHECKS] == printed
    assert len(printed) == 33 + 18 + 4


@pytest.mark.parametrize(("difference", "column", "printed"), ENTRIES)
def test_every_printed_digit(difference: str, column: str, printed: str) -> None:
    """Some F that rounds to the printed one gives a number that rounds to the printed value.

    One entry is a misprint: three units of its last digit off, where rounding explains one.
    """
    f, width = float(difference), half_unit(difference)
    ends = [float(getattr(hertz_coefficients(v), column)) for v in (f - width, f + width)]
    tolerance = half_unit(printed) * (1.0 + 1e-9)
    reproduced = min(ends) - tolerance <= float(printed) <= max(ends) + tolerance
    misprint = (difference, column) in MISPRINTS
    assert reproduced is not misprint
    name = f"{SYMBOLS[column]}, F = {difference}"
    (check,) = (check for check in CHECKS if check.quantity == name)
    assert check.verdict == ("explained" if misprint else "agrees")


@pytest.mark.parametrize(("example", "table"), EXAMPLES)
def test_the_two_authors_differ_as_the_table_states(example: str, table: str) -> None:
    """Both columns and the stated percentages fit each other: none of them is mistyped."""
    stated = RADAELLI[table]["difference_percent"]
    assert stated.keys() == HARRIS[example]["printed"].keys() == RADAELLI[table]["printed"].keys()
    for key, percent in stated.items():
        by_hand, by_computer = HARRIS[example]["printed"][key], RADAELLI[table]["printed"][key]
        if float(by_computer) == 0.0:
            assert float(by_hand) == 0.0 == float(percent)
            continue
        found = 100.0 * abs(float(by_hand) / float(by_computer) - 1.0)
        assert found == pytest.approx(float(percent), abs=half_unit(percent)), key
