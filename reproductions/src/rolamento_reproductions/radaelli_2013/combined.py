"""Figures 5.15 to 5.24 and 5.27 to 5.32, table 5.4: the 218 under combined load, level and tilted.

Effects are left out, and the balls turned: figures of the loads and angles round the ring.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import Displacement, Duty, Load
from rolamento.case.model import Model
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import RPM
from rolamento_reproductions.given import KILO, MILLI, status_column
from rolamento_reproductions.radaelli_2013.inputs import case, inputs_of, said, source_of
from rolamento_reproductions.record import (
    Cell,
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, same

_STEPS: Final = 15
"""Turns of the cage within the spacing of two balls: every 1.5° with sixteen balls."""


@dataclass(frozen=True, slots=True, eq=False)
class Round:
    """A case with the cage turned: arrays over all balls of all turns, by azimuth; SI and degrees.

    ball: 1 to Z where the source has a ball, NaN between. Displacement and moment are those with
    the balls where the source puts them.
    """

    case: Case
    solved: Solved
    turn: Floats
    azimuth: Floats
    ball: Floats
    inner_load: Floats
    outer_load: Floats
    inner_angle: Floats
    outer_angle: Floats
    order: np.ndarray[tuple[int, ...], np.dtype[np.int64]]

    @property
    def placed(self) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Where the source has a ball."""
        return np.isfinite(self.ball)

    @property
    def shift(self) -> Floats:
        """Displacement (x, y, z) of the inner ring; mm."""
        shift: Floats = self.solved.displacement.array[0, :3] / MILLI
        return shift

    @property
    def moment(self) -> float:
        """Reaction my; N·m."""
        return float(self.solved.load.my[0])


def solved_round(case: Case) -> Round:
    """Solve a case, and again with the cage turned."""
    count = case.bearing.element_count
    turns = np.arange(_STEPS) * 2.0 * np.pi / (count * _STEPS)
    solved = solve(case, first_ball_azimuth=case.duty.first_ball_azimuth + turns)
    number = np.full((_STEPS, count), np.nan)
    number[0] = np.arange(1.0, count + 1.0)
    # From above -180° to 180°; rounded, lest noise move a ball from one end to the other.
    azimuth = 180.0 - np.mod(np.round(180.0 - np.degrees(solved.elements.azimuth), 9), 360.0)
    order = np.argsort(azimuth.ravel(), kind="stable")
    turned = np.broadcast_to(np.degrees(turns)[:, np.newaxis], azimuth.shape)

    def sorted_by_azimuth(values: Floats) -> Floats:
        by_azimuth: Floats = values.ravel()[order]
        return by_azimuth

    return Round(
        case=case,
        solved=solved,
        turn=sorted_by_azimuth(turned),
        azimuth=sorted_by_azimuth(azimuth),
        ball=sorted_by_azimuth(number),
        inner_load=sorted_by_azimuth(solved.inner.load),
        outer_load=sorted_by_azimuth(solved.outer.load),
        inner_angle=sorted_by_azimuth(np.degrees(solved.inner.contact_angle)),
        outer_angle=sorted_by_azimuth(np.degrees(solved.outer.contact_angle)),
        order=order,
    )


def figure_pair(
    numbers: tuple[str, str], case: Text, source: Text, found: Round
) -> tuple[Figure, Figure]:
    """Return the figure of ball loads and that of contact angles, without statements."""
    load = said("ball_load_q")
    angle = said("contact_angle")
    loads = _figure_round_the_ring(
        numbers[0],
        said("figure_pair.ball_loads_at", case=case),
        source,
        found,
        (
            Series("inner_load", "N", load, found.inner_load),
            Series("outer_load", "N", load, found.outer_load),
        ),
        ("Q_i", "Q_o"),
    )
    angles = _figure_round_the_ring(
        numbers[1],
        said("figure_pair.contact_angles_at", case=case),
        source,
        found,
        (
            Series("inner_contact_angle", "°", angle, found.inner_angle),
            Series("outer_contact_angle", "°", angle, found.outer_angle),
        ),
        ("α_i", "α_o"),
    )
    return loads, angles


