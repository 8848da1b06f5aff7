"""A turn of the cage: a new equilibrium for each instant, until the next ball stands in place.

Quasi-static: at every azimuth of the first ball the bearing is in balance, and what changes from
one instant to the next is only where the balls stand. Displacement and stiffness then repeat with
every ball that passes under the load: the variable compliance of a rolling bearing.

Sources: Sunnersjö, Journal of Sound and Vibration 58 (1978) 363; Radaelli (2013), chapter 6.
"""

from __future__ import annotations

import os
from functools import reduce
from math import gcd, pi
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case, load_case
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Contacts, Solved
from rolamento.validate import whole_number
from rolamento.words import Note

Floats = NDArray[np.float64]
Compared = Literal["displacement", "load", "stiffness"]

SCHEMA: Final = 2
FEWEST_POINTS: Final = 4
MOST_POINTS: Final = 4096
DEFAULT_POINTS: Final = 256
"""Keeps the first harmonics to 1e-6 and the extremes of the stiffness to 2 % where balls leave the
load zone, and everything to rounding where all stay loaded: see
docs/theory/variable-compliance.md."""

ROUNDING: Final = 1e-9
"""Fraction of the maximum of its kind: a variation below is rounding of the solver, and given as
zero."""

_LOADED: Final = 0.01  # of the heaviest ball: one that carries less follows the cage
_STANDSTILL: Final = 1e-9  # of the rings' speeds: below, the cage stands still


@frozen
class CageSpeed:
    """Orbital speed of the loaded balls about the shaft axis, over balls and instants; rad/s.

    Raceway control gives every ball an orbital speed of its own; a cage has one. Its speed is
    taken to be the plain mean over the balls that carry at least a hundredth of the heaviest
    ball's inner load. Positive about +x, like the rings' speeds.
    """

    mean: float
    minimum: float
    maximum: float

    @property
    def spread(self) -> float:
        """Maximum less minimum, over the mean; NaN where the cage stands still."""
        return (self.maximum - self.minimum) / abs(self.mean) if self.mean else float("nan")


@frozen(eq=False)
class ContactHistory:
    """One race's contact of a ball on its way round: arrays over the azimuths of `BallHistory`.

    load (N), contact_angle (rad), max_pressure (Pa).
    """

    load: Floats
    contact_angle: Floats
    max_pressure: Floats

    @property
    def heaviest(self) -> int:
        """Where the load is at its maximum; -1 where there is no result for the whole way."""
        return int(np.argmax(self.load)) if np.isfinite(self.load).all() else -1

    def to_mapping(self) -> dict[str, Floats]:
        """Give the arrays by name."""
        return {name: getattr(self, name) for name in ("load", "contact_angle", "max_pressure")}


@frozen(eq=False)
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


@frozen(eq=False)
class Variation:
    """How a quantity varies over a period; NaN if a point has no result.

    Attributes
    ----------
    mean
        over the period
    peak_to_peak
        maximum less minimum of the points, which may miss a sharp extreme between two of them
    harmonics
        (orders, …) complex: the quantity is mean + Σ Re[harmonics exp(i order ψ)], so that the
        absolute value is an amplitude; orders as in `CageTurn.orders`
    """

    mean: Floats
    peak_to_peak: Floats
    harmonics: NDArray[np.complex128]


