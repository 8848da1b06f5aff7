"""A case to start from: it solves at once, has every field, and each of them can be woken up."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento import solve
from rolamento.case import Case, parse_case
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.tasks.new_case import TABLES, case_template, file_name
from rolamento.words import speaking

ASLEEP = re.compile(r"# ([a-z_0-9]+) = (.+)$")
DESIGNATIONS = (
    *("6310/C3", "6008", "6212-2Z", "6320", "S 6012 C", "EX 70 25deg", "S 61912 C"),
    *("SKF 6205", "QJ210", "1210", "51210"),
    *("NU 205/C3", "NJ 2210", "30206", "NA 4905"),
)


@pytest.mark.parametrize("designation", [*DESIGNATIONS, None])
def test_it_solves_at_once(designation: str | None) -> None:
    case = parse_case(case_template(designation))
    assert case.bearing.designation == designation
    assert case.lubricant is not None
    solved = solve(case)
    assert solved.converged.all()
    assert solved.inner.max_pressure.max() < 3.5e9
    if designation is not None:
        assert case.title == designation
        assert 0.05 < (case.duty.load.fz or case.duty.load.fx or 0.0) / 1e3 < 100.0


def fields_in(text: str) -> list[str]:
    table, found = "", []
    for line in text.splitlines():
        if heading := re.fullmatch(r"(?:# )?\[([a-z._]+)\]", line):
            table = f"{heading[1]}."
        elif field := re.match(r"(?:# )?([a-z_0-9]+) = ", line):
            found.append(f"{table}{field[1]}")
    return found


def test_it_has_every_field_once() -> None:
    found: list[str] = []
    for designation in ("6310", "NU 205", "30206"):
        own = fields_in(case_template(designation))
        assert len(own) == len({*own})
        found += own
    left = {name for name in Case.fields() if name not in found}
    # what is given by its name as a whole, and the factors of one theory
    whole = (*(f"{name}." for name in Case.fields()), "life.tallian_")
    assert {name for name in left if not name.startswith(whole)} == {"bearing.element", "lubricant"}
    assert {*TABLES} >= {name.rpartition(".")[0] for name in found}


def test_balls_have_no_fields_of_rollers_and_rollers_none_of_balls() -> None:
    balls, needles, cones = (
        {*fields_in(case_template(name))} for name in ("6310", "NA 4905", "30206")
    )
    assert not any("roller" in name or "_ribs" in name for name in balls)
    assert not any(name.startswith("bearing.ball") for name in needles | cones)
    assert "model.slices" in needles
    assert "model.raceway_control" not in needles
    assert "bearing.roller_half_angle" in cones - needles
    assert "bearing.inner_ribs" in needles - cones


@pytest.mark.parametrize("designation", ["6310/C3", "S 6012 C", "NU 205/C3", "30210"])
def test_every_field_that_sleeps_can_be_read(designation: str) -> None:
    table, known = "", Case.fields()
    for line in case_template(designation).splitlines():
        if heading := re.fullmatch(r"(?:# )?\[([a-z._]+)\]", line):
            table = f"{heading[1]}."
        elif field := ASLEEP.match(line):
            name = f"{table}{field[1]}"
            value = tomllib.loads(f"value = {field[2]}")["value"]  # the comment behind it is one
            if known[name].kind != "list" and name != "bearing.preload":
                assert known[name].checked(value, in_file=True) is not None


def test_what_the_bearing_has_stands_in_the_comments() -> None:
    text = case_template("6310/C3")
    for line in (
        "# ball_count = 8 ",
        '# ball_diameter = "19.05 mm"',
        '# bore = "50 mm"',
        '# dynamic_rating = "62 kN"',
        '# diametral_clearance = "0.027 mm"',
    ):
        assert line in text


def test_axial_load_where_it_is_wanted() -> None:
    assert parse_case(case_template("6310")).duty.load.fx is None
    for designation in ("EX 70 25deg", "S 6012 C"):
        assert parse_case(case_template(designation)).duty.load.fx
    fast, slow = (parse_case(case_template(d)).duty.inner_speed for d in ("S 6012 C", "6012"))
    assert fast > 2.0 * slow


def test_it_is_in_the_language_that_is_spoken() -> None:
    with speaking("pt"):
        text = case_template("6310")
    assert "rotação do anel interno" in text
    assert parse_case(text) == parse_case(case_template("6310"))


@pytest.mark.parametrize(
    ("designation", "name"),
    [
        ("6310/C3", "6310-C3.toml"),
        ("EX 70 25deg", "EX-70-25deg.toml"),
        (None, "case.toml"),
        ("../../etc", "etc.toml"),
        ("/", "case.toml"),
    ],
)
def test_its_name(designation: str | None, name: str) -> None:
    assert file_name(designation) == name


def test_no_such_bearing() -> None:
    with pytest.raises(InputError, match="is in no catalogue"):
        case_template("6399")


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str, code: int = 0) -> str:
        result = CliRunner().invoke(app, ["new", *arguments], env={"LC_ALL": "C.UTF-8"})
        assert result.exit_code == code, result.stderr
        return result.stderr if code else result.stdout

    told = "Wrote 6310-C3.toml; now try: rolamento solve 6310-C3.toml\n"
    assert run("6310/C3") == told
    assert (tmp_path / "6310-C3.toml").read_text("utf-8") == case_template("6310/C3")
    assert "already exists; --force overwrites it" in run("6310/C3", code=2)
    assert run("6310/C3", "--force") == told
    assert run("6310/C3", "-o", "-") == case_template("6310/C3")
    assert "must end in .toml" in run("6310", "-o", "case.txt", code=2)
    assert "is in no catalogue" in run("6399", code=2)
    (tmp_path / "own.csv").write_text(
        "designation,bore_mm,outside_diameter_mm,width_mm,dynamic_rating_kN,static_rating_kN\n"
        "My-1,50,110,27,62,38.5\n",
        encoding="utf-8",
    )
    assert "rolamento solve My-1.toml --catalogue own.csv" in run("My-1", "--catalogue", "own.csv")
