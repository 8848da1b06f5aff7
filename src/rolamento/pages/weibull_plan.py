"""The pages of planned life tests: a life demonstrated, a life known to a precision."""

from __future__ import annotations

from collections.abc import Sequence
from math import isclose, isfinite, nan
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.given import picture
from rolamento.pages.lives import FIGURES, life_name, percent
from rolamento.weibull import Demonstration, Estimand, LifeTestPlan
from rolamento.words import ABSENT, Note, counted, manner, said
from rolamento.words.naming import one_line

if TYPE_CHECKING:
    from rolamento.tasks.weibull import DemonstrationStudy, PrecisionStudy

__all__ = ["demonstration_page", "precision_page"]

_FAIR: Final = 0.9


# --- demonstration ---------------------------------------------------------------------------


def demonstration_page(found: DemonstrationStudy) -> doc.Document:
    """Return the page of a planned demonstration; times are in the unit of the life.

    Parameters
    ----------
    found
        Of `rolamento.tasks.DemonstrationTest`.
    """
    plan, unit = found.plan, one_line(found.unit)
    quantity = life_name(Estimand.life(plan.reliability))
    title = said(
        "Demonstration test: {quantity} of {life:.4} {unit} with {confidence} % confidence",
        quantity=quantity,
        life=plan.life,
        unit=unit,
        confidence=percent(plan.confidence),
    )
    shape = said("shape {shape:.4}, assumed from experience", shape=plan.shape)
    sections = [
        doc.Section(blocks=(doc.Title(title), doc.Statement(shape, "faint", indent=2)), key="head"),
        doc.Section(blocks=_what_is_tested(plan, quantity, unit), key="test"),
    ]
    if plan.planned:
        sections.append(_chances(found))
        if not _as_long(plan):
            sections.append(_shapes(found))
    if found.alternatives:
        sections.append(_trade(found.alternatives, unit))
    if plan.planned:
        caption = said("Probability of passing the test, by the true life")
        sections.append(
            picture(
                caption,
                lambda: plots.chance_figure([plan, *found.beside], found.unit),
                "chance",
                "",
            )
        )
    return doc.Document(title, tuple(sections), "weibull-plan")


def _what_is_tested(plan: Demonstration, quantity: str, unit: str) -> tuple[doc.Statement, ...]:
    """Say in sentences what the test is, and what may be expected of it."""
    if plan.advice is not None:
        return (_no_plan(plan.advice),)
    ratio, allowed = plan.life_ratio_for(_FAIR), plan.failures_allowed
    values = {"bearings": plan.bearings, "time": plan.time, "unit": unit, "total": plan.total_time}
    if allowed:
        run = counted(
            "Test {bearings} bearings for {time:.4} {unit} each (total {total:.4} {unit}), with at"
            " most {n} failure.",
            "Test {bearings} bearings for {time:.4} {unit} each (total {total:.4} {unit}), with at"
            " most {n} failures.",
            allowed,
            **values,
        )
    else:
        run = said(
            "Test {bearings} bearings for {time:.4} {unit} each (total {total:.4} {unit}), without"
            " failure.",
            **values,
        )
    sentences = [
        run,
        said(
            "If passed, the test demonstrates the life with {shown} % confidence.",
            shown=_probability(plan.shown),
        ),
        said(
            "Bearings whose life is exactly the required one pass {chance} % of such tests.",
            chance=_probability(float(plan.chance_of_passing(1.0))),
        ),
        said(
            "For a 90 % probability of passing, their {quantity} must be {life:.4} {unit},"
            " {ratio:.3} times the required one.",
            quantity=quantity,
            life=ratio * plan.life,
            unit=unit,
            ratio=ratio,
        ),
        said(
            "Bearings of exactly the required life end the test after {time:.3} {unit} on average,"
            " since one failure too many ends it.",
            time=plan.expected_time(),
            unit=unit,
        ),
    ]
    if _as_long(plan):
        sentences.append(
            said("The test is as long as the life: the result does not depend on the shape.")
        )
    return _bullets(sentences)


def _as_long(plan: Demonstration) -> bool:
    """Whether the test is as long as the life, so that the shape does not matter."""
    return isclose(plan.time, plan.life, rel_tol=1e-9)


def _bullets(sentences: Sequence[str]) -> tuple[doc.Statement, ...]:
    return tuple(doc.Statement(text, indent=2, mark="•", mark_tone="good") for text in sentences)


def _no_plan(advice: Note) -> doc.Statement:
    return doc.Statement(advice.text, indent=2, mark="✗", mark_tone="bad")


