"""Static safety: of every contact by its pressure and by its load, and of the bearing by C_0/P_0.

C_0 is the load under which the contact with the most load has a limiting pressure p_lim: 4200 MPa,
4600 MPa of self-aligning ball bearings, 4000 MPa of rollers (ISO 76). Loads grow with the cube of
the pressure of points and with its square along lines, so that a contact of pressure p has

    S = (p_lim/p)³  (points),    S = (p_lim/p)²  (lines),

and edges of rollers count. By its load it has S = Q_0/Q with the load Q_0 that C_0 puts on the
contact with the most load, by which the standard derives its ratings:

    Q_0 = 5 C_0/(Z cos α) of radial ball, 4.076 C_0/(Z cos α) of radial roller bearings,
    Q_0 = C_0a/(Z sin α) of thrust bearings,

C_0 and Z being those of a row. The two differ where a bearing's C_0 is not that of its geometry,
and where rollers are loaded unevenly along their length. For the bearing, S_0 = C_0/P_0.

Raceways softer than 58 HRC bear less: C_0 and all of these are multiplied by
f = min(1, c (HV/800)²), c = 1.5 for balls and 2 for rollers (Harris and Kotzalas, 2006; general
knowledge, no page at hand).

Sources: ISO 76:2006, 3 and 5; ISO/TR 10657 for Q_0; makers' tables in data/static_safety.toml.
"""

from __future__ import annotations

from typing import Final, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.static import Operation, Requirement, Static
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.life.basis import static_of_bearings
from rolamento.life.conditions import conditions_of
from rolamento.life.equivalent_load import static_safety
from rolamento.life.row_ratings import (
    nominal_contact_angle,
    ratings_of,
    row_kinds,
    within_rating,
)
from rolamento.numerics import FloatArray
from rolamento.ratings import Rated, RatedType, RollerRated, rated_as
from rolamento.records import frozen, span
from rolamento.safety.hardening import Hardening, hardening_of, vickers_of_rockwell
from rolamento.safety.launch import Launch, launch_of
from rolamento.solution import solve
from rolamento.solved import RACES, Solved
from rolamento.types import type_of_element
from rolamento.validate import numbers, one_of
from rolamento.words import Note

__all__ = [
    "RaceSafety",
    "Recommended",
    "StaticSafety",
    "load_of_rating",
    "pressure_limit",
    "recommended_safety",
    "static_safety_of",
    "stress_safety",
]

_SOFT: Final = {"ball": 1.5, "roller": 2.0}
_HARD: Final = 800.0
"""HV"""


def pressure_limit(kind: Rated) -> float:
    """Return the pressure under C_0 by what a row is rated as, in Pa.

    Parameters
    ----------
    kind
        ``"radial"``, ``"self_aligning"``, ``"thrust"``, ``"roller"`` or ``"roller_thrust"``.

    ISO 76:2006.

    >>> f"{1e-6 * pressure_limit('self_aligning'):.0f} MPa"
    '4600 MPa'
    """
    one_of(kind, "kind", get_args(RatedType) + get_args(RollerRated))
    return 1e6 * float(toml_of("static_safety")["pressure"][kind])


def stress_safety(
    max_pressure: ArrayLike, limit: ArrayLike, *, line: ArrayLike = False
) -> FloatArray:
    """Static safety by the pressure: (p_lim/p)³ of points, (p_lim/p)² of lines.

    Parameters
    ----------
    max_pressure
        p, in Pa; infinite safety where nothing presses.
    limit
        p_lim, in Pa.
    line
        Whether the contact is a line.

    ISO 76:2006: Hertz's relation of load and pressure.

    >>> float(stress_safety(2.1e9, 4.2e9))
    8.0
    """
    p = numbers(max_pressure, "max_pressure")
    with np.errstate(divide="ignore"):
        ratio = numbers(limit, "limit") / p
    return np.asarray(ratio ** np.where(line, 2.0, 3.0))


