"""What a line contact of a roller loses: oil at the inlet, elastic hysteresis, slip, the rib.

Per unit of length, for the load q of a slice and the mean speed u of the surfaces.

*Oil at the inlet*, Aihara (1987), equations 19, 21 and 27: a force t on each surface, so that the
contact takes the power 2 t u. With G = α E', U = η₀ u/(E' R), W = q/(E' R), L = η₀ b u²/k_f,

    t = 88 R/α (G U)^0.658 W^0.31/(1 + 0.29 L^0.78)

from the computed rolling resistance of Goksem and Hargreaves (1978), whose load and factor the
torque of some two hundred tapered roller bearings and a two-disc machine corrected; the denominator
is `lubrication.film_thickness.aihara`. Fully flooded; oil bath or circulation. Biboulet and Houpert
(2010, part 1) computed

    t = E' R 1.42 (U W)^½/(1 + (0.9655 (W/√U)^½)^10)^0.1,   here with U = 2 η₀ u/(E' R)

without an influence of load beyond a light one; theirs is isothermal.

*Elastic hysteresis*: M = α_h q 2b/(3π) about the axis of rolling (Johnson, Contact Mechanics, 1985,
section 9.1): as for balls, of the work that the front half of the contact does a part α_h is lost.

*Slip along the roller*: where the apex of a tapered roller is not on the bearing's axis, the
contact rolls at one place only and slips elsewhere at the rate of its spin. Without a force along
rolling the slip changes sign where half of the load lies on either side.

*Rib*: Coulomb's friction of the load that asperities carry, Aihara (1987), equation 14:
μ = μ₀ exp(-1.8 Λ^1.2), with Λ = 1.25 h_0/σ and h_0 the minimum film by Hamrock and Dowson. The
shear of a full film there, with a coefficient below 0.01, is not counted, as in the source.
"""

from __future__ import annotations

from math import pi
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray

RIB_COEFFICIENT: Final = 0.2
"""μ₀ between roller end and rib as asperities carry it all, and at the start. Aihara (1987); NSK,
Rolling Bearings (E1102m), section 15.4."""

RIB_FILM: Final = 1.25
"""Film in the middle over the minimum film by Hamrock and Dowson. Aihara (1987), equation 16."""


def inlet_force(
    load_per_length: ArrayLike,
    curvature: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity: ArrayLike,
    speed: ArrayLike,
) -> FloatArray:
    """Force t of the oil on each surface per length of contact, against its motion; N/m.

    Parameters
    ----------
    load_per_length : q; N/m.
    curvature : 1/R, summed over both bodies along rolling; 1/m.
    modulus : E'; Pa.
    viscosity, pressure_viscosity : η₀ and α of the oil at the inlet; Pa·s, 1/Pa.
    speed : u, mean speed of the surfaces through the contact; m/s.

    Returns
    -------
    t of the broadcast shape, isothermal and fully flooded; 0 without load, viscosity or speed.

    Aihara (1987), equation 27 without the factor 2 R of its moment and the factor of heat.
    """
    e, radius = np.asarray(modulus), 1.0 / np.asarray(curvature)
    q, alpha = np.asarray(load_per_length), np.asarray(pressure_viscosity)
    rate = np.asarray(viscosity) * np.abs(speed) / (e * radius)
    with np.errstate(invalid="ignore", divide="ignore"):
        works = (q > 0.0) & (rate > 0.0)
        force = 88.0 * radius / alpha * (alpha * e * rate) ** 0.658 * (q / (e * radius)) ** 0.31
    return np.asarray(np.where(works, force, 0.0 * q))


def computed_inlet_force(
    load_per_length: ArrayLike,
    curvature: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    speed: ArrayLike,
) -> FloatArray:
    """The same by Biboulet and Houpert (2010), part 1, equation 42: isothermal, fully flooded; N/m.

    Parameters as of `inlet_force`. From the rigid roller in a fluid of constant viscosity, t = 1.42
    E' R √(U W), to the elastic contact, t = 1.47 E' R U^¾, whatever its load.
    """
    e, radius, q = np.asarray(modulus), 1.0 / np.asarray(curvature), np.asarray(load_per_length)
    rate = 2.0 * np.asarray(viscosity) * np.abs(speed) / (e * radius)
    with np.errstate(invalid="ignore", divide="ignore"):
        load = q / (e * radius)
        blend = (1.4 / 1.45) ** 10 * (load / np.sqrt(rate)) ** 5
        force = 1.42 * np.sqrt(rate * load) / (1.0 + blend) ** 0.1 * e * radius
    return np.asarray(np.where((q > 0.0) & (rate > 0.0), force, 0.0 * q))


