"""The page of `diagnose`: the verdict first, then what was measured, and why."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite, log10, pi
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.frequencies import balls_of, contact_angle, failure_notes
from rolamento.pages.notes import cautions, notes_section
from rolamento.vibration.diagnosis import DAMAGE, SEVERE, ComponentVerdict, Diagnosis
from rolamento.vibration.frequencies import ABBREVIATIONS, FAULTS, FaultFrequencies
from rolamento.words import ABSENT, Note, manner, said, said_in
from rolamento.words.headlines import qualifies
from rolamento.words.naming import one_line, part_name

if TYPE_CHECKING:
    from rolamento.tasks.diagnosis import DiagnosisResult
    from rolamento.tasks.shaft_speed import ShaftSpeed

__all__ = ["diagnosis_page"]

_UNITS: Final = {"m/s^2": "m/s²", "mm/s^2": "mm/s²", "um": "µm", "um/s": "µm/s", "1": ""}
_HEADLINES: Final[dict[str, doc.Tone]] = {
    "fault": "bad-strong",
    "undecided": "warning-strong",
    "watch": "good-strong",
    "nothing_found": "good-strong",
    "no_verdict": "warning-strong",
}
_TONES: Final[dict[str, doc.Tone]] = {
    "fault": "bad-strong",
    "undecided": "warning-strong",
    "watch": "warning",
    "nothing_found": "good",
    "not_tested": "faint",
}
_KILO: Final = 1e-3
_OF_THE_SCALE: Final = {
    "full_scale_unknown", "bits_to_full_scale", "samples_not_calibrated", "samples_multiplied",
    "scaled_by_sensitivity",
}  # fmt: skip
"""What does not qualify a diagnosis: it does not depend on the scale of the samples."""


def diagnosis_page(found: DiagnosisResult) -> doc.Document:
    """Return the page of a diagnosis, or of a record that is too short for one."""
    if found.too_short is not None:
        return _too_short_page(found)
    sections = [_verdict(found), _facts(found), _parts(found.diagnosis)]
    if not found.still:
        sections.append(_why(found.diagnosis))
    sections += _notes(found)
    sections.append(doc.Section("", (*_figures(found), _spectrum(found.diagnosis)), "figures"))
    title = f"{found.bearing_name}: {found.title}"
    return doc.Document(title, tuple(sections), kind="diagnose", main="spectrum")


def _too_short_page(found: DiagnosisResult) -> doc.Document:
    statements = tuple(doc.Statement(note.text, "warning-strong") for note in found.statement)
    section = doc.Section("", (*statements, doc.Title(one_line(found.title))), "verdict")
    return doc.Document(found.title, (section,), kind="diagnose")


def _verdict(found: DiagnosisResult) -> doc.Section:
    """Show the verdict, what to do, and what speaks against it."""
    tone = _HEADLINES[found.verdict]
    statements = [doc.Statement(note.text, tone) for note in found.statement]
    statements += [doc.Statement(note.text) for note in found.advice]
    said_before = {note.key for note in found.statement}
    leading = (note for note in _noted(found) if note.key not in said_before | _OF_THE_SCALE)
    blocks: tuple[doc.Block, ...] = (*statements, *cautions(leading))
    keys = {note.key for note in found.notes}
    if found.solved is not None and "no_loaded_frequencies" in keys:
        blocks = (*blocks, *failure_notes(found.solved))
    return doc.Section("", blocks, "verdict")


# --- what was given and measured ---------------------------------------------------------------


def _facts(found: DiagnosisResult) -> doc.Section:
    entries = (
        doc.Entry(
            said("bearing"),
            said(
                "{name}: {balls}",
                name=found.bearing_name,
                balls=balls_of(found.bearing, found.frequencies),
            ),
        ),
        doc.Entry(said("frequencies"), _frequencies(found.frequencies)),
        doc.Entry(said("shaft"), "\n".join(_speed(found))),
        doc.Entry(said("signal"), _signal(found)),
        doc.Entry(said("search"), "\n".join(_search(found))),
    )
    return doc.Section("", (doc.Title(one_line(found.title)), doc.KeyValues(entries)), "given")


def _frequencies(sought: FaultFrequencies) -> str:
    """Say of which bearing the frequencies are that were sought: by the geometry, or loaded."""
    if sought.source == "nominal":
        return said("by the geometry, {angle}", angle=contact_angle(sought))
    lines = [_loaded_angle(sought)]
    cage = sought.cage
    ends = [manner().fixed(order, 4) for order in (cage.minimum, cage.maximum)]
    if ends[0] == ends[1]:
        lines.append(said("cage order {order:.4f}", order=cage.order))
    else:
        lines.append(
            said(
                "cage order {order:.4f}, {least} to {most} over the balls",
                order=cage.order,
                least=ends[0],
                most=ends[1],
            )
        )
    return "\n".join(lines)


def _loaded_angle(sought: FaultFrequencies) -> str:
    angles = {"inner": sought.inner_contact_angle, "outer": sought.outer_contact_angle}
    shown = {manner().number(angle, ".1f [°]") for angle in angles.values()}
    if len(shown) == 1:
        return said("under load, mean contact angle {inner:.1f °}", **angles)
    return said(
        "under load, mean contact angle {inner:.1f °} (inner), {outer:.1f °} (outer)", **angles
    )


def _speed(found: DiagnosisResult) -> Iterable[str]:
    frequency, known = found.diagnosis.shaft_frequency, found.speed
    speed = 2.0 * pi * frequency
    if known is not None and known.minimum != known.maximum:
        yield said(
            "mean {speed:.5 rpm} ({frequency:.5 Hz}), from {least:.5 [rpm]} to {most:.5 rpm}",
            speed=speed,
            frequency=frequency,
            least=known.minimum,
            most=known.maximum,
        )
    else:
        yield said("{speed:.6 rpm} ({frequency:.5 Hz})", speed=speed, frequency=frequency)
    if known is not None:
        yield from _by_whom(found, known)
    if found.frequencies.outer_speed != 0.0:
        yield said("outer ring {speed:.6 rpm}", speed=found.frequencies.outer_speed)


def _by_whom(found: DiagnosisResult, known: ShaftSpeed) -> Iterable[str]:
    """Say where the speed is from: as given or measured, or by the shaft's own peaks."""
    diagnosis, source = found.diagnosis, _source(known)
    if diagnosis.speed_factor != 1.0:
        off = diagnosis.speed_factor - 1.0
        values = {"given": abs(known.mean), "source": source, "off": off}
        yield (
            said("by the shaft's own peaks, {off:+.1f %} from {given:.6 rpm} {source}", **values)
            if abs(off) >= 1e-3
            else said(
                "by the shaft's own peaks, {off:+.2f %} from {given:.6 rpm} {source}", **values
            )
        )
        return
    yield source
    if not (diagnosis.speed_confirmed or found.still) and known.is_steady:
        yield said(
            "not confirmed by the shaft's own peaks: peaks were sought within {tolerance:.3 %}",
            tolerance=found.settings.speed_tolerance,
        )


