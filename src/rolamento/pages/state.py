"""The page of `solve`: inner ring, rows of a set, stiffness, rolling elements and their contacts.

The bearing is seen from the +x end, so that x points at the reader: +z is up, +y is to the right,
and azimuths run clockwise like the hours.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import cos, isfinite, pi, sin
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import plots
from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.document import (
    Beside,
    Break,
    CellContent,
    Column,
    Document,
    Entry,
    Figure,
    KeyValues,
    Number,
    Section,
    Table,
    Tone,
)
from rolamento.numerics import FloatArray
from rolamento.pages.elements import (
    element_sections,
    heaviest_section,
    roller_pictures,
    without_rounding,
)
from rolamento.pages.given import BOTH, case_page, facing, head
from rolamento.pages.notes import remarks_of
from rolamento.pages.preload import stage_table
from rolamento.solved import NO_LOAD, RACES, Preloading, Rolling, Solved
from rolamento.words import ABSENT, Note, decimals_for, in_unit, manner, said, worded

if TYPE_CHECKING:
    from rolamento.analysis import Analysis

__all__ = ["rosette", "state_page", "stiffness_section"]

_SHIFTS: Final = 3
"""x, y, z come before the tilts, forces before moments."""
_NEGLIGIBLE: Final = 1e-9
"""Fraction of the stiffnesses on the diagonal: what is less is rounding, and written 0."""


def state_page(solved: Solved, analysis: Analysis | None = None) -> Document:
    """Return the page of one case: without a result it says why and what to do.

    Parameters
    ----------
    solved
        One case, converged or not.
    analysis
        What follows from it; film, friction and life are shown if it has them.
    """
    sections: list[Section | Beside] = []
    whole = (*solved.notes[0], *(() if analysis is None else analysis.notes))
    remarks: list[Note] = []
    if solved.converged[0]:
        if solved.case.bearing.is_set:
            sections.append(_rows(solved))
            sections += [] if solved.preload is None else [_preload(solved, solved.preload)]
        beside = Beside(
            (_ring(solved), heaviest_section(solved)), (rosette_section(solved),), key="ring"
        )
        sections += [beside, stiffness_section(solved)]
        sections += [*element_sections(solved), *roller_pictures(solved)]
        sections += [] if solved.rolling is None else _rolling(solved, solved.rolling)
    else:  # files have its elements all the same, without numbers
        sections += element_sections(solved)
    if analysis is not None:
        sections += _what_follows(solved, analysis, remarks)
    main = "balls" if "ball" in solved.rows.element else "rollers"  # of files of one table
    return case_page(
        solved.case, head(solved), sections, "solve", main, notes=whole, remarks=remarks
    )


# --- the inner ring ----------------------------------------------------------------------------


def _ring(solved: Solved) -> Section:
    """Show displacement and load of the five degrees of freedom, the results in bold."""
    moved, loads = solved.displacement.array[0].tolist(), solved.load.array[0].tolist()
    units = [("µm", "N")] * _SHIFTS + [("mrad", "N·m")] * (len(AXES) - _SHIFTS)
    duty, known = solved.case.duty, list[tuple[str, bool]]()  # what was, and whether by its load
    for axis, load in zip(AXES, LOADS, strict=True):
        pressed = getattr(duty.load, load) is not None
        moved_to, held = getattr(duty.displacement, axis) is not None, axis in ("ry", "rz")
        if pressed or moved_to:
            known.append((said("{name} given", name=load if pressed else axis), pressed))
        else:
            known.append((said("held") if held else said("free"), not held))
    columns = (
        Column("", AXES, "direction"),
        Column(
            said("displacement"),
            _alike(moved, [unit for unit, _ in units], (3, 4)),
            "displacement",
            tones=["strong" if by_load else "" for _, by_load in known],
        ),
        Column("", [unit for unit, _ in units], "displacement_unit"),
        Column("", [f" {load}" for load in LOADS], "load_name"),
        Column(
            said("load"),
            _alike(loads, [unit for _, unit in units], (3, 4)),
            "load",
            tones=["" if by_load else "strong" for _, by_load in known],
        ),
        Column("", [unit for _, unit in units], "load_unit"),
        Column("", [f" {text}" for text, _ in known], "known", tone="faint"),
    )
    table = Table(columns, "ring", headless=True, gap=1)
    return Section(said("Inner ring"), (table,), "ring")


def _alike(
    values: Sequence[float], units: Sequence[str], most: tuple[int, int], figures: int = 5
) -> list[CellContent]:
    """Write displacements, and tilts, each with the decimals of the greatest."""
    cells: list[CellContent] = []
    for part, limit in ((slice(None, _SHIFTS), most[0]), (slice(_SHIFTS, None), most[1])):
        scaled = [float(in_unit(v, u)) for v, u in zip(values[part], units[part], strict=True)]
        decimals = decimals_for(scaled, figures, limit)
        cells += [
            Number(value, f".{decimals}f [{unit}]")
            for value, unit in zip(values[part], units[part], strict=True)
        ]
    return cells


def stiffness_section(solved: Solved) -> Section:
    """Show the 5 x 5 matrix in four blocks of one unit each; in files a load in a row."""
    stiffness = solved.stiffness.array[0]
    diagonal = np.abs(np.outer(stiffness.diagonal(), stiffness.diagonal()))
    noise = stiffness * stiffness <= _NEGLIGIBLE**2 * diagonal
    matrix = np.where(noise, 0.0, stiffness)
    tilts = len(AXES) - _SHIFTS
    of_kind = (["N/µm"] * _SHIFTS + ["N·m/mm"] * tilts, ["N/mrad"] * _SHIFTS + ["N·m/mrad"] * tilts)
    columns = [Column("", ["", *LOADS[:_SHIFTS], "", *LOADS[_SHIFTS:]], "load")]
    in_files = [Column("load", LOADS, "load")]
    for j, axis in enumerate(AXES):
        units, numbers = of_kind[j >= _SHIFTS], matrix[:, j].tolist()
        cells = _alike(numbers, units, (3, 3))
        tones: list[Tone] = ["strong" if i == j else "" for i in range(len(AXES))]
        columns.append(
            Column(
                axis,
                [units[0], *cells[:_SHIFTS], units[-1], *cells[_SHIFTS:]],
                axis,
                align="right",
                tones=["faint", *tones[:_SHIFTS], "faint", *tones[_SHIFTS:]],
            )
        )
        values = [Number(one, f"[{unit}]") for one, unit in zip(numbers, units, strict=True)]
        in_files.append(Column(axis, values, axis))
    in_files += [
        Column("unit", units, key)
        for units, key in zip(of_kind, ("shift_unit", "tilt_unit"), strict=True)
    ]
    tables = Table(tuple(columns), gap=3), Table(tuple(in_files), "stiffness", only_in_files=True)
    return Section(said("Stiffness"), tables, "stiffness")


# --- the rosette: a small polar drawing of the loads ----------------------------------------------

_HEIGHT: Final = 11
_GAP: Final = 2
_SIDE: Final = " +y"
_BRAILLE: Final = 0x2800
_BITS: Final = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""Bit of the dot in a row and column of a braille character."""

