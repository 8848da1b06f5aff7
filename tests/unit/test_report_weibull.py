"""The pages of life tests and their plans: every name has its words, no line is too wide."""

from __future__ import annotations

import json
from dataclasses import fields
from typing import Any, get_args

import numpy as np
import pytest

from rolamento.document.medium import Medium
from rolamento.report.language import LANGUAGES, Words
from rolamento.report.weibull import weibull_json, weibull_report
from rolamento.report.weibull_plan import (
    demonstration_json,
    demonstration_report,
    precision_json,
    precision_report,
)
from rolamento.report.weibull_plan_words import PLAN_WORDS
from rolamento.report.weibull_sentences import said_advice, said_note
from rolamento.report.weibull_words import WEIBULL_WORDS
from rolamento.tasks.weibull import demonstration_study, precision_study
from rolamento.weibull import (
    ADVICE,
    FIT_METHODS,
    METHODS,
    NOTES,
    PLAN_ADVICE,
    LifeTest,
    LifeTestSummary,
    Scheme,
    ShapePrior,
    Wanted,
    against_calculated_life,
    all_bounds,
    published_life_test,
    summarise,
)

SAMPLES = 300
WIDTHS = (80, 120)
EVERY = pytest.mark.parametrize("words", LANGUAGES.values(), ids=LANGUAGES)


def summary(name: str = "campanha_2008", **keywords: Any) -> LifeTestSummary:
    by_group = keywords.pop("by_group", True)
    wanted = Wanted(samples=SAMPLES, **keywords)
    return summarise(published_life_test(name), wanted, by_group=by_group)


# --- words -----------------------------------------------------------------------------------


@pytest.mark.parametrize("code", LANGUAGES)
def test_every_name_of_the_engine_has_words(code: str) -> None:
    said = WEIBULL_WORDS[code]
    assert set(said.schemes) == set(get_args(Scheme))
    assert set(said.fits) == {*FIT_METHODS, "fixed_shape"}
    assert set(said.bound_methods) == set(METHODS)
    assert set(said.hypotheses) == {"common_shape", "same_life", "homogeneous"}
    for name in NOTES:
        assert said_note(name, code) != name
    for name in (*ADVICE, *PLAN_ADVICE):
        assert said_advice(name, code) != name


def test_portuguese_is_not_english() -> None:
    for english, portuguese in (
        (WEIBULL_WORDS["en"], WEIBULL_WORDS["pt"]),
        (PLAN_WORDS["en"], PLAN_WORDS["pt"]),
    ):
        same = [
            field.name
            for field in fields(english)
            if getattr(english, field.name) == getattr(portuguese, field.name)
        ]
        assert set(same) <= {"p_value", "reliability_at", "from_to"}
    for name in NOTES:
        assert said_note(name, "pt") != said_note(name, "en")
    for name in (*ADVICE, *PLAN_ADVICE):
        assert said_advice(name, "pt") != said_advice(name, "en")


def test_a_name_that_is_new_is_said_as_the_engine_says_it() -> None:
    assert said_note("brand_new", "pt") == "brand_new"
    assert said_advice("brand_new", "en") == "brand_new"


def placeholders(text: Any) -> list[str]:
    from string import Formatter

    texts = text if isinstance(text, tuple) else (text,)
    return sorted({name for t in texts for _, name, _, _ in Formatter().parse(t) if name})


def test_both_languages_fill_in_the_same() -> None:
    for words in (WEIBULL_WORDS, PLAN_WORDS):
        for field in fields(words["en"]):
            english = getattr(words["en"], field.name)
            portuguese = getattr(words["pt"], field.name)
            if isinstance(english, str | tuple):
                assert placeholders(english) == placeholders(portuguese), field.name
            else:
                assert set(english) == set(portuguese), field.name


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
def test_no_line_is_wider_than_the_page(case: dict[str, Any], width: int, words: Words) -> None:
    text = weibull_report(summary(**case), words, Medium(width))
    assert max(map(len, text.splitlines())) <= width
    assert "nan" not in text.lower().replace("finan", "")
    assert "{" not in text


@EVERY
def test_the_page_can_be_plain_ascii(words: Words) -> None:
    text = weibull_report(summary(shape=1.5), words, Medium(encoding="ascii"))
    assert text.isascii()
    assert "?" not in text


def test_numbers_are_those_of_the_engine() -> None:
    test = published_life_test("lieblein_zelen_1956")
    (bound,) = all_bounds(test, ["L10"], samples=SAMPLES)
    text = weibull_report(summary("lieblein_zelen_1956"))
    (line,) = [line for line in text.splitlines() if line.startswith("  L10 Mrev")]
    shown = [float(cell) for cell in line.split()[2:]]
    expected = [bound.estimate, bound.lower, bound.upper, bound.upper / bound.lower]
    np.testing.assert_allclose(shown, expected, rtol=2e-3)


