"""The pages of `replace`: what is left of a life, when to replace, failures of a fleet."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.io.dates import moment_after, moment_said
from rolamento.pages.given import picture
from rolamento.pages.lives import FIGURES, percent
from rolamento.pages.notes import cautions, notes_section, remarks_of
from rolamento.words import ABSENT, ENDLESS, counted, manner, said
from rolamento.words.naming import one_line, shortened

if TYPE_CHECKING:
    from rolamento.tasks.replace import FleetStudy, RemainingStudy, ReplacementStudy
    from rolamento.weibull.distribution import Interval, LifeDistribution

__all__ = ["fleet_page", "remaining_page", "replacement_page"]

_MOST_ROWS: Final = 60


# --- what is left of a life ------------------------------------------------------------------


def remaining_page(study: RemainingStudy) -> doc.Document:
    """Return the page of what is left of a life.

    Parameters
    ----------
    study
        Of `rolamento.tasks.RemainingLifeRequest`.
    """
    title = said("Remaining life")
    found = study.found
    if found is None:
        return _nothing(title, study.distribution)
    unit = one_line(found.distribution.unit)
    confidence = percent(found.confidence)
    statements: list[doc.Block] = []
    if isfinite(found.mission):
        values = {"age": found.age, "mission": found.mission, "unit": unit}
        chance = found.reliability
        text = (
            said(
                "A bearing that has run {age:.6} {unit} runs {mission:.6} {unit} more with"
                " {chance} % probability ({confidence} % confidence: {lower} to {upper} %).",
                chance=_chance(chance.value),
                lower=_chance(chance.lower),
                upper=_chance(chance.upper),
                confidence=confidence,
                **values,
            )
            if isfinite(chance.lower)
            else said(
                "A bearing that has run {age:.6} {unit} runs {mission:.6} {unit} more with"
                " {chance} % probability.",
                chance=_chance(chance.value),
                **values,
            )
        )
        statements.append(doc.Statement(text, "strong"))
        text = said("A new one would do so with {chance} % probability.", chance=_chance(found.new))
        statements.append(doc.Statement(text, "faint"))
    rows = [
        (said("mean"), found.mean),
        (said("median"), found.median),
        *(
            (said("reached by {share} %", share=percent(p)), interval)
            for p, interval in found.quantiles
            if p != 0.5
        ),
    ]
    columns = (
        doc.Column("", [name for name, _ in rows], "quantity"),
        *_interval_columns([interval for _, interval in rows], unit, confidence),
    )
    heading = said("Time left after {age:.6} {unit}", age=found.age, unit=unit)
    notes = (*study.distribution.notes, *study.notes)
    sections = [
        doc.Section("", (*statements, *cautions(notes)), "verdict"),
        _head(title, study.distribution, study.title),
        doc.Section(heading, (doc.Table(columns, "residual_lives"),), "residual"),
    ]

    caption = said("Probability of running on, over the time from now")
    sections += [
        *notes_section(remarks_of(notes)),
        picture(caption, lambda: plots.remaining_life_figure(found), "remaining", "figures"),
    ]
    return doc.Document(title, tuple(sections), kind="remaining-life", main="residual_lives")


# --- when to replace -------------------------------------------------------------------------


def replacement_page(study: ReplacementStudy) -> doc.Document:
    """Return the page of the age of replacement at least cost.

    Parameters
    ----------
    study
        Of `rolamento.tasks.ReplacementRequest`.
    """
    title = said("Age replacement at least cost")
    found = study.found
    if found is None:
        return _nothing(title, study.distribution)
    unit, money = one_line(found.distribution.unit), one_line(study.currency, 20)
    confidence = percent(found.confidence)
    tone: doc.Tone = "good-strong" if found.worthwhile else "warning-strong"
    blocks: list[doc.Block] = [doc.Statement(_verdict(study), tone)]
    if found.worthwhile and isfinite(found.age.lower):
        text = said(
            "{confidence} % interval of that age: {lower} to {upper} {unit}; in {none} % of the"
            " distributions that the data allow, planned replacement does not pay.",
            confidence=confidence,
            lower=_time(found.age.lower),
            upper=_time(found.age.upper),
            unit=unit,
            none=_chance(found.no_optimum),
        )
        blocks.append(doc.Statement(text, "faint"))
    entries = [
        doc.Entry(said("planned replacement"), _money(found.planned, money)),
        doc.Entry(said("failure"), _money(found.failure, money)),
        doc.Entry(
            said("replaced on failure"),
            said(
                "{cost} per 1000 {unit}",
                cost=_money(1000.0 * found.cost_on_failure, money),
                unit=unit,
            ),
        ),
    ]
    if found.worthwhile:
        entries += [
            doc.Entry(
                said("replaced at {age} {unit}", age=_time(found.age.value), unit=unit),
                said("{cost} per 1000 {unit}", cost=_money(1000.0 * found.cost, money), unit=unit),
            ),
            doc.Entry(said("saving"), _interval_percent(found.saving, confidence)),
            doc.Entry(said("fail before that age"), said("{part} %", part=_chance(found.failed))),
            doc.Entry(
                said("mean time between replacements"),
                said("{time:.4} {unit}", time=found.interval, unit=unit),
            ),
            doc.Entry(
                said("cost within 5 %"),
                said(
                    "from {low} to {high} {unit}",
                    low=_time(found.near[0]),
                    high=_time(found.near[1]),
                    unit=unit,
                ),
            ),
        ]
    notes = (*study.distribution.notes, *study.notes)
    sections = [
        doc.Section("", (*blocks, *cautions(notes)), "verdict"),
        _head(title, study.distribution, study.title),
        doc.Section(said("Costs"), (doc.KeyValues(tuple(entries), 2),), "costs"),
    ]
    if found.if_shape:
        sections.append(_if_shape(study))

    caption = said("Cost of replacing at an age")
    sections += [
        *notes_section(remarks_of(notes)),
        picture(
            caption, lambda: plots.cost_of_ages_figure(found, study.currency), "cost", "figures"
        ),
    ]
    return doc.Document(title, tuple(sections), kind="age-replacement", main="if_shape")


def _verdict(study: ReplacementStudy) -> str:
    found = study.found
    assert found is not None
    unit = one_line(found.distribution.unit)
    if found.code == "optimum":
        return said(
            "Replace at {age} {unit}: it costs {saving} % less than replacing on failure.",
            age=_time(found.age.value),
            unit=unit,
            saving=_chance(found.saving.value),
        )
    if found.code == "not_worn":
        return said(
            "Replace on failure: with a shape of {shape:.3}, not above 1, the failure rate does not"
            " rise with age, and a running bearing is no worse than a new one.",
            shape=found.distribution.shape,
        )
    if found.code == "not_dearer":
        return said("Replace on failure: a failure costs no more than a planned replacement.")
    return said("Replace on failure: planned replacement would save less than 0.1 %.")


def _if_shape(study: ReplacementStudy) -> doc.Section:
    found = study.found
    assert found is not None
    unit = one_line(found.distribution.unit)
    columns = (
        doc.Column(said("shape"), [doc.Number(one.shape, ".3") for one in found.if_shape], "shape"),
        doc.Column(
            said("least cost at {unit}", unit=unit),
            [_time(one.best) for one in found.if_shape],
            "age",
            align="right",
        ),
        doc.Column(
            said("saving"), [one.saving for one in found.if_shape], "saving", "%", form=".1f [%]"
        ),
        doc.Column(
            said("above least"),
            [one.regret for one in found.if_shape],
            "regret",
            "%",
            form=".1f [%]",
        ),
    )
    legend = said(
        "What replacing at {age} {unit} saves, and costs above the least, if the shape is another"
        " with the same L10.",
        age=_time(found.age.value),
        unit=unit,
    )
    table = doc.Table(columns, "if_shape", legends=(legend,))
    return doc.Section(said("If the shape is different"), (table,), "if_shape")


# --- a fleet ---------------------------------------------------------------------------------


def fleet_page(study: FleetStudy) -> doc.Document:
    """Return the page of the failures of a fleet.

    Parameters
    ----------
    study
        Of `rolamento.tasks.FleetRequest`.
    """
    title = said("Expected failures of a fleet")
    found = study.found
    if found is None:
        return _nothing(title, study.distribution)
    unit, end = one_line(found.distribution.unit), found.end
    values = {
        "expected": end.expected,
        "lower": int(end.lower),
        "upper": int(end.upper),
        "confidence": percent(found.confidence),
        "bearings": found.fleet.size,
    }
    if study.begin is not None and study.end is not None:
        text = said(
            "Of {bearings} bearings, {expected:.3} failures are expected from {begin} to {end};"
            " with {confidence} % probability between {lower} and {upper}.",
            begin=moment_said(study.begin),
            end=moment_said(study.end),
            **values,
        )
    else:
        text = said(
            "Of {bearings} bearings, {expected:.3} failures are expected within {time:.6} {unit};"
            " with {confidence} % probability between {lower} and {upper}.",
            time=float(found.fleet.ahead.max()),
            unit=unit,
            **values,
        )
    entries = [
        doc.Entry(
            said("bearings that fail"),
            said("are replaced by new ones, which may fail too")
            if found.renewed
            else said("are not replaced"),
        ),
        doc.Entry(said("no failure"), said("{chance} % probability", chance=_chance(found.none))),
    ]
    if isfinite(found.exact[0]) and found.distribution.uncertain:
        entries.append(
            doc.Entry(
                said("by chance alone"),
                said(
                    "{lower} to {upper}, if the fitted distribution were exact",
                    lower=int(found.exact[0]),
                    upper=int(found.exact[1]),
                ),
            )
        )
    text_now = said("{now:.3} among bearings of these ages", now=found.now)
    if study.of_data and found.distribution.failures:
        observed = counted("{n} failure", "{n} failures", found.distribution.failures)
        text_now = said(
            "{now:.3} among bearings of these ages; the data have {observed}",
            now=found.now,
            observed=observed,
        )
    entries.append(doc.Entry(said("expected by now"), text_now))
    notes = (*study.distribution.notes, *study.notes)
    sections = [
        doc.Section("", (doc.Statement(text, "strong"), *cautions(notes)), "verdict"),
        _head(title, study.distribution, study.title),
        doc.Section("", (doc.KeyValues(tuple(entries)),), "facts"),
        _steps(study),
        _bearings(study),
    ]

    caption = said("Failures of the fleet over the time from now")
    sections += [
        *notes_section(remarks_of(notes)),
        picture(caption, lambda: plots.fleet_failures_figure(found), "failures", "figures"),
    ]
    return doc.Document(title, tuple(sections), kind="fleet", main="steps")


def _steps(study: FleetStudy) -> doc.Section:
    from datetime import timedelta

    found = study.found
    assert found is not None
    ahead, unit = found.fleet.ahead, one_line(found.distribution.unit)
    if study.begin is not None and study.end is not None:
        days = (study.end - study.begin) / timedelta(days=1)
        at: list[doc.CellContent] = [
            moment_after(moment_said(study.begin), step.part * days, to_the_day=True)
            for step in found.steps
        ]
        head = said("until")
    else:
        head = said("within {unit}", unit=unit)
        at = [doc.Number(step.part * float(ahead.max()), ".4r") for step in found.steps]
    columns = (
        doc.Column(head, at, "until", align="right"),
        doc.Column(
            said("expected"), [doc.Number(step.expected, ".3") for step in found.steps], "expected"
        ),
        doc.Column(said("from"), [int(step.lower) for step in found.steps], "lower"),
        doc.Column(said("to"), [int(step.upper) for step in found.steps], "upper"),
    )
    legend = said(
        "Cumulated failures; from–to: {confidence} % prediction interval, with chance and with the"
        " uncertainty of the distribution.",
        confidence=percent(found.confidence),
    )
    return doc.Section(said("Failures"), (doc.Table(columns, "steps", legends=(legend,)),), "steps")


def _bearings(study: FleetStudy) -> doc.Section:
    found = study.found
    assert found is not None
    fleet, unit = found.fleet, one_line(found.distribution.unit)
    rows = [place for place, _ in found.riskiest]
    named = any(study.names)
    columns = [
        *(
            [
                doc.Column(
                    said("bearing"), [shortened(one_line(study.names[row])) for row in rows], "name"
                )
            ]
            * named
        ),
        doc.Column(
            said("has run {unit}", unit=unit),
            [doc.Number(float(fleet.ages[row]), ".6") for row in rows],
            "age",
        ),
        doc.Column(
            said("will run {unit}", unit=unit),
            [doc.Number(float(fleet.ahead[row]), ".6") for row in rows],
            "ahead",
        ),
        doc.Column(said("bearings"), [int(fleet.counts[row]) for row in rows], "count"),
        doc.Column(
            said("fails"), [p for _, p in found.riskiest], "probability", "%", form=".3 [%]"
        ),
    ]
    heading = said("Most likely to fail")
    legend = said("Fails: probability that a bearing of the row fails at least once.")
    table = doc.Table(tuple(columns), "riskiest", legends=(legend,))
    return doc.Section(heading, (table,), "riskiest")


# --- what the pages share --------------------------------------------------------------------


def _nothing(title: str, law: LifeDistribution) -> doc.Document:
    advice = law.advice
    assert advice is not None
    statement = doc.Statement(advice.text, indent=2, mark="✗", mark_tone="bad")
    return doc.Document(
        title, (doc.Section("", (doc.Title(title), statement), "verdict"),), "replace"
    )


def _head(title: str, law: LifeDistribution, data: str) -> doc.Section:
    unit = one_line(law.unit)
    values = {"shape": law.shape, "scale": law.scale, "unit": unit}
    how = {
        "given": said("given: shape β = {shape:.4}, scale η = {scale:.5} {unit}", **values),
        "maximum_likelihood": said(
            "fitted: shape β = {shape:.4}, scale η = {scale:.5} {unit}; {failures} of {size}"
            " bearings failed",
            failures=law.failures,
            size=law.size,
            **values,
        ),
        "fixed_shape": said(
            "shape β = {shape:.4} assumed, scale η = {scale:.5} {unit} fitted; {failures} of {size}"
            " bearings failed",
            failures=law.failures,
            size=law.size,
            **values,
        ),
    }[law.method]
    entries = [doc.Entry(said("Weibull distribution"), how)]
    if data:
        entries.insert(0, doc.Entry(said("data"), one_line(data)))
    return doc.Section("", (doc.Title(title), doc.KeyValues(tuple(entries))), "head")


def _interval_columns(
    intervals: list[Interval], unit: str, confidence: str
) -> Iterable[doc.Column]:
    heads = {
        "value": unit,
        "lower": said("from ({confidence} %)", confidence=confidence),
        "upper": said("to ({confidence} %)", confidence=confidence),
    }
    known = any(isfinite(interval.lower) for interval in intervals)
    for name, head in heads.items():
        if name == "value" or known:
            values = [_time(getattr(interval, name)) for interval in intervals]
            yield doc.Column(head, values, name, align="right")


def _interval_percent(interval: Interval, confidence: str) -> str:
    if not isfinite(interval.lower):
        return said("{value} %", value=_chance(interval.value))
    return said(
        "{value} % ({confidence} % confidence: {lower} to {upper} %)",
        value=_chance(interval.value),
        confidence=confidence,
        lower=_chance(interval.lower),
        upper=_chance(interval.upper),
    )


def _chance(share: float) -> str:
    """Write a share in per cent: one decimal, more where it is near 0 or 1."""
    if not isfinite(share):
        return ABSENT
    if 0.0 < share < 0.001:
        return manner().short(100.0 * share, 2)
    if 0.999 < share < 1.0:
        return manner().short(100.0 * share, 5)
    return manner().fixed(100.0 * share, 1)


def _time(value: float) -> str:
    if value == float("inf"):
        return ENDLESS
    return manner().number(value, f".{FIGURES}r") if isfinite(value) else ABSENT


def _money(value: float, currency: str) -> str:
    text = manner().number(value, ".5")
    return f"{text} {currency}" if currency else text