def _source(known: ShaftSpeed) -> str:
    tracking = known.tracking
    if known.lost:
        return said("taken as constant: it was not found in the vibration")
    if known.source == "vibration" and tracking is not None:
        if isfinite(tracking.share):
            return said(
                "found in the vibration within {within:.3 %} of {nominal:.6 rpm}; {share:.0f %} of"
                " the power about a harmonic lies on it",
                within=tracking.within,
                nominal=abs(tracking.nominal),
                share=tracking.share,
            )
        return said(
            "found in the vibration within {within:.3 %} of {nominal:.6 rpm}",
            within=tracking.within,
            nominal=abs(tracking.nominal),
        )
    if known.source == "channel":
        return said("from the channel {channel}", channel=known.channel)
    if known.source == "pulses":
        return said(
            "from the pulses of the channel {channel}, {pulses} per revolution",
            channel=known.channel,
            pulses=known.pulses or 1,
        )
    return {
        "given": said("as given"),
        "file": said("from the signal's file"),
        "case": said("from the case"),
    }[known.source]


def _signal(found: DiagnosisResult) -> str:
    signal, sizes = found.signal, found.indicators
    turns, unit = found.diagnosis.revolutions, _UNITS.get(signal.unit, signal.unit)
    write = manner()
    lines = [
        said(
            "{duration:.4 s} at {rate:.6 Hz}, {revolutions} revolutions",
            duration=found.duration,
            rate=signal.rate,
            revolutions=write.short(turns, 3) if turns < 100.0 else write.fixed(turns, 0),
        )
    ]
    if signal.duration < found.duration * (1.0 - 1e-9):
        lines.append(said("first {duration:.4 s}:", duration=signal.duration))
    lines.append(
        said(
            "RMS {rms}, crest factor {crest:.3}, kurtosis {kurtosis:.3} (3 for noise)",
            rms=f"{write.short(sizes.rms, 4)} {unit}".rstrip(),
            crest=sizes.crest,
            kurtosis=sizes.kurtosis,
        )
    )
    return "\n".join(lines)


