"""What a bearing loses beside its contacts: friction of contact seals, drag of an oil bath.

By SKF, in N mm with lengths in mm, n in r/min and ν in mm²/s. Both seals of a bearing:

    M_seal = K_S1 d_s^β + K_S2.

Elements that wade through oil of the level H above the lowest contact at the outer raceway, in a
large reservoir on a horizontal shaft:

    M_drag = 0.4 V_M K_ball d_m⁵ n²     + 1.093e-7 n² d_m³ (n d_m² f_t/ν)^-1.379 R_s   (balls)
    M_drag = 4 V_M K_roll C_w B d_m⁴ n² + the same                                     (rollers)

    K_ball = i K_Z (d + D)/(D - d) 1e-12,   K_roll = K_L K_Z (d + D)/(D - d) 1e-12
    C_w = 2.789e-10 l_D³ - 2.786e-4 l_D² + 0.0195 l_D + 0.6439,   l_D = 5 K_L B/d_m
    t = 2 arccos((0.6 d_m - H)/(0.6 d_m)),   f_t = sin(t/2) up to t = π, then 1
    R_s = 0.36 d_m² (t - sin t) f_A,   f_A = 0.05 K_Z (D + d)/(D - d)

H counts up to 1.2 d_m. Valid up to ν = 500 mm²/s with H ≤ D/2, and 250 above. With an oil jet twice
the drag of a level of half an element's diameter.

Source: SKF, Rolling bearings (catalogue 10000 EN, 2013), frictional moment of seals and drag
losses; the constants, at second hand, and V_M, read off a diagram, in data/seals.toml.
"""

from __future__ import annotations

from math import inf, pi
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.losses import Losses
from rolamento.case.rolling_bearing import RollingBearing
from rolamento.errors import InputError
from rolamento.friction.machine import bearings_of
from rolamento.io.data import toml_of
from rolamento.lubrication.film_thickness import spreading_factor
from rolamento.lubrication.films import Film
from rolamento.numerics import FloatArray
from rolamento.records import frozen, span
from rolamento.solved import Solved
from rolamento.validate import numbers
from rolamento.words import Note, said

__all__ = [
    "FittedSeal",
    "SealsAndBath",
    "drag_moment",
    "fitted_seal",
    "seal_moment",
    "seals_and_bath",
]

_RPM: Final = 30.0 / pi
_HIGHEST: Final = 1.2
"""H/d_m from which on the bearing is full."""
_MOST_VISCOUS: Final = (500e-6, 250e-6)
"""m²/s, with a level up to half the outside diameter, and above."""


class FittedSeal(NamedTuple):
    """The seals of a bearing: SKF's kind, their number, and whether they are another maker's."""

    seal: str
    number: int
    alike: bool = False


def seal_moment(
    kind: str,
    seal: str,
    outside_diameter: float,
    counterface: float,
    count: int = 2,
) -> float:
    """Return the friction of the contact seals of a bearing; N·m, NaN where the table has none.

    Parameters
    ----------
    kind
        Of the bearing, such as ``"deep_groove"``.
    seal
        ``"rsl"``, ``"rsh"``, ``"rs1"``, ``"ls"`` or ``"cs"``; ``"none"`` has no friction.
    outside_diameter
        D, in m, which chooses the line of the table.
    counterface
        d_s, in m.
    count
        Seals, 1 or 2: one has half of two, but RSL above 25 mm.

    SKF, Rolling bearings (2013), frictional moment of seals.

    >>> f"{1e3 * seal_moment('deep_groove', 'rs1', 0.052, 0.03435):.0f} N mm"
    '68 N mm'
    """
    if seal == "none":
        return 0.0
    if count not in (1, 2):
        raise InputError(said("must be 1 or 2"), field="count", value=count, example="count = 2")
    for row in toml_of("seals")["seal"]:
        over, to = 1e-3 * row.get("over", 0.0), 1e-3 * row.get("to", inf)
        inside = over * (1.0 - 1e-9) < outside_diameter <= to * (1.0 + 1e-9)
        if (row["kind"], row["seal"]) == (kind, seal) and inside:
            both = row["K_S1"] * (1e3 * counterface) ** row["beta"] + row["K_S2"]
            one = count == 1 and not row.get("one_as_two", False)
            return float(1e-3 * both * (0.5 if one else 1.0))
    return float("nan")


