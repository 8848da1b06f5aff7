"""The app's pictures: what solved cases show, one or two over one another, for Plotly.js.

Each is read from the records and shown in the units that people read; none computes anything.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import ceil, inf, isfinite
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis import Analysis
from rolamento.case import Case
from rolamento.contact.line import PRESSURE_LIMIT
from rolamento.friction import Friction
from rolamento.geometry import Race
from rolamento.heat import HeatBalance
from rolamento.life import LifeSummary
from rolamento.life.theories import BY_RANK, THEORIES
from rolamento.lubrication import Film
from rolamento.lubrication.regime import regimes
from rolamento.notes import nothing_given, pressure_limit
from rolamento.pages.film import regime_name
from rolamento.pages.frequencies import line_name
from rolamento.pages.friction import power_unit, source_name, torque_unit
from rolamento.pages.life import limiting_sentences
from rolamento.plots.along_roller import (
    chosen_roller,
    lying_roller,
    place_name,
    pressure_along,
    roller_label,
    tilted_name,
)
from rolamento.plots.axes_units import (
    DEGREE,
    MEGAPASCAL,
    MILLIMETRE,
    NONE,
    ReadableUnit,
    readable_unit,
)
from rolamento.plots.contacts import (
    AROUND,
    azimuth_name,
    contact_quantity,
    free_angle,
    load_unit,
    race_name,
    race_word,
    rows_in_order,
)
from rolamento.plots.groove import Slot, extent, slots_of
from rolamento.plots.texts import capitalised, no_result, number, theory_label
from rolamento.records import frozen
from rolamento.roller_notes import are_rollers
from rolamento.solved import RACES, Solved
from rolamento.tasks.heat import balance_of
from rolamento.units import HOUR, ZERO_CELSIUS
from rolamento.vibration.frequencies import ABBREVIATIONS, FAULTS
from rolamento.web.drawing import (
    FAINT,
    NUMBER,
    Picture,
    axis,
    decades,
    empty,
    line,
    look,
    numbers,
    picture,
    reach,
    rounded_up,
)
from rolamento.words import ENDLESS, in_unit, manner, marked, said
from rolamento.words.sentences.heat import PLACE_NAMES

__all__ = ["PICTURES", "PictureKind", "described", "figures"]

Floats = NDArray[np.float64]
Of = Callable[[Analysis, Race], Floats]
"""A number of the contacts with a race, SI, (elements,)."""

_BALLS, _ROLLERS, _SETS = frozenset({"ball"}), frozenset({"roller"}), frozenset({"set"})
_ALL: Final = frozenset({"ball", "roller"})
_MOST_LINES: Final = 8
_MOST_ROWS: Final = 6
_MOST_ELLIPSES: Final = 120
_TURN: Final = 360.0
_MARGIN: Final = 8.0
_NEAR: Final = 0.5
"""Fraction of a limit: from there on it is drawn."""
_HARMONICS: Final = 5
_DIRECTIONS: Final = (112.5, 247.5, 157.5, 202.5, 67.5, 292.5, 22.5, 337.5)
_LITTLE: Final = 0.3
"""Fraction of the greatest circle."""
_WRAPPED: Final[dict[str, Any]] = {"mode": "lines+markers", "meta": {"from": 1, "to": -1}}
"""Style of a line that goes all round: its ends are there once more."""
_DRAWING: Final = {"drawing": True}
"""Style of a picture whose lines are outlines: a table of their points says nothing."""


class _Shown(NamedTuple):
    """A case with a result: its place (0 or 1), what the legend calls it, empty if it is alone."""

    place: int
    name: str
    analysis: Analysis

    @property
    def solved(self) -> Solved:
        return self.analysis.solved

    def named(self, what: str) -> str:
        """Name a line of the case."""
        return said("{case}: {what}", case=self.name, what=what) if self.name else what


Cases = Sequence[_Shown]


@frozen
class PictureKind:
    """A kind of picture.

    Attributes
    ----------
    key
        by which the page asks for it
    label
        marked for translation
    of
        the bearings that it suits: "ball", "roller", "set"
    draw
        of the cases that have a result, at least one
    opened
        whether the page shows it at first
    unloaded
        whether it shows something of a bearing that nothing loads
    """

    key: str
    label: str
    of: frozenset[str]
    draw: Callable[[Cases], Picture]
    opened: bool = False
    unloaded: bool = False


def described() -> list[dict[str, Any]]:
    """Return what the page needs to know of all pictures, in the language that is spoken."""
    return [
        {"key": own.key, "label": said(own.label), "of": sorted(own.of), "opened": own.opened}
        for own in PICTURES.values()
    ]


def figures(
    analyses: Sequence[Analysis | None], keys: Iterable[str], *, names: Sequence[str] = ("A", "B")
) -> dict[str, Picture]:
    """Return pictures of one case or of two over one another.

    Parameters
    ----------
    analyses
        Of single cases; None of one that is wrong: the other is drawn alone.
    keys
        Of `PICTURES`; others are left out.
    names
        What legends call the cases where there are two.

    Returns
    -------
    dict
        By key; of cases without a result empty pictures that say why.
    """
    many = len(analyses) > 1
    there = [
        _Shown(place, names[place] if many else "", analysis)
        for place, analysis in enumerate(analyses)
        if analysis is not None
    ]
    shown = [one for one in there if one.solved.converged[0]]
    asked = [PICTURES[key] for key in dict.fromkeys(keys) if key in PICTURES]
    found = {}
    for kind in asked:
        suited = [one for one in shown if kind.of & _kinds_of(one.solved)]
        loaded = [one for one in suited if kind.unloaded or not nothing_given(one.solved)]
        if loaded:
            found[kind.key] = kind.draw(loaded)
        elif suited:
            found[kind.key] = empty(said("no load is given yet: give a speed and a load"))
        else:
            found[kind.key] = empty(said("not of such a bearing") if shown else _why_not(there))
    return found


def _kinds_of(solved: Solved) -> frozenset[str]:
    rollers = are_rollers(solved)
    kinds = {"ball": not rollers.all(), "roller": rollers.any(), "set": len(solved.rows) > 1}
    return frozenset(name for name, own in kinds.items() if own)


def _why_not(cases: Cases) -> str:
    """Say why cases have no result; what to do stands with their status."""
    texts = [one.named(no_result(str(one.solved.status.code[0]))) for one in cases]
    return "\n".join(texts) or no_result()


# --- over azimuth ---------------------------------------------------------------------------------


def _loads(cases: Cases) -> Picture:
    quantity, unit = contact_quantity("load"), load_unit([one.solved for one in cases])
    return _over_azimuth(
        cases, lambda one, race: quantity.of(one.solved, race), quantity.name, unit, zero=True
    )


def _angles(cases: Cases) -> Picture:
    quantity = contact_quantity("contact_angle")
    free = []
    for one in cases:
        angle = free_angle(one.solved)
        if angle is not None:
            name = one.named(said("free (unloaded)"))
            free.append(_across(name, float(DEGREE.of(angle)), DEGREE, one.place))
    return _over_azimuth(
        cases, lambda one, race: quantity.of(one.solved, race), quantity.name, DEGREE, beside=free
    )


def _pressures(cases: Cases) -> Picture:
    quantity = contact_quantity("max_pressure")
    found = [quantity.of(one.solved, race) for one in cases for race in RACES]
    greatest, limits = _greatest(found), []
    kinds = [(one.solved.case, kind) for one in cases for kind in _kinds_of(one.solved)]
    known = {pressure_limit(case) if kind == "ball" else PRESSURE_LIMIT for case, kind in kinds}
    for limit in sorted(known):
        if greatest > _NEAR * limit:
            name = said("limit {limit:.4 MPa}", limit=limit)
            limits.append(_across(name, float(MEGAPASCAL.of(limit)), MEGAPASCAL, color="bad"))
    return _over_azimuth(
        cases, lambda one, race: quantity.of(one.solved, race), quantity.name, MEGAPASCAL,
        zero=True, beside=limits,
    )  # fmt: skip


def _thickness(cases: Cases) -> Picture:
    known = [one for one in cases if one.analysis.film is not None]
    if not known:
        return empty(_no_film(cases))

    def central(one: Analysis, race: Race) -> Floats:
        return np.asarray(_film_of(one).of(race).central_thickness[0])

    found = [central(one.analysis, race) for one in known for race in RACES]
    if not _greatest(found) > 0.0:
        return empty(said("nothing rotates: no film"))
    unit = readable_unit("m", np.concatenate(found))
    return _over_azimuth(
        known, central, capitalised(said("central film h_c")), unit, zero=True, least=True
    )


def _film_parameter(cases: Cases) -> Picture:
    known = [one for one in cases if one.analysis.film is not None]
    if not known:
        return empty(_no_film(cases))

    def parameter(one: Analysis, race: Race) -> Floats:
        return np.asarray(_film_of(one).of(race).film_parameter[0])

    found = [parameter(one.analysis, race) for one in known for race in RACES]
    if not isfinite(_greatest(found)):
        return empty(said("λ needs the roughness of the surfaces."))
    drawn = _over_azimuth(
        known, parameter, capitalised(said("film parameter λ")), NONE, zero=True, least=True
    )
    top = float(drawn["layout"]["yaxis"]["range"][1])
    above = inf
    bands, names = [], []
    for regime in regimes():
        low, high = max(regime.above, 0.0), min(above, top)
        above = regime.above
        if low >= high:
            continue
        color = f"{_BANDS[regime.name]}-band"
        bands.append(
            {"type": "rect", "xref": "paper", "x0": 0, "x1": 1, "y0": low, "y1": high,
             "layer": "below", "line": {"width": 0}, "fillcolor": color}
        )  # fmt: skip
        if high - low > 0.07 * top:
            names.append(
                {"text": regime_name(regime.name), "xref": "paper", "x": 1, "xanchor": "right",
                 "y": high, "yanchor": "top", "showarrow": False}
            )  # fmt: skip
    drawn["layout"] |= {"shapes": bands, "annotations": names}
    return drawn


_BANDS: Final = {"full_film": "good", "partial": "fair", "boundary": "bad", "adhesive": "bad"}


def _film_of(one: Analysis) -> Film:
    assert one.film is not None
    return one.film


def _no_film(cases: Cases) -> str:
    """Say why cases have no film: as their notes do, or that nothing lubricates."""
    return _notes_of(cases, "no_temperature") or said("The film needs an oil or a grease.")


def _notes_of(cases: Cases, *keys: str) -> str:
    """Say what notes of some keys say of the cases, a line each; empty without such."""
    told = [
        one.named(note.text) for one in cases for note in one.analysis.notes if note.key in keys
    ]
    return "\n".join(told)


def _across(
    name: str, height: float, unit: ReadableUnit, place: int = 0, color: str = "grey"
) -> dict[str, Any]:
    """Return a line at one height."""
    dash = "dot" if place else "longdash"
    ends = [-_MARGIN, _TURN + _MARGIN]
    hover = f"%{{y:{NUMBER}}} {unit.symbol}"
    own = {"color": color, "dash": dash, "width": 1.5}
    return line(ends, [height, height], name, hover, line=own)


def _over_azimuth(
    cases: Cases,
    of: Of,
    name: str,
    unit: ReadableUnit,
    *,
    zero: bool = False,
    least: bool = False,
    beside: Sequence[dict[str, Any]] = (),
) -> Picture:
    """Draw a number of every contact over azimuth, and lines beside; least: that matters most."""
    races, rows = _chosen(cases, of)
    drawn: list[dict[str, Any]] = []
    hover = f"%{{x:{NUMBER}}}°, %{{y:{NUMBER}}} {unit.symbol}".replace(f" {NONE.symbol}", "")
    for one in cases:
        by_row = rows_in_order(one.solved)
        for row in rows[one.place]:
            azimuth = np.mod(DEGREE.of(one.solved.elements.azimuth[0, by_row[row]]), _TURN)
            for race in races:
                values = unit.of(of(one.analysis, race)[by_row[row]])
                drawn.append(
                    line(
                        *_all_round(azimuth, values),
                        one.named(race_name(race, row, len(by_row))),
                        hover,
                        **{
                            **look(race, one.place, row, len(values)),
                            "mode": "lines+markers",
                            "meta": {"from": 1, "to": -1},
                        },
                    )
                )
    heights = [np.array(one["y"], dtype=np.float64) for one in (*drawn, *beside)]
    elements = [own for one in cases for own in one.solved.rows.element]
    title = name if unit is NONE else unit.label(name)
    return picture(
        [*drawn, *beside],
        _tell_extreme(cases, of, name, unit, least=least),
        xaxis=axis(
            DEGREE.label(azimuth_name(elements)), (-_MARGIN, _TURN + _MARGIN), tick0=0, dtick=45
        ),
        yaxis=axis(title, reach(*heights, zero=zero, least=1.0 if unit is DEGREE else 0.0)),
    )


def _chosen(cases: Cases, of: Of) -> tuple[Sequence[Race], dict[int, list[int]]]:
    """Races and rows to draw, most loaded row first: no more lines than can be distinguished."""
    rows = {one.place: list(range(len(one.solved.rows))) for one in cases}
    count = sum(map(len, rows.values()))
    races: Sequence[Race] = RACES if count * len(RACES) <= _MOST_LINES else ("inner",)
    if count * len(races) <= _MOST_LINES:
        return races, rows
    for one in cases:
        values, own = of(one.analysis, "inner"), one.solved.elements.row
        order = sorted(rows[one.place], key=lambda row: -_greatest([values[own == row]]))
        rows[one.place] = sorted(order[: _MOST_LINES // len(cases)])
    return races, rows


def _greatest(arrays: Iterable[Floats]) -> float:
    """Return the greatest number; NaN where there is none."""
    found = np.concatenate([np.ravel(one) for one in arrays])
    found = found[np.isfinite(found)]
    return float(found.max()) if found.size else float("nan")


def _tell_extreme(
    cases: Cases, of: Of, name: str, unit: ReadableUnit, *, least: bool = False
) -> str:
    """Say which contact of each race has the greatest value, or the least, and where it is."""
    told = []
    for one in cases:
        for race in RACES:
            values = of(one.analysis, race)
            if np.isfinite(values).any():
                place = int(np.nanargmin(values) if least else np.nanargmax(values))
                told.append(
                    said(
                        "{name} {value} at {azimuth:.4 °}",
                        name=one.named(race_word(race)),
                        value=_with_unit(float(unit.of(values[place])), unit),
                        azimuth=float(np.mod(one.solved.elements.azimuth[0, place], 2.0 * np.pi)),
                    )
                )
    return _listed(name, told, least=least)


def _listed(name: str, told: Sequence[str], *, least: bool = False) -> str:
    if least:
        return said("{name}, least: {values}.", name=name, values="; ".join(told))
    return said("{name}, greatest: {values}.", name=name, values="; ".join(told))


def _with_unit(value: float, unit: ReadableUnit) -> str:
    if unit is NONE:
        return number(value)
    return f"{number(value)}{'' if unit is DEGREE else ' '}{unit.symbol}"


def _all_round(azimuth: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Put elements in order; the last one before the first, the first one after the last."""
    order = np.argsort(azimuth, kind="stable")
    around, own = azimuth[order], values[order]
    ends = around[-1] - _TURN, around[0] + _TURN
    return np.r_[ends[0], around, ends[1]], np.r_[own[-1], own, own[0]]


