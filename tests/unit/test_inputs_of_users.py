"""Inputs that users brought, whole, through the command line: each has one right answer.

Fifteen kinds: the door that read them wrongly or refused them was mended for the kind, of which
these are one or two each.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.io
from typer.testing import CliRunner

from rolamento.cli.app import app
from rolamento.units import to_si
from rolamento.vibration.reading import channels_of, open_signal
from rolamento.weibull import parse_life_test, read_life_test, read_trend

Run = Callable[..., tuple[int, str, str]]
RATE = 12_000


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)

    def runner(*arguments: str, lang: str = "en") -> tuple[int, str, str]:
        result = CliRunner().invoke(app, [*arguments, "--lang", lang], env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        squeezed = (" ".join(text.split()) for text in (result.stdout, result.stderr))
        return (result.exit_code, *squeezed)

    return runner


def _sine(number: int) -> list[float]:
    return [math.sin(2.0 * math.pi * 50.0 * i / RATE) for i in range(number)]


# --- 1: what says what failed ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "failed"),
    [
        ("T,E\n13467,0\n13760,1\n12011,0\n7798,0\n7928,0\n", 1),
        ("time,event_observed\n100,1\n150,1\n200,0\n250,1\n300,0\n", 3),
        ("time,delta\n100,1\n150,1\n200,0\n250,1\n300,0\n", 3),
        ("time,observed\n100,true\n150,true\n200,false\n250,true\n300,false\n", 3),
        ("Zeit;Ereignis\n100,5;1\n150;1\n200;0\n", 2),
        ("tempo;falha\n100,5;S\n150;N\n200;S\n", 2),
    ],
)
def test_a_column_of_one_and_nought_says_what_failed(text: str, failed: int) -> None:
    assert parse_life_test(text).failures == failed


@pytest.mark.parametrize(
    ("text", "column"),
    [
        ("time,c\n100,1\n150,1\n200,0\n", "c"),
        ("time,cens\n100,1\n150,1\n200,0\n", "cens"),
        ("time,flag\n100,1\n150,1\n200,0\n", "flag"),
        ("time,ended\n100,well\n150,badly\n200,well\n", "ended"),
        ("time,how\n100,pulled\n150,\n200,\n", "how"),
        ("time,remark\n100,failed\n150,suspended\n", "remark"),
    ],
)
def test_what_may_say_what_failed_is_asked_about(run: Run, text: str, column: str) -> None:
    Path("a.csv").write_text(text, encoding="utf-8")
    code, out, complaint = run("weibull", "a.csv")
    assert code == 2
    assert not out
    assert f"{column}: " in complaint
    assert "--status-column" in complaint
    code, out, _ = run("weibull", "a.csv", "--ignore-column", column)
    assert code in (0, 1)
    assert "bearings, " in out


def test_a_blank_failure_mode_is_asked_about(run: Run) -> None:
    """The column is read as modes by its name: what it lacks is a word, not an option."""
    Path("a.csv").write_text("time,failure mode\n100,spall\n150,cage\n200,\n", encoding="utf-8")
    code, out, complaint = run("weibull", "a.csv")
    assert (code, out) == (2, "")
    assert "a.csv, line 4: failure mode: is blank, and no column says what failed" in complaint
    assert "(example: suspended)" in complaint
    code, out, _ = run("weibull", "a.csv", "--ignore-column", "failure mode")
    assert code in (0, 1)
    assert "3 bearings, " in out


def test_what_cannot_say_what_failed_is_passed_over() -> None:
    test = parse_life_test("time,rig,load kN,colour\n100,1,5,red\n150,2,10,blue\n200,3,5,green\n")
    assert test.failures == 3
    assert test.passed_over == ("load kN", "colour")


def test_s_and_n_in_a_status_are_asked_about(run: Run) -> None:
    Path("a.csv").write_text("tempo;evento\n100;S\n150;N\n200;S\n", encoding="utf-8")
    code, _, complaint = run("weibull", "a.csv", lang="pt")
    assert code == 2
    assert "evento" in complaint


# --- 2, 9: units and names of times ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("heading", "scale"),
    [
        ("Time (µs)", 1e6),  # U+00B5
        ("Time (μs)", 1e6),  # U+03BC
        ("Time [μs]", 1e6),
        ("Time (us)", 1e6),
        ("time_ms", 1e3),
        ("t_ms", 1e3),
        ("time_us", 1e6),
        ("Elapsed time", 1.0),
        ("sec", 1.0),
        ("Time_sec", 1.0),
        ("Rel. time [s]", 1.0),
        ("x-axis (s)", 1.0),
        ("Time (milliseconds)", 1e3),
        ("Time (minutes)", 1.0 / 60.0),
        ("Time in ms", 1e3),
        ("Time_s", 1.0),
        ("time/s", 1.0),
        ("Seconds", 1.0),
        ("T(s)", 1.0),
        ("Time, s", 1.0),
        ("Zeit [ms]", 1e3),
        ("Tempo (segundos)", 1.0),
        ("Tiempo (ms)", 1e3),
    ],
)
def test_columns_of_times(tmp_path: Path, heading: str, scale: float) -> None:
    path = tmp_path / "a.csv"
    rows = [f"{i * scale / RATE:.9f};{x:.5f}" for i, x in enumerate(_sine(200))]
    path.write_text(f"{heading};acc (g)\n" + "\n".join(rows) + "\n", encoding="utf-8")
    with open_signal(path) as source:
        assert source.rate == pytest.approx(RATE, rel=1e-4)
        assert [channel.name for channel in source.channels] == ["acc"]


@pytest.mark.parametrize("heading", ["Time (parsecs)", "Time [foo]", "time (m)"])
def test_seconds_are_not_assumed_over_another_unit(tmp_path: Path, heading: str) -> None:
    path = tmp_path / "a.csv"
    rows = [f"{i / RATE:.9f};{x:.5f}" for i, x in enumerate(_sine(200))]
    path.write_text(f"{heading};acc (g)\n" + "\n".join(rows) + "\n", encoding="utf-8")
    assert {channel.rate for channel in channels_of(path)} == {None}


def test_a_channel_that_does_not_rise_evenly_is_no_time(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    rows = [f"{x:.5f};{i}" for i, x in enumerate(_sine(200))]
    path.write_text("response time (ms);n\n" + "\n".join(rows) + "\n", encoding="utf-8")
    assert [channel.name for channel in channels_of(path)] == ["response time", "n"]


@pytest.mark.parametrize(
    ("heading", "unit"),
    [
        ("Failure Time", "h"),
        ("failure time (h)", "h"),
        ("Failure times", "h"),
        ("Cycles to failure", "h"),
        ("Age at failure", "h"),
        ("Ausfallzeit (h)", "h"),
        ("Horas hasta fallo", "h"),
    ],
)
def test_columns_of_lives(heading: str, unit: str) -> None:
    test = parse_life_test(f"{heading};n\n100;1\n150;1\n")
    assert test.times.tolist() == [100.0, 150.0]
    assert test.unit == unit


# --- 3: a rate that is absurdly low ---------------------------------------------------------------


@pytest.mark.parametrize("rate", ["0.01", "0.1", "100"])
def test_a_rate_below_the_fault_frequencies_is_one_sentence(run: Run, rate: str) -> None:
    Path("a.csv").write_text("acc (g)\n" + "\n".join(f"{x:.5f}" for x in _sine(4000)) + "\n")
    code, _, complaint = run(
        "diagnose", "a.csv", "--bearing", "6205", "--speed", "1797 rpm", "--rate", rate
    )
    assert code == 2
    assert "is too low" in complaint
    assert "162.4 times a second" in complaint  # BPFI of 6205 at 29.95 Hz: 5.42 turns


# --- 4, 5: moments --------------------------------------------------------------------------------


def test_the_time_of_day_counts(run: Run) -> None:
    rows = "".join(f"2024-01-01 08:{10 * i:02}:00,{1.0 + 0.2 * i:.1f}\n" for i in range(5))
    Path("t.csv").write_text(f"timestamp,velocity (mm/s)\n{rows}")
    assert run("trend", "t.csv", "--limit", "4.5", "--json", "t.json")[0] == 0
    told = json.loads(Path("t.json").read_text())
    assert [row["time"] for row in told["rows"]] == pytest.approx([i / 144.0 for i in range(5)])
    found = told["limits"][0]
    linear = found["laws"][0]
    assert linear["slope"] == pytest.approx(28.8)
    assert linear["crossing"]["time"] * 24.0 == pytest.approx(2.9167, abs=1e-3)


@pytest.mark.parametrize(
    "text",
    [
        "Date,Time,Velocity (mm/s)\n2024-01-01,08:00:00,1.0\n2024-01-01,20:00:00,1.2\n",
        "Datum;Uhrzeit;Schwinggeschwindigkeit (mm/s)\n01.01.2024;08:00;1,0\n01.01.2024;20:00;1,2\n",
        "Data;Hora do dia;Velocidade (mm/s)\n01/01/2024;8h00;1,0\n01/01/2024;20h00;1,2\n",
        "timestamp,velocity (mm/s)\n2024-01-01T08:00:00+02:00,1.0\n2024-01-01T19:00:00+01:00,1.2\n",
        "date,velocity (mm/s)\n1 Jan 2024 8:00 AM,1.0\n1 Jan 2024 8:00 PM,1.2\n",
    ],
)
def test_a_day_and_a_time_of_day_are_a_moment(tmp_path: Path, text: str) -> None:
    path = tmp_path / "d.csv"
    path.write_text(text, encoding="utf-8")
    assert read_trend(path).times.tolist() == [0.0, 0.5]


def test_times_of_day_alone_say_what_is_missing(run: Run) -> None:
    Path("d.csv").write_text("Time,Velocity (mm/s)\n08:00:00,1.0\n09:00:00,1.2\n")
    code, _, complaint = run("trend", "d.csv")
    assert code == 2
    assert "times of day" in complaint


def test_days_come_first_where_the_language_says_so(run: Run) -> None:
    Path("d.csv").write_text("date,velocity (mm/s)\n01/02/2024,1.0\n01/03/2024,1.2\n")
    code, _, complaint = run("trend", "d.csv")
    assert code == 2
    assert "--date-order day_first" in complaint
    code, out, _ = run("trend", "d.csv", lang="pt")
    assert code == 0
    assert "2024-02-01" in out
    assert "dia primeiro" in out


# --- 6, 15: files of other programs ---------------------------------------------------------------


def test_structures_of_several_elements(tmp_path: Path) -> None:
    kind = np.dtype([("Name", object), ("Data", object)])
    samples = np.random.default_rng(1).normal(size=64_000)
    y = np.array([[("speed", np.full(4000, 1500.0)), ("vibration_1", samples)]], dtype=kind)
    path = tmp_path / "N15_M07_F10_K001_1.mat"
    scipy.io.savemat(path, {"N15_M07_F10_K001_1": {"Y": y}})
    with open_signal(path, channel="Y.vibration_1", rate=64_000.0, unit="g") as source:
        assert source.length == 64_000
        assert source.read(0, 5).samples == pytest.approx(9.80665 * samples[:5])


def test_a_matlab_file_without_numbers_says_what_it_holds(run: Run) -> None:
    scipy.io.savemat("a.mat", {"who": "me", "z": np.array([1.0 + 2.0j, 3.0])})
    code, _, complaint = run("severity", "a.mat")
    assert code == 2
    assert "who: text" in complaint
    assert "z: complex numbers" in complaint


PSD = """\
    -1
    58
