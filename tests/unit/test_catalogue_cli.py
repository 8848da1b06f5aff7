"""`rolamento catalogue`: what is printed, what is written, how it ends."""

from __future__ import annotations

import json
import re
import tomllib
from importlib import resources
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from rolamento.catalogue import catalogue, geometry_of
from rolamento.cli.catalogue import app
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.pages.catalogue import bearing_page, search_page
from rolamento.studies import parse_study
from rolamento.studies import run as run_study
from rolamento.words import said, speaking


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, [*arguments, "--lang", "en"])


def test_search() -> None:
    result = run("search", "630", "--most", "5")
    assert result.exit_code == 0
    assert "6304  NSK  20  52  15" in result.stdout
    assert "6305" not in result.stdout
    assert "type more of the designation" in result.stdout
    assert "type more" not in run("search", "6305").stdout


def test_search_finds_nothing() -> None:
    result = run("search", "no such")
    assert result.exit_code == 1
    assert "no match" in result.stdout


def test_show_tells_that_the_inside_is_inferred() -> None:
    result = run("show", "6305-2RS/C3")
    assert result.exit_code == 0
    assert "inferred from C, C_0, f_0, not published" in result.stdout
    assert re.search(r"10\.319 +mm +inferred +13/32 in", result.stdout)
    assert "clearance class C3" in result.stdout
    assert "2RS: contact seals on both sides" in result.stdout
    assert "NSK, Rolling Bearings" in result.stdout


@pytest.mark.parametrize(
    ("designation", "kind", "figure"),
    [
        ("3206", "double-row angular-contact ball bearing", "distance of the rows"),
        (
            "QJ 210",
            "four-point contact ball bearing",
            "basic dynamic axial load rating C_a  57 000",
        ),
        ("1210", "self-aligning ball bearing", "clearance class CN"),
        (
            "51210",
            "single-direction thrust ball bearing",
            "basic dynamic axial load rating C_a   49 000",
        ),
    ],
)
def test_kinds_are_shown_without_the_word_show(designation: str, kind: str, figure: str) -> None:
    result = run(designation)
    assert result.exit_code == 0
    assert kind in result.stdout
    assert figure in result.stdout
    assert result.stdout == run("show", designation).stdout


def test_a_misspelt_command_is_no_designation() -> None:
    assert "Did you mean search" in run("serch", "62").stderr


@pytest.mark.parametrize("designation", ["QJ 210", "FAG 3206", "6205 C3"])
def test_a_designation_of_several_words_needs_no_quotes(designation: str) -> None:
    shown = run("show", designation).stdout
    assert shown
    assert run(*designation.split()).stdout == shown
    assert run("show", *designation.split()).stdout == shown


def test_show_of_a_published_inside() -> None:
    result = run("show", "S 6012 C")
    assert result.exit_code == 0
    assert "inferred" not in result.stdout
    assert re.search(r"77\.5 +mm +published", result.stdout)


