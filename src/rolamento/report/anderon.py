"""Noise of bearings in anderons for a reader: the verdict first."""

from __future__ import annotations

from collections.abc import Iterator
from math import exp, isfinite, nan, pi
from typing import Final

from rich.text import Text

from rolamento.report.anderon_result import MeasuredNoise, NoiseResult
from rolamento.report.anderon_words import NOISE_WORDS, NoiseWords
from rolamento.report.language import ENGLISH, Words
from rolamento.report.medium import Medium
from rolamento.report.numbers import ABSENT, Digits
from rolamento.report.page import Lines, Page, one_line, shortened, table
from rolamento.report.reading_words import said_choice
from rolamento.report.terminal import rendered
from rolamento.vibration.anderon import BANDS, BandNoise, velocity_of_anderons
from rolamento.vibration.anderon_trend import AnderonTrend, BandTrend

__all__ = ["noise_report", "noise_statement"]

_RPM: Final = 30.0 / pi
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
        parts += [_facts(page, said, found.measured[0]), _bands(page, said, found)]
    else:
        parts.append(_signals(page, said, found))
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
        (said.speed, said.speeds[known].format(speed=digits.short(_RPM * one.noise.speed, 6))),
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


def _bands(page: Page, said: NoiseWords, found: NoiseResult) -> Lines:
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
    legend = said.legend.format(speed=page.digits.short(_RPM * one.noise.speed, 6), factors=factors)
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


def _signals(page: Page, said: NoiseWords, found: NoiseResult) -> Lines:
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
    rows = [_row_over_time(page, said, band) for band in trend.bands if band.anderons]
    if not rows:
        return []
    return [
        page.heading(said.over_time),
        *table(page, said.time_heads, rows),
        *page.hanging(Text("  "), said.time_legend, "dim"),
    ]


def _row_over_time(page: Page, said: NoiseWords, band: BandTrend) -> list[str]:
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
        texts = [one.note(name, said, page.digits) for name in one.names_of_notes]
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
