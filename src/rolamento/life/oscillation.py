"""Life of a bearing whose ring swings to and fro: pitch and yaw bearings, robots, joints, linkages.

φ is the angle between the end points; an oscillation goes there and back, 2 φ. Each race has a
critical angle, at which the arcs that neighbouring elements roll over just meet,

    φ_c = 4π/(Z (1 ± γ)),   γ = D cos α/d_m,   + inner race, - outer race.

A race that lives L_rot revolutions lives so many oscillations:

    L = L_rot π/φ                              for φ ≥ φ_c: only the way that is rolled counts,
    L = L_rot (π/φ_c) (φ_c/φ)^(1/e)            below: less of the race is stressed, as often.

Both agree at φ_c; the second is what Lundberg and Palmgren's volume makes of shorter arcs, with
Weibull's e of 10/9 for points and 9/8 for lines.

The ring that moves against the load also loses its averaging. In rotation every point of it passes
the whole load distribution q(ψ), and q^p counts by its mean; in an oscillation a point stays within
±φ/2, and those that stay under the heaviest load fail first. The life of that race is divided by

    {mean_ψ [(mean_(ψ ± φ/2) q^p)^e]}^(1/e) / mean_ψ q^p,

which is 1 at 360°, or under an axial load, and tends to (J_2/J_1)^p as φ tends to 0. The races
live together by the product of their reliabilities. p is 3 for points, 4 for lines.

Beside it stand two simpler forms. Harris: L = (90°/θ) L_rot with θ = φ/2, of the whole bearing, at
any angle. Makers of robot gears (Harmonic Drive): the same of the catalogue's life,
(180°/φ) (C/P)^(3 or 10/3). Both leave out the lost averaging.

Below half the critical angle the elements roll within their own footprints' reach: the lubricant is
pushed out and nothing brings it back. Fretting and false brinelling end such a bearing, not
fatigue, and no life is given (Harris, Rumbarger and Butterfield, 2009).

Sources: Harris (1991), chapter 18; Houpert (1999); Harris, Rumbarger and Butterfield (2009, NREL
DG03); Menck and Stammler (2024); Lundberg and Palmgren (1947, 1952).
"""

from __future__ import annotations

from typing import Any, Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.life.basis import Basis
from rolamento.life.conditions import LifeConditions, conditions_of
from rolamento.life.iso16281 import EXPONENT, SLOPE, system_life
from rolamento.life.lamina import EXPONENT as LINE_EXPONENT
from rolamento.life.lamina import edge_factor
from rolamento.life.row_ratings import nominal_contact_angle
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen, span
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import DEGREES
from rolamento.validate import finite, numbers, positive
from rolamento.words import Note, said

__all__ = [
    "OscillationLife",
    "critical_angle",
    "lives_over_angles",
    "oscillation_life",
    "oscillations_per_revolution",
    "window_factor",
]

Race = Literal["inner", "outer"]

_POSITIONS: Final = 8
"""Places of the set of elements, within a pitch, at which the load distribution is taken."""
_MILLION: Final = 1e6
_HOUR: Final = 3600.0


def critical_angle(element_count: ArrayLike, ratio: ArrayLike, *, race: Race) -> FloatArray:
    """Angle of oscillation at which the arcs of neighbouring elements just meet.

    Parameters
    ----------
    element_count : array, Z of the row.
    ratio : array, γ = D cos α/d_m.
    race : "inner" or "outer".

    Returns
    -------
    φ_c = 4π/(Z (1 ± γ)) between the end points, + at the inner race; rad.

    Harris, Rumbarger and Butterfield (2009), whose θ_crit = 360°/(Z (1 ± γ)) is half of it.

    >>> print(f"{np.degrees(critical_angle(16, 0.13, race='outer')):.1f} deg")
    51.7 deg
    """
    sign = 1.0 if race == "inner" else -1.0
    gamma = numbers(ratio, "ratio")
    return np.asarray(
        4.0 * np.pi / (positive(element_count, "element_count") * (1.0 + sign * gamma))
    )


