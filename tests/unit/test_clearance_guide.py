"""The examples of the guide to clearances run as they stand, and print what it says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rolamento import load_case
from rolamento.clearance import clearance_of_case

GUIDE = (Path(__file__).resolve().parents[2] / "docs" / "clearance.md").read_text("utf-8")
CASE = re.findall(r"```toml\n(.*?)```", GUIDE, re.DOTALL)[0]
BLOCKS = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)


@pytest.fixture(autouse=True)
def _case_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "mounted.toml").write_text(CASE, "utf-8")
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("block", BLOCKS, ids=range(len(BLOCKS)))
def test_example_runs(block: str, capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(block, "example", "exec"), {})
    assert capsys.readouterr().out


def test_the_table_of_steps() -> None:
    found = clearance_of_case(load_case("mounted.toml"))
    rows = {
        name: tuple(float(cell.replace("−", "-")) for cell in cells.split("|"))
        for name, cells in re.findall(
            r"^\| (\w[\w ]*) \|((?: −?\d+\.\d \|){2} −?\d+\.\d) \|", GUIDE, re.M
        )
    }
    assert set(rows) == {*(step.name for step in found.steps), "in operation"}
    for step in found.steps:
        assert rows[step.name] == pytest.approx([1e6 * c for c in step.change], abs=0.05)
    limits = [1e6 * value for value in (found.minimum, found.mean, found.maximum)]
    assert rows["in operation"] == pytest.approx(limits, abs=0.05)
    assert [note.key for note in found.warnings] == ["interference_at_minimum"]


def test_every_key_of_the_mounting_is_explained() -> None:
    from rolamento.case.mounting import Mounting

    section = GUIDE.partition("## Keys of")[2].partition("\n## ")[0]
    named = set(re.findall(r"`(\w+)`", section))
    assert set(Mounting.model_fields) <= named