def drag_moment(
    kind: str,
    *,
    speed: ArrayLike,
    bore_diameter: float,
    outside_diameter: float,
    kinematic_viscosity: ArrayLike,
    oil_level: float,
    width: float | None = None,
    rows: int = 1,
) -> FloatArray:
    """Return the drag of an oil bath; N·m.

    Parameters
    ----------
    kind
        Of the bearing, such as ``"deep_groove"``.
    speed
        Of the rings to each other, in rad/s.
    bore_diameter, outside_diameter
        d and D, in m.
    kinematic_viscosity
        Of the oil at its temperature, in m²/s.
    oil_level
        H above the lowest contact of an element with the outer raceway, in m.
    width
        B, in m, which roller bearings need.
    rows
        Of balls.

    Returns
    -------
    array
        0 at rest and without oil.

    Raises
    ------
    InputError
        If a roller bearing has no width.

    SKF, Rolling bearings (2013), drag losses.

    >>> moment = drag_moment("deep_groove", speed=314.0, bore_diameter=0.05,
    ...     outside_diameter=0.11, kinematic_viscosity=46e-6, oil_level=0.0095)
    >>> f"{1e3 * moment:.0f} N mm"
    '14 N mm'
    """
    data = toml_of("seals")["drag"]
    d, outside = 1e3 * bore_diameter, 1e3 * outside_diameter
    mean = 0.5 * (d + outside)
    n = _RPM * np.abs(numbers(speed, "speed"))
    nu = 1e6 * numbers(kinematic_viscosity, "kinematic_viscosity")
    level = min(1e3 * oil_level, _HIGHEST * mean)
    if level <= 0.0:
        return np.asarray(0.0 * n * nu)
    spread = spreading_factor(kind) * (d + outside) / (outside - d)
    long = data["K_L"].get(kind)
    volume = float(
        np.interp(level / mean, data["level"], data["ball" if long is None else "roller"])
    )
    if long is None:
        stirred = 0.4 * volume * rows * spread * 1e-12 * mean**5
    else:
        if width is None:
            raise InputError(said("is needed of a roller bearing"), field="width", example="0.02")
        b = 1e3 * width
        ratio = 5.0 * long * b / mean
        shape = 2.789e-10 * ratio**3 - 2.786e-4 * ratio**2 + 0.0195 * ratio + 0.6439
        stirred = 4.0 * volume * long * spread * 1e-12 * shape * b * mean**4
    angle = 2.0 * np.arccos(np.clip((0.6 * mean - level) / (0.6 * mean), -1.0, 1.0))
    turbulent = np.sin(0.5 * angle) if angle <= pi else 1.0
    wetted = 0.36 * mean**2 * (angle - np.sin(angle)) * 0.05 * spread
    turning = np.where(n > 0.0, n, 1.0)
    reynolds = turning * mean**2 * turbulent / nu
    whole = turning**2 * (stirred + 1.093e-7 * mean**3 * reynolds**-1.379 * wetted)
    return np.where(n > 0.0, 1e-3 * whole, 0.0)


def fitted_seal(bearing: RollingBearing, given: Losses) -> FittedSeal | None:
    """Return the seals of a bearing: those given, else those of its designation; None without.

    Parameters
    ----------
    bearing
        One bearing.
    given
        Of the case.
    """
    resolved = bearing.resolved
    letters = toml_of("seals")["letters"]
    own = None
    if resolved is not None:
        texts = [part.text for part in resolved.designation.letters.parts]
        own = next((letters[text] for text in texts if text in letters), None)
    if given.seal is not None:
        count = given.seal_count or (own or {}).get("count", 2)
        return FittedSeal(given.seal, count)
    if own is None:
        return None
    return FittedSeal(own["seal"], given.seal_count or own["count"], own.get("alike", False))


