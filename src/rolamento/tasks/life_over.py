"""Life over a field of the case, over load as a diagram of stress over cycles, over load zone.

Every theory at every point, and where it is valid.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from typing import Any, Final, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.case import Case, case_of
from rolamento.case.bearing import ball_bearing
from rolamento.case.duty import LOADS
from rolamento.case.roller_bearing import RollerBearing
from rolamento.contact.hertz import effective_modulus
from rolamento.contact.line import EXPONENT as LINE
from rolamento.contact.line import pair_constant
from rolamento.contact.race import race_stiffness
from rolamento.errors import InputError
from rolamento.io.json import dumps
from rolamento.life import Headline, Life, LifeSummary, life
from rolamento.life.iso16281 import race_ratings
from rolamento.life.l_able import FactorTable
from rolamento.life.lamina import one_number_of_slices, roller_race_ratings
from rolamento.life.load_zone import (
    clearance_function,
    load_zone,
    roller_clearance_function,
    roller_zone_life,
    zone_life,
)
from rolamento.life.theories import THEORIES
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.fields import Value
from rolamento.studies.ranges import Range, read_range, refuse_many_singles
from rolamento.studies.solving import CONVERGED, INVALID_INPUT, array_fields, base_case
from rolamento.tasks.life import (
    SCHEMA,
    CaseSource,
    TableSource,
    conditions_with,
    factor_table,
)
from rolamento.words import Note, said
from rolamento.words.headlines import Qualified, over_cases

__all__ = [
    "LifeCurve",
    "LifeRows",
    "LoadLives",
    "ZoneLife",
    "curves_json",
    "life_curve",
    "life_curves",
    "lives_of_rows",
    "lives_over_load",
    "lives_over_zone",
]

_MINIMUM_LOAD, _MAXIMUM_LOAD = 0.02, 1.0
"""P/C from which and to which the lives go, at least."""
_REACH: Final = 3.0
"""The load is made so many times smaller and greater, at least."""
_POINTS: Final = 40
_NARROWEST, _WIDEST, _ZONES = 0.1, 3.0, 2901
_PURE: Final = 1e-6
"""Axial load or moment over the radial load, up to which the load is radial."""
_LONGEST_STATUS: Final = "U24"


@frozen(kw_only=True, eq=False)
class LifeRows:
    """Lives of a case at rows of values of its fields.

    Attributes
    ----------
    status
        (rows,), of each solved case; "invalid_input" where there is no such case
    theories
        by name, arrays (rows,); NaN where there is no life
    headline
        the life that leads, arrays (rows,)
    races, slopes
        basic reference life of each race, (rows, races), 10^6 rev, and Weibull's e, (races,)
    viscosity_ratio, contamination_factor
        κ and e_C, (rows,); NaN where they are not known
    slices
        into how many slices rollers were divided; None without rollers
    refused
        why there is no such case, and in which rows: (rows,)
    cautions
        what qualifies the life that leads, and in which rows; empty where it was not asked for
    """

    status: NDArray[np.str_]
    theories: Mapping[str, Life]
    headline: Headline
    races: FloatArray
    slopes: FloatArray
    viscosity_ratio: FloatArray
    contamination_factor: FloatArray
    slices: int | None
    refused: tuple[tuple[NDArray[np.int64], InputError], ...]
    cautions: tuple[Qualified, ...]

    def __getitem__(self, theory: str) -> Life:
        """Return the life by one theory, arrays (rows,)."""
        return self.theories[theory]

    @property
    def converged(self) -> bool:
        """Whether every row has a result."""
        return bool(np.all(self.status == CONVERGED))


@frozen(kw_only=True, eq=False)
class LifeCurve(LifeRows):
    """Lives of a case over the values of one field; the rows are the points.

    Attributes
    ----------
    case
        what does not vary
    label
        what sets this curve apart from others beside it; empty of the case itself
    over
        the range that was chosen: the field and its values
    """

    case: Case
    label: str
    over: Range

    def __len__(self) -> int:
        """Count the points."""
        return len(self.over.values)

    @property
    def in_hours(self) -> bool:
        """Whether lives are shown in hours: not where nothing ever turns."""
        return any(not np.isnan(own.hours).all() for own in self.theories.values())

    def shown(self, record: Life | Headline) -> FloatArray:
        """Lives of a record of the curve in hours, or else in millions of revolutions."""
        return record.hours if self.in_hours else record.life

    @property
    def field(self) -> str:
        """Dotted name of what varies."""
        return self.over.field.name

    @property
    def values(self) -> FloatArray:
        """What it takes, (points,), SI."""
        return self.over.values

    def to_mapping(self) -> dict[str, Any]:
        """Give all of it as plain values: SI units, hours, millions of revolutions."""
        leading = self.headline
        return {
            "label": self.label,
            "status": self.status,
            "headline": {
                "theory": leading.theory,
                "hours": leading.hours,
                "life": leading.life,
                "valid": leading.valid,
                "upper_bound": leading.below,
                "reason": leading.reason,
            },
            "theories": {
                name: {
                    "hours": own.hours,
                    "life": own.life,
                    "unlimited": np.isinf(own.life),
                    "valid": own.valid,
                    "upper_bound": own.below,
                    "notes": {key: where for key, where in own.notes.items() if np.any(where)},
                }
                for name, own in self.theories.items()
            },
            "viscosity_ratio": self.viscosity_ratio,
            "contamination_factor": self.contamination_factor,
            "case": self.case.to_mapping(),
        }


def curves_json(curves: Sequence[LifeCurve]) -> str:
    """Return curves over one field as one JSON object."""
    first = curves[0]
    return dumps(
        {
            "schema": SCHEMA,
            "kind": "life_curve",
            "title": first.case.title,
            "field": first.field,
            "unit": first.over.field.unit,
            "values": first.values,
            "curves": [curve.to_mapping() for curve in curves],
        },
        indent=2,
    )


def life_curve(
    case: CaseSource,
    over: Range | str,
    *,
    label: str = "",
    nsk_table: TableSource = None,
    decimal_mark: str | None = None,
) -> LifeCurve:
    """Solve a case over a range, and find its life by every theory.

    Parameters
    ----------
    case
        With its [life] table, designation and lubricant, if it has them; or its file.
    over
        From `read_range`, or its text: ``"duty.load.fz=1..8kN"``.
    label
        What sets this case apart.
    nsk_table, decimal_mark
        a_NSK of L_able, or its file; and the decimal mark in it, ``"point"`` or ``"comma"``, where
        nothing there says which.

    Raises
    ------
    InputError
        If no point of the range makes a case with a life; of the first point.
    """
    base, chosen = case_of(case), read_range(over) if isinstance(over, str) else over
    name, count = chosen.field.name, len(chosen.values)
    if name not in array_fields():
        refuse_many_singles(count)
    columns = {name: chosen.values.tolist()}
    table = factor_table(nsk_table, [base], decimal_mark)
    rows = lives_of_rows(base, columns, nsk_table=table, cautions=True)
    own = {one.name: getattr(rows, one.name) for one in fields(rows)}
    return LifeCurve(case=base, label=label, over=chosen, **own)


def life_curves(
    cases: Iterable[tuple[str, CaseSource]],
    over: Range | str,
    *,
    nsk_table: TableSource = None,
    decimal_mark: str | None = None,
) -> list[LifeCurve]:
    """Find the lives of several cases over one range, to be compared.

    Parameters
    ----------
    cases
        What sets each apart, and the case.
    over, nsk_table, decimal_mark
        As of `life_curve`.

    Raises
    ------
    InputError
        As `life_curve`, or if rollers are divided into different numbers of slices.
    """
    curves = [
        life_curve(one, over, label=label, nsk_table=nsk_table, decimal_mark=decimal_mark)
        for label, one in cases
    ]
    one_number_of_slices(curve.slices for curve in curves)
    return curves


# --- rows of values -----------------------------------------------------------------------------


def lives_of_rows(
    case: Case,
    columns: Mapping[str, Sequence[Value]],
    *,
    stress_volume: bool = True,
    nsk_table: FactorTable | None = None,
    cautions: bool = False,
) -> LifeRows:
    """Solve a case for every row of a table, and find the lives.

    Rows that differ in fields that a batch takes as arrays are solved together.

    Parameters
    ----------
    case
        Supplies what does not vary. A mounted one is solved with its clearance in operation.
    columns
        Values of one length, checked, SI, by the dotted names of the fields.
    stress_volume
        Whether to evaluate theories that take milliseconds for a case.
    nsk_table
        a_NSK of L_able.
    cautions
        Whether to collect what qualifies the lives; a millisecond for a row.

    Raises
    ------
    InputError
        If no row makes a case with a life; of the first row.
    """
    arrays = [name for name in columns if name in array_fields()]
    single = [name for name in columns if name not in array_fields()]
    count = len(next(iter(columns.values())))
    groups: dict[tuple[Value, ...], list[int]] = {}
    for row in range(count):
        groups.setdefault(tuple(columns[name][row] for name in single), []).append(row)
    status = np.full(count, INVALID_INPUT, dtype=_LONGEST_STATUS)
    blocks: list[tuple[NDArray[np.int64], LifeSummary]] = []
    refused = []
    notes: list[Sequence[Note]] = [()] * count
    for own, members in groups.items():
        index = np.array(members, dtype=np.int64)
        varied: dict[str, ArrayLike] = {
            name: np.array([columns[name][i] for i in members], np.float64) for name in arrays
        }
        try:
            changed = base_case(case, dict(zip(single, own, strict=True))) if single else case
            # alike in all: the length has to come from somewhere
            alike = {"duty.inner_speed": np.full(len(index), changed.duty.inner_speed)}
            solved = solve(changed, varied or alike)
            given = conditions_with(solved, nsk_table)
            found = life(solved, given, stress_volume=stress_volume)
        except InputError as error:
            refused.append((index, error))
        else:
            status[index] = solved.status.code
            blocks.append((index, found))
            for place, row in enumerate(members if cautions else ()):
                notes[row] = (*solved.notes[place], *found.qualifications(place))
    if not blocks:
        raise refused[0][1]
    slices = one_number_of_slices(own.slices for _, own in blocks)
    known = {name for _, summary in blocks for name in summary.theories}
    races = [
        (index, np.concatenate([own.reference.inner, own.reference.outer], axis=1))
        for index, own in blocks
    ]
    return LifeRows(
        status=status,
        theories={
            name: _joined(
                [(index, own[name]) for index, own in blocks if name in own.theories], count
            )
            for name in THEORIES
            if name in known
        },
        headline=_joined([(index, own.headline) for index, own in blocks], count),
        races=_spread(races, count),
        slopes=blocks[0][1].reference.race_slopes,
        slices=slices,
        viscosity_ratio=_spread([(i, own.viscosity_ratio) for i, own in blocks], count),
        contamination_factor=_spread([(i, own.contamination_factor) for i, own in blocks], count),
        refused=tuple(refused),
        cautions=over_cases(notes),
    )


Record = TypeVar("Record", Life, Headline)
Part = tuple[NDArray[np.int64], Any]


def _joined(blocks: Sequence[tuple[NDArray[np.int64], Record]], count: int) -> Record:
    """Put the records of blocks of rows together; blank in the other rows."""
    joined: dict[str, Any] = {}
    for one in fields(blocks[0][1]):
        parts = [(index, getattr(record, one.name)) for index, record in blocks]
        first = parts[0][1]
        if isinstance(first, np.ndarray):
            joined[one.name] = _spread(parts, count)
        elif isinstance(first, Mapping):
            joined[one.name] = {
                name: _spread([(i, own[name]) for i, own in parts if name in own], count)
                for name in dict.fromkeys(name for _, own in parts for name in own)
            }
        else:
            joined[one.name] = parts[-1][1]
    return type(blocks[0][1])(**joined)


def _spread(parts: Sequence[Part], count: int) -> NDArray[Any]:
    """Put arrays of blocks of rows into one over all rows: NaN, False or "" in the others."""
    known = [(index, array) for index, array in parts if array is not None]
    if not known:
        return np.full(count, np.nan)
    first = known[0][1]
    blank = np.nan if first.dtype.kind == "f" else np.zeros((), first.dtype)
    found = np.full((count, *first.shape[1:]), blank, dtype=first.dtype)
    for index, array in known:
        found[index] = array
    return found


# --- over load and load zone --------------------------------------------------------------------


@frozen(eq=False)
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
        maximum pressure of all contacts, (points,), Pa
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


@frozen(eq=False)
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


def lives_over_load(solved: Solved, *, points: int = _POINTS) -> LoadLives:
    """Lives by every theory under loads smaller and greater than a case's.

    Parameters
    ----------
    solved
        Of `rolamento.solve`: a single case with a result, which has a life.
    points
        How many beside the case itself, from P/C of 0.02 to 1.

    Raises
    ------
    InputError
        If no load acts on the ring, or the case has no life.
    """
    case = solved.case
    given = {name: getattr(case.duty.load, name) for name in LOADS}
    acting = {name: value for name, value in given.items() if value}
    own = life(solved, stress_volume=False)
    by_reference = bool(np.isnan(own.loads.dynamic[0]))
    load = float(_load_over_rating(own, by_reference)[0])
    if not acting or not load > 0.0:
        raise InputError(
            said("is missing: life over load needs forces on the ring"),
            field="case.duty.load",
            example='fz = "10 kN"',
        )
    factor, place = _factors(load, points)
    values = {f"duty.load.{name}": value * factor for name, value in acting.items()}
    loaded = solve(case, values)
    found = life(loaded, stress_volume=True)
    return LoadLives(
        case=case,
        factor=factor,
        load=_load_over_rating(found, by_reference),
        by_reference=by_reference,
        pressure=np.fmax(*(c.max_pressure.max(axis=1) for c in loaded.contacts.values())),
        theories=found.theories,
        fatigue_load=float(own.ratings.fatigue_in_factor[0] / own.ratings.dynamic_of_set[0]),
        own=place,
    )


def lives_over_zone(solved: Solved) -> ZoneLife:
    """Life over the load zone of a solved case's bearing.

    Raises
    ------
    InputError
        If the bearing is a set, has a contact angle, or has no life.
    """
    if isinstance(solved.case.bearing, RollerBearing):
        return _rollers_over_zone(solved, solved.case.bearing)
    case, bearing = solved.case, ball_bearing(solved.case)
    if bearing.is_set or bearing.contact_angle:
        raise InputError(
            said("needs a single radial-contact bearing given by its clearance"),
            field="case.bearing",
            example="diametral_clearance in the place of contact_angle",
        )
    ratings = race_ratings(
        life(solved, stress_volume=False).ratings.dynamic[0, 0],
        bearing.ball_count,
        bearing.ball_diameter,
        bearing.pitch_diameter,
        bearing.inner_conformity,
        bearing.outer_conformity,
        0.0,
    )
    zone = np.linspace(_NARROWEST, _WIDEST, _ZONES)
    scale = _clearance_scale(solved)
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


def _rollers_over_zone(solved: Solved, bearing: RollerBearing) -> ZoneLife:
    """The same of a single cylindrical or needle roller bearing."""
    if bearing.is_set or bearing.diametral_clearance is None:
        raise InputError(
            said("needs a single radial-contact bearing given by its clearance"),
            field="case.bearing",
            example="diametral_clearance in the place of contact_angle",
        )
    rating = life(solved, stress_volume=False).ratings.dynamic[0, 0]
    inside = (bearing.roller_count, bearing.roller_diameter, bearing.pitch_diameter)
    ratings = roller_race_ratings(rating, *inside, 0.0)
    zone = np.linspace(_NARROWEST, _WIDEST, _ZONES)
    modulus = effective_modulus(bearing.roller_material, bearing.ring_material)
    stiffness = float(pair_constant(bearing.effective_length, modulus))
    scale = (_radial_load(solved) / (bearing.roller_count * stiffness)) ** (1.0 / LINE)
    ratio, clearance = roller_zone_life(zone, ratings), scale * roller_clearance_function(zone)
    own, play = None, bearing.diametral_clearance
    if np.isfinite(scale) and clearance[-1] <= play <= clearance[0]:
        epsilon = float(np.interp(-play, -clearance, zone))
        own = epsilon, float(roller_zone_life(epsilon, ratings))
    return ZoneLife(case=solved.case, zone=zone, life_ratio=ratio, clearance=clearance, own=own)


def _radial_load(solved: Solved) -> float:
    """F_r, N; NaN if anything else acts on the ring."""
    load, arm = solved.load, solved.case.bearing.pitch_diameter
    radial = float(np.hypot(load.fy[0], load.fz[0]))
    others = (load.fx[0], load.my[0] / arm, load.mz[0] / arm)
    return radial if radial > 0.0 and max(map(abs, others)) <= _PURE * radial else float("nan")


def _clearance_scale(solved: Solved) -> float:
    """(F_r/(Z K))^(2/3), by which f(ε) gives the clearance, m; NaN if the load is not radial."""
    bearing, radial = ball_bearing(solved.case), _radial_load(solved)
    stiffness = float(race_stiffness(bearing, 0.0).combined)
    return float((radial / (bearing.ball_count * stiffness)) ** (2.0 / 3.0))


def _factors(load: float, points: int) -> tuple[FloatArray, int]:
    """Factors of the load, 1 among them, and where it is."""
    first = min(_MINIMUM_LOAD / load, 1.0 / _REACH)
    last = max(_MAXIMUM_LOAD / load, _REACH)
    factor = np.unique(np.append(np.geomspace(first, last, points), 1.0))
    return factor, int(np.searchsorted(factor, 1.0))


def _load_over_rating(found: LifeSummary, by_reference: bool) -> FloatArray:
    load = found.reference_load if by_reference else found.loads.dynamic
    return np.asarray(load / found.ratings.dynamic_of_set)
