"""Life by the stress in the volume, with a fatigue limit: Ioannides and Harris.

    ln(1/S) = Ā N^e ∫ ⟨τ - τ_u⟩^c / z'^h dV,   dV = 2πr dy dz,   e = 10/9, c = 31/3, h = 7/3

τ(y, z) is the amplitude of the orthogonal shear (`shear_field`); what stays below the limit τ_u
does no harm. Without a limit the integral over one contact grows with Q^(10/3), as in Lundberg and
Palmgren's theory. Ā of each race is set so that the life with τ_u = 0 is the reference life of
ISO/TS 16281; then, per race,

    L = L_16281 [R(0)/R(τ_u)]^(1/e),

with R the risk of the race: the mean of the balls' integrals on a ring that stands, and
(mean I^(1/e))^e, damage adding up by Miner's rule, on one that turns.

The depth z' is each point's own (the default), or the mean depth of the contact, weighted with
⟨τ - τ_u⟩^c.

There is no stress of the surface in it: no friction, no dents, no asperities. At the pressures of
clean, lightly loaded bearings life becomes very long; at 3 to 4 GPa of a thin, dirty film it is
wildly optimistic.

Source: Ioannides and Harris (1985); Campanha (2008), eq. 2.6.5; Lundberg and Palmgren (1947).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.subsurface import orthogonal_shear
from rolamento.errors import InputError
from rolamento.life.iso16281 import SLOPE, ReferenceLife, system_life
from rolamento.life.shear_field import FieldMesh, shear_integrals
from rolamento.life.theory import OF_BEARING, Theory
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import numbers, positive
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life
    from rolamento.solved import Contacts

Depth = Literal["local", "mean"]

FATIGUE_LIMIT: Final = 374e6
"""τ_u of bearing steel: the orthogonal shear under 1500 MPa of a usual contact ellipse; Pa."""
STRESS_EXPONENT: Final = 31.0 / 3.0
DEPTH_EXPONENT: Final = 7.0 / 3.0
_MAXIMUM_SHEAR: Final = 0.25
"""τ_0/p0 of a line contact; every ellipse has less."""


@frozen
class Ellipses:
    """Contacts: semi_major, semi_minor (m) and max_pressure (Pa); arrays of one shape."""

    semi_major: FloatArray
    semi_minor: FloatArray
    max_pressure: FloatArray


@frozen
class StressVolumeLife:
    """Life by stress volume: of the bearing (cases,), of its races (cases, rows); 10^6 rev."""

    life: FloatArray
    inner: FloatArray
    outer: FloatArray


def fatigue_limit_of_pressure(pressure: ArrayLike, ellipticity: ArrayLike) -> FloatArray:
    """Orthogonal shear under a contact of a given pressure: τ_u from a pressure limit; Pa.

    Parameters: arrays that broadcast, p0 (Pa) and a/b. 374 MPa for 1500 MPa and a/b of 8.
    """
    return orthogonal_shear(pressure, ellipticity, 1.0).amplitude


def risk_integral(
    contacts: Ellipses | Contacts,
    fatigue_limit: ArrayLike,
    *,
    depth: Depth = "local",
    mesh: FieldMesh | None = None,
) -> FloatArray:
    """∫∫ ⟨τ - τ_u⟩^c / z'^h dy dz under each contact.

    Parameters
    ----------
    contacts : ellipses of any shape; those without load give 0, NaN gives NaN.
    fatigue_limit : array that broadcasts with them, τ_u ≥ 0; Pa.
    depth : "local" or "mean".
    mesh : of the field.

    Returns
    -------
    Array of the contacts' shape; Pa^c m^(2-h).

    Raises
    ------
    InputError
        For an unknown depth, or a negative limit.
    """
    if depth not in get_args(Depth):
        raise InputError(
            said("must be local or mean"), field="depth", value=depth, example='"local"'
        )
    limit = positive(fatigue_limit, "fatigue_limit", zero=True)
    a, b, p0, limit = np.broadcast_arrays(
        contacts.semi_major, contacts.semi_minor, contacts.max_pressure, limit
    )
    result = np.where(np.isnan(p0), np.nan, 0.0)
    with np.errstate(invalid="ignore"):
        harmed = (p0 > 0.0) & (limit < _MAXIMUM_SHEAR * p0)
    a, b, p0 = a[harmed], b[harmed], p0[harmed]
    found = shear_integrals(
        limit[harmed] / p0,
        a / b,
        stress_exponent=STRESS_EXPONENT,
        depth_exponent=DEPTH_EXPONENT,
        mesh=mesh,
    )
    shape = found.local
    if depth == "mean":
        shape = np.where(found.plain > 0.0, found.plain * found.mean_depth**-DEPTH_EXPONENT, 0.0)
    result[harmed] = p0**STRESS_EXPONENT * a * b ** (1.0 - DEPTH_EXPONENT) * shape
    return np.asarray(result)


def race_risk(integral: ArrayLike, *, turning: ArrayLike, slope: float = SLOPE) -> FloatArray:
    """Risk of a race from its balls' integrals.

    Parameters
    ----------
    integral : array (…, Z).
    turning : array that broadcasts with (…), whether the race turns against the load.
    slope : Weibull's e.

    Returns
    -------
    Array (…), in the unit of the integrals.
    """
    one = numbers(integral, "integral")
    by_damage = np.mean(one ** (1.0 / slope), axis=-1) ** slope
    return np.asarray(np.where(turning, by_damage, np.mean(one, axis=-1)))


def stress_volume_life(
    reference: ReferenceLife,
    inner: Ellipses | Contacts,
    outer: Ellipses | Contacts,
    row_starts: tuple[int, ...] = (0,),
    *,
    fatigue_limit: ArrayLike = FATIGUE_LIMIT,
    inner_turning: ArrayLike = True,
    outer_turning: ArrayLike = False,
    depth: Depth = "local",
    mesh: FieldMesh | None = None,
) -> StressVolumeLife:
    """Life by stress volume of solved cases, calibrated by their reference life.

    Parameters
    ----------
    reference : reference life of the same cases, without fatigue limit.
    inner, outer : contacts of the races, (cases, balls), row after row.
    row_starts : index of each row's first ball.
    fatigue_limit : τ_u, one number or an array (cases,); Pa.
    inner_turning, outer_turning : as `reference_life`.
    depth, mesh : as `risk_integral`.

    Returns
    -------
    StressVolumeLife; infinite where no point of a race exceeds the limit.
    """
    limit = numbers(fatigue_limit, "fatigue_limit").reshape(-1, 1)
    races = []
    for contacts, basic, turning in (
        (inner, reference.inner, inner_turning),
        (outer, reference.outer, outer_turning),
    ):
        risks = [
            np.stack(
                [
                    race_risk(row, turning=turning)
                    for row in np.split(
                        risk_integral(contacts, tau, depth=depth, mesh=mesh), row_starts[1:], axis=1
                    )
                ],
                axis=1,
            )
            for tau in (np.zeros((1, 1)), limit)
        ]
        with np.errstate(divide="ignore", invalid="ignore"):
            gain = np.where(risks[0] > 0.0, (risks[0] / risks[1]) ** (1.0 / SLOPE), 1.0)
        races.append(np.where(np.isnan(risks[0]), np.nan, basic * gain))
    return StressVolumeLife(system_life(np.concatenate(races, axis=1)), *races)


def material_constant(
    life: ArrayLike,
    risk: ArrayLike,
    cycles_per_revolution: ArrayLike,
    race_radius: ArrayLike,
) -> FloatArray:
    """Ā that gives a race a life: ln(1/0.9) = Ā N^e 2πr R; SI (Pa^-c m^(h-3)).

    Parameters
    ----------
    life : array, of the race for 90 %; millions of revolutions.
    risk : array, of the race.
    cycles_per_revolution : array, balls that pass a point while the rings turn once: Z (1 ± γ)/2.
    race_radius : array, r; m.
        All broadcast against each other.
    """
    cycles = numbers(life, "life") * 1e6 * numbers(cycles_per_revolution, "cycles_per_revolution")
    volume = 2.0 * np.pi * numbers(race_radius, "race_radius") * numbers(risk, "risk")
    return np.asarray(-np.log(0.9) / (cycles**SLOPE * volume))


def _evaluate(basis: Basis) -> Life:
    (inner, outer), reference = basis.turning, basis.reference
    found = stress_volume_life(
        reference,
        basis.solved.inner,
        basis.solved.outer,
        tuple(basis.solved.rows.starts.tolist()),
        fatigue_limit=basis.over_cases("fatigue_limit"),
        inner_turning=inner,
        outer_turning=outer,
        depth=basis.given.depth,
    )
    notes = {
        "no_surface_stress": np.ones(len(basis), dtype=np.bool_),
        "below_fatigue_limit": np.isinf(found.life) & np.isfinite(reference.life),
    }
    return basis.record(THEORY.name, found.life, {"a_1": basis.reliability_factor}, notes)


THEORY: Final = Theory(
    name="ioannides_harris",
    evaluate=_evaluate,
    of_balls=True,
    validity=(*OF_BEARING, "theory_of_balls"),
    rank=4,
    bound=True,
    slow=True,
)
