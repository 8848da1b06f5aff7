"""From bearings and duties to the numbers that the kernels work on: a column a case."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case.bearing import Bearing
from rolamento.case.model import Model
from rolamento.contact.hertz import effective_modulus
from rolamento.contact.race import race_stiffness
from rolamento.geometry import edge_cosine, groove_places
from rolamento.kinematics import ball_mass, nominal_orbit
from rolamento.records import frozen
from rolamento.rows.ball import layout

Floats = NDArray[np.float64]

TERMS: Final = ((0.22, layout.COEFFICIENTS), (0.55, 12), (0.78, 20), (1.0, layout.MOST_TERMS))
"""Up to which D/d_m how many coefficients in cos α give K to 1e-10 of its value, 0 ≤ α ≤ 90°."""
HOLD_SHARE: Final = 0.8
"""Part of the centrifugal force in the nominal orbit by which the inner ring has to press on a ball
to hold it firmly. With less, balls that it hardly touches could have more than one place where the
outer ring turns: their F_c falls by up to 1.5 / HOLD_SHARE newtons for each
that the ring presses."""
CAGE_WEIGHT: Final = 1e-2
"""Fraction of a ball's centrifugal force: the load with which the nominal speed counts in the
cage's. Where balls are held, that changes it by some 1e-5; with much less, a breath on one drives
it."""


@frozen
class Columns:
    """Many cases of a row of balls: their duties, and the bearing, once if all have the same.

    duty (layout.DUTY, cases), bearing (layout.COLUMN - layout.DUTY or more, cases or 1): the rows
    of `layout` in two parts. An index is a row of it, whichever part has that.
    """

    duty: Floats
    bearing: Floats

    @property
    def cases(self) -> int:
        """Number of cases."""
        return int(self.duty.shape[1])

    def __getitem__(self, row: int | slice) -> Floats:
        """Rows of either part; (…, cases), of the bearing (…, cases or 1)."""
        first = row.start if isinstance(row, slice) else row
        part, before = (self.duty, 0) if first < layout.DUTY else (self.bearing, layout.DUTY)
        if isinstance(row, slice):
            return part[first - before : row.stop - before]
        return np.asarray(part[first - before])

    def __setitem__(self, row: int | slice, values: Any) -> None:
        """Fill in rows of either part."""
        self[row][...] = values

    def of(self, which: Any) -> Columns:
        """Some of the cases; the duties of numbered ones are a copy."""
        alike = self.bearing.shape[1] == 1
        return Columns(self.duty[:, which], self.bearing if alike else self.bearing[:, which])

    def over_balls(self) -> Columns:
        """The same with an axis for the balls: rows (cases or 1, 1)."""
        return Columns(self.duty[..., np.newaxis], self.bearing[..., np.newaxis])

    def whole(self) -> Floats:
        """Whole columns, a copy; (length, cases)."""
        shape = (len(self.bearing), self.cases)
        return np.concatenate([self.duty, np.broadcast_to(self.bearing, shape)])


def ring_arms(p: Columns | Floats) -> Floats:
    """The lengths (1, 1, 1, R_i, R_i) that turn tilts into shifts and moments into forces."""
    arms = np.ones((layout.DEGREES_OF_FREEDOM, *np.shape(p[layout.ARM])))
    arms[3:] = p[layout.ARM]
    return arms


def apply_model(p: Columns | Floats, model: Model) -> None:
    """Put into columns that know their speeds what the model says of inertia and of the cage."""
    inner, outer, gamma = p[layout.INNER_SPEED], p[layout.OUTER_SPEED], p[layout.GAMMA]
    cosine = np.minimum(
        p[layout.RADIAL_OFFSET] / (p[layout.OUTER_LENGTH] + p[layout.INNER_LENGTH]), 1.0
    )
    p[layout.NOMINAL_ORBIT] = nominal_orbit(cosine * gamma, inner, outer)
    # rings that turn against each other may leave the cage nearly standing still
    speed = np.maximum(np.abs(p[layout.NOMINAL_ORBIT]), 0.25 * (np.abs(inner) + np.abs(outer)))
    force = p[layout.CENTRIFUGAL] * speed**2
    p[layout.CAGE_WEIGHT] = CAGE_WEIGHT * force
    p[layout.HOLD_OFFSET] = model.cage == "none"
    if model.cage != "none":
        with np.errstate(divide="ignore"):
            p[layout.HOLD_RATE] = np.where(force > 0.0, 1.0 / (HOLD_SHARE * force), 0.0)
    p[layout.OWN_ORBIT] = model.cage != "rigid"
    p[layout.CENTRIFUGAL] *= model.centrifugal_force
    p[layout.GYROSCOPIC] *= model.gyroscopic_moment
    inertia = p[layout.CENTRIFUGAL] * p[layout.NOMINAL_ORBIT] ** 2
    p[layout.INERTIA_APPROACH] = np.cbrt(inertia / p[layout.SERIES_STIFFNESS]) ** 2
    p[layout.LAMBDA_INNER] = 1.0 if model.raceway_control == "none" else 0.0


@lru_cache(maxsize=64)
def directions(balls: int) -> tuple[Floats, Floats]:
    """Cosine and sine of 2π j/Z for every ball j, symmetrical to the last bit; (balls,) each.

    Not to be written to. Balls that mirror each other then have the same place to the last bit
    too, and a ball at 90° is under no part of a load along z.
    """
    part = np.arange(balls)
    quarter, rest = np.divmod(4 * part, balls)
    late, middle = 2 * rest > balls, 2 * rest == balls
    angle = 0.5 * np.pi * np.where(late, balls - rest, rest) / balls
    c = np.cos(angle)
    s = np.where(middle, c, np.sin(angle))
    c, s = np.where(late, s, c), np.where(late, c, s)
    cosines = np.choose(quarter, [c, -s, -c, s])
    sines = np.choose(quarter, [s, c, -s, -c])
    return cosines + 0.0, sines + 0.0


@lru_cache(maxsize=256)
def bearing_column(bearing: Bearing) -> Floats:
    """What does not depend on the duty, of a bearing of one row; not to be written to."""
    own = bearing_columns(bearing, 1)
    own.flags.writeable = False
    return own


def bearing_columns(bearing: Any, count: int) -> Floats:
    """What does not depend on the duty; (layout.COLUMN - layout.DUTY or more, count).

    bearing: a `Bearing`, or an object with its attributes as arrays, (count,).
    """
    diameter, pitch = bearing.ball_diameter, bearing.pitch_diameter
    places = groove_places(
        diameter,
        pitch,
        bearing.inner_conformity,
        bearing.outer_conformity,
        contact_angle=bearing.contact_angle,
        diametral_clearance=bearing.diametral_clearance,
    )
    mass = ball_mass(diameter, bearing.ball_material.density)
    terms = _terms(diameter / pitch)
    long = np.max(terms) > layout.COEFFICIENTS
    p = Columns(
        np.zeros((layout.DUTY, 0)),
        np.zeros((layout.COLUMN - layout.DUTY + 3 * layout.MOST_TERMS * long, count)),
    )
    p[layout.OUTER_LENGTH] = places.outer_length
    p[layout.INNER_LENGTH] = places.inner_length
    p[layout.AXIAL_OFFSET] = places.axial_offset
    p[layout.RADIAL_OFFSET] = places.radial_offset
    p[layout.GAMMA] = diameter / pitch
    p[layout.CENTRIFUGAL] = 0.5 * mass * pitch
    p[layout.GYROSCOPIC] = 0.1 * mass * pitch
    p[layout.ARM] = places.inner_groove_radius
    p[layout.FRICTION_ARM] = bearing.inner_conformity * diameter / places.inner_groove_radius
    p[layout.ONE_SIDED] = bearing.contact_angle is not None and np.greater(
        bearing.contact_angle, 0.0
    )
    p[layout.BALL_DIAMETER] = diameter
    p[layout.MODULUS] = effective_modulus(bearing.ring_material, bearing.ball_material)
    p[layout.INNER_EDGE] = edge_cosine(bearing, "inner")
    p[layout.OUTER_EDGE] = edge_cosine(bearing, "outer")
    p[layout.TERMS] = terms
    _put_polynomials(p, bearing, layout.COEFFICIENTS)
    for count in {*terms[terms > layout.COEFFICIENTS].tolist()}:
        _put_polynomials(p, bearing, int(count), where=p[layout.TERMS] == count)
    p[layout.OUTER_SHARE] = np.cbrt(p[layout.SERIES_STIFFNESS] / p[layout.OUTER_STIFFNESS]) ** 2
    return p.bearing


def _terms(ratio: Any) -> Floats:
    """Number of coefficients of K at a D/d_m; NaN counts as the smallest."""
    limits, counts = zip(*TERMS, strict=True)
    place = np.searchsorted(limits, np.nan_to_num(np.asarray(ratio, dtype=np.float64), posinf=0.0))
    return np.asarray(counts, dtype=np.float64)[np.minimum(place, len(counts) - 1)]


def _put_polynomials(p: Columns, bearing: Any, count: int, where: Any = True) -> None:
    """Put in K_i, K_o and both in series as polynomials of so many coefficients in cos α.

    The exact stiffness depends on the loaded angle through the curvatures, weakly: a polynomial
    through Chebyshev points of 0 ≤ cos α ≤ 1 follows it (see `TERMS`).
    """
    chebyshev = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    cosines = 0.5 * (1.0 + chebyshev)
    exact = race_stiffness(bearing, np.arccos(cosines)[:, np.newaxis])
    powers = np.vander(cosines, count, increasing=True)
    for first, values in (
        (layout.INNER_STIFFNESS, exact.inner),
        (layout.OUTER_STIFFNESS, exact.outer),
        (layout.SERIES_STIFFNESS, exact.combined),
    ):
        start = first if count == layout.COEFFICIENTS else layout.long_polynomial(first)
        np.copyto(p[start : start + count], np.linalg.solve(powers, values), where=where)
