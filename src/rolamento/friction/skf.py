"""SKF's frictional moment of lubricated bearings: M = M_rr + M_sl, without seals and oil drag.

With d_m, d and D in mm, n in rpm, ν in mm²/s and loads in N, moments come in N·mm:

    M_rr = φ_ish φ_rs G_rr (ν n)^0.6
    M_sl = G_sl μ_sl
    φ_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 ν^0.64)                  inlet shear heating
    φ_rs  = exp(-K_rs ν n (d + D) √(K_z/(2 (D - d))))            replenishment, starvation
    μ_sl  = φ_bl μ_bl + (1 - φ_bl) μ_EHL,   φ_bl = exp(-2.6e-8 (ν n)^1.4 d_m)

Deep-groove ball bearings, with α_F = 24.6° (F_a/C_0)^0.24:

    G_rr = R1 d_m^1.96 (F_r + R2 F_a/sin α_F)^0.54
    G_sl = S1 d_m^-0.145 (F_r^5 + S2 d_m^1.5 F_a^4/sin α_F)^(1/3)
    without axial load  G_rr = R1 d_m^1.96 F_r^0.54,  G_sl = S1 d_m^-0.26 F_r^(5/3)

Angular-contact and four-point contact ball bearings, with F_g = R3 d_m⁴ n² and S3 d_m⁴ n² in the
two lines:

    G_rr = R1 d_m^1.97 (F_r + F_g + R2 F_a)^0.54
    G_sl = S1 d_m^0.26 ((F_r + F_g)^(4/3) + S2 F_a^(4/3))

Self-aligning ball bearings, with F_g = R3 d_m^3.5 n² and S3 d_m^3.5 n²:

    G_rr = R1 d_m² (F_r + F_g + R2 F_a)^0.54
    G_sl = S1 d_m^-0.12 ((F_r + F_g)^(4/3) + S2 F_a^(4/3))

Thrust ball bearings:

    G_rr = R1 d_m^1.83 F_a^0.54,  G_sl = S1 d_m^0.05 F_a^(4/3)

Cylindrical roller bearings, and tapered ones with their axial factor Y = 0.4 cot α:

    G_rr = R1 d_m^2.41 F_r^0.31                    G_sl = S1 d_m^0.9 F_a + S2 d_m F_r
    G_rr = R1 d_m^2.38 (F_r + R2 Y F_a)^0.31       G_sl = S1 d_m^0.82 (F_r + S2 Y F_a)

Spherical roller bearings, each the lesser of two, for point and for line contact:

    G_rr = R1 d_m^1.85 (F_r + R2 F_a)^0.54         G_sl = S1 d_m^0.25 (F_r^4 + S2 F_a^4)^(1/3)
    G_rr = R3 d_m^2.3 (F_r + R4 F_a)^0.31          G_sl = S3 d_m^0.94 (F_r^3 + S4 F_a^3)^(1/3)

Toroidal ones likewise, under a radial load:

    G_rr = R1 d_m^1.97 F_r^0.54                    G_sl = S1 d_m^-0.19 F_r^(5/3)
    G_rr = R2 d_m^2.37 F_r^0.31                    G_sl = S2 d_m^1.05 F_r

Cylindrical roller thrust bearings:

    G_rr = R1 d_m^2.38 F_a^0.31                    G_sl = S1 d_m^0.62 F_a

Source: SKF, Rolling bearings (catalogue 10000 EN, 2013), "The SKF model for calculating the
frictional moment", equations and table 2a; the constants of deep-groove series and of single-row,
double-row and four-point contact angular-contact bearings from table 2b, in data/skf_friction.toml,
which shows what of the other kinds was at hand.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from math import pi, radians
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.film_model import Supply
from rolamento.errors import InputError, guess
from rolamento.friction.coefficient import (
    SLIDING_AT_START,
    SLIDING_BOUNDARY,
    SLIDING_FULL_FILM,
    blended,
    boundary_share,
    full_film_of,
)
from rolamento.friction.model import (
    Setting,
    Torque,
    TorqueModel,
    added,
    bearing_load,
    limits_of_lubricated_bearings,
    torque_of_parts,
)
from rolamento.io.data import toml_of
from rolamento.lubrication.film_thickness import (
    REPLENISHMENT,
    replenishment,
    skf_inlet_heating,
    spreading_factor,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.types import TYPES
from rolamento.validate import numbers, one_of, positive
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.friction.machine import MachineBearing


@frozen
class SkfConstants:
    """Geometry constants of a bearing series, as SKF tabulates them.

    kind: type of bearing, which chooses the formulas. r3 and s3 are used by angular-contact and
    self-aligning bearings only, r2 by all but thrust and cylindrical roller bearings, s2 by all but
    thrust bearings. k_z: of the type, if not given. contact_angle: nominal, of the bearings that
    the constants are for (rad), if known.
    """

    kind: str
    r1: float
    r2: float
    s1: float
    s2: float
    r3: float = 0.0
    s3: float = 0.0
    r4: float = 0.0
    s4: float = 0.0
    k_z: float = 3.1
    contact_angle: float | None = None


@cache
def constants_by_series(kind: str) -> Mapping[str, SkfConstants]:
    """Return the constants of a type of bearing by series, such as "62" of 6205 or "2" of NU 206.

    Of types whose series are all alike by the empty text; none of a type that the table lacks.
    """
    return {
        series: _of_row(kind, row)
        for row in toml_of("skf_friction").get(kind, ())
        for series in row.get("series", ("",))
    }


def constants_of(kind: str, series: str = "") -> SkfConstants | None:
    """Return the constants of a bearing; None of a type or a series that is not on file."""
    known = constants_by_series(kind)
    return known.get("", known.get(series))


def series_constants(kind: str, series: str = "") -> SkfConstants:
    """Return the constants of a bearing that has to be on file.

    Parameters
    ----------
    kind
        Of the bearing, such as ``"deep_groove"``.
    series
        Such as ``"62"``; any of a type whose series are all alike.

    Raises
    ------
    InputError
        If the type or the series is not in the table.
    """
    found = constants_of(kind, series)
    if found is not None:
        return found
    formulas = toml_of("skf_friction")["formulas"]
    one_of(kind, "kind", formulas)
    raise InputError(
        said(
            "is not a series of such bearings in SKF's table; {guess}",
            guess=guess(series, constants_by_series(kind)),
        ),
        field="series",
        value=series,
        example='"62"',
    )


def _of_row(kind: str, row: Mapping[str, Any]) -> SkfConstants:
    angle = row.get("contact_angle_deg")
    return SkfConstants(
        kind,
        row["R1"],
        row.get("R2", 0.0),
        row["S1"],
        row.get("S2", 0.0),
        row.get("R3", 0.0),
        row.get("S3", 0.0),
        row.get("R4", 0.0),
        row.get("S4", 0.0),
        spreading_factor(kind),
        None if angle is None else radians(angle),
    )


_RPM = 30.0 / pi


@frozen(eq=False)
class SkfMoment:
    """The moment and what it is made of; arrays of one shape.

    rolling, sliding, starting N·m; the factors and the sliding coefficient are dimensionless.
    """

    rolling: FloatArray
    sliding: FloatArray
    starting: FloatArray
    """What it takes to start the bearing from rest: sliding with μ_bl = 0.15."""
    inlet_heating: FloatArray
    replenishment: FloatArray
    sliding_coefficient: FloatArray


def skf_moment(
    constants: SkfConstants,
    *,
    speed: ArrayLike,
    bore_diameter: ArrayLike,
    outside_diameter: ArrayLike,
    kinematic_viscosity: ArrayLike,
    radial_load: ArrayLike,
    axial_load: ArrayLike = 0.0,
    static_load_rating: ArrayLike | None = None,
    axial_factor: ArrayLike | None = None,
    supply: Supply = "grease",
    oil: str = "mineral",
) -> SkfMoment:
    """SKF's moment of a bearing without contact seals, not in an oil bath that drags.

    Parameters
    ----------
    constants : of the series.
    speed : of the rings to each other; rad/s.
    bore_diameter, outside_diameter : m.
    kinematic_viscosity : of the oil, or the grease's base oil, at its temperature; m²/s.
    radial_load, axial_load : N.
    static_load_rating : C_0; N. Deep-groove bearings with axial load need it.
    axial_factor : Y; tapered roller bearings need it.
    supply : how the lubricant comes, a key of `lubrication.film_thickness.REPLENISHMENT`.
    oil : a key of `SLIDING_FULL_FILM`.

    Returns
    -------
    SkfMoment of the broadcast shape.

    Raises
    ------
    InputError
        For an unknown word, or a number that is missing or out of range.
    """
    turning = np.abs(numbers(speed, "speed"))
    bore = positive(bore_diameter, "bore_diameter", finite=True)
    outside = positive(outside_diameter, "outside_diameter", finite=True)
    viscosity = positive(kinematic_viscosity, "kinematic_viscosity", finite=True)
    _known(REPLENISHMENT, supply, "supply")
    replenished = replenishment(viscosity, turning, bore, outside, supply, kind=constants.k_z)
    diameter = 0.5 * (bore + outside)
    n, nu, mean = _RPM * turning, 1e6 * viscosity, 1e3 * diameter
    fr = np.abs(numbers(radial_load, "radial_load"))
    fa = np.abs(numbers(axial_load, "axial_load"))
    given = _Given(constants, mean, fr, fa, n, static_load_rating, axial_factor)
    rolling, sliding = _FORMULAS[toml_of("skf_friction")["formulas"][constants.kind]](given)
    heating = skf_inlet_heating(viscosity, turning, diameter)
    boundary = boundary_share(viscosity, turning, diameter)
    full_film = full_film_of(constants.kind) or _known(SLIDING_FULL_FILM, oil, "oil")
    coefficient = blended(boundary, SLIDING_BOUNDARY, full_film)
    return SkfMoment(
        *np.broadcast_arrays(
            1e-3 * heating * replenished * rolling * (nu * n) ** 0.6,
            1e-3 * sliding * coefficient,
            1e-3 * sliding * SLIDING_AT_START,
            heating,
            replenished,
            coefficient,
        )
    )


def skf_torque(moment: SkfMoment, speed: ArrayLike) -> Torque:
    """The moment as a `Torque`; parts "rolling" and "sliding". speed: rad/s.

    Contact seals and the drag of an oil bath are not counted.
    """
    parts = {"rolling": np.atleast_1d(moment.rolling), "sliding": np.atleast_1d(moment.sliding)}
    return torque_of_parts(MODEL.name, parts, np.atleast_1d(np.asarray(speed)))


class _Given(NamedTuple):
    """Constants, d_m (mm), F_r, F_a (N), n (rpm), C_0 (N) and Y, where they are given."""

    c: SkfConstants
    mean: FloatArray
    fr: FloatArray
    fa: FloatArray
    n: FloatArray
    rating: ArrayLike | None
    factor: ArrayLike | None


_Both = tuple[FloatArray, FloatArray]
"""G_rr and G_sl."""


def _grooves(g: _Given) -> _Both:
    c, mean, fr, fa = g.c, g.mean, g.fr, g.fa
    axial = fa > 0.0
    if g.rating is None and np.any(axial):
        raise InputError(
            said("is needed for a deep-groove bearing with axial load"),
            field="static_load_rating",
            example="static_load_rating = 7800.0",
        )
    c0 = positive(1.0 if g.rating is None else g.rating, "static_load_rating", finite=True)
    angle = np.radians(24.6) * (np.where(axial, fa, c0) / c0) ** 0.24
    sine = np.sin(angle)
    pushed = np.where(axial, fa, 0.0)
    rolling = c.r1 * mean**1.96 * (fr + c.r2 / sine * pushed) ** 0.54
    combined = c.s1 * mean**-0.145 * np.cbrt(fr**5 + c.s2 * mean**1.5 / sine * pushed**4)
    return rolling, np.where(axial, combined, c.s1 * mean**-0.26 * fr ** (5.0 / 3.0))


def _inclined(g: _Given) -> _Both:
    return _thrown(g, 4.0, 1.97, 0.26)


def _sphere(g: _Given) -> _Both:
    return _thrown(g, 3.5, 2.0, -0.12)


def _thrown(g: _Given, thrown: float, rolls: float, slides: float) -> _Both:
    """Balls that centrifugal forces press out; thrown, rolls, slides: powers of d_m."""
    c, mean, power = g.c, g.mean, 4.0 / 3.0
    inertia = mean**thrown * g.n**2
    rolling = c.r1 * mean**rolls * (g.fr + c.r3 * inertia + c.r2 * g.fa) ** 0.54
    sliding = c.s1 * mean**slides * ((g.fr + c.s3 * inertia) ** power + c.s2 * g.fa**power)
    return rolling, sliding


def _washers(g: _Given) -> _Both:
    return g.c.r1 * g.mean**1.83 * g.fa**0.54, g.c.s1 * g.mean**0.05 * g.fa ** (4.0 / 3.0)


def _cylinders(g: _Given) -> _Both:
    rolling = g.c.r1 * g.mean**2.41 * g.fr**0.31
    return rolling, g.c.s1 * g.mean**0.9 * g.fa + g.c.s2 * g.mean * g.fr


def _cones(g: _Given) -> _Both:
    if g.factor is None:
        raise InputError(
            said("is needed for a tapered roller bearing"),
            field="axial_factor",
            example="axial_factor = 1.6",
        )
    pushed = positive(g.factor, "axial_factor", finite=True) * g.fa
    rolling = g.c.r1 * g.mean**2.38 * (g.fr + g.c.r2 * pushed) ** 0.31
    return rolling, g.c.s1 * g.mean**0.82 * (g.fr + g.c.s2 * pushed)


def _barrels(g: _Given) -> _Both:
    """The lesser of point and line contact, each for rolling and for sliding."""
    c, mean, third = g.c, g.mean, 1.0 / 3.0
    rolling = np.minimum(
        c.r1 * mean**1.85 * (g.fr + c.r2 * g.fa) ** 0.54,
        c.r3 * mean**2.3 * (g.fr + c.r4 * g.fa) ** 0.31,
    )
    sliding = np.minimum(
        c.s1 * mean**0.25 * (g.fr**4 + c.s2 * g.fa**4) ** third,
        c.s3 * mean**0.94 * (g.fr**3 + c.s4 * g.fa**3) ** third,
    )
    return rolling, sliding


def _flat_washers(g: _Given) -> _Both:
    return g.c.r1 * g.mean**2.38 * g.fa**0.31, g.c.s1 * g.mean**0.62 * g.fa


def _torus(g: _Given) -> _Both:
    """The lesser of point and line contact; under a radial load only."""
    c, mean, fr = g.c, g.mean, g.fr
    rolling = np.minimum(c.r1 * mean**1.97 * fr**0.54, c.r2 * mean**2.37 * fr**0.31)
    sliding = np.minimum(c.s1 * mean**-0.19 * fr ** (5.0 / 3.0), c.s2 * mean**1.05 * fr)
    return np.where(g.fa > 0.0, np.nan, rolling), np.where(g.fa > 0.0, np.nan, sliding)


_FORMULAS: Final[Mapping[str, Callable[[_Given], _Both]]] = {
    "grooves": _grooves,
    "inclined": _inclined,
    "sphere": _sphere,
    "washers": _washers,
    "cylinders": _cylinders,
    "cones": _cones,
    "barrels": _barrels,
    "torus": _torus,
    "flat_washers": _flat_washers,
}
"""The equations of table 2a, by their names in data/skf_friction.toml."""


def _known(table: Mapping[Any, float], word: str, field: str) -> float:
    one_of(word, field, table)
    return table[word]


_SAME_ANGLE: Final = radians(1.0)


def _of_bearing(setting: Setting) -> Torque:
    speed = setting.solved.relative_speed
    moments = [_moment(setting, machine) for machine in setting.machines]
    whole = added([skf_torque(moment, speed) for moment in moments])
    if not all(TYPES[one.kind].has_rollers for one in setting.machines):
        return whole
    return replace(whole, starting=np.sum([moment.starting for moment in moments], axis=0))


def _moment(setting: Setting, machine: MachineBearing) -> SkfMoment:
    """That of one of the bearings under its own load."""
    assert machine.constants is not None
    radial, axial = bearing_load(setting.solved, machine)
    return skf_moment(
        machine.constants,
        speed=setting.solved.relative_speed,
        bore_diameter=machine.bore_diameter,
        outside_diameter=machine.outside_diameter,
        kinematic_viscosity=machine.kinematic_viscosity,
        radial_load=radial,
        axial_load=axial,
        static_load_rating=machine.static_load_rating,
        axial_factor=machine.axial_factor,
        supply=machine.supply,
        oil=machine.oil,
    )


def _limits(setting: Setting) -> dict[str, BoolArray]:
    """SKF's constants for angular-contact bearings are for one contact angle."""
    differs: bool | BoolArray = False
    for machine in setting.machines:
        assert machine.constants is not None
        own = machine.constants.contact_angle
        if own is not None:
            differs = differs | (np.abs(machine.contact_angle - own) > _SAME_ANGLE)
    return {
        **limits_of_lubricated_bearings(setting),
        "other_angle": np.full(setting.regime.shape, differs),
    }


MODEL: Final = TorqueModel(
    name="skf",
    title=marked("SKF"),
    short_title=marked("SKF"),
    needs=("constants",),
    evaluate=_of_bearing,
    limits=_limits,
    of_contacts=False,
    closed_form=True,
)
