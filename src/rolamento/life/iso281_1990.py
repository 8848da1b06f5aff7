"""Adjusted rating life of 1990: L_na = a_1 a_2 a_3 L_10, with factors that the user answers for.

The standard gives no values of a_2 (steel and design) and a_3 (lubrication and surroundings); it
says when they should differ from 1. Those conditions are here.

Source: ISO 281:1990, clause 8, as in Campanha (2008), 2.6.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.life.reliability import outside_print, reliability_factor
from rolamento.life.theory import OF_BEARING, OF_EQUIVALENT_LOAD, Need, Theory
from rolamento.numerics import BoolArray, FloatArray
from rolamento.validate import positive
from rolamento.words import marked

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life

THIN_OIL: Final = 13e-6
"""Kinematic viscosity at the running temperature below which a_3 < 1 is to be considered; m²/s."""
SLOW: Final = 10_000.0
"""n d_m below which a_3 < 1 is to be considered; r/min · mm."""


def adjusted_life(
    basic_life: ArrayLike,
    reliability_factor: ArrayLike = 1.0,
    material_factor: ArrayLike = 1.0,
    operation_factor: ArrayLike = 1.0,
) -> FloatArray:
    """Adjusted rating life L_na; in the unit of the basic life.

    Parameters
    ----------
    basic_life : array, L_10.
    reliability_factor, material_factor, operation_factor : arrays that broadcast, a_1, a_2, a_3.

    ISO 281:1990, 8.1.

    >>> print(f"{adjusted_life(100.0, 0.62, 2.0, 0.5):.0f} million revolutions")
    62 million revolutions
    """
    return np.asarray(
        positive(basic_life, "basic_life", zero=True)
        * positive(reliability_factor, "reliability_factor")
        * positive(material_factor, "material_factor")
        * positive(operation_factor, "operation_factor")
    )


def adjustment_notes(
    material_factor: ArrayLike,
    operation_factor: ArrayLike,
    viscosity: ArrayLike,
    speed: ArrayLike,
    pitch_diameter: ArrayLike,
) -> dict[str, BoolArray]:
    """Where the factors and the standard's conditions do not go together, by name.

    Parameters
    ----------
    material_factor, operation_factor : arrays, a_2 and a_3.
    viscosity : array, kinematic, at the running temperature; m²/s, NaN if unknown.
    speed : array, of the rings against each other; rad/s.
    pitch_diameter : array; m.
        All broadcast against each other.

    Returns
    -------
    material_factor_unsupported: a_2 other than 1 wants evidence from the maker;
    operation_factor_too_great: a_3 of 1 or more although the oil is thinner than 13 mm²/s or n d_m
    is below 10 000; operation_factor_unfounded: a_3 above 1 needs a film that separates the
    surfaces, and makes up for no steel.
    """
    a2, a3, nu, omega, diameter = np.broadcast_arrays(
        *(
            np.asarray(value, dtype=np.float64)
            for value in (material_factor, operation_factor, viscosity, speed, pitch_diameter)
        )
    )
    slow = np.abs(omega) * 30.0 / np.pi * diameter * 1e3 < SLOW
    return {
        "material_factor_unsupported": np.asarray(a2 != 1.0),
        "operation_factor_too_great": np.asarray((a3 >= 1.0) & ((nu < THIN_OIL) | slow)),
        "operation_factor_unfounded": np.asarray(a3 > 1.0),
    }


def _evaluate(basis: Basis) -> Life:
    given = basis.given
    a2, a3 = (
        np.ones(len(basis)) if getattr(given, name) is None else basis.over_cases(name)
        for name in ("material_factor", "operation_factor")
    )
    diameter = basis.solved.rows.pitch_diameter.max(axis=1)
    notes = {
        **basis.notes_on_load(),
        **adjustment_notes(a2, a3, basis.over_cases("viscosity"), basis.speed, diameter),
        "reliability_continued": outside_print(given.reliability, EDITION),
    }
    a1 = reliability_factor(given.reliability, EDITION)
    return basis.record(THEORY.name, basis.basic_life, {"a_1": a1, "a_2": a2, "a_3": a3}, notes)


EDITION: Final = "1990"
ADJUSTMENT: Final = Need(
    "adjustment",
    marked("a material factor or an operation factor"),
    "[life] with operation_factor = 0.8 in the case",
    ("material_factor", "operation_factor"),
)
THEORY: Final = Theory(
    name="iso281_1990",
    evaluate=_evaluate,
    asked=lambda basis: (
        basis.given.material_factor is not None or basis.given.operation_factor is not None
    ),
    needs=(ADJUSTMENT,),
    validity=(*OF_BEARING, *OF_EQUIVALENT_LOAD),
    rank=6,
    edition=EDITION,
)
