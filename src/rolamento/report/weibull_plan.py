"""Planned life tests, for a reader, and as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from math import isclose, isfinite, nan
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import ABSENT
from rolamento.report.page import FIGURES, Lines, Page, one_line, percent, rendered, table
from rolamento.report.plain_data import json_text
from rolamento.report.weibull import life_name
from rolamento.report.weibull_plan_words import PLAN_WORDS, PlanWords
from rolamento.report.weibull_sentences import said_advice
from rolamento.report.weibull_words import counted
from rolamento.weibull import Demonstration, Estimand, LifeTestPlan

if TYPE_CHECKING:
    from rolamento.tasks.weibull import DemonstrationStudy, PrecisionStudy

__all__ = ["demonstration_json", "demonstration_report", "precision_json", "precision_report"]

SCHEMA: Final = 1
_FAIR: Final = 0.9
_FEW: Final = 3


# --- demonstration ---------------------------------------------------------------------------


def demonstration_json(found: DemonstrationStudy) -> str:
    """Return a planned demonstration as one JSON object; times in the unit that it names."""
    return json_text({"schema": SCHEMA, "kind": "weibull_plan_demonstration", **found.to_mapping()})


def demonstration_report(
    found: DemonstrationStudy, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the page of a planned demonstration as text that ends in a newline.

    Parameters
    ----------
    found
        Of `rolamento.tasks.weibull.demonstration_study`.
    words, medium
        The language, and what the text is shown on; by default plain text of 80 columns.
    """
    page, said = Page(words, medium or Medium()), PLAN_WORDS[words.code]
    plan, others, unit = found.plan, found.alternatives, one_line(found.unit)
    quantity = life_name(page, Estimand.life(plan.reliability))
    title = said.showing.format(
        quantity=quantity,
        life=page.digits.short(plan.life, FIGURES),
        unit=unit,
        confidence=percent(page, plan.confidence),
    )
    head = [
        *page.hanging(Text(), title, "bold"),
        page.rule(page.medium.width),
        *page.hanging(
            Text("  "), said.shape.format(shape=page.digits.short(plan.shape, FIGURES)), "dim"
        ),
    ]
    parts = [head, _what_is_tested(page, said, plan, quantity, unit)]
    if plan.planned:
        parts.append(_chances(page, said, found))
        parts.append([] if _as_long(plan) else _shapes(page, said, found))
    if others:
        parts.append(_trade(page, said, others, unit))
    return rendered(page.medium, [part for part in parts if part])


def _what_is_tested(
    page: Page, said: PlanWords, plan: Demonstration, quantity: str, unit: str
) -> Lines:
    """Say in sentences what the test is, and what may be expected of it."""
    if not plan.planned:
        return page.hanging(page.text("  ✗ ", "red"), said_advice(plan.code, page.words.code))
    allowed = plan.failures_allowed
    failures = said.without_failure
    if allowed:
        failures = counted(said.with_failures, allowed, page.digits.fixed(allowed, 0))
    ratio = plan.life_ratio_for(_FAIR)
    life = page.digits.short(ratio * plan.life, FIGURES)
    sentences = [
        said.run.format(
            bearings=page.digits.fixed(plan.bearings, 0),
            time=page.digits.short(plan.time, FIGURES),
            unit=unit,
            total=page.digits.short(plan.total_time, FIGURES),
            failures=failures,
        ),
        said.shown.format(shown=_probability(page, plan.shown)),
        said.just_as_wanted.format(chance=_probability(page, float(plan.chance_of_passing(1.0)))),
        said.to_pass.format(
            quantity=quantity, life=life, unit=unit, ratio=page.digits.short(ratio, _FEW)
        ),
        said.expected_end.format(time=page.digits.short(plan.expected_time(), _FEW), unit=unit),
    ]
    if _as_long(plan):
        sentences.append(said.any_shape)
    return _bullets(page, sentences)


def _as_long(plan: Demonstration) -> bool:
    """Whether the test is as long as the life, so that the shape does not matter."""
    return isclose(plan.time, plan.life, rel_tol=1e-9)


def _bullets(page: Page, sentences: Sequence[str]) -> Lines:
    lines: Lines = []
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "green"), sentence)
    return lines


