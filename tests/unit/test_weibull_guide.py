"""The guide to life tests shows what the program prints, and its examples run."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
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
