"""The benchmarks of life and catalogue run, and what they compare with finds the same."""

from __future__ import annotations

import importlib
import math
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def bench(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(ROOT))
    return importlib.import_module("benchmarks.life")


def test_plain_loop_finds_the_same_lives(bench: Any) -> None:
    findings = bench.measure(60, 60, 1)
    assert findings.failures == []
    values = {figure.name: figure.value for figure in findings.figures}
    assert values["rate"] > 0.0
    assert values["  the engine is faster by"] > 0.0


def test_a_different_life_is_told(bench: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = bench.life_plain.reference_life
    monkeypatch.setattr(
        bench.life_plain, "reference_life", lambda *given: kept(*given) * (1.0 + 1e-6)
    )
    assert "differs by" in bench.measure(10, 10, 1).failures[0]


def test_stress_volume(bench: Any) -> None:
    findings = bench.measure_stress_volume(20, 0, 1)
    assert findings.failures == []
    assert all(math.isfinite(figure.value) for figure in findings.figures)


@pytest.mark.slow
@pytest.mark.sweep
def test_scipy_integrates_the_same(bench: Any) -> None:
    findings = bench.measure_stress_volume(20, 1, 1)
    assert findings.failures == []
    assert len(findings.figures) == 5


def test_catalogue(bench: Any) -> None:
    findings = bench.measure_catalogue(2)
    assert findings.failures == []
    targets = [figure.target for figure in findings.figures if figure.target is not None]
    assert len(targets) == 3
