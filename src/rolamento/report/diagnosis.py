"""What a vibration signal says of a bearing, for a reader: the statement first."""

from __future__ import annotations

import csv
from dataclasses import asdict
from io import StringIO
from math import degrees, log10, nan
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.diagnosis_sentences import (
    said_advice,
    said_note,
    said_own_note,
    said_reasons,
    said_result,
    said_too_short,
)
from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS, DiagnosisWords
from rolamento.report.frequencies_words import FREQUENCY_WORDS
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import csv_number, json_text
from rolamento.report.reading_words import said_choice
from rolamento.units import rpm_of
from rolamento.vibration.diagnosis import DAMAGE, SEVERE, ComponentVerdict, Diagnosis
from rolamento.vibration.frequencies import FaultFrequencies

if TYPE_CHECKING:
    from rolamento.tasks.diagnosis import DiagnosisResult, TooShort
    from rolamento.tasks.shaft_speed import ShaftSpeed

SCHEMA: Final = 1

CSV_COLUMNS: Final = ("band_low_Hz", "band_high_Hz", "order", "frequency_Hz", "over_noise_dB")
"""The header of the envelope's spectrum: one line of it in a row."""

_MM: Final = 1e3
_KILO: Final = 1e-3
_UNITS: Final = {"m/s^2": "m/s²", "mm/s^2": "mm/s²", "um": "µm", "um/s": "µm/s", "1": ""}
_STYLES: Final = {
    "fault": "bold red",
    "undecided": "bold yellow",
    "watch": "yellow",
    "nothing_found": "green",
    "not_tested": "dim",
}
_HEADLINES: Final = {
    "fault": "bold red",
    "undecided": "bold yellow",
    "watch": "bold green",
    "nothing_found": "bold green",
    "no_verdict": "bold yellow",
}


