"""Life tests from Python: one call from end to end, what it takes, and what it refuses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from rolamento.errors import InputError
from rolamento.tasks.weibull import (
    DemonstrationTest,
    PrecisionTest,
    TrendEvaluation,
    life_test_study,
)
from rolamento.weibull import (
    LifeTest,
    ShapePrior,
    WeibullFit,
    all_bounds,
    bands_of,
    bounds,
    compare,
    confidence_band,
    demonstrate,
    fixed_shape,
    life_ratio,
    likelihood_region,
    maximum_likelihood,
    median_rank,
    plotting_positions,
    posterior,
    published_life_test,
    published_text,
    published_trend,
    rank_regression,
    regions_of,
    series_life,
    series_reliability,
    summarise,
    system_rating_life,
    three_parameter,
    unbiased,
)

TIMES = [310.0, 88.0, 520.0, 700.0, 120.5, 640.0]
FIT = WeibullFit("maximum_likelihood", "converged", 1.5, 1000.0)
PLAN = demonstrate(1000.0, shape=1.5, bearings=10)


# --- one call --------------------------------------------------------------------------------


def test_a_file_and_its_test_say_the_same(tmp_path: Path) -> None:
    file = tmp_path / "test.csv"
    file.write_text(published_text("campanha_2008"), encoding="utf-8")
    wanted: dict[str, Any] = {"only": ["I"], "samples": 200, "reliabilities": (0.9,)}
    found = life_test_study(file, calculated={"ISO 281": "58 h"}, times=["2 days"], **wanted)
    again = life_test_study(
        published_life_test("campanha_2008"), calculated={"ISO 281": 58.0}, times=[48.0], **wanted
    )
    assert found.to_mapping() == again.to_mapping()
    assert set(bands_of(found)) == set(regions_of(found)) == {"I"}


def test_large_tests_are_drawn_less_often() -> None:
    few, many = (
        life_test_study([1.0, 2.0, 4.0], methods=["maximum_likelihood"]),
        LifeTest([1.0, 2.0, 4.0], [True, True, False], counts=[1, 1, 1998]),
    )
    assert few.request.samples == 10_000
    assert life_test_study(many, methods=["maximum_likelihood"]).request.samples == 2500


def test_a_demonstration_as_long_as_its_life() -> None:
    found = DemonstrationTest(life="1000 h", confidence=0.95).run()
    assert (found.plan.time, found.unit) == (1000.0, "h")
    assert [one.failures_allowed for one in found.beside] == [1, 2]
    in_days = DemonstrationTest(life="1000 h", bearings=5, time="2 days").run()
    assert in_days.plan.time == 48.0


def test_a_precision_without_a_life_is_in_multiples() -> None:
    found = PrecisionTest(failures=6, group_sizes=[1, 4], samples=200).run()
    assert (found.unit, len(found.plans), found.planned) == ("", 2, True)
    assert found.plans[0].life == 1.0


def test_noise_has_no_law_of_wear() -> None:
    noise = published_trend("campanha_2008_anderon")
    assert not TrendEvaluation(data=noise).run().fits
    with pytest.raises(InputError):
        TrendEvaluation(data=noise, law="power").run()
    assert set(TrendEvaluation(data=published_trend("campanha_2008_clearance")).run().fits) == {
        "9",
        "10",
    }


@pytest.mark.parametrize(
    ("call", "field"),
    [
        (lambda: life_test_study(TIMES, times=["1 Mrev"]), "times"),
        (lambda: life_test_study(TIMES, calculated={"a": -1.0}), "calculated"),
        (lambda: life_test_study(TIMES, only=["III"]), "only"),
        (lambda: life_test_study(TIMES, methods="maximum_likelihood"), "methods"),
        (lambda: DemonstrationTest(life="1000").run(), "life"),
        (lambda: DemonstrationTest(life="1000 h", time="1 Mrev").run(), "time"),
        (lambda: PrecisionTest().run(), "ratio"),
        (lambda: PrecisionTest(ratio=5.0, groups=4, group_sizes=[2, 3]).run(), "groups"),
    ],
)
def test_what_a_task_refuses(call: Callable[[], object], field: str) -> None:
    with pytest.raises(InputError) as caught:
        call()
    assert caught.value.field == field


# --- array-likes -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "times",
    [TIMES, tuple(TIMES), np.array(TIMES), pd.Series(TIMES, index=list("abcdef")),
     np.array(TIMES, dtype=np.float32), LifeTest(TIMES)],
    ids=["list", "tuple", "array", "series", "single", "test"],
)  # fmt: skip
def test_times_of_any_kind_will_do(times: Any) -> None:
    fit = maximum_likelihood(times)
    assert fit.shape == pytest.approx(maximum_likelihood(LifeTest(TIMES)).shape, rel=1e-6)
    assert bounds(times, "L10", method="fisher").converged
    assert compare({"a": times, "b": times}, "same_life", samples=100).statistic < 1e-6


def test_series_beside_series() -> None:
    frame = pd.DataFrame({"time": TIMES, "failed": [True, True, False] * 2, "lot": list("aabbab")})
    test = LifeTest(frame.time, frame.failed, group=frame.lot, counts=pd.Series([1, 2, 3] * 2))
    assert (test.failures, test.size, set(test.by_group())) == (6, 12, {"a", "b"})
    assert FIT.life_at(pd.Series([0.9, 0.5])).shape == (2,)


FRAME = pd.DataFrame({"time": TIMES, "failed": [1.0] * 6})
REFUSED = [FRAME, "abc", None, ["1", "2"], [[1.0], [1.0, 2.0]], [1.0, np.nan], [], 5.0, {"a": 1}]
NAMES = ["frame", "text", "none", "texts", "ragged", "nan", "empty", "number", "mapping"]
OF_A_TEST: list[Callable[[Any], object]] = [
    LifeTest, maximum_likelihood, three_parameter, unbiased, rank_regression, plotting_positions,
    bounds, confidence_band, likelihood_region, summarise, life_test_study,
    lambda x: fixed_shape(x, 1.5), lambda x: all_bounds(x, ["L10"]),
    lambda x: posterior(x, ShapePrior(1.0, 2.0)), lambda x: compare({"a": x, "b": TIMES}),
    lambda x: life_ratio({"a": TIMES, "b": x}), lambda x: LifeTest.sudden_death(x, 4),
]  # fmt: skip


@pytest.mark.parametrize("call", OF_A_TEST, ids=range(len(OF_A_TEST)))
@pytest.mark.parametrize("wrong", REFUSED, ids=NAMES)
@pytest.mark.thirds
def test_what_is_no_life_test_is_refused(call: Callable[[Any], object], wrong: object) -> None:
    with pytest.raises(InputError) as caught:
        call(wrong)
    if not (call is life_test_study and isinstance(wrong, str)):  # a file that is not there
        assert caught.value.field == "times"
        assert caught.value.example


COLUMNS = [
    ("failed", FRAME), ("failed", "abc"), ("failed", ["yes"] * 6), ("failed", [True] * 5),
    ("failed", [[True], [True, False]]), ("failed", None),
    ("counts", FRAME), ("counts", "abc"), ("counts", [1.5] * 6), ("counts", [1] * 5),
    ("lower", FRAME), ("lower", "abc"), ("lower", [1.0] * 5), ("lower", [[1.0], [1.0, 2.0]]),
    ("group", FRAME), ("group", ["a"] * 5), ("group", None), ("rig", FRAME), ("rig", [["a"], []]),
]  # fmt: skip


@pytest.mark.parametrize(("field", "wrong"), COLUMNS, ids=range(len(COLUMNS)))
def test_other_columns_are_refused_by_name(field: str, wrong: Any) -> None:
    with pytest.raises(InputError) as caught:
        LifeTest(TIMES, **{field: wrong})
    assert caught.value.field == field


ARRAYS: list[tuple[str, Callable[[Any], object]]] = [
    ("reliability", FIT.life_at),
    ("time", FIT.reliability_at),
    ("life_ratio", PLAN.chance_of_passing),
    ("shape", PLAN.confidence_at),
    ("rank", lambda x: median_rank(x, 10)),
    ("lives", system_rating_life),
    ("reliability", lambda x: series_life(x, [1.5], [1000.0])),
    ("time", lambda x: series_reliability(x, [1.5], [1000.0])),
    ("shapes", lambda x: series_life(0.9, x, 1000.0)),
    ("locations", lambda x: series_life(0.9, 1.5, 1000.0, x)),
    ("probabilities", lambda x: likelihood_region(TIMES, probabilities=x)),
]


@pytest.mark.parametrize(("field", "call"), ARRAYS)
@pytest.mark.parametrize("wrong", [FRAME, "abc", None, ["a"], [[1.0], [1.0, 2.0]]], ids=range(5))
@pytest.mark.thirds
def test_arrays_are_refused_by_name(
    field: str, call: Callable[[Any], object], wrong: object
) -> None:
    with pytest.raises(InputError) as caught:
        call(wrong)
    assert caught.value.field == field
    assert caught.value.example


@pytest.mark.parametrize("wrong", ["0.9", [0.9], None, np.array([0.9]), pd.Series([0.9]), True])
def test_one_number_is_one_number(wrong: Any) -> None:
    for call in (lambda: bounds(TIMES, confidence=wrong), lambda: fixed_shape(TIMES, wrong)):
        with pytest.raises(InputError):
            call()


@pytest.mark.parametrize("wrong", [TIMES, None, "ab", {"a": TIMES}])
def test_groups_are_tests_by_their_labels(wrong: Any) -> None:
    with pytest.raises(InputError) as caught:
        compare(wrong)
    assert caught.value.field == "groups"