def _rosette(cases: Cases) -> Picture:
    quantity, unit = contact_quantity("load"), load_unit([one.solved for one in cases])

    def load(one: Analysis, race: Race) -> Floats:
        return quantity.of(one.solved, race)

    races, rows = _chosen(cases, load)
    drawn, greatest = [], 0.0
    for one in cases:
        by_row = rows_in_order(one.solved)
        for row in rows[one.place]:
            around = np.append(by_row[row], by_row[row][0])
            for race in races:
                values = unit.of(load(one.analysis, race)[around])
                greatest = max(greatest, float(values.max()))
                drawn.append(
                    {
                        "type": "scatterpolar",
                        "mode": "lines+markers",
                        "theta": numbers(DEGREE.of(one.solved.elements.azimuth[0, around])),
                        "r": numbers(values),
                        "name": one.named(race_name(race, row, len(by_row))),
                        "hovertemplate": f"%{{theta:{NUMBER}}}°, %{{r:{NUMBER}}} {unit.symbol}"
                        "<extra>%{fullData.name}</extra>",
                        "meta": {"to": -1},
                        **look(race, one.place, row, len(values)),
                    }
                )
    ring = said("Contact load ({unit}), seen from +x", unit=unit.symbol)
    names = [text.replace("\n", "<br>") for text in AROUND]
    rim = rounded_up(greatest)
    return picture(
        drawn,
        _tell_extreme(cases, load, ring, unit),
        polar={
            "angularaxis": {
                "rotation": 90, "direction": "clockwise", "tickmode": "array",
                "tickvals": [45 * place for place in range(len(names))], "ticktext": names,
            },
            "radialaxis": axis(
                ring, (0.0, rim), angle=90.0 - _emptiest(drawn, rim), tickangle=0, nticks=5
            ),
        },
    )  # fmt: skip


