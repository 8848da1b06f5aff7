"""Basic reference rating life from the loads of the single balls.

Each race of each row has a rating, the load at which it lives a million revolutions:

    Q_ci = C/(0.407 Z cos α i^0.7) (1 + T^(10/3))^(3/10)
    Q_ce = C/(0.389 Z cos α i^0.7) (1 + T^(-10/3))^(3/10)
    T = 1.044 ((1-γ)/(1+γ))^1.72 [r_i/r_e (2 r_e - D)/(2 r_i - D)]^0.41,   γ = D cos α/d_m.

Every point of a race that turns against the load passes all balls: its loads count by their cubic
mean. On one that stands, the points under the heavy balls are the ones that fail: Q^(10/3) is
averaged. The parts of a bearing live together by the product of their reliabilities, with
Weibull's slope 10/9:

    L_10r = [Σ (Q_c/Q_e)^(-10/3)]^(-9/10)   over races and rows.

Roller rows are in `lamina`, slice by slice; both share one reference life, each with its slope.

The loads may come from anywhere: any load, tilt, clearance, set or speed. The standard takes
static loads, equal at both races; here each race has its own, with the centrifugal force.

The cosine: some transcriptions of the edition of 2008 have (cos α)^0.7 below Q_c. By Lundberg and
Palmgren C goes with Q_c Z cos α, and Q_c with (cos α)^-0.3: the power 0.7 is what then stands in C.
Only with cos α the reference life at a load zone of one half is (C/P)³ at every contact angle; with
the power 0.7 it would be 21 % less at 40°. ISO 16281:2025 has cos α, as transcribed in public
source code.

Sources: ISO/TS 16281:2008 and ISO 16281:2025; Lundberg and Palmgren (1947).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.life.theory import OF_BEARING, OF_LOAD, Theory
from rolamento.numerics import FloatArray
from rolamento.ratings import RatedType, rated_as
from rolamento.records import frozen
from rolamento.validate import numbers, positive
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life

SLOPE: Final = 10.0 / 9.0
"""Weibull's slope e of point contact."""
ROLLER_SLOPE: Final = 9.0 / 8.0
"""Weibull slope of line contact."""
EXPONENT: Final = 3.0
_RISK: Final = EXPONENT * SLOPE
"""Exponent of the load, in the risk of failure."""


@frozen
class RaceRatings:
    """Q_ci and Q_ce: ball loads for a life of a million revolutions; arrays of one shape, N."""

    inner: FloatArray
    outer: FloatArray


@frozen
class ReferenceLife:
    """The reference life and what it is made of.

    Attributes
    ----------
    life
        L_10r, (cases,), millions of revolutions; infinite without load, NaN without a result
    inner, outer
        of each race alone, (cases, rows), millions of revolutions
    inner_load, outer_load
        equivalent loads Q_e of an element on the races, (cases, rows), N
    slope
        Weibull's e of the rows, (rows,): 10/9 of balls, 9/8 of rollers
    """

    life: FloatArray
    inner: FloatArray
    outer: FloatArray
    inner_load: FloatArray
    outer_load: FloatArray
    slope: FloatArray

    @property
    def row(self) -> FloatArray:
        """Life of each row, (cases, rows), millions of revolutions."""
        rows = zip(self.inner.T, self.outer.T, self.slope.tolist(), strict=True)
        return np.stack(
            [system_life(np.stack([i, o]), axis=0, slope=slope) for i, o, slope in rows], axis=1
        )

    @property
    def race_slopes(self) -> FloatArray:
        """Slopes of the inner races, then of the outer ones; (2·rows,)."""
        return np.concatenate([self.slope, self.slope])

    @classmethod
    def of_races(
        cls,
        inner: FloatArray,
        outer: FloatArray,
        inner_load: FloatArray,
        outer_load: FloatArray,
        slope: FloatArray,
    ) -> ReferenceLife:
        """Put the lives of the races together; arrays (cases, rows), slope (rows,)."""
        races = np.concatenate([inner, outer], axis=1)
        life = system_life(races, slope=np.concatenate([slope, slope]))
        return cls(life, inner, outer, inner_load, outer_load, slope)


