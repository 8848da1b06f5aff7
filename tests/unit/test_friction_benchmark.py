"""The benchmark of friction control runs: on a few cases, and beside SciPy on a small bearing."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, Load

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def benchmark(monkeypatch: pytest.MonkeyPatch) -> Any:
    """The module, which stands beside the package."""
    monkeypatch.syspath_prepend(str(ROOT))
    return importlib.import_module("benchmarks.friction_control")


def test_it_times_both_meshes(benchmark: Any) -> None:
    findings = benchmark.measure(4, 0, 1)
    assert findings.failures == []
    figures = {figure.name: figure for figure in findings.figures}
    for mesh, target in (("fine", 2.0), ("coarse", 2.0)):
        figure = figures[f"{mesh} mesh, one core"]
        assert figure.value > 0.0
        assert figure.target is not None
        assert figure.target.value(False) == target


def test_scipy_finds_the_same_torque(benchmark: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    bearing = Bearing(
        ball_count=3,
        ball_diameter="12 mm",
        pitch_diameter="60 mm",
        contact_angle="25 deg",
        inner_conformity=0.53,
        outer_conformity=0.52,
    )
    small = Case(bearing=bearing, duty=Duty(load=Load(fx=1.0)))
    monkeypatch.setattr(benchmark.duty_sets, "example", lambda: small)
    duties = {
        "fx": np.array([2e3]), "fy": np.zeros(1), "fz": np.array([300.0]),
        "inner_speed": np.array([900.0]),
    }  # fmt: skip
    findings = benchmark._beside_scipy(duties, 1, 1e-3)
    assert findings.failures == []
    figures = {figure.name.strip(): figure.value for figure in findings.figures}
    assert figures["SciPy finds a solution"] == 100.0
    assert figures["the engine is faster by"] > 0.0
    monkeypatch.setattr(benchmark, "AGREEMENT", 1e-9)
    assert "differs by" in benchmark._beside_scipy(duties, 1, 1e-3).failures[0]
