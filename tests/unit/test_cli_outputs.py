"""The options by which commands write reports, CSV and workbooks."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import openpyxl
import pytest
from typer.main import get_command
from typer.testing import CliRunner, Result

from rolamento.cli.app import app
from rolamento.cli.outputs import OUTPUT_OPTIONS

FREQUENCIES = ("frequencies", "6205", "--speed", "1797 rpm", "--lang", "en")


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_every_command_with_a_page_has_them() -> None:
    commands = get_command(app).commands  # type: ignore[attr-defined]
    pages = ("solve", "turn", "life", "friction", "clearance", "weibull", "diagnose", "trend",
             "verify", "sweep", "tolerance", "frequencies", "anderon")  # fmt: skip
    groups = [commands[name].commands.values() for name in ("weibull-plan", "catalogue")]
    for command in [*(commands[name] for name in pages), *groups[0], *groups[1]]:
        assert set(OUTPUT_OPTIONS) <= {one.name for one in command.params}, command.name


def test_a_page_goes_to_the_terminal_and_to_files() -> None:
    done = run(*FREQUENCIES, "--report", "a.html", "--xlsx", "a.xlsx", "--csv", "a.csv")
    assert done.exit_code == 0
    assert "29.95" in done.stdout
    assert run("report", "6305", "--fr", "2 kN", "-o", "r.md").stdout == "Wrote r.md\n"
    assert Path("a.html").read_text("utf-8").startswith("<!DOCTYPE html>")
    assert "lines" in openpyxl.load_workbook("a.xlsx").sheetnames
    assert Path("a.csv").read_bytes().startswith(b"source,row,line,abbreviation,harmonic,")


def test_csv_is_written_with_the_marks_that_are_asked_for() -> None:
    done = run(*FREQUENCIES, "--csv", "-", "--decimal", "comma")
    rows = list(csv.DictReader(io.StringIO(done.stdout, newline=""), delimiter=";"))
    assert rows[0]["frequency_Hz"].startswith("11,90")
    tabbed = run(
        *FREQUENCIES, "--csv", "-", "--separator", "tab", "--table", "alternatives", "--si"
    )
    assert "\tball_diameter_m\t" in tabbed.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--csv", "x.xlsx"), "x.xlsx: must end in one of .csv"),
        (("--xlsx", "x.csv"), "x.csv: must end in one of .xlsx"),
        (("--xlsx", "-"), "must end in one of .xlsx"),
        (("--report", "x.docx"), "x.docx: must end in one of .html, .pdf"),
        (("--report", "-"), "must end in one of .html"),
        (("--csv", "x", "--separator", "dot"), '--separator: "dot": must be one of comma'),
        (("--csv", "x", "--decimal", "comma", "--separator", "comma"), "must differ"),
        (("--csv", "x", "--table", "nonsense"), '"nonsense": must be one of'),
        (("--table", "lines"), "--table: needs --csv"),
        (("--si",), "--si: needs --csv"),
        (("--report", "a.md", "--csv", "a.md"), "only one of"),
    ],
)
def test_what_will_not_do_is_refused_before_anything_is_written(
    arguments: tuple[str, ...], message: str
) -> None:
    done = run(*FREQUENCIES, *arguments)
    assert done.exit_code == 2
    assert message in done.output
    assert not [path for path in Path().iterdir() if path.suffix]