def oscillations_per_revolution(
    angle: ArrayLike, critical: ArrayLike, *, slope: ArrayLike = SLOPE
) -> FloatArray:
    """Oscillations that a race lives for each revolution of its life in rotation.

    Parameters
    ----------
    angle : array, φ between the end points; rad.
    critical : array, φ_c of the race; rad.
    slope : Weibull's e, 10/9 of points, 9/8 of lines.

    Returns
    -------
    π/φ from φ_c on, below it (π/φ_c)(φ_c/φ)^(1/e), and NaN below φ_c/2, where fatigue is not what
    ends it.

    Lundberg and Palmgren (1947) on the arcs that are rolled over.

    >>> print(f"{oscillations_per_revolution(np.pi / 3, 0.9):.0f} oscillations of 60 deg")
    3 oscillations of 60 deg
    """
    phi, own = positive(angle, "angle"), positive(critical, "critical")
    exponent = 1.0 / positive(slope, "slope")
    found = np.where(phi >= own, np.pi / phi, (np.pi / own) * (own / phi) ** exponent)
    return np.asarray(np.where(phi >= 0.5 * own, found, np.nan))


def window_factor(
    load: ArrayLike, angle: ArrayLike, *, exponent: float = EXPONENT, slope: float = SLOPE
) -> FloatArray:
    """By how much the moving ring's life falls since its points do not pass the whole load.

    Parameters
    ----------
    load : array (points,) or (points, slices): loads at azimuths that part a turn evenly, of
        contact points, or of the slices of lines of contact; N or N/m.
    angle : one number, φ between the end points; rad.
    exponent : p of the load, 3 of points, 4 of lines.
    slope : Weibull's e.

    Returns
    -------
    {mean[(mean over ±φ/2 of q^p)^e]}^(1/e)/mean q^p, 1 or more; slices add their risks. Between the
    points q^p is taken as straight. NaN without load.

    Houpert (1999); Menck and Stammler (2024).

    >>> print(f"{window_factor(np.maximum(np.cos(np.linspace(0.0, 6.2, 64)), 0.0), 6.28):.2f}")
    1.00
    """
    q = np.maximum(numbers(load, "load"), 0.0)
    q = q[:, np.newaxis] if q.ndim == 1 else q
    greatest = q.max()
    if not greatest > 0.0:
        return np.asarray(np.nan)
    part = (q / greatest) ** exponent
    weights = _window(len(part), float(positive(angle, "angle")))
    mean = np.fft.irfft(
        np.fft.rfft(part, axis=0) * np.fft.rfft(weights)[:, np.newaxis], n=len(part), axis=0
    )
    risk = (np.maximum(mean, 0.0) ** slope).mean(axis=0).sum()
    in_rotation = (part.mean(axis=0) ** slope).sum()
    return np.asarray((risk / in_rotation) ** (1.0 / slope))


def _window(points: int, angle: float) -> FloatArray:
    """Weights of the points around one, 0 first, in the mean over ±φ/2 of what lies between."""

    def below(x: FloatArray) -> FloatArray:
        """Integral of the triangle of half-width 1 about 0, up to x."""
        rising, falling = (
            0.5 * (1.0 + np.clip(x, -1.0, 0.0)) ** 2,
            0.5 * (1.0 - np.clip(x, 0.0, 1.0)) ** 2,
        )
        return np.asarray(np.where(x < 0.0, rising, 1.0 - falling))

    half = 0.5 * angle * points / (2.0 * np.pi)
    places = np.arange(-int(half) - 2, int(half) + 3)
    at = places.astype(np.float64)
    weights = (below(half - at) - below(-half - at)) / (2.0 * half)
    return np.asarray(
        np.bincount(places % points, weights=weights, minlength=points), dtype=np.float64
    )


