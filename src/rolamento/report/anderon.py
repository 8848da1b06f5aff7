"""Noise of bearings in anderons for a reader: the verdict first."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import asdict
from io import StringIO
from math import exp, isfinite, nan
from typing import TYPE_CHECKING, Any, Final

from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.anderon_words import NOISE_WORDS, NoiseWords
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import ABSENT, Digits
from rolamento.report.page import Lines, Page, one_line, rendered, shortened, table
from rolamento.report.plain_data import csv_number, json_text
from rolamento.report.reading_words import said_choice
from rolamento.units import rpm_of
from rolamento.vibration.anderon import BANDS, BandNoise, velocity_of_anderons
from rolamento.vibration.anderon_trend import AnderonTrend, BandTrend

if TYPE_CHECKING:
    from rolamento.tasks.noise import MeasuredNoise, NoiseResult

SCHEMA: Final = 1

CSV_COLUMNS: Final = (
    "signal", "hours", "band", "low_Hz", "high_Hz", "velocity_um_per_s", "anderons",
    "full_scale_anderons", "accepted_to_anderons", "verdict",
)  # fmt: skip
"""The header of the CSV: one band of one signal in a row."""

_MICRO: Final = 1e6
_STYLES: Final = {
    "accepted": "green", "rejected": "bold red", "not_measured": "bold yellow", "none": "dim"
}  # fmt: skip
_LONGEST_NAME: Final = 32


def noise_report(found: NoiseResult, words: Words = ENGLISH, medium: Medium | None = None) -> str:
    """Return the page of one signal's noise, or of several, as text that ends in a newline.

    Parameters
    ----------
    found
        What the command found.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    said = NOISE_WORDS[words.code]
    parts = [_statement(page, found)]
    if len(found.measured) == 1:
        parts += [_facts(page, said, found.measured[0]), _band_table(page, said, found)]
    else:
        parts.append(_signal_table(page, said, found))
        if found.trend is not None:
            parts.append(_over_time(page, said, found.trend))
    parts.append(_notes(page, said, found))
    return rendered(page.medium, [part for part in parts if part])


def noise_statement(found: NoiseResult, words: Words = ENGLISH) -> str:
    """Return what the noise of one signal, or of several, comes to."""
    digits, said = Digits(words.decimal_mark), NOISE_WORDS[words.code]
    count, rejected = len(found.measured), found.verdicts.count("rejected")
    if not found.full_scales:
        return said.no_verdict
    part = digits.short(100.0 * found.part, 4)
    if not rejected:
        return (said.accepted if count == 1 else said.accepted_all).format(part=part, count=count)
    if count > 1:
        return said.rejected_some.format(rejected=rejected, count=count)
    above = any(isfinite(level) for level in _levels_rejected(found))
    template = said.rejected if above else said.not_accepted
    return template.format(bands="; ".join(_rejections(digits, said, found)))


def _levels_rejected(found: NoiseResult) -> list[float]:
    """Anderons of the only signal in the bands that it is rejected for; NaN if not measured."""
    acceptance = found.acceptances[0]
    noise = found.measured[0].noise
    return [noise.of(name).anderons for name in acceptance.rejected] if acceptance else []


def _rejections(digits: Digits, said: NoiseWords, found: NoiseResult) -> Iterator[str]:
    """Say in which bands the only signal is rejected."""
    one, acceptance = found.measured[0], found.acceptances[0]
    scales = found.scales_of(one)
    for name in acceptance.rejected if acceptance else ():
        value = one.noise.of(name).anderons
        yield (said.above if isfinite(value) else said.unmeasured).format(
            band=said.bands[name],
            value=digits.short(value, 3),
            limit=digits.short(found.part * scales[name], 3),
        )


def _statement(page: Page, found: NoiseResult) -> Lines:
    style = "yellow" if not found.full_scales else "green"
    style = "red" if "rejected" in found.verdicts else style
    return page.hanging(Text(), noise_statement(found, page.words), f"bold {style}")


# --- one signal ------------------------------------------------------------------------------


