"""A diagnosis for programs: JSON in SI units and Hz, and the envelope's spectrum as CSV."""

from __future__ import annotations

import csv
from dataclasses import asdict
from io import StringIO
from math import nan
from typing import Any, Final

import numpy as np

from rolamento.report.diagnosis_result import DiagnosisResult, ShaftSpeed
from rolamento.report.diagnosis_sentences import said_advice, said_own_note, said_result
from rolamento.report.plain_data import csv_number, json_text

__all__ = ["CSV_COLUMNS", "diagnosis_csv", "diagnosis_json"]

SCHEMA: Final = 1

CSV_COLUMNS: Final = ("band_low_Hz", "band_high_Hz", "order", "frequency_Hz", "over_noise_dB")
"""The header of the envelope's spectrum: one line of it in a row."""


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
            "speed": None if found.speed is None else _speed(found.speed),
            "revolutions": diagnosis.revolutions,
            "blocks": diagnosis.blocks,
            "order_resolution": diagnosis.resolution,
            "bearing": found.bearing_name,
            "frequencies": found.frequencies.to_mapping(),
            "state": None if found.state is None else asdict(found.state.status),
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


def _speed(speed: ShaftSpeed) -> dict[str, Any]:
    """Give the speed of the shaft, in rad/s."""
    return {
        "source": speed.source,
        "mean": speed.mean,
        "minimum": speed.least,
        "maximum": speed.most,
        "channel": speed.channel or None,
        "pulses_per_revolution": speed.pulses,
        "tracking": None if speed.tracking is None else asdict(speed.tracking),
    }


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
