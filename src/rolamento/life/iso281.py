"""Basic rating life: L_10 = (C/P)^3, of roller bearings (C/P)^(10/3), for 90 % reliability.

Source: ISO 281:2007, clause 5; Lundberg and Palmgren (1947).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.life.theory import OF_BEARING, OF_EQUIVALENT_LOAD, Theory
from rolamento.numerics import BoolArray, FloatArray
from rolamento.validate import numbers, positive

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life

EXPONENT: Final = 3.0
"""Exponent of load, for point contact."""
ROLLER_EXPONENT: Final = 10.0 / 3.0
"""Exponent of load, for roller bearings, whose contact is between a point and a line."""
MAXIMUM_LOAD: Final = 0.5
"""P/C up to which the rating life is valid: above, the balls' contacts deform plastically."""
MILLION: Final = 1e6


def basic_rating_life(
    dynamic_rating: ArrayLike, equivalent_load: ArrayLike, exponent: float = EXPONENT
) -> FloatArray:
    """Basic rating life L_10; millions of revolutions.

    Parameters
    ----------
    dynamic_rating : array, C; N.
    equivalent_load : array that broadcasts with it, P ≥ 0; N.
    exponent : 3, or of roller bearings 10/3.

    Returns
    -------
    Array of the broadcast shape; infinite without load.

    ISO 281:2007, 5.1.3 and 7.3.

    >>> print(f"{basic_rating_life(62e3, 6.2e3):.0f} million revolutions")
    1000 million revolutions
    """
    rating = positive(dynamic_rating, "dynamic_rating")
    load = positive(equivalent_load, "equivalent_load", zero=True)
    with np.errstate(divide="ignore"):
        return np.asarray((rating / load) ** exponent)


def hours(life: ArrayLike, speed: ArrayLike) -> FloatArray:
    """Life in hours; NaN where nothing turns.

    Parameters
    ----------
    life : array; millions of revolutions of one ring against the other.
    speed : array that broadcasts with it, of the rings against each other; rad/s, its size counts.

    >>> print(f"{hours(60.0, 1000.0 * np.pi / 30.0):.0f} h")
    1000 h
    """
    turns_per_hour = np.abs(numbers(speed, "speed")) * 1800.0 / np.pi
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        found = numbers(life, "life") * MILLION / turns_per_hour
    return np.asarray(np.where(turns_per_hour > 0.0, found, np.nan))


def load_notes(
    equivalent_load: ArrayLike, dynamic_rating: ArrayLike, static_rating: ArrayLike
) -> dict[str, BoolArray]:
    """Where the load is too great for the rating life to be valid, by name; arrays, N.

    load_above_half_rating: P > 0.5 C; load_above_static_rating: P > C_0. The formula still gives a
    number there. ISO 281:2007, 5.1.3 and 9.3.3.
    """
    load = numbers(equivalent_load, "equivalent_load")
    return {
        "load_above_half_rating": np.asarray(
            load > MAXIMUM_LOAD * numbers(dynamic_rating, "dynamic_rating")
        ),
        "load_above_static_rating": np.asarray(load > numbers(static_rating, "static_rating")),
    }


def _evaluate(basis: Basis) -> Life:
    factors = {"a_1": basis.reliability_factor}
    return basis.record(THEORY.name, basis.basic_life, factors, basis.notes_on_load())


THEORY: Final = Theory(
    name="iso281",
    evaluate=_evaluate,
    validity=(*OF_BEARING, *OF_EQUIVALENT_LOAD),
    rank=3,
    standard=True,
)