def _chances(page: Page, said: PlanWords, found: DemonstrationStudy) -> Lines:
    ratios, chances, ends = zip(*found.chances, strict=True)
    rows = [
        [said.passes, *(_probability(page, chance) for chance in chances)],
        [
            said.ends_after.format(unit=one_line(found.unit)),
            *(page.digits.short(end, _FEW) for end in ends),
        ],
    ]
    heads = [said.true_ratio, *(page.digits.short(ratio, 2) for ratio in ratios)]
    return [page.heading(said.chance), *table(page, heads, rows)]


def _shapes(page: Page, said: PlanWords, found: DemonstrationStudy) -> Lines:
    shapes, confidences = zip(*found.confidences, strict=True)
    heads = [said.shape_head, *(page.digits.short(shape, 2) for shape in shapes)]
    row = [said.shown_with, *(_probability(page, one) for one in confidences)]
    return [page.heading(said.other_shape), *table(page, heads, [row])]


def _trade(page: Page, said: PlanWords, others: Sequence[Demonstration], unit: str) -> Lines:
    """One line a number of bearings: the time of each, by the failures allowed."""
    allowed = sorted({other.failures_allowed for other in others})
    by_place = {(other.bearings, other.failures_allowed): other.time for other in others}
    heads = [said.bearings]
    for count in allowed:
        shown = page.digits.fixed(count, 0)
        heads.append(counted(said.allowed, count, shown) if count else said.no_failure)
    heads.append(said.total)
    rows = []
    for bearings in sorted({other.bearings for other in others}):
        times = [by_place.get((bearings, count), nan) for count in allowed]
        cells = [*times, bearings * times[0]]
        rows.append([page.digits.fixed(bearings, 0), *(_time(page, time) for time in cells)])
    return [
        page.heading(said.trade.format(unit=unit)),
        *table(page, heads, rows, "r" * len(heads)),
    ]


# --- precision -------------------------------------------------------------------------------


def precision_json(found: PrecisionStudy) -> str:
    """Return planned tests as one JSON object; times in the unit that it names."""
    return json_text({"schema": SCHEMA, "kind": "weibull_plan_precision", **found.to_mapping()})


