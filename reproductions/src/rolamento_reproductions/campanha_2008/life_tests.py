"""The life tests, the lives drawn from them, and how these compare with calculated lives.

The tests' L_10h over a calculated one has an interval; only where that leaves 1 outside do the
tests contradict the calculation. That they do not is no proof of it.
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.life.iso281 import MILLION
from rolamento.verification.campanha_2008 import (
    as_if_failed,
    as_plotted,
    condition,
    five_failures,
    four_failures,
    minimum_life,
)
from rolamento.weibull import (
    CalculatedLife,
    LifeTest,
    WeibullFit,
    against_calculated_life,
    bounds,
    compare,
    published_life_test,
    published_text,
    rank_regression,
)
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    HOUR,
    NONE,
    Number,
    basic_life_hours,
    load,
    numbers_table,
    printed,
    said,
    speed,
)
from rolamento_reproductions.campanha_2008.rating import nsk_numbers
from rolamento_reproductions.campanha_2008.weibull import (
    Tested,
    figure_of_condition_one,
    figure_without_test_5,
    interval,
    life_by_all,
    lives_of_tests,
    shapes_of_fatigue,
    six_failures,
    without_test,
)
from rolamento_reproductions.record import Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text, fixed, listed, same, written

_REJECTED: Final = 0.1
"""p below which two conditions are said to differ."""


@dataclass(frozen=True, slots=True, eq=False)
class _Judged:
    """A calculated life, and what the tests of a condition say of it; shape: "" where free."""

    key: str
    told: Text
    condition: str
    shape: str
    found: CalculatedLife

    @property
    def contradicted(self) -> bool:
        """Whether the tests leave no room for it."""
        return bool(self.found.bearings_live)


@cache
def _judged() -> tuple[_Judged, ...]:
    rating = (
        "basic",
        same("L_10h = (C/P)³"),
        basic_life_hours(printed("life")["dynamic_rating_N"]),
    )
    maker = {number.key: float(number.printed) for number in nsk_numbers()}
    reduced = float(GIVEN.inputs_of("load_zone")["reduced_life_h"])
    catalogue = said("judged.l_able_catalogue")
    measured = said("judged.l_able_measured")
    first = (
        rating,
        ("catalogue_I", catalogue, maker["catalogue_I"]),
        ("measured_I", measured, maker["measured_I"]),
        ("reduced", said("judged.reduced"), reduced),
    )
    second = (
        rating,
        ("catalogue_II", catalogue, maker["catalogue_II"]),
        ("measured_II", measured, maker["measured_II"]),
    )
    return (
        *(
            _Judged(key, told, "I", "", against_calculated_life(condition("I"), life))
            for key, told, life in first
        ),
        *(
            _Judged(
                key, told, "II", name, against_calculated_life(condition("II"), life, shape=shape)
            )
            for key, told, life in second
            for name, shape in shapes_of_fatigue().items()
        ),
    )


def against_table() -> Table:
    """Set every calculated life against the tests."""
    rows = _judged()

    def column(name: str, title: Text, cells: list[Text]) -> TableColumn:
        return TableColumn(name, title, tuple(cells), sentences=name == "verdict")

    return Table(
        number="E.2",
        caption=said("against_table.caption"),
        source=GIVEN.source_of("weibull"),
        columns=(
            column("life", said("against_table.life"), [row.told for row in rows]),
            column(
                "calculated_h",
                said("against_table.calculated_h"),
                [fixed(row.found.calculated, 1) for row in rows],
            ),
            column("condition", said("condition"), [same(r.condition) for r in rows]),
            column("shape", same("β"), [_shape(row.shape) for row in rows]),
            column("tests_h", said("against_table.tests_h"), [_lives(r.found) for r in rows]),
            column("ratio", said("against_table.ratio"), [_ratio_text(row.found) for row in rows]),
            column("p", same("p"), [_probability(row.found.p_value) for row in rows]),
            column("verdict", said("against_table.verdict"), [_verdict_text(row) for row in rows]),
        ),
        claims=(_no_agreement(), _small_error(), _film_and_life()),
        notes=(_outside(),),
    )


def _shape(name: str) -> Text:
    return written(name) if name else said("shape")


def _range_text(low: float, high: float, digits: int) -> Text:
    if not isfinite(high):
        return said("at_least", low=fixed(low, digits))
    return said("range", low=fixed(low, digits), high=fixed(high, digits))


def _lives(found: CalculatedLife) -> Text:
    return _range_text(found.observed.lower, found.observed.upper, 0)


def _ratio_text(found: CalculatedLife) -> Text:
    return _range_text(found.lower, found.upper, 2)


def _probability(value: float) -> Text:
    if value < 0.001:
        return same("< {:.3f}", 0.001)
    return fixed(value, 2 if value >= 0.01 else 3)


def _verdict_text(row: _Judged) -> Text:
    if row.contradicted:
        longer = row.found.bearings_live == "longer"
        return said("verdict_text") if longer else said("verdict_text.contradicted_bearings_live")
    return said("verdict_text.not_contradicted")


# --- statements -------------------------------------------------------------


def _names_of_rows(rows: tuple[_Judged, ...]) -> Text:
    """Name calculated lives by their hours: "57.8, 151.2 and 189"."""
    lives = sorted({row.found.calculated for row in rows})
    return listed([written(f"{life:.1f}".removesuffix(".0")) for life in lives])


def _of_condition(name: str) -> tuple[_Judged, ...]:
    return tuple(row for row in _judged() if row.condition == name)


def _by_shapes(*, every: bool) -> tuple[_Judged, ...]:
    """Lives of condition II contradicted with every shape; or with some but not with every."""
    found = []
    for row in _of_condition("II"):
        verdicts = [r.contradicted for r in _of_condition("II") if r.key == row.key]
        if all(verdicts) if every else any(verdicts) and not all(verdicts):
            found.append(row)
    return tuple(found)


def _no_agreement() -> Claim:
    rows, first, life = _judged(), _of_condition("I"), life_by_all().life
    out = tuple(row for row in first if row.contradicted)
    return Claim(
        said("no_agreement.statement"),
        said(
            "no_agreement.finding",
            lower=life.lower,
            upper=life.upper,
            admitted=_names_of_rows(tuple(row for row in first if not row.contradicted)),
            excluded=_names_of_rows(out),
            p_value_min=min((row.found.p_value for row in out), default=1.0),
            never=_names_of_rows(_by_shapes(every=True)),
            by_one=_names_of_rows(_by_shapes(every=False)),
        ),
        holds=all(row.contradicted for row in rows),
        partly=any(row.contradicted for row in rows),
    )


def _small_error() -> Claim:
    found = {row.key: row for row in _of_condition("I")}
    near, far = found["measured_I"], found["catalogue_I"]
    off = max(near.found.upper - 1.0, 1.0 - near.found.lower)
    return Claim(
        said("small_error.statement"),
        said(
            "small_error.finding",
            *(near.found.ratio, near.found.lower, near.found.upper),
            *(far.found.ratio, far.found.lower, far.found.upper),
            near.found.upper / near.found.lower,
        ),
        holds=far.contradicted and off <= _stated_share("measured_percent"),
        partly=far.contradicted and not near.contradicted,
    )


def _stated_share(name: str) -> float:
    return float(GIVEN.inputs_of("comparison")[name]) / 100.0


def _film_and_life() -> Claim:
    alike = compare(published_life_test("campanha_2008"), "same_life")
    first, second = condition("I"), condition("II")
    last = float(second.times.max())
    by_then = int((first.failed & (first.times <= last)).sum())
    maker = [row for row in _of_condition("II") if row.key == "catalogue_II"]
    return Claim(
        said("film_and_life.statement"),
        said(
            "film_and_life.finding",
            p_value=alike.p_value,
            times_min=float(second.times.min()),
            last=last,
            by_then=by_then,
            size=first.size,
        ),
        holds=alike.p_value < _REJECTED,
        partly=all(row.contradicted for row in maker),
    )


def _outside() -> Text:
    share = 100.0 * load() / printed("life")["dynamic_rating_N"]
    return said("outside", share=share)


_NONE: Final = same("–")
_WEAR: Final = 2.0
"""β above which the text has bearings."""


@dataclass(frozen=True, slots=True, eq=False)
class _Row:
    """One way of analysing some of the tests; without a fit there is a lower limit alone."""

    told: Text
    test: LifeTest
    shape: Text
    life: Text
    fit: WeibullFit | None = None

    @property
    def scale(self) -> Text:
        """η."""
        return _NONE if self.fit is None else same("{:.0f}", self.fit.scale)

    @property
    def mean(self) -> Text:
        """Mean life."""
        return _NONE if self.fit is None else same("{:.0f}", self.fit.mean)


def fits_table() -> Table:
    """Put the analyses side by side."""
    rows = _fit_rows()

    def column(name: str, title: Text, cell: Callable[[_Row], Text]) -> TableColumn:
        return TableColumn(name, title, tuple(cell(row) for row in rows), sentences=name == "of")

    return Table(
        number="E.1",
        caption=said("fits_table.caption"),
        source=GIVEN.source_of("weibull"),
        columns=(
            column("of", said("fits_table.of"), lambda row: row.told),
            column("tested", said("fits_table.tested"), lambda row: same(str(row.test.size))),
            column("failed", said("fits_table.failed"), lambda row: same(str(row.test.failures))),
            column("shape", same("β"), lambda row: row.shape),
            column("scale_h", same("η (h)"), lambda row: row.scale),
            column("mean_h", said("fits_table.mean_h"), lambda row: row.mean),
            column("life_h", same("L_10h (h)"), lambda row: row.life),
        ),
        claims=(_steep(),),
        notes=(_other_limits(), _pooled()),
    )


def _fit_rows() -> tuple[_Row, ...]:
    return (*_of_procedure_two(), *_of_condition_one(), *_of_condition_two())


def _of_procedure_two() -> tuple[_Row, ...]:
    four, five = four_failures(), five_failures()
    return (
        _of_line(said("of_procedure_two.procedure_ii_as"), four, as_plotted(four)),
        _of_line(said("of_procedure_two.same_ln_t"), four, rank_regression(four)),
        _of_likelihood(said("of_procedure_two.same_maximum_likelihood"), Tested.of(four)),
        _of_line(said("of_procedure_two.with_test_5"), five, as_plotted(five)),
    )


def _of_condition_one() -> tuple[_Row, ...]:
    return (
        _of_likelihood(said("of_condition_one.six_failures_condition"), Tested.of(six_failures())),
        _of_likelihood(said("of_condition_one.condition_i_all"), life_by_all()),
        _of_likelihood(said("of_condition_one.same_without_test"), without_test(5)),
        _of_likelihood(
            said("of_condition_one.same_without_test.same_without_test"), without_test(1)
        ),
    )


def _of_condition_two() -> tuple[_Row, ...]:
    """The printed line, and lower limits by shapes of fatigue and by that of condition I."""
    hot, own = as_if_failed(), life_by_all().fit.shape
    shapes = {**shapes_of_fatigue(), f"{own:.2f}": own}
    return (
        _of_line(said("of_condition_two.condition_ii_as"), hot, as_plotted(hot)),
        *(_at_shape(*pair) for pair in shapes.items()),
    )


def _of_line(told: Text, test: LifeTest, fit: WeibullFit) -> _Row:
    return _Row(told, test, same("{:.2f}", fit.shape), same("{:.1f}", fit.l10), fit)


def _of_likelihood(told: Text, tested: Tested) -> _Row:
    return _Row(told, tested.test, interval(tested.shape, 2), interval(tested.life), tested.fit)


def _at_shape(name: str, shape: float) -> _Row:
    """Condition II with a shape from elsewhere."""
    return _Row(
        said("at_shape.condition_ii_as"),
        condition("II"),
        written(name),
        said("at_shape.at_least", minimum_life=minimum_life(shape)),
    )


# --- what follows -----------------------------------------------------------


def _steep() -> Claim:
    shape = life_by_all().shape
    return Claim(
        said("steep.statement"),
        said("steep.finding", interval=interval(shape, 2)),
        holds=shape.lower > _WEAR,
    )


def _other_limits() -> Text:
    life = bounds(condition("I"), "L10", method="calibrated_likelihood_ratio")
    return said("other_limits", lower=life.lower, upper=life.upper)


def _pooled() -> Text:
    whole = published_life_test("campanha_2008", group="procedure")
    first = whole.select(published_life_test("campanha_2008").group == "I")
    alike = compare(first, "homogeneous")
    return said("pooled", p_value=alike.p_value)


_DOUBLE = 100.0
"""% above the calculated life."""


@dataclass(frozen=True, slots=True)
class RigTest:
    """One test: what ran how long (h), and what failed at its end."""

    number: int
    procedure: str
    condition: str
    hours: float
    bearings: tuple[int, ...]
    failed: tuple[int, ...]


@cache
def life_tests() -> tuple[RigTest, ...]:
    """Return the tests of tables 4.1.1 and 4.1.2."""
    lines = published_text("campanha_2008").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return tuple(_life_test_of(list(own)) for _, own in groupby(rows, key=lambda row: row["test"]))


def _life_test_of(rows: list[dict[str, str]]) -> RigTest:
    """Put the bearings of a test together."""
    first = rows[0]
    return RigTest(
        number=int(first["test"]),
        procedure=first["procedure"],
        condition=first["condition"],
        hours=float(first["time"]),
        bearings=tuple(int(row["bearing"]) for row in rows),
        failed=tuple(int(row["bearing"]) for row in rows if row["status"] == "failed"),
    )


def life_tests_section(title: Text) -> Section:
    """Show the tests, the lives drawn from them, and compute the comparisons."""
    return Section(
        title,
        (
            _record(),
            figure_of_condition_one(),
            figure_without_test_5(),
            _comparison(),
            fits_table(),
            against_table(),
        ),
    )


# --- tables 4.1.1 and 4.1.2 -------------------------------------------------


def _record() -> Table:
    tests = life_tests()
    rating = printed("life")["dynamic_rating_N"]
    turns = [test.hours * HOUR * speed() / (2.0 * np.pi * MILLION) for test in tests]

    def column(name: str, title: Text, cells: list[Any]) -> TableColumn:
        return TableColumn(name, title, tuple(str(cell) for cell in cells))

    return Table(
        number="4.1.1",
        caption=said("record.caption", basic_life_hours=basic_life_hours(rating)),
        source=GIVEN.source_of("life_tests"),
        columns=(
            column("test", said("record.test"), [test.number for test in tests]),
            column("procedure", said("record.procedure"), [t.procedure for t in tests]),
            column("condition", said("condition"), [t.condition for t in tests]),
            column(
                "bearings", said("record.bearings"), [_listed_numbers(t.bearings) for t in tests]
            ),
            column("hours", said("time_h"), [f"{t.hours:.1f}" for t in tests]),
            column("revolutions_1e6", said("record.revolutions_1e6"), [f"{n:.2f}" for n in turns]),
            column(
                "over_rating_life",
                said("record.over_rating_life"),
                [f"{t.hours / basic_life_hours(rating):.2f}" for t in tests],
            ),
            column("failed", said("record.failed"), [_listed_numbers(t.failed) for t in tests]),
        ),
        claims=(_six(), _third(), _sides()),
    )


def _listed_numbers(numbers: tuple[int, ...]) -> str:
    return " + ".join(str(number) for number in numbers) or "–"


def _six() -> Claim:
    failed = [number for test in life_tests() for number in test.failed]
    count = sum(len(test.bearings) for test in life_tests())
    return Claim(
        said("six.statement"),
        said("six.finding", failed_count=len(failed), count_1=count, count_2=count - len(failed)),
        (len(failed), count) == (6, 24),
    )


def _third() -> Claim:
    first = life_tests()[0]
    return Claim(
        said("third.statement"),
        said(
            "third.finding", listed_numbers=_listed_numbers(first.bearings), failed=first.failed[0]
        ),
        3 in first.bearings,
    )


def _sides() -> Claim:
    drive = GIVEN.inputs_of("life_tests")["drive_side"]
    single = [test.bearings[0] for test in life_tests() if test.procedure == "II"]
    against = [number for number in single if (number % 2 == 1) != (number in drive)]
    return Claim(
        said("sides.statement"),
        said("sides.finding", bearings=said("sides.and", *against)),
        holds=not against,
    )


# --- comparisons ------------------------------------------------------------


@cache
def comparison_numbers() -> tuple[Number, ...]:
    """Return the printed deviations of tested from calculated lives."""
    given = GIVEN.inputs_of("comparison")
    calculated = {number.key: float(number.printed) for number in nsk_numbers()}
    reduced = float(GIVEN.inputs_of("load_zone")["reduced_life_h"])
    lives = {number.key: float(number.printed) for number in lives_of_tests()}
    without, hot = lives["life_without_5"], lives["life_II"]
    measured = calculated["measured_I"]
    return (
        Number(
            "measured",
            said("comparison_numbers.measured.quantity"),
            given["measured_percent"],
            _above(without, measured),
            NONE,
            said("comparison_numbers.measured.reason", above=_above(lives["life_I"], measured)),
        ),
        Number(
            "catalogue",
            said("comparison_numbers.catalogue.quantity"),
            given["catalogue_percent"],
            _above(without, calculated["catalogue_I"]),
            NONE,
            said("comparison_numbers.catalogue.reason"),
        ),
        Number(
            "condition_II",
            said("comparison_numbers.condition_ii.quantity"),
            given["condition_II_percent"],
            _above(hot, calculated["measured_II"]),
            NONE,
            said("comparison_numbers.condition_ii.reason"),
        ),
        Number(
            "reduced",
            said("comparison_numbers.reduced.quantity"),
            given["reduced_percent"],
            _above(without, reduced),
            NONE,
            said("comparison_numbers.reduced.reason"),
        ),
    )


def _above(tested: float, calculated: float) -> float:
    """How far a tested life is above the calculated one; %."""
    return 100.0 * (tested / calculated - 1.0)


def _comparison() -> Table:
    return numbers_table(
        "E",
        said("comparison.caption"),
        GIVEN.source_of("comparison"),
        (*lives_of_tests(), *comparison_numbers()),
        claims=(_more_than_double(),),
        notes=(said("comparison.there_is_no"),),
    )


def _more_than_double() -> Claim:
    calculated = {number.key: float(number.printed) for number in nsk_numbers()}["measured_II"]
    tested = next(float(n.printed) for n in lives_of_tests() if n.key == "life_II")
    times = [test.hours for test in life_tests() if test.condition == "II"]
    above = [_above(time, calculated) for time in times]
    most = sum(value > _DOUBLE for value in above)
    return Claim(
        said("more_than_double.statement"),
        said(
            "more_than_double.finding",
            most=most,
            times_count=len(times),
            above_min=min(above),
            above=_above(tested, calculated),
        ),
        holds=most == len(times),
        partly=most > 0,
    )