def _figure_round_the_ring(
    number: str,
    caption: Text,
    source: Text,
    found: Round,
    pair: tuple[Series, Series],
    symbols: tuple[str, str],
) -> Figure:
    places = (
        Series("azimuth", "°", said("azimuth"), found.azimuth),
        Series("ball", "", said("ball"), found.ball),
        Series("cage_turned", "°", said("figure_round_the_ring.cage_turned"), found.turn),
    )
    status = status_column(found.solved.status.code)
    states = np.asarray(status.values).repeat(found.case.bearing.element_count)[found.order]
    races = (
        said("figure_round_the_ring.inner_race", symbols=symbols[0]),
        said("figure_round_the_ring.outer_race", symbols=symbols[1]),
    )
    lines = tuple(
        Line(column.name, look, race, dashed=bool(look), marked="ball")
        for look, (column, race) in enumerate(zip(pair, races, strict=True))
    )
    return Figure(
        number=number,
        caption=caption,
        source=source,
        columns=(*places, *pair, Series("status", "", status.title, tuple(map(str, states)))),
        picture=Curves(
            (Panel("azimuth", pair[0].title, pair[0].unit, lines, tick=45.0, around=True),)
        ),
    )


_ALIKE_LOAD, _ALIKE_ANGLE = 0.10, 5.0
"""Differences that still read as alike: a part of the maximum load, and degrees."""
_NEAR_ZERO = 5.0  # degrees
_NEARLY_EQUAL = 0.05  # of the maximum load
_NEAR_DIRECTION = 3.0  # degrees


# --- figures 5.15 to 5.20 ---------------------------------------------------


def combined_section(title: Text) -> Section:
    """Compute figures 5.15 to 5.20."""
    given = inputs_of("combined")
    whole = _solved_combined(given)
    still = _solved_combined(given, model=Model(gyroscopic_moment=False))
    light = _solved_combined(given, model=Model(centrifugal_force=False))
    source = source_of("combined")
    figures = (
        *figure_pair(("5.15", "5.16"), _caption_of_loads(given), source, whole),
        *figure_pair(
            ("5.17", "5.18"),
            _caption_of_loads(given, said("combined_section.no_gyroscopic_moment")),
            source,
            still,
        ),
        *figure_pair(
            ("5.19", "5.20"),
            _caption_of_loads(given, said("combined_section.no_centrifugal_force")),
            source,
            light,
        ),
    )
    claims = (
        (_who_carries(whole),),
        (_opposite_angles(whole),),
        (_alike_loads(whole, still),),
        (_alike_angles(whole, still),),
        (_equal_inside_and_outside(whole, light),),
        (_greater_effect(whole, still, light),),
    )
    notes: dict[str, Text] = {"5.17": _displacements(whole, still), "5.19": _lightest(light)}
    return Section(title, _completed(figures, claims, notes))


def _solved_combined(
    given: dict[str, Any], *, model: Model | None = None, first_ball: float = 0.0
) -> Round:
    load = Load(
        fx=given["axial_load_kN"] * KILO,
        fz=given["radial_load_kN"] * KILO,
        fy=given.get("lateral_load_kN", 0.0) * KILO,
    )
    duty = Duty(
        inner_speed=given["inner_speed_rpm"] * RPM,
        first_ball_azimuth=np.radians(first_ball),
        load=load,
    )
    return solved_round(case(duty, model))


def _caption_of_loads(given: dict[str, Any], extra: Text | None = None) -> Text:
    return said(
        "caption_of_loads",
        inner_speed_rpm=given["inner_speed_rpm"],
        axial_load_kn=given["axial_load_kN"],
        radial_load_kn=given["radial_load_kN"],
        extra=extra or same(""),
    )


def _completed(
    figures: tuple[Figure, ...], claims: tuple[tuple[Claim, ...], ...], notes: dict[str, Text]
) -> tuple[Figure, ...]:
    """Put the statements beside their figures."""
    return tuple(
        replace(
            figure, claims=stated, notes=(notes[figure.number],) if figure.number in notes else ()
        )
        for figure, stated in zip(figures, claims, strict=True)
    )