def line_hysteresis(
    load_per_length: ArrayLike, half_width: ArrayLike, loss: ArrayLike
) -> FloatArray:
    """Moment of elastic hysteresis about the axis of rolling per length: α_h q 2b/(3π); N.

    Parameters: q (N/m), b (m), α_h, arrays that broadcast. Johnson (1985), section 9.1.
    """
    width = 2.0 * np.asarray(half_width) / (3.0 * pi)
    return np.asarray(np.asarray(loss) * np.asarray(load_per_length) * width)


def curved_slip_moment(
    load_per_length: FloatArray, place: FloatArray, curvature: FloatArray
) -> FloatArray:
    """Return ∫ q |x² - x_0²|/(2R) dx along a contact that is curved; N·m.

    Parameters
    ----------
    load_per_length, place
        (..., slices), q at the middles x of slices of one width; N/m, m.
    curvature
        (...), 1/R of the pressed surface in the plane of the roller's axis; 1/m.

    Returns
    -------
    Array (...): times μ and the roll it is the power of friction of a roller whose middle runs
    ahead and whose ends lag behind. Two lines at ±x_0 roll truly, half of the load between them,
    so that the tractions balance. Heathcote (1921); Harris (1991), chapter 14.
    """
    q = np.nan_to_num(load_per_length)
    width = place[..., 1:2] - place[..., :1]
    square = place**2
    order = np.argsort(square, axis=-1, kind="stable")
    below = np.cumsum(np.take_along_axis(q, order, axis=-1), axis=-1)
    half = np.argmax(below >= 0.5 * below[..., -1:], axis=-1)[..., np.newaxis]
    rolls = np.take_along_axis(np.take_along_axis(square, order, axis=-1), half, axis=-1)
    apart = (q * np.abs(square - rolls)).sum(axis=-1) * width[..., 0]
    return np.asarray(0.5 * np.nan_to_num(curvature) * apart)


def slip_moment(load_per_length: FloatArray, place: FloatArray) -> FloatArray:
    """∫ q |x - x_0| dx along the contact, half of the load lying beyond x_0; N·m.

    Parameters
    ----------
    load_per_length, place : (..., slices), q at the middles x of slices of one width; N/m, m.

    Returns
    -------
    (...); times μ and the spin it is the power of friction of a contact that spins and rolls.
    x_0 is found within its slice, so that a uniform load gives q l²/4 exactly.
    """
    q = np.nan_to_num(load_per_length)
    width = place[..., 1:2] - place[..., :1]
    total = q.sum(axis=-1, keepdims=True)
    below = np.cumsum(q, axis=-1)
    here = np.argmax(below >= 0.5 * total, axis=-1)[..., np.newaxis]
    at = np.take_along_axis(q, here, axis=-1)
    before = np.take_along_axis(below, here, axis=-1) - at
    with np.errstate(invalid="ignore", divide="ignore"):
        inside = np.where(at > 0.0, (0.5 * total - before) / at, 0.5)
    middle = np.take_along_axis(place, here, axis=-1) + (inside - 0.5) * width
    lever = np.abs(place - middle)
    own = np.abs(place - middle) < 0.5 * width
    split = np.where(own, (lever**2 + 0.25 * width**2) / width, lever)
    return np.asarray((q * split * width).sum(axis=-1))


def rib_coefficient(film_parameter: ArrayLike, boundary: ArrayLike = RIB_COEFFICIENT) -> FloatArray:
    """Coefficient of friction between roller end and rib under a film: μ₀ exp(-1.8 Λ^1.2).

    Parameters: Λ, at least 0; μ₀. Aihara (1987), equation 14, for roughness along the motion.
    """
    parameter = np.asarray(film_parameter, dtype=np.float64)
    return np.asarray(np.asarray(boundary) * np.exp(-1.8 * parameter**1.2))


def starting_torque(
    axial_load: ArrayLike,
    rib_height: ArrayLike,
    half_angle: ArrayLike,
    coefficient: ArrayLike = RIB_COEFFICIENT,
) -> FloatArray:
    """Starting torque of a tapered roller bearing under axial load: M = e μ F_a cos β; N·m.

    Parameters
    ----------
    axial_load : F_a of one bearing; N. A preloaded pair takes twice the torque of one bearing.
    rib_height : e, of the contact on the roller's end over the inner raceway; m.
    half_angle : β, of the roller; rad.
    coefficient : μ at the rib, 0.2.

    NSK, Rolling Bearings (E1102m), section 15.4; Aihara (1987), equation 11. Of a new bearing, not
    run in, with rust-preventive oil or fresh grease; running in lowers it.
    """
    return np.asarray(
        np.asarray(rib_height)
        * np.asarray(coefficient)
        * np.abs(np.asarray(axial_load, dtype=np.float64))
        * np.cos(half_angle)
    )
