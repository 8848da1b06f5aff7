"""The examples of the Python guides run as they stand (those of the README: test_cli)."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"
BLOCKS = [
    pytest.param(block, id=f"{guide}-{number}")
    for guide in ("case-file.md", "python.md", "report.md", "studies.md")
    for number, block in enumerate(
        re.findall(r"```python\n(.*?)```", (DOCS / guide).read_text("utf-8"), re.DOTALL)
    )
]


@pytest.mark.parametrize("block", BLOCKS)
def test_example_runs(
    block: str, examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(examples / "218_combined.toml", tmp_path / "case.toml")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {})
