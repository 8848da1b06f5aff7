"""Headers of recorders and spreadsheets in their forms, in English, Portuguese, German and Spanish.

The files are made here, after the forms that the programs write; each holds the same sine at the
same rate, which has to come out with its unit.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
import pytest

from rolamento.vibration.reading import open_signal

RATE: Final = 12_000
COUNT: Final = 400
SINE: Final = np.round(np.sin(2.0 * np.pi * 50.0 * np.arange(COUNT) / RATE), 5)
GRAVITY: Final = 9.80665


@dataclass(frozen=True)
class Words:
    """What a language calls what stands in headers, and how it writes numbers."""

    time: str
    acceleration: str
    rate: str
    interval: str
    unit: str
    title: str
    date: str
    clock: str
    comment: str
    comma: bool
    day: str

    def number(self, value: float, form: str = ".5f") -> str:
        text = format(value, form)
        return text.replace(".", ",") if self.comma else text

    @property
    def separator(self) -> str:
        return ";" if self.comma else ","


LANGUAGES: Final = {
    "en": Words("Time", "Acceleration", "Sampling rate", "Sample interval", "Unit",
                "Motor 7, drive end", "Date", "Time of day", "Comment", False, "2024-02-29"),
    "pt": Words("Tempo", "Aceleração", "Taxa de amostragem", "Intervalo de amostragem", "Unidade",
                "Motor 7, lado do acoplamento", "Data", "Hora do dia", "Comentário", True,
                "29/02/2024"),
    "de": Words("Zeit", "Beschleunigung", "Abtastrate", "Abtastintervall", "Einheit",
                "Motor 7, Antriebsseite", "Datum", "Uhrzeit", "Kommentar", True, "29.02.2024"),
    "es": Words("Tiempo", "Aceleración", "Frecuencia de muestreo", "Intervalo de muestreo",
                "Unidad", "Motor 7, lado de accionamiento", "Fecha", "Hora del día", "Comentario",
                True, "29/02/2024"),
}  # fmt: skip


def _rows(words: Words, separator: str, scale: float = 1.0, form: str = ".9f") -> str:
    return "".join(
        f"{words.number(scale * i / RATE, form)}{separator}{words.number(x)}\n"
        for i, x in enumerate(SINE)
    )


def spreadsheet(w: Words) -> str:
    s = w.separator
    return f"{w.time} (s){s}{w.acceleration} (g)\n" + _rows(w, s)


def spreadsheet_with_separator(w: Words) -> str:
    return f"sep=;\n{w.time} [ms];{w.acceleration} [g]\n" + _rows(w, ";", 1e3, ".6f")


def spreadsheet_with_titles(w: Words) -> str:
    s = w.separator
    title = f'"{w.title}"' if s in w.title else w.title
    return f"{title}{s}\n{s}\n{w.date}: {w.day}{s}\n{s}\n{w.time} (s){s}{w.acceleration} (g)\n" + (
        _rows(w, s)
    )


def units_below(w: Words) -> str:
    s = w.separator
    return f"{w.time}{s}{w.acceleration}\nµs{s}g\n" + _rows(w, s, 1e6, ".3f")


def units_in_brackets_below(w: Words) -> str:
    return f"{w.time}\t{w.acceleration}\n[ms]\t[g]\n" + _rows(w, "\t", 1e3, ".6f")


def unicode_text(w: Words) -> str:
    return f"{w.time} (µs)\t{w.acceleration} (g)\n" + _rows(w, "\t", 1e6, ".3f")


def labview_without_times(w: Words) -> str:
    mark = "," if w.comma else "."
    head = (
        f"LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t{mark}\n"
        "Multi_Headings\tNo\nX_Columns\tNo\nTime_Pref\tRelative\nDate\t2024/02/29\n"
        f"Time\t08:00:00{mark}5\n***End_of_Header***\t\n\t\nChannels\t1\t\nSamples\t{COUNT}\t\n"
        f"Y_Unit_Label\tg\t\nX_Dimension\tTime\t\nX0\t{w.number(0.0)}\t\n"
        f"Delta_X\t{w.number(1.0 / RATE, '.9E')}\t\n***End_of_Header***\t\t\n"
        f"X_Value\t{w.acceleration}\tComment\n"
    )
    return head + "".join(f"\t{w.number(x)}\n" for x in SINE)


def labview_with_times(w: Words) -> str:
    head = (
        "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tOne\n***End_of_Header***\t\n\t\n"
        f"Channels\t1\t\nSamples\t{COUNT}\t\nY_Unit_Label\tg\t\n"
        f"Delta_X\t{w.number(1.0 / RATE, '.9E')}\t\n***End_of_Header***\t\t\n"
        f"X_Value\t{w.acceleration}\tComment\n"
    )
    return head + _rows(w, "\t")


def catman(w: Words) -> str:
    return (
        f"HBM_CATMAN_DATAFILE_40\n{w.title}\nT0 = {w.day} 08:00:00\n\n"
        f"{w.time}  1 - default sample rate\t{w.acceleration}\ns\tg\n" + _rows(w, "\t")
    )


def dewesoft(w: Words) -> str:
    return (
        f"Data info\nFile name: test.dxd\n{w.rate}: {RATE} Hz\nNumber of ch: 1\n\nData1\n"
        f"{w.time} (s);{w.acceleration} (g)\n" + _rows(w, ";")
    )


def simcenter(w: Words) -> str:
    return (
        f"{w.title}\nTime record, Real\nX increment: {w.number(1.0 / RATE, '.9f')} s\n"
        f"Number of values: {COUNT}\n{w.unit}: g\n{w.acceleration}\n"
        + "".join(f"{w.number(x)}\n" for x in SINE)
    )


def picoscope(w: Words) -> str:
    s = w.separator
    return f"{w.time}{s}{w.acceleration}\n(ms){s}(g)\n\n" + _rows(w, s, 1e3, ".6f")


def tektronix(w: Words) -> str:
    head = (
        "Model,MDO3024\nFirmware Version,1.26\n\nWaveform Type,ANALOG\nPoint Format,Y\n"
        "Horizontal Units,s\nHorizontal Scale,0.004\nSample Interval,8.33333333e-05\n"
        f"Record Length,{COUNT}\nVertical Units,g\nVertical Scale,0.5\nLabel,{w.acceleration}\n"
        "TIME,CH1\n"
    )
    return head + "".join(f"{i / RATE:.9e},{x:.5f}\n" for i, x in enumerate(SINE))


def tektronix_beside(w: Words) -> str:
    labels = [
        f"Record Length,{COUNT:.6e}", "Sample Interval,8.33333333e-05", "Trigger Point,2.0e+02",
        "Source,CH1", "Vertical Units,g", "Vertical Scale,5.0e-01", f"Note,{w.acceleration}",
    ]  # fmt: skip
    labels += [","] * (COUNT - len(labels))
    return "".join(
        f"{label},,{i / RATE:.9f},{x:.5f},\n"
        for i, (label, x) in enumerate(zip(labels, SINE, strict=True))
    )


def only_a_rate(w: Words) -> str:
    return f"{w.title}\n{w.rate}: 12 kHz\n{w.acceleration} (g)\n" + "".join(
        f"{w.number(x)}\n" for x in SINE
    )


def only_an_interval(w: Words) -> str:
    interval = w.number(1e6 / RATE, ".6f")
    return f"{w.interval} = {interval} µs\n{w.acceleration} [g]\n" + "".join(
        f"{w.number(x)}\n" for x in SINE
    )


def samples_a_second(w: Words) -> str:
    return f"% Rate = {RATE} samples/sec\n{w.unit}: g\n{w.acceleration}\n" + "".join(
        f"{w.number(x)}\n" for x in SINE
    )


def stamps(w: Words) -> str:
    return f"{w.date};{w.clock};{w.acceleration} (g)\n" + "".join(
        f"{w.day};08:00:{w.number(i / RATE, '09.6f')};{w.number(x)}\n" for i, x in enumerate(SINE)
    )


def blanks(w: Words) -> str:
    name = "".join(c for c in w.acceleration if c.isascii())
    return f"# {w.time}_ms   {name}(g)\n" + "".join(
        f"  {w.number(1e3 * i / RATE, '.6f'):>12}  {w.number(x):>10}\n" for i, x in enumerate(SINE)
    )


FORMS: Final[tuple[Callable[[Words], str], ...]] = (
    spreadsheet, spreadsheet_with_separator, spreadsheet_with_titles, units_below,
    units_in_brackets_below, unicode_text, labview_without_times, labview_with_times, catman,
    dewesoft, simcenter, picoscope, tektronix, tektronix_beside, only_a_rate, only_an_interval,
    samples_a_second, stamps, blanks,
)  # fmt: skip
ENCODINGS: Final = {unicode_text: "utf-16", catman: "cp1252", spreadsheet: "utf-8-sig"}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.__name__)
def test_headers(tmp_path: Path, form: Callable[[Words], str], language: str) -> None:
    path = tmp_path / "record"
    encoding = ENCODINGS.get(form, "utf-8")
    path.write_bytes(form(LANGUAGES[language]).encode(encoding))
    with open_signal(path) as source:
        assert source.rate == pytest.approx(RATE, rel=1e-3)
        assert source.channel.unit == "g"
        assert source.length == COUNT
        assert source.read().samples == pytest.approx(GRAVITY * SINE, abs=1e-9)


def test_there_are_sixty() -> None:
    assert len(FORMS) * len(LANGUAGES) >= 60


@pytest.mark.parametrize("rows", [3, 40])
def test_decimal_commas_without_a_name_are_asked_about(tmp_path: Path, rows: int) -> None:
    path = tmp_path / "a.csv"
    path.write_text("".join(f"{0.1 + 0.001 * i:.5f}\n".replace(".", ",") for i in range(rows)))
    with pytest.raises(ValueError, match="one channel with decimal commas, or two channels"):
        open_signal(path, rate=1e3, unit="g")
    with open_signal(path, rate=1e3, unit="g", decimal_mark="comma") as source:
        assert source.read().samples[0] == pytest.approx(0.1 * GRAVITY)
    assert math.isclose(source.rate, 1e3)
