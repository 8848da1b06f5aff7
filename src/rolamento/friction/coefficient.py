"""Coefficient of friction of lubricated contacts by the regime of lubrication, where none is given.

    μ = φ_bl μ_bl + (1 - φ_bl) μ_EHL,    φ_bl = exp(-2.6e-8 (ν n)^1.4 d_m)

in mm²/s, r/min and mm: of the load, asperities carry the part φ_bl. In SKF's model the sliding part
of the torque takes this coefficient; here all that slides in the contacts does. It is a default for
want of a measured one, and comes with the range of the source's own values.

Source: SKF, Rolling bearings (catalogue 10000 EN, 2013), frictional moment: φ_bl, μ_EHL of ball
bearings by oil, and 0.15 for μ_bl; the later model has 0.12 for it when the bearing turns. Those of
roller bearings as in data/skf_friction.toml.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.case import lubricant_of
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.validate import within

SLIDING_FULL_FILM: Final[Mapping[str, float]] = {
    "mineral": 0.05,
    "synthetic": 0.04,
    "transmission_fluid": 0.1,
}
"""μ_EHL of ball bearings by oil."""


def full_film_of(kind: str) -> float | None:
    """Return μ_EHL of a type of roller bearing, whatever the oil; None of ball bearings."""
    found = toml_of("skf_friction")["full_film"].get(kind)
    return None if found is None else float(found)


SLIDING_BOUNDARY: Final = 0.12
"""μ_bl of a turning bearing in SKF's later model, which distinguishes it from starting; the
catalogue of 2013 gives one value of about 0.15 for both."""

SLIDING_AT_START: Final = 0.15
"""μ_bl of one that starts to turn."""

USUAL_OIL: Final = "mineral"
"""What an oil is taken for whose type is not given."""

_USUAL_OILS: Final = ("mineral", "synthetic")
_RPM: Final = 30.0 / np.pi


@frozen
class Coefficient:
    """Coefficients of friction of solved cases, and what the torque takes of them; (cases, 1) each.

    Attributes
    ----------
    balls
        between balls and races
    rollers
        between rollers and races, and at ribs whose film is not known; (cases, 1 or elements)
    boundary
        at ribs where asperities carry the load
    """

    balls: FloatArray
    rollers: FloatArray
    boundary: FloatArray

    @classmethod
    def given(cls, value: FloatArray) -> Coefficient:
        """One coefficient for all that slides, as of a measurement; (cases, 1)."""
        return cls(value, value, value)

    def __getitem__(self, some: slice) -> Coefficient:
        """Return that of some of the cases."""
        return Coefficient(self.balls[some], self.rollers[some], self.boundary[some])


def boundary_share(viscosity: ArrayLike, speed: ArrayLike, mean_diameter: ArrayLike) -> FloatArray:
    """Part φ_bl of the load that asperities carry.

    Parameters
    ----------
    viscosity : array, kinematic, of the oil or the grease's base oil in operation; m²/s.
    speed : array, of the rings against each other; rad/s.
    mean_diameter : array, d_m; m.

    Returns
    -------
    exp(-2.6e-8 (ν n)^1.4 d_m) in mm²/s, r/min and mm, of the broadcast shape; 1 at rest.

    SKF, Rolling bearings (10000 EN, 2013), frictional moment.
    """
    nu = 1e6 * within(viscosity, "viscosity", "m²/s", 0.0, 1e6)
    n = _RPM * within(speed, "speed", "rad/s", 0.0, 1e9)
    mean = 1e3 * within(mean_diameter, "mean_diameter", "m", 0.0, 1e3)
    return np.asarray(np.exp(-2.6e-8 * (n * nu) ** 1.4 * mean))


def blended(boundary_part: ArrayLike, boundary: ArrayLike, full_film: ArrayLike) -> FloatArray:
    """φ_bl μ_bl + (1 - φ_bl) μ_EHL; arrays that broadcast."""
    part = np.asarray(boundary_part, dtype=np.float64)
    return np.asarray(part * np.asarray(boundary) + (1.0 - part) * np.asarray(full_film))


def coefficient_by_regime(solved: Solved) -> tuple[Coefficient, Coefficient, Coefficient]:
    """The coefficient of solved cases by their regime, and its lower and upper limits.

    Parameters
    ----------
    solved
        With an oil or a grease at its temperature.

    Returns
    -------
    Three `Coefficient`: μ_bl = 0.12 with the μ_EHL of the oil's type, or of the kind of roller; the
    minimum of the source's values, and their maximum: 0.12 to 0.15, of balls in mineral and
    synthetic oils 0.04 to 0.05, of rollers 0.002 to 0.02.
    """
    rows, oil = solved.rows, solved.oil
    speed = solved.relative_speed
    part = boundary_share(
        oil.kinematic_viscosity[:, np.newaxis], speed[:, np.newaxis], rows.pitch_diameter
    )
    kind = lubricant_of(solved.case).oil.oil_type or USUAL_OIL
    film = SLIDING_FULL_FILM[kind]
    usual = [SLIDING_FULL_FILM[one] for one in _USUAL_OILS] if kind in _USUAL_OILS else [film]
    # a type that has none of its own has that of the oil, as balls have
    of_rows = [full_film_of(one) for one in rows.element]
    spread = toml_of("skf_friction")["full_film"].values()
    low, high = (
        np.array([end(usual) if one is None else end(spread) for one in of_rows])
        for end in (min, max)
    )
    lines = [film if one is None else one for one in of_rows]
    # of rows that differ, the ball models take the one with the thinnest film
    balls = part.max(axis=1, keepdims=True)

    def made(boundary: float, of_balls: float, of_rollers: ArrayLike) -> Coefficient:
        return Coefficient(
            blended(balls, boundary, of_balls),
            rows.per_element(blended(part, boundary, of_rollers)),
            np.full_like(balls, boundary),
        )

    return (
        made(SLIDING_BOUNDARY, film, np.array(lines)),
        made(SLIDING_BOUNDARY, min(usual), low),
        made(SLIDING_AT_START, max(usual), high),
    )
