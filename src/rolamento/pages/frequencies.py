"""The page of `frequencies`: fault frequencies by the geometry and under load."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Final

from rolamento.case.bearing import Bearing
from rolamento.case.roller_bearing import RollerBearing
from rolamento.document import (
    Block,
    CellContent,
    Column,
    Document,
    Notes,
    Number,
    Remark,
    Section,
    Statement,
    Table,
    Title,
)
from rolamento.pages.data import in_files
from rolamento.pages.notes import cautions, notes_section, remarks_of
from rolamento.types import type_of_element
from rolamento.vibration.frequencies import ABBREVIATIONS, FAULTS, FaultFrequencies, LineName
from rolamento.vibration.frequency_band import Alternative
from rolamento.words import marked, said, said_in, worded
from rolamento.words.naming import PARTS, part_name
from rolamento.words.reasons import why_not

if TYPE_CHECKING:
    from rolamento.solved import Solved
    from rolamento.tasks.frequencies import FrequencyResult

__all__ = ["balls_of", "contact_angle", "failure_notes", "frequencies_page", "line_name"]

_LINES: Final[dict[LineName, str]] = {
    "cage": PARTS["cage"],
    "ball_pass_outer": PARTS["outer_race"],
    "ball_pass_inner": PARTS["inner_race"],
    "ball_spin": marked("ball, one revolution"),
    "ball_spin_twice": marked("ball, both races"),
}
_OF_ROLLERS: Final[dict[LineName, str]] = {
    **_LINES,
    "ball_spin": marked("roller, one revolution"),
    "ball_spin_twice": marked("roller, both races"),
}


def frequencies_page(found: FrequencyResult) -> Document:
    """Return the page of the fault frequencies of a bearing."""
    sections = [_head(found)]
    sections += [_lines(found, one) for one in found.by_source if isfinite(one.cage.order)]
    sections.append(_harmonics(found))
    if found.alternatives:
        sections.append(_alternatives(found.alternatives, found.nominal.element))
    sections += notes_section(remarks_of(found.notes))
    sections.append(in_files("lines", _COLUMNS, _every_line(found)))
    return Document(found.title, tuple(sections), kind="frequencies", main="lines")


_COLUMNS: Final = {
    "source": "", "row": "", "line": "", "abbreviation": "", "harmonic": "",
    "sideband": "", "order": "",
    "frequency": "Hz", "order_low": "", "order_high": "", "frequency_low": "Hz",
    "frequency_high": "Hz",
}  # fmt: skip
"""Low and high are a nominal line's band, or a loaded line's range over the balls."""


def _every_line(found: FrequencyResult) -> Iterator[tuple[CellContent, ...]]:
    """Return lines, harmonics and sidebands."""
    for one in found.by_source:
        shaft = one.shaft_frequency
        for name, line in one.lines.items():
            band = line.band
            ends = (
                (line.minimum, line.maximum, shaft * line.minimum, shaft * line.maximum)
                if band is None
                else (band.order_low, band.order_high, band.frequency_low, band.frequency_high)
            )
            called = (name, ABBREVIATIONS[name])
            yield one.source, one.row, *called, 1, 0, line.order, line.frequency, *ends
        for kind, name in FAULTS.items():
            called = (name, ABBREVIATIONS[name])
            for extra in one.harmonics(kind, found.harmonics, found.sidebands):
                if (extra.harmonic, extra.sideband) != (1, 0):
                    own = (extra.harmonic, extra.sideband, extra.order, extra.frequency)
                    yield one.source, one.row, *called, *own, *[None] * 4


def line_name(name: LineName, element: str) -> str:
    """Return what a line of the frequencies is called, by what rolls."""
    return worded((element,), said(_LINES[name]), said(_OF_ROLLERS[name]))


def balls_of(bearing: Bearing | RollerBearing, frequencies: FaultFrequencies) -> str:
    """Say what the frequencies follow from: the balls and the circle of their centres, or rollers.

    Of a set that has both, those of the row that the frequencies are of.
    """
    if frequencies.element != bearing.element:
        bearing = bearing.element_rows[frequencies.row].bearing
    if isinstance(bearing, RollerBearing):
        return said(
            "{count} rollers of {roller:.5 mm}, pitch diameter {pitch:.6 mm}",
            count=bearing.roller_count,
            roller=bearing.roller_diameter,
            pitch=bearing.pitch_diameter,
        )
    return said(
        "{count} balls of {ball:.5 mm}, pitch diameter {pitch:.6 mm}",
        count=bearing.ball_count,
        ball=bearing.ball_diameter,
        pitch=bearing.pitch_diameter,
    )


def contact_angle(frequencies: FaultFrequencies) -> str:
    """Say which contact angle the frequencies are of."""
    if type_of_element(frequencies.element).conical:
        return said(
            "contact angles {inner:.4 °} (inner) and {outer:.4 °} (outer)",
            inner=frequencies.inner_contact_angle,
            outer=frequencies.outer_contact_angle,
        )
    return said("contact angle {angle:.4 °}", angle=frequencies.inner_contact_angle)


def failure_notes(solved: Solved) -> tuple[Notes, ...]:
    """Say why there are no frequencies under load; nothing where there are some."""
    if solved.converged[0]:
        return ()
    return (Notes((Remark(_failure(solved), "no_solution_no_frequencies", "warning"),)),)


def _failure(solved: Solved) -> str:
    """Say that a case has no solution, why, and what to do."""
    return said("The case has no solution: {reason}", reason=why_not(solved, advised=True))


def _head(found: FrequencyResult) -> Section:
    nominal = found.nominal
    lines = [f"{balls_of(found.bearing, nominal)}; {contact_angle(nominal)}"]
    if isfinite(nominal.shaft_frequency):
        lines.append("; ".join(_speeds(nominal)))
    else:
        lines.append(said("no speed given: orders of the inner ring, which turns"))
    if nominal.slip:
        lines.append(said("the cage lags behind the outer ring by {slip:.3 %}", slip=nominal.slip))
    notes = [note for note in found.notes if note.key != "no_solution_no_frequencies"]
    leading = cautions(notes)
    if found.solved is not None:
        leading = (*leading, *failure_notes(found.solved))
    blocks: tuple[Block, ...] = (Title(found.title), Statement("\n".join(lines), indent=2))
    blocks += leading
    return Section("", blocks, "given")


def _speeds(nominal: FaultFrequencies) -> Iterable[str]:
    yield said("inner ring {speed:.6 rpm}", speed=nominal.inner_speed)
    if nominal.outer_speed != 0.0:
        yield said("outer ring {speed:.6 rpm}", speed=nominal.outer_speed)
    yield said("shaft {frequency:.5 Hz}", frequency=nominal.shaft_frequency)


# --- lines -------------------------------------------------------------------------------------


def _lines(found: FrequencyResult, one: FaultFrequencies) -> Section:
    nominal, several = one.source == "nominal", bool(found.nominal.rows)
    lines = list(one.lines.values())
    columns = [
        Column("", [line_name(name, one.element) for name in one.lines], "line"),
        Column("", [ABBREVIATIONS[name] for name in one.lines], "abbreviation"),
        Column(said("order"), [line.order for line in lines], "order", form=".4f"),
        Column(
            said("frequency"),
            [line.frequency for line in lines],
            "frequency",
            "Hz",
            form=".3f [Hz]",
        ),
        *(_band(one) if nominal else _spread(one)),
    ]
    legend = said(
        "From, to: what the internal geometry, the contact angle and the tolerances leave open, all"
        " at their worst together."
    )
    if not nominal and found.solved is not None:
        legend = _loaded_legend(one, int(found.solved.loaded_elements[0, one.row]))
    name = f"{one.source}_{one.row}" if several else one.source
    table = Table(tuple(columns), f"lines_{name}", legends=(legend,))
    return Section(_heading(one, several=several), (table,), name)


def _loaded_legend(one: FaultFrequencies, count: int) -> str:
    return worded(
        (one.element,),
        said(
            "Order: of the cage as driven by the loads. Minimum, mean, maximum: over the {count}"
            " balls in contact with the inner ring.",
            count=count,
        ),
        said(
            "Order: of the cage as driven by the loads. Minimum, mean, maximum: over the {count}"
            " rollers in contact with the inner ring.",
            count=count,
        ),
    )


def _heading(one: FaultFrequencies, *, several: bool) -> str:
    if one.source == "nominal":
        return said("By the geometry, row {row}", row=one.row) if several else _by_geometry()
    angles = {"inner": one.inner_contact_angle, "outer": one.outer_contact_angle}
    if several:
        return said(
            "Under load, row {row} (contact angle {inner:.2f [°]} / {outer:.2f °})",
            row=one.row,
            **angles,
        )
    return said("Under load (contact angle {inner:.2f [°]} / {outer:.2f °})", **angles)


def _by_geometry() -> str:
    return said("By the geometry")


def _band(one: FaultFrequencies) -> list[Column]:
    """What uncertainty leaves open, in orders and in Hz."""
    bands = [line.band for line in one.lines.values()]
    if not all(bands):
        return []
    return [
        Column(head, [getattr(band, name) for band in bands], name, unit, form=form)
        for head, name, unit, form in (
            (said("from"), "order_low", "", ".4f"),
            (said("to"), "order_high", "", ".4f"),
            (said("from"), "frequency_low", "Hz", ".3f [Hz]"),
            (said("to"), "frequency_high", "Hz", ".3f [Hz]"),
        )
    ]


def _spread(one: FaultFrequencies) -> list[Column]:
    """Orders over the loaded balls."""
    heads = (
        ("minimum", said_in("order", "minimum")),
        ("mean", said_in("order", "mean")),
        ("maximum", said_in("order", "maximum")),
    )
    return [
        Column(head, [getattr(line, name) for line in one.lines.values()], name, form=".4f")
        for name, head in heads
    ]


def _harmonics(found: FrequencyResult) -> Section:
    """Show a harmonic in a row, its sidebands beside it."""
    best = found.best
    in_hertz = isfinite(best.shaft_frequency) and best.shaft_frequency > 0.0
    sides = range(-found.sidebands, found.sidebands + 1)
    numbers = range(1, found.harmonics + 1)
    places = {
        (kind, line.harmonic, line.sideband): line.frequency if in_hertz else line.order
        for kind in FAULTS
        for line in best.harmonics(kind, found.harmonics, found.sidebands)
    }
    rows = [(kind, number) for kind in FAULTS for number in numbers]
    columns = [
        Column("", [part_name(kind, best.element) for kind, _ in rows], "part", once=True),
        Column("", [ABBREVIATIONS[FAULTS[kind]] for kind, _ in rows], "abbreviation", once=True),
        Column("", [Number(float(number), ".0f", behind="×") for _, number in rows], "harmonic"),
        *(
            Column(
                f"{side:+d}".replace("-", "−") if side else "0",
                [places.get((*row, side)) for row in rows],
                f"sideband_{side}",
                "Hz" if in_hertz else "",
                form=".2f [Hz]" if in_hertz else ".4f",
            )
            for side in sides
        ),
    ]
    legend = worded(
        (best.element,),
        said(
            "Sidebands: of a stationary load, with the ring that is damaged, or with the cage for a"
            " ball."
        ),
        said(
            "Sidebands: of a stationary load, with the ring that is damaged, or with the cage for a"
            " roller."
        ),
    )
    headings = {
        (True, "nominal"): said("Harmonics and sidebands by the geometry"),
        (True, "loaded"): said("Harmonics and sidebands under load"),
        (False, "nominal"): said("Harmonics and sidebands by the geometry (orders)"),
        (False, "loaded"): said("Harmonics and sidebands under load (orders)"),
    }
    table = Table(tuple(columns), "harmonics", legends=(legend,))
    return Section(headings[in_hertz, best.source], (table,), "harmonics")


def _alternatives(alternatives: Sequence[Alternative], element: str) -> Section:
    orders: tuple[tuple[LineName, str], ...] = (
        ("cage", said("cage")),
        ("ball_pass_outer", said_in("race", "outer")),
        ("ball_pass_inner", said_in("race", "inner")),
        ("ball_spin_twice", part_name("ball", element)),
    )
    columns = (
        Column(
            "",
            [
                Number(float(one.rank), ".0f", behind="" if one.reproduces else " ×")
                for one in alternatives
            ],
            "rank",
            align="left",
        ),
        Column("Z", [one.ball_count for one in alternatives], "ball_count"),
        Column(
            "D", [one.ball_diameter for one in alternatives], "ball_diameter", "mm", form=".3f [mm]"
        ),
        Column(
            "d_m",
            [one.pitch_diameter for one in alternatives],
            "pitch_diameter",
            "mm",
            form=".2f [mm]",
        ),
        Column(said("share"), [one.share for one in alternatives], "share", "%", form=".0f [%]"),
        *(
            Column(head, [one.orders[name] for one in alternatives], name, form=".4f")
            for name, head in orders
        ),
    )
    legend = worded(
        (element,),
        said(
            "Ball: both races. × marks a geometry that misses a printed rating by more than three"
            " tolerances; the band leaves it out."
        ),
        said(
            "Roller: both races. × marks a geometry that misses a printed rating by more than three"
            " tolerances; the band leaves it out."
        ),
    )
    table = Table(columns, "alternatives", legends=(legend,))
    heading = said("Other geometries that the ratings allow (orders)")
    return Section(heading, (table,), "alternatives")
