"""The friction of a case by every model, as its JSON has it."""

from __future__ import annotations

from typing import Any

from rolamento.analysis import Analysis, analyse
from rolamento.case import Case
from rolamento.friction.summary import no_coefficient

__all__ = ["friction_mapping", "friction_of_case"]


def friction_of_case(case: Case, *, hysteresis: float = 0.01) -> Analysis:
    """Analyse a case whose friction is asked for.

    Parameters
    ----------
    case
        With a coefficient of friction, or an oil or a grease at its temperature.
    hysteresis
        Part of the elastic work that the material loses, 0 to 1.

    Raises
    ------
    InputError
        If it has neither.
    """
    lubricant = case.lubricant
    known = lubricant is not None and lubricant.friction_coefficient is not None
    if lubricant is None or not (known or case.lubricant_temperature is not None):
        raise no_coefficient(case)
    return analyse(case, hysteresis=hysteresis)


def friction_mapping(analysis: Analysis) -> dict[str, Any]:
    """Return the friction of one case as plain data, in SI units."""
    whole = analysis.to_mapping()
    kept = ("schema", "title", "status", "friction", "seals_and_bath", "notes", "case")
    return {"kind": "friction", **{key: whole[key] for key in kept if key in whole}}