def race_ratings(
    dynamic_rating: ArrayLike,
    ball_count: ArrayLike,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    inner_conformity: ArrayLike,
    outer_conformity: ArrayLike,
    contact_angle: ArrayLike,
    kind: RatedType = "radial",
) -> RaceRatings:
    """Rolling-element load ratings of the races of a row.

    Parameters
    ----------
    dynamic_rating : array, C_r of one row (that of i rows is i^0.7 as much), or C_a; N.
    ball_count : array, Z.
    ball_diameter, pitch_diameter : arrays; m.
    inner_conformity, outer_conformity : arrays, r/D.
    contact_angle : array, nominal α; rad.
        All broadcast against each other.
    kind : what the bearing is rated as.

    ISO/TS 16281:2008, 4.3: thrust bearings have C_a/(Z sin α), and no 1.044 in T.
    """
    rating = positive(dynamic_rating, "dynamic_rating")
    angle = numbers(contact_angle, "contact_angle")
    cosine = np.where(angle >= np.pi / 2, 0.0, np.cos(angle))
    gamma = (
        numbers(ball_diameter, "ball_diameter") * cosine / numbers(pitch_diameter, "pitch_diameter")
    )
    f_i, f_o = (
        numbers(inner_conformity, "inner_conformity"),
        numbers(outer_conformity, "outer_conformity"),
    )
    grooves = (f_i / f_o * (2.0 * f_o - 1.0) / (2.0 * f_i - 1.0)) ** 0.41
    ratio = ((1.0 - gamma) / (1.0 + gamma)) ** 1.72 * grooves
    if rated_as(kind)["axial"]:
        ball = rating / (numbers(ball_count, "ball_count") * np.sin(angle))
        return RaceRatings(
            np.asarray(ball * (1.0 + ratio**_RISK) ** (1.0 / _RISK)),
            np.asarray(ball * (1.0 + ratio**-_RISK) ** (1.0 / _RISK)),
        )
    ratio = 1.044 * ratio
    ball = rating / (numbers(ball_count, "ball_count") * cosine)
    return RaceRatings(
        np.asarray(ball / 0.407 * (1.0 + ratio**_RISK) ** (1.0 / _RISK)),
        np.asarray(ball / 0.389 * (1.0 + ratio**-_RISK) ** (1.0 / _RISK)),
    )


def equivalent_ball_load(load: ArrayLike, *, turning: ArrayLike) -> FloatArray:
    """Mean ball load Q_e of a race, by what it does to the life.

    Parameters
    ----------
    load : array (…, Z), of the balls, N; none is 0.
    turning : array that broadcasts with (…), whether the race turns against the load.

    Returns
    -------
    Array (…); N.

    ISO/TS 16281:2008, 4.4: cubic mean if turning, else the mean of power 10/3.

    >>> print(f"{equivalent_ball_load([1000.0, 1000.0], turning=True):.0f} N")
    1000 N
    """
    q = np.maximum(numbers(load, "load"), 0.0)
    scale = q.max(axis=-1, keepdims=True)
    part = q / np.where(scale > 0.0, scale, 1.0)
    cube = part * part * part
    turning_mean = np.cbrt(cube.mean(axis=-1))
    standing_mean = (cube * np.cbrt(part)).mean(axis=-1) ** (1.0 / _RISK)
    return np.asarray(scale[..., 0] * np.where(turning, turning_mean, standing_mean))


def race_life(rating: ArrayLike, equivalent: ArrayLike) -> FloatArray:
    """Life (Q_c/Q_e)³ of a race; arrays, N; millions of revolutions, infinite without load.

    >>> print(f"{race_life(10e3, 1e3):.0f} million revolutions")
    1000 million revolutions
    """
    with np.errstate(divide="ignore"):
        return np.asarray(
            (numbers(rating, "rating") / numbers(equivalent, "equivalent")) ** EXPONENT
        )