def _facts(page: Page, said: NoiseWords, one: MeasuredNoise) -> Lines:
    digits, signal = page.digits, one.noise.velocity
    known = "right" if one.at_test_speed else "known"
    known = "unknown" if "speed_unknown" in one.noise.notes else known
    entries = (
        (said.speed, said.speeds[known].format(speed=digits.short(rpm_of(one.noise.speed), 6))),
        (
            said.signal,
            said.samples.format(
                quantity=said.quantities[signal.quantity],
                duration=digits.short(signal.duration, 4),
                rate=digits.short(signal.rate, 6),
            ),
        ),
    )
    width = max(len(label) for label, _ in entries)
    lines = [*page.hanging(Text(), one_line(one.title), "bold"), page.rule(page.medium.width)]
    for label, content in entries:
        lines += page.hanging(page.text(f"{label:{width}}  ", "dim"), content)
    return lines


def _band_table(page: Page, said: NoiseWords, found: NoiseResult) -> Lines:
    one, scales = found.measured[0], found.scales_of(found.measured[0])
    heads = said.heads + (said.limit_heads if scales else ())
    velocities = page.digits.column([_MICRO * band.velocity for band in one.noise.bands], 4, 2)
    anderons = page.digits.column([band.anderons for band in one.noise.bands], 3, 2)
    rows = [[page.text(head, "dim") for head in heads]]
    for band, velocity, level in zip(one.noise.bands, velocities, anderons, strict=True):
        edges = "–".join(page.digits.fixed(edge, 0) for edge in band.band)
        cells = [page.text(cell) for cell in (said.bands[band.name], edges, velocity, level)]
        rows.append(cells + (_verdict_cells(page, said, found, band) if scales else []))
    factors = ", ".join(
        said.one.format(
            factor=page.digits.fixed(_MICRO * velocity_of_anderons(1.0, edges, one.noise.speed), 3),
            band=said.bands[name],
        )
        for name, edges in BANDS.items()
    )
    legend = said.legend.format(
        speed=page.digits.short(rpm_of(one.noise.speed), 6), factors=factors
    )
    return [
        page.heading(said.table),
        *page.columns(rows, "lrrr" + ("rrrl" if scales else "")),
        *page.hanging(Text("  "), legend, "dim"),
    ]


def _verdict_cells(page: Page, said: NoiseWords, found: NoiseResult, band: BandNoise) -> list[Text]:
    digits, one = page.digits, found.measured[0]
    scale = found.scales_of(one).get(band.name, nan)
    verdict = found.verdict_of(0, band.name)
    numbers = (
        digits.short(scale, 4),
        digits.fixed(100.0 * band.anderons / scale, 1),
        digits.short(found.part * scale, 4),
    )
    cells = [page.text(text) for text in numbers]
    return [*cells, page.text(said.verdicts[verdict], _STYLES[verdict])]


# --- several ---------------------------------------------------------------------------------


def _signal_table(page: Page, said: NoiseWords, found: NoiseResult) -> Lines:
    columns = [
        page.digits.column([one.noise.of(name).anderons for one in found.measured], 3, 2)
        for name in BANDS
    ]
    rows = [[page.text(head, "dim") for head in said.signal_heads]]
    for place, (one, verdict) in enumerate(zip(found.measured, found.verdicts, strict=True)):
        cells = [shortened(one_line(one.title), _LONGEST_NAME), page.digits.short(one.hours, 6)]
        cells += [column[place] for column in columns]
        texts = [page.text(cell) for cell in cells]
        rows.append([*texts, page.text(said.verdicts[verdict], _STYLES[verdict])])
    return [
        page.heading(said.signals),
        *page.columns(rows, "lrrrrl"),
        *page.hanging(Text("  "), said.signals_legend, "dim"),
    ]


def _over_time(page: Page, said: NoiseWords, trend: AnderonTrend) -> Lines:
    rows = [_trend_row(page, said, band) for band in trend.bands if band.anderons]
    if not rows:
        return []
    return [
        page.heading(said.over_time),
        *table(page, said.time_heads, rows),
        *page.hanging(Text("  "), said.time_legend, "dim"),
    ]


