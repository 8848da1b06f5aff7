"""The app's pictures: what solved cases show, one or two over one another, for Plotly.js.

Each is read from the records and shown in the units that people read; none computes anything.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from math import ceil, inf, isfinite
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.analysis import Analysis
from rolamento.case import Case
from rolamento.charts import (
    Axis,
    Bars,
    Chart,
    Labels,
    Line,
    Look,
    Mark,
    Zone,
    case_look,
    race_look,
)
from rolamento.charts.along_roller import chosen_roller, roller_label
from rolamento.charts.axes_units import DEGREE, MEGAPASCAL, NONE, readable_unit
from rolamento.charts.contact_charts import (
    contact_chart,
    greatest,
    limit_marks,
    listed,
    over_azimuth,
    rosette_chart,
    row_charts,
    with_unit,
)
from rolamento.charts.contacts import Shown, azimuth_name, race_word
from rolamento.charts.ellipse_charts import across_axis, ellipse_chart
from rolamento.charts.groove import Slot, extent, slots_of
from rolamento.charts.limits import decades, reach, rounded_up
from rolamento.charts.plotly import Picture, empty, picture
from rolamento.charts.record import Side
from rolamento.charts.roller_charts import along_chart, between_chart, pressure_line
from rolamento.charts.texts import capitalised, no_result, number, theory_label
from rolamento.friction import Friction
from rolamento.geometry import Race
from rolamento.heat import HeatBalance
from rolamento.life import LifeSummary
from rolamento.life.theories import BY_RANK, THEORIES
from rolamento.lubrication import Film
from rolamento.lubrication.regime import regimes
from rolamento.pages.film import regime_name
from rolamento.pages.frequencies import line_name
from rolamento.pages.friction import power_unit, source_name, torque_unit
from rolamento.pages.life import LONGEST_LIFE, hours_text, limiting_sentences
from rolamento.records import frozen
from rolamento.solved import RACES, Solved
from rolamento.solved.notes import nothing_given
from rolamento.tasks.heat import balance_of
from rolamento.units import HOUR, ZERO_CELSIUS
from rolamento.vibration.frequencies import ABBREVIATIONS, FAULTS
from rolamento.words import ENDLESS, in_unit, manner, marked, said
from rolamento.words.quantities import called
from rolamento.words.sentences.heat import PLACE_NAMES

__all__ = ["PICTURES", "PictureKind", "described", "figures"]

Floats = NDArray[np.float64]

_BALLS, _ROLLERS, _SETS = frozenset({"ball"}), frozenset({"roller"}), frozenset({"set"})
_ALL: Final = frozenset({"ball", "roller"})
_MOST_LINES: Final = 8
_MOST_ROWS: Final = 6
_MOST_ELLIPSES: Final = 120
_HARMONICS: Final = 5


@frozen(eq=False, kw_only=True)
class Analysed(Shown):
    """A case with all that follows from it."""

    analysis: Analysis


Cases = Sequence[Analysed]


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
        Analysed(names[place] if many else "", analysis.solved, place, analysis=analysis)
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
    rollers = solved.are_rollers
    kinds = {"ball": not rollers.all(), "roller": rollers.any(), "set": len(solved.rows) > 1}
    return frozenset(name for name, own in kinds.items() if own)


def _why_not(cases: Cases) -> str:
    """Say why cases have no result; what to do stands with their status."""
    texts = [one.named(no_result(str(one.solved.status.code[0]))) for one in cases]
    return "\n".join(texts) or no_result()


# --- over azimuth ---------------------------------------------------------------------------------


def _rosette(cases: Cases) -> Picture:
    return picture(rosette_chart(cases, most=_MOST_LINES))


def _loads(cases: Cases) -> Picture:
    return picture(contact_chart(cases, "load", most=_MOST_LINES))


def _angles(cases: Cases) -> Picture:
    return picture(contact_chart(cases, "contact_angle", most=_MOST_LINES))


def _pressures(cases: Cases) -> Picture:
    return picture(contact_chart(cases, "max_pressure", most=_MOST_LINES))


def _rows(cases: Cases) -> Picture:
    return picture(*row_charts(cases, _MOST_ROWS))


def _thickness(cases: Cases) -> Picture:
    known = [one for one in cases if one.analysis.film is not None]
    if not known:
        return empty(_no_film(cases))

    def central(one: Analysed, race: Race) -> Floats:
        return np.asarray(_film_of(one).of(race).central_thickness[0])

    found = [central(one, race) for one in known for race in RACES]
    if not greatest(found) > 0.0:
        return empty(said("nothing rotates: no film"))
    unit, name = readable_unit("m", np.concatenate(found)), capitalised(said("central film h_c"))
    return picture(
        over_azimuth(known, central, name, unit, zero=True, least=True, most=_MOST_LINES)
    )


def _film_parameter(cases: Cases) -> Picture:
    known = [one for one in cases if one.analysis.film is not None]
    if not known:
        return empty(_no_film(cases))

    def parameter(one: Analysed, race: Race) -> Floats:
        return np.asarray(_film_of(one).of(race).film_parameter[0])

    if not isfinite(greatest(parameter(one, race) for one in known for race in RACES)):
        return empty(said("λ needs the roughness of the surfaces."))
    name = capitalised(called("film_parameter"))
    chart = over_azimuth(known, parameter, name, NONE, zero=True, least=True, most=_MOST_LINES)
    ends = [inf, *(max(regime.above, 0.0) for regime in regimes())]
    zones = tuple(
        Zone(low, high, regime_name(regime.name), _BANDS[regime.name])
        for regime, high, low in zip(regimes(), ends[:-1], ends[1:], strict=True)
    )
    return picture(replace(chart, zones=zones))


_BANDS: Final = {"full_film": "good", "partial": "fair", "boundary": "bad", "adhesive": "bad"}


def _film_of(one: Analysed) -> Film:
    assert one.analysis.film is not None
    return one.analysis.film


def _no_film(cases: Cases) -> str:
    """Say why cases have no film: as their notes do, or that nothing lubricates."""
    return _notes_of(cases, "no_temperature") or said("The film needs an oil or a grease.")


def _notes_of(cases: Cases, *keys: str) -> str:
    """Say what notes of some keys say of the cases, a line each; empty without such."""
    told = [
        one.named(note.text) for one in cases for note in one.analysis.notes if note.key in keys
    ]
    return "\n".join(told)


# --- ellipses ----------------------------------------------------------------------------------


def _ellipses(cases: Cases) -> Picture:
    """Draw the ellipses where they lie across both grooves, to scale; the balls side by side."""
    cases = [one for one in cases if not one.solved.are_rollers.any()]
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
    rows = max(len(one.solved.rows) for one in cases)
    low, high = reach(extent(every))
    per_row = max(ceil(len(one.solved.elements.row) / len(one.solved.rows)) for one in cases)
    widest = max(slot.semi_minor for slot in every)
    step = rounded_up(max(3.0 * widest, 3.0 * (high - low) / (per_row * rows)))
    wide = step * per_row
    turns = np.arange(0.0, 1.0, 0.125 if rows == 1 else 0.25).tolist()
    ticks = tuple(
        (wide * (row + turn), _tick(turn, row, rows)) for row in range(rows) for turn in turns
    )
    along = Axis(azimuth_name(["ball"]), DEGREE.symbol, (-step, wide * rows), ticks=ticks)
    panels = [
        ellipse_chart(
            [(one, [replace(slot, along=_along(slot, wide))
                    for slot in found[one.place, race][:_MOST_ELLIPSES]]) for one in cases],
            race, across=across_axis(capitalised(race_word(race)), low, high), along=along,
            margin=0.5 * step, prefix=race_word(race),
        )
        for race in RACES
    ]  # fmt: skip
    over = [
        one.named(said("{race} at {azimuth:.4 °}", race=race_word(race),
                       azimuth=float(np.mod(slot.azimuth, 2.0 * np.pi))))
        for one in cases
        for race in RACES
        for slot in found[one.place, race]
        if slot.over_edge
    ]  # fmt: skip
    scale = said("To scale across the groove and along it; the balls stand side by side.")
    return picture(*panels, down=True, conclusion=f"{_over_text(over, every)} {scale}")


def _along(slot: Slot, wide: float) -> float:
    return wide * (slot.row + float(np.mod(slot.azimuth, 2.0 * np.pi)) / (2.0 * np.pi))


def _tick(turn: float, row: int, rows: int) -> str:
    """Write an azimuth below the ellipses; at the first of each row its number."""
    angle = number(360.0 * turn)
    return f"{angle}\n{said('row {number}', number=row)}" if rows > 1 and not turn else angle


def _over_text(over: Sequence[str], slots: Sequence[Slot]) -> str:
    if over:
        return said(
            "Ellipses that run over the edge of the groove: {balls}.", balls="; ".join(over)
        )
    if all(slot.shoulder for slot in slots):
        return said("No ellipse runs over the edge of its groove.")
    return said("Without shoulder heights the edges of the grooves are not known.")


# --- rollers -----------------------------------------------------------------------------------


def _chosen_rollers(cases: Cases) -> list[tuple[Analysed, int]]:
    """Return the roller of each case that presses most; of those that have one."""
    found = (
        (one, one.solved.rollers and chosen_roller(one.solved, one.solved.rollers, None))
        for one in cases
    )
    return [(one, roller) for one, roller in found if isinstance(roller, int)]


def _along_roller(cases: Cases) -> Picture:
    chosen = _chosen_rollers(cases)
    if not chosen:
        return empty(said("no roller is loaded"))
    lines: list[Line] = []
    told = []
    for one, roller in chosen:
        for race in RACES:
            name = one.named(race_word(race))
            line = pressure_line(one.solved, roller, race, name, race_look(race, one.place))
            lines.append(line)
            told.append(
                said("{name} {value}", name=name,
                     value=with_unit(float(np.nanmax(line.y)), MEGAPASCAL))
            )  # fmt: skip
        label = roller_label(one.solved, roller)
        told[-1] = said("{values} ({roller})", values=told[-1], roller=label)
    name = capitalised(called("max_pressure"))
    solved = [one.solved for one, _ in chosen]
    marks = limit_marks(solved, 1e6 * greatest(line.y for line in lines))
    return picture(along_chart(lines, solved, name, listed(name, told), marks))


def _between_races(cases: Cases) -> Picture:
    """Draw the most loaded roller between its races; of two cases side by side."""
    chosen = _chosen_rollers(cases)
    if not chosen:
        return empty(said("no roller is loaded"))
    charts = [between_chart(one, roller) for one, roller in chosen]
    half = rounded_up(max(abs(end) for chart in charts for end in chart.y.limits or ()))
    first = replace(charts[0], y=replace(charts[0].y, limits=(-half, half)))
    told = "; ".join(chart.says for chart in charts)
    exaggerated = said("Heights are many times exaggerated; the roller's body is cut.")
    return picture(first, *charts[1:], conclusion=f"{told}. {exaggerated}")


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
    bars = [(one.name, case_look(one.place), shown[one.place]) for one, _ in known]
    if len(known) == 1 and turns:
        words = {"inner": said("heat, inner"), "outer": said("heat, outer")}
        bars = [(words[race], race_look(race), heat) for race, heat in by_race.items()]
    told = [one.named(_friction_told(own, torque)) for one, own in known]
    title = capitalised(called("power")) if turns else capitalised(called("torque"))
    most = float(in_unit(max(max(own) for own in shown.values()), unit))
    places = tuple(range(len(names)))
    return picture(
        Chart(
            tuple(Bars(np.asarray(in_unit(np.array(own), unit)), places, name, look)
                  for name, look, own in bars),
            Axis(title, unit, (0.0, rounded_up(1.03 * most))),
            Axis(categories=tuple(names)),
            said("Friction of all sources: {values}.", values="; ".join(told)),
            stacked=len(known) == 1,
        )
    )  # fmt: skip


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
    some = {name for (_, name), life in lives.items() if not np.isnan(life)}
    theories = [name for name in theories if name in some]
    bars: list[Bars] = []
    for one, own in known:
        of = [name for name in theories if not np.isnan(lives.get((one.place, name), np.nan))]
        values = [float(lives[one.place, name]) for name in of]
        texts = (
            _life_text(value, below=bool(own[name].below[0]), in_hours=turns)
            for name, value in zip(of, values, strict=True)
        )
        places = tuple(theories.index(name) for name in of)
        valid = tuple(bool(own[name].valid[0]) for name in of)
        name, look = one.name or said("life"), case_look(one.place)
        bars.append(Bars(np.array(values), places, name, look, tuple(texts), valid))
    marks = [_upright(hours, one.named(said("required life")), one.place) for one, hours in wanted]
    told = [one.named(text) for one, own in known for text in limiting_sentences(one.solved, own)]
    if not all(all(own.valid) for own in bars):
        told.append(said("Faint: the theory is not valid for this case."))
    ends = 10.0 ** limits[0], 10.0 ** limits[1]
    across = Axis(unit="h", limits=ends, log=True, step=1.0, name=said("Life"))
    if not turns:
        across = replace(across, unit="10⁶ rev")
    names = tuple(theory_label(name) for name in theories)
    return picture(
        Chart(tuple(bars), across, Axis(categories=names), " ".join(told), marks=tuple(marks))
    )


def _life_text(value: float, *, below: bool, in_hours: bool) -> str:
    if np.isposinf(value):
        return ENDLESS
    text = hours_text(value) if in_hours else manner().significant(value, 4)
    long = in_hours and value > LONGEST_LIFE
    return said("< {life}", life=text) if below and not long else text


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


def _upright(at: float, name: str, place: int) -> Mark:
    """Return a line across the bars, or the rows of marks."""
    return Mark(at, name, Look("ink", "dot" if place else "dash", width=0.75), "x")


def _frequencies(cases: Cases) -> Picture:
    """Draw where each fault shows: its frequency and the multiples of it, a line a fault."""
    found = [(one, one.analysis.frequencies) for one in cases]
    known = [(one, own) for one, own in found if own is not None]
    if not known:
        return empty(said("nothing rotates: no frequencies"))
    found_labels = {
        (one.place, kind): f"{ABBREVIATIONS[name]}, {line_name(name, own.element)}"
        for one, own in known
        for kind, name in FAULTS.items()
    }
    rows = list(dict.fromkeys(found_labels.values()))
    series = []
    told = []
    for one, own in known:
        x, y, texts = [], [], []
        for kind, name in FAULTS.items():
            short = ABBREVIATIONS[name]
            told.append(one.named(f"{short} {number(own.of_fault(kind).frequency)} Hz"))
            for harmonic in own.harmonics(kind, _HARMONICS, 0):
                x.append(harmonic.frequency)
                y.append(rows.index(found_labels[one.place, kind]))
                texts.append(f"{harmonic.harmonic} × {short}")
        look = (
            Look("inner2", mark="diamond", hollow=True) if one.place else Look("inner", mark="tick")
        )
        called = one.name or said("fault frequencies")
        series.append(Line(np.array(x), np.array(y, dtype=np.float64), called, look, "points",
                           texts=tuple(texts)))  # fmt: skip
    shafts = {round(own.shaft_frequency, 9) for _, own in known}
    shaft = said("shaft")
    marks = [  # one line where both turn alike
        _upright(own.shaft_frequency, one.named(shaft) if len(shafts) > 1 else shaft, one.place)
        for one, own in known[: len(shafts)]
    ]  # fmt: skip
    top = rounded_up(1.03 * greatest(line.x for line in series))
    conclusion = said("Under load: {values}. Marks: the first {count} harmonics.",
                      values="; ".join(told), count=_HARMONICS)  # fmt: skip
    across = Axis(unit="Hz", limits=(0.0, top), name=said("Frequency"))
    return picture(
        Chart(tuple(series), across, Axis(categories=tuple(rows)), conclusion, marks=tuple(marks))
    )


# --- heat -----------------------------------------------------------------------------------------

_PLACES: Final = {
    "shaft": 5.0, "inner_ring": 4.0, "elements": 3.0, "outer_ring": 2.0, "housing": 1.0,
}  # fmt: skip
"""Heights of the nodes: from the shaft down to the housing."""
_WIDEST: Final = 7.0
"""Width of the greatest heat flow, in those of an ordinary line."""
_NOWHERE: Final = np.zeros(2, dtype=np.bool_)
"""Where a heat flow is drawn in full: its line lies below words."""


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


def _heat_told(one: Analysed, found: HeatBalance) -> str:
    values = {
        "power": _told(found.power, "W"),
        "temperature": number(max(found.temperatures.values()) - ZERO_CELSIUS),
    }
    return one.named(said("{power} of friction, {temperature} °C at most", **values))


def _network(one: Analysed, found: HeatBalance) -> Picture:
    at = found.temperatures
    ends = {name: (0.0, y) for name, y in _PLACES.items()}
    most = max(abs(flow.power) for flow in found.flows) or 1.0
    series: list[Line | Labels] = []
    middles, texts = [], []
    sides: list[Side] = []
    for flow in found.flows:
        if not flow.power:
            continue
        first, last = _ends(flow.start, flow.end, ends)
        text = f"{number(abs(flow.power))} W"
        names = [said(PLACE_NAMES[name]) for name in (flow.start, flow.end)]
        told = " → ".join(names if flow.power > 0.0 else names[::-1])
        width = max(0.5, _WIDEST * abs(flow.power) / most)
        look = Look("outer" if flow.start in ("friction", "outside") else "grey", width=width)
        x, y = np.array([first, last]).T
        series.append(Line(x, y, "", look, texts=(f"{told}: {text}",) * 2, valid=_NOWHERE))
        middles.append((0.5 * x.sum(), 0.5 * y.sum()))
        texts.append(f"{text} {_arrow(first, last, flow.power > 0.0)}")
        sides.append("left" if first[0] == last[0] else "above")
    across, upright = np.array(middles).T
    series.append(Labels(across, upright, tuple(texts), tuple(sides)))
    heights, nowhere = np.array(list(_PLACES.values())), np.zeros(len(_PLACES))
    names = [f"{said(PLACE_NAMES[name])}\n{number(at[name] - ZERO_CELSIUS)} °C" for name in _PLACES]
    nodes = Look("inner", width=2.0)
    series.append(Line(nowhere, heights, "", nodes, "points", texts=tuple(names)))
    aside: list[Side] = ["right"] * len(names)
    series.append(Labels(nowhere, heights, tuple(names), tuple(aside)))
    return picture(
        Chart(
            tuple(series),
            Axis(limits=(-2.3, 2.3), hidden=True),
            Axis(limits=(-0.4, 6.4), hidden=True),
            said("Heat balance: {values}.", values=_heat_told(one, found)),
            outlines=True,
        )
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


def _temperatures_beside(states: Sequence[tuple[Analysed, HeatBalance]]) -> Picture:
    names = [capitalised(said(PLACE_NAMES[name])) for name in _PLACES]
    places = tuple(range(len(names)))
    bars = [
        Bars(np.array([found.temperatures[name] for name in _PLACES]) - ZERO_CELSIUS, places,
             one.name, case_look(one.place))
        for one, found in states
    ]  # fmt: skip
    told = "; ".join(_heat_told(one, found) for one, found in states)
    top = rounded_up(1.03 * greatest(own.values for own in bars))
    return picture(
        Chart(
            tuple(bars),
            Axis(unit="°C", limits=(0.0, top), name=said("Temperature")),
            Axis(categories=tuple(names)),
            said("Heat balance: {values}.", values=told),
        )
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
