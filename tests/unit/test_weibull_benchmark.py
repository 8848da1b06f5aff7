"""The benchmarks of life tests run, on a handful of fits, and their findings agree."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def module(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Import a module of the benchmarks, which stand beside the package."""
    monkeypatch.syspath_prepend(str(ROOT))

    def load(name: str) -> ModuleType:
        return importlib.import_module(f"benchmarks.{name}")

    return load


def test_fits_agree(module: Any) -> None:
    findings = module("weibull").measure(fits=200, few=2, repeats=1)
    assert findings.failures == []
    values = {figure.name: figure.value for figure in findings.figures}
    assert values["rate"] > 0.0
    assert values["SciPy, one at a time"] > 0.0


@pytest.mark.sweep
def test_coverage_is_counted(module: Any) -> None:
    coverage = module("weibull_coverage")
    results = {
        (kind, size): coverage.measure(kind, size, 4, 100)
        for kind in coverage.KINDS
        for size in coverage.SIZES[:1]
    }
    for found in results.values():
        assert [c.method for c in found] == list(coverage.METHODS_SHOWN)
        assert all(c.tests == 4 for c in found)
        assert all(np.all((c.held >= 0.0) & (c.held <= 100.0)) for c in found)
    whole = {(k, n): results[k, coverage.SIZES[0]] for k in coverage.KINDS for n in coverage.SIZES}
    page = coverage.markdown(whole, 4, 100)
    assert page.count("| pivotal |") == len(coverage.KINDS) * len(coverage.SIZES)
