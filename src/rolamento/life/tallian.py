"""Tallian's form of the life equation: a product of factors, for each origin of failure.

    -ln S = φ0 φ1 φ2 φ3 φ4 N^s,   s = ψ μ/ζ

φ0 is the strength of the material, φ1 the shape of the defect and the elasticity, φ2 the density
of defects, φ3 the distribution of the failure rate, φ4 that of the pressure round the race.
Failures from below the surface and from the surface have factors of their own (φ1 of the surface is
1), and their risks add up. The constants were never published: every factor is the user's.

With φ0 = A, φ1 = φ2 = 1 and φ3 φ4 = ∫ a z_0 τ_0^c/z_0^h dl the form is that of Lundberg and
Palmgren (table 2.6.1), and that is what a factor is that the user does not give: A of each race is
then such that the race has its reference life by ISO/TS 16281, and the integral is that of the
solved contacts. Of failures from the surface all factors have to be given.

Source: Tallian (1971) and Chiu, Tallian and McCool (1971), as in Campanha (2008), eq. 2.6.3 and
table 2.6.1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.life_model import TallianFactors
from rolamento.errors import InputError
from rolamento.life.ioannides_harris import DEPTH_EXPONENT, STRESS_EXPONENT, race_risk
from rolamento.life.reliability import RATING_RELIABILITY
from rolamento.life.spectrum import shaft_life
from rolamento.life.theory import OF_BEARING, OF_LOAD, Need, Theory
from rolamento.numerics import BoolArray, FloatArray
from rolamento.validate import positive, within
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.geometry import Race
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life

_FACTORS: Final = (
    "strength",
    "defect_shape",
    "defect_density",
    "failure_rate",
    "pressure_distribution",
)


def product(factors: TallianFactors) -> float:
    """φ0 φ1 φ2 φ3 φ4; InputError if one of them is not given."""
    for name in _FACTORS:
        if getattr(factors, name) is None:
            raise InputError(
                said("is missing: the constants of Tallian's model are not public"),
                field=name,
                example="1.0",
            )
    return float(np.prod([getattr(factors, name) for name in _FACTORS]))


def risk(factors: TallianFactors, cycles: ArrayLike) -> FloatArray:
    """-ln S after N stress cycles. Parameters: the factors, and an array of N ≥ 0."""
    return np.asarray(product(factors) * positive(cycles, "cycles", zero=True) ** factors.exponent)


def survival(factors: tuple[TallianFactors, ...], cycles: ArrayLike) -> FloatArray:
    """Reliability S after N stress cycles, of all origins together: exp(-Σ risk)."""
    total = np.sum([risk(origin, cycles) for origin in factors], axis=0)
    return np.asarray(np.exp(-total))


def tallian_life(
    factors: TallianFactors, reliability: ArrayLike = RATING_RELIABILITY
) -> FloatArray:
    """Stress cycles that a share S of the contacts survives, by one origin of failure.

    Parameters
    ----------
    factors : of the origin, all of them.
    reliability : array, S.
    """
    s = within(
        reliability, "reliability", "", 0.01, 0.999999, example="reliability = 0.9", nan_too=False
    )
    return np.asarray((-np.log(s) / product(factors)) ** (1.0 / factors.exponent))


def lundberg_palmgren_integral(
    semi_major: ArrayLike, shear: ArrayLike, shear_depth: ArrayLike, race_length: ArrayLike
) -> FloatArray:
    """φ3 φ4 with which Tallian's form is that of Lundberg and Palmgren, for one uniform load.

    Parameters
    ----------
    semi_major : array, a of the contact; m.
    shear, shear_depth : arrays, τ_0 (Pa) and z_0 (m).
    race_length : array, circumference of the race; m.
        All broadcast against each other.

    Campanha (2008), table 2.6.1: a z_0 τ_0^c z_0^-h l, c = 31/3, h = 7/3; 0 without load.
    """
    tau, depth = (
        positive(shear, "shear", zero=True), positive(shear_depth, "shear_depth", zero=True)
    )  # fmt: skip
    volume = np.asarray(semi_major) * np.where(depth > 0.0, depth, 1.0) ** (1.0 - DEPTH_EXPONENT)
    return np.asarray(np.asarray(race_length) * volume * tau**STRESS_EXPONENT)


def _gamma(basis: Basis) -> FloatArray:
    """D cos α/d_m of the rows, (cases, rows)."""
    rows = basis.solved.rows
    return rows.ball_diameter * np.cos(basis.contact_angle) / rows.pitch_diameter


def _race_integrals(basis: Basis, race: Race, turning: BoolArray, slope: float) -> FloatArray:
    """φ3 φ4 of the rows of a race by Lundberg and Palmgren, (cases, rows)."""
    rows, contacts = basis.solved.rows, basis.solved.contacts[race]
    integral = lundberg_palmgren_integral(
        contacts.semi_major, contacts.orthogonal_shear, contacts.orthogonal_shear_depth, 1.0
    )
    integral = np.where(contacts.load == 0.0, 0.0, integral)
    of_rows = np.split(integral, rows.starts[1:], axis=1)
    mean = np.stack([race_risk(row, turning=turning, slope=slope) for row in of_rows], axis=1)
    sign = -1.0 if race == "inner" else 1.0
    return np.asarray(mean * np.pi * rows.pitch_diameter * (1.0 + sign * _gamma(basis)))


def _cycles(basis: Basis) -> FloatArray:
    """Stress cycles of the races in a million revolutions, (cases, races)."""
    gamma, half = _gamma(basis), 0.5e6 * basis.solved.rows.element_count
    return np.concatenate([half * (1.0 + gamma), half * (1.0 - gamma)], axis=1)


def _subsurface(basis: Basis, factors: TallianFactors) -> FloatArray:
    """Risk of the races below the surface after a million revolutions, (cases, races)."""
    s, given = factors.exponent, factors.defect_shape * factors.defect_density
    if factors.strength is None:
        races = np.concatenate([basis.reference.inner, basis.reference.outer], axis=1)
        return np.asarray(-np.log(RATING_RELIABILITY) * given * races**-s)
    if factors.failure_rate is not None:
        distribution: FloatArray | float = product(factors) / (factors.strength * given)
    else:
        inner, outer = basis.turning
        distribution = np.concatenate(
            [
                _race_integrals(basis, "inner", inner, s),
                _race_integrals(basis, "outer", outer, s),
            ],
            axis=1,
        )
    return np.asarray(factors.strength * given * distribution * _cycles(basis) ** s)


def _evaluate(basis: Basis) -> Life:
    below = basis.given.tallian_subsurface or TallianFactors()
    surface = basis.given.tallian_surface
    # a risk after a million revolutions and an exponent for each origin
    origins = [(_subsurface(basis, below).sum(axis=1), below.exponent)]
    if surface is not None:
        cycles = _cycles(basis) ** surface.exponent
        origins.append((product(surface) * cycles.sum(axis=1), surface.exponent))

    def life_for(reliability: float) -> FloatArray:
        lives = np.broadcast_arrays(
            np.empty(len(basis)),
            *((-np.log(reliability) / risk) ** (1.0 / exponent) for risk, exponent in origins),
        )[1:]
        return shaft_life(np.stack(lives, axis=-1), slope=[exponent for _, exponent in origins])

    with np.errstate(divide="ignore", invalid="ignore"):
        basic = life_for(RATING_RELIABILITY)
        factor = life_for(basis.given.reliability) / basic
    notes = {
        **basis.notes_on_reference_load(),
        "factors_of_the_user": np.ones(len(basis), dtype=np.bool_),
        "surface_left_out": np.full(len(basis), surface is None),
    }
    return basis.record(THEORY.name, basic, {"a_1": factor}, notes)


FACTORS: Final = Need(
    "tallian factors",
    marked("factors of Tallian's form"),
    "[life.tallian_subsurface] with defect_density = 0.5 in the case",
    ("tallian_subsurface", "tallian_surface"),
)
THEORY: Final = Theory(
    name="tallian",
    evaluate=_evaluate,
    of_balls=True,
    asked=lambda basis: (
        basis.given.tallian_subsurface is not None or basis.given.tallian_surface is not None
    ),
    needs=(FACTORS,),
    validity=(*OF_BEARING, *OF_LOAD, "theory_of_balls"),
    rank=7,
    refuses=True,
)