def _emptiest(drawn: Sequence[dict[str, Any]], rim: float) -> float:
    """Return the azimuth (°) for the numbers of the circles: where little is borne."""
    borne = {}
    for direction in _DIRECTIONS:
        loads = [
            load
            for one in drawn
            for angle, load in zip(one["theta"], one["r"], strict=True)
            if abs((angle - direction + 180.0) % _TURN - 180.0) < 45.0
        ]
        borne[direction] = max(loads, default=0.0)
        if borne[direction] < _LITTLE * rim:
            break  # as before, while a slider moves
    return min(borne, key=lambda direction: borne[direction])


def _rows(cases: Cases) -> Picture:
    """Draw the loads of the rows side by side, all to one scale."""
    quantity, unit = contact_quantity("load"), load_unit([one.solved for one in cases])
    count = min(max(len(one.solved.rows) for one in cases), _MOST_ROWS)
    drawn: list[dict[str, Any]] = []
    frames: dict[str, Any] = {}
    hover = f"%{{x:{NUMBER}}}°, %{{y:{NUMBER}}} {unit.symbol}"
    for row in range(count):
        number_of = "" if row == 0 else str(row + 1)
        for one in cases:
            by_row = rows_in_order(one.solved)
            if row >= len(by_row):
                continue
            azimuth = np.mod(DEGREE.of(one.solved.elements.azimuth[0, by_row[row]]), _TURN)
            for race in RACES:
                values = unit.of(quantity.of(one.solved, race)[by_row[row]])
                drawn.append(
                    line(
                        *_all_round(azimuth, values),
                        one.named(race_name(race, row, count)),
                        hover,
                        xaxis=f"x{number_of}",
                        **{
                            **look(race, one.place, row, len(values)),
                            "mode": "lines+markers",
                            "meta": {"from": 1, "to": -1},
                        },
                    )
                )
        left = row / count
        frames[f"xaxis{number_of}"] = axis(
            said("row {number}", number=row), (0.0, _TURN),
            tickmode="array", tickvals=[0, 90, 180, 270] if count <= 3 else [0, 180],
            domain=[left, left + 0.94 / count],
        )  # fmt: skip
    heights = [np.array(one["y"], dtype=np.float64) for one in drawn]
    frames["yaxis"] = axis(unit.label(quantity.name), reach(*heights, zero=True))
    told = _tell_extreme(
        cases, lambda one, race: quantity.of(one.solved, race), quantity.name, unit
    )
    return picture(drawn, told, **frames)


