"""The Python examples of the documentation run as they stand."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BLOCKS = [
    pytest.param(block, id=f"{page.name}-{i}")
    for page in (ROOT / "README.md", ROOT / "README.pt-BR.md", ROOT / "docs" / "python.md")
    if page.exists()
    for i, block in enumerate(re.findall(r"```python\n(.*?)```", page.read_text("utf-8"), re.S))
]


@pytest.mark.parametrize("block", BLOCKS)
def test_example_runs(
    block: str, examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(examples / "218_combined.toml", tmp_path / "case.toml")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {})
