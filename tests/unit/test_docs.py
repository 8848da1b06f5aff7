"""The examples of the Python guide run as they stand (those of the README: test_cli)."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

GUIDE = Path(__file__).resolve().parents[2] / "docs" / "python.md"
BLOCKS = re.findall(r"```python\n(.*?)```", GUIDE.read_text("utf-8"), re.DOTALL)


@pytest.mark.parametrize("block", BLOCKS)
def test_example_runs(
    block: str, examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(examples / "218_combined.toml", tmp_path / "case.toml")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {})