# --- ellipses ----------------------------------------------------------------------------------

_CORNERS: Final = np.linspace(0.0, 2.0 * np.pi, 25)
_FINE: Final = 4
"""Decimals of an outline in mm."""


def _ellipses(cases: Cases) -> Picture:
    """Draw the ellipses where they lie across both grooves, to scale; the balls side by side."""
    cases = [one for one in cases if not are_rollers(one.solved).any()]
    if not cases:
        return empty(said("is for ball bearings: rollers touch along lines"))
    found = {
        (one.place, race): [slot for slot in slots_of(one.solved, race) if slot.touches]
        for one in cases
        for race in RACES
    }
    every = [slot for own in found.values() for slot in own]
    if not every:
        return empty(said("no ball is loaded"))
    widest = max(slot.semi_minor for slot in every)
    rows = max(len(one.solved.rows) for one in cases)
    low, high = reach(extent(every))
    per_row = max(ceil(len(one.solved.elements.row) / len(one.solved.rows)) for one in cases)
    step = rounded_up(max(3.0 * widest, 3.0 * (high - low) / (per_row * rows)))
    wide = step * per_row
    drawn: list[dict[str, Any]] = []
    frames: dict[str, Any] = {}
    over: list[str] = []
    for place, race in enumerate(RACES):
        upright = "y" if place == 0 else "y2"
        for one in cases:
            own = found[one.place, race][:_MOST_ELLIPSES]
            over += _draw_ellipses(drawn, one, race, own, wide, upright)
        bottom = line([-step, wide * rows], [0.0, 0.0], said("bottom of the groove"), "0 mm")
        drawn.append({**bottom, "yaxis": upright, "line": {"color": "grey", "dash": "dashdot",
                                                           "width": 1}})  # fmt: skip
        frames["yaxis" if place == 0 else "yaxis2"] = axis(
            MILLIMETRE.label(capitalised(race_word(race))), (low, high),
            scaleanchor="x", constrain="domain", domain=[0.54, 1.0] if place == 0 else [0.0, 0.46],
        )  # fmt: skip
    ticks = np.arange(0.0, 1.0, 0.125 if rows == 1 else 0.25)
    frames["xaxis"] = axis(
        DEGREE.label(azimuth_name(["ball"])),
        (-step, wide * rows),
        tickmode="array",
        tickvals=[wide * (row + tick) for row in range(rows) for tick in ticks],
        ticktext=[_tick(tick, row, rows) for row in range(rows) for tick in ticks],
        anchor="y2",
        constrain="domain",
    )
    scale = said("To scale across the groove and along it; the balls stand side by side.")
    return picture(drawn, f"{_over_text(over, every)} {scale}", meta=_DRAWING, **frames)


def _tick(turn: float, row: int, rows: int) -> str:
    """Write an azimuth below the ellipses; at the first of each row its number."""
    angle = number(_TURN * turn)
    return f"{angle}<br>{said('row {number}', number=row)}" if rows > 1 and not turn else angle


def _over_text(over: Sequence[str], slots: Sequence[Slot]) -> str:
    if over:
        return said(
            "Ellipses that run over the edge of the groove: {balls}.", balls="; ".join(over)
        )
    if all(slot.shoulder for slot in slots):
        return said("No ellipse runs over the edge of its groove.")
    return said("Without shoulder heights the edges of the grooves are not known.")


