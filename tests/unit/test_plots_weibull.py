"""Probability paper and regions of likelihood: what is drawn is what the engine says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from rolamento.charts.drawing import draw
from rolamento.plots.saving import save_figure
from rolamento.plots.weibull import (
    FITS,
    contour_figure,
    paper_chart,
    regions_chart,
    weibull_figure,
)
from rolamento.plots.weibull_plan import chance_chart, cost_chart
from rolamento.weibull import (
    FIT_METHODS,
    Band,
    LifeTest,
    LifeTestRequest,
    LifeTestSummary,
    LikelihoodRegion,
    alternatives,
    confidence_band,
    demonstrate,
    likelihood_region,
    plan_for_ratio,
    plans_for_ratio,
    plotting_positions,
    published_life_test,
    summarise,
)
from rolamento.words import speaking

SAMPLES = 300


def summary(test: LifeTest, by_group: bool = True, **keywords: Any) -> LifeTestSummary:
    return summarise(test, LifeTestRequest(samples=SAMPLES, **keywords), by_group=by_group)


def bands(found: LifeTestSummary) -> dict[str, Band]:
    shape = found.request.shape
    return {g.name: confidence_band(g.test, samples=SAMPLES, shape=shape) for g in found.groups}


def regions(found: LifeTestSummary, of: str = "L10") -> dict[str, LikelihoodRegion]:
    return {g.name: likelihood_region(g.test, of, samples=SAMPLES) for g in found.groups}


@pytest.fixture(scope="module")
def campanha() -> LifeTest:
    return published_life_test("campanha_2008")


@pytest.fixture(scope="module")
def lieblein() -> LifeTest:
    return published_life_test("lieblein_zelen_1956")


def inspected() -> LifeTest:
    nan = float("nan")
    return LifeTest(
        [100, 150, 200, 250, 250], [True, True, True, True, False],
        lower=[50, 100, 150, 200, nan], counts=[1, 3, 4, 2, 10],
    )  # fmt: skip


def lines(axes: Axes, marker: str) -> list[Line2D]:
    return [line for line in axes.get_lines() if line.get_marker() == marker]


def labels(axes: Axes) -> list[str]:
    legend = axes.get_legend()
    return [] if legend is None else [text.get_text() for text in legend.get_texts()]


# --- probability paper -----------------------------------------------------------------------


def test_failures_stand_at_their_median_ranks(lieblein: LifeTest) -> None:
    axes = draw(paper_chart(summary(lieblein)))
    (points,) = lines(axes, "o")
    positions = plotting_positions(lieblein)
    np.testing.assert_array_equal(points.get_xdata(), positions.times)
    np.testing.assert_allclose(points.get_ydata(), positions.y, rtol=1e-12)
    assert axes.get_xscale() == "log"


def test_the_fit_is_a_straight_line_with_the_shape_as_slope(lieblein: LifeTest) -> None:
    found = summary(lieblein, methods=("maximum_likelihood",))
    axes = draw(paper_chart(found))
    fit = found.groups[0].main
    (line,) = [one for one in axes.get_lines() if len(np.asarray(one.get_xdata())) == 200]
    x, y = np.log(np.asarray(line.get_xdata())), np.asarray(line.get_ydata())
    np.testing.assert_allclose(np.diff(y) / np.diff(x), fit.shape, rtol=1e-9)
    assert np.interp(np.log(fit.l10), x, y) == pytest.approx(np.log(-np.log(0.9)), rel=1e-9)


def test_all_methods_are_drawn_of_one_group(lieblein: LifeTest) -> None:
    axes = draw(paper_chart(summary(lieblein, methods=FIT_METHODS)))
    said = FITS
    assert {said[name] for name in FIT_METHODS[1:]} <= set(labels(axes))
    curved = next(one for one in axes.get_lines() if one.get_label() == said["three_parameter"])
    x, y = np.log(np.asarray(curved.get_xdata())), np.asarray(curved.get_ydata())
    slope = np.diff(y) / np.diff(x)
    assert slope[0] > 3.0 * slope[-1]  # steep toward the time before which nothing fails


def test_upright_axis_is_numbered_in_percent(lieblein: LifeTest) -> None:
    axes = draw(paper_chart(summary(lieblein)))
    ticks = dict(zip(axes.get_yticklabels(), axes.get_yticks(), strict=True))
    for label, place in ticks.items():
        share = float(label.get_text()) / 100.0
        assert place == pytest.approx(np.log(-np.log(1.0 - share)), rel=1e-9)
    assert {"1", "10", "50", "99"} <= {label.get_text() for label in ticks}


def test_the_band_reaches_from_bound_to_bound(campanha: LifeTest) -> None:
    found = summary(campanha, by_group=False)
    drawn = bands(found)
    axes = draw(paper_chart(found, drawn))
    (filled,) = axes.patches
    x = np.asarray(filled.get_path().vertices)[:, 0]  # type: ignore[attr-defined]
    # clipped beyond the frame, for bounds may be anywhere
    assert x.min() <= axes.get_xlim()[0]
    assert x.max() >= axes.get_xlim()[1]
    lower = x[: len(drawn[""].lower)]
    inside = (lower > axes.get_xlim()[0]) & (lower < axes.get_xlim()[1])
    np.testing.assert_allclose(lower[inside], drawn[""].lower[inside])
    assert "90 % bounds" in labels(axes)


def test_suspended_bearings_are_ticks_at_the_foot(campanha: LifeTest) -> None:
    axes = draw(paper_chart(summary(campanha)))
    ticks = lines(axes, "|")
    assert len(ticks) == 2
    for line, name in zip(ticks, ("I", "II"), strict=True):
        part = campanha.by_group()[name]
        expected = np.unique(part.times[~part.failed])
        np.testing.assert_array_equal(line.get_xdata(), expected)
        assert np.asarray(line.get_ydata()).max() < 0.1  # of the frame's height
    assert "suspended" in labels(axes)
    assert "II: 0/10 failed, suspended" in labels(axes)


def test_groups_have_their_own_colours(campanha: LifeTest) -> None:
    test = LifeTest(
        [100.0, 200.0, 300.0, 500.0, 900.0, 1500.0], group=["a", "a", "a", "b", "b", "b"]
    )
    axes = draw(paper_chart(summary(test)))
    points = [line for line in axes.get_lines() if line.get_linestyle() == "None"]
    assert len({line.get_color() for line in points}) == 2
    assert len({line.get_marker() for line in points}) == 2
    assert [label for label in labels(axes) if label.startswith(("a: β", "b: β"))]


def test_calculated_lives_are_marked_at_their_share(campanha: LifeTest) -> None:
    found = summary(campanha, calculated={"ISO 281": 58.0}, reliabilities=(0.99,))
    axes = draw(paper_chart(found))
    (mark,) = lines(axes, "*")
    assert mark.get_xdata()[0] == 58.0
    assert mark.get_ydata()[0] == pytest.approx(np.log(-np.log(0.99)))
    assert "calculated L1: ISO 281, 58 h" in labels(axes)


def test_inspected_failures_are_bars_at_the_foot() -> None:
    axes = draw(paper_chart(summary(inspected())))
    assert not lines(axes, "o")
    bars = [np.asarray(line.get_xdata()) for line in axes.get_lines()]
    ends = [tuple(bar[:2]) for bar in bars if len(bar) == 3]
    assert ends == [(50.0, 100.0), (100.0, 150.0), (150.0, 200.0), (200.0, 250.0)]


def test_without_failures_a_lower_line_or_an_empty_frame() -> None:
    test = LifeTest([100.0], [False], counts=[8])
    assert draw(paper_chart(summary(test))).get_legend() is None
    found = summary(test, shape=1.5)
    axes = draw(paper_chart(found, bands(found)))
    assert "lower bound (90 %)" in labels(axes)
    (line,) = [one for one in axes.get_lines() if one.get_label() == "lower bound (90 %)"]
    np.testing.assert_array_equal(line.get_xdata(), bands(found)[""].lower)


def test_bounds_beyond_measure_leave_the_data_visible() -> None:
    found = summary(LifeTest([100.0, 101.0, 300.0, 400.0], [True, True, False, False]))
    axes = draw(paper_chart(found, bands(found)))
    low, high = axes.get_xlim()
    assert 100.0 / 50.0 < low < 100.0
    assert 400.0 < high < 400.0 * 50.0


def test_titles_and_units_of_others_are_only_text(tmp_path: Path) -> None:
    test = LifeTest([1.0, 2.0, 4.0], unit="$x_", title=r"$\frac{1$ \x", group=["$", "$", "$"])
    found = summary(test, calculated={"$a_": 1.0})
    save_figure(weibull_figure(found, bands(found)), tmp_path / "paper.png")
    save_figure(contour_figure(found, regions(found)), tmp_path / "contour.png")


# --- plans -----------------------------------------------------------------------------------


def test_chances_of_passing_are_those_of_the_plans() -> None:
    plan = demonstrate(1000.0, shape=1.5, bearings=10)
    plans = [plan, *alternatives(plan, [10], [1, 2])]
    axes = draw(chance_chart(plans, "h"))
    for line, one in zip(axes.get_lines(), plans, strict=False):
        x, y = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
        np.testing.assert_allclose(y, 100.0 * one.chance_of_passing(x))
    assert labels(axes)[0] == "10 × 1684 h, 0 failures allowed"
    assert draw(chance_chart([demonstrate(1.0, shape=1.5, bearings=1, time=0.1)], "h")).texts


def test_costs_are_those_of_the_plans() -> None:
    plans = plans_for_ratio(5.0, shape=1.5, life=1000.0, samples=SAMPLES)
    with speaking("pt"):
        axes = draw(cost_chart(plans, "h"))
    joined = [line for line in axes.get_lines() if line.get_marker() != "None"]
    shown = [float(y) for line in joined for y in np.asarray(line.get_ydata())]
    means = [plan.duration.mean for plan in plans if plan.duration is not None]
    assert sorted(shown) == pytest.approx(sorted(means))
    assert {text.get_text() for text in axes.texts} == {str(plan.failures) for plan in plans}
    assert axes.get_ylabel() == "Duração (h)"
    nothing = plan_for_ratio(1.5, shape=1.5, groups=3, samples=SAMPLES)
    assert draw(cost_chart([nothing], "h")).texts


# --- regions of likelihood -------------------------------------------------------------------


def test_estimates_and_calculated_lives_stand_in_the_regions(campanha: LifeTest) -> None:
    found = summary(campanha, by_group=False, calculated={"ISO 281": 58.0})
    axes = draw(regions_chart(found, regions(found)))
    group = found.groups[0]
    (mark,) = [m for m in lines(axes, "o") if len(np.asarray(m.get_xdata()))]
    assert mark.get_xdata()[0] == group.main.shape
    assert mark.get_ydata()[0] == pytest.approx(group.main.l10)
    (line,) = [one for one in axes.get_lines() if "ISO 281" in str(one.get_label())]
    assert line.get_ydata() == [58.0, 58.0]
    assert {"50 %", "90 %", "95 %", "10/9 of the rating standards"} <= set(labels(axes))
    assert axes.get_xscale() == axes.get_yscale() == "log"
    assert axes.get_ylim()[0] < 58.0


def test_lives_of_another_reliability_are_not_drawn(campanha: LifeTest) -> None:
    found = summary(campanha, by_group=False, calculated={"ISO 281": 58.0})
    axes = draw(regions_chart(found, regions(found, "scale")))
    assert not any("ISO" in label for label in labels(axes))
    assert axes.get_ylabel() == "Scale η (h)"


def test_every_group_has_its_regions() -> None:
    random = np.random.default_rng(3)
    test = LifeTest(
        np.concatenate([random.weibull(1.5, 9), 9.0 * random.weibull(2.5, 9)]),
        group=["a"] * 9 + ["b"] * 9,
    )
    found = summary(test)
    axes = draw(regions_chart(found, regions(found)))
    assert {"a: 50 %", "b: 95 %"} <= set(labels(axes))
    low, high = axes.get_xlim()
    for region in regions(found).values():
        assert low <= region.shape[0] < region.shape[-1] <= high


def test_without_a_fit_the_frame_is_empty() -> None:
    found = summary(LifeTest([1.0, 2.0], False))
    axes = draw(regions_chart(found, regions(found)))
    assert axes.get_legend() is None
    assert axes.texts


@pytest.mark.parametrize("language", ["en", "pt"])
def test_figures_speak_both_languages(campanha: LifeTest, language: str, tmp_path: Path) -> None:
    found = summary(campanha, calculated={"ISO 281": 58.5})
    drawn = bands(found), regions(found)
    contents = []
    for _ in range(2):  # the same data give the same bytes
        with speaking(language):
            paper, contour = weibull_figure(found, drawn[0]), contour_figure(found, drawn[1])
        save_figure(paper, tmp_path / "paper.svg")
        save_figure(contour, tmp_path / "contour.svg")
        contents.append([(tmp_path / f"{name}.svg").read_bytes() for name in ("paper", "contour")])
    assert contents[0] == contents[1]
    (axes,) = paper.get_axes()
    assert axes.get_ylabel() == ("Failed (%)" if language == "en" else "Falharam (%)")
    mark = "58.5" if language == "en" else "58,5"
    assert any(mark in label for label in labels(axes))