PSD
NONE
13-Apr-23 09:57:51
NONE
NONE
    9         0    0         0 Pilot              0   0 NONE               0   0
         2         6         1  0.00000E+00  1.00000E+00  0.00000E+00
        18    0    0    0 Frequency            Hz
         0    0    0    0 PSD                  g^2/Hz
         0    0    0    0 NONE                 NONE
         0    0    0    0 NONE                 NONE
  1.00000E-07  1.20000E-06  4.30000E-07  3.80000E-06  4.70000E-05  1.20000E-04
    -1
"""


def test_spectra_are_called_spectra(run: Run) -> None:
    Path("psd.uff").write_text(PSD)
    code, _, complaint = run("severity", "psd.uff")
    assert code == 2
    assert "holds power spectral densities; a record over time is needed" in complaint


def test_tdms(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    path = tmp_path / "a.tdms"
    samples = np.array(_sine(1000))
    with nptdms.TdmsWriter(path) as writer:
        about = {"wf_increment": 1.0 / RATE, "unit_string": "g"}
        writer.write_segment([nptdms.ChannelObject("Motor", "DE", samples, properties=about)])
    with open_signal(path) as source:
        assert source.rate == pytest.approx(RATE)
        assert source.read(0, 10).samples == pytest.approx(9.80665 * samples[:10])


def test_tdms_without_its_library_says_what_to_do(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("a.tdms").write_bytes(b"TDSm" + bytes(100))
    monkeypatch.setattr("rolamento.vibration.reading.arrays.find_spec", lambda _: None)
    code, _, complaint = run("severity", "a.tdms")
    assert code == 2
    assert "is a TDMS file" in complaint
    assert "pip install rolamento[tdms]" in complaint


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("gearbox.rexs", '<?xml version="1.0"?>\n<model version="1.4"><relations/></model>\n'),
        ("gearbox.rexsj", '{"model": {"version": "1.4", "components": []}}\n'),
    ],
)
def test_rexs_is_called_rexs(run: Run, name: str, text: str) -> None:
    Path(name).write_text(text)
    code, _, complaint = run("solve", name)
    assert code == 2
    assert "is a REXS model" in complaint


# --- 7, 8: text of recorders ----------------------------------------------------------------------


def test_text_goes_by_its_bytes(run: Run) -> None:
    rows = np.random.default_rng(0).normal(size=(2000, 8))
    text = "\n".join("\t".join(f"{x:.3f}" for x in row) for row in rows)
    Path("2003.10.22.12.06.24").write_text(text + "\n")
    assert len(channels_of("2003.10.22.12.06.24")) == 8
    Path("letter").write_text("Dear Sir,\nthe bearing is worn.\n")
    code, _, complaint = run("severity", "letter")
    assert code == 2
    assert "is not of a format that can be read" in complaint


LABVIEW = """\
LabVIEW Measurement\t
Separator\tTab
Decimal_Separator\t.
X_Columns\tNo
***End_of_Header***\t
\t
Channels\t1\t
Samples\t24000
Y_Unit_Label\tg
X0\t0.0
Delta_X\t8.333333E-5
***End_of_Header***\t
X_Value\tAcceleration_0\tComment
"""


def test_a_file_of_labview(run: Run) -> None:
    Path("run.txt").write_text(LABVIEW + "".join(f"\t{x:.5f}\n" for x in _sine(24_000)))
    (channel,) = channels_of("run.txt")
    assert channel.name == "Acceleration_0"
    assert channel.unit == "g"
    assert channel.rate == pytest.approx(RATE, rel=1e-6)
    assert run("severity", "run.txt", "--unit", "g")[0] == 0


@pytest.mark.parametrize(
    ("line", "rate"),
    [
        ("dt = 0.1 ms", 1e4),
        ("%Rate = 10000 samples/sec", 1e4),
        ("Sampling rate: 10 kS/s", 1e4),
        ("Scan rate: 10000", 1e4),
        ("Taxa de aquisição: 10000", 1e4),
        ("Abtastrate;10000", 1e4),
        ("Frecuencia de muestreo: 10 kHz", 1e4),
        ('"Sample Interval","1.0E-04"', 1e4),
        ("Delta_X\t1E-4", 1e4),
    ],
)
def test_words_of_recorders(tmp_path: Path, line: str, rate: float) -> None:
    path = tmp_path / "a.txt"
    rows = "".join(f"{x:.5f};{x:.4f}\n" for x in _sine(100))
    path.write_text(f"{line}\nacc (g);b (g)\n{rows}", encoding="utf-8")
    assert [channel.rate for channel in channels_of(path)] == pytest.approx([rate, rate])


# --- 10, 11, 12: forms of tables ------------------------------------------------------------------


def test_what_a_spreadsheet_puts_first(tmp_path: Path) -> None:
    path = tmp_path / "s.csv"
    path.write_bytes(b"\xef\xbb\xbfsep=;\ntempo;status\n100,5;falhou\n200;falhou\n300;suspenso\n")
    test = read_life_test(path)
    assert test.times.tolist() == [100.5, 200.0, 300.0]
    assert test.failures == 2


def test_blanks_part_cells() -> None:
    test = parse_life_test("t status\n35 0\n34 1\n50 1\n60 1\n")
    assert test.times.tolist() == [35.0, 34.0, 50.0, 60.0]
    assert test.failures == 3


@pytest.mark.parametrize("end", ["", "inf", "∞", "-"])
@pytest.mark.parametrize("names", ["lower,upper", "start,end", "left,right"])
def test_inspections_with_an_open_end(run: Run, names: str, end: str) -> None:
    rows = f"0,10,50\n11,20,25\n21,25,15\n26,30,9\n31,{end},1\n"
    Path("i.csv").write_text(f"{names},count\n{rows}", encoding="utf-8")
    code, out, _ = run("weibull", "i.csv")
    assert code == 0
    assert "100 bearings, 99 failed, 1 suspended" in out
    assert "maximum likelihood 1.441 14.05" in out  # as another program prints


# --- 13: units of name plates ---------------------------------------------------------------------

SPEED = 188.49555921538757


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        *((f"1800 {u}", "angular_speed", SPEED) for u in (
            "1/min", "min^-1", "min⁻¹", "RPM", "U/min", "rot/min", "r/min", "min-1")),
        *((f"30 {u}", "angular_speed", SPEED) for u in ("Hz", "hz", "rps", "r/s", "U/s")),
        ("1 KN", "force", 1000.0),
        ("100 kp", "force", 980.665),
        ("10 daN", "force", 100.0),
        ("10 N-m", "moment", 10.0),
        ("88 in-lb", "moment", 9.942664954430269),
        ("70 ºC", "temperature", 343.15),
        ("70 C", "temperature", 343.15),
        ("70 °C", "temperature", 343.15),
        ("45 KW", "power", 45e3),
        ("1 gpa", "stress", 1e9),
    ],
)  # fmt: skip
def test_units_of_name_plates(text: str, dimension: str, value: float) -> None:
    assert to_si(text, dimension) == pytest.approx(value, rel=1e-12)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("text", "dimension"),
    [("30 1/s", "angular_speed"), ("1 MPA", "stress"), ("1 mn", "force"), ("1 Kn m²", "force")],
)
def test_units_with_two_meanings_are_refused(text: str, dimension: str) -> None:
    with pytest.raises(ValueError, match="unit"):
        to_si(text, dimension)  # type: ignore[arg-type]


def test_decimal_commas_in_options(run: Run) -> None:
    given = ("solve", "6205", "--fr", "1,5 kN", "--speed", "1500 1/min")
    assert run(*given, "--json", "a.json", lang="pt")[0] == 0
    assert json.loads(Path("a.json").read_text())["case"]["duty"]["load"]["fz"] == "1.5 kN"
    code, _, complaint = run(*given)
    assert code == 2
    assert "decimal point" in complaint
    commas = ("life", "6205", "--fr", "1,5 kN", "--speed", "30 Hz", "--reliability", "0,95")
    assert run(*commas, "--json", "b.json", lang="pt")[0] == 0
    assert json.loads(Path("b.json").read_text())["case"]["life"]["reliability"] == 0.95


# --- 14: a catalogue of one's own -----------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "Designation,Type,d,D,B,Dynamic_Load_C_kN,Static_Load_C0_kN\nX6205,ball,25,52,15,14,7.85\n",
        "designation;d (mm);D (mm);B (mm);C [kN];C0 [kN]\nX6205;25;52;15;14;7,85\n",
        "DESIGNATION,d_mm,D_mm,b_mm,c_n,c0_n\nX6205,25,52,15,14000,7850\n",
        "# units: mm, kN\nBearing,d,D,B,C,C0\nX6205,25,52,15,14,7.85\n",
        "Rolamento;d;D;B;C;C0\n;mm;mm;mm;kN;kN\nX6205;25;52;15;14;7,85\n",
        "sep=;\nBezeichnung;Bohrung d;Aussendurchmesser D;Breite B;Tragzahl dynamisch C (kN);"
        "Tragzahl statisch C0 (kN)\nX6205;25;52;15;14;7,85\n",
    ],
)
def test_a_catalogue_with_the_usual_headings(run: Run, text: str) -> None:
    Path("o.csv").write_text(text, encoding="utf-8")
    code, out, complaint = run("catalogue", "show", "X6205", "--catalogue", "o.csv")
    assert code == 0, complaint
    for figure in ("bore d 25 mm", "outside diameter D 52 mm", "width B 15 mm"):
        assert figure in out
    assert "rating C 14 000 N" in out
    assert "rating C_0 7850 N" in out


@pytest.mark.parametrize(
    ("header", "complaint"),
    [
        ("Designation,D,D,B", "occurs twice"),
        ("Designation,d,d,B", "occurs twice"),
        ("Designation,d,D,C", "needs its unit"),
        ("Designation,d (kN),D,B", "has a unit of another quantity"),
        ("Designation,d,D,heft", "is an unknown column"),
    ],
)
def test_headings_that_are_refused(run: Run, header: str, complaint: str) -> None:
    Path("o.csv").write_text(f"{header}\nX6205,25,52,15\n")
    code, _, said = run("catalogue", "show", "X6205", "--catalogue", "o.csv")
    assert code == 2
    assert complaint in said


# --- a spectrum as people write it ----------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "share,duty.inner_speed,duty.load.fx,duty.load.fz\n0.3,1500 rpm,500 N,3 kN\n"
        "0.7,1000 rpm,200 N,2 kN\n",
        "Share;Speed (rpm);Fx (kN);Fz (kN)\n30 %;1500;0,5;3\n70 %;1000;0,2;2\n",
        "Share (%),n (1/min),Fa (N),Fr (kN)\n30,1500,500,3\n70,1000,200,2\n",
        "Duration (h),Speed (min⁻¹),Fa (kN),Fr (kN)\n300,1500,0.5,3\n700,1000,0.2,2\n",
        "Parcela do tempo;Rotação (rpm);Fa (kN);Fr (kN)\n0,3;1500;0,5;3\n0,7;1000;0,2;2\n",
    ],
)
def test_headings_of_spectra(tmp_path: Path, text: str) -> None:
    from rolamento.tasks.life_spectrum import read_spectrum

    path = tmp_path / "s.csv"
    path.write_text(text, encoding="utf-8")
    steps = read_spectrum(path)
    assert steps.shares == pytest.approx([0.3, 0.7])
    assert steps.values["duty.inner_speed"] == pytest.approx(
        (157.07963267948966, 104.71975511965977)
    )
    assert steps.values["duty.load.fx"] == (500.0, 200.0)
    assert steps.values["duty.load.fz"] == (3000.0, 2000.0)


def test_several_bearings_under_one_spectrum(run: Run) -> None:
    Path("s.csv").write_text(
        "Share;Speed (rpm);Fx (kN);Fz (kN)\n30 %;1500;0,5;3\n70 %;1000;0,2;2\n"
    )
    given = ("--fr", "3 kN", "--speed", "1000 rpm", "--spectrum", "s.csv")
    alone = []
    for name in ("6310", "6309"):
        assert run("life", name, *given, "--json", "a.json")[0] == 0
        alone.append(json.loads(Path("a.json").read_text())["headline"]["hours"])
    code, out, _ = run("life", "6310", "6309", *given)
    assert code == 0
    assert "the 2 bearings together reach" in out
    assert run("life", "6310", "6309", *given, "--json", "b.json")[0] == 0
    together = json.loads(Path("b.json").read_text())["together"]["hours"]
    slope = 10.0 / 9.0  # of balls; Lundberg and Palmgren 1947
    assert together == pytest.approx(sum(one**-slope for one in alone) ** (-1.0 / slope))
