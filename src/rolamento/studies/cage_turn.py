"""A turn of the cage: a new equilibrium for each instant, until the next ball stands in place.

Quasi-static: at every azimuth of the first ball the bearing is in balance, and what changes from
one instant to the next is only where the balls stand. Displacement and stiffness then repeat with
every ball that passes under the load: the variable compliance of a rolling bearing.

Sources: Sunnersjö, Journal of Sound and Vibration 58 (1978) 363; Radaelli (2013), chapter 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from math import gcd, pi
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.contact.hertz import effective_modulus, elliptical_contact
from rolamento.errors import InputError
from rolamento.geometry import Race, race_curvature
from rolamento.rows.ball import BatchState
from rolamento.solution import solve, solve_batch

if TYPE_CHECKING:
    from rolamento.rows.ball.detail import BallTable, ContactTable

__all__ = [
    "DEFAULT_POINTS",
    "LEAST_POINTS",
    "MOST_POINTS",
    "ROUNDING",
    "BallHistory",
    "CageSpeed",
    "CageTurn",
    "ContactHistory",
    "Quantity",
    "Variation",
    "cage_turn",
]

Floats = NDArray[np.float64]
Quantity = Literal["displacement", "load", "stiffness"]

LEAST_POINTS: Final = 4
MOST_POINTS: Final = 4096
DEFAULT_POINTS: Final = 256
"""Keeps the first harmonics to 1e-6 and the extremes of the stiffness to 2 % where balls leave the
load zone, and everything to rounding where all stay loaded: see
docs/theory/variable-compliance.md."""

ROUNDING: Final = 1e-9
"""Of the greatest of its kind: a variation below is rounding of the solver, and given as zero."""

_LOADED: Final = 0.01  # of the heaviest ball: one that carries less follows the cage
_STANDSTILL: Final = 1e-9  # of the rings' speeds: below, the cage stands still


@dataclass(frozen=True, slots=True)
class CageSpeed:
    """Orbital speed of the loaded balls about the shaft axis, over balls and instants; rad/s.

    Raceway control gives every ball an orbital speed of its own; a cage has one. Its speed is
    taken to be the plain mean over the balls that carry at least a hundredth of the heaviest
    ball's inner load. Positive about +x, like the rings' speeds.
    """

    mean: float
    least: float
    greatest: float

    @property
    def spread(self) -> float:
        """Greatest less least, over the mean; NaN where the cage stands still."""
        return (self.greatest - self.least) / abs(self.mean) if self.mean else float("nan")


@dataclass(frozen=True, slots=True, eq=False)
class ContactHistory:
    """One race's contact of a ball on its way round: arrays over the azimuths of `BallHistory`.

    load (N), contact_angle (rad), max_pressure (Pa).
    """

    load: Floats
    contact_angle: Floats
    max_pressure: Floats

    @property
    def heaviest(self) -> int:
        """Where the load is greatest; -1 where there is no result for the whole way."""
        return int(np.argmax(self.load)) if np.isfinite(self.load).all() else -1


@dataclass(frozen=True, slots=True, eq=False)
class BallHistory:
    """What the first ball of a row meets in one revolution, put together from all balls.

    Attributes
    ----------
    row
        of balls, counted from 0
    azimuth
        (steps,), rising from 0 to below 2π (rad)
    inner, outer
        the contacts there
    """

    row: int
    azimuth: Floats
    inner: ContactHistory
    outer: ContactHistory


@dataclass(frozen=True, slots=True, eq=False)
class Variation:
    """How a quantity varies over a period; NaN if a point has no result.

    Attributes
    ----------
    mean
        over the period
    peak_to_peak
        greatest less least of the points, which may miss a sharp extreme between two of them
    harmonics
        (orders, …) complex: the quantity is mean + Σ Re[harmonics exp(i order ψ)], so that the
        absolute value is an amplitude; orders as in `CageTurn.orders`
    """

    mean: Floats
    peak_to_peak: Floats
    harmonics: NDArray[np.complex128]


@dataclass(frozen=True, slots=True, eq=False)
class CageTurn:
    """Equilibria over one period of the cage's turn, SI; NaN where a point has no result.

    Attributes
    ----------
    case
        that was turned
    angle
        (points,), azimuth of the first ball, from 0 to below `period` (rad)
    period
        after which the balls stand as before: one pitch 2π/Z; with rows of different ball counts,
        2π over their greatest common divisor (rad)
    status
        (points,), "converged" or why there is no result
    advice
        what a person can do about the first point without a result, or None
    residual
        the greatest of the converged points
    displacement, load
        (points, 5)
    stiffness
        (points, 5, 5)
    row
        (balls,), the row of each ball
    inner_load, outer_load
        (points, balls), of every ball's contacts (N)
    cage_speed
        mean and spread of the loaded balls' orbital speeds
    histories
        of one ball of each row over a revolution
    """

    case: Case
    angle: Floats
    period: float
    status: NDArray[np.str_]
    advice: str | None
    residual: float
    displacement: Floats
    load: Floats
    stiffness: Floats
    row: NDArray[np.int64]
    inner_load: Floats
    outer_load: Floats
    cage_speed: CageSpeed
    histories: tuple[BallHistory, ...]

    def __len__(self) -> int:
        """Count the points."""
        return len(self.angle)

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return bool(np.all(self.status == "converged"))

    @property
    def orders(self) -> NDArray[np.int64]:
        """Orders of the harmonics, per revolution of the cage: multiples of 2π over the period.

        For one row these are the multiples of its ball count, the ball-passage order.
        """
        return round(2.0 * pi / self.period) * np.arange(1, (len(self) + 1) // 2)

    @property
    def passage_frequency(self) -> float:
        """How often the balls stand as before, Z ω_m/2π for one row; Hz, NaN at standstill.

        Load and outer ring frame are fixed in space and the balls pass under the load, whichever
        ring turns.
        """
        return abs(self.cage_speed.mean) / self.period if self._turns else float("nan")

    @property
    def frequencies(self) -> Floats:
        """Frequencies of the harmonics; Hz, NaN at standstill."""
        step = self.passage_frequency * self.period / (2.0 * pi)
        return np.asarray(step * self.orders, dtype=np.float64)

    @property
    def time(self) -> Floats:
        """When the first ball stands at each angle, within one period from ψ = 0; s.

        Azimuths run from +z to +y, which is against a positive speed about +x: a cage with a
        positive speed meets the angles in falling order. NaN at standstill.
        """
        if not self._turns:
            return np.full(len(self), np.nan)
        forward = self.angle if self.cage_speed.mean < 0.0 else (-self.angle) % self.period
        # so small an angle below the period is the period itself
        forward = np.where(self.period - forward < 1e-12 * self.period, 0.0, forward)
        return np.asarray(forward / abs(self.cage_speed.mean), dtype=np.float64)

    @property
    def _turns(self) -> bool:
        duty = self.case.duty
        fastest = max(abs(duty.inner_speed), abs(duty.outer_speed))
        return abs(self.cage_speed.mean) > _STANDSTILL * fastest

    def variation(self, quantity: Quantity) -> Variation:
        """Return mean, peak to peak and harmonics of displacement, load or stiffness.

        What is below `ROUNDING`, or below ten times the solver's residual where that is more, of
        the greatest of its kind is zero; tilts are compared on the arm of half the pitch diameter.
        """
        values: Floats = getattr(self, quantity)
        arms = self._arms(quantity)
        scaled = values * arms
        scale = np.abs(scaled).max(initial=0.0) if self.converged else np.nan
        if quantity == "load":
            scale = max(scale, self.outer_load.max(initial=0.0))
        floor = max(ROUNDING, 10.0 * self.residual) * scale / arms
        mean, extent = values.mean(axis=0), np.ptp(values, axis=0)
        count = len(self.orders)
        harmonics = 2.0 * np.fft.rfft(values, axis=0)[1 : count + 1] / len(self)
        return Variation(
            mean=np.where(np.abs(mean) <= floor, 0.0, mean),
            peak_to_peak=np.where(extent <= floor, 0.0, extent),
            # nothing that stands still has harmonics
            harmonics=np.where((np.abs(harmonics) <= floor) | (extent <= floor), 0.0, harmonics),
        )

    def _arms(self, quantity: Quantity) -> Floats:
        """Factors that bring rotations and moments to the units of shifts and forces."""
        arm = 0.5 * self.case.bearing.pitch_diameter
        arms: Floats = np.array([1.0, 1.0, 1.0, arm, arm])
        if quantity == "displacement":
            return arms
        inverse = np.asarray(1.0 / arms, dtype=np.float64)
        return inverse if quantity == "load" else inverse[:, np.newaxis] * inverse


def cage_turn(case: Case, *, points: int = DEFAULT_POINTS, threads: int | None = None) -> CageTurn:
    """Solve a case for azimuths of the first ball evenly spread over one period.

    Parameters
    ----------
    case
        The case; its own first_ball_azimuth is not used.
    points
        In one period, 4 to 4096.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        If the number of points is out of range.

    A point without a result never raises: its status tells, its numbers are NaN, and with them
    whatever describes the whole turn.
    """
    if not LEAST_POINTS <= points <= MOST_POINTS:
        raise InputError(
            f"must be {LEAST_POINTS} to {MOST_POINTS}",
            field="points",
            value=points,
            example=f"points = {DEFAULT_POINTS}",
        )
    places = [place.bearing for place in case.bearing.places]
    counts = [place.ball_count for place in places]
    repeats = reduce(gcd, counts)
    period = 2.0 * pi / repeats
    angle = period * np.arange(points) / points
    batch = solve_batch(case, first_ball_azimuth=angle, threads=threads)
    balls = batch.balls()
    row = np.repeat(np.arange(len(counts)), counts)
    return CageTurn(
        case=case,
        angle=angle,
        period=period,
        status=batch.status,
        advice=_advice(case, batch, angle),
        residual=float(batch.residual[batch.converged].max(initial=0.0)),
        displacement=batch.displacement,
        load=batch.load,
        stiffness=batch.stiffness,
        row=row,
        inner_load=balls.inner.load,
        outer_load=balls.outer.load,
        cage_speed=_cage_speed(batch, balls),
        histories=tuple(
            _history(balls, place, index, np.flatnonzero(row == index)[:: count // repeats])
            for index, (place, count) in enumerate(zip(places, counts, strict=True))
        ),
    )


def _advice(case: Case, batch: BatchState, angle: Floats) -> str | None:
    """Ask the solver of one case what to do where a batch only says that there is no result."""
    if batch.converged.all():
        return None
    first = float(angle[np.argmin(batch.converged)])
    return solve(case.replace(duty=case.duty.replace(first_ball_azimuth=first))).status.advice


def _cage_speed(batch: BatchState, balls: BallTable) -> CageSpeed:
    """Mean and extremes of the loaded balls' orbital speeds; NaN if a point has no result."""
    load, orbit = balls.inner.load, np.asarray(balls.motion.orbital_speed)
    loaded = load > _LOADED * load.max(axis=1, keepdims=True)
    if not batch.converged.all() or not loaded.any():
        return CageSpeed(*[float("nan")] * 3)
    speeds = np.broadcast_to(orbit, load.shape)[loaded]
    return CageSpeed(float(speeds.mean()), float(speeds.min()), float(speeds.max()))


