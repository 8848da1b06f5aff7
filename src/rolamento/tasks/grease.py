"""The oil that a case wants, and its grease: the doors of `lubrication.oil_choice` and `grease`."""

from __future__ import annotations

import os

from rolamento.case import Case, case_of
from rolamento.errors import InputError
from rolamento.grease.of_case import GREASE_KAPPA, GreaseCase, grease_of_case
from rolamento.lubrication.oil_choice import OilChoice, choose_oil
from rolamento.words import said

__all__ = ["GREASE_KAPPA", "GreaseCase", "choose_oil_of_case", "grease_of_case"]


def choose_oil_of_case(
    case: Case | str | os.PathLike[str],
    kappa: float = GREASE_KAPPA,
    coldest: float | None = None,
    hottest: float | None = None,
) -> OilChoice:
    """Choose the ISO viscosity grade for a case, with a required κ over a range of temperatures.

    Parameters
    ----------
    case
        Or its file, or a designation; with a speed.
    kappa
        κ that the hottest temperature has to leave.
    coldest, hottest
        Temperatures of the lubricant, K; by default that of the case.

    Raises
    ------
    InputError
        If nothing turns, no temperature is known, or one is out of range.

    >>> case = Case(bearing="6310", duty={"inner_speed": "1480 rpm"})
    >>> choose_oil_of_case(case, 1.5, 313.15, 343.15).chosen
    'ISO VG 68'
    """
    given = case_of(case)
    swing = given.duty.oscillation
    speed = abs(given.duty.inner_speed - given.duty.outer_speed)
    if swing is not None:
        speed = 2.0 * swing.angle * (swing.frequency or 0.0)
    own = given.lubricant_temperature
    hot = hottest if hottest is not None else own
    if hot is None:
        raise InputError(
            said("is missing: the viscosity goes by it"),
            field="temperature.lubricant",
            example='"70 degC"',
        )
    cold = coldest if coldest is not None else min(hot, own or hot)
    pitch = min(place.bearing.pitch_diameter for place in given.bearing.places)
    return choose_oil(speed, pitch, kappa, cold, hot)