def load_of_rating(
    static_rating: ArrayLike, element_count: ArrayLike, contact_angle: ArrayLike, kind: Rated
) -> FloatArray:
    """Load Q_0 that C_0 puts on the contact of a row with the most load; N.

    Parameters
    ----------
    static_rating
        C_0 of the row, in N; axial of thrust bearings.
    element_count
        Z of the row.
    contact_angle
        Nominal, in rad.
    kind
        What the row is rated as.

    ISO 76:2006 with ISO/TR 10657.

    >>> f"{load_of_rating(20e3, 10, 0.0, 'radial'):.0f} N"
    '10000 N'
    """
    angle = numbers(contact_angle, "contact_angle")
    own = rated_as(kind)
    along = np.sin(angle) if own["axial"] else np.cos(angle)
    count = numbers(element_count, "element_count")
    return np.asarray(own["share"] * numbers(static_rating, "static_rating") / (count * along))


@frozen
class Recommended:
    """The static safety that a maker recommends.

    Attributes
    ----------
    maker
    safety
        S_0; None where the maker's table has no such entry
    at_least
        whether the table says "or more"
    source
    checked
        whether the figure was held against a published text
    """

    maker: str
    safety: float | None
    at_least: bool
    source: str
    checked: bool


def recommended_safety(
    element: str, operation: Operation = "normal", requirement: Requirement = "normal"
) -> tuple[Recommended, ...]:
    """Return the static safety that makers recommend, side by side.

    Parameters
    ----------
    element
        What rolls, as a case file has it, such as ``"ball"`` or ``"needle"``.
    operation, requirement
        As of `rolamento.case.Static`.

    >>> [(one.maker, one.safety) for one in recommended_safety("ball", "shock", "high")]
    [('SKF', 2.0), ('NSK', None)]
    """
    rolls = "roller" if type_of_element(element).has_rollers else "ball"
    found = []
    for row in toml_of("static_safety")["recommended"]:
        if rolls not in row or element not in row.get("elements", (element,)):
            continue
        value = row[rolls].get(operation, {}).get(requirement)
        more = operation == "shock" and row.get("shock_at_least", False)
        found.append(Recommended(row["maker"], value, more, row["source"], row["checked"]))
    return tuple(found)


@frozen(eq=False)
class RaceSafety:
    """Static safety of the contacts with one race; (cases, elements), infinite without load.

    Attributes
    ----------
    by_stress
        (p_lim/p)³ of points, (p_lim/p)² of lines
    by_load
        Q_0/Q; NaN where no C_0 is known
    """

    by_stress: FloatArray
    by_load: FloatArray