def _chances(found: DemonstrationStudy) -> doc.Section:
    ratios, chances, ends = zip(*found.chances, strict=True)
    unit = one_line(found.unit)
    columns = (
        doc.Column(
            said("true life/required life"),
            [doc.Number(ratio, ".2") for ratio in ratios],
            "life_ratio",
        ),
        doc.Column(
            said("passes %"), [_probability_cell(one) for one in chances], "chance", align="right"
        ),
        doc.Column(
            said("ends after {unit}", unit=unit),
            [doc.Number(end, ".3") for end in ends],
            "expected_time",
        ),
    )
    return doc.Section(said("Probability of passing"), (doc.Table(columns, "chances"),))


def _shapes(found: DemonstrationStudy) -> doc.Section:
    shapes, confidences = zip(*found.confidences, strict=True)
    columns = (
        doc.Column(said("shape"), [doc.Number(shape, ".2") for shape in shapes], "shape"),
        doc.Column(
            said("confidence %"),
            [_probability_cell(one) for one in confidences],
            "confidence",
            align="right",
        ),
    )
    return doc.Section(said("If the shape is different"), (doc.Table(columns, "shapes"),))


def _trade(others: Sequence[Demonstration], unit: str) -> doc.Section:
    """One line a number of bearings: the time of each, by the failures allowed."""
    allowed = sorted({other.failures_allowed for other in others})
    by_place = {(other.bearings, other.failures_allowed): other.time for other in others}
    bearings = sorted({other.bearings for other in others})
    columns = [doc.Column(said("bearings"), bearings, "bearings")]
    for count in allowed:
        head = counted("{n} failure", "{n} failures", count) if count else said("no failures")
        times = [by_place.get((one, count), nan) for one in bearings]
        columns.append(doc.Column(head, [_time(time) for time in times], f"time_{count}_failures"))
    totals = [one * by_place.get((one, allowed[0]), nan) for one in bearings]
    columns.append(
        doc.Column(said("total, no failures"), [_time(one) for one in totals], "total_time")
    )
    heading = said(
        "Equivalent tests: time of each bearing ({unit}), by failures allowed", unit=unit
    )
    return doc.Section(heading, (doc.Table(tuple(columns), "alternatives"),), "alternatives")


# --- precision -------------------------------------------------------------------------------


def precision_page(found: PrecisionStudy) -> doc.Document:
    """Return the page of tests that determine a life to a precision; times in its unit.

    Parameters
    ----------
    found
        Of `rolamento.tasks.PrecisionTest`.
    """
    plans, ratio, unit = found.plans, found.ratio, one_line(found.unit)
    first = plans[0]
    quantity = life_name(Estimand.life(first.reliability))
    values = {"shape": first.shape, "quantity": quantity, "life": first.life, "unit": unit}
    given = [
        said("assumed: shape {shape:.4}, {quantity} {life:.4} {unit}", **values)
        if unit
        else said("assumed: shape {shape:.4}; times are multiples of {quantity}", **values)
    ]
    if ratio is not None:
        given.append(
            said(
                "required: {confidence} % bounds within a factor of {ratio:.3} of each other in"
                " half of the tests",
                confidence=percent(first.confidence),
                ratio=ratio,
            )
        )
    title = said("Precision of {quantity} from a life test", quantity=quantity)
    head: list[doc.Block] = [
        doc.Title(title),
        *(doc.Statement(text, "faint", indent=2) for text in given),
    ]
    unit = unit or quantity  # without a unit times are multiples of the life
    sections = [
        doc.Section(blocks=tuple(head), key="head"),
        doc.Section(blocks=_what_it_takes(plans, quantity, unit), key="test"),
    ]
    if found.planned:
        heading = said("Tests") if ratio is None else said("Tests of equal precision")
        sections.append(doc.Section(heading, (_table_of_plans(plans, unit),), "plans"))
        caption = said("Duration of the tests and the bearings they need")
        sections.append(
            picture(caption, lambda: plots.cost_figure(plans, found.time_label), "cost", "")
        )
    return doc.Document(title, tuple(sections), "weibull-plan")