def _draw_ellipses(
    drawn: list[dict[str, Any]],
    one: _Shown,
    race: Race,
    slots: Sequence[Slot],
    wide: float,
    upright: str,
) -> list[str]:
    """Draw the ellipses of a race and the edges of its groove; name those that run over them."""
    style = look(race, one.place)["line"]
    for over, name in ((False, said("contact ellipse")), (True, said("ellipse over the edge"))):
        own = [slot for slot in slots if slot.over_edge is over]
        x, y = [], []
        for slot in own:
            along = wide * (slot.row + float(np.mod(slot.azimuth, 2.0 * np.pi)) / (2.0 * np.pi))
            x.append(np.r_[along + slot.semi_minor * np.cos(_CORNERS), np.nan])
            y.append(np.r_[slot.across + slot.semi_major * np.sin(_CORNERS), np.nan])
        color = "bad" if over else style["color"]
        if own:
            told = line(
                np.round(np.concatenate(x), _FINE), np.round(np.concatenate(y), _FINE),
                one.named(said("{race}: {what}", race=race_word(race), what=name)),
                f"%{{y:{NUMBER}}} mm",
                yaxis=upright, line={**style, "color": color, "width": 1.2},
            )  # fmt: skip
            fill = {} if one.place else {"fill": "toself", "fillcolor": f"{color}-band"}
            drawn.append({**told, **fill})
    edges_x: list[float] = []
    edges_y: list[float] = []
    for row in sorted({slot.row for slot in slots if slot.shoulder}):
        edge = next(slot.edge for slot in slots if slot.row == row)
        for side in (-edge, edge):
            edges_x += [wide * (row - 0.03), wide * (row + 0.97), np.nan]
            edges_y += [side, side, np.nan]
    if edges_x:
        dash = {"color": "ink", "width": 1.5, "dash": "dot" if one.place else "solid"}
        name = one.named(said("edge of the groove"))
        drawn.append(line(edges_x, edges_y, name, f"%{{y:{NUMBER}}} mm", yaxis=upright, line=dash))
    return [
        one.named(
            said("{race} at {azimuth:.4 °}", race=race_word(race),
                 azimuth=float(np.mod(slot.azimuth, 2.0 * np.pi)))
        )
        for slot in slots
        if slot.over_edge
    ]  # fmt: skip


# --- rollers -----------------------------------------------------------------------------------


def _along_roller(cases: Cases) -> Picture:
    drawn: list[dict[str, Any]] = []
    told = []
    ends = 0.0
    for one in cases:
        rollers, roller = one.solved.rollers, chosen_roller_of(one.solved)
        if rollers is None or roller is None:
            continue
        name = roller_label(one.solved, roller)
        ends = max(ends, 0.5e3 * float(np.nanmax(one.solved.rows.effective_length[0])))
        for race in RACES:
            pressure = pressure_along(rollers, race)[roller]
            drawn.append(
                line(
                    MILLIMETRE.of(rollers.slice_place[0, roller]), pressure,
                    one.named(race_word(race)), f"%{{x:{NUMBER}}} mm, %{{y:{NUMBER}}} MPa",
                    line=look(race, one.place)["line"],
                )
            )  # fmt: skip
            told.append(
                said("{name} {value}", name=one.named(race_word(race)),
                     value=_with_unit(float(np.nanmax(pressure)), MEGAPASCAL))
            )  # fmt: skip
        told[-1] = said("{values} ({roller})", values=told[-1], roller=name)
    if not drawn:
        return empty(said("no roller is loaded"))
    heights = [np.array(one["y"], dtype=np.float64) for one in drawn]
    if _greatest(heights) > _NEAR * float(MEGAPASCAL.of(PRESSURE_LIMIT)):
        name = said("limit {limit:.4 MPa}", limit=PRESSURE_LIMIT)
        limit = _across(name, float(MEGAPASCAL.of(PRESSURE_LIMIT)), MEGAPASCAL, color="bad")
        drawn.append({**limit, "x": [-1.08 * ends, 1.08 * ends]})
        heights.append(MEGAPASCAL.of([PRESSURE_LIMIT]))
    name = said("Maximum contact pressure")
    return picture(
        drawn,
        _listed(name, told),
        xaxis=axis(MILLIMETRE.label(place_name(cases[0].solved)), (-1.08 * ends, 1.08 * ends)),
        yaxis=axis(MEGAPASCAL.label(name), reach(*heights, zero=True)),
    )


def chosen_roller_of(solved: Solved) -> int | None:
    """Return the roller that presses most; None without rollers, or without load."""
    return None if solved.rollers is None else chosen_roller(solved, solved.rollers, None)


def _between_races(cases: Cases) -> Picture:
    """Draw the most loaded roller between its races; of two cases side by side."""
    chosen = [(one, chosen_roller_of(one.solved)) for one in cases]
    found = [(one, roller) for one, roller in chosen if roller is not None]
    if not found:
        return empty(said("no roller is loaded"))
    drawn: list[dict[str, Any]] = []
    frames: dict[str, Any] = {}
    told = []
    lying = [(one, roller, lying_roller(one.solved, roller)) for one, roller in found]
    half = rounded_up(max(max(lies.top, -lies.bottom) for _, _, lies in lying))
    for place, (one, roller, lies) in enumerate(lying):
        own = "x" if place == 0 else "x2"
        hover = f"%{{x:{NUMBER}}} mm, %{{y:{NUMBER}}} µm"
        name = one.named(tilted_name(roller_label(one.solved, roller), lies.tilt))
        told.append(name)
        outline_x = np.r_[lies.x, lies.x[::-1], lies.x[0]]
        outline_y = np.r_[lies.above, lies.below[::-1], lies.above[0]]
        outline = {"color": "ink", "width": 1.5}
        drawn.append(
            line(outline_x, outline_y, name, hover, xaxis=own, line=outline, fill="toself",
                 fillcolor="ink-band")
        )  # fmt: skip
        inner = tilted_name(said("inner race"), lies.ring_tilt)
        for race, surface, called in (
            ("outer", lies.race_above, said("outer race")),
            ("inner", lies.race_below, inner),
        ):
            width = {"color": race, "width": 2, "dash": "dash" if race == "outer" else "solid"}
            drawn.append(line(lies.x, surface, one.named(called), hover, xaxis=own, line=width))
        axis_line = {"color": "grey", "width": 1, "dash": "dashdot"}
        middle = one.named(said("axis of the roller"))
        drawn.append(line(lies.x, lies.axis, middle, hover, xaxis=own, line=axis_line))
        share = 1.0 / len(found)
        reaches = 1.08 * float(np.abs(lies.x).max())
        frames["xaxis" if place == 0 else "xaxis2"] = axis(
            MILLIMETRE.label(place_name(one.solved)), (-reaches, reaches),
            domain=[place * share, (place + 0.94 if len(found) > 1 else 1.0) * share],
        )  # fmt: skip
    frames["yaxis"] = axis(said("Radial height (µm)"), (-half, half))
    exaggerated = said("Heights are many times exaggerated; the roller's body is cut.")
    return picture(drawn, f"{'; '.join(told)}. {exaggerated}", meta=_DRAWING, **frames)