def _search(found: DiagnosisResult) -> Iterable[str]:
    tolerance = found.settings.tolerance
    if found.frequencies.source == "loaded":
        yield said("cage within {tolerance:.3 %} of its speed under load", tolerance=tolerance)
    else:
        yield said("cage within {tolerance:.3 %} of its nominal speed", tolerance=tolerance)
    if found.slip is not None:
        yield said("wider than `slip`, to cover the range over the balls")
    yield said(
        "noise alone gives a finding in at most {alarm:.3 %} of records",
        alarm=found.settings.false_alarm,
    )


# --- the parts of the bearing ------------------------------------------------------------------


def _parts(diagnosis: Diagnosis) -> doc.Section:
    parts, element = diagnosis.components, diagnosis.element
    bands = [part.band or (None, None) for part in parts]
    columns = (
        doc.Column("", [part_name(part.component, element) for part in parts], "part"),
        doc.Column("", [ABBREVIATIONS[FAULTS[part.component]] for part in parts], "abbreviation"),
        doc.Column(
            said_in("frequency", "expected"),
            [part.nominal_order * diagnosis.shaft_frequency for part in parts],
            "expected",
            "Hz",
            form=".2f [Hz]",
        ),
        doc.Column(
            said_in("frequency", "found"),
            [part.frequency for part in parts],
            "found",
            "Hz",
            form=".2f [Hz]",
        ),
        doc.Column(
            said_in("column", "deviation"),
            [part.deviation for part in parts],
            "deviation",
            "%",
            form=".2f [%]",
        ),
        doc.Column(
            said_in("column", "depth"), [part.depth for part in parts], "depth", "%", form=".0f [%]"
        ),
        doc.Column(
            said_in("column", "evidence"), [part.evidence for part in parts], "evidence", form=".1f"
        ),
        doc.Column(
            said("verdict"),
            [_verdict_of(part) for part in parts],
            "verdict",
            tones=[_TONES[part.verdict] for part in parts],
        ),
        doc.Column(said("band"), [_band(part) for part in parts], "band", "kHz", align="right"),
        *(
            doc.Column(head, [band[place] for band in bands], key, "kHz", only_in_files=True)
            for place, (head, key) in enumerate(
                ((said("from"), "band_low"), (said("to"), "band_high"))
            )
        ),
    )
    table = doc.Table(columns, "parts", legends=tuple(_legend(diagnosis)))
    return doc.Section(said("Parts"), (table,), "parts")


def _verdict_of(part: ComponentVerdict) -> str:
    return {
        "fault": said_in("part", "damaged"),
        "undecided": said_in("part", "undecided"),
        "watch": (
            said_in("part", "watch") if part.depth >= DAMAGE else said_in("part", "weak peaks")
        ),
        "nothing_found": said_in("part", "nothing"),
        "not_tested": said_in("part", "not tested"),
    }[part.verdict]


def _band(part: ComponentVerdict) -> str:
    if part.band is None:
        return ABSENT
    return "–".join(manner().fixed(_KILO * edge, 2) for edge in part.band)


