"""Fault frequencies for a reader; JSON in SI, and a table for spreadsheets."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import asdict
from io import StringIO
from math import degrees, isfinite
from typing import TYPE_CHECKING, Any, Final

from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.frequencies_words import FREQUENCY_WORDS, FrequencyWords
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import json_text
from rolamento.units import rpm_of
from rolamento.vibration.frequencies import FAULTS, FaultFrequencies, FaultKind, Harmonic
from rolamento.vibration.frequency_band import Alternative

if TYPE_CHECKING:
    from rolamento.solved import Solved
    from rolamento.tasks.frequencies import FrequencyResult

SCHEMA: Final = 1

CSV_COLUMNS: Final = (
    "source",
    "row",
    "line",
    "harmonic",
    "sideband",
    "order",
    "frequency_Hz",
    "order_low",
    "order_high",
    "frequency_low_Hz",
    "frequency_high_Hz",
)
"""The header: low and high are a nominal line's band, or a loaded line's range over the balls."""

_MM: Final = 1e3


# --- page ------------------------------------------------------------------------------------


def frequencies_report(
    found: FrequencyResult, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the page of fault frequencies as text that ends in a newline.

    Parameters
    ----------
    found
        What to show.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    said = FREQUENCY_WORDS[words.code]
    parts = [_page_head(page, said, found)]
    parts += [_line_table(page, said, found, one) for one in found.by_source if _has_lines(one)]
    parts.append(_harmonics(page, said, found))
    if found.alternatives:
        parts.append(_alternatives(page, said, found.alternatives))
    parts.append(_notes(page, said, words, found))
    return rendered(page.medium, [part for part in parts if part])


def _page_head(page: Page, said: FrequencyWords, found: FrequencyResult) -> Lines:
    digits, bearing, nominal = page.digits, found.bearing, found.nominal
    inside = said.inside.format(
        count=bearing.ball_count,
        ball=digits.short(_MM * bearing.ball_diameter),
        pitch=digits.short(_MM * bearing.pitch_diameter, 6),
    )
    angle = said.angle.format(angle=digits.short(degrees(nominal.inner_contact_angle), 4))
    lines = [f"{inside}; {angle}"]
    if isfinite(nominal.shaft_frequency):
        facts = [
            said.speeds[ring].format(speed=digits.short(rpm_of(speed), 6))
            for ring, speed in (("inner", nominal.inner_speed), ("outer", nominal.outer_speed))
            if speed != 0.0 or ring == "inner"
        ]
        frequency = digits.short(nominal.shaft_frequency)
        lines.append("; ".join((*facts, said.shaft.format(frequency=frequency))))
    else:
        lines.append(said.no_speed)
    if nominal.slip:
        lines.append(said.slip.format(slip=digits.short(100.0 * nominal.slip, 3)))
    return [
        page.text(found.title, "bold"),
        page.rule(page.medium.width),
        *page.hanging(Text("  "), "\n".join(lines)),
    ]


def _has_lines(one: FaultFrequencies) -> bool:
    return isfinite(one.cage.order)


def _line_table(
    page: Page, said: FrequencyWords, found: FrequencyResult, one: FaultFrequencies
) -> Lines:
    nominal = one.source == "nominal"
    heads = said.nominal_heads if nominal else said.loaded_heads
    rows = [[page.text(head, "dim") for head in heads]]
    for name, line in one.lines.items():
        numbers = [(line.order, 4), (line.frequency, 3)]
        if line.band is not None:
            band = line.band
            numbers += [(band.order_low, 4), (band.order_high, 4)]
            numbers += [(band.frequency_low, 3), (band.frequency_high, 3)]
        elif not nominal:
            numbers += [(line.minimum, 4), (line.mean, 4), (line.maximum, 4)]
        cells = [page.digits.fixed(value, decimals) for value, decimals in numbers]
        cells += [""] * (len(heads) - 1 - len(cells))
        rows.append([page.text(said.lines[name]), *(page.text(cell) for cell in cells)])
    title = said.nominal if nominal else said.loaded
    title += f", {said.row.format(row=one.row)}" if found.nominal.rows else ""
    if not nominal:
        angles = (one.inner_contact_angle, one.outer_contact_angle)
        shown = " / ".join(page.digits.fixed(degrees(angle), 2) for angle in angles)
        title += f" ({said.angle.format(angle=shown)})"
    legend = said.band
    if not nominal and found.solved is not None:
        legend = said.over_balls.format(count=int(found.solved.loaded_elements[0, one.row]))
    return [
        page.heading(title),
        *page.columns(rows, "l" + "r" * (len(heads) - 1)),
        *page.hanging(Text("  "), legend, "dim"),
    ]


def _harmonics(page: Page, said: FrequencyWords, found: FrequencyResult) -> Lines:
    """One line a harmonic, its sidebands beside it."""
    best = found.best
    in_hertz = isfinite(best.shaft_frequency) and best.shaft_frequency > 0.0
    sides = range(-found.sidebands, found.sidebands + 1)
    heads = ["", "", *(f"{side:+d}" if side else "0" for side in sides)]
    rows = [[page.text(head.replace("-", "−"), "dim") for head in heads]]
    for kind in FAULTS:
        lines = best.harmonics(kind, found.harmonics, found.sidebands)
        for number in range(1, found.harmonics + 1):
            own = {line.sideband: line for line in lines if line.harmonic == number}
            cells = [_harmonic_cell(page, own.get(side), in_hertz) for side in sides]
            label = said.faults[kind] if number == 1 else ""
            rows.append([page.text(cell) for cell in (label, f"{number}×", *cells)])
    heading = said.harmonics if in_hertz else said.harmonics_in_orders
    source = said.nominal if best.source == "nominal" else said.loaded
    return [
        page.heading(f"{heading}: {source[0].lower()}{source[1:]}"),
        *page.columns(rows, "lr" + "r" * len(sides)),
        *page.hanging(Text("  "), said.spacing, "dim"),
    ]


def _harmonic_cell(page: Page, line: Harmonic | None, in_hertz: bool) -> str:
    if line is None:
        return ""
    return page.digits.fixed(*((line.frequency, 2) if in_hertz else (line.order, 4)))


def _alternatives(page: Page, said: FrequencyWords, alternatives: Sequence[Alternative]) -> Lines:
    rows = [[page.text(head, "dim") for head in said.alternative_heads]]
    for one in alternatives:
        digits, orders = page.digits, one.orders
        cells = [
            f"{one.rank}" + ("" if one.reproduces else " ×"),
            str(one.ball_count),
            digits.fixed(_MM * one.ball_diameter, 3),
            digits.fixed(_MM * one.pitch_diameter, 2),
            digits.fixed(100.0 * one.share, 0),
            *(digits.fixed(orders[line], 4) for line in (
                "cage", "ball_pass_outer", "ball_pass_inner", "ball_spin_twice"
            )),
        ]  # fmt: skip
        rows.append([page.text(cell, "bold" if one.rank == 1 else "") for cell in cells])
    return [
        page.heading(said.alternatives),
        *page.columns(rows, "lrrrrrrrr"),
        *page.hanging(Text("  "), said.alternatives_legend, "dim"),
    ]


def _notes(page: Page, said: FrequencyWords, words: Words, found: FrequencyResult) -> Lines:
    names = dict.fromkeys(name for one in found.by_source for name in one.notes)
    sentences = [said.note[name] for name in names if name != "no_result"]
    if found.solved is not None and not found.solved.converged[0]:
        sentences.append(said.failed.format(reason=said_failure(found.solved, words)))
    if not sentences:
        return []
    lines = [page.heading(said.notes)]
    for sentence in sentences:
        lines += page.hanging(page.text("  • "), sentence)
    return lines


def said_failure(solved: Solved, words: Words) -> str:
    """Say why a case has no result, and what to do."""
    return ": ".join(part for part in (words.reason(solved), words.advice(solved)) if part)


# --- data ------------------------------------------------------------------------------------


def frequencies_json(found: FrequencyResult) -> str:
    """Return everything as one JSON object, in SI units and Hz."""
    tables: dict[FaultKind, list[dict[str, Any]]] = {
        kind: [
            {key: value for key, value in asdict(line).items() if key != "fault"}
            for line in found.best.harmonics(kind, found.harmonics, found.sidebands)
        ]
        for kind in FAULTS
    }
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "frequencies",
            "title": found.title,
            "nominal": found.nominal.to_mapping(),
            "loaded": None if found.loaded is None else found.loaded.to_mapping(),
            "harmonics": tables,
            "alternatives": [asdict(one) for one in found.alternatives],
        }
    )


def frequencies_csv(found: FrequencyResult) -> str:
    """Return lines, harmonics and sidebands, one a line below a header, lines ending in CR LF."""
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    for one in found.by_source:
        shaft = one.shaft_frequency
        for name, line in one.lines.items():
            band = line.band
            ends = (
                (line.minimum, line.maximum, shaft * line.minimum, shaft * line.maximum)
                if band is None
                else (band.order_low, band.order_high, band.frequency_low, band.frequency_high)
            )
            numbers = (line.order, line.frequency, *ends)
            writer.writerow((one.source, one.row, name, 1, 0, *map(_nine_digits, numbers)))
        for kind, name in FAULTS.items():
            for extra in one.harmonics(kind, found.harmonics, found.sidebands):
                if (extra.harmonic, extra.sideband) != (1, 0):
                    place = (name, extra.harmonic, extra.sideband)
                    own = (_nine_digits(extra.order), _nine_digits(extra.frequency))
                    writer.writerow((one.source, one.row, *place, *own, *[""] * 4))
    return text.getvalue()


def _nine_digits(value: float) -> str:
    return f"{value:.9g}" if isfinite(value) else ""