# --- friction, life, frequencies ------------------------------------------------------------------


def _friction(cases: Cases) -> Picture:
    """Draw what each source of friction takes; where nothing turns, its torque."""
    known = [(one, one.analysis.friction) for one in cases if one.analysis.friction is not None]
    if not known:
        why = _notes_of(cases, "no_temperature_no_friction")
        return empty(why or said("Friction needs a lubricant."))
    sources = list(dict.fromkeys(name for _, own in known for name in own.torque_by_source))
    torques = {
        one.place: [_first(own.torque_by_source.get(name)) for name in sources]
        for one, own in known
    }
    powers: dict[int, list[float]] = {}
    by_race: dict[Race, list[float]] = {}
    for one, own in known:
        losses = [own.heat.get(name) for name in sources]
        by_race = {
            race: [0.0 if loss is None else float(getattr(loss, race)[0].sum()) for loss in losses]
            for race in RACES
        }
        powers[one.place] = [inner + outer for inner, outer in zip(*by_race.values(), strict=True)]
    turns = any(sum(own) > 0.0 for own in powers.values())
    shown = powers if turns else torques
    readable = power_unit if turns else torque_unit
    unit = readable([value for own in shown.values() for value in own])
    torque = torque_unit([value for own in torques.values() for value in own])
    names = [capitalised(source_name(name)) for name in sources]
    drawn: list[dict[str, Any]] = []
    if len(known) == 1 and turns:
        for race, heat in by_race.items():
            name = said("heat, inner") if race == "inner" else said("heat, outer")
            drawn.append(_bars(names, heat, unit, name, race))
    else:
        for one, _ in known:
            color = "inner" if one.place == 0 else "inner2"
            drawn.append(_bars(names, shown[one.place], unit, one.name, color))
    told = [one.named(_friction_told(own, torque)) for one, own in known]
    title = said("Power loss") if turns else said("Friction torque")
    stacked = len(known) == 1
    most = max(max(own) for own in shown.values())
    return picture(
        drawn,
        said("Friction of all sources: {values}.", values="; ".join(told)),
        xaxis=axis(f"{title} ({unit})", (0.0, rounded_up(1.03 * float(in_unit(most, unit))))),
        yaxis=_categories(),
        barmode="stack" if stacked else "group",
    )


def _friction_told(friction: Friction, unit: str) -> str:
    """Say torque and power, and whether they are an upper bound."""
    power = float(friction.power[0])
    values = {
        "torque": _told(float(friction.torque[0]), unit),
        "power": _told(power, power_unit([power])),
    }
    if friction.upper_bound[0]:
        return said("torque at most {torque}, power at most {power}", **values)
    return said("torque {torque}, power {power}", **values)


def _first(values: Floats | None) -> float:
    return 0.0 if values is None else float(values[0])


def _told(value: float, unit: str) -> str:
    return f"{number(float(in_unit(value, unit)))} {unit}"


def _bars(
    names: Sequence[str], values: Sequence[float], unit: str, name: str, color: str
) -> dict[str, Any]:
    """Return bars that lie; values in SI."""
    return {
        "type": "bar",
        "orientation": "h",
        "x": numbers(in_unit(np.array(values), unit)),
        "y": list(names),
        "name": name,
        "hovertemplate": f"%{{y}}: %{{x:{NUMBER}}} {unit}<extra>%{{fullData.name}}</extra>",
        "marker": {"color": color},
    }


def _categories() -> dict[str, Any]:
    """Return the axis of bars that lie: the first at the top, their names within the picture."""
    return {"autorange": "reversed", "automargin": True, "ticksuffix": "  "}


def _life(cases: Cases) -> Picture:
    """Draw the life by every theory, faintly where it does not hold, and what is required."""
    known = [(one, one.analysis.life) for one in cases if one.analysis.life is not None]
    if not known:
        why = _notes_of(cases, "life_of_thrust_bearing", "life_without_rating")
        return empty(why or said("Life needs a designation or a [life] table."))
    turns = all(np.isfinite(own.headline.hours).any() or _endless(own) for _, own in known)
    theories = [name for name in BY_RANK if any(name in own.theories for _, own in known)]
    lives = {
        (one.place, name): own[name].hours[0] if turns and not np.isposinf(own[name].life[0])
        else own[name].life[0]
        for one, own in known
        for name in theories
        if name in own.theories
    }  # fmt: skip
    wanted = [
        (one, own.conditions.required_life / HOUR)
        for one, own in known
        if turns and own.conditions.required_life is not None
    ]
    limits = _limits_of_lives(lives, [hours for _, hours in wanted])
    if limits is None:
        endless = any(np.isposinf(life) for life in lives.values())
        return empty(said("fatigue ends no life here") if endless else no_result())
    symbol = "h" if turns else "10⁶ rev"
    names = {name: theory_label(name) for name in theories}
    drawn: list[dict[str, Any]] = []
    for one, own in known:
        of = [name for name in theories if isfinite(lives.get((one.place, name), np.nan))
              or np.isposinf(lives.get((one.place, name), np.nan))]  # fmt: skip
        values = [float(lives[one.place, name]) for name in of]
        holds = [bool(own[name].valid[0]) for name in of]
        texts = [
            _life_text(value, below=bool(own[name].below[0]))
            for name, value in zip(of, values, strict=True)
        ]
        color = "inner" if one.place == 0 else "inner2"
        drawn.append(
            {
                "type": "bar",
                "orientation": "h",
                # what never ends fills the frame; its text says so
                "x": [10.0 ** limits[1] if np.isposinf(value) else value for value in values],
                "y": [names[name] for name in of],
                "text": texts,
                "textposition": "auto",
                "insidetextanchor": "start",
                "textangle": 0,
                "name": one.name or said("life"),
                "hovertemplate": f"%{{y}}: %{{text}} {symbol}<extra>%{{fullData.name}}</extra>",
                "marker": {
                    "color": color,
                    "opacity": [1.0 if fine else FAINT for fine in holds],
                },
            }
        )
    told_of = list(dict.fromkeys(name for own in drawn for name in own["y"]))
    for one, hours in wanted:
        name = one.named(said("required life"))
        drawn.append(_upright(hours, told_of, name, "h", one.place))
    told = [one.named(text) for one, own in known for text in limiting_sentences(one.solved, own)]
    if any(FAINT in own["marker"]["opacity"] for own in drawn if "marker" in own):
        told.append(said("Faint: the theory is not valid for this case."))
    return picture(
        drawn,
        " ".join(told),
        xaxis=axis(said("Life (h)") if turns else said("Life (10⁶ rev)"), limits, type="log",
                   dtick=1),
        yaxis=_categories(),
        barmode="group",
    )  # fmt: skip