@frozen(eq=False)
class StaticSafety:
    """How far solved cases are from what they bear at rest; SI.

    Attributes
    ----------
    solved
        with the load factor in its loads
    demands
        of the case
    limit
        p_lim of each row, (rows,) (Pa)
    load_limit
        Q_0 of each row, (cases, rows) (N)
    inner, outer
        the safeties of every contact
    rating, equivalent_load, safety
        C_0, P_0 and S_0 of each bearing, (cases, bearings); NaN where the standard has none
    hardness_factor
        of soft raceways, on all safeties; (rows,)
    recommended
        of each kind of rolling element, by makers
    hardening
        what the races need, by race
    launch
        margins to the allowable stress, and gaps
    notes
    """

    solved: Solved
    demands: Static
    limit: FloatArray
    load_limit: FloatArray
    inner: RaceSafety
    outer: RaceSafety
    rating: FloatArray
    equivalent_load: FloatArray
    safety: FloatArray
    hardness_factor: FloatArray
    recommended: tuple[Recommended, ...]
    hardening: dict[str, Hardening]
    launch: Launch
    notes: tuple[Note, ...]

    def of_rows(self, race: str, by: str) -> FloatArray:
        """Return the minimum safety of each row at a race; (cases, rows).

        Parameters
        ----------
        race
            ``"inner"`` or ``"outer"``.
        by
            ``"stress"`` or ``"load"``.
        """
        values = getattr(getattr(self, race), f"by_{by}")
        return np.asarray(np.minimum.reduceat(values, self.solved.rows.starts, axis=1))

    def minimum(self, by: str = "stress") -> FloatArray:
        """Return the minimum safety of all contacts; (cases,). by: as `of_rows`."""
        both = [self.of_rows(race, by).min(axis=1) for race in RACES]
        return np.asarray(np.minimum(*both))

    def _shown(self) -> dict[str, str]:
        return {
            "": self.solved.title or "a case without a title",
            "safety by stress": span(self.minimum("stress")),
            "safety by load": span(self.minimum("load")),
            "C_0/P_0": span(self.safety),
            "load factor": f"{self.demands.load_factor:g}",
        }

    def to_mapping(self) -> dict[str, object]:
        """Give a single case as plain mappings and lists in SI units, NaN as None."""
        from rolamento.io.json import plain

        rows = [
            {
                "pressure_limit": float(self.limit[row]),
                "load_limit": float(self.load_limit[0, row]),
                "hardness_factor": float(self.hardness_factor[row]),
                "gap": float(self.launch.gap[0, row]),
                "lost": bool(self.launch.lost[0, row]),
                **{
                    race: {
                        "safety_by_stress": float(self.of_rows(race, "stress")[0, row]),
                        "safety_by_load": float(self.of_rows(race, "load")[0, row]),
                        "max_pressure": float(self.hardening[race].max_pressure[0, row]),
                        "max_shear": float(self.hardening[race].shear[0, row]),
                        "max_shear_depth": float(self.hardening[race].depth[0, row]),
                        "hardness": float(self.hardening[race].hardness[0, row]),
                        "case_depth": float(self.hardening[race].case_depth[0, row]),
                    }
                    for race in RACES
                },
            }
            for row in range(len(self.limit))
        ]
        bearings = [
            {"static_rating": c, "static_equivalent_load": p, "static_safety": s}
            for c, p, s in zip(
                self.rating[0].tolist(),
                self.equivalent_load[0].tolist(),
                self.safety[0].tolist(),
                strict=True,
            )
        ]
        found = {
            "title": self.solved.title,
            "converged": bool(self.solved.converged[0]),
            "load_factor": self.demands.load_factor,
            "safety_by_stress": float(self.minimum("stress")[0]),
            "safety_by_load": float(self.minimum("load")[0]),
            "bearings": bearings,
            "rows": rows,
            "recommended": [
                {"maker": r.maker, "static_safety": r.safety, "source": r.source}
                for r in self.recommended
            ],
            "allowables": [
                {"key": a.key, "pressure": a.pressure, "margin": float(a.margin[0])}
                for a in self.launch.allowables
            ],
            "notes": [note.to_mapping() for note in (*self.solved.notes[0], *self.notes)],
        }
        return dict(plain(found))


