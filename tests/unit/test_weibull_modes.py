"""Failure modes that compete: tables, fits, the whole, pages, commands and decisions."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import optimize
from scipy.stats import weibull_min
from tests.field_data import as_table, field_data
from typer.testing import CliRunner

from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.tasks.replace import RemainingLifeRequest, ReplacementRequest
from rolamento.tasks.weibull import life_test_study
from rolamento.weibull import (
    Estimand,
    LifeTest,
    LifeTestRequest,
    maximum_likelihood,
    parse_life_test,
    series_life,
    summarise,
    system_of_modes,
)
from rolamento.words import speaking

Run = Callable[..., tuple[int, str, str]]
FEW = ("--samples", "200")


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "field.csv").write_text(as_table(field_data()), encoding="utf-8")

    def runner(*arguments: str, given: str | None = None) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, input=given, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


# --- data ------------------------------------------------------------------------------------


def test_other_modes_are_suspensions() -> None:
    test = LifeTest([1.0, 2, 3, 4], [True, True, True, False], mode=["a", "b", "", "a"])
    assert test.modes == ("a", "b", "")
    assert test.unknown_modes == 1
    assert test.mode.tolist() == ["a", "b", "", ""]  # a suspended bearing has none
    one = test.for_mode("a")
    assert one.failed.tolist() == [True, False, False, False]
    assert (one.size, one.modes) == (4, ())
    assert test.for_mode("a", or_unknown=True).failures == 2
    assert list(test.by_mode()) == ["a", "b", "unknown mode"]
    with pytest.raises(InputError, match="the modes are a, b, unknown mode"):
        test.for_mode("c")
    with pytest.raises(InputError, match="which have none"):
        LifeTest([1.0, 2.0]).for_mode("a")


def test_without_a_mode_there_are_none() -> None:
    assert LifeTest([1.0, 2.0]).modes == ()
    assert LifeTest([1.0, 2.0], mode="a").modes == ("a",)


def test_a_failure_by_another_mode_found_at_an_inspection_was_last_seen_before() -> None:
    test = LifeTest(
        [10.0, 10, 20, 30], [True, True, True, False], lower=[0.0, 0, 10, np.nan],
        mode=["a", "b", "b", ""],
    )  # fmt: skip
    one = test.for_mode("a")
    assert one.times.tolist() == [10.0, 10.0, 30.0]  # the one never seen whole says nothing
    assert one.failed.tolist() == [True, False, False]
    assert one.lower[0] == 0.0


def test_rows_keep_their_modes() -> None:
    test = field_data()
    assert test.select(test.failed).modes == test.modes
    assert test.by_group()[""].modes == test.modes


@pytest.mark.parametrize("title", ["mode", "Failure mode", "Modo de falha", "causa da falha"])
def test_modes_are_read_under_usual_names(title: str) -> None:
    test = parse_life_test(f"time,status,{title}\n1,f,a\n2,f,?\n3,f,unknown\n4,f,b\n5,s,\n")
    assert test.modes == ("a", "b", "")
    assert test.unknown_modes == 2


def test_a_column_of_modes_can_be_chosen() -> None:
    text = "time,status,what\n1,f,a\n2,f,b\n5,s,\n"
    assert parse_life_test(text).modes == ()
    assert parse_life_test(text, mode="what").modes == ("a", "b")


def test_without_a_status_the_modes_say_what_failed() -> None:
    test = parse_life_test("Hours,Mode\n2,E\n3,D\n5,Cen\n8,suspended\n9,0\n")
    assert test.failed.tolist() == [True, True, False, False, False]
    assert test.modes == ("E", "D")
    with pytest.raises(InputError, match="is blank, and no column says what failed") as raised:
        parse_life_test("Hours,Mode\n2,E\n3,\n")
    assert raised.value.line == 3


def test_modes_taken_for_groups_are_asked_about() -> None:
    """A group that only failed bearings have makes a population of the failures alone."""
    with pytest.raises(InputError, match="seems to hold failure modes") as raised:
        parse_life_test(as_table(field_data()), group="Modo de falha")
    assert raised.value.example == 'mode="Modo de falha"'
    text = "time,status,group\n1,f,a\n2,f,b\n3,s,\n"
    with pytest.raises(InputError, match="seems to hold failure modes"):
        parse_life_test(text)
    whole = parse_life_test("time,status,group\n1,f,a\n2,f,b\n3,s,b\n")
    assert list(whole.by_group()) == ["a", "b"]


def test_modes_of_suspended_bearings_are_named() -> None:
    test = parse_life_test("time,status,mode\n1,f,a\n2,f,b\n3,s,a\n")
    assert [note.key for note in test.notes] == ["modes_of_suspended"]


def test_group_names_are_never_empty() -> None:
    test = LifeTest([1.0, 2, 3, 4, 5, 6], group=["a", "a", "a", "", "", ""])
    found = summarise(test, LifeTestRequest(samples=200))
    assert [group.name for group in found.groups] == ["a", "(blank)"]
    only = life_test_study(test, only=["(blank)"], samples=200)
    assert only.test.size == 3


# --- fits ------------------------------------------------------------------------------------


def scipy_fit(test: LifeTest) -> tuple[float, float, float]:
    """Shape, scale and log-likelihood by another maximiser of another density."""

    def cost(x: np.ndarray[Any, Any]) -> float:
        law = weibull_min(np.exp(x[0]), scale=np.exp(x[1]))
        return -float(
            law.logpdf(test.times[test.failed]).sum() + law.logsf(test.times[~test.failed]).sum()
        )

    found = optimize.minimize(
        cost, [0.0, np.log(test.times.mean())], method="Nelder-Mead",
        options={"xatol": 1e-9, "fatol": 1e-10, "maxiter": 4000},
    )  # fmt: skip
    return float(np.exp(found.x[0])), float(np.exp(found.x[1])), -float(found.fun)


def test_each_mode_is_fitted_with_the_others_suspended() -> None:
    test = field_data()
    for name in test.modes:
        fit = maximum_likelihood(test.for_mode(name))
        shape, scale, value = scipy_fit(test.for_mode(name))
        assert (fit.shape, fit.scale) == pytest.approx((shape, scale), rel=1e-5)
        assert fit.log_likelihood == pytest.approx(value, abs=1e-6)


def test_the_trap_of_pooled_modes() -> None:
    """Pooled, β is near 1 and says nothing; each mode has the shape that it was drawn with."""
    found = summarise(field_data(), LifeTestRequest(samples=1000, confidence=0.98))
    assert found.system is not None
    by_name = {group.name: group for group in found.groups}
    assert found.system.pooled.shape == pytest.approx(1.055, abs=0.001)
    assert by_name["fatigue"].main.shape == pytest.approx(3.28, abs=0.01)
    assert by_name["fatigue"].main.l10 == pytest.approx(11_391.0, rel=1e-3)
    assert by_name["mounting"].main.shape == pytest.approx(0.540, abs=0.001)
    for name, shape in (("fatigue", 3.2), ("mounting", 0.8)):
        bound = by_name[name].bound(Estimand.of("shape"))
        assert bound is not None
        assert bound.contains(shape)
        assert not by_name[name].goodness.contradicted
    assert found.system.goodness.bent is not None
    assert found.system.log_likelihood > found.system.log_likelihood_pooled + 2.0


def test_the_whole_is_the_product_of_the_modes() -> None:
    test = field_data()
    whole = system_of_modes(
        test, [Estimand.of(one) for one in ("L10", "L50", "R10000")], samples=300
    )
    fits = [maximum_likelihood(test.for_mode(name)) for name in test.modes]
    shapes, scales = [fit.shape for fit in fits], [fit.scale for fit in fits]
    lives = series_life([0.9, 0.5], shapes, scales)
    assert [one.estimate for one in whole.bounds[:2]] == pytest.approx(lives.tolist(), rel=1e-9)
    alive = float(np.prod([fit.reliability_at(10_000.0) for fit in fits]))
    assert whole.bounds[2].estimate == pytest.approx(alive, rel=1e-12)
    assert float(whole.reliability_at(np.array(10_000.0))) == pytest.approx(alive, rel=1e-12)
    for bound in whole.bounds:
        assert bound.lower < bound.estimate < bound.upper
    assert sum(one.hazard_share for one in whole.modes) == pytest.approx(1.0)
    # of the modes' joint likelihood, and of the times alone: each failure had one of the modes
    joint = sum(fit.log_likelihood for fit in fits)
    assert joint < whole.log_likelihood
    assert whole.life_at_ordinate(np.log(-np.log([0.9])))[0] == pytest.approx(lives[0])


def test_unknown_modes_lead_and_are_bracketed() -> None:
    plain = field_data()
    modes = plain.mode.copy()
    modes[np.flatnonzero(modes == "fatigue")[:3]] = ""
    test = LifeTest(plain.times, plain.failed, mode=modes)
    whole = system_of_modes(test, [Estimand.of("L10")], samples=200)
    assert whole.unknown == 3
    assert [one.name for one in whole.modes] == ["mounting", "fatigue", "unknown mode"]
    fatigue = whole.modes[1]
    assert fatigue.earliest is not None
    assert fatigue.earliest.l10 == pytest.approx(maximum_likelihood(plain.for_mode("fatigue")).l10)
    assert fatigue.fit.life_at(0.5) > fatigue.earliest.life_at(0.5)
    assert "modes_unknown" in [note.key for note in whole.notes]


def test_a_mode_without_a_fit_leaves_the_whole_without_one() -> None:
    test = LifeTest([1.0, 2, 3, 4, 5], mode=["a", "a", "a", "a", "b"])
    whole = system_of_modes(test, [Estimand.of("L10")], samples=200)
    assert (whole.code, whole.bounds) == ("mode_without_fit", ())
    assert np.isnan(whole.log_likelihood)
    known = system_of_modes(test, [Estimand.of("L10")], shape=2.0, samples=200)
    assert known.converged
    assert known.bounds[0].lower < known.bounds[0].upper


def test_inspected_modes_are_put_together() -> None:
    random = np.random.default_rng(5)
    one, other = 100.0 * random.weibull(3.0, 300), 150.0 * random.weibull(1.0, 300)
    times, ends = np.minimum(one, other), np.arange(10.0, 201.0, 10.0)
    cell = np.searchsorted(ends, times)
    failed = cell < len(ends)
    upper = ends[np.minimum(cell, len(ends) - 1)]
    lower = np.where(failed, upper - 10.0, np.nan)
    mode = np.where(one < other, "wear", "shock")
    test = LifeTest(upper, failed, lower=lower, mode=mode)
    whole = system_of_modes(test, [Estimand.of("L50")], samples=200)
    assert "modes_at_inspections" in [note.key for note in whole.notes]
    shapes = {m.name: m.fit.shape for m in whole.modes}
    assert shapes["wear"] == pytest.approx(3.0, abs=0.5)
    assert shapes["shock"] == pytest.approx(1.0, abs=0.2)
    assert whole.bounds[0].estimate == pytest.approx(float(np.median(times)), rel=0.1)


def test_groups_and_modes_at_once_are_asked_about() -> None:
    test = field_data()
    lots = LifeTest(test.times, test.failed, mode=test.mode, group=["A", "B"] * 20)
    with pytest.raises(InputError, match="2 groups and 2 failure modes"):
        summarise(lots, LifeTestRequest(samples=200))
    compared = life_test_study(lots, only_mode="FATIGUE", samples=200)
    assert [group.name for group in compared.groups] == ["A", "B"]
    assert compared.test.failures == 12
    assert compared.comparisons
    parted = life_test_study(lots, only=["A"], samples=200)
    assert parted.system is not None
    pooled = life_test_study(lots, by_group=False, by_mode=False, samples=200)
    assert [note.key for note in pooled.notes] == ["modes_pooled"]


# --- one kind of bound, a known shape ----------------------------------------------------------


def test_lower_bounds_of_a_page_have_one_confidence() -> None:
    test = LifeTest([1.0, 2, 3, 4, 5, 5], [True] * 4 + [False] * 2, group=["a"] * 4 + ["b"] * 2)
    found = summarise(test, LifeTestRequest(samples=200))
    both = [found.groups[0].bounds[0], found.groups[1].assumed[0].bounds[0]]
    assert [bound.one_sided_confidence for bound in both] == [0.95, 0.95]


def test_a_known_shape_is_used_by_every_method() -> None:
    test = field_data().for_mode("fatigue")
    (group,) = summarise(test, LifeTestRequest(shape=2.0, samples=200)).groups
    assert [fit.method for fit in group.fits] == ["fixed_shape", "rank_regression_x_on_y"]
    assert [fit.shape for fit in group.fits] == [2.0, 2.0]
    for method in ("unbiased", "three_parameter"):
        with pytest.raises(InputError, match="fits the shape too"):
            LifeTestRequest(shape=2.0, methods=(method,))  # type: ignore[arg-type]


# --- pages and commands ------------------------------------------------------------------------


def test_the_page_has_every_mode_and_the_whole(run: Run) -> None:
    code, out, err = run("weibull", "field.csv", *FEW)
    assert (code, err) == (0, "")
    for text in (
        "40 bearings, 23 failed, 17 suspended; 2 failure modes",
        "mounting: 11 of 40 bearings failed by it",
        "fatigue: 12 of 40 bearings failed by it",
        "All modes together (90 % bounds)",
        "The data do not contradict a Weibull distribution",
        "independent of each other",
    ):
        assert " ".join(text.split()) in " ".join(out.split())
    assert out.index("All modes together") < out.index("mounting: 11 of 40")


def test_pooled_modes_are_said_first(run: Run) -> None:
    code, out, _ = run("weibull", "field.csv", "--modes-pooled", "--samples", "1000")
    assert code == 0
    text = " ".join(out.split())
    assert text.index("Failures by 2 different modes") < text.index("With 95 % confidence")
    assert text.index("has a dog-leg at about") < text.index("With 95 % confidence")
    assert "two failure modes, Weibull each" in text
    assert "AICc" in text


def test_one_mode_is_said_first(run: Run) -> None:
    code, out, _ = run("weibull", "field.csv", "--mode", "fatigue", *FEW)
    assert code == 0
    text = " ".join(out.split())
    assert "the 11 failures by other modes are taken as suspensions" in text
    code, out, err = run("weibull", "field.csv", "--mode", "wear")
    assert (code, out) == (2, "")
    assert "--mode" in err
    assert "the modes are" in err


def test_the_json_has_modes_system_and_tests(run: Run) -> None:
    code, out, _ = run("weibull", "field.csv", "--json", "--models", *FEW)
    assert code == 0
    data = json.loads(out)
    assert data["by_mode"] is True
    assert [group["name"] for group in data["groups"]] == ["mounting", "fatigue"]
    system = data["system"]
    assert system["status"]["converged"]
    assert system["bounds"][0]["method"] == "product_of_modes"
    assert system["goodness_of_fit_pooled"]["dog_leg"]["shape_after"] > 2.0
    for group in data["groups"]:
        assert 0.0 < group["goodness_of_fit"]["p_value"] <= 1.0
        assert {model["name"] for model in group["models"]} >= {"weibull", "lognormal"}


def test_probability_paper_has_modes_and_the_whole(run: Run, tmp_path: Path) -> None:
    from rolamento.plots.weibull import weibull_figure

    assert run("weibull", "field.csv", *FEW, "--plot", "modes.svg")[0] == 0
    assert (tmp_path / "modes.svg").stat().st_size > 5000
    found = summarise(field_data(), LifeTestRequest(samples=200))
    labels = {text.get_text() for text in weibull_figure(found).axes[0].get_legend().get_texts()}
    assert {"all failures", "all modes together"} <= labels
    pooled = summarise(field_data(), LifeTestRequest(samples=1000), by_mode=False)
    labels = {text.get_text() for text in weibull_figure(pooled).axes[0].get_legend().get_texts()}
    assert any(label.startswith("dog-leg") for label in labels)


def test_the_page_speaks_portuguese(run: Run) -> None:
    code, out, _ = run("weibull", "field.csv", *FEW, "--lang", "pt")
    assert code == 0
    assert "Modos de falha" in out
    assert "Todos os modos em conjunto" in out
    with speaking("pt_BR"):
        assert list(LifeTest([1.0, 2.0], mode=["a", ""]).by_mode())[1] == "modo desconhecido"


# --- decisions ---------------------------------------------------------------------------------


def test_a_decision_asks_for_the_mode(run: Run) -> None:
    costs = ("--planned-cost", "800", "--failure-cost", "12000", *FEW)
    code, out, err = run("replace", "age", "field.csv", *costs)
    assert (code, out) == (2, "")
    assert "--mode: must be chosen" in err
    code, out, _ = run("replace", "age", "field.csv", *costs, "--mode", "fatigue")
    assert code == 0
    text = " ".join(out.split())
    assert "Replace at 7878 h: it costs 75.2 % less" in text
    assert text.index("failures by other modes") < text.index("Weibull distribution fitted")
    code, out, _ = run("replace", "age", "field.csv", *costs, "--mode", "all")
    assert code == 0
    assert "Failures by 2 different modes are taken together" in " ".join(out.split())


def test_decisions_carry_what_contradicts_them() -> None:
    test = field_data()
    pooled = ReplacementRequest(
        data=test, planned=800.0, failure=12_000.0, only_mode="all", samples=1000
    ).run()
    keys = [note.key for note in pooled.notes]
    assert keys[:2] == ["dog_leg_steeper", "modes_pooled"]
    one = RemainingLifeRequest(data=test, age=5000.0, only_mode="fatigue", samples=200).run()
    assert [note.key for note in one.notes][:2] == ["one_mode", "decision_one_mode"]
    plain = RemainingLifeRequest(
        data=LifeTest(test.times, test.failed, mode="x"), age=5000.0, samples=200
    ).run()
    assert "one_mode" not in [note.key for note in plain.notes]
