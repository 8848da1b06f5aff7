"""The table of f_0 of ISO 76, which follows from Hertz."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rolamento.ratings import static_factor_of_grooves
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import published

__all__ = ["checks"]

_NOTHING: Final = 1e-12
"""γ in the place of 0, where the closed form begins."""
_ROUNDED: Final = (
    "The load that makes 4200 MPa, by exact Hertz with 207 GPa and 0.3, grooves of 0.52 and 0.53."
)
_BEYOND: Final = (
    "By exact Hertz 15.653 with 207 GPa and 0.3: the table's one number that is not the rounded"
    " one. Tolerance: 0.003 more than half a digit."
)
_MORE: Final = 0.003


def checks() -> Iterator[Check]:
    """Compare f_0 over the whole table."""
    table = published("iso_76")["static_factor"]
    for index, printed in enumerate(table["factors"]):
        gamma = table["gamma_step"] * index
        odd = index in table["not_rounded"]
        found = static_factor_of_grooves(max(gamma, _NOTHING), *table["conformities"])
        yield Check(
            source=table["source"],
            quantity=f"f_0, γ = {gamma:.2f}",
            unit="N/mm²",
            printed=printed,
            computed=float(found),
            tolerance=half_unit(printed) + (_MORE if odd else 0.0),
            explanation=_BEYOND if odd else _ROUNDED,
        )