def _who_carries(whole: Round) -> Claim:
    """Return what part of the radial load the balls within ±45° carry."""
    balls = whole.placed
    force = whole.inner_load * np.cos(np.radians(whole.inner_angle))
    radial = (force * np.cos(np.radians(whole.azimuth)))[balls]
    near = np.abs(whole.azimuth[balls]) <= 45.0 + 1e-6
    share = float(radial[near].sum() / radial.sum())
    opposite = _at_azimuth(whole, 180.0)
    return Claim(
        said("who_carries.statement"),
        said(
            "who_carries.finding",
            share=100.0 * share,
            inner_load=whole.inner_load[opposite],
            outer_load=whole.outer_load[opposite],
        ),
        share > 0.8 and float(whole.inner_load[opposite] / whole.inner_load.max()) < 0.05,
    )


def _opposite_angles(whole: Round) -> Claim:
    opposite = _at_azimuth(whole, 180.0)
    inner, outer = whole.inner_angle[opposite], whole.outer_angle[opposite]
    return Claim(
        said("opposite_angles.statement"),
        said("opposite_angles.finding", inner=inner, outer=outer),
        bool(outer < _NEAR_ZERO < 60.0 < inner),
    )


def _alike_loads(whole: Round, still: Round) -> Claim:
    difference, maximum = _load_difference(whole, still), float(whole.outer_load.max())
    return Claim(
        said("alike_loads.statement"),
        said(
            "alike_loads.finding",
            difference_1=difference,
            difference_2=100.0 * difference / maximum,
        ),
        difference < _ALIKE_LOAD * maximum,
    )


def _alike_angles(whole: Round, still: Round) -> Claim:
    difference = _angle_difference(whole, still)
    return Claim(
        said("alike_angles.statement"),
        said("alike_angles.finding", difference=difference),
        difference < _ALIKE_ANGLE,
    )


def _equal_inside_and_outside(whole: Round, light: Round) -> Claim:
    def apart(found: Round) -> float:
        return float(np.abs(found.outer_load - found.inner_load)[found.placed].max())

    maximum = float(light.outer_load.max())
    return Claim(
        said("equal_inside_and_outside.statement"),
        said(
            "equal_inside_and_outside.finding",
            apart_1=apart(light),
            apart_2=100.0 * apart(light) / maximum,
            apart_3=apart(whole),
        ),
        apart(light) < _NEARLY_EQUAL * maximum < apart(whole),
    )


def _greater_effect(whole: Round, still: Round, light: Round) -> Claim:
    moment, force = _angle_difference(whole, still), _angle_difference(whole, light)
    return Claim(
        said("greater_effect.statement"),
        said(
            "greater_effect.finding",
            force=force,
            moment=moment,
            load_difference_1=_load_difference(whole, light),
            load_difference_2=_load_difference(whole, still),
        ),
        force > 2.0 * moment,
    )


def _displacements(whole: Round, still: Round) -> Text:
    return said(
        "displacements",
        shift_1=whole.shift[0],
        shift_2=still.shift[0],
        shift_3=whole.shift[2],
        shift_4=still.shift[2],
    )


def _lightest(light: Round) -> Text:
    opposite = _at_azimuth(light, 180.0)
    return said(
        "lightest", inner_load=light.inner_load[opposite], outer_load=light.outer_load[opposite]
    )


def _at_azimuth(found: Round, azimuth: float) -> int:
    """Return the row of the ball at an azimuth."""
    off = np.where(found.placed, np.abs(found.azimuth - azimuth), np.inf)
    return int(np.argmin(off))


def _load_difference(one: Round, other: Round) -> float:
    inner = np.abs(one.inner_load - other.inner_load)
    return float(np.maximum(inner, np.abs(one.outer_load - other.outer_load))[one.placed].max())


def _angle_difference(one: Round, other: Round) -> float:
    inner = np.abs(one.inner_angle - other.inner_angle)
    return float(np.maximum(inner, np.abs(one.outer_angle - other.outer_angle))[one.placed].max())


# --- figures 5.21 to 5.24 ---------------------------------------------------