def _life_text(value: float, *, below: bool) -> str:
    if np.isposinf(value):
        return ENDLESS
    text = manner().significant(value, 4)
    return said("< {life}", life=text) if below else text


def _limits_of_lives(
    lives: Mapping[tuple[int, str], Any], wanted: Sequence[float]
) -> list[float] | None:
    """Return the logarithms of the ends of an axis of lives; bounds far above do not lead it."""
    near = [life for (_, theory), life in lives.items() if not THEORIES[theory].bound]
    limits = decades(near, wanted)
    if limits is None:
        return decades(list(lives.values()))
    return [limits[0] - 0.5, limits[1] + 0.5]


def _endless(summary: LifeSummary) -> bool:
    return bool(np.isposinf(summary.headline.life).any())


def _upright(
    at: float, categories: Sequence[str], name: str, unit: str, place: int
) -> dict[str, Any]:
    """Return a line across the bars, or the rows of marks."""
    drawn = {"color": "ink", "width": 1.5, "dash": "dot" if place else "dash"}
    ends = [categories[0], categories[-1]]
    return {**line([at, at], [], name, f"%{{x:{NUMBER}}} {unit}", line=drawn), "y": ends}


def _frequencies(cases: Cases) -> Picture:
    """Draw where each fault shows: its frequency and the multiples of it, a line a fault."""
    found = [(one, one.analysis.frequencies) for one in cases]
    known = [(one, own) for one, own in found if own is not None]
    if not known:
        return empty(said("nothing rotates: no frequencies"))
    drawn: list[dict[str, Any]] = []
    rows: dict[str, None] = {}
    told = []
    for one, own in known:
        x, y, text = [], [], []
        for kind, name in FAULTS.items():
            label = f"{ABBREVIATIONS[name]}, {line_name(name, own.element)}"
            rows[label] = None
            told.append(
                one.named(f"{ABBREVIATIONS[name]} {number(own.of_fault(kind).frequency)} Hz")
            )
            for harmonic in own.harmonics(kind, _HARMONICS, 0):
                x.append(harmonic.frequency)
                y.append(label)
                text.append(f"{harmonic.harmonic} × {ABBREVIATIONS[name]}")
        color = "inner" if one.place == 0 else "inner2"
        drawn.append(
            {
                "type": "scatter",
                "mode": "markers",
                "x": numbers(x),
                "y": y,
                "text": text,
                "name": one.name or said("fault frequencies"),
                "hovertemplate": "%{text}: %{x:,.5~r} Hz<extra>%{fullData.name}</extra>",
                "marker": {
                    "color": color,
                    "symbol": "line-ns-open" if one.place == 0 else "diamond-open",
                    "size": 18 if one.place == 0 else 9,
                    "line": {"width": 3 if one.place == 0 else 2, "color": color},
                },
            }
        )
    greatest = max(value for own in drawn for value in own["x"])
    shafts = {round(own.shaft_frequency, 9) for _, own in known}
    for one, own in known[: len(shafts)]:  # one line where both turn alike
        shaft = one.named(said("shaft")) if len(shafts) > 1 else said("shaft")
        drawn.append(_upright(own.shaft_frequency, list(rows), shaft, "Hz", one.place))
    return picture(
        drawn,
        said("Under load: {values}. Marks: the first {count} harmonics.",
             values="; ".join(told), count=_HARMONICS),
        xaxis=axis(said("Frequency (Hz)"), (0.0, rounded_up(1.03 * greatest))),
        yaxis={**_categories(), "categoryorder": "array", "categoryarray": list(rows)},
    )  # fmt: skip


# --- heat -----------------------------------------------------------------------------------------

_PLACES: Final = {
    "shaft": 5.0, "inner_ring": 4.0, "elements": 3.0, "outer_ring": 2.0, "housing": 1.0,
}  # fmt: skip
"""Heights of the nodes: from the shaft down to the housing."""
_WIDEST: Final = 14.0
"""px of the greatest heat flow."""


def _heat(cases: Cases) -> Picture:
    """Draw the network with its heat flows; of two cases the temperatures beside each other."""
    found = [(one, balance_of(_given_case(one.solved))) for one in cases]
    known = [(one, own) for one, own in found if own is not None]
    if not known:
        return empty(said("The heat balance needs a lubricant and the sizes of the bearing."))
    states = [(one, own) for one, own in known if own.root is not None]
    if not states:
        return empty("\n".join(one.named(no_result(own.status)) for one, own in known))
    if len(states) > 1:
        return _temperatures_beside(states)
    return _network(*states[0])


def _given_case(solved: Solved) -> Case:
    """The case as it was given, before its mounting."""
    return solved.case if solved.before_mounting is None else solved.before_mounting.case