def _history(
    balls: BallTable, bearing: Bearing, row: int, chosen: NDArray[np.int64]
) -> BallHistory:
    """Line up the balls of a row, each over one period, to one ball's way round."""
    azimuth = _below_full_turn(balls.azimuth[:, chosen].ravel())
    order = np.argsort(azimuth)
    return BallHistory(
        row=row,
        azimuth=azimuth[order],
        inner=_contact_history(bearing, balls.inner, "inner", chosen, order),
        outer=_contact_history(bearing, balls.outer, "outer", chosen, order),
    )


def _below_full_turn(azimuth: Floats) -> Floats:
    """Reduce to 0 … 2π, where what is a rounding below 2π is 0."""
    reduced = np.mod(azimuth, 2.0 * pi)
    return np.asarray(np.where(2.0 * pi - reduced < 1e-12, 0.0, reduced), dtype=np.float64)


def _contact_history(
    bearing: Bearing,
    contacts: ContactTable,
    race: Race,
    chosen: NDArray[np.int64],
    order: NDArray[Any],
) -> ContactHistory:
    load = contacts.load[:, chosen].ravel()[order]
    angle = contacts.contact_angle[:, chosen].ravel()[order]
    conformity = bearing.inner_conformity if race == "inner" else bearing.outer_conformity
    curvature = race_curvature(
        bearing.ball_diameter, bearing.pitch_diameter, conformity, angle, race
    )
    modulus = effective_modulus(bearing.ring_material, bearing.ball_material)
    ellipse = elliptical_contact(load, curvature.rolling, curvature.across, modulus)
    return ContactHistory(load, angle, np.asarray(ellipse.max_pressure, dtype=np.float64))
