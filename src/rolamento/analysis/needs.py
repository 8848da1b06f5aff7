"""Which parts of an analysis a case asks for, and which it has what they need for."""

from __future__ import annotations

from math import isfinite

from rolamento.case import Case


def has_oil(case: Case) -> bool:
    """Whether there is an oil or a grease."""
    return case.lubricant is not None and case.lubricant.kind != "dry"


def has_film(case: Case) -> bool:
    """Whether there is one, at a known temperature."""
    return has_oil(case) and case.lubricant_temperature is not None


def has_life(case: Case) -> bool:
    """Whether a life is asked for: by a designation, or the [life] table."""
    return case.life is not None or case.bearing.designation is not None


def coefficient(case: Case) -> float:
    """The coefficient of friction, or NaN."""
    mu = None if case.lubricant is None else case.lubricant.friction_coefficient
    return float("nan") if mu is None else float(mu)


def has_friction(case: Case) -> bool:
    """Whether the coefficient of friction is known."""
    return isfinite(coefficient(case))


def missing(case: Case) -> tuple[str, ...]:
    """Name the notes on what the film and the friction of a lubricated case lack."""
    notes = []
    if has_oil(case) and not has_film(case):
        notes.append("no_temperature")
    if not has_friction(case):
        notes.append("no_coefficient")
    return tuple(notes)