def static_safety_of(source: Case | Solved) -> StaticSafety:
    """Static safety of a case, or of solved ones, with the load factor of ``[static]``.

    Parameters
    ----------
    source
        A case, or what `rolamento.solve` returned: it is solved anew where the load factor is
        not 1.

    Returns
    -------
    StaticSafety
        NaN where a case has no result.

    >>> from rolamento.case import case_of
    >>> found = static_safety_of(case_of("6310", {"duty.load.fz": "19 kN"}))
    >>> f"{found.safety[0, 0]:.2f}"  # 38.5 kN / 19 kN
    '2.03'
    """
    case = source if isinstance(source, Case) else source.case
    demands = case.static or Static()
    if isinstance(source, Case):
        solved = solve(factored(source, demands.load_factor))
    elif demands.load_factor == 1.0:
        solved = source
    else:
        times = demands.load_factor
        varied = {
            name: values * times if name.startswith("duty.load.") else values
            for name, values in source.varied.items()
        }
        solved = solve(factored(source.case, times), varied or None)
    rows, kinds = solved.rows, row_kinds(solved)
    limit = np.array([pressure_limit(kind) for kind in kinds])
    lines = np.isfinite(rows.effective_length)
    factor = _hardness_factor(demands.surface_hardness, lines[0])
    load_limit = _load_limit(solved, kinds) * factor
    of_race = {}
    for race in RACES:
        contacts = solved.contacts[race]
        stress = stress_safety(
            contacts.max_pressure,
            rows.per_element(limit),
            line=_are_lines(contacts.semi_major, rows.per_element(rows.effective_length)),
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            load = rows.per_element(load_limit) / contacts.load
        of_race[race] = RaceSafety(stress * rows.per_element(factor), load)
    rating, equivalent = static_of_bearings(solved)
    worst = float(factor.min())
    core = demands.core_hardness or float(toml_of("static_safety")["hardness"]["core"])
    hardening = hardening_of(solved, core)
    launch = launch_of(solved, demands.allowable_pressure)
    elements = dict.fromkeys(rows.element)
    recommended = tuple(
        one
        for element in elements
        for one in recommended_safety(element, demands.operation, demands.requirement)
    )
    with np.errstate(invalid="ignore"):
        safety = static_safety(rating, equivalent) * worst
    return StaticSafety(
        solved, demands, limit, load_limit, of_race["inner"], of_race["outer"], rating, equivalent,
        np.asarray(safety), factor, recommended, hardening, launch,
        tuple(_notes(solved, demands, rating, hardening, launch, worst)),
    )  # fmt: skip


def factored(case: Case, factor: float) -> Case:
    """Return a case with its loads multiplied; its preload and its displacements stay.

    Parameters
    ----------
    case, factor
        The case, and what its loads are multiplied with.
    """
    if factor == 1.0:
        return case
    load = case.duty.load
    names = ("fx", "fy", "fz", "my", "mz")
    given = {name: getattr(load, name) for name in names}
    return case.with_(
        {f"duty.load.{name}": factor * value for name, value in given.items() if value}
    )


def _are_lines(semi_major: FloatArray, length: FloatArray) -> FloatArray:
    """Whether the pressure spreads over the whole roller; of barrels a point under little load."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.isfinite(length) & (2.0 * semi_major > 0.99 * length))


def _hardness_factor(rockwell: float | None, lines: FloatArray) -> FloatArray:
    if rockwell is None or rockwell >= toml_of("static_safety")["hardness"]["full"]:
        return np.ones(len(lines))
    vickers = float(vickers_of_rockwell(rockwell))
    constant = np.where(lines, _SOFT["roller"], _SOFT["ball"])
    return np.asarray(np.minimum(1.0, constant * (vickers / _HARD) ** 2))


def _load_limit(solved: Solved, kinds: tuple[Rated, ...]) -> FloatArray:
    """Q_0 of each row, (cases, rows); NaN where no C_0 is known."""
    rows = solved.rows
    nothing = np.full(rows.ball_diameter.shape, np.nan)
    try:
        angle = within_rating(nominal_contact_angle(solved), kinds)
        ratings = ratings_of(solved, angle, conditions_of(solved))
    except InputError as error:
        if error.field not in ("bearing.contact_angle", "dynamic_rating"):
            raise
        return nothing
    return np.stack(
        [
            load_of_rating(ratings.static[:, i], rows.element_count[i], angle[:, i], kind)
            for i, kind in enumerate(kinds)
        ],
        axis=1,
    )


def _notes(
    solved: Solved,
    demands: Static,
    rating: FloatArray,
    hardening: dict[str, Hardening],
    launch: Launch,
    factor: float,
) -> list[Note]:
    found: list[Note] = []
    if not solved.converged[0]:
        return found
    if np.isnan(rating[0]).any():
        found.append(Note("no_static_rating_for_safety"))
    if factor < 1.0:
        found.append(
            Note("soft_raceways", {"hardness": demands.surface_hardness, "factor": factor})
        )
    if launch.lost[0].any():
        rows = np.flatnonzero(launch.lost[0]).tolist()
        found.append(Note("rows_gap", {"rows": rows, "gap": float(launch.gap[0, rows].max())}))
    needed = max(float(np.nanmax(one.case_depth[0])) for one in hardening.values())
    if demands.case_depth is not None and demands.case_depth < needed:
        values = {"depth": demands.case_depth, "needed": needed}
        found.append(Note("case_too_shallow", values))
    hardest = max(float(np.nanmax(one.hardness[0])) for one in hardening.values())
    if demands.surface_hardness is not None:
        own = float(vickers_of_rockwell(demands.surface_hardness))
        if own < hardest:
            found.append(Note("subsurface_yielding", {"hardness": own, "needed": hardest}))
    turning = np.any(solved.field("duty.inner_speed") != solved.field("duty.outer_speed"))
    if turning and launch.allowables:
        found.append(Note("launch_limits_at_rest"))
    return found
