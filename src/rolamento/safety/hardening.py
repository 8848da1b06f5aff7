"""Hardness and case depth that a raceway needs, from the stresses below its surface.

A metal begins to yield where the maximum shear is half of its yield stress (Tresca), and its
hardness is three times the yield stress (Tabor, 1951). At a depth z below the contact it has to be

    H(z) = 6 τ_max(z),   HV = H/(9.807 MPa)

hard. τ_max(z) = (σ_max - σ_min)/2 has its maximum τ_max at 0.5 to 0.8 b below the surface; deeper
it falls, and where H(z) has come down to the hardness of the core, the case may end: `case_depth`.
That is for a load at rest without any permanent deformation; residual stresses, the steps of a real
hardness curve and fatigue are not in it.

SKF gives one number to compare: under C_0 and with a core of 350 HV about a tenth of the element's
diameter, which the formula gives of the usual grooves within a fifth (tests/validation).
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.contact.subsurface import axis_stresses
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import RACES, Solved
from rolamento.validate import numbers
from rolamento.words import said

__all__ = [
    "Hardening",
    "case_depth",
    "hardening_of",
    "hardness_needed",
    "rockwell_of_vickers",
    "vickers_of_rockwell",
]

_VICKERS: Final = 9.80665e6
"""Pa of one HV, a kgf/mm²."""
_SHEAR_TO_HARDNESS: Final = 6.0
_LINE: Final = 1e4
"""a/b from which on an ellipse is a line contact."""
_DEEPEST: Final = 200.0
"""z/b to which the case is looked for: there the shear is below a hundredth of the pressure."""
_HALVINGS: Final = 60
_ROCKWELL: Final = (20.0, 68.0)
"""HRC between which the conversion holds."""


def hardness_needed(shear: ArrayLike) -> FloatArray:
    """Hardness at which a shear stress leaves no permanent deformation; HV.

    Parameters
    ----------
    shear
        Maximum shear at the place, in Pa.

    Tabor (1951), with Tresca's criterion.

    >>> print(f"{hardness_needed(1.0e9):.0f} HV")
    612 HV
    """
    return np.asarray(_SHEAR_TO_HARDNESS * numbers(shear, "shear") / _VICKERS)


def vickers_of_rockwell(hardness: ArrayLike) -> FloatArray:
    """Convert Rockwell C hardness to Vickers: HV = (223 HRC + 14 500)/(100 - HRC).

    Parameters
    ----------
    hardness
        HRC; NaN outside 20 to 68.

    Schlecht, Maschinenelemente 2 (2010).

    >>> print(f"{vickers_of_rockwell(60.0):.0f} HV")
    697 HV
    """
    rockwell = numbers(hardness, "hardness")
    inside = (rockwell >= _ROCKWELL[0]) & (rockwell <= _ROCKWELL[1])
    value = (223.0 * rockwell + 14500.0) / (100.0 - np.where(inside, rockwell, 0.0))
    return np.where(inside, value, np.nan)


def rockwell_of_vickers(hardness: ArrayLike) -> FloatArray:
    """Convert Vickers hardness to Rockwell C, the reverse of `vickers_of_rockwell`.

    Parameters
    ----------
    hardness
        HV; NaN where that is outside 20 to 68 HRC.
    """
    vickers = numbers(hardness, "hardness")
    rockwell = (100.0 * vickers - 14500.0) / (223.0 + vickers)
    inside = (rockwell >= _ROCKWELL[0]) & (rockwell <= _ROCKWELL[1])
    return np.where(inside, rockwell, np.nan)


def case_depth(
    max_pressure: ArrayLike,
    semi_major: ArrayLike,
    semi_minor: ArrayLike,
    core_hardness: ArrayLike,
    poisson_ratio: ArrayLike = 0.3,
) -> FloatArray:
    """Depth below which a core of some hardness bears the stresses; m.

    Parameters
    ----------
    max_pressure
        p_0, in Pa.
    semi_major, semi_minor
        a ≥ b, in m; an infinite a is a line contact.
    core_hardness
        Of the core, in HV.
    poisson_ratio
        Of the ring.

    Returns
    -------
    array
        0 where the core bears the stresses everywhere and nothing needs to be hardened, or nothing
        presses.

    Raises
    ------
    InputError
        If the core has no hardness.

    >>> print(f"{1e3 * case_depth(4.2e9, 2.0e-3, 0.4e-3, 350.0):.2f} mm")
    1.24 mm
    """
    core = numbers(core_hardness, "core_hardness")
    if np.any(core <= 0.0):
        raise InputError(said("must be above zero"), field="core_hardness", example="350")
    p, a, b, core, nu = np.broadcast_arrays(
        numbers(max_pressure, "max_pressure"),
        np.asarray(semi_major, np.float64),
        numbers(semi_minor, "semi_minor"),
        core,
        numbers(poisson_ratio, "poisson_ratio"),
    )
    long = np.where(np.isfinite(a), np.minimum(a, _LINE * b), _LINE * b)

    def harder(depth: FloatArray) -> FloatArray:
        """By how much the place has to be harder than the core; HV."""
        s = axis_stresses(depth * b, p, long, b, nu)
        principal = np.stack([s.minor, s.major, s.normal])
        shear = 0.5 * (principal.max(axis=0) - principal.min(axis=0))
        return np.asarray(hardness_needed(shear) - core)

    steps = np.concatenate([np.linspace(0.0, 1.5, 31), np.geomspace(1.6, _DEEPEST, 60)])
    depths = steps.reshape(-1, *(1,) * p.ndim) + np.zeros(p.shape)
    above = np.stack([harder(depth) for depth in depths]) > 0.0
    last = np.where(above.any(axis=0), above.shape[0] - 1 - above[::-1].argmax(axis=0), 0)
    low = steps[last]
    high = steps[np.minimum(last + 1, len(steps) - 1)]
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        over = harder(middle) > 0.0
        low, high = np.where(over, middle, low), np.where(over, high, middle)
    found = np.where(above.any(axis=0), b * high, 0.0)
    return np.where(np.isnan(p) | np.isnan(b), np.nan, found)


@frozen(eq=False)
class Hardening:
    """Hardness that each race needs under its contact of the most pressure; (cases, rows), SI.

    Attributes
    ----------
    max_pressure
        p_0 there (Pa)
    shear, depth
        maximum shear and its depth (Pa, m)
    hardness
        needed there (HV)
    case_depth
        where the core bears the stresses (m)
    core_hardness
        of the core (HV)
    """

    max_pressure: FloatArray
    shear: FloatArray
    depth: FloatArray
    hardness: FloatArray
    case_depth: FloatArray
    core_hardness: float


def hardening_of(solved: Solved, core_hardness: float) -> dict[str, Hardening]:
    """Hardness and case depth that the races need in solved cases.

    Parameters
    ----------
    solved
        Of `rolamento.solve`.
    core_hardness
        Of the core below the case, in HV.

    Returns
    -------
    dict
        By race, "inner" and "outer".
    """
    rows = solved.rows
    nu = solved.case.bearing.ring_material.poisson_ratio
    lines = np.isfinite(rows.per_element(rows.effective_length))
    found: dict[str, Hardening] = {}
    for race in RACES:
        contacts = solved.contacts[race]
        worst = _most_pressed(solved, np.nan_to_num(contacts.max_pressure, nan=-1.0))
        p = _at(contacts.max_pressure, worst)
        a = _at(np.where(lines, np.inf, contacts.semi_major), worst)
        b = _at(contacts.semi_minor, worst)
        shear = _at(contacts.max_shear, worst)
        found[race] = Hardening(
            max_pressure=p,
            shear=shear,
            depth=_at(contacts.max_shear_depth, worst),
            hardness=hardness_needed(shear),
            case_depth=case_depth(p, a, b, core_hardness, nu),
            core_hardness=core_hardness,
        )
    return found


def _most_pressed(solved: Solved, pressure: FloatArray) -> NDArray[np.int64]:
    """Index of the element of each row with the most pressure; (cases, rows)."""
    starts = solved.rows.starts
    counts = solved.rows.element_count
    own = [
        start + pressure[:, start : start + count].argmax(axis=1)
        for start, count in zip(starts, counts, strict=True)
    ]
    return np.stack(own, axis=1)


def _at(values: FloatArray, index: NDArray[np.int64]) -> FloatArray:
    return np.take_along_axis(values, index, axis=1)