def _trend_row(page: Page, said: NoiseWords, band: BandTrend) -> list[str]:
    digits = page.digits
    rejected = ABSENT
    if isfinite(band.rejected_by):
        between = (digits.short(hours, 5) for hours in (band.rejected_after, band.rejected_by))
        rejected = "–".join(between)
    growth = 100.0 * (exp(min(100.0 * band.growth, 700.0)) - 1.0)
    return [
        said.bands[band.name],
        digits.short(band.anderons[0], 3),
        digits.short(band.anderons[-1], 3),
        digits.short(band.ratio, 3),
        digits.short(growth, 3),
        rejected,
    ]


# --- notes -----------------------------------------------------------------------------------


def _notes(page: Page, said: NoiseWords, found: NoiseResult) -> Lines:
    """Show every note once; of several signals, with those that it is about."""
    about: dict[str, list[str]] = {}
    for one in found.measured:
        texts = [_said_note(one, name, said, page.digits) for name in one.names_of_notes]
        texts += [said_choice(note, page.words.code) for note in one.choices]
        for text in texts:
            about.setdefault(text, []).append(shortened(one_line(one.title), _LONGEST_NAME))
    if not about:
        return []
    lines = [page.heading(said.notes)]
    for text, titles in about.items():
        if len(titles) < len(found.measured):
            text = said.in_signals.format(note=text, signals=", ".join(titles[:3]))
        lines += page.hanging(page.text("  • ", "yellow"), text)
    return lines


def _said_note(one: MeasuredNoise, name: str, said: NoiseWords, digits: Digits) -> str:
    """Say one of a signal's notes."""
    return said.note[name].format(
        rate=digits.short(one.noise.velocity.rate, 6),
        bands=", ".join(said.bands[name] for name in one.noise.missing),
        unit=one.scaled_unit,
        sensitivity=one_line(one.sensitivity),
    )


# --- for programs ----------------------------------------------------------------------------


def noise_json(found: NoiseResult) -> str:
    """Return everything as one JSON object, in SI units, Hz, anderons and hours."""
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "anderon",
            "bearing": found.bearing,
            "accepted_part": found.part,
            "signals": [_signal_data(found, place) for place in range(len(found.measured))],
            "trend": None if found.trend is None else [asdict(band) for band in found.trend.bands],
        }
    )


def _signal_data(found: NoiseResult, place: int) -> dict[str, Any]:
    one, said = found.measured[place], NOISE_WORDS["en"]
    scales = found.scales_of(one)
    bands = [
        {
            **asdict(band),
            "full_scale": scales.get(band.name),
            "of_full_scale": band.anderons / scales.get(band.name, nan),
            "verdict": found.verdict_of(place, band.name),
        }
        for band in one.noise.bands
    ]
    return {
        "title": one.title,
        "verdict": found.verdicts[place],
        "hours": one.hours,
        "speed": one.noise.speed,
        "bands": bands,
        "rate": one.noise.velocity.rate,
        "duration": one.noise.velocity.duration,
        "quantity": one.noise.velocity.quantity,
        "reading_notes": list(one.reading_notes),
        "notes": [
            {"name": name, "text": _said_note(one, name, said, Digits("."))}
            for name in one.names_of_notes
        ],
    }


def noise_csv(found: NoiseResult) -> str:
    """Return one band of one signal in a row below a header, lines ending in CR LF."""
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    for place, one in enumerate(found.measured):
        scales = found.scales_of(one)
        for band in one.noise.bands:
            scale = scales.get(band.name, nan)
            numbers = (*band.band, _MICRO * band.velocity, band.anderons, scale, found.part * scale)
            writer.writerow(
                (
                    one_line(one.title),
                    csv_number(one.hours),
                    band.name,
                    *(csv_number(number) for number in numbers),
                    found.verdict_of(place, band.name),
                )
            )
    return text.getvalue()


def noise_record(found: NoiseResult, language: str = "en") -> str:
    """Return the anderons over the hours as the CSV that `rolamento trend` reads.

    Only its title is in the language, ``"en"`` or ``"pt"``.
    """
    title = NOISE_WORDS[language].record.format(bearing=found.bearing)
    text = StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    text.write(f"# title: {title}\n")
    writer.writerow(("time (h)", "bearing", *(f"{name} (anderon)" for name in BANDS)))
    for one in found.measured:
        levels = (csv_number(one.noise.of(name).anderons) for name in BANDS)
        writer.writerow((csv_number(one.hours), found.bearing, *levels))
    return text.getvalue()