def test_show_without_ratings_and_with_given_ones() -> None:
    without = run("show", "7230B")
    assert without.exit_code == 1
    assert "--dynamic and --static" in without.stdout
    given = run("show", "7230B", "--dynamic", "250 kN", "--static", "280 kN")
    assert given.exit_code == 0
    assert re.search("250 000 +N", given.stdout)
    assert "Candidates that fit the ratings" in given.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("show", "6255"), "did you mean"),
        (("show", "6205/C9"), "C2, CN, C3, C4 and C5"),
        (("show", "6205", "--dynamic", "14"), "--dynamic"),
        (("show", "6205", "--static", "0 N"), "must be at least 1 N and at most"),
        (("search", "62", "--most", "0"), "must be at least 1 and at most 1000"),
        (("search", "62", "--catalogue", "absent.csv"), "absent.csv"),
    ],
)
def test_wrong_input(arguments: tuple[str, ...], message: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert message in result.stderr
    assert result.stderr.count("\n") == 1


def test_json(tmp_path: Path) -> None:
    result = run("show", "6205", "--json")
    data = json.loads(result.stdout)
    assert data["inside"]["ball_count"] == {"value": 9, "origin": "inferred"}
    assert data["bearing"]["figures"]["dynamic_rating"]["value"] == 14000.0
    assert data["candidates"][0]["rests_on"] == ["dynamic_rating", "static_rating", "f0"]
    file = tmp_path / "list.json"
    assert run("search", "6305", f"--json={file}").exit_code == 0
    listed = json.loads(file.read_text("utf-8"))["bearings"]
    assert [one["designation"] for one in listed] == ["6305"]


def test_axis_of_a_study_file() -> None:
    result = run("show", "6815", "--axis")
    assert result.exit_code == 0
    case = '[case.bearing]\ndesignation = "6815"\n[case.duty.load]\nfz = "5 kN"\n'
    study = parse_study('outputs = ["max_inner_load"]\n' + result.stdout + case)
    loads = run_study(study).max_inner_load.to_numpy()
    assert loads.shape == (3,)
    assert loads.max() > loads.min()


def test_no_axis_without_candidates() -> None:
    result = run("show", "S 6012 C", "--axis")
    assert result.exit_code == 2
    assert "no candidates" in result.stderr


def test_own_catalogue(tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    file.write_text(
        "designation,bore_mm,outside_diameter_mm,ball_count,ball_diameter_mm\nQX 1,25,52,9,7.5\n"
    )
    result = run("show", "qx1", "--catalogue", str(file))
    assert result.exit_code == 0
    assert re.search(r"7\.5 +mm +published", result.stdout)
    assert re.search(r"38\.5 +mm +assumed", result.stdout)


@pytest.mark.parametrize("language", ["en", "pt"])
@pytest.mark.parametrize("encoding", ["utf-8", "ascii"])
def test_pages_in_every_language_and_encoding(language: str, encoding: str) -> None:
    inside = geometry_of("6815")
    with speaking(language):
        documents = (
            bearing_page(inside),
            bearing_page(geometry_of("7014 ACE/HCP4ADBA", with_balls=False)),
            search_page(catalogue().search("EX"), is_all=False),
        )
    page = "".join(terminal(document, Medium(encoding=encoding)) for document in documents)
    page.encode(encoding)
    assert max(map(len, page.splitlines())) <= 80


def test_every_meaning_is_translated() -> None:
    file = resources.files("rolamento") / "data" / "designations.toml"
    data = tomllib.loads(file.read_text(encoding="utf-8"))
    tables = ("prefixes", "suffixes", "inserts", "insert_housings", "phrases")
    meanings = {meaning for table in tables for meaning in data[table].values()}
    inside = geometry_of("6305ZZ/C3")
    with speaking("pt"):
        assert [meaning for meaning in meanings - {"flange"} if said(meaning) == meaning] == []
        page = terminal(bearing_page(inside))
    text = " ".join(page.split())
    assert "ZZ: placas de proteção dos dois lados; classe de folga C3" in text


def test_a_designation_alone_is_shown() -> None:
    short, long = run("7014C", "--lang", "en"), run("show", "7014C", "--lang", "en")
    assert (short.exit_code, short.stdout) == (0, long.stdout)
    assert "S 6014 C" in short.stdout  # one of the same size with published balls
    assert "No such command: serch" in run("serch", "62").stderr


def test_a_bearing_without_balls_shows_those_of_its_size() -> None:
    shown = run("7014 ACE/HCP4ADB", "--lang", "en")
    assert shown.exit_code == 1
    text = " ".join(shown.stdout.split())
    assert "Neither balls nor load ratings are published" in text
    assert "VEX 70 25deg" in text
    assert "HC: ceramic balls" in text
    found = json.loads(run("7014 ACE/HCP4ADB", "--json").stdout)
    assert found["inside"] is None
    assert found["same_size"][0]["designation"] == "VEX 70 25deg"
    assert found["without_effect"] == ["P4A"]
