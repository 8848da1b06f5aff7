"""A designation in the place of a case file, and the options that give its load and its oil."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import rolamento
from rolamento.case import is_designation, load_case
from rolamento.cli.app import app
from rolamento.errors import FileError, InputError
from rolamento.studies import load_study

CASE = """
[bearing]
designation = "6310/C3"
[duty]
inner_speed = "1480 rpm"
[duty.load]
fz = "5 kN"
fx = "1 kN"
"""
LOAD = ("--fr", "5 kN", "--fa", "1 kN", "--speed", "1480 rpm")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    return tmp_path


def run(*arguments: str, code: int = 0) -> str:
    result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
    if result.exception and not isinstance(result.exception, SystemExit):
        raise result.exception
    assert result.exit_code == code, result.stderr
    return result.stderr if code == 2 else result.stdout


def numbers(state: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in state.items() if key not in ("title", "case")}


def same(one: Any, other: Any) -> None:
    """Equal, numbers to what plain Python and compiled code may differ by."""
    if isinstance(one, dict):
        assert one.keys() == other.keys()
        for key in one.keys() - {"residual", "iterations"}:
            same(one[key], other[key])
    elif isinstance(one, list):
        for pair in zip(one, other, strict=True):
            same(*pair)
    elif isinstance(one, float):
        assert one == pytest.approx(other, rel=1e-8, abs=1e-9)
    else:
        assert one == other


@pytest.mark.parametrize("command", ["solve", "life"])
def test_a_designation_gives_what_its_file_gives(command: str) -> None:
    of_file = json.loads(run(command, "case.toml", "--json"))
    of_name = json.loads(run(command, "6310/C3", *LOAD, "--json"))
    same(numbers(of_name), numbers(of_file))
    assert of_name["title"] == "6310/C3"


@pytest.mark.parametrize(
    ("command", "more"),
    [
        ("friction", ("--coefficient", "0.1", *LOAD)),
        ("turn", ("--points", "4", *LOAD)),
        ("report", LOAD),
        ("frequencies", LOAD),
        (
            "clearance",
            ("--set", "mounting.shaft_tolerance=k5", "--set", "mounting.housing_tolerance=H7"),
        ),
    ],
)
def test_every_command_on_a_case_takes_one(command: str, more: tuple[str, ...]) -> None:
    assert "6310/C3" in run(command, "6310/C3", *more)


def test_options_go_over_a_file() -> None:
    state = json.loads(
        run("solve", "case.toml", "--fr", "8 kN", "--outer-speed", "10 rpm", "--json")
    )
    assert state["load"]["fz"] == pytest.approx(8000.0)
    assert state["load"]["fx"] == pytest.approx(1000.0)
    assert state["case"]["duty"]["outer_speed"] == "10 rpm"


def test_oil_and_temperature() -> None:
    more = ("--lubricant", "ISO VG 68", "--temperature", "70 degC")
    case = json.loads(run("solve", "6310", *LOAD, *more, "--json"))
    assert case["case"]["lubricant"] == "ISO VG 68"
    assert case["film"] is not None


def test_a_study_takes_one(folder: Path) -> None:
    text = 'case = "6310/C3"\n[[axes]]\nfield = "duty.load.fz"\nvalues = ["1 kN", "2 kN"]\n'
    (folder / "study.toml").write_text(text, encoding="utf-8")
    assert load_study(folder / "study.toml").case == load_case("6310/C3")
    assert "2" in run("sweep", "study.toml", "--speed", "100 rpm")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("solve", "6310"), "6310: duty.load: is missing: nothing loads the bearing"),
        (("clearance", "6310"), "example: --set mounting.shaft_tolerance=k5 --set mounting.hous"),
        (("solve", "6310", "--fr", "5"), '--fr: "5": needs a unit of force'),
        (("solve", "6310", "--fr", "5 mm"), '--fr: "5 mm"'),
        (("solve", "6310", *LOAD, "--set", "duty.load.fz=1 kN"), "--set duty.load.fz too"),
        (("solve", "6310", *LOAD, "--lubricant", "VG 6800"), '--lubricant: "VG 6800"'),
        (("solve", "6310", "--catalogue", "none.csv"), "none.csv"),
        (("solve", "cas"), "cas: is no file; did you mean case.toml?"),
        (("solve", "case"), "case: is no file; did you mean case.toml?"),
        (("solve", "bearing"), "bearing: is neither a file nor the designation of a bearing"),
        (("solve", "6299"), 'bearing.designation = "6299": is in no catalogue; did you mean'),
        (("solve", "none.toml"), "none.toml: cannot be opened: no such file"),
        (("life", "6310/C9", *LOAD), "C9"),
    ],
)
def test_what_is_refused(arguments: tuple[str, ...], told: str) -> None:
    assert told in run(*arguments, code=2)


def test_a_designation_is_no_file(folder: Path) -> None:
    assert is_designation("6310/C3")
    assert not is_designation("6310.toml")
    assert not is_designation("-")
    assert not is_designation(folder / "6310")
    (folder / "6310").write_text(CASE, encoding="utf-8")
    assert not is_designation("6310")
    assert is_designation("6310", folder / "elsewhere")
    (folder / "6205").mkdir()  # of results
    assert is_designation("6205")


OWN = """\
designation,bore_mm,outside_diameter_mm,width_mm,dynamic_rating_kN,static_rating_kN
My-1,50,110,27,62,38.5
"""


@pytest.mark.parametrize(
    ("command", "more"),
    [
        ("solve", LOAD),
        ("life", LOAD),
        ("friction", ("--coefficient", "0.1", *LOAD)),
        ("turn", ("--points", "4", *LOAD)),
        ("report", LOAD),
        ("frequencies", ("--speed", "1480 rpm")),
    ],
)
def test_a_catalogue_of_ones_own(folder: Path, command: str, more: tuple[str, ...]) -> None:
    (folder / "own.csv").write_text(OWN, encoding="utf-8")
    assert "My-1" in run(command, "My-1", "--catalogue", "own.csv", *more)
    assert "My-1" in run(command, "My-1", *more, code=2)


def test_in_python() -> None:
    assert rolamento.solve("6310", fz=[1e3, 2e3]).converged.all()
    assert load_case("6310", ["title=ours"]).title == "ours"
    with pytest.raises(FileError, match="neither a file nor"):
        load_case("spindle")
    with pytest.raises(InputError, match="is in no catalogue"):
        load_case("6299")


def test_the_coefficient_counts_before_the_check_that_wants_it(folder: Path) -> None:
    text = CASE + '[lubricant]\nkind = "dry"\n[model]\nraceway_control = "friction"\n'
    (folder / "friction.toml").write_text(text, encoding="utf-8")
    assert "lubricant.friction_coefficient: is missing" in run("solve", "friction.toml", code=2)
    page = run("friction", "friction.toml", "--coefficient", "0.1", "--set", "model.mesh=coarse")
    assert "μ = 0.1" in page


def test_the_coefficient_of_a_case_without_a_lubricant_is_dry() -> None:
    page = json.loads(run("friction", "case.toml", "--coefficient", "0.1", "--json"))
    assert page["case"]["lubricant"]["kind"] == "dry"
    oil = json.loads(
        run("friction", "case.toml", "--lubricant", "ISO VG 68", "--coefficient", "0.1", "--json")
    )
    assert oil["case"]["lubricant"]["friction_coefficient"] == 0.1
    assert oil["case"]["lubricant"].get("kind", "oil") == "oil"
