"""What a life test says, in sentences: lives, the shape, calculated lives, groups."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Final

from rolamento.report.page import Lines, Page
from rolamento.report.weibull_numbers import (
    FIGURES,
    alike,
    life_name,
    one_line,
    p_text,
    percent,
    short_number,
    table,
)
from rolamento.report.weibull_sentences import said_advice
from rolamento.report.weibull_words import WeibullWords
from rolamento.weibull import (
    Comparison,
    Estimand,
    GroupSummary,
    LifeRatio,
    LifeTestSummary,
    Wanted,
)

__all__ = ["comparison_part", "statement_part"]

_RATING_SHAPE: Final = 10.0 / 9.0


def statement_part(page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted) -> Lines:
    """Say in sentences what one group says, without a heading."""
    lines: Lines = []
    if not group.bounded and not group.main.converged:
        advice = said_advice(group.main.code, page.words.code)
        lines += page.hanging(page.text("  ✗ ", "red"), said.nothing.format(advice=advice))
    sentences = _of_life(page, said, group, wanted)
    if wanted.shape is None:
        sentences += _of_shape(said, group)
    elif sentences:
        sentences.append(said.shape_given.format(shape=page.digits.short(wanted.shape, FIGURES)))
    sentences += _of_calculation(said, group)
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "green"), sentence)
    return lines


def _of_life(page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted) -> list[str]:
    """Of the first life that was wanted."""
    life = wanted.lives[0]
    bound = group.bound(life)
    if bound is None or not bound.converged:
        return []
    two = bound.sides == "two"
    # a limit of two sides is one of one side with half of what is left out
    one_sided = 0.5 * (1.0 + bound.confidence) if two else bound.confidence
    lower, upper = alike(page, [bound.lower, bound.upper])
    shown = {
        "confidence": percent(page, one_sided),
        "share": percent(page, life.value),
        "lower": lower,
        "upper": upper,
        "unit": group.test.unit,
        "quantity": life_name(page, life),
    }
    if bound.sides == "upper":
        return [said.life_at_most.format(**shown)] if isfinite(bound.upper) else []
    if bound.lower <= 0.0:
        return []
    if two and isfinite(bound.upper):
        apart = short_number(page, bound.upper / bound.lower, 2)
        return [said.life_two_sided.format(**shown, apart=apart)]
    return [said.life_at_least.format(**shown)]


def _of_shape(said: WeibullWords, group: GroupSummary) -> list[str]:
    bound = group.bound(Estimand.of("shape"))
    if bound is None or not bound.converged or bound.sides != "two":
        return []
    inside = bound.lower <= _RATING_SHAPE <= bound.upper
    return [
        said.shape_below
        if bound.upper < 1.0
        else (said.shape_above if bound.lower > 1.0 else said.shape_open),
        said.rating_inside if inside else said.rating_outside,
    ]


def _of_calculation(said: WeibullWords, group: GroupSummary) -> list[str]:
    judged = {name: one for name, one in group.calculated.items() if one.code == "converged"}
    sentences = []
    for live, sentence in said.contradict.items():
        names = [one_line(name) for name, one in judged.items() if one.bearings_live == live]
        if names:
            sentences.append(sentence.format(names="; ".join(names)))
    return [said.none_contradict] if judged and not sentences else sentences


def comparison_part(page: Page, said: WeibullWords, found: LifeTestSummary) -> Lines:
    """Show whether the groups differ, and by how much."""
    if not found.comparisons:
        return []
    judged = [one for one in found.comparisons if one.converged]
    lines = [page.heading(said.comparison)]
    sentences = _difference(page, said, judged, found.wanted.confidence)
    sentences += [_ratio(page, said, ratio) for ratio in found.ratios]
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "green"), sentence)
    rows = [[said.hypotheses[one.hypothesis], p_text(page, one.p_value)] for one in judged]
    return [*lines, *(table(page, ["", said.p_value], rows) if rows else [])]


def _difference(
    page: Page, said: WeibullWords, judged: Sequence[Comparison], confidence: float
) -> list[str]:
    """Of the hypotheses that have a p-value, the first that is rejected; else the last."""
    if not judged:
        return []
    rejected = [one for one in judged if one.rejected(confidence)]
    one = rejected[0] if rejected else judged[-1]
    sentence, name = (
        said.differ if rejected else said.do_not_differ,
        said.hypotheses[one.hypothesis],
    )
    return [sentence.format(hypothesis=name, p=p_text(page, one.p_value))]


def _ratio(page: Page, said: WeibullWords, ratio: LifeRatio) -> str:
    first, second = (one_line(name) for name in ratio.groups)
    quantity = life_name(page, Estimand.life(ratio.reliability))
    if not ratio.converged:
        advice = said_advice(ratio.code, page.words.code)
        advice = advice[:1].upper() + advice[1:]
        return said.no_ratio.format(quantity=quantity, first=first, second=second, advice=advice)
    sentence = said.ratio if ratio.common_shape else said.ratio_own_shapes
    numbers = [short_number(page, x, 3) for x in (ratio.ratio, ratio.lower, ratio.upper)]
    return sentence.format(
        quantity=quantity,
        first=first,
        second=second,
        ratio=numbers[0],
        lower=numbers[1],
        upper=numbers[2],
        confidence=percent(page, ratio.confidence),
        shape=page.digits.short(ratio.shape, 3),
        p=p_text(page, ratio.p_value),
    )
