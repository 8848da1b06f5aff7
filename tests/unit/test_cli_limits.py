"""The commands static and electrical: pages, JSON, tables, exit codes, what they refuse."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner, Result

from rolamento.cli.app import app

STATIC = ["static", "6310", "--fr", "19 kN"]
ELECTRICAL = [
    "electrical", "6310", "--fr", "1 kN", "--speed", "1500 rpm", "--lubricant", "ISO VG 100",
    "--temperature", "70 degC", "--set", "electrical.current=0.5 A",
]  # fmt: skip


def run(*words: str) -> Result:
    return CliRunner().invoke(app, [*words, "--lang", "en"])


def test_static_shows_all_three_safeties() -> None:
    found = run(*STATIC)
    assert found.exit_code == 0
    for text in ("by stress", "by load", "C_0/P_0", "Recommended by makers", "Hardness below"):
        assert text in found.output


def test_static_as_json() -> None:
    found = json.loads(run(*STATIC, "--json").stdout)
    assert found["kind"] == "static"
    assert found["bearings"][0]["static_safety"] == pytest.approx(38.5 / 19.0, rel=1e-3)
    assert found["safety_by_stress"] == found["rows"][0]["inner"]["safety_by_stress"]


def test_static_as_a_table() -> None:
    lines = run(*STATIC, "--csv", "-").stdout.splitlines()
    assert lines[0].split(",")[0] == "race"
    assert len(lines) == 3


def test_without_a_load_static_says_what_to_give() -> None:
    found = run("static", "6310")
    assert "inf" not in found.output.lower().split()


@pytest.mark.parametrize(
    ("setting", "said"),
    [("static.load_factor=0", "static.load_factor"), ("static.operation=gentle", "smooth"),
     ("static.surface_hardness=90", "surface_hardness"),
     ("static.allowable_pressure=3200", "MPa")],
)  # fmt: skip
def test_static_refuses_what_is_out_of_range(setting: str, said: str) -> None:
    found = run(*STATIC, "--set", setting)
    assert found.exit_code == 2
    assert said in found.output
    assert "Traceback" not in found.output


def test_electrical_shows_bands_and_no_verdict() -> None:
    found = run(*ELECTRICAL)
    assert found.exit_code == 0
    assert "Published bands" in found.output
    assert "no limits" in found.output


def test_electrical_as_json() -> None:
    found = json.loads(run(*ELECTRICAL, "--json").stdout)
    assert found["kind"] == "electrical"
    assert found["capacitance"] == pytest.approx(2.0 * found["capacitance_of_ellipses"])
    assert found["inner"]["current_density"] * found["inner"]["total_area"] == pytest.approx(0.5)


def test_electrical_without_oil_says_what_is_missing() -> None:
    found = run("electrical", "6310", "--fr", "1 kN")
    assert found.exit_code == 2
    assert "capacitor" in found.output


def test_electrical_takes_units_of_electricity() -> None:
    plain, small = (
        json.loads(run(*ELECTRICAL[:-1], f"electrical.current={one}", "--json").stdout)
        for one in ("0.5 A", "500 mA")
    )
    of_small = pytest.approx(small["inner"]["current_density"])
    assert plain["inner"]["current_density"] == of_small
    refused = run(*ELECTRICAL[:-1], "electrical.current=0.5 V")
    assert refused.exit_code == 2
    assert "current" in refused.output


@pytest.mark.parametrize("command", ["static", "electrical"])
def test_help_in_portuguese(command: str) -> None:
    found = CliRunner().invoke(app, [command, "--help", "--lang", "pt"])
    assert found.exit_code == 0
    assert "Mostra" in found.output