def _legend(diagnosis: Diagnosis) -> Iterable[str]:
    if not diagnosis.trials:
        return
    values = {
        "damage": DAMAGE,
        "severe": SEVERE,
        "trials": diagnosis.trials,
        "least": -log10(diagnosis.false_alarm),
    }
    if diagnosis.element == "ball":
        yield said(
            "Depth: swing of the squared envelope at that frequency over its mean; damage from"
            " {damage:.0f %}, severe from {severe:.0f %}. Evidence: −log10 of the probability that"
            " noise without such peaks gives them, all {trials} trials counted; a finding from"
            " {least:.3}. Healthy bearings have such peaks too: depth decides. Band: where it"
            " resonates most clearly. Ball: its damage strikes twice per revolution.",
            **values,
        )
    else:
        yield said(
            "Depth: swing of the squared envelope at that frequency over its mean; damage from"
            " {damage:.0f %}, severe from {severe:.0f %}. Evidence: −log10 of the probability that"
            " noise without such peaks gives them, all {trials} trials counted; a finding from"
            " {least:.3}. Healthy bearings have such peaks too: depth decides. Band: where it"
            " resonates most clearly. Roller: its damage strikes twice per revolution.",
            **values,
        )


def _why(diagnosis: Diagnosis) -> doc.Section:
    """Give the reasons, those of faults first; parts that have the same stand together."""
    unclear = ("nothing_found", "not_tested")
    parts = sorted(diagnosis.components, key=lambda part: part.verdict in unclear)
    by_reasons: dict[str, list[str]] = {}
    for part in parts:
        text = "\n".join(note.text for note in part.reasons)
        by_reasons.setdefault(text, []).append(part_name(part.component, diagnosis.element))
    blocks = [
        block
        for text, names in by_reasons.items()
        for block in (doc.Statement(", ".join(names), indent=2), doc.Statement(text, indent=4))
    ]
    return doc.Section(said("Why"), tuple(blocks), "why")


def _noted(found: DiagnosisResult) -> tuple[Note, ...]:
    return (*found.notes, *found.choices, *found.frequencies.notes)


def _notes(found: DiagnosisResult) -> list[doc.Section]:
    rest = [note for note in _noted(found) if not qualifies(note) or note.key in _OF_THE_SCALE]
    return notes_section(rest)


def _spectrum(diagnosis: Diagnosis) -> doc.Table:
    """Return the spectrum of the squared envelope in the band of each fault, for files."""
    spectra, places = diagnosis.spectra, diagnosis.bands_shown
    count = len(spectra.order)
    order = spectra.order.tolist() * len(places)
    above = np.concatenate([spectra.above_noise[place] for place in places])
    level = 10.0 * np.log10(above, out=np.full(above.shape, np.nan), where=above > 0.0)
    lows, highs = ([spectra.bands[p][end] for p in places for _ in range(count)] for end in (0, 1))
    return doc.Table(
        (
            doc.Column(said("band from"), lows, "band_low", "Hz"),
            doc.Column(said("band to"), highs, "band_high", "Hz"),
            doc.Column(said("order"), order, "order"),
            doc.Column(
                said("frequency"),
                [one * diagnosis.shaft_frequency for one in order],
                "frequency",
                "Hz",
            ),
            doc.Column(said("over noise"), level.tolist(), "over_noise", "dB"),
        ),
        "spectrum",
        caption=said("Spectrum of the squared envelope"),
        only_in_files=True,
    )


# --- pictures ----------------------------------------------------------------------------------


def _figures(found: DiagnosisResult) -> Iterable[doc.Figure]:
    fault = found.diagnosis.clearest_fault
    caption = said("The signal over time")
    if fault is not None:
        caption = said("The signal over time, with the impacts of the clearest fault")
    yield doc.Figure(
        caption, lambda: plots.impacts_figure(found.signal, found.diagnosis), "waveform"
    )
    yield doc.Figure(
        said("Kurtogram: how impulsive the signal is, by frequency and bandwidth"),
        lambda: plots.kurtogram_figure(found.signal, band=None if fault is None else fault.band),
        "kurtogram",
    )
    yield doc.Figure(
        said("Spectrum of the squared envelope, with the frequencies of the bearing"),
        lambda: plots.envelope_figure(found.diagnosis),
        "envelope",
    )
