"""`rolamento clearance`: what is printed, what is written, how it ends."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from rolamento import load_case
from rolamento.clearance import clearance_of_case, sample_clearance
from rolamento.cli.requested import program_of
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.pages.clearance import clearance_page
from rolamento.tasks.clearance import mounted_clearance
from rolamento.words import speaking

GUIDE = (Path(__file__).resolve().parents[2] / "docs" / "clearance.md").read_text("utf-8")
CASE = re.findall(r"```toml\n(.*?)```", GUIDE, re.DOTALL)[0]

app = program_of("running:ClearanceRequest", "clearance")


@pytest.fixture
def mounted(tmp_path: Path) -> str:
    path = tmp_path / "mounted.toml"
    path.write_text(CASE, "utf-8")
    return str(path)


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, [*arguments, "--lang", "en"])


def test_each_step_is_shown(mounted: str) -> None:
    result = run(mounted)
    assert result.exit_code == 0
    for line in (
        r"before mounting +13\.0 +20\.5 +28\.0",
        r"fit on the shaft +−14\.2 +−7\.8 +−1\.3",
        r"interference as mounted +21\.0 +11\.5 +2\.0",
        r"gain by thermal expansion +6\.5 +6\.5 +6\.5",
        r"temperature +−5\.5 +−5\.5 +−5\.5",
        r"in operation +−17\.4 +7\.2 +21\.2",
    ):
        assert re.search(line, result.stdout), line
    assert "ISO 5753-1:2009, class C3" in result.stdout
    assert "The minimum clearance in operation is negative" in result.stdout


def test_bearings_are_drawn(mounted: str) -> None:
    result = run(mounted, "--samples", "20000", "--seed", "3")
    assert result.exit_code == 0
    assert "20 000 bearings" in result.stdout
    assert re.search(r"mean 6\.\d µm, standard deviation 3\.\d µm", result.stdout)
    assert result.stdout == run(mounted, "--samples", "20000", "--seed", "3").stdout


def test_json(mounted: str, tmp_path: Path) -> None:
    result = run(mounted, "--json", "--samples", "1")
    whole = json.loads(result.stdout)
    found = clearance_of_case(load_case(mounted))
    assert whole["mean"] == found.mean
    assert whole["schema"] == 2
    assert whole["samples"]["standard_deviation"] is None
    written = tmp_path / "out.json"
    both = run(mounted, "--json", str(written))
    assert both.exit_code == 0
    assert "in operation" in both.stdout
    assert json.loads(written.read_text("utf-8"))["steps"][0]["name"] == "initial"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--set", "mounting.shaft_tolerance=K5"], "mounting.shaft_tolerance"),
        (["--set", "mounting.bore=2 mm"], "mounting.bore"),
        (["--samples", "0"], "integer from 1"),
    ],
)
def test_wrong_input_ends_in_one_line(mounted: str, arguments: list[str], told: str) -> None:
    result = run(mounted, *arguments)
    assert result.exit_code == 2
    assert told in result.stderr
    assert "Traceback" not in result.stderr


def test_a_case_without_a_mounting_and_one_that_would_be_overwritten(
    examples: Path, mounted: str
) -> None:
    result = run(str(examples / "218_combined.toml"))
    assert (result.exit_code, "mounting: is missing" in result.stderr) == (2, True)
    result = run(mounted, "--json", mounted)
    assert (result.exit_code, "is one of the input files" in result.stderr) == (2, True)


@pytest.mark.parametrize("code", ["en", "pt"])
@pytest.mark.parametrize("width", [60, 80, 140])
def test_no_line_is_wider_than_the_medium(mounted: str, code: str, width: int) -> None:
    case = load_case(mounted, ["mounting.wear=3 um"])
    assert case.mounting is not None
    samples = sample_clearance(case.bearing, case.mounting, case.temperature, samples=100)
    with speaking(code):
        page = clearance_page(mounted_clearance(case), samples)
    text = terminal(page, Medium(width=width))
    assert max(map(len, text.splitlines())) <= width


def test_all_words_of_both_languages(mounted: str) -> None:
    case = load_case(mounted)
    found = mounted_clearance(case)
    english = terminal(clearance_page(found))
    with speaking("pt"):
        portuguese = terminal(clearance_page(found))
    assert "fit on the shaft" in english
    assert "ajuste no eixo" in portuguese
    assert "−17,4" in portuguese
    assert "pré-carregados" in portuguese
    for word in ("fit on", "growth", "class ", "chapter", "section", "expansion", "{"):
        assert word not in portuguese


def test_a_measured_clearance_and_its_load(mounted: str) -> None:
    text = CASE.replace('clearance_class = "C3"', 'measured_clearance = "26 um"')
    Path(mounted).write_text(text, "utf-8")
    shown = run(mounted).stdout
    assert re.search(r"measuring load +−5\.\d", shown)
    whole: dict[str, Any] = json.loads(run(mounted, "--json").stdout)
    assert whole["steps"][1]["details"]["load"] == [49.0, 49.0, 49.0]