Sketch = list[list[tuple[str, Tone]]]


def rosette_section(solved: Solved) -> Section:
    """Draw the inner loads round the bearing, with the axes and the scale: one rosette a row."""
    count = len(solved.rows)
    heading = said("Load rosette") if count == 1 else said("Load rosettes")
    figure = Figure(
        worded(
            solved.rows.element,
            said("Ball loads round the bearing, seen from +x"),
            said("Roller loads round the bearing, seen from +x"),
            said("Loads of the rolling elements round the bearing, seen from +x"),
        ),
        lambda: plots.load_rosette(solved),
        "rosette",
        sketch=lambda width, draws: _sketch(solved, width, draws),
        width=count * (2 * _HEIGHT + len(_SIDE)) + (count - 1) * _GAP,
    )
    return Section(heading, (figure,), "rosette")


def _sketch(solved: Solved, width: int, draws: bool) -> Sketch:
    """Set as many rosettes side by side as there is room for; all have the same scale."""
    count = len(solved.rows)
    rim, wide, beside = float(solved.inner.load[0].max()), 2 * _HEIGHT, " " * len(_SIDE)
    drawn = []
    for row in range(count):
        own = solved.elements.row == row
        loads, azimuths = solved.inner.load[0, own].tolist(), solved.elements.azimuth[0, own]
        cells = rosette(loads, azimuths.tolist(), _HEIGHT, rim=rim, braille=draws)
        heads = [said("row {number}", number=row)] * (count > 1) + ["+z"]
        drawn.append([
            *([(head.center(wide) + beside, "")] for head in heads),
            *([*line, (_SIDE if at == _HEIGHT // 2 else beside, "")]
              for at, line in enumerate(cells)),
        ])  # fmt: skip
    one = wide + len(_SIDE)
    most = max(min((width + _GAP) // (one + _GAP), count), 1)
    abreast = -(-count // -(-count // most))  # four as two and two, not three and one
    lines: Sketch = []
    for first in range(0, count, abreast):
        for parts in zip(*drawn[first : first + abreast], strict=True):
            line: list[tuple[str, Tone]] = []
            for number, part in enumerate(parts):
                line += [(" " * _GAP, "")] * bool(number) + part
            lines.append(line)
    scale = manner().fixed(rim, decimals_for([rim], 5)) if rim > 0.0 else ABSENT
    captions = [said("rim: Q_i = {load} N", load=scale), said("seen from +x")]
    if count > 1:
        return [*lines, [(f"  {', '.join(captions)}", "faint")]]
    return [*lines, *([(caption.center(2 * _HEIGHT), "faint")] for caption in captions)]  # type: ignore[list-item]


def rosette(
    loads: Sequence[float],
    azimuths: Sequence[float],
    height: int,
    *,
    rim: float,
    braille: bool = True,
) -> Sketch:
    """Draw a spoke for each element, as long as its load, within a rim.

    Parameters
    ----------
    loads
        Of the elements; what is not a number or not above zero is left out.
    azimuths
        Of the elements, in rad.
    height
        In lines; the drawing is twice as many characters wide.
    rim
        The load at the rim.
    braille
        Draw with braille dots, two by four to a character; otherwise with ASCII.
    """
    across, down = (2, 4) if braille else (1, 1)
    columns, rows = 2 * height * across, height * down
    circle = [(1.0, 2.0 * pi * step / (16 * height)) for step in range(16 * height)]
    spokes = [
        (step / columns, azimuth)
        for load, azimuth in zip(loads, azimuths, strict=True)
        if load > 0.0
        for step in range(round(load / rim * columns) + 1)
    ]
    dots: dict[tuple[int, int], bool] = {}  # by row and column, whether of a load
    for loaded, drawn in ((False, circle), (True, spokes)):
        for radius, azimuth in drawn:
            column = round((columns - 1) / 2 * (1.0 + radius * sin(azimuth)))
            row = round((rows - 1) / 2 * (1.0 - radius * cos(azimuth)))
            dots[row, column] = loaded
    lines: Sketch = [[] for _ in range(height)]
    for row, column in product(range(height), range(2 * height)):
        places = [
            (r, c, (down * row + r, across * column + c))
            for r in range(down)
            for c in range(across)
        ]
        inside = [(r, c, dots[place]) for r, c, place in places if place in dots]
        loaded = any(of_load for _, _, of_load in inside)
        character = "o" if loaded else "."
        if braille:
            character = chr(_BRAILLE + sum(_BITS[r][c] for r, c, _ in inside))
        lines[row].append((character if inside else " ", "mark" if loaded else "faint"))
    return lines


# --- the rows of a set and their preload -------------------------------------------------------


def _rows(solved: Solved) -> Section:
    """Show a line for each row: its place, what it takes, its loaded elements, its peaks."""
    rows, bearing = solved.rows, solved.case.bearing
    faces = [facing(bearing, place) for place in bearing.places]
    loaded = zip(solved.loaded_elements[0], rows.element_count, strict=True)
    both = said(", ± both ways") if BOTH in faces else ""
    legend = worded(
        solved.rows.element,
        said(
            "faces + carries axial load toward +x, − toward −x{both}; moments about x = 0; loaded: "
            "balls that the inner ring presses on; Q_i, p_i maximum",
            both=both,
        ),
        said(
            "faces + carries axial load toward +x, − toward −x{both}; moments about x = 0; loaded: "
            "rollers that the inner ring presses on; Q_i, p_i maximum",
            both=both,
        ),
        said(
            "faces + carries axial load toward +x, − toward −x{both}; moments about x = 0; loaded: "
            "rolling elements that the inner ring presses on; Q_i, p_i maximum",
            both=both,
        ),
    )
    columns = [
        Column(said("row"), list(range(len(rows))), "row"),
        Column(said("faces"), faces, "faces"),
        Column("x", rows.position[0].tolist(), "position", "mm", figures=5),
        Column(
            said("loaded"), [f"{some}/{count}" for some, count in loaded], "loaded", align="right"
        ),
        Column("Q_i", _maximum_by_row(solved, solved.inner.load[0]), "inner_load", "N", most=1),
        Column(
            "p_i",
            _maximum_by_row(solved, solved.inner.max_pressure[0]),
            "inner_max_pressure",
            "MPa",
            most=1,
        ),
        *_taken(rows.load[0]),
    ]
    breaks = (Break(6, ""),)
    table = Table(tuple(columns), "rows", legends=(legend,), rule=True, fixed=1, breaks=breaks)
    return Section(said("Rows"), (table,), "rows")


def _taken(loads: FloatArray) -> list[Column]:
    """The forces and moments of each row, all forces and all moments with the same decimals."""
    columns = []
    for first, end, unit in ((0, _SHIFTS, "N"), (_SHIFTS, len(LOADS), "N·m")):
        decimals = decimals_for(loads[:, first:end].ravel().tolist(), 4, 2)
        columns += [
            Column(
                LOADS[index],
                loads[:, index].tolist(),
                LOADS[index],
                unit,
                figures=99,
                most=decimals,
            )
            for index in range(first, end)
        ]
    return columns


def _maximum_by_row(solved: Solved, values: FloatArray) -> list[float]:
    """At the inner contacts that are loaded; NaN without any."""
    loaded = np.where(solved.inner.load[0] > 0.0, values, np.nan)
    return [float(value) for value in np.fmax.reduceat(loaded, solved.rows.starts)]


def _preload(solved: Solved, preload: Preloading) -> Section:
    """Show the preload at rest and at speed, and where it is lost."""
    entries = []
    if not preload.stages:
        entries.append(Entry(said("at rest"), Number(preload.at_rest, ".4 N")))
    if not preload.stages and solved.case.duty.turns:
        entries.append(Entry(said("at speed"), Number(preload.at_speed, ".4 N")))
    entries += [*_lift(solved, preload), *_loss(solved, preload)]
    stages = (stage_table(preload.stages),) if preload.stages else ()
    block = (KeyValues(tuple(entries), 2, label_tone=""),) if entries else ()
    return Section(said("Preload"), (*stages, *block), "preload")


def _lift(solved: Solved, preload: Preloading) -> list[Entry]:
    """Where the first element lifts off, unless it takes its row along."""
    factor = preload.lift_factor
    if preload.lift_row is None or factor is None or factor == preload.loss_factor:
        return []
    label = worded(
        solved.rows.element, said("first ball"), said("first roller"), said("first rolling element")
    )
    values = {
        "row": preload.lift_row,
        "factor": factor,
        "load": _resulting_load(solved.case.duty, factor),
    }
    if factor < 1.0:
        text = said("has lifted off in row {row}, at {factor:.3} × the load: {load}", **values)
        return [Entry(label, text, "warning")]
    text = said("lifts off in row {row} at {factor:.3} × the load: {load}", **values)
    return [Entry(label, text)]


def _loss(solved: Solved, preload: Preloading) -> list[Entry]:
    """Where a row lifts off, as a multiple of the load and as that load."""
    row, factor = preload.lost_row, preload.loss_factor
    if factor is None:  # nobody looked for it
        return []
    duty, label = solved.case.duty, said("loss")
    lost = [int(other) for other in np.flatnonzero(solved.loaded_elements[0] == 0)]
    if row is None or not isfinite(factor):
        if lost:
            text = worded(
                solved.rows.element,
                said("no ball of row {rows} presses on the inner ring", rows=lost),
                said("no roller of row {rows} presses on the inner ring", rows=lost),
                said("no rolling element of row {rows} presses on the inner ring", rows=lost),
            )
            return [Entry(label, text, "warning-strong")]
        loaded = any(getattr(duty.load, name) for name in LOADS)
        text = said("no row loses all contact as this load increases")
        return [Entry(label, text)] if loaded else []
    values = {"row": row, "factor": factor, "load": _resulting_load(duty, factor)}
    if factor < 1.0 or row in lost:
        text = said("row {row} has lifted off, at {factor:.3} × the load: {load}", **values)
        return [Entry(label, text, "warning-strong")]
    return [Entry(label, said("row {row} lifts off at {factor:.3} × the load: {load}", **values))]


def _resulting_load(duty: Duty, factor: float) -> str:
    """The external load, times a factor."""
    parts = []
    for name in LOADS:
        value = getattr(duty.load, name)
        if value:
            form = ".4 N" if name.startswith("f") else ".4 N·m"
            parts.append(f"{name} {manner().number(factor * value, form)}")
    return ", ".join(parts)


# --- balls that friction alone moves -----------------------------------------------------------


def _rolling(solved: Solved, rolling: Rolling) -> list[Section]:
    """Show how friction moves cage and balls, and what it costs."""
    entries = (
        Entry(said("cage"), _cage(rolling)),
        Entry(
            said("torque"),
            said(
                "{inner:.4 N·mm} on the shaft, {outer:.4 N·mm} on the housing",
                inner=float(rolling.inner_torque[0]),
                outer=float(rolling.outer_torque[0]),
            ),
        ),
        Entry(said("losses"), _powers(rolling, solved.case.model.cage_drag)),
    )
    legend = said(
        "β, β′ angles of the ball's axis to the shaft, in its axial plane and out of it; s "
        "spin-to-roll ratio, P power lost, v slip at the contact's centre along the orbit"
    )
    elements = solved.elements
    tilt, yaw = (without_rounding(one[0]).tolist() for one in (elements.attitude, elements.yaw))
    columns = [
        Column("#", list(range(len(elements.row))), "ball"),
        Column("ψ", elements.azimuth[0].tolist(), "azimuth", "°", figures=5),
        Column("β", tilt, "attitude", "°"),
        Column("β′", yaw, "yaw", "°", figures=3, most=3),
    ]
    for race in RACES:
        own, other = solved.contacts[race], solved.contacts["outer" if race == "inner" else "inner"]
        touched = own.load[0] > NO_LOAD * other.load[0]
        spin = without_rounding(np.where(touched, own.spin_to_roll[0], np.nan))
        name = f"{race}_spin"
        columns.append(Column(f"s_{race[0]}", spin.tolist(), name, "–", figures=3, most=3))
    for symbol, unit, name, most in (("P", "W", "power", 3), ("v", "mm/s", "slip", 2)):
        for race in RACES:
            values = getattr(getattr(rolling, race), name)[0].tolist()
            columns.append(Column(f"{symbol}_{race[0]}", values, f"{race}_{name}", unit, most=most))
    table = Table(tuple(columns), "rolling", legends=(legend,), rule=True)
    facts = Section(said("Motion under friction"), (KeyValues(entries, 2),), "rolling")
    return [facts, Section("", (table,))]


def _cage(rolling: Rolling) -> str:
    skid = float(rolling.skid[0])
    values = {
        "speed": float(rolling.cage_speed[0]),
        "skid": abs(skid),
        "usual": float(rolling.control_cage_speed[0]),
    }
    if skid >= 0.0:
        return said(
            "{speed:.5 rpm}, {skid:.3 %} behind the {usual:.5 rpm} of outer raceway control",
            **values,
        )
    return said(
        "{speed:.5 rpm}, {skid:.3 %} ahead of the {usual:.5 rpm} of outer raceway control", **values
    )


def _powers(rolling: Rolling, drag: float) -> str:
    text = said(
        "{total:.4 W} in the contacts: {inner:.4 W} inner, {outer:.4 W} outer",
        total=float(rolling.power[0]),
        inner=float(rolling.inner.power[0].sum()),
        outer=float(rolling.outer.power[0].sum()),
    )
    if drag:
        own = drag * abs(float(rolling.cage_speed[0]))
        text += "; " + said("{drag:.4 W} against the cage's drag", drag=own)
    return text


# --- what follows from the state ---------------------------------------------------------------


def _what_follows(solved: Solved, analysis: Analysis, notes: list[Note]) -> list[Section | Beside]:
    """Show film, friction and life; what is to be known of them goes to the notes."""
    sections: list[Section | Beside] = []
    if analysis.film is not None:
        from rolamento.pages.film import film_sections

        sections += film_sections(analysis.film)
        notes += remarks_of(analysis.film.notes_of())
    if analysis.friction is not None:
        from rolamento.pages.friction import beside_sections, friction_sections

        sections += friction_sections(solved, analysis.friction)
        sections += beside_sections(analysis)
    if analysis.life is not None:
        from rolamento.pages.life import life_notes, life_section

        sections.append(life_section(solved, analysis.life))
        notes += life_notes(analysis.life)
    return sections
