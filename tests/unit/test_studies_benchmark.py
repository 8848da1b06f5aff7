"""The measurement of studies runs: on a handful of cases, so that it does not rot."""

from __future__ import annotations

import importlib
import os
from pathlib import Path

import pytest

import rolamento

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.skipif(os.name != "posix", reason="memory is measured by POSIX means")
@pytest.mark.sweep
def test_a_small_study_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT))
    monkeypatch.setenv("PYTHONPATH", str(Path(rolamento.__file__).parents[1]))
    sweep = importlib.import_module("benchmarks.sweep")
    findings = sweep.measure(2000, ".parquet")
    assert findings.failures == []
    values = {figure.name: figure.value for figure in findings.figures}
    assert values["rate"] > 0.0
    assert 0.0 < values["peak memory"] < 2000.0
    assert "exit code" in sweep.measure(2000, ".none").failures[0]