def system_life(lives: ArrayLike, *, axis: int = -1, slope: ArrayLike = SLOPE) -> FloatArray:
    """Life of parts that all have to survive: (Σ L^-e)^(-1/e), in the unit of the lives.

    Parameters
    ----------
    lives : array, for one and the same reliability; infinite where a part cannot fail.
    axis : along which the parts lie.
    slope : Weibull's e; 10/9 for ball bearings, 9/8 for roller bearings; one number, or one for
        each part. Where they differ the life t follows from Σ (t/L)^e = 1.

    Raises
    ------
    InputError
        If there are neither one nor as many slopes as parts.

    Lundberg and Palmgren (1947).

    >>> print(f"{system_life([1000.0, 1000.0]):.0f} million revolutions")
    536 million revolutions
    """
    life = numbers(lives, "lives")
    exponents = positive(slope, "slope")
    if exponents.ndim:
        if exponents.shape != life.shape[axis : axis + 1 or None]:
            raise InputError(said("must be one number, or one for each bearing"), field="slope")
        if np.any(exponents != exponents[0]):
            return _mixed_life(np.moveaxis(life, axis, -1), exponents)
        exponents = exponents[0]
    return _even_life(life, axis, float(exponents))


def _even_life(life: FloatArray, axis: int, slope: float) -> FloatArray:
    least = np.min(life, axis=axis, keepdims=True)
    finite = np.where(np.isfinite(least) & (least > 0.0), least, 1.0)
    with np.errstate(divide="ignore"):
        total = np.sum((life / finite) ** -slope, axis=axis) ** (-1.0 / slope)
    return np.asarray(np.squeeze(finite, axis=axis) * total)


def _mixed_life(life: FloatArray, slope: FloatArray) -> FloatArray:
    """Root t of Σ (t/L)^e = 1, by halving in ln t between the least life and what it allows."""
    least = life.min(axis=-1)
    usable = np.isfinite(least) & (least > 0.0)
    scaled = life / np.where(usable, least, 1.0)[..., np.newaxis]
    scaled = np.where(usable[..., np.newaxis], scaled, 1.0)
    low = np.full(least.shape, -np.log(life.shape[-1]) / slope.min())
    high = np.zeros(least.shape)
    for _ in range(60):
        middle = 0.5 * (low + high)
        risk = np.sum((np.exp(middle)[..., np.newaxis] / scaled) ** slope, axis=-1)
        low, high = np.where(risk < 1.0, middle, low), np.where(risk < 1.0, high, middle)
    return np.asarray(np.where(usable, least * np.exp(0.5 * (low + high)), least))


def reference_life(
    inner_load: ArrayLike,
    outer_load: ArrayLike,
    ratings: RaceRatings,
    row_starts: tuple[int, ...] = (0,),
    *,
    inner_turning: ArrayLike = True,
    outer_turning: ArrayLike = False,
) -> ReferenceLife:
    """Basic reference rating life of solved cases.

    Parameters
    ----------
    inner_load, outer_load : arrays (cases, balls), row after row; N.
    ratings : arrays (rows,) or (cases, rows); N.
    row_starts : index of each row's first ball.
    inner_turning, outer_turning : arrays (cases,) or single: whether the ring turns against the
        load.

    ISO/TS 16281:2008, 4.5.
    """
    parts = {}
    for name, load, turning in (
        ("inner", inner_load, inner_turning),
        ("outer", outer_load, outer_turning),
    ):
        rows = np.split(numbers(load, "load"), row_starts[1:], axis=1)
        parts[name] = np.stack([equivalent_ball_load(row, turning=turning) for row in rows], axis=1)
    inner = race_life(ratings.inner, parts["inner"])
    outer = race_life(ratings.outer, parts["outer"])
    slope = np.full(inner.shape[1], SLOPE)
    return ReferenceLife.of_races(inner, outer, parts["inner"], parts["outer"], slope)


def _evaluate(basis: Basis) -> Life:
    factors = {"a_1": basis.reliability_factor, "equivalent_load": basis.reference_load}
    return basis.record(THEORY.name, basis.reference.life, factors, basis.notes_on_reference_load())


THEORY: Final = Theory(
    name="iso16281",
    evaluate=_evaluate,
    validity=(*OF_BEARING, *OF_LOAD),
    rank=2,
    standard=True,
    by_race=True,
)
