"""The guide to life tests shows what the program prints, and its examples run."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from tests.field_data import as_table, field_data
from typer.testing import CliRunner

from rolamento.cli.app import app

DOCS = Path(__file__).resolve().parents[2] / "docs"
GUIDE = (DOCS / "weibull.md").read_text("utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)
_COMMAND = r"\n    rolamento ((?:[^\n]*\\\n)*[^\n]*)\n"
_OTHER_LINES = r"(?:\n    [^\n]*)*\n"
FOUND = re.findall(rf"{_COMMAND}{_OTHER_LINES}```\n(.*?)```", GUIDE, re.DOTALL)
SHOWN = [(shlex.split(command.replace("\\\n", " ")), output) for command, output in FOUND]


def test_five_outputs_are_shown() -> None:
    assert len(SHOWN) == 5


@pytest.mark.parametrize(("command", "output"), SHOWN, ids=[" ".join(c[:3]) for c, _ in SHOWN])
def test_what_the_guide_shows_is_what_is_printed(
    command: list[str], output: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(app, command, env={"LC_ALL": "C.UTF-8"})
    assert result.exit_code == 0
    # the guide leaves out the head, which repeats the command
    assert output.strip() in result.stdout


@pytest.mark.parametrize("block", BLOCKS, ids=range(len(BLOCKS)))
def test_example_runs(block: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {})


@pytest.mark.parametrize("page", ["weibull.md", "theory/weibull-planning.md"])
def test_links_lead_somewhere(page: str) -> None:
    text = (DOCS / page).read_text("utf-8")
    for link in re.findall(r"\]\(([^)#]+)", text):
        assert ((DOCS / page).parent / link).exists(), link


@pytest.mark.parametrize(
    "command", ["weibull field.csv --plot modes.png", "weibull field.csv --modes-pooled"]
)
def test_what_the_guide_shows_of_modes_is_printed(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of the drawn field data of the tests of modes, line by line."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "field.csv").write_text(as_table(field_data()), encoding="utf-8")
    shown = GUIDE.split(f"    rolamento {command}\n")[1].split("```text\n")[1].split("```")[0]
    result = CliRunner().invoke(app, command.split(), env={"LC_ALL": "C.UTF-8"})
    assert result.exit_code == 0
    printed = result.stdout.splitlines()
    assert not [line for line in shown.splitlines() if line and line not in printed]
