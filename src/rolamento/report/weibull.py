"""What a life test says, for a reader, and as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Final

import numpy as np
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import ABSENT
from rolamento.report.page import (
    FIGURES,
    Lines,
    Page,
    alike,
    beside,
    one_line,
    percent,
    rendered,
    short_number,
    shortened,
    table,
)
from rolamento.report.plain_data import json_text
from rolamento.report.weibull_sentences import said_advice, said_note
from rolamento.report.weibull_words import WEIBULL_WORDS, WeibullWords, counted
from rolamento.weibull import (
    EXPONENTS,
    Bounds,
    Comparison,
    Estimand,
    GroupSummary,
    LifeRatio,
    LifeTest,
    LifeTestSummary,
    Wanted,
)

__all__ = ["life_name", "weibull_json", "weibull_report"]

SCHEMA: Final = 1
_LEAST_P: Final = 0.001
_LONGEST_SHOWN_UNIT: Final = 12
_LETTERS: Final = {"β": "beta", "η": "eta"}
_GAP: Final = 3
_LONGEST_UNIT: Final = 6
_WIDE: Final = 100
_LONGEST_NAME: Final = (16, 36)
"""Of a calculated life, on a narrow page and on a wide one."""


def weibull_json(found: LifeTestSummary) -> str:
    """Return everything as one JSON object; times in the unit of the data, which it names."""
    return json_text({"schema": SCHEMA, "kind": "weibull", **found.to_mapping()})


def weibull_report(
    found: LifeTestSummary, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the page of a life test as text that ends in a newline.

    Parameters
    ----------
    found
        What to show.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    said = WEIBULL_WORDS[words.code]
    parts = [_heading(page, said, found)]
    for group in found.groups:
        parts += _parts_of_group(page, said, found.wanted, group, alone=len(found.groups) == 1)
    parts.append(_comparison(page, said, found))
    parts.append(_notes(page, said, found))
    return rendered(page.medium, [part for part in parts if part])


def _heading(page: Page, said: WeibullWords, found: LifeTestSummary) -> Lines:
    test, groups = found.test, found.groups
    facts = [_sizes(page, said, test)]
    if len(groups) > 1:
        facts.insert(1, said.groups.format(count=len(groups)))
    elif groups[0].name:
        facts[0] = f"{one_line(groups[0].name)}: {facts[0]}"
    first, last = (short_number(page, float(time), 6) for time in _ends(test))
    facts.append(said.from_to.format(first=first, last=last, unit=test.unit))
    entries = [
        (said.data, "; ".join(facts)),
        ("", "" if len(groups) > 1 else said.schemes.get(test.scheme, test.scheme)),
        (said.source, one_line(test.source)),
    ]
    width = max(len(label) for label, _ in entries)
    lines = page.hanging(Text(), one_line(test.title) or said.untitled, "bold")
    lines.append(page.rule(page.medium.width))
    for label, content in entries:
        if content:
            lines += page.hanging(page.text(f"{label:{width}}  ", "dim"), content)
    return lines


def _sizes(page: Page, said: WeibullWords, test: LifeTest) -> str:
    """Say how many bearings there were, and what became of them."""

    def count(forms: tuple[str, str], number: int) -> str:
        return counted(forms, number, page.digits.fixed(number, 0))

    facts = [count(said.bearings, test.size)]
    facts.append(count(said.failed, test.failures) if test.failures else said.none_failed)
    if test.failures and test.suspensions:
        facts.append(count(said.suspended, test.suspensions))
    return ", ".join(facts)


def _ends(test: LifeTest) -> tuple[float, float]:
    return float(np.min(test.times)), float(np.max(test.times))


def _parts_of_group(
    page: Page, said: WeibullWords, wanted: Wanted, group: GroupSummary, *, alone: bool
) -> list[Lines]:
    """Say what one group says: in sentences, then in tables."""
    parts = [_statement(page, said, group, wanted)]
    if not alone:
        name = page.text(f"{one_line(group.name)}: {_sizes(page, said, group.test)}", "bold")
        scheme = said.schemes.get(group.test.scheme, group.test.scheme)
        parts[0][:0] = [
            name,
            page.rule(max(len(name), 40)),
            *page.hanging(Text("  "), scheme, "dim"),
        ]
    fits, bounds = _table_of_fits(page, said, group), _table_of_bounds(page, said, group)
    legend = page.hanging(Text("  "), _bounded_by(page, said, group), "dim") if bounds else []
    if fits and bounds and _width(fits) + _GAP + _width(bounds) <= page.medium.width:
        parts.append([*beside(fits, bounds, _GAP), *legend])
    else:
        parts += [fits, [*bounds, *legend]]
    if group.assumed:
        parts.append(_at_assumed_shapes(page, said, group, wanted))
    if group.credible:
        parts.append(_table_of_posterior(page, said, group, wanted))
    if any(one.code == "converged" for one in group.calculated.values()):
        parts.append(_table_of_calculated(page, said, group, wanted))
    return parts


def _width(lines: Lines) -> int:
    return max(map(len, lines))


# --- tables ----------------------------------------------------------------------------------


def _table_of_fits(page: Page, said: WeibullWords, group: GroupSummary) -> Lines:
    """One line a method; nothing where no method has a result."""
    unit = one_line(group.test.unit)
    fits = [fit for fit in group.fits if fit.converged]
    if not fits:
        return []
    heads = [said.fitted_by, *(_spelt(page, head) for head in (said.shape, said.scale))]
    heads += ["L10", "L50", said.mean]
    columns = [
        alike(page, [getattr(fit, name) for fit in fits])
        for name in ("shape", "scale", "l10", "l50", "mean")
    ]
    rows = [[page.text(head, "dim") for head in heads]]
    for index, fit in enumerate(fits):
        style = "bold" if fit is group.main else ""
        cells = [said.fits.get(fit.method, fit.method), *(column[index] for column in columns)]
        rows.append([page.text(cell, style) for cell in cells])
    lines = [
        page.heading(said.fit.format(unit=unit)),
        *page.columns(rows, "l" + "r" * (len(heads) - 1)),
    ]
    for fit in fits:
        if fit.location > 0.0:
            location = short_number(page, fit.location)
            text = said.location.format(location=location, unit=unit)
            lines += page.hanging(Text("  "), text, "dim")
    return lines


def _table_of_bounds(page: Page, said: WeibullWords, group: GroupSummary) -> Lines:
    first = group.bounds[0]
    if not group.bounded:
        return []
    heads = ["", said.estimate, *_limit_heads(said, first)]
    rows = []
    for bound in group.bounds:
        quantity = Estimand.of(bound.quantity)
        scale = _shown_scale(quantity)
        cells = alike(page, [scale * number for number in (bound.estimate, *_limits(bound))])
        if bound.sides == "two":
            of_share = quantity.kind == "reliability" or bound.lower <= 0.0
            cells.append("" if of_share else short_number(page, bound.ratio, 3))
        rows.append([name_with_unit(page, said, quantity, group.test.unit), *cells])
    confidence = percent(page, first.confidence)
    return [page.heading(said.bounds.format(confidence=confidence)), *table(page, heads, rows)]


def _bounded_by(page: Page, said: WeibullWords, group: GroupSummary) -> str:
    """Say how the bounds were found."""
    first = next(bound for bound in group.bounds if bound.converged)
    drawn = ""
    if first.samples:
        drawn = said.drawn.format(samples=page.digits.fixed(first.samples, 0), seed=first.seed)
        if first.dropped:
            drawn += said.dropped.format(dropped=page.digits.fixed(first.dropped, 0))
    method = said.bound_methods.get(first.method, first.method.replace("_", " "))
    return said.bounds_by.format(
        confidence=percent(page, first.confidence), method=method, drawn=drawn
    )


def _limit_heads(said: WeibullWords, bound: Bounds) -> list[str]:
    if bound.sides == "two":
        return [said.low, said.high, said.apart]
    return [said.at_least if bound.sides == "lower" else said.at_most]


def _limits(bound: Bounds) -> list[float]:
    if bound.sides == "two":
        return [bound.lower, bound.upper]
    return [bound.lower if bound.sides == "lower" else bound.upper]


def _at_assumed_shapes(
    page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted
) -> Lines:
    """One line a shape: bounds on every life and reliability."""
    unit = group.test.unit
    heads = [_spelt(page, said.assumed_shape)]
    rows = []
    for assumed in group.assumed:
        cells = [page.digits.short(assumed.shape, 3)]
        for bound in assumed.bounds:
            cells.append(_range_text(page, said, bound, _shown_scale(Estimand.of(bound.quantity))))
        rows.append(cells)
    for bound in group.assumed[0].bounds:
        heads.append(name_with_unit(page, said, Estimand.of(bound.quantity), unit))
    confidence = percent(page, wanted.confidence)
    return [
        page.heading(said.assumed.format(confidence=confidence)),
        *table(page, heads, rows),
    ]


def _range_text(page: Page, said: WeibullWords, bound: Bounds, scale: float) -> str:
    cells = [short_number(page, scale * limit) for limit in _limits(bound)]
    if bound.sides == "two":
        return f"{said.low} {cells[0]} {said.high} {cells[1]}"
    return f"{_limit_heads(said, bound)[0]} {cells[0]}"


def _table_of_posterior(
    page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted
) -> Lines:
    prior = wanted.prior
    assert prior is not None
    probability = 1.0 if prior.kind == "uniform" else prior.probability
    heading = said.prior.format(
        low=page.digits.short(prior.low, 3),
        high=page.digits.short(prior.high, 3),
        probability=percent(page, probability),
        kind=said.priors[prior.kind],
    )
    rows = []
    for one in group.credible:
        quantity = Estimand.of(one.quantity)
        scale = _shown_scale(quantity)
        cells = alike(page, [scale * x for x in (one.median, one.lower, one.upper)])
        rows.append([name_with_unit(page, said, quantity, group.test.unit), *cells])
    return [page.heading(heading), *table(page, ["", said.median, said.low, said.high], rows)]


def _table_of_calculated(
    page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted
) -> Lines:
    heads = ["", shortened(one_line(group.test.unit), _LONGEST_UNIT), said.observed_ratio]
    heads += [said.low, said.high, said.p_value, said.contradicted]
    rows = [
        [
            shortened(one_line(name), _LONGEST_NAME[page.medium.width >= _WIDE]),
            short_number(page, one.calculated),
            *(short_number(page, x, 3) for x in (one.ratio, one.lower, one.upper)),
            _p_text(page, one.p_value),
            said.verdicts[one.bearings_live] if one.code == "converged" else ABSENT,
        ]
        for name, one in group.calculated.items()
    ]
    quantity = life_name(page, wanted.lives[0])
    confidence = percent(page, wanted.confidence)
    return [
        page.heading(said.calculated.format(quantity=quantity, confidence=confidence)),
        *table(page, heads, rows, "lrrrrrl"),
        *page.hanging(Text("  "), said.calculated_legend, "dim"),
    ]


def _notes(page: Page, said: WeibullWords, found: LifeTestSummary) -> Lines:
    names: dict[str, None] = {}
    for group in found.groups:
        for noted in (*(fit.notes for fit in group.fits), *(one.notes for one in group.bounds)):
            names |= dict.fromkeys(noted)
    for noted in (*(one.notes for one in found.comparisons), *(one.notes for one in found.ratios)):
        names |= dict.fromkeys(noted)
    sentences = [said_note(name, page.words.code) for name in names]
    if found.test.passed_over:
        columns = ", ".join(shortened(one_line(name), 30) for name in found.test.passed_over)
        sentences.insert(0, said.passed_over.format(columns=columns))
    if found.test.inspected:
        sentences.append(said.no_ranks)
        if len(found.groups) > 1:
            sentences.append(said.not_compared)
    elif not all(group.ranked for group in found.groups):
        sentences.append(said.too_many_for_ranks)
    lines = [page.heading(said.notes)] if sentences else []
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "yellow"), sentence)
    return lines


# --- sentences -------------------------------------------------------------------------------


def _statement(page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted) -> Lines:
    """Say in sentences what one group says, without a heading."""
    lines: Lines = []
    if not group.bounded and not group.main.converged:
        advice = said_advice(group.main.code, page.words.code)
        lines += page.hanging(page.text("  ✗ ", "red"), said.nothing.format(advice=advice))
    sentences = _of_the_life(page, said, group, wanted)
    if wanted.shape is None:
        sentences += _of_the_shape(said, group)
    elif sentences:
        sentences.append(said.shape_given.format(shape=page.digits.short(wanted.shape, FIGURES)))
    sentences += _of_the_calculation(said, group)
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "green"), sentence)
    return lines


def _of_the_life(page: Page, said: WeibullWords, group: GroupSummary, wanted: Wanted) -> list[str]:
    """Of the first life that was wanted."""
    life = wanted.lives[0]
    bound = group.bound(life)
    if bound is None or not bound.converged:
        return []
    two = bound.sides == "two"
    lower, upper = alike(page, [bound.lower, bound.upper])
    shown = {
        "confidence": percent(page, bound.one_sided_confidence),
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
        apart = short_number(page, bound.ratio, 2)
        return [said.life_two_sided.format(**shown, apart=apart)]
    return [said.life_at_least.format(**shown)]


def _of_the_shape(said: WeibullWords, group: GroupSummary) -> list[str]:
    bound = group.bound(Estimand.of("shape"))
    if bound is None or not bound.converged or bound.sides != "two":
        return []
    inside = bound.contains(EXPONENTS["ball"])
    return [
        said.shape_below
        if bound.upper < 1.0
        else (said.shape_above if bound.lower > 1.0 else said.shape_open),
        said.rating_inside if inside else said.rating_outside,
    ]


def _of_the_calculation(said: WeibullWords, group: GroupSummary) -> list[str]:
    judged = {name: one for name, one in group.calculated.items() if one.code == "converged"}
    sentences = []
    for live, sentence in said.contradict.items():
        names = [one_line(name) for name, one in judged.items() if one.bearings_live == live]
        if names:
            sentences.append(sentence.format(names="; ".join(names)))
    return [said.none_contradict] if judged and not sentences else sentences


def _comparison(page: Page, said: WeibullWords, found: LifeTestSummary) -> Lines:
    """Show whether the groups differ, and by how much."""
    if not found.comparisons:
        return []
    judged = [one for one in found.comparisons if one.converged]
    lines = [page.heading(said.comparison)]
    sentences = _sentence_of_difference(page, said, judged, found.wanted.confidence)
    sentences += [_sentence_of_ratio(page, said, ratio) for ratio in found.ratios]
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "green"), sentence)
    rows = [[said.hypotheses[one.hypothesis], _p_text(page, one.p_value)] for one in judged]
    return [*lines, *(table(page, ["", said.p_value], rows) if rows else [])]


def _sentence_of_difference(
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
    return [sentence.format(hypothesis=name, p=_p_text(page, one.p_value))]


def _sentence_of_ratio(page: Page, said: WeibullWords, ratio: LifeRatio) -> str:
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
        p=_p_text(page, ratio.p_value),
    )


# --- names and numbers -----------------------------------------------------------------------


def _p_text(page: Page, p: float) -> str:
    """Write a p-value; the smallest only as being small."""
    if isfinite(p) and p < _LEAST_P:
        return "< " + page.digits.short(_LEAST_P, 1)
    return page.digits.short(p, 2)


def _shown_scale(quantity: Estimand) -> float:
    """Return what a quantity is multiplied with to be read: reliabilities in per cent."""
    return 100.0 if quantity.kind == "reliability" else 1.0


def name_with_unit(page: Page, said: WeibullWords, quantity: Estimand, unit: str) -> str:
    """Write what a quantity is, with its unit."""
    if quantity.kind == "shape":
        return _spelt(page, said.shape)
    unit = shortened(one_line(unit), _LONGEST_SHOWN_UNIT)
    if quantity.kind == "reliability":
        return said.reliability_at.format(time=page.digits.short(quantity.value, 6), unit=unit)
    name = _spelt(page, said.scale) if quantity.name == "scale" else life_name(page, quantity)
    return f"{name} {unit}"


def _spelt(page: Page, text: str) -> str:
    """Spell out the letters of shape and scale where they cannot be shown."""
    for letter, name in _LETTERS.items():
        text = text if page.medium.shows(letter) else text.replace(letter, name)
    return text


def life_name(page: Page, quantity: Estimand) -> str:
    """Write the name of a life, with our decimal mark: L10, L0,1."""
    return quantity.name.replace(".", page.words.decimal_mark)
