"""What a vibration signal says of a bearing: the statement first; JSON and CSV."""

from __future__ import annotations

import csv
from dataclasses import asdict, dataclass
from functools import cached_property
from io import StringIO
from math import degrees, inf, isfinite, log10, nan, pi
from typing import Final, Literal

import numpy as np
from rich.text import Text

from rolamento.bearing import Bearing
from rolamento.report.diagnosis_sentences import said_note, said_reasons, said_statements
from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS, DiagnosisWords
from rolamento.report.frequencies_words import FREQUENCY_WORDS
from rolamento.report.language import ENGLISH, Words
from rolamento.report.medium import Medium
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Lines, Page
from rolamento.report.plain_data import csv_number, json_text
from rolamento.report.terminal import rendered
from rolamento.vibration.diagnosis import ComponentVerdict, Diagnosis, DiagnosisSettings
from rolamento.vibration.fault_lines import FaultFrequencies
from rolamento.vibration.indicators import Indicators, indicators
from rolamento.vibration.signal import Signal

__all__ = [
    "CSV_COLUMNS",
    "DiagnosisResult",
    "diagnosis_csv",
    "diagnosis_json",
    "diagnosis_report",
]

SCHEMA: Final = 1

CSV_COLUMNS: Final = ("band_low_Hz", "band_high_Hz", "order", "frequency_Hz", "over_noise_dB")
"""The header of the envelope's spectrum: one line of it in a row."""

_RPM: Final = 30.0 / pi
_MM: Final = 1e3
_CLEAR: Final = 9.0
"""dB above the noise that a line of noise alone reaches once in three thousand."""
_KILO: Final = 1e-3
_UNITS: Final = {"m/s^2": "m/s²", "mm/s^2": "mm/s²", "1": ""}
_STYLES: Final = {"fault": "bold red", "nothing_found": "green", "not_tested": "dim"}


@dataclass(frozen=True, eq=False)
class DiagnosisResult:
    """All that the command finds.

    Attributes
    ----------
    title
        of the signal
    bearing_name
        designation or title of the case
    bearing
        whose vibration this is
    frequencies
        nominal, at the mean speed
    diagnosis, settings
        what was found, and how it was looked for
    signal
        that was diagnosed, or its first part if it is long
    duration
        of all; s
    reading_notes
        how the samples were taken from their file
    """

    title: str
    bearing_name: str
    bearing: Bearing
    frequencies: FaultFrequencies
    diagnosis: Diagnosis
    settings: DiagnosisSettings
    signal: Signal
    duration: float
    reading_notes: tuple[str, ...] = ()

    @cached_property
    def indicators(self) -> Indicators:
        """Size and peakedness of the signal, or of its first part."""
        return indicators(self.signal)

    @property
    def still(self) -> bool:
        """Whether the signal does not change at all."""
        return self.indicators.peak_to_peak == 0.0

    @property
    def verdict(self) -> Literal["fault", "nothing_found", "no_verdict"]:
        """What it comes to."""
        if self.diagnosis.faults:
            return "fault"
        found = any(part.verdict == "nothing_found" for part in self.diagnosis.components)
        return "nothing_found" if found and not self.still else "no_verdict"

    @property
    def own_notes(self) -> tuple[str, ...]:
        """Names of what is to be known beside the engine's notes."""
        names = ["not_a_certificate"] if self.verdict == "nothing_found" else []
        faults = [part for part in self.diagnosis.components if part.verdict == "fault"]
        if any(_highest_line(part) < _CLEAR for part in faults):
            names.append("weak_lines")
        if "inferred" in self.bearing.origins.values():
            names.append("inferred_inside")
        return tuple(names)


def _highest_line(part: ComponentVerdict) -> float:
    """Return by how much the highest multiple of a fault stands out; dB, -inf if none is seen."""
    levels = [line.above_noise for line in part.lines if isfinite(line.above_noise)]
    return max(levels, default=-inf)


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
    parts = [_statement(page, found), _facts(page, said, found), _table(page, said, found)]
    if not found.still:
        parts.append(_why(page, said, found))
    parts.append(_notes(page, said, found))
    return rendered(page.medium, [part for part in parts if part])


def _statement(page: Page, found: DiagnosisResult) -> Lines:
    style = {"fault": "bold red", "nothing_found": "bold green", "no_verdict": "bold yellow"}
    lines: Lines = []
    for text in said_statements(found.diagnosis, page.words.code, still=found.still):
        lines += page.hanging(Text(), text, style[found.verdict])
    return lines