def _what_it_takes(
    plans: Sequence[LifeTestPlan], quantity: str, unit: str
) -> tuple[doc.Statement, ...]:
    planned = [plan for plan in plans if plan.planned]
    if not planned:
        advice = plans[0].advice
        assert advice is not None
        return (_no_plan(advice),)
    first = planned[0]
    sentences = [
        said(
            "{bearings} bearings, {failures} failures: the {confidence} % bounds of {quantity}"
            " differ by a factor of {ratio:.3} in half of the tests, and of {rarely:.3} or more in"
            " 10 % of them.",
            bearings=first.bearings,
            failures=first.failures,
            confidence=percent(first.confidence),
            quantity=quantity,
            ratio=first.ratio,
            rarely=first.ratio_rarely_exceeded,
        )
    ]
    sudden = [plan for plan in planned if plan.group_size > 1]
    if first.scheme == "complete" and sudden:
        fastest = min(sudden, key=_mean_end)
        sentences += [
            said(
                "Testing {bearings} bearings until all have failed takes {time:.3} {unit}.",
                bearings=first.bearings,
                time=_mean_end(first),
                unit=unit,
            ),
            said(
                "A sudden-death test with {groups} groups of {size} is as precise with {failures}"
                " failures, and takes {time:.3} {unit}; it needs {bearings} bearings.",
                groups=fastest.groups,
                size=fastest.group_size,
                failures=fastest.failures,
                time=_mean_end(fastest),
                unit=unit,
                bearings=fastest.bearings,
            ),
        ]
    return _bullets(sentences)


def _mean_end(plan: LifeTestPlan) -> float:
    return float("inf") if plan.duration is None else plan.duration.mean


def _table_of_plans(plans: Sequence[LifeTestPlan], unit: str) -> doc.Table:
    """One line a test: in one table where it is wide enough, else in two."""
    counts = {"bearings": said("bearings"), "groups": said("rigs"), "failures": said("failures")}
    ratios = {
        "ratio": said("factor"),
        "ratio_rarely_exceeded": said("1 in 10"),
        "shape_ratio": said("shape"),
    }
    columns = [doc.Column("", [_kind(plan) for plan in plans], "test")]
    columns += [
        doc.Column(
            head,
            [getattr(plan, key) if plan.planned else ABSENT for plan in plans],
            key,
            align="right",
        )
        for key, head in counts.items()
    ]
    columns += [
        doc.Column(head, [getattr(plan, key) for plan in plans], key, figures=3)
        for key, head in ratios.items()
    ]
    first = next(plan for plan in plans if plan.planned)
    legend = said(
        "Factor: between the bounds, in half of the tests; 1 in 10: exceeded in 10 % of the tests;"
        " shape: factor between the bounds of the shape. Duration: mean, and the range in which"
        " 90 % of the tests end, with all rigs running at the same time. {samples} simulated tests,"
        " seed {seed}.",
        samples=first.samples,
        seed=str(first.seed),
    )
    return doc.Table(
        (*columns, *_time_columns(plans, unit)),
        "plans",
        breaks=(doc.Break(len(columns), "", legend),),
    )


def _time_columns(plans: Sequence[LifeTestPlan], unit: str) -> list[doc.Column]:
    ends = [plan.duration for plan in plans]
    limits = manner().column(
        [limit for end in ends if end is not None for limit in (end.lower, end.upper)], FIGURES
    )
    pairs = iter(zip(limits[::2], limits[1::2], strict=True))
    ranges = [ABSENT if end is None else "–".join(next(pairs)) for end in ends]
    numbers = {
        "mean": (
            said("duration {unit}", unit=unit),
            [nan if end is None else end.mean for end in ends],
        ),
        "bearing_time": (said("bearing·{unit}", unit=unit), [plan.bearing_time for plan in plans]),
        "rig_time": (said("rig·{unit}", unit=unit), [plan.rig_time for plan in plans]),
    }
    mean, *others = (
        doc.Column(head, values, key, most=4) for key, (head, values) in numbers.items()
    )
    bounds = [
        doc.Column(
            key,
            [nan if end is None else getattr(end, key) for end in ends],
            f"duration_{key}",
            only_in_files=True,
        )
        for key in ("lower", "upper")
    ]
    return [mean, doc.Column("(90 %)", ranges, align="right"), *bounds, *others]


def _kind(plan: LifeTestPlan) -> str:
    """Say how the test ends."""
    if plan.group_size > 1:
        return said("sudden death, {size} each", size=plan.group_size)
    if plan.scheme == "complete":
        return said("all fail")
    share = plan.failures / plan.groups if plan.groups else nan
    return said("{share:.2 [%]} % fail", share=share)


def _probability(share: float) -> str:
    """Write a probability in per cent; what is nearly sure, or nearly not, as more or less."""
    if not isfinite(share):
        return ABSENT
    if share < 0.001:
        return "< " + manner().short(0.1, 1)
    if share > 0.999:
        return "> " + manner().short(99.9, 3)
    return manner().fixed(100.0 * share, 1)


def _probability_cell(share: float) -> doc.CellContent:
    return doc.Number(share, ".1f [%]") if 0.001 <= share <= 0.999 else _probability(share)


def _time(time: float) -> doc.Number:
    return doc.Number(time, f".{FIGURES}")
