"""Rolling resistance of a lubricated contact: the oil that is pressed back at the inlet.

Biboulet and Houpert (2010), part 2, point contacts, from the isoviscous-rigid to the
piezoviscous-elastic regime. With κ = b/a, E' = 2/[(1-ν₁²)/E₁ + (1-ν₂²)/E₂], u the mean speed of
the surfaces, W = Q/(E' R_x²), U = 2 η₀ u/(E' R_x) and β = b E'/(π p0 R_x):

    M = β^¼ κ W U^(-¾)
    F_R = 2 a R_x E' [(0.77 β^(-⅓) κ^0.12 U^(-1/12) - 1.8 β^(-¼))/(1 + M/6.6) + 1.8 β^(-¼)] U^¾

F_R holds each of the two surfaces back, so the contact takes the power 2 F_R u. It is isothermal
and fully flooded; what heat in the inlet and lack of oil leave of it is as for rollers and for the
film (`lubrication.films.resistance_left`).

The formula is given here as the open source of NSK's D-BRAIN has it (Tribology.cpp; its own test
has the value with the exponent -1/3, which an integer division in the code turns into 0). One
thing is read otherwise: there F_R R_x is the whole moment between ball and ring, which would be
half the power. That F_R is the force on one surface is decided by Kapitza's solution for a rigid
sphere (docs/theory/friction.md).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento.friction.model import ContactLoss
from rolamento.friction.slip import Patch, solved_motion
from rolamento.geometry import Race
from rolamento.lubrication.films import has_film, resistance_left
from rolamento.numerics import FloatArray
from rolamento.solved import RACES, Solved
from rolamento.validate import positive


def rolling_force(
    patch: Patch,
    rolling_curvature: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    speed: ArrayLike,
) -> FloatArray:
    """Force F_R of the oil on each surface, against its motion; N.

    Parameters
    ----------
    patch : contacts, arrays (...).
    rolling_curvature : 1/R_x, summed over both bodies; 1/m.
    modulus : E'; Pa.
    viscosity : η₀ of the oil at the inlet; Pa·s.
    speed : u, mean speed of the surfaces through the contact; m/s.

    Returns
    -------
    F_R of the broadcast shape; 0 without load, viscosity or speed.
    """
    e, radius = np.asarray(modulus), 1.0 / np.asarray(rolling_curvature)
    rate = 2.0 * np.asarray(viscosity) * np.abs(speed) / (e * radius)
    with np.errstate(invalid="ignore", divide="ignore"):
        works = (patch.load > 0.0) & (rate > 0.0)
        flat = patch.semi_minor / patch.semi_major
        beta = patch.semi_minor * e / (np.pi * patch.max_pressure * radius)
        load = patch.load / (e * radius**2)
        fourth = np.sqrt(np.sqrt(beta))
        three_fourths = np.sqrt(rate * np.sqrt(rate))
        elastic = 1.8 / fourth
        powers = 0.12 * np.log(flat) - np.log(beta) / 3.0 - np.log(rate) / 12.0
        rigid = 0.77 * np.exp(powers)
        regime = fourth * flat * load / three_fourths
        mixed = (rigid - elastic) / (1.0 + regime / 6.6) + elastic
        force = 2.0 * patch.semi_major * mixed * three_fourths * e * radius
    return np.asarray(np.where(works, force, 0.0 * patch.load))


def rolling_resistance_loss(solved: Solved, viscosity: ArrayLike) -> ContactLoss:
    """Power of rolling resistance in every contact as it was solved; W.

    viscosity : η₀ at the inlet, a number or (cases,); Pa·s. Without an oil in the case, whose
    other properties then are not known, the resistance is isothermal and fully flooded.

    Raises
    ------
    InputError
        If a viscosity is negative.
    """
    eta = positive(viscosity, "dynamic_viscosity", zero=True, finite=True).reshape(-1, 1)
    eta = np.broadcast_to(eta, (len(solved), 1))
    return ContactLoss(*(_loss_of_race(solved, race, eta) for race in RACES))


def _loss_of_race(solved: Solved, race: Race, viscosity: FloatArray) -> FloatArray:
    """2 F_R u, with the speed u = ω_roll R_x of pure rolling."""
    contacts = solved.contacts[race]
    curvature = contacts.rolling_curvature
    yaws = solved.elements.yaw.any()
    roll = solved_motion(solved, race, yawing=False).roll if yaws else contacts.roll
    speed = np.abs(roll) / curvature
    force = rolling_force(Patch.of(contacts), curvature, contacts.modulus, viscosity, speed)
    if has_film(solved):
        force = force * resistance_left(solved, race, viscosity)
    return np.asarray(np.where(solved.balls_bear, 2.0 * force * speed, 0.0))