@frozen(eq=False)
class CageTurn:
    """Equilibria over one period of the cage's turn, SI; NaN where a point has no result.

    Attributes
    ----------
    solved
        a case for each point
    angle
        (points,), azimuth of the first ball, from 0 to below `period` (rad)
    period
        after which the balls stand as before: one pitch 2π/Z; with rows of different ball counts,
        2π over their greatest common divisor (rad)
    advice
        what a person can do about the first point without a result, or None
    cage_speed
        mean and spread of the loaded balls' orbital speeds
    histories
        of one ball of each row over a revolution
    """

    solved: Solved
    angle: Floats
    period: float
    advice: Note | None
    cage_speed: CageSpeed
    histories: tuple[BallHistory, ...]

    def __len__(self) -> int:
        """Count the points."""
        return len(self.angle)

    @property
    def case(self) -> Case:
        """What was turned."""
        return self.solved.case

    @property
    def elements(self) -> tuple[str, ...]:
        """What rolls in each row, as a case file has it."""
        return tuple(place.bearing.element for place in self.case.bearing.places)

    @property
    def status(self) -> NDArray[np.str_]:
        """(points,), "converged" or why there is no result."""
        return self.solved.status.code

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return bool(self.solved.converged.all())

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

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and arrays in SI units."""
        speed = self.cage_speed
        return {
            "schema": SCHEMA,
            "kind": "cage_turn",
            "title": self.case.title,
            "status": {"converged": self.converged, "codes": self.status.tolist()},
            "period": self.period,
            "angle": self.angle,
            "time": self.time,
            "cage_speed": {"mean": speed.mean, "minimum": speed.minimum, "maximum": speed.maximum},
            "passage_frequency": self.passage_frequency,
            "orders": self.orders.tolist(),
            "frequencies": self.frequencies,
            "displacement": self._variation_mapping("displacement"),
            "load": self._variation_mapping("load"),
            "stiffness": self._variation_mapping("stiffness"),
            "balls": [
                {
                    "row": history.row,
                    "azimuth": history.azimuth,
                    "inner": history.inner.to_mapping(),
                    "outer": history.outer.to_mapping(),
                }
                for history in self.histories
            ],
        }

    def _variation_mapping(self, quantity: Compared) -> dict[str, Any]:
        variation = self.variation(quantity)
        return {
            "values": getattr(self.solved, quantity).array,
            "mean": variation.mean,
            "peak_to_peak": variation.peak_to_peak,
            "amplitude": np.abs(variation.harmonics),
            "phase": np.angle(variation.harmonics),
        }

    def variation(self, quantity: Compared) -> Variation:
        """Return mean, peak to peak and harmonics of displacement, load or stiffness.

        What is below `ROUNDING`, or below ten times the solver's residual where that is more, of
        the maximum of its kind is zero; tilts are compared on the arm of half the pitch diameter.
        """
        values: Floats = getattr(self.solved, quantity).array
        residual = self.solved.status.residual[self.solved.converged].max(initial=0.0)
        arms = self._arms(quantity)
        scaled = values * arms
        scale = np.abs(scaled).max(initial=0.0) if self.converged else np.nan
        if quantity == "load":
            scale = max(scale, self.solved.outer.load.max(initial=0.0))
        floor = max(ROUNDING, 10.0 * residual) * scale / arms
        mean, extent = values.mean(axis=0), np.ptp(values, axis=0)
        count = len(self.orders)
        harmonics = 2.0 * np.fft.rfft(values, axis=0)[1 : count + 1] / len(self)
        return Variation(
            mean=np.where(np.abs(mean) <= floor, 0.0, mean),
            peak_to_peak=np.where(extent <= floor, 0.0, extent),
            # nothing that stands still has harmonics
            harmonics=np.where((np.abs(harmonics) <= floor) | (extent <= floor), 0.0, harmonics),
        )

    def _arms(self, quantity: Compared) -> Floats:
        """Factors that bring rotations and moments to the units of shifts and forces."""
        arm = 0.5 * self.case.bearing.pitch_diameter
        arms: Floats = np.array([1.0, 1.0, 1.0, arm, arm])
        if quantity == "displacement":
            return arms
        inverse = np.asarray(1.0 / arms, dtype=np.float64)
        return inverse if quantity == "load" else inverse[:, np.newaxis] * inverse


def cage_turn(
    case: Case | str | os.PathLike[str],
    *,
    points: int = DEFAULT_POINTS,
    threads: int | None = None,
) -> CageTurn:
    """Solve a case for azimuths of the first ball evenly spread over one period.

    Parameters
    ----------
    case
        Or the file of one; its own first_ball_azimuth is not used.
    points
        In one period, 4 to 4096.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        If the number of points is out of range.

    A point without a result never raises: its status says why, its numbers are NaN, and with them
    whatever describes the whole turn.
    """
    whole_number(points, "points", FEWEST_POINTS, MOST_POINTS, f"points = {DEFAULT_POINTS}")
    case = case if isinstance(case, Case) else load_case(case)
    counts = [place.bearing.element_count for place in case.bearing.places]
    repeats = reduce(gcd, counts)
    period = 2.0 * pi / repeats
    angle = period * np.arange(points) / points
    solved = solve(case, {"duty.first_ball_azimuth": angle}, threads=threads)
    failed = np.flatnonzero(~solved.converged)
    return CageTurn(
        solved=solved,
        angle=angle,
        period=period,
        advice=solved[int(failed[0])].advice[0] if len(failed) else None,
        cage_speed=_cage_speed(solved),
        histories=tuple(
            _history(solved, row, count // repeats) for row, count in enumerate(counts)
        ),
    )


def _cage_speed(solved: Solved) -> CageSpeed:
    """Mean and extremes of the loaded balls' orbital speeds; NaN if a point has no result."""
    load = solved.inner.load
    loaded = load > _LOADED * load.max(axis=1, keepdims=True)
    if not solved.converged.all() or not loaded.any():
        return CageSpeed(*[float("nan")] * 3)
    speeds = solved.elements.orbital_speed[loaded]
    return CageSpeed(float(speeds.mean()), float(speeds.min()), float(speeds.max()))


def _history(solved: Solved, row: int, pitches: int) -> BallHistory:
    """Line up the balls of a row that stand so many pitches apart to one ball's way round."""
    balls = np.flatnonzero(solved.elements.row == row)[::pitches]
    azimuth = _below_full_turn(solved.elements.azimuth[:, balls].ravel())
    order = np.argsort(azimuth)

    def met(contacts: Contacts) -> ContactHistory:
        columns = (contacts.load, contacts.contact_angle, contacts.max_pressure)
        return ContactHistory(*(column[:, balls].ravel()[order] for column in columns))

    return BallHistory(row, azimuth[order], met(solved.inner), met(solved.outer))


def _below_full_turn(azimuth: Floats) -> Floats:
    """Reduce to 0 … 2π, where what is a rounding below 2π is 0."""
    reduced = np.mod(azimuth, 2.0 * pi)
    return np.asarray(np.where(2.0 * pi - reduced < 1e-12, 0.0, reduced), dtype=np.float64)