def three_loads_section(title: Text) -> Section:
    """Compute figures 5.21 to 5.24."""
    given = inputs_of("three_loads")
    found = [_solved_combined(given, first_ball=value) for value in given["first_ball_deg"]]
    figures: list[Figure] = []
    for numbers, one, first in zip(
        (("5.21", "5.22"), ("5.23", "5.24")), found, given["first_ball_deg"], strict=True
    ):
        extra = said(
            "three_loads_section.f_y_kn", lateral_load_kn=given["lateral_load_kN"], first=first
        )
        figures.extend(
            figure_pair(numbers, _caption_of_loads(given, extra), source_of("three_loads"), one)
        )
    direction = float(np.degrees(np.arctan2(given["lateral_load_kN"], given["radial_load_kN"])))
    claims = (
        (_turned_loads(found[0], direction),),
        (_turned_angles(found[0], direction),),
        (_moved_loads(found[0], found[1]),),
        (_moved_angles(found[0], found[1]),),
    )
    return Section(title, _completed(tuple(figures), claims, {"5.23": _moved_ring(*found)}))


def _turned_loads(found: Round, direction: float) -> Claim:
    peak = float(found.azimuth[np.argmax(found.inner_load)])
    return Claim(
        said("turned_loads.statement", direction=direction),
        said("turned_loads.finding", peak=peak),
        abs(peak - direction) < _NEAR_DIRECTION,
    )


def _turned_angles(found: Round, direction: float) -> Claim:
    peak = float(found.azimuth[np.argmax(found.inner_angle)])
    opposite = direction - 180.0
    return Claim(
        said("turned_angles.statement"),
        said("turned_angles.finding", peak=peak, opposite=opposite),
        abs(peak - opposite) < _NEAR_DIRECTION,
    )


def _moved_loads(still: Round, moved: Round) -> Claim:
    balls = [found.inner_load[found.placed] for found in (still, moved)]
    heaviest = [float(loads.max()) for loads in balls]
    change = _by_ball(still, moved, still.inner_load, moved.inner_load)
    return Claim(
        said("moved_loads.statement"),
        said("moved_loads.finding", change=change, heaviest_1=heaviest[1], heaviest_2=heaviest[0]),
        change > 0.01 * heaviest[0],
    )


def _moved_angles(still: Round, moved: Round) -> Claim:
    change = _by_ball(still, moved, still.inner_angle, moved.inner_angle)
    return Claim(
        said("moved_angles.statement"), said("moved_angles.finding", change=change), change > 1.0
    )


def _moved_ring(still: Round, moved: Round) -> Text:
    """Return how little the ring itself notices."""
    return said(
        "moved_ring",
        shift_1=still.shift[2],
        shift_2=moved.shift[2],
        shift_3=still.shift[1],
        shift_4=moved.shift[1],
    )


def _by_ball(one: Round, other: Round, values: np.ndarray, others: np.ndarray) -> float:
    """Maximum difference between balls of one number."""
    first = values[one.placed][np.argsort(one.ball[one.placed])]
    second = others[other.placed][np.argsort(other.ball[other.placed])]
    return float(np.abs(first - second).max())


_TILTED_FIGURES = (("5.27", "5.28"), ("5.29", "5.30"), ("5.31", "5.32"))
_STRONG_CHANGE = 0.10
"""A change of a displacement that counts as strong."""
_WEAK_LOAD, _WEAK_ANGLE = 0.10, 5.0
"""Changes that count as weak: a part of the maximum load, and degrees."""
_LOADED_PART = 0.10
"""Part of the maximum load from which a ball counts as loaded."""


def tilt_section(title: Text) -> Section:
    """Compute figures 5.27 to 5.32 and table 5.4."""
    tilts = [float(value) for value in inputs_of("tilted")["tilts_deg"]]
    found = {tilt: _solved_tilted(tilt) for tilt in tilts}
    figures = tuple(
        figure
        for numbers, tilt in zip(_TILTED_FIGURES, tilts, strict=True)
        for figure in _tilted_pair(numbers, tilt, found)
    )
    return Section(title, (*figures, _table_5_4(found)))


def _solved_tilted(tilt: float) -> Round:
    given = inputs_of("tilted")
    duty = Duty(
        inner_speed=given["inner_speed_rpm"] * RPM,
        load=Load(fx=given["axial_load_kN"] * KILO, fz=given["radial_load_kN"] * KILO),
        displacement=Displacement(ry=np.radians(tilt)),
    )
    return solved_round(case(duty))