def _heat_told(one: _Shown, found: HeatBalance) -> str:
    values = {
        "power": _told(found.power, "W"),
        "temperature": number(max(found.temperatures.values()) - ZERO_CELSIUS),
    }
    return one.named(said("{power} of friction, {temperature} °C at most", **values))


def _network(one: _Shown, found: HeatBalance) -> Picture:
    at = found.temperatures
    ends = {name: (0.0, y) for name, y in _PLACES.items()}
    most = max(abs(flow.power) for flow in found.flows) or 1.0
    drawn: list[dict[str, Any]] = []
    labels: tuple[list[float], list[float], list[str], list[str]] = ([], [], [], [])
    for flow in found.flows:
        if not flow.power:
            continue
        first, last = _ends(flow.start, flow.end, ends)
        forth = flow.power > 0.0
        text = f"{number(abs(flow.power))} W"
        names = [said(PLACE_NAMES[name]) for name in (flow.start, flow.end)]
        told = " → ".join(names if forth else names[::-1])
        drawn.append(
            line(
                [first[0], last[0]], [first[1], last[1]], "", f"{told}: {text}",
                line={"color": "outer" if flow.start in ("friction", "outside") else "grey",
                      "width": max(1.0, _WIDEST * abs(flow.power) / most)},
                opacity=0.5,
            )
        )  # fmt: skip
        labels[0].append(0.5 * (first[0] + last[0]))
        labels[1].append(0.5 * (first[1] + last[1]))
        labels[2].append(f"{text} {_arrow(first, last, forth)}")
        labels[3].append("middle left" if first[0] == last[0] else "top center")
    drawn.append(
        {
            "type": "scatter", "mode": "text", "x": labels[0], "y": labels[1], "text": labels[2],
            "textposition": labels[3], "hoverinfo": "skip",
        }
    )  # fmt: skip
    names = [
        f"{said(PLACE_NAMES[name])}<br>{number(at[name] - ZERO_CELSIUS)} °C" for name in _PLACES
    ]
    drawn.append(
        {
            "type": "scatter", "mode": "markers+text", "x": [0.0] * len(names),
            "y": list(_PLACES.values()), "text": names, "textposition": "middle right",
            "marker": {"color": "inner", "size": 16}, "hoverinfo": "text",
        }
    )  # fmt: skip
    hidden = {"visible": False, "fixedrange": True}
    return picture(
        drawn,
        said("Heat balance: {values}.", values=_heat_told(one, found)),
        meta=_DRAWING,
        xaxis=axis("", (-2.3, 2.3), **hidden),
        yaxis=axis("", (-0.4, 6.4), **hidden),
    )


def _ends(
    start: str, end: str, nodes: Mapping[str, tuple[float, float]]
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Where a heat flow begins and ends: to the surroundings above and below, from aside else."""
    if start in ("friction", "outside"):
        x, y = nodes[end]
        return (x - 1.8, y), (x, y)
    x, y = nodes[start]
    if end == "oil":
        return (x, y), (x - 1.8, y)
    if end == "ambient":
        return (x, y), (x, y + 1.0 if start == "shaft" else y - 1.0)
    return (x, y), nodes[end]


def _arrow(first: tuple[float, float], last: tuple[float, float], forth: bool) -> str:
    over, up = last[0] - first[0], last[1] - first[1]
    if not forth:
        over, up = -over, -up
    if over:
        return "→" if over > 0.0 else "←"
    return "↑" if up > 0.0 else "↓"


def _temperatures_beside(states: Sequence[tuple[_Shown, HeatBalance]]) -> Picture:
    names = [capitalised(said(PLACE_NAMES[name])) for name in _PLACES]
    drawn = []
    for one, found in states:
        warm = [found.temperatures[name] - ZERO_CELSIUS for name in _PLACES]
        color = "inner" if one.place == 0 else "inner2"
        drawn.append(
            {
                "type": "bar", "orientation": "h", "x": numbers(warm), "y": names,
                "name": one.name, "marker": {"color": color},
                "hovertemplate": f"%{{y}}: %{{x:{NUMBER}}} °C<extra>%{{fullData.name}}</extra>",
            }
        )  # fmt: skip
    most = max(max(found.temperatures.values()) for _, found in states) - ZERO_CELSIUS
    told = "; ".join(_heat_told(one, found) for one, found in states)
    return picture(
        drawn,
        said("Heat balance: {values}.", values=told),
        xaxis=axis(said("Temperature (°C)"), (0.0, rounded_up(1.03 * most))),
        yaxis=_categories(),
        barmode="group",
    )


PICTURES: Final[Mapping[str, PictureKind]] = {
    own.key: own
    for own in (
        PictureKind("rosette", marked("Load rosette"), _ALL, _rosette, opened=True),
        PictureKind("loads", marked("Contact loads"), _ALL, _loads, opened=True),
        PictureKind("rows", marked("Loads row by row"), _SETS, _rows, opened=True),
        PictureKind("angles", marked("Contact angles"), _BALLS, _angles, opened=True),
        PictureKind("ellipses", marked("Contact ellipses"), _BALLS, _ellipses, opened=True),
        PictureKind("pressures", marked("Contact pressures"), _ALL, _pressures, opened=True),
        PictureKind(
            "along_roller", marked("Pressure along the roller"), _ROLLERS, _along_roller,
            opened=True,
        ),
        PictureKind("between_races", marked("Roller between the races"), _ROLLERS, _between_races),
        PictureKind("film_thickness", marked("Film thickness"), _ALL, _thickness),
        PictureKind(
            "film_parameter", marked("Lubrication regime"), _ALL, _film_parameter, opened=True
        ),
        PictureKind("friction", marked("Friction by source"), _ALL, _friction, opened=True),
        PictureKind("heat", marked("Heat flows"), _ALL, _heat, unloaded=True),
        PictureKind("life", marked("Life by theory"), _ALL, _life, opened=True),
        PictureKind(
            "frequencies", marked("Fault frequencies"), _ALL, _frequencies, unloaded=True
        ),
    )
}  # fmt: skip
"""All pictures, in the order in which the page shows them."""
