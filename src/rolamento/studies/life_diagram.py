"""Life over load, like a diagram of stress over cycles, and over the load zone, of a state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.duty import LOADS
from rolamento.errors import InputError
from rolamento.life import Life, LifeSummary, conditions_of, life, life_of_batch
from rolamento.life.iso16281 import race_ratings
from rolamento.life.load_zone import clearance_function, load_zone, zone_life
from rolamento.numerics import FloatArray
from rolamento.state import State
from rolamento.static._common import race_stiffness
from rolamento.studies.outputs import Solved
from rolamento.studies.pressure import greatest_pressure
from rolamento.studies.solving import solve

__all__ = ["LoadLives", "ZoneLife", "lives_over_load", "lives_over_zone"]

_LEAST, _MOST = 0.02, 1.0
"""P/C from which and to which the lives go, at least."""
_REACH: Final = 3.0
"""The load is made so many times smaller and greater, at least."""
_POINTS: Final = 40
_NARROWEST, _WIDEST, _ZONES = 0.1, 3.0, 2901
_PURE: Final = 1e-6
"""Axial load or moment over the radial load, up to which the load is radial."""


@dataclass(frozen=True, slots=True, eq=False)
class LoadLives:
    """Lives of a case whose forces and moments all grow by one factor.

    Attributes
    ----------
    case
        the one that was solved
    factor
        of the loads, (points,), rising; 1 among them
    load
        P/C, (points,)
    by_reference
        whether P is that of ISO/TS 16281, for a bearing for which ISO 281 has none
    pressure
        greatest pressure of all contacts, (points,), Pa
    theories
        by name, arrays (points,)
    fatigue_load
        C_u/C
    own
        index of the case itself, where the factor is 1
    """

    case: Case
    factor: FloatArray
    load: FloatArray
    by_reference: bool
    pressure: FloatArray
    theories: Mapping[str, Life]
    fatigue_load: float
    own: int


@dataclass(frozen=True, slots=True, eq=False)
class ZoneLife:
    """Life of a bearing under radial load over its load zone, by ISO/TS 16281.

    Attributes
    ----------
    case
        the bearing's
    zone
        ε, (points,), rising: the part of its diameter on which the ring carries
    life_ratio
        life over that at ε = 0.5, without clearance, (points,)
    clearance
        diametral, that makes these zones under the case's load, (points,), m; NaN if its load is
        not radial
    own
        ε of the case and its life ratio; None if its load is not radial, or it has no clearance
    """

    case: Case
    zone: FloatArray
    life_ratio: FloatArray
    clearance: FloatArray
    own: tuple[float, float] | None

    @property
    def best(self) -> tuple[float, float]:
        """ε with the longest life, and its life ratio."""
        place = int(np.argmax(self.life_ratio))
        return float(self.zone[place]), float(self.life_ratio[place])


def lives_over_load(state: State, *, points: int = _POINTS) -> LoadLives:
    """Lives by every theory under loads smaller and greater than a case's.

    Parameters
    ----------
    state
        Of `rolamento.solve`, with a result; its case has a life.
    points
        How many beside the case itself, from P/C of 0.02 to 1.

    Raises
    ------
    InputError
        If no load acts on the ring, or the case has no life.
    """
    case = state.case
    given = {name: getattr(case.duty.load, name) for name in LOADS}
    acting = {name: value for name, value in given.items() if value}
    own = life(state, stress_volume=False)
    by_reference = bool(np.isnan(own.loads.dynamic[0]))
    load = float(_load_over_rating(own, by_reference)[0])
    if not acting or not load > 0.0:
        raise InputError(
            "is missing: life over load needs forces on the ring",
            field="case.duty.load",
            example='fz = "10 kN"',
        )
    factor, place = _factors(load, points)
    values = {f"duty.load.{name}": value * factor for name, value in acting.items()}
    batch = solve(case, values, cases=len(factor), threads=None)
    found = life_of_batch(case, batch, conditions_of(case), stress_volume=True)
    return LoadLives(
        case=case,
        factor=factor,
        load=_load_over_rating(found, by_reference),
        by_reference=by_reference,
        pressure=_greatest_pressure(Solved(batch, case)),
        theories=found.theories,
        fatigue_load=float(own.ratings.fatigue_of_set[0] / own.ratings.dynamic_of_set[0]),
        own=place,
    )


def lives_over_zone(state: State) -> ZoneLife:
    """Life over the load zone of a solved case's bearing.

    Raises
    ------
    InputError
        If the bearing is a set, has a contact angle, or has no life.
    """
    case, bearing = state.case, state.case.bearing
    if bearing.is_set or bearing.contact_angle:
        raise InputError(
            "needs a single bearing of radial contact, given by its clearance",
            field="case.bearing",
            example="diametral_clearance in the place of contact_angle",
        )
    ratings = race_ratings(
        life(state, stress_volume=False).ratings.dynamic[0, 0],
        bearing.ball_count,
        bearing.ball_diameter,
        bearing.pitch_diameter,
        bearing.inner_conformity,
        bearing.outer_conformity,
        0.0,
    )
    zone = np.linspace(_NARROWEST, _WIDEST, _ZONES)
    scale = _clearance_scale(state)
    own = None
    if np.isfinite(scale) and bearing.diametral_clearance is not None:
        epsilon = float(load_zone(bearing.diametral_clearance / scale, 1.0, 1.0, 1.0))
        if np.isfinite(epsilon):
            own = epsilon, float(zone_life(epsilon, ratings))
    return ZoneLife(
        case=case,
        zone=zone,
        life_ratio=zone_life(zone, ratings),
        clearance=scale * clearance_function(zone),
        own=own,
    )


def _clearance_scale(state: State) -> float:
    """(F_r/(Z K))^(2/3), by which f(ε) gives the clearance, m; NaN if the load is not radial."""
    load = state.load
    radial = float(np.hypot(load.fy, load.fz))
    arm = state.case.bearing.pitch_diameter
    others = (load.fx, load.my / arm, load.mz / arm)
    if not radial > 0.0 or max(map(abs, others)) > _PURE * radial:
        return float("nan")
    stiffness = float(race_stiffness(state.case.bearing, 0.0).combined)
    return float((radial / (state.case.bearing.ball_count * stiffness)) ** (2.0 / 3.0))


def _factors(load: float, points: int) -> tuple[FloatArray, int]:
    """Factors of the load, 1 among them, and where it is."""
    first = min(_LEAST / load, 1.0 / _REACH)
    last = max(_MOST / load, _REACH)
    factor = np.unique(np.append(np.geomspace(first, last, points), 1.0))
    return factor, int(np.searchsorted(factor, 1.0))


def _load_over_rating(found: LifeSummary, by_reference: bool) -> FloatArray:
    load = found["iso16281"].factors["equivalent_load"] if by_reference else found.loads.dynamic
    return np.asarray(load / found.ratings.dynamic_of_set)


def _greatest_pressure(solved: Solved) -> NDArray[np.float64]:
    return np.fmax(greatest_pressure(solved, "inner"), greatest_pressure(solved, "outer"))
