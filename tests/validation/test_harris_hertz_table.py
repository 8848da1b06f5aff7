"""Harris's table of a*, b* and δ* against F(ρ).

The abscissa is printed to a few digits only, so a printed value counts as reproduced when some
F that rounds to the printed one gives a number that rounds to the printed value.
"""

from __future__ import annotations

import tomllib
from decimal import Decimal
from pathlib import Path

import pytest

from rolamento.contact.hertz import hertz_coefficients

TABLE = tomllib.loads(
    (Path(__file__).parent / "data" / "harris_1991_hertz.toml").read_text("utf-8")
)
COLUMNS = ("semi_major", "semi_minor", "deflection")
ENTRIES = [
    (row[0], column, printed)
    for row in TABLE["rows"]
    for column, printed in zip(COLUMNS, row[1:], strict=True)
]
ERRATA = {(e["curvature_difference"], e["column"]): e for e in TABLE["errata"]}


def half_unit(printed: str) -> float:
    """Half a unit of the last printed digit."""
    exponent = Decimal(printed).as_tuple().exponent
    assert isinstance(exponent, int)
    return float(0.5 * 10.0**exponent)


def reproduced(difference: str, column: str, printed: str) -> bool:
    f, width = float(difference), half_unit(difference)
    ends = [float(getattr(hertz_coefficients(v), column)) for v in (f - width, f + width)]
    tolerance = half_unit(printed) * (1.0 + 1e-9)
    return min(ends) - tolerance <= float(printed) <= max(ends) + tolerance


@pytest.mark.parametrize(("difference", "column", "printed"), ENTRIES)
def test_every_printed_digit(difference: str, column: str, printed: str) -> None:
    """One entry is a misprint: three units of its last digit off, where rounding explains one."""
    erratum = ERRATA.get((difference, column))
    assert reproduced(difference, column, printed) is (erratum is None)
    if erratum is not None:
        assert erratum["printed"] == printed
        assert reproduced(difference, column, erratum["exact"])