@frozen(eq=False)
class SealsAndBath:
    """Torque of the seals and of the oil bath of a bearing or a set; (cases,), N·m.

    Attributes
    ----------
    seal
        of all contact seals, at rest too
    drag
        of the oil bath
    speed
        of the rings against each other (rad/s)
    notes
        what was estimated, and what could not be counted
    """

    seal: FloatArray
    drag: FloatArray
    speed: FloatArray
    notes: tuple[Note, ...]

    def _shown(self) -> dict[str, str]:
        return {"seals": span(1e3 * self.seal, "N mm"), "oil bath": span(1e3 * self.drag, "N mm")}

    @property
    def torque(self) -> FloatArray:
        """Sum of both."""
        return np.asarray(self.seal + self.drag)

    @property
    def power(self) -> FloatArray:
        """Power of both, W."""
        return np.asarray(self.torque * self.speed)

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values in SI units."""
        from rolamento.io.json import plain

        found = {
            "seal": float(self.seal[case]),
            "drag": float(self.drag[case]),
            "torque": float(self.torque[case]),
            "power": float(self.power[case]),
        }
        return dict(plain(found))


def seals_and_bath(solved: Solved, film: Film | None = None) -> SealsAndBath | None:
    """Friction of seals and oil bath of solved cases; None where a case has neither.

    Parameters
    ----------
    solved
        Of `rolamento.solve`; the designation says which seals, ``[losses]`` what it does not.
    film
        Its film, for the viscosity of the bath.
    """
    given = solved.case.losses or Losses()
    bearings = bearings_of(solved.case.bearing)
    seals = [fitted_seal(one, given) for one in bearings]
    bathed = given.oil_level is not None
    if not (any(one is not None for one in seals) or bathed or given.seal_moment is not None):
        return None
    notes: list[Note] = []
    speed = solved.relative_speed
    shape = np.zeros(len(solved))
    if given.seal_moment is not None:
        moment = given.seal_moment
    else:
        pairs = [(one, seal) for one, seal in zip(bearings, seals, strict=True) if seal]
        moment = sum((_moment_of(one, seal, given, notes) for one, seal in pairs), 0.0)
    drag = shape
    if bathed:
        drag = _drag(solved, bearings, given, film, speed, notes)
    fine = np.where(solved.converged, 0.0, np.nan)
    return SealsAndBath(moment + fine, drag + fine, speed + shape, tuple(dict.fromkeys(notes)))


def _moment_of(
    bearing: RollingBearing, seal: FittedSeal, given: Losses, notes: list[Note]
) -> float:
    """Torque of the seals of one bearing; 0 with a note where the table has none."""
    if seal.seal == "none":
        return 0.0
    resolved = bearing.resolved
    place = bearing.places[0].bearing
    kind = place.listed_type.key if bearing.bearing_type.has_rollers else bearing.bearing_type.key
    if resolved is not None:
        kind = resolved.bearing.kind
    outside = None if resolved is None else resolved.bearing.outside_diameter
    counterface = given.seal_diameter or _counterface(kind, seal.seal, outside, place)
    if outside is None or counterface is None:
        notes.append(Note("seal_sizes_unknown"))
        return 0.0
    moment = seal_moment(kind, seal.seal, outside, counterface, seal.number)
    if np.isnan(moment):
        notes.append(Note("seal_not_in_table", {"seal": seal.seal.upper()}))
        return 0.0
    if given.seal_diameter is None and moment:
        notes.append(Note("seal_diameter_estimated", {"diameter": counterface}))
    if seal.alike:
        notes.append(Note("seal_taken_as", {"seal": seal.seal.upper()}))
    return moment


def _counterface(
    kind: str, seal: str, outside: float | None, bearing: RollingBearing
) -> float | None:
    """Return d_s by the elements; None where it cannot be estimated."""
    data = toml_of("seals")
    rows = [row for row in data["seal"] if (row["kind"], row["seal"]) == (kind, seal)]
    if outside is None or not rows:
        return outside
    name = rows[0]["counterface"]
    pitch, diameter = bearing.pitch_diameter, bearing.element_diameter
    if name == "E":
        return pitch + diameter
    if bearing.bearing_type.has_rollers:
        return None
    return float(pitch - data["counterface"][name] * diameter)


def _drag(
    solved: Solved,
    bearings: tuple[RollingBearing, ...],
    given: Losses,
    film: Film | None,
    speed: FloatArray,
    notes: list[Note],
) -> FloatArray:
    nothing = np.zeros(len(solved))
    level = given.oil_level
    assert level is not None
    if film is None:
        notes.append(Note("bath_without_oil"))
        return nothing
    total = nothing
    for bearing in bearings:
        resolved = bearing.resolved
        if resolved is None:
            notes.append(Note("bath_without_designation"))
            continue
        own = resolved.bearing
        kind = own.kind
        total = total + drag_moment(
            kind,
            speed=speed,
            bore_diameter=own.bore,
            outside_diameter=own.outside_diameter,
            kinematic_viscosity=film.kinematic_viscosity,
            oil_level=level,
            width=own.width,
            rows=bearing.rows_of_one_bearing,
        )
        limit = _MOST_VISCOUS[int(level > 0.5 * own.outside_diameter)]
        if np.any(film.kinematic_viscosity > limit):
            notes.append(Note("bath_too_viscous", {"limit": limit}))
        notes.append(Note("bath_by_diagram"))
    return total
