"""The pages of life tests and their plans: every name has its words, no line is too wide."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any, get_args

import numpy as np
import pytest

from rolamento.document import Document, Medium
from rolamento.document.terminal import terminal
from rolamento.io.json import dumps
from rolamento.pages.lives import alike, written
from rolamento.pages.weibull import BOUND_METHODS, FITS, HYPOTHESES, SCHEMES, weibull_page
from rolamento.pages.weibull_plan import demonstration_page, precision_page
from rolamento.tasks.weibull import DemonstrationTest, PrecisionTest
from rolamento.weibull import (
    FIT_METHODS,
    METHODS,
    LifeTest,
    LifeTestRequest,
    LifeTestSummary,
    Scheme,
    ShapePrior,
    against_calculated_life,
    all_bounds,
    published_life_test,
    summarise,
)
from rolamento.words import Note, speaking
from rolamento.words.sentences import sentences

SAMPLES = 300
WIDTHS = (80, 120)
EVERY = pytest.mark.parametrize("language", ["en", "pt"])


def summary(name: str = "campanha_2008", **keywords: Any) -> LifeTestSummary:
    by_group = keywords.pop("by_group", True)
    wanted = LifeTestRequest(samples=SAMPLES, **keywords)
    return summarise(published_life_test(name), wanted, by_group=by_group)


def shown(
    page: Callable[[Any], Document], found: Any, language: str = "en", medium: Medium | None = None
) -> str:
    with speaking(language):
        return terminal(page(found), medium)


def advice(key: str, language: str) -> str:
    with speaking(language):
        return Note(key).text


# --- words -----------------------------------------------------------------------------------


def test_every_name_of_the_engine_has_words() -> None:
    assert set(SCHEMES) == set(get_args(Scheme))
    assert set(FITS) == {*FIT_METHODS, "fixed_shape"}
    assert set(BOUND_METHODS) == set(METHODS)
    assert set(HYPOTHESES) == {"common_shape", "same_life", "homogeneous"}


def test_every_status_has_advice() -> None:
    said = sentences()
    codes = {
        *("no_failures", "one_failure", "no_spread", "no_maximum", "not_converged"),
        *("not_modelled", "too_large", "no_mean", "group_without_fit"),
    }
    assert {f"weibull_{code}" for code in codes} <= said.keys()
    plans = {"not_shown", "too_many_bearings", "too_long", "too_few_failures"}
    assert {f"plan_{code}" for code in (*plans, "too_many_failures", "not_reached")} <= said.keys()
    for key in said:
        if key.startswith(("weibull_", "plan_")):
            assert Note(key).text.endswith(".")


# --- pages -----------------------------------------------------------------------------------


CASES: tuple[dict[str, Any], ...] = (
    {"calculated": {"ISO 281": 58.0, "a very long name of a life": 189.0}, "times": (100.0,)},
    {"shape": 1.5, "calculated": {"ISO 281": 58.0}},
    {"prior": ShapePrior(1.0, 2.5), "by_group": False, "methods": FIT_METHODS},
    {"sides": "upper", "bounds": "bootstrap_bca"},
    {"name": "lieblein_zelen_1956", "methods": FIT_METHODS, "reliabilities": (0.999, 0.9, 0.5)},
)


@EVERY
@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_no_line_is_wider_than_the_page(case: dict[str, Any], width: int, language: str) -> None:
    text = shown(weibull_page, summary(**case), language, Medium(width))
    assert max(map(len, text.splitlines())) <= width
    assert "nan" not in text.lower().replace("finan", "")
    assert "{" not in text


@EVERY
def test_the_page_can_be_plain_ascii(language: str) -> None:
    text = shown(weibull_page, summary(shape=1.5), language, Medium(encoding="ascii"))
    assert text.isascii()
    assert "?" not in text


def test_numbers_are_those_of_the_engine() -> None:
    test = published_life_test("lieblein_zelen_1956")
    (bound,) = all_bounds(test, ["L10"], samples=SAMPLES)
    text = shown(weibull_page, summary("lieblein_zelen_1956"))
    (line,) = [line for line in text.splitlines() if line.startswith("  L10 Mrev")]
    cells = [float(cell) for cell in line.split()[2:]]
    expected = [bound.estimate, bound.lower, bound.upper, bound.upper / bound.lower]
    np.testing.assert_allclose(cells, expected, rtol=2e-3)


def test_the_verdict_is_that_of_the_engine() -> None:
    test = published_life_test("campanha_2008").by_group()["I"]
    for life in (20.0, 58.0, 600.0):
        verdict = against_calculated_life(test, life, samples=SAMPLES)
        found = summary(calculated={"it": life})
        text = shown(weibull_page, found)
        (line,) = [line for line in text.splitlines() if line.startswith("  it ")]
        ending = f"yes: {verdict.bearings_live}" if verdict.bearings_live else "no"
        assert line.endswith(ending)
        live = {"longer": "last longer", "shorter": "fail sooner"}.get(verdict.bearings_live)
        said = f"contradict it: the bearings {live}"
        assert (said if verdict.bearings_live else "contradict none") in text


def test_the_shape_is_judged_by_its_bounds() -> None:
    random = np.random.default_rng(8)
    for shape, said in ((0.5, "Shape below 1"), (4.0, "Shape above 1")):
        test = LifeTest(100.0 * random.weibull(shape, 40))
        text = shown(weibull_page, summarise(test, LifeTestRequest(samples=SAMPLES)))
        assert said in text
        assert "lies outside the bounds" in text
    text = shown(
        weibull_page, summarise(LifeTest([10.0, 20.0, 60.0]), LifeTestRequest(samples=SAMPLES))
    )
    assert "Shape 1 lies within the bounds" in text
    assert "Fewer than five failures" in text


def test_numbers_far_out_stay_short() -> None:
    for scale in (1e-25, 1e25):
        test = LifeTest(scale * np.array([1.0, 2.0, 5.0, 9.0]))
        text = shown(
            weibull_page,
            summarise(test, LifeTestRequest(samples=SAMPLES, calculated={"it": scale})),
        )
        assert max(map(len, text.splitlines())) <= 80
        assert ("e25" if scale > 1.0 else "e-25") in text


@pytest.mark.parametrize(
    ("ends", "share", "said"),
    [
        ((0.097, 168.646), False, ["0.0970", "169"]),
        ((0.5, 12345.6), False, ["0.500", "12 300"]),
        ((55.061, 71.639), False, ["55.06", "71.64"]),
        ((1.08, 9321.4), False, ["1.08", "9320"]),
        ((0.0005, 0.99976), True, ["0.050", "99.976"]),
    ],
)
def test_an_interval_has_the_figures_that_its_width_supports(
    ends: tuple[float, float], share: bool, said: list[str]
) -> None:
    assert [written(one) for one in alike(ends, share=share)] == said


def test_factors_of_little_known_lives_have_few_figures() -> None:
    test = LifeTest(np.array([0.5, 40.0, 300.0]))
    text = shown(weibull_page, summarise(test, LifeTestRequest(samples=SAMPLES)))
    assert not re.findall(r"factor of [\d ]*[1-9]\d\d\b", text)
    assert re.search(r"factor of\s", text)


def test_groups_that_differ_are_told_apart() -> None:
    random = np.random.default_rng(10)
    test = LifeTest(
        np.concatenate([random.weibull(1.5, 15), 20.0 * random.weibull(1.5, 15)]),
        group=["short"] * 15 + ["long"] * 15,
    )
    found = summarise(test, LifeTestRequest(samples=SAMPLES))
    text = shown(weibull_page, found)
    assert "The groups differ (equal lives, at a common shape: p = " in text
    assert "L10 of short over long: 0.0" in text
    headings = [line for line in text.splitlines() if "Weibull fit" in line]
    assert headings == [f"{name}: Weibull fit (lives in h)" for name in ("short", "long")]
    ratio = found.ratios[0]
    assert f"common shape {ratio.shape:.3g}".rstrip("0") in " ".join(text.split())


def test_json_has_null_for_what_does_not_exist() -> None:
    data = json.loads(dumps(summary().to_mapping()))
    assert (data["schema"], data["kind"]) == (2, "weibull")
    first, second = data["groups"]
    assert second["fits"][0]["shape"] is None
    assert second["bounds"][0]["lower"] is None
    assert first["posterior"] is None
    assert data["life_ratios"][0]["ratio"] is None


# --- plans -----------------------------------------------------------------------------------


@EVERY
@pytest.mark.parametrize("width", WIDTHS)
def test_plans_fit_the_page(width: int, language: str) -> None:
    demonstrated = DemonstrationTest(
        life="12000 Mrev", shape=1.3, bearings=12, failures_allowed=1
    ).run()
    known = PrecisionTest(ratio=5.0, shape=1.1, life="25000 h", samples=SAMPLES).run()
    told = PrecisionTest(failures=6, groups=6, group_sizes=[4], samples=SAMPLES).run()
    pages = [
        shown(demonstration_page, demonstrated, language, Medium(width)),
        shown(precision_page, known, language, Medium(width)),
        shown(precision_page, told, language, Medium(width)),
    ]
    for page in pages:
        assert max(map(len, page.splitlines())) <= width
        assert "nan" not in page
        assert "{" not in page


@EVERY
def test_plans_without_result_give_advice(language: str) -> None:
    failed = DemonstrationTest(life="1000 h", bearings=2, time=10.0).run()
    page = " ".join(shown(demonstration_page, failed, language).split())
    assert advice("plan_not_shown", language) in page
    unreachable = PrecisionTest(ratio=1.5, groups=5, life="1000 h", samples=SAMPLES).run()
    page = " ".join(shown(precision_page, unreachable, language).split())
    assert advice("plan_not_reached", language) in page


def test_sudden_death_is_weighed_against_the_full_test() -> None:
    found = PrecisionTest(ratio=5.0, life="1000 h", samples=SAMPLES).run()
    text = " ".join(shown(precision_page, found).split())
    plans, full = found.plans, found.plans[0]
    fastest = min((p for p in plans if p.group_size > 1), key=lambda p: p.duration.mean)  # type: ignore[union-attr]
    assert f"Testing {full.bearings} bearings until all have failed" in text
    assert f"{fastest.groups} groups of {fastest.group_size}" in text


def test_json_of_plans() -> None:
    found = DemonstrationTest(life="1000 h", bearings=10).run()
    data = json.loads(dumps(found.to_mapping()))
    assert (data["unit"], data["time"]) == ("h", found.plan.time)
    chance = {one["life_ratio"]: one["chance"] for one in data["chance_of_passing"]}
    assert chance[2.0] == pytest.approx(0.1 ** (2.0**-1.5))
    assert len(data["alternatives"]) == 33
    data = json.loads(dumps(PrecisionTest(failures=1).run().to_mapping()))
    assert data["plans"][0]["ratio"] is None
    assert data["plans"][0]["duration"] is None
