"""Capacitance, voltage and current density of contacts with a film.

A film in the contact ellipse is a plate capacitor, and the gap around it adds as much again:

    C_c = k ε_0 ε_r A/h_c,   A = π a b,   k ≈ 2.

The two contacts of an element are in series, all elements of a bearing are parallel. The voltage
across an element divides as 1/C. The apparent current density is the amplitude of the current over
the area of all ellipses of a race: a measure of severity, not what flows in a contact.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.validate import numbers

__all__ = [
    "VACUUM",
    "apparent_current_density",
    "film_capacitance",
    "in_series",
    "share_of_voltage",
]

VACUUM: Final = float(toml_of("electrical")["vacuum_permittivity"])
"""ε_0, F/m."""


def film_capacitance(
    area: ArrayLike, thickness: ArrayLike, permittivity: ArrayLike, outside_factor: ArrayLike = 1.0
) -> FloatArray:
    """Capacitance of a film between two surfaces; F.

    Parameters
    ----------
    area
        A of the contact, in m²; nothing touches where it is 0: no capacitance.
    thickness
        h_c, in m; infinite capacitance without a film.
    permittivity
        ε_r of the lubricant.
    outside_factor
        k, of the whole contact over its ellipse.

    A plate capacitor, k ε_0 ε_r A/h.

    >>> f"{1e12 * film_capacitance(1e-7, 1e-6, 2.2):.2f} pF"
    '1.95 pF'
    """
    plates, film = numbers(area, "area"), np.asarray(thickness, np.float64)
    scale = (
        numbers(outside_factor, "outside_factor") * VACUUM * numbers(permittivity, "permittivity")
    )
    touching = plates > 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        found = scale * plates / film
    return np.where(touching, found, np.where(np.isnan(plates), np.nan, 0.0))


def in_series(first: ArrayLike, second: ArrayLike) -> FloatArray:
    """Capacitance of two capacitors in series; 0 where one is 0.

    Parameters
    ----------
    first, second
        Their capacitances, in F; one that is infinite conducts.

    >>> float(in_series(2.0, 2.0))
    1.0
    """
    one, other = np.broadcast_arrays(numbers(first, "first"), np.asarray(second, np.float64))
    with np.errstate(divide="ignore", invalid="ignore"):
        found = 1.0 / (1.0 / one + 1.0 / other)
    return np.asarray(found)


def share_of_voltage(own: ArrayLike, other: ArrayLike) -> FloatArray:
    """Part of an element's voltage that lies across one of its contacts.

    Parameters
    ----------
    own, other
        Capacitances of that contact and of the other one, in F.

    C_other/(C_own + C_other): the lesser capacitance, with the thicker film, has the greater part.

    >>> float(share_of_voltage(1.0, 3.0))
    0.75
    """
    mine, yours = np.broadcast_arrays(np.asarray(own, np.float64), np.asarray(other, np.float64))
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.where(np.isinf(yours), 1.0, yours / (mine + yours))
    return np.where(np.isinf(mine) & np.isinf(yours), np.nan, found)


def apparent_current_density(current: ArrayLike, area: ArrayLike) -> FloatArray:
    """Amplitude of the current over the area of all contacts of a race; A/m².

    Parameters
    ----------
    current
        Amplitude through the bearing, in A.
    area
        Of all contact ellipses of the race, in m².

    >>> f"{1e-6 * apparent_current_density(0.5, 1e-6):.1f} A/mm²"
    '0.5 A/mm²'
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(numbers(current, "current") / numbers(area, "area"))