def diagnosis_report(
    found: DiagnosisResult, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the page of a diagnosis as text that ends in a newline.

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
    said = DIAGNOSIS_WORDS[words.code]
    parts = [_statement(page, found), _facts(page, said, found), _verdict_table(page, said, found)]
    if not found.still:
        parts.append(_reasons_by_part(page, said, found))
    parts.append(_notes(page, said, found))
    return rendered(page.medium, [part for part in parts if part])


def _statement(page: Page, found: DiagnosisResult) -> Lines:
    """Show the verdict, what to do, and what speaks against it."""
    lines: Lines = []
    for text in said_result(found, page.words.code):
        lines += page.hanging(Text(), text, _HEADLINES[found.verdict])
    if found.verdict != "no_verdict":
        for text in said_advice(found.diagnosis, page.words.code):
            lines += page.hanging(Text(), text)
    return lines


def _facts(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    """Show what was given and measured, label by label."""
    entries = [
        (said.bearing, _bearing(page, said, found)),
        (said.frequencies, _frequencies(page, said, found.frequencies)),
        (said.shaft, _speed(page, said, found)),
        (said.signal, _signal(page, said, found)),
        (said.search, _search(page, said, found)),
    ]
    width = max(len(label) for label, _ in entries)
    lines = [*page.hanging(Text(), found.title, "bold"), page.rule(page.medium.width)]
    for label, content in entries:
        lines += page.hanging(page.text(f"{label:{width}}  ", "dim"), content)
    return lines


def _bearing(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> str:
    digits, bearing = page.digits, found.bearing
    return said.inside.format(
        name=found.bearing_name,
        count=bearing.ball_count,
        ball=digits.short(_MM * bearing.ball_diameter),
        pitch=digits.short(_MM * bearing.pitch_diameter, 6),
    )


def _frequencies(page: Page, said: DiagnosisWords, sought: FaultFrequencies) -> str:
    """Say of which bearing the frequencies are that were looked for: as drawn, or as loaded."""
    digits, cage = page.digits, sought.cage
    if sought.source == "nominal":
        return said.nominal.format(angle=digits.short(degrees(sought.inner_contact_angle), 4))
    angles = [
        digits.fixed(degrees(angle), 1)
        for angle in (sought.inner_contact_angle, sought.outer_contact_angle)
    ]
    ends = [digits.fixed(order, 4) for order in (cage.minimum, cage.maximum)]
    over_balls = said.over_balls.format(least=ends[0], most=ends[1])
    return said.loaded.format(
        angle=said.angles[angles[0] != angles[1]].format(inner=angles[0], outer=angles[1]),
        cage=digits.fixed(cage.order, 4),
        range=over_balls if ends[0] != ends[1] else "",
    )


def _speed(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> str:
    digits, frequency, known = page.digits, found.diagnosis.shaft_frequency, found.speed
    ranges = known is not None and known.minimum != known.maximum
    text = (said.speed_range if ranges else said.speed).format(
        speed=digits.short(60.0 * frequency, 5 if ranges else 6),
        frequency=digits.short(frequency),
        least=digits.short(rpm_of(known.minimum), 5) if known else "",
        most=digits.short(rpm_of(known.maximum), 5) if known else "",
    )
    if known is not None:
        text += ", " + _by_whom(page, said, found, known)
    outer = found.frequencies.outer_speed
    if outer != 0.0:
        text += "; " + said.outer_speed.format(speed=digits.short(rpm_of(outer), 6))
    return text


def _by_whom(page: Page, said: DiagnosisWords, found: DiagnosisResult, known: ShaftSpeed) -> str:
    """Say who tells the speed: what was given or measured, or the shaft's own lines."""
    digits, diagnosis, source = page.digits, found.diagnosis, _speed_source(page, said, known)
    tolerance = found.settings.speed_tolerance
    if diagnosis.speed_factor != 1.0:
        part = 100.0 * (1.0 / diagnosis.speed_factor - 1.0)
        off = digits.fixed(part, 1 if abs(part) >= 0.1 else 2)
        given = digits.short(rpm_of(abs(known.mean)), 6)
        return said.speed_by_lines.format(source=source, given=given, off=off)
    if diagnosis.speed_confirmed or found.still or not known.is_steady:
        return source
    return f"{source}; " + said.speed_open.format(tolerance=digits.short(100.0 * tolerance, 3))


def _speed_source(page: Page, said: DiagnosisWords, known: ShaftSpeed) -> str:
    digits, tracking = page.digits, known.tracking
    return said.speed_source["lost" if known.lost else known.source].format(
        channel=known.channel,
        pulses=known.pulses,
        within=digits.short(100.0 * tracking.within, 3) if tracking else "",
        nominal=digits.short(rpm_of(abs(tracking.nominal)), 6) if tracking else "",
    )


def _signal(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> str:
    digits, signal, sizes = page.digits, found.signal, found.indicators
    samples = said.samples.format(
        duration=digits.short(found.duration, 4),
        rate=digits.short(signal.rate, 6),
        turns=digits.short(found.diagnosis.revolutions, 3)
        if found.diagnosis.revolutions < 100.0
        else digits.fixed(found.diagnosis.revolutions, 0),
    )
    unit = _UNITS.get(signal.unit, signal.unit)
    part = signal.duration < found.duration * (1.0 - 1e-9)
    measured = said.indicators.format(
        rms=digits.short(sizes.rms, 4),
        unit=f" {unit}" if unit else "",
        crest=digits.short(sizes.crest, 3),
        kurtosis=digits.short(sizes.kurtosis, 3),
    )
    first = said.of_part.format(duration=digits.short(signal.duration, 4)) if part else ""
    return f"{samples}\n{first}{measured}"


def _search(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> str:
    return said.searched.format(
        expected=said.expected[found.frequencies.source == "loaded"],
        wider="" if found.slip is None else said.wider,
        tolerance=page.digits.short(100.0 * found.settings.tolerance, 3),
        alarm=page.digits.short(100.0 * found.settings.false_alarm, 3),
    )


def _verdict_table(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    rows = [[page.text(head, "dim") for head in said.heads]]
    for part in found.diagnosis.components:
        rows.append(_verdict_row(page, said, found.diagnosis, part))
    legend = said.legend.format(
        trials=found.diagnosis.trials,
        least=page.digits.short(-log10(found.diagnosis.false_alarm), 3),
        damage=page.digits.fixed(100.0 * DAMAGE, 0),
        severe=page.digits.fixed(100.0 * SEVERE, 0),
    )
    return [
        page.heading(said.table),
        *page.columns(rows, "lrrrrrlr"),
        *(page.hanging(Text("  "), legend, "dim") if found.diagnosis.trials else []),
    ]


def _verdict_row(
    page: Page, said: DiagnosisWords, diagnosis: Diagnosis, part: ComponentVerdict
) -> list[Text]:
    digits = page.digits
    band = ABSENT
    if part.band is not None:
        ends = (digits.fixed(_KILO * edge, 2) for edge in part.band)
        band = "–".join(ends)
    cells = [
        said.parts[part.component],
        digits.fixed(part.nominal_order * diagnosis.shaft_frequency, 2),
        digits.fixed(part.frequency, 2),
        digits.fixed(100.0 * part.deviation, 2),
        digits.fixed(100.0 * part.depth, 0),
        digits.fixed(part.evidence, 1),
        said.verdicts[part.verdict],
        band,
    ]
    return [
        page.text(cell, _STYLES[part.verdict] if i == 6 else "") for i, cell in enumerate(cells)
    ]


def _reasons_by_part(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    """Give the reasons, those of faults first; parts that have the same stand together."""
    diagnosis, code = found.diagnosis, page.words.code
    by_evidence = sorted(
        diagnosis.components, key=lambda part: part.verdict in ("nothing_found", "not_tested")
    )
    entries: dict[str, list[str]] = {}
    for part in by_evidence:
        text = "\n".join(said_reasons(part, diagnosis, code))
        entries.setdefault(text, []).append(said.parts[part.component])
    lines = [page.heading(said.why)]
    for text, names in entries.items():
        lines += page.hanging(Text("  "), ", ".join(names))
        lines += page.hanging(Text("    "), text)
    return lines


def _notes(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    code = page.words.code
    sentences = [said_note(note, found.diagnosis, code) for note in found.diagnosis.notes]
    sentences += [said_own_note(name, found, code) for name in found.own_notes]
    sentences += [said_choice(note, code) for note in found.choices]
    sentences += [FREQUENCY_WORDS[code].note[name] for name in found.frequencies.notes]
    if not sentences:
        return []
    lines = [page.heading(said.notes)]
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "yellow"), sentence)
    return lines


# --- for programs ----------------------------------------------------------------------------


def diagnosis_json(found: DiagnosisResult) -> str:
    """Return everything but the spectra as one JSON object, in SI units and Hz."""
    diagnosis, signal = found.diagnosis, found.signal
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "diagnosis",
            "title": found.title,
            "verdict": found.verdict,
            "grade": diagnosis.grade,
            "faults": list(diagnosis.causes),
            "watched": list(diagnosis.watched),
            "undecided": [
                {"component": part, "shaft_frequency": frequency}
                for part, frequency in diagnosis.undecided
            ],
            "statement": said_result(found, "en"),
            "advice": said_advice(diagnosis, "en"),
            "components": [asdict(part) for part in diagnosis.components],
            "unexplained": [asdict(line) for line in diagnosis.unexplained],
            "false_alarm": diagnosis.false_alarm,
            "tolerance": diagnosis.tolerance,
            "slip": diagnosis.tolerance if found.slip is None else found.slip,
            "trials": diagnosis.trials,
            "shaft_frequency": diagnosis.shaft_frequency,
            "speed_tolerance": found.settings.speed_tolerance,
            "speed_factor": diagnosis.speed_factor,
            "speed_source": diagnosis.speed_source,
            "speed_confirmed": diagnosis.speed_confirmed,
            "speed": None if found.speed is None else _speed_data(found.speed),
            "revolutions": diagnosis.revolutions,
            "blocks": diagnosis.blocks,
            "order_resolution": diagnosis.resolution,
            "bearing": found.bearing_name,
            "frequencies": found.frequencies.to_mapping(),
            "state": None if found.solved is None else found.solved.to_mapping()["status"],
            "signal": {
                "rate": signal.rate,
                "duration": found.duration,
                "quantity": signal.quantity,
                "unit": signal.unit,
                "indicators_of_first": signal.duration,
                "indicators": asdict(found.indicators),
                "reading_notes": list(found.reading_notes),
            },
            "notes": [
                *(asdict(note) for note in diagnosis.notes),
                *(
                    {"name": name, "text": said_own_note(name, found, "en")}
                    for name in found.own_notes
                ),
            ],
        }
    )


def _speed_data(speed: ShaftSpeed) -> dict[str, Any]:
    """Give the speed of the shaft, in rad/s."""
    return {
        "source": speed.source,
        "mean": speed.mean,
        "minimum": speed.minimum,
        "maximum": speed.maximum,
        "channel": speed.channel or None,
        "pulses_per_revolution": speed.pulses,
        "tracking": None if speed.tracking is None else asdict(speed.tracking),
    }


def too_short_json(found: TooShort) -> str:
    """Return what is known of a record that is too short as one JSON object."""
    return json_text(
        {
            "verdict": found.verdict,
            "statement": [said_too_short(found, "en")],
            "reason": found.reason,
            "revolutions": found.revolutions,
            "least_revolutions": found.least_revolutions,
            "duration": found.duration,
        }
    )


def diagnosis_csv(found: DiagnosisResult) -> str:
    """Return the squared envelope's spectrum of every fault's band, or of the best match's.

    One line of the spectrum in a row below a header, lines ending in CR LF.
    """
    spectra, diagnosis = found.diagnosis.spectra, found.diagnosis
    bands = [part.band for part in diagnosis.components if part.band is not None]
    places = sorted({spectra.bands.index(band) for band in bands if band in spectra.bands})
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    for place in places or [diagnosis.clearest_band]:
        low, high = spectra.bands[place]
        for order, above in zip(spectra.order, spectra.above_noise[place], strict=True):
            level = 10.0 * float(np.log10(above)) if above > 0.0 else nan
            numbers = (low, high, order, order * diagnosis.shaft_frequency, level)
            writer.writerow([csv_number(float(number)) for number in numbers])
    return text.getvalue()
