"""`rolamento frequencies`: what is printed, what is written, how it ends."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from rolamento import Bearing, load_case
from rolamento.cli.app import app as program
from rolamento.cli.requested import program_of
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.pages.frequencies import frequencies_page
from rolamento.solution import solve
from rolamento.tasks.frequencies import FrequencyResult
from rolamento.vibration.frequencies import (
    FAULTS,
    LINES,
    frequencies_of,
    nominal_frequencies,
)
from rolamento.words import languages, speaking

app = program_of("running:FrequenciesRequest", "frequencies")

CASE = """
title = "6205 of a fan"

[bearing]
designation = "6205"

[duty]
inner_speed = "1797 rpm"

[duty.load]
fz = "1 kN"
fx = "0.5 kN"
"""


@pytest.fixture
def fan(tmp_path: Path) -> str:
    path = tmp_path / "fan.toml"
    path.write_text(CASE, "utf-8")
    return str(path)


def run(*arguments: str, given: str | None = None) -> Result:
    return CliRunner().invoke(app, [*arguments, "--lang", "en"], input=given)


def test_of_a_designation() -> None:
    result = run("6205", "--speed", "1797 rpm")
    assert result.exit_code == 0
    for line in (
        r"9 balls of 7\.9375 mm, pitch diameter 38\.731 mm; contact angle 0°",
        r"inner ring 1797 rpm; shaft 29\.95 Hz",
        r"outer race +BPFO +3\.5778 +107\.154 +3\.5668 +3\.6013 +106\.826 +107\.859",
        r"inner race +BPFI +1× +132\.45 +162\.40 +192\.35",
        r"Other geometries that the ratings allow",
    ):
        assert re.search(line, result.stdout), line
    assert "Under load" not in result.stdout
    assert "given by its clearance" in result.stdout


def test_without_a_speed_there_are_orders() -> None:
    result = run("6205", "--harmonics", "1", "--sidebands", "0")
    assert result.exit_code == 0
    assert "no speed given" in result.stdout
    assert re.search(r"cage +FTF +0\.3975 +– +", result.stdout)
    assert "by the geometry (orders)" in result.stdout


def test_both_rings_and_slip() -> None:
    result = run("6205", "--speed", "1000 rpm", "--outer-speed", "-500 rpm", "--slip", "0.02")
    assert "inner ring 1000 rpm; outer ring −500 rpm" in result.stdout
    assert "lags behind the outer ring by 2 %" in result.stdout
    found = nominal_frequencies(Bearing.named("6205"), 1000 / 9.5493, -500 / 9.5493, slip=0.02)
    assert f"{found.ball_pass_outer.order:.4f}" in result.stdout


def test_only_the_outer_ring() -> None:
    result = run("6205", "--outer-speed", "600 rpm")
    assert "outer ring 600 rpm; shaft 10 Hz" in result.stdout
    assert re.search(r"outer race +BPFO +1× +25\.78 +35\.78 +45\.78", result.stdout)


def test_of_a_case_with_load(fan: str) -> None:
    result = run(fan)
    assert result.exit_code == 0
    assert "6205 of a fan" in result.stdout
    assert "By the geometry" in result.stdout
    assert re.search(r"Under load \(contact angle \d+\.\d+ / \d+\.\d+°\)", result.stdout)
    loaded = frequencies_of(solve(load_case(fan)))
    assert re.search(rf"outer race +BPFO +{loaded.ball_pass_outer.order:.4f}", result.stdout)
    assert "Harmonics and sidebands under load" in result.stdout


def test_the_speed_goes_over_the_case(fan: str) -> None:
    assert "inner ring 3000 rpm" in run(fan, "--speed", "3000 rpm").stdout
    assert "shaft 25 Hz" in run(fan, "--set", "duty.inner_speed=1500 rpm").stdout


def test_a_case_on_standard_input() -> None:
    result = run("-", "--harmonics", "1", given=CASE)
    assert result.exit_code == 0
    assert "6205 of a fan" in result.stdout


def test_a_designation_with_fields_of_its_own() -> None:
    own = ("--set", "bearing.ball_diameter=7.94mm", "--set", "bearing.pitch_diameter=39.04mm")
    result = run("6205", *own, "--set", "bearing.ball_count=9", "--speed", "1797rpm")
    assert re.search(r"outer race +BPFO +3\.5848 +107\.36", result.stdout)
    assert "Other geometries that the ratings allow" not in result.stdout


def test_angle_and_tolerances() -> None:
    wide = run("6205", "--angle", "free", "--tolerance", "speed=0.01", "--speed", "1797 rpm")
    assert "free contact angle, as under axial" in wide.stdout
    told = run("6205", "--angle", "15 deg", "--tolerance", "pitch_diameter=0.1 mm")
    assert "contact angle 15°" in told.stdout
    assert "given by its clearance" not in told.stdout


def test_json(fan: str, tmp_path: Path) -> None:
    path = tmp_path / "out.json"
    assert run(fan, "--json", str(path)).exit_code == 0
    found = json.loads(path.read_text("utf-8"))
    assert (found["schema"], found["kind"], found["title"]) == (2, "frequencies", "6205 of a fan")
    loaded = frequencies_of(solve(load_case(fan)))
    assert found["loaded"] == loaded.to_mapping()
    assert set(LINES) <= set(found["nominal"])
    assert found["nominal"]["ball_pass_outer"]["band"]["order_low"] < 3.5778
    assert set(found["harmonics"]) == set(FAULTS)
    assert len(found["harmonics"]["inner_race"]) == 9
    assert found["alternatives"][0]["ball_count"] == 9


def test_json_on_standard_output_is_nothing_else() -> None:
    result = run("6205", "--json")
    found = json.loads(result.stdout)
    assert found["loaded"] is None
    assert found["nominal"]["shaft_frequency"] is None
    assert found["harmonics"]["cage"][0]["frequency"] is None


def test_csv(fan: str) -> None:
    result = run(fan, "--csv", "-", "--harmonics", "2")
    rows = list(csv.DictReader(result.stdout.splitlines()))
    assert [*rows[0]] == [
        "source", "row", "line", "abbreviation", "harmonic", "sideband", "order", "frequency_Hz",
        "order_low", "order_high", "frequency_low_Hz", "frequency_high_Hz",
    ]  # fmt: skip
    assert {row["source"] for row in rows} == {"nominal", "loaded"}
    keys = [(r["source"], r["row"], r["line"], r["harmonic"], r["sideband"]) for r in rows]
    assert len(keys) == len(set(keys))
    twice = [r for r in rows if (r["line"], r["harmonic"], r["sideband"]) == ("cage", "2", "0")]
    once = [r for r in rows if (r["line"], r["harmonic"], r["sideband"]) == ("cage", "1", "0")]
    assert float(twice[0]["order"]) == pytest.approx(2.0 * float(once[0]["order"]), rel=1e-8)
    assert float(once[0]["order_low"]) <= float(once[0]["order"]) <= float(once[0]["order_high"])


def test_csv_without_speed_leaves_hertz_empty() -> None:
    rows = list(csv.DictReader(run("6205", "--csv", "-").stdout.splitlines()))
    assert {row["frequency_Hz"] for row in rows} == {""}


def test_a_case_without_solution_keeps_its_geometry() -> None:
    result = run("6205", "--set", "duty.load.fz=1e6kN", "--speed", "100 rpm")
    assert result.exit_code == 1
    assert "By the geometry" in result.stdout
    assert "Under load" not in result.stdout
    assert "no solution" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("6299",), 'bearing.designation = "6299": is in no catalogue'),
        (("absent.toml",), "absent.toml"),
        (("6205", "--speed", "1797"), "--speed"),
        (("6205", "--outer-speed", "fast"), "--outer-speed"),
        (("6205", "--speed", "1e9 rpm"), '--speed: "1000000000 rpm": must be at least'),
        (("6205", "--slip", "2"), "slip"),
        (("6205", "--angle", "5"), "--angle"),
        (("6205", "--angle", "95 deg"), '--angle: "95 deg": must be at least 0° and less'),
        (("6205", "--tolerance", "speed"), "KEY=VALUE"),
        (("6205", "--tolerance", "size=1"), "ball_diameter"),
        (("6205", "--tolerance", "speed=nan"), "speed"),
        (("6205", "--tolerance", "ball_diameter=1"), "unit"),
        (("6205", "--harmonics", "0"), "--harmonics"),
        (("6205", "--harmonics", "101"), "from 1 to 100"),
        (("6205", "--sidebands", "-1"), "--sidebands"),
        (("6205", "--set", "bearing.balls=3"), "--set"),
        (("6205", "--json", "-", "--csv", "-"), "only one of --json and --csv"),
        (("\x00",), "is not a valid file name"),
        (("x" * 10_000,), "designation"),
    ],
)
def test_wrong_input(arguments: tuple[str, ...], message: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2, result.output
    assert message in result.output
    assert "line 1" not in result.output
    assert len(result.output) < 1000


def test_output_over_the_case_is_refused(fan: str) -> None:
    result = run(fan, "--csv", fan)
    assert result.exit_code == 2
    assert "is one of the input files" in result.output


# --- words -----------------------------------------------------------------------------------


def test_in_portuguese(fan: str) -> None:
    result = CliRunner().invoke(app, [fan, "--lang", "pt", "--slip", "0.01"])
    assert result.exit_code == 0
    for text in (
        "Pela geometria",
        "Sob carga",
        "gaiola",
        "pista externa",
        "29,95 Hz",
        "atrasa 1 % em relação ao anel externo",
    ):
        assert text in result.stdout
    assert "geometry" not in result.stdout


def test_rows_of_a_set_stand_apart_and_lines_fit() -> None:
    pair = Bearing.named("S 6012 C").replace(arrangement="DB", spacing=0.02)
    nominal = nominal_frequencies(pair, 1000.0, slip=0.01)
    found = FrequencyResult("pair", pair, nominal, None, None, (), 3, 1)
    for language in languages():
        with speaking(language):
            text = terminal(frequencies_page(found))
        assert text.count("row 1") + text.count("carreira 1") == 1
        assert max(map(len, text.splitlines())) <= 80


def test_plain_ascii_is_possible() -> None:
    found = FrequencyResult(
        "6205", Bearing.named("6205"), nominal_frequencies(Bearing.named("6205")), None, None, (),
        2, 1,
    )  # fmt: skip
    terminal(frequencies_page(found), Medium(encoding="ascii")).encode("ascii")


@pytest.mark.parametrize(
    "arguments",
    [
        ("frequencies", "6310", "--speed", "1.480 rpm"),
        ("life", "6310", "--fr", "5 kN", "--speed", "1.480 rpm"),
        ("life", "6310", "--fr", "5.000 N", "--speed", "1480 rpm"),
        ("solve", "6310", "--fr", "5 kN", "--set", "duty.inner_speed=1.480 rpm"),
    ],
)
def test_points_in_thousands_are_asked_about_in_portuguese(arguments: tuple[str, ...]) -> None:
    """1.480 rpm is no shaft that turns once in 40 s."""
    result = CliRunner().invoke(program, [*arguments, "--lang", "pt"])
    assert result.exit_code == 2
    assert "ponto de milhar" in result.output
    whole = "5000 N" if "5.000 N" in arguments else "1480 rpm"
    assert f"{whole}" in result.output.partition("(exemplo: ")[2]