@frozen(eq=False)
class OscillationLife:
    """Life of a bearing that oscillates; lives in millions of oscillations, NaN without one.

    Attributes
    ----------
    angle
        φ between the end points; rad
    frequency
        oscillations in a second, Hz; None where it is not known
    moving
        race that moves against the load: "inner", or "outer" under a rotating load
    critical_inner, critical_outer
        φ_c of the races, (rows,), rad
    window
        by which the life of the moving race falls, (rows,); 1 or more
    inner, outer
        lives of the races, (rows,)
    life
        of the bearing, for the reliability; NaN where fretting ends it
    hours
        the same in hours; NaN without a frequency
    harris
        by Harris's form, of the reference life; NaN below the critical angle
    makers
        by that of makers of robot gears, of the catalogue's life (C/P)^p
    rotation
        reference life of the same load in rotation, millions of revolutions
    reliability, reliability_factor
        S that life and hours are for, and its a_1
    fretting
        whether the angle is below half the critical one of a race
    slopes
        Weibull's e of the inner races, then of the outer ones, (2·rows,)
    distribution
        loads of the heaviest row over a turn, (points,), N; and
    azimuth
        where, (points,), rad
    notes
        what to know
    """

    angle: float
    frequency: float | None
    moving: Race
    critical_inner: FloatArray
    critical_outer: FloatArray
    window: FloatArray
    inner: FloatArray
    outer: FloatArray
    life: float
    hours: float
    harris: float
    makers: float
    rotation: float
    reliability: float
    reliability_factor: float
    fretting: bool
    slopes: FloatArray
    distribution: FloatArray
    azimuth: FloatArray
    notes: tuple[Note, ...] = ()

    def _shown(self) -> dict[str, str]:
        rate = "" if self.frequency is None else f", {self.frequency:.4g} Hz"
        return {
            "": f"{self.angle * DEGREES:.4g} deg{rate}",
            "life": f"{self.life:.4g} million oscillations, {span([self.hours], 'h')}",
            "critical angle": f"{self.critical * DEGREES:.4g} deg",
            "by Harris": f"{self.harris:.4g} million oscillations",
            "fretting": str(self.fretting),
        }

    @property
    def critical(self) -> float:
        """The greatest critical angle of all races; rad."""
        return float(max(self.critical_inner.max(), self.critical_outer.max()))

    @property
    def races(self) -> FloatArray:
        """Lives of the inner races, then of the outer ones, (2·rows,), millions of oscillations."""
        return np.concatenate([self.inner, self.outer])

    @property
    def limiting(self) -> Race:
        """Race that lives shorter; of races without a life the moving one."""
        if np.isnan(self.races).any():
            return self.moving
        return "inner" if self.inner.min() <= self.outer.min() else "outer"

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values: rad, Hz, millions of oscillations, hours; NaN as None."""
        rows: dict[str, Any] = {
            name: [finite(value) for value in getattr(self, name)]
            for name in ("critical_inner", "critical_outer", "window", "inner", "outer")
        }
        numbers_: dict[str, Any] = {
            name: finite(getattr(self, name))
            for name in ("life", "hours", "harris", "makers", "rotation")
        }
        return {
            "angle": self.angle,
            "frequency": self.frequency,
            "moving": self.moving,
            "reliability": self.reliability,
            **rows,
            **numbers_,
            "unlimited": bool(np.isposinf(self.life)),
            "fretting": self.fretting,
            "notes": [note.to_mapping() for note in self.notes],
        }


def oscillation_life(
    solved: Solved,
    angle: float | None = None,
    frequency: float | None = None,
    conditions: LifeConditions | None = None,
) -> OscillationLife:
    """Life of one solved case whose ring oscillates.

    Parameters
    ----------
    solved
        Of `rolamento.solve`, a single case.
    angle, frequency
        φ between the end points (rad), and oscillations in a second (Hz); by default those of
        the case's duty.
    conditions
        As of `rolamento.life.life`: ratings and reliability. a_ISO is left out, for its κ is of a
        speed that an oscillation does not keep.

    Raises
    ------
    InputError
        If there is more than one case, none of them has a result, no angle is known, or no theory
        of life is for such a bearing.

    >>> from rolamento import solve
    >>> found = oscillation_life(solve("6310", fz=5e3), angle=2.5, frequency=2.0)
    >>> found.fretting, found.moving, round(found.life / found.harris, 2)
    (False, 'inner', 0.94)
    """
    if len(solved) != 1 or not solved.converged[0]:
        raise InputError(said("must be one case with a result"), field="solved", value=len(solved))
    own = solved.case.duty.oscillation
    phi = angle if angle is not None else None if own is None else own.angle
    rate = frequency if frequency is not None else None if own is None else own.frequency
    if phi is None:
        raise InputError(
            said("is missing: how far the ring swings"),
            field="duty.oscillation.angle",
            example="--angle 30deg",
        )
    phi = float(positive(phi, "angle"))
    rate = None if rate is None else float(positive(rate, "frequency"))
    return _of_basis(*_prepared(solved, conditions), phi, rate)


def lives_over_angles(
    solved: Solved, angles: ArrayLike, conditions: LifeConditions | None = None
) -> tuple[FloatArray, FloatArray]:
    """Life of one solved case at many angles of oscillation, and by Harris's form.

    Parameters
    ----------
    solved, conditions
        As of `oscillation_life`.
    angles
        (points,), φ between the end points, rad.

    Returns
    -------
    Millions of oscillations, (points,) both; NaN where `oscillation_life` has none.
    """
    ready = _prepared(solved, conditions)
    every = positive(angles, "angles").ravel().tolist()
    found = [_of_basis(*ready, angle, None) for angle in every]
    return np.array([one.life for one in found]), np.array([one.harris for one in found])


_Loads = tuple[list[FloatArray], bool]


def _prepared(solved: Solved, conditions: LifeConditions | None) -> tuple[Basis, _Loads]:
    basis = Basis.of(solved, conditions_of(solved) if conditions is None else conditions)
    return basis, _distributions(solved, _moving(basis), basis.ratings.rollers)


def _moving(basis: Basis) -> Race:
    return "inner" if bool(basis.turning[0][0]) else "outer"


def _of_basis(
    basis: Basis, distributions: _Loads, angle: float, frequency: float | None
) -> OscillationLife:
    solved, rows = basis.solved, basis.solved.rows
    cosine = np.cos(nominal_contact_angle(solved)[0])
    gamma = rows.ball_diameter[0] / rows.pitch_diameter[0] * np.abs(cosine)
    count = np.asarray(rows.element_count, dtype=np.float64)
    slope = basis.reference.slope
    critical = {race: critical_angle(count, gamma, race=race) for race in _RACES}
    moving = _moving(basis)
    loads, between = distributions
    window = np.array(
        [
            float(
                window_factor(
                    load,
                    angle,
                    exponent=LINE_EXPONENT if rolls else EXPONENT,
                    slope=float(slope[row]),
                )
            )
            for row, (load, rolls) in enumerate(zip(loads, basis.ratings.rollers, strict=True))
        ]
    )
    window = np.where(np.isnan(window), 1.0, window)
    lives = {}
    for race in _RACES:
        in_rotation = getattr(basis.reference, race)[0]
        own = in_rotation * oscillations_per_revolution(angle, critical[race], slope=slope)
        lives[race] = own / window if race == moving else own
    factor = float(basis.reliability_factor)
    idle = bool(basis.unloaded[0])
    races = np.concatenate([lives["inner"], lives["outer"]])
    fretting = angle < 0.5 * max(critical["inner"].max(), critical["outer"].max())
    known = not (idle or fretting or np.isnan(races).any())
    life = (
        factor * float(system_life(races, slope=basis.reference.race_slopes)) if known else np.nan
    )
    greatest = max(critical["inner"].max(), critical["outer"].max())
    rotation = float(basis.reference.life[0]) if not idle else np.nan
    turns = np.pi / angle
    heaviest = int(np.argmax([load.max() for load in loads]))
    shown = loads[heaviest]
    return OscillationLife(
        angle=angle,
        frequency=frequency,
        moving=moving,
        critical_inner=critical["inner"],
        critical_outer=critical["outer"],
        window=window,
        inner=lives["inner"],
        outer=lives["outer"],
        life=life,
        hours=np.nan if frequency is None else _MILLION * life / frequency / _HOUR,
        harris=factor * rotation * turns if angle >= greatest else np.nan,
        makers=factor * float(basis.basic_life[0]) * turns if not idle else np.nan,
        rotation=rotation,
        reliability=basis.given.reliability,
        reliability_factor=factor,
        fretting=bool(fretting),
        slopes=basis.reference.race_slopes,
        distribution=shown if shown.ndim == 1 else shown.sum(axis=1),
        azimuth=np.arange(len(shown)) * 2.0 * np.pi / len(shown),
        notes=_notes(basis, angle, greatest, frequency, fretting=bool(fretting), between=between),
    )


_RACES: Final[tuple[Race, Race]] = ("inner", "outer")


def _distributions(solved: Solved, race: Race, rollers: BoolArray) -> _Loads:
    """Loads of a race over a turn, row by row: (points,), or (points, slices) of lines.

    The elements are put at places between the given ones, and the case is solved at each; where
    one has no result, or rows have different numbers of elements, those of the case count alone,
    and the second value is false.
    """
    rows = solved.rows
    counts = np.asarray(rows.element_count)
    own = solved
    if np.all(counts == counts[0]):
        pitch = 2.0 * np.pi / float(counts[0])
        case = solved.case_at(0)  # what varied is not in the case itself
        places = case.duty.first_ball_azimuth + pitch * np.arange(_POSITIONS) / _POSITIONS
        found = solve(case, first_ball_azimuth=places, preload_loss=False)
        own = found if bool(found.converged.all()) else solved
    found_loads = []
    for row in range(len(rows)):
        mine = np.flatnonzero(rows.row_of_element == row)
        azimuth = np.mod(own.elements.azimuth[:, mine], 2.0 * np.pi)
        order = np.argsort(azimuth.ravel())
        if own.rollers is None or not rollers[row]:
            load = getattr(own, race).load[:, mine]
            found_loads.append(np.nan_to_num(load.ravel()[order]))
            continue
        line = getattr(own.rollers, race).load_per_length[:, mine]
        if solved.case.model.roller_contact != "coupled":
            line = line * edge_factor(line.shape[-1])
        found_loads.append(np.nan_to_num(line.reshape(-1, line.shape[-1])[order]))
    return found_loads, own is not solved


def _notes(
    basis: Basis,
    angle: float,
    critical: float,
    rate: float | None,
    *,
    fretting: bool,
    between: bool,
) -> tuple[Note, ...]:
    """What qualifies the life in oscillations, then what it leaves out."""
    values = {"angle": angle, "critical": critical}
    notes = []
    if fretting:
        notes.append(Note("oscillation_frets", values))
    elif angle < critical:
        notes.append(Note("oscillation_under_critical", values))
    if bool(basis.unloaded[0]):
        notes.append(Note("oscillation_unloaded"))
    for key in ("open_grooves", "ceramic_balls", "too_hot_for_steel"):
        if bool(np.any(basis.common_notes[key])):
            notes.append(Note(key, {"element": basis.element} if key == "ceramic_balls" else {}))
    notes.append(Note("oscillation_without_lubrication"))
    if not between:
        notes.append(Note("oscillation_as_own_loads"))
    if rate is None:
        notes.append(Note("oscillation_without_frequency"))
    return tuple(notes)
