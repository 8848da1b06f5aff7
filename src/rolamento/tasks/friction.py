"""The friction of a case by every model, as its JSON has it."""

from __future__ import annotations

from typing import Any, Final

from rolamento.analysis import Analysis, analyse
from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["COEFFICIENT", "friction_mapping", "friction_of_case"]

COEFFICIENT: Final = "lubricant.friction_coefficient"
"""The field without which a case has no friction."""


def friction_of_case(case: Case, *, hysteresis: float = 0.01) -> Analysis:
    """Analyse a case whose friction is asked for.

    Parameters
    ----------
    case
        With a coefficient of friction.
    hysteresis
        Part of the elastic work that the material loses, 0 to 1.

    Raises
    ------
    InputError
        If it has none.
    """
    if case.lubricant is None or case.lubricant.friction_coefficient is None:
        raise InputError(
            said("is missing; the friction calculation needs it"),
            field=COEFFICIENT,
            example="[lubricant] with friction_coefficient = 0.1",
        )
    return analyse(case, hysteresis=hysteresis)


def friction_mapping(analysis: Analysis) -> dict[str, Any]:
    """Return the friction of one case as plain data, in SI units."""
    whole = analysis.to_mapping()
    kept = ("schema", "title", "status", "friction", "notes", "case")
    return {"kind": "friction", **{key: whole[key] for key in kept}}
