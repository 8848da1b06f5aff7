"""The benchmarks run: on a handful of cases, so that they do not rot."""

from __future__ import annotations

import importlib
import json
import os
from dataclasses import replace
from pathlib import Path
from random import Random
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from rich.console import Console

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def module(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Import a module of the benchmarks, which stand beside the package."""
    monkeypatch.syspath_prepend(str(ROOT))

    def load(name: str) -> ModuleType:
        return importlib.import_module(f"benchmarks.{name}")

    return load


def test_sets_are_the_same_every_time(module: Any) -> None:
    sets = module("duty_sets")
    for duties_of in (sets.tilts_held, sets.moments_given, sets.hard):
        first, again = duties_of(50), duties_of(50)
        assert all(np.array_equal(first[name], again[name]) for name in first)


def test_duty_set_is_what_it_says(module: Any) -> None:
    duties = module("duty_sets").moments_given(2000)
    fx = duties["fx"]
    assert fx.min() >= 2e3
    assert fx.max() <= 45e3
    assert (np.abs(duties["fz"] / fx - 0.45) <= 0.45).all()
    assert (np.abs(duties["fy"] / fx) <= 0.4).all()
    assert (np.abs(duties["my"] / fx) <= 0.02).all()
    assert duties["inner_speed"].max() <= 15_000 * np.pi / 30.0


@pytest.mark.parametrize("name", ["duty set, tilts held", "duty set, moments given", "hard set"])
def test_throughput(module: Any, name: str) -> None:
    findings = module("throughput").measure(name, 40, 1)
    assert findings.failures == []
    values = {figure.name: figure.value for figure in findings.figures}
    assert values["one thread"] > 0.0
    assert values["converged"] == 100.0


def test_the_evaluation_of_a_ball_follows_its_kernel(module: Any) -> None:
    assert module("throughput").ball_evaluation(1, passes=2) > 0.0


def test_laws_of_rollers(module: Any) -> None:
    findings = module("roller_laws").measure(120)
    assert findings.failures == []
    values = {figure.name: figure.value for figure in findings.figures}
    assert values["converged"] > 80.0
    assert values["not converged"] == 0.0
    assert "balance of a roller, of its own load" in values
    assert "alone or among others: loads" in values


def test_sets_on_one_ring(module: Any) -> None:
    findings = module("sets").measure(20, 2, 1)
    assert findings.failures == []
    assert all(figure.value > 0.0 for figure in findings.figures)


def test_one_case(module: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    interactive = module("interactive")
    monkeypatch.setattr(interactive, "EXAMPLES", ("6305_film",))
    findings = interactive.measure(1)
    assert findings.failures == []
    assert [figure.name for figure in findings.figures] == ["read", "quick", "full", "write"]


@pytest.mark.parametrize("name", ["tilts held", "moments given"])
def test_scipy_finds_the_same(module: Any, name: str) -> None:
    against = module("against_scipy")
    case = against.example()
    duties_of, tilting = against.SETS[name]
    sample = against._Sample(case, duties_of(6), tilting)
    differences = sample.differences(sample.solve(sample.warm, True))
    assert np.nanmax(differences) < against.AGREEMENT
    assert np.isfinite(differences).all()


def test_jacobian_of_the_scipy_model(module: Any) -> None:
    model = module("scipy_model")
    case = module("duty_sets").example()
    bearing = model.ScipyBearing(case.bearing, tilting=True)
    load = np.array([2e4, 1e3, 1.5e4, 50.0, -30.0])
    at = bearing.static_guess(load) + np.random.default_rng(1).normal(scale=0.1, size=37)
    exact = bearing.jacobian(load, bearing.evaluate(1000.0, at))

    def residual(unknowns: Any) -> Any:
        return bearing.residual(load, bearing.evaluate(1000.0, unknowns))

    steps = 1e-6 * np.eye(37)
    numerical = np.array([residual(at + h) - residual(at - h) for h in steps]).T / 2e-6
    # but for the change of K with the angle
    assert np.abs(exact - numerical).max() < 1e-3 * np.abs(numerical).max()


def test_slices_coupled_by_scipy_are_the_same(module: Any) -> None:
    findings = module("line_contact").measure(4, 2, 1)
    assert findings.failures == []
    assert all(figure.value > 0.0 for figure in findings.figures)


def test_rollers_on_a_ring_by_scipy_are_the_same(module: Any) -> None:
    findings = module("rollers").measure(4, 2, 0)
    assert findings.failures == []
    assert all(figure.value > 0.0 for figure in findings.figures)


def test_random_cases(module: Any) -> None:
    robustness = module("robustness")
    for name in robustness.KINDS:
        findings = robustness.measure(name, 40)
        assert findings.failures == []


def test_a_case_that_does_not_converge_is_a_failure(module: Any) -> None:
    throughput, sets = module("throughput"), module("duty_sets")
    batch_of = importlib.import_module("rolamento").solve
    batch = batch_of(sets.example(), **sets.tilts_held(5))
    batch.status.number[2] = 2
    assert "2 (not_converged)" in throughput.complaints("set", batch, False)[0]


def test_import_time(module: Any) -> None:
    findings = module("start")._measure("python", [module("start").sys.executable, "-V"], 1, 5.0)
    assert findings.failures == []
    assert findings.figures[0].target is not None


def test_a_command_that_fails_is_a_failure(module: Any) -> None:
    start = module("start")
    findings = start._measure("python", [start.sys.executable, "-c", "raise SystemExit(3)"], 1, 5.0)
    assert "exit code 3" in findings.failures[0]


def test_table_and_file(module: Any, tmp_path: Path) -> None:
    main, figures = module("__main__"), module("figures")
    target = figures.at_least(100.0, 50.0)
    findings = figures.Findings(
        [figures.Figure("set", "rate", np.float64(70.0), "cases/s", target)], [], []
    )
    console = Console(record=True, width=100)
    main.show(findings, False, console)
    assert "≥ 50" in console.export_text()
    main.write_json(findings, True, tmp_path / "figures.json")
    row = json.loads((tmp_path / "figures.json").read_text(encoding="utf-8"))["figures"][0]
    assert (row["target"], row["reached"]) == (100.0, False)


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs processes of POSIX")
def test_faults(module: Any, tmp_path: Path) -> None:
    """One trial of a damaged file, and what is counted as a bad end."""
    faults = module("faults")
    random = Random(1)
    assert len({faults.damaged(bytes(range(256)), random) for _ in range(20)}) > 15
    ended = faults.command(tmp_path, "solve", "nothing.toml")
    assert (ended.code, ended.wrong(60.0)) == (2, "")
    assert replace(ended, code=-11).wrong(60.0) == "crash (-11)"
    assert replace(ended, said="Exception ignored in: …\n").wrong(60.0) == "traceback"
    assert replace(ended, said="one\ntwo\n").wrong(60.0) == "not one message"
    assert replace(ended, seconds=61.0).wrong(60.0) == "late"
    assert replace(ended, memory=1e10).wrong(60.0) == "memory"
    tried = faults.Tried("a kind")
    tried.take("message", ended, 60.0, "it")
    tried.take("message", replace(ended, code=-11), 60.0, "it")
    assert (tried.trials, len(tried.bad)) == (2, 1)
    assert "| a kind | 2 | crash (-11): 1, message: 1 | 1 |" in faults.page([tried], "")