def precision_report(
    found: PrecisionStudy, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the page of planned tests as text that ends in a newline.

    Parameters
    ----------
    found
        Of `rolamento.tasks.weibull.precision_study`.
    words, medium
        The language, and what the text is shown on; by default plain text of 80 columns.
    """
    page, said = Page(words, medium or Medium()), PLAN_WORDS[words.code]
    plans, ratio, unit = found.plans, found.ratio, one_line(found.unit)
    first = plans[0]
    quantity = life_name(page, Estimand.life(first.reliability))
    expected = said.expected if unit else said.expected_multiples
    unit = unit or quantity  # without a unit times are multiples of the life
    entries = [
        expected.format(
            shape=page.digits.short(first.shape, FIGURES),
            quantity=quantity,
            life=page.digits.short(first.life, FIGURES),
            unit=unit,
        )
    ]
    if ratio is not None:
        confidence = percent(page, first.confidence)
        entries.append(
            said.known_to.format(confidence=confidence, ratio=page.digits.short(ratio, _FEW))
        )
    head = [
        *page.hanging(Text(), said.precision.format(quantity=quantity), "bold"),
        page.rule(page.medium.width),
        *(line for entry in entries for line in page.hanging(Text("  "), entry, "dim")),
    ]
    parts = [head, _what_it_takes(page, said, plans, quantity, unit)]
    if found.planned:
        heading = said.tests if ratio is None else said.table
        parts += _table_of_plans(page, said, plans, unit, heading)
    return rendered(page.medium, [part for part in parts if part])


def _what_it_takes(
    page: Page, said: PlanWords, plans: Sequence[LifeTestPlan], quantity: str, unit: str
) -> Lines:
    planned = [plan for plan in plans if plan.planned]
    if not planned:
        return page.hanging(page.text("  ✗ ", "red"), said_advice(plans[0].code, page.words.code))
    first = planned[0]
    sentences = [
        said.one.format(
            bearings=page.digits.fixed(first.bearings, 0),
            failures=page.digits.fixed(first.failures, 0),
            confidence=percent(page, first.confidence),
            quantity=quantity,
            ratio=page.digits.short(first.ratio, _FEW),
            rarely=page.digits.short(first.ratio_rarely_exceeded, _FEW),
        )
    ]
    sudden = [plan for plan in planned if plan.group_size > 1]
    if first.scheme == "complete" and sudden:
        fastest = min(sudden, key=_mean_end)
        sentences.append(
            said.several.format(
                bearings=page.digits.fixed(first.bearings, 0),
                time=page.digits.short(_mean_end(first), _FEW),
                unit=unit,
            )
        )
        sentences.append(
            said.sudden_saves.format(
                groups=page.digits.fixed(fastest.groups, 0),
                size=page.digits.fixed(fastest.group_size, 0),
                failures=page.digits.fixed(fastest.failures, 0),
                time=page.digits.short(_mean_end(fastest), _FEW),
                unit=unit,
                bearings=page.digits.fixed(fastest.bearings, 0),
            )
        )
    return _bullets(page, sentences)


def _mean_end(plan: LifeTestPlan) -> float:
    return float("inf") if plan.duration is None else plan.duration.mean


def _table_of_plans(
    page: Page, said: PlanWords, plans: Sequence[LifeTestPlan], unit: str, heading: str
) -> list[Lines]:
    """One line a test: in one table where it is wide enough, else in two."""
    kinds = ["", *(_kind(page, said, plan) for plan in plans)]
    precision = _precision_columns(page, said, plans)
    times = _time_columns(page, said, plans, unit)
    first = next(plan for plan in plans if plan.planned)
    legend = page.hanging(
        Text("  "),
        said.legend.format(
            samples=page.digits.fixed(first.samples, 0), seed=page.digits.fixed(first.seed, 0)
        ),
        "dim",
    )
    whole = _set_columns(page, [kinds, *precision, *times])
    if max(map(len, whole)) <= page.medium.width:
        return [[page.heading(heading), *whole], legend]
    return [
        [page.heading(heading), *_set_columns(page, [kinds, *precision])],
        _set_columns(page, [kinds, *times]),
        legend,
    ]


def _set_columns(page: Page, columns: Sequence[Sequence[str]]) -> Lines:
    heads, *rows = list(zip(*columns, strict=True))
    return table(page, heads, rows)


def _precision_columns(
    page: Page, said: PlanWords, plans: Sequence[LifeTestPlan]
) -> list[list[str]]:
    columns = []
    for head, name in (
        (said.bearings, "bearings"),
        (said.groups, "groups"),
        (said.failures, "failures"),
    ):
        numbers = [getattr(plan, name) if plan.planned else nan for plan in plans]
        columns.append([head, *(page.digits.fixed(number, 0) for number in numbers)])
    for head, name in (
        (said.ratio, "ratio"),
        (said.rarely, "ratio_rarely_exceeded"),
        (said.shape_ratio, "shape_ratio"),
    ):
        numbers = [getattr(plan, name) for plan in plans]
        columns.append([head, *page.digits.column(numbers, digits=3, most=2)])
    return columns


def _time_columns(
    page: Page, said: PlanWords, plans: Sequence[LifeTestPlan], unit: str
) -> list[list[str]]:
    ends = [plan.duration for plan in plans]
    means = page.digits.column([nan if end is None else end.mean for end in ends], FIGURES)
    limits = page.digits.column(
        [limit for end in ends if end is not None for limit in (end.lower, end.upper)], FIGURES
    )
    pairs = iter(zip(limits[::2], limits[1::2], strict=True))
    ranges = [ABSENT if end is None else "–".join(next(pairs)) for end in ends]
    return [
        [said.ends.format(unit=unit), *means],
        [said.from_to, *ranges],
        [
            said.bearing_time.format(unit=unit),
            *page.digits.column([plan.bearing_time for plan in plans], FIGURES),
        ],
        [
            said.rig_time.format(unit=unit),
            *page.digits.column([plan.rig_time for plan in plans], FIGURES),
        ],
    ]


def _kind(page: Page, said: PlanWords, plan: LifeTestPlan) -> str:
    """Say how the test ends."""
    if plan.group_size > 1:
        return said.sudden.format(size=page.digits.fixed(plan.group_size, 0))
    if plan.scheme == "complete":
        return said.all_fail
    share = plan.failures / plan.groups if plan.groups else float("nan")
    return said.part_fails.format(percent=page.digits.short(100.0 * share, 2))


def _probability(page: Page, share: float) -> str:
    """Write a probability in per cent; what is nearly sure, or nearly not, as more or less."""
    if not isfinite(share):
        return ABSENT
    if share < 0.001:
        return "< " + page.digits.short(0.1, 1)
    if share > 0.999:
        return "> " + page.digits.short(99.9, 3)
    return page.digits.fixed(100.0 * share, 1)


def _time(page: Page, time: float) -> str:
    return page.digits.short(time, FIGURES)