def _facts(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    """Show what was given and measured, label by label."""
    entries = [
        (said.bearing, _bearing(page, said, found)),
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
        angle=digits.short(degrees(found.frequencies.inner_contact_angle), 4),
    )


def _speed(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> str:
    digits, frequency = page.digits, found.diagnosis.shaft_frequency
    text = said.speed.format(
        speed=digits.short(60.0 * frequency, 6), frequency=digits.short(frequency)
    )
    outer = found.frequencies.outer_speed
    if outer != 0.0:
        text += "; " + said.outer_speed.format(speed=digits.short(_RPM * outer, 6))
    return text


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
        tolerance=page.digits.short(100.0 * found.settings.tolerance, 3),
        alarm=page.digits.short(100.0 * found.settings.false_alarm, 3),
    )


def _table(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    rows = [[page.text(head, "dim") for head in said.heads]]
    for part in found.diagnosis.components:
        rows.append(_row(page, said, found.diagnosis, part))
    legend = said.legend.format(
        trials=found.diagnosis.trials,
        least=page.digits.short(-log10(found.diagnosis.false_alarm), 3),
    )
    return [
        page.heading(said.table),
        *page.columns(rows, "lrrrrlr"),
        *(page.hanging(Text("  "), legend, "dim") if found.diagnosis.trials else []),
    ]


def _row(
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
        digits.fixed(part.evidence, 1),
        said.verdicts[part.verdict],
        band,
    ]
    return [
        page.text(cell, _STYLES[part.verdict] if i == 5 else "") for i, cell in enumerate(cells)
    ]


def _why(page: Page, said: DiagnosisWords, found: DiagnosisResult) -> Lines:
    """Give the reasons, those of faults first; parts that have the same stand together."""
    diagnosis, code = found.diagnosis, page.words.code
    by_evidence = sorted(diagnosis.components, key=lambda part: part.verdict != "fault")
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
    sentences += [said.note[name] for name in found.own_notes]
    sentences += [FREQUENCY_WORDS[code].note[name] for name in found.frequencies.notes]
    if not sentences:
        return []
    lines = [page.heading(said.notes)]
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "yellow"), sentence)
    return lines


# --- data ------------------------------------------------------------------------------------


def diagnosis_json(found: DiagnosisResult) -> str:
    """Return everything but the spectra as one JSON object, in SI units and Hz."""
    diagnosis, english = found.diagnosis, DIAGNOSIS_WORDS["en"]
    signal = found.signal
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "diagnosis",
            "title": found.title,
            "verdict": found.verdict,
            "faults": list(diagnosis.faults),
            "statement": said_statements(diagnosis, "en", still=found.still),
            "components": [asdict(part) for part in diagnosis.components],
            "false_alarm": diagnosis.false_alarm,
            "tolerance": diagnosis.tolerance,
            "trials": diagnosis.trials,
            "shaft_frequency": diagnosis.shaft_frequency,
            "revolutions": diagnosis.revolutions,
            "blocks": diagnosis.blocks,
            "order_resolution": diagnosis.resolution,
            "bearing": found.bearing_name,
            "frequencies": found.frequencies.to_mapping(),
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
                *({"name": name, "text": english.note[name]} for name in found.own_notes),
            ],
        }
    )


def diagnosis_csv(found: DiagnosisResult) -> str:
    """Return the squared envelope's spectrum of every fault's band, or of the best match's.

    One line of the spectrum in a row below a header, lines ending in CR LF.
    """
    from rolamento.plots.vibration_spectrum import clearest_band

    spectra, diagnosis = found.diagnosis.spectra, found.diagnosis
    bands = [part.band for part in diagnosis.components if part.band is not None]
    places = sorted({spectra.bands.index(band) for band in bands if band in spectra.bands})
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(CSV_COLUMNS)
    for place in places or [clearest_band(diagnosis)]:
        low, high = spectra.bands[place]
        for order, above in zip(spectra.order, spectra.above_noise[place], strict=True):
            level = 10.0 * float(np.log10(above)) if above > 0.0 else nan
            numbers = (low, high, order, order * diagnosis.shaft_frequency, level)
            writer.writerow([csv_number(float(number)) for number in numbers])
    return text.getvalue()