def test_the_verdict_is_that_of_the_engine() -> None:
    test = published_life_test("campanha_2008").by_group()["I"]
    for life in (20.0, 58.0, 600.0):
        verdict = against_calculated_life(test, life, samples=SAMPLES)
        found = summary(calculated={"it": life})
        text = weibull_report(found)
        (line,) = [line for line in text.splitlines() if line.startswith("  it ")]
        ending = f"yes: {verdict.bearings_live}" if verdict.bearings_live else "no"
        assert line.endswith(ending)
        said = f"contradict it: the bearings live {verdict.bearings_live}"
        assert (said if verdict.bearings_live else "contradict none") in text


def test_the_shape_is_judged_by_its_bounds() -> None:
    random = np.random.default_rng(8)
    for shape, said in ((0.5, "Shape below 1"), (4.0, "Shape above 1")):
        test = LifeTest(100.0 * random.weibull(shape, 40))
        text = weibull_report(summarise(test, Wanted(samples=SAMPLES)))
        assert said in text
        assert "lies outside the bounds" in text
    text = weibull_report(summarise(LifeTest([10.0, 20.0, 60.0]), Wanted(samples=SAMPLES)))
    assert "Shape 1 lies within the bounds" in text
    assert "Fewer than five failures" in text


def test_numbers_far_out_stay_short() -> None:
    for scale in (1e-25, 1e25):
        test = LifeTest(scale * np.array([1.0, 2.0, 5.0, 9.0]))
        text = weibull_report(summarise(test, Wanted(samples=SAMPLES, calculated={"it": scale})))
        assert max(map(len, text.splitlines())) <= 80
        assert ("e+25" if scale > 1.0 else "e-25") in text


def test_groups_that_differ_are_told_apart() -> None:
    random = np.random.default_rng(10)
    test = LifeTest(
        np.concatenate([random.weibull(1.5, 15), 20.0 * random.weibull(1.5, 15)]),
        group=["short"] * 15 + ["long"] * 15,
    )
    found = summarise(test, Wanted(samples=SAMPLES))
    text = weibull_report(found)
    assert "The groups differ: one life, at one shape has p = " in text
    assert "L10 of short over that of long: 0.0" in text
    ratio = found.ratios[0]
    assert f"at one shape of {ratio.shape:.3g}".rstrip("0") in " ".join(text.split())


def test_json_has_null_for_what_does_not_exist() -> None:
    data = json.loads(weibull_json(summary()))
    assert (data["schema"], data["kind"]) == (1, "weibull")
    first, second = data["groups"]
    assert second["fits"][0]["shape"] is None
    assert second["bounds"][0]["lower"] is None
    assert first["posterior"] is None
    assert data["life_ratios"][0]["ratio"] is None


# --- plans -----------------------------------------------------------------------------------


@EVERY
@pytest.mark.parametrize("width", WIDTHS)
def test_plans_fit_the_page(width: int, words: Words) -> None:
    shown = demonstration_study("12000 Mrev", shape=1.3, bearings=12, failures_allowed=1)
    known = precision_study(5.0, shape=1.1, life="25000 h", samples=SAMPLES)
    told = precision_study(failures=6, groups=6, group_sizes=[4], samples=SAMPLES)
    pages = [
        demonstration_report(shown, words, Medium(width)),
        precision_report(known, words, Medium(width)),
        precision_report(told, words, Medium(width)),
    ]
    for page in pages:
        assert max(map(len, page.splitlines())) <= width
        assert "nan" not in page
        assert "{" not in page


@EVERY
def test_plans_without_result_give_advice(words: Words) -> None:
    failed = demonstration_study("1000 h", bearings=2, time=10.0)
    advice = " ".join(said_advice("not_shown", words.code).split())
    page = " ".join(demonstration_report(failed, words).split())
    assert advice in page
    unreachable = precision_study(1.5, groups=5, life="1000 h", samples=SAMPLES)
    page = " ".join(precision_report(unreachable, words).split())
    assert " ".join(said_advice("not_reached", words.code).split()) in page


def test_sudden_death_is_weighed_against_the_full_test() -> None:
    found = precision_study(5.0, life="1000 h", samples=SAMPLES)
    text = " ".join(precision_report(found).split())
    plans, full = found.plans, found.plans[0]
    fastest = min((p for p in plans if p.group_size > 1), key=lambda p: p.duration.mean)  # type: ignore[union-attr]
    assert f"{full.bearings} bearings run until all have failed" in text
    assert f"Sudden death in {fastest.groups} groups of {fastest.group_size}" in text


def test_json_of_plans() -> None:
    found = demonstration_study("1000 h", bearings=10)
    data = json.loads(demonstration_json(found))
    assert (data["unit"], data["time"]) == ("h", found.plan.time)
    chance = {one["life_ratio"]: one["chance"] for one in data["chance_of_passing"]}
    assert chance[2.0] == pytest.approx(0.1 ** (2.0**-1.5))
    assert len(data["alternatives"]) == 33
    data = json.loads(precision_json(precision_study(failures=1)))
    assert data["plans"][0]["ratio"] is None
    assert data["plans"][0]["duration"] is None