def _tilted_pair(
    numbers: tuple[str, str], tilt: float, found: dict[float, Round]
) -> tuple[Figure, Figure]:
    given = inputs_of("tilted")
    named = said(
        "tilted_pair.218_at_rpm",
        inner_speed_rpm=given["inner_speed_rpm"],
        axial_load_kn=given["axial_load_kN"],
        radial_load_kn=given["radial_load_kN"],
        tilt=tilt,
    )
    loads, angles = figure_pair(numbers, named, source_of("tilted"), found[tilt])
    if tilt == 0.0:
        return replace(loads, claims=(_moment_without_tilt(found[tilt]),)), angles
    level = found[0.0]
    return (
        replace(loads, claims=(_weak_on_loads(level, found[tilt]),)),
        replace(angles, claims=(_weak_on_angles(level, found[tilt]),)),
    )


def _weak_on_loads(level: Round, tilted: Round) -> Claim:
    inner = np.abs(level.inner_load - tilted.inner_load)
    outer = np.abs(level.outer_load - tilted.outer_load)
    change = float(np.maximum(inner, outer)[level.placed].max())
    share = change / float(level.outer_load.max())
    return Claim(
        said("weak_on_loads.statement"),
        said("weak_on_loads.finding", change=change, share=100.0 * share),
        share < _WEAK_LOAD,
    )


def _weak_on_angles(level: Round, tilted: Round) -> Claim:
    inner = np.abs(level.inner_angle - tilted.inner_angle)
    outer = np.abs(level.outer_angle - tilted.outer_angle)
    change = np.maximum(inner, outer)[level.placed]
    loaded = level.inner_load[level.placed] > _LOADED_PART * level.inner_load.max()
    of_loaded, maximum = float(change[loaded].max()), float(change.max())
    return Claim(
        said("weak_on_angles.statement"),
        said(
            "weak_on_angles.finding",
            of_loaded=of_loaded,
            loaded_sum=int(loaded.sum()),
            loaded_part=100.0 * _LOADED_PART,
            maximum=maximum,
        ),
        holds=maximum < _WEAK_ANGLE,
        partly=of_loaded < _WEAK_ANGLE,
    )


def _moment_without_tilt(level: Round) -> Claim:
    return Claim(
        said("moment_without_tilt.statement"),
        same("M_y = {:.2f} N·m.", level.moment),
        level.moment > 1.0,
    )


def _table_5_4(found: dict[float, Round]) -> Table:
    given = inputs_of("table_5_4")
    rows = given["rows"]
    states = [found[float(row[0])] for row in rows]
    columns = (
        TableColumn("tilt_deg", same("θ_y (°)"), tuple(str(row[0]) for row in rows)),
        _printed_beside(rows, 1, "axial_displacement_mm", "δ_a (mm)", [s.shift[0] for s in states]),
        _printed_beside(
            rows, 2, "radial_displacement_mm", "δ_z (mm)", [s.shift[2] for s in states]
        ),
        _printed_beside(rows, 3, "moment_Nm", "M_y (N·m)", [s.moment for s in states]),
    )
    return Table(
        number="5.4",
        caption=said("table_5_4.caption"),
        source=source_of("table_5_4"),
        columns=columns,
        claims=(_strong_on_ring(found),),
        notes=(said("table_5_4.moment_is_measured"),),
    )


def _printed_beside(
    rows: list[list[str]], place: int, name: str, title: str, computed: list[float]
) -> TableColumn:
    cells = tuple(Cell(row[place], float(v)) for row, v in zip(rows, computed, strict=True))
    return TableColumn(name, same("{}", title), cells)


def _strong_on_ring(found: dict[float, Round]) -> Claim:
    level = found[0.0]
    others = [state for tilt, state in found.items() if tilt != 0.0]
    axial, radial = (
        [float(state.shift[axis] / level.shift[axis] - 1.0) for state in others] for axis in (0, 2)
    )
    return Claim(
        said("strong_on_ring.statement"),
        said(
            "strong_on_ring.finding",
            max(found),
            *(100.0 * value for value in (*axial, *radial)),
            *(100.0 * (state.moment / level.moment - 1.0) for state in others),
        ),
        min(abs(value) for value in (*axial, *radial)) > _STRONG_CHANGE,
    )
