"""The page of a life test: Weibull fits, bounds, a calculated life, groups compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.lives import alike, brief, life_name, percent, written
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.weibull import (
    EXPONENTS,
    Bounds,
    Comparison,
    Estimand,
    GroupSummary,
    LifeModel,
    LifeRatio,
    LifeTest,
    LifeTestRequest,
    LifeTestSummary,
    Sides,
    bands_of,
    regions_of,
)
from rolamento.words import ABSENT, Note, counted, manner, marked, said
from rolamento.words.naming import one_line, shortened

if TYPE_CHECKING:
    pass

__all__ = ["weibull_page"]

_LEAST_P: Final = 0.001
_LONGEST_SHOWN_UNIT: Final = 12
_LONGEST_UNIT: Final = 6
_LONGEST_NAME: Final = 18

SCHEMES: Final[Mapping[str, str]] = {
    "complete": marked("all failed"),
    "type_ii": marked("stopped at the last failure"),
    "sudden_death": marked("sudden death: rigs stopped at their first failure"),
    "type_i": marked("stopped at a set time, the same for all"),
    "multiple": marked("suspended at various times"),
    "interval": marked("failures found at inspections"),
}
FITS: Final[Mapping[str, str]] = {
    "maximum_likelihood": marked("maximum likelihood"),
    "unbiased": marked("  with unbiased shape"),
    "rank_regression_x_on_y": marked("rank regression, X on Y"),
    "rank_regression_y_on_x": marked("rank regression, Y on X"),
    "three_parameter": marked("three parameters"),
    "fixed_shape": marked("known shape"),
}
BOUND_METHODS: Final[Mapping[str, str]] = {
    "pivotal": marked("maximum-likelihood pivots"),
    "calibrated_likelihood_ratio": marked("calibrated likelihood ratio"),
    "likelihood_ratio": marked("likelihood ratio"),
    "fisher": marked("Fisher information"),
    "parametric_percentile": marked("parametric bootstrap, percentiles"),
    "parametric_bias_corrected": marked("parametric bootstrap, bias-corrected"),
    "bootstrap_percentile": marked("bootstrap, percentiles"),
    "bootstrap_bca": marked("bootstrap, bias-corrected and accelerated"),
    "fixed_shape": marked("chi-square at the known shape"),
}
MODELS: Final[Mapping[str, str]] = {
    "weibull": marked("Weibull"),
    "three_parameter": marked("Weibull with a failure-free time"),
    "lognormal": marked("lognormal"),
    "limited_population": marked("Weibull, of a limited population"),
    "mixture": marked("two populations, Weibull each"),
    "two_modes": marked("two failure modes, Weibull each"),
}
_TRY: Final[Mapping[str, str]] = {
    "three_parameter": marked(
        "The best fit is {name}: nothing may fail before {location} {unit}. Repeat with"
        " `three_parameter`."
    ),
    "lognormal": marked(
        "The best fit is {name}, as where damage grows in proportion to its extent."
    ),
    "limited_population": marked(
        "The best fit is {name}: perhaps only {share} % of the bearings can fail in this way. Look"
        " for what they have in common, such as a lot."
    ),
    "mixture": marked(
        "The best fit is {name}: perhaps {share} % of the bearings are of a weaker kind. Look for"
        " what they have in common, such as a lot, and separate them as a group."
    ),
    "two_modes": marked(
        "The best fit is {name}: examine the failed bearings, and put their failure modes in a"
        " column."
    ),
}
"""What a distribution that fits better suggests."""
_WORTH: Final = 2.0
"""Difference of AICc from which on it says something (Burnham and Anderson 2002, section 2.6)."""
HYPOTHESES: Final[Mapping[str, str]] = {
    "common_shape": marked("equal shapes"),
    "same_life": marked("equal lives, at a common shape"),
    "homogeneous": marked("equal shapes and lives"),
}
_VERDICTS: Final[Mapping[str, str]] = {
    "": marked("no"),
    "longer": marked("yes: longer"),
    "shorter": marked("yes: shorter"),
}


def weibull_page(found: LifeTestSummary) -> doc.Document:
    """Return the page of a life test; times are in the unit of the data.

    Parameters
    ----------
    found
        Of `rolamento.weibull.summarise`.
    """
    title = one_line(found.test.title) or said("Life test")
    alone = len(found.groups) == 1
    level, notes = 2 if alone else 1, _notes(found)
    parts: list[doc.Section | doc.Beside] = [_head(found, title), *cautions_section(notes, level)]
    parts += _whole(found)
    for group in found.groups:
        parts += _parts_of_group(found, group, alone=alone)
    parts += _comparison(found)
    parts += _pictures(found)
    parts += notes_section(remarks_of(notes), level)
    return doc.Document(title, tuple(parts), "weibull")


def _head(found: LifeTestSummary, title: str) -> doc.Section:
    test, groups = found.test, found.groups
    facts = [_sizes(test)]
    if found.system is not None:
        facts.append(counted("{n} failure mode", "{n} failure modes", len(groups)))
    elif len(groups) > 1:
        facts.append(counted("{n} group", "{n} groups", len(groups)))
    elif groups[0].name:
        facts[0] = f"{one_line(groups[0].name)}: {facts[0]}"
    first, last = (written(brief(float(time), 6)) for time in _ends(test))
    facts.append(said("{first} to {last} {unit}", first=first, last=last, unit=test.unit))
    scheme = "" if len(groups) > 1 else said(SCHEMES[test.scheme])
    entries = (
        doc.Entry(said("data"), "; ".join(facts)),
        doc.Entry("", scheme),
        doc.Entry(said("source"), one_line(test.source)),
    )
    shown = tuple(entry for entry in entries if entry.content)
    return doc.Section(blocks=(doc.Title(title), doc.KeyValues(shown)), key="head")


def _sizes(test: LifeTest) -> str:
    """Say how many bearings there were, and what became of them."""
    facts = [counted("{n} bearing", "{n} bearings", test.size)]
    if not test.failures:
        return ", ".join([*facts, said("none failed")])
    facts.append(counted("{n} failed", "{n} failed", test.failures))
    if test.suspensions:
        facts.append(counted("{n} suspended", "{n} suspended", test.suspensions))
    return ", ".join(facts)


def _ends(test: LifeTest) -> tuple[float, float]:
    return float(np.min(test.times)), float(np.max(test.times))


def _sizes_of_mode(test: LifeTest) -> str:
    """Say how many bearings failed by a mode; the others may have failed by another."""
    return said("{failed} of {size} bearings failed by it", failed=test.failures, size=test.size)


def _parts_of_group(
    found: LifeTestSummary, group: GroupSummary, *, alone: bool
) -> list[doc.Section | doc.Beside]:
    """Say what one group or mode says: in sentences, then in tables."""
    name, wanted = one_line(group.name), found.request
    blocks: list[doc.Block] = list(_statements(group, wanted))
    heading = ""
    if found.system is not None:
        heading = f"{name}: {_sizes_of_mode(group.test)}"
    elif not alone:
        heading = f"{name}: {_sizes(group.test)}"
        blocks.insert(0, doc.Statement(said(SCHEMES[group.test.scheme]), "faint", indent=2))
    tables = [
        doc.Section(title if alone else f"{name}: {title}", (table,), table.key)
        for title, table in (
            *_table_of_fits(group),
            *_table_of_bounds(group),
            *_at_assumed_shapes(group, wanted),
            *_table_of_posterior(group, wanted),
            *_table_of_calculated(group, wanted),
            *_table_of_models(group),
        )
    ]
    parts: list[doc.Section | doc.Beside] = [doc.Section(heading, tuple(blocks), "group", 1)]
    if [table.key for table in tables[:2]] == ["fits", "bounds"]:
        parts.append(doc.Beside((tables[0],), (tables[1],), key="fits_and_bounds"))
        tables = tables[2:]
    return [*parts, *tables]


_Headed = tuple[tuple[str, doc.Table], ...]
"""A table with its heading, or none."""


# --- tables ----------------------------------------------------------------------------------


def _table_of_fits(group: GroupSummary) -> _Headed:
    """One line a method; nothing where no method has a result."""
    unit = one_line(group.test.unit)
    fits = [fit for fit in group.fits if fit.converged]
    if not fits:
        return ()
    tones: list[doc.Tone] = ["strong" if fit is group.main else "" for fit in fits]
    heads = {
        "shape": said("shape β"),
        "scale": said("scale η"),
        "l10": "L10",
        "l50": "L50",
        "mean": said("mean"),
    }
    columns = [
        doc.Column(head, alike([getattr(fit, name) for fit in fits]), name, tones=tones)
        for name, head in heads.items()
    ]
    names = doc.Column(said("method"), [said(FITS[f.method]) for f in fits], "method", tones=tones)
    legends = tuple(
        said(
            "failure-free time {location} {unit}; the scale is counted from there",
            location=written(brief(fit.location)),
            unit=unit,
        )
        for fit in fits
        if fit.location > 0.0
    )
    table = doc.Table((names, *columns), "fits", legends=legends)
    return ((said("Weibull fit (lives in {unit})", unit=unit), table),)


def _table_of_bounds(group: GroupSummary) -> _Headed:
    first, unit = group.bounds[0], group.test.unit
    if not group.bounded:
        return ()
    quantities = [Estimand.of(bound.quantity) for bound in group.bounds]
    rows, ratios = [], []
    for bound, quantity in zip(group.bounds, quantities, strict=True):
        of_share = quantity.kind == "reliability"
        rows.append(alike([bound.estimate, *_limits(bound)], share=of_share))
        known = not of_share and bound.lower > 0.0
        ratios.append(doc.Number(bound.ratio, ".3r") if known else None)
    columns = [_names(quantities, unit)]
    heads = {"estimate": said("estimate"), **_limit_heads(first)}
    columns += [
        doc.Column(head, column, key, align="right")
        for (key, head), column in zip(heads.items(), zip(*rows, strict=True), strict=True)
    ]
    if first.sides == "two":
        columns.append(doc.Column(said("ratio"), ratios, "ratio", align="right"))
    heading = _bounds_heading(first.sides, first.confidence)
    legend = _bounded_by(group)
    return ((heading, doc.Table(tuple(columns), "bounds", legends=(legend,))),)


def _bounds_heading(sides: Sides, confidence: float) -> str:
    """Say what kind of bounds they are."""
    if sides == "two":
        return said("{confidence} % bounds", confidence=percent(confidence))
    if sides == "lower":
        return said("{confidence} % lower bounds", confidence=percent(confidence))
    return said("{confidence} % upper bounds", confidence=percent(confidence))


def _bounded_by(group: GroupSummary) -> str:
    """Say how the bounds were found."""
    first = next(bound for bound in group.bounds if bound.converged)
    values = {
        "confidence": percent(first.confidence),
        "method": said(BOUND_METHODS[first.method]),
        "samples": first.samples,
        "seed": str(first.seed),
        "dropped": first.dropped,
    }
    if not first.samples:
        return said("{confidence} % bounds by {method}.", **values)
    if not first.dropped:
        return said(
            "{confidence} % bounds by {method}; {samples} simulated tests, seed {seed}.", **values
        )
    return said(
        "{confidence} % bounds by {method}; {samples} simulated tests, seed {seed}, of which"
        " {dropped} have no fit.",
        **values,
    )


def _limit_heads(bound: Bounds) -> dict[str, str]:
    if bound.sides == "two":
        return {"lower": said("from"), "upper": said("to")}
    if bound.sides == "lower":
        return {"lower": said("at least")}
    return {"upper": said("at most")}


def _limits(bound: Bounds) -> list[float]:
    return [getattr(bound, name) for name in _limit_heads(bound)]


def _at_assumed_shapes(group: GroupSummary, wanted: LifeTestRequest) -> _Headed:
    """One line a shape: bounds on every life and reliability."""
    if not group.assumed:
        return ()
    shapes = [doc.Number(assumed.shape, ".3") for assumed in group.assumed]
    columns = [doc.Column(said("shape β"), shapes, "shape", align="left")]
    for place, bound in enumerate(group.assumed[0].bounds):
        quantity = Estimand.of(bound.quantity)
        of_share = quantity.kind == "reliability"
        for name, head in _limit_heads(bound).items():
            limits = [getattr(assumed.bounds[place], name) for assumed in group.assumed]
            values: list[doc.CellContent] = [
                doc.Number(limit, ".4 [%]" if of_share else ".4", before=f"{head} ")
                if isfinite(limit)
                else f"{head} {written(brief(limit))}"
                for limit in limits
            ]
            columns.append(
                doc.Column(
                    "" if name == "upper" else _name_with_unit(quantity, group.test.unit),
                    values,
                    f"{bound.quantity}_{name}",
                    align="right",
                )
            )
    heading = said(
        "For an assumed shape ({bounds})", bounds=_bounds_heading(*wanted.bounds_of(group.test))
    )
    return ((heading, doc.Table(tuple(columns), "assumed_shapes")),)


def _table_of_models(group: GroupSummary) -> _Headed:
    """Other distributions beside Weibull's, the likeliest first."""
    models = [model for model in group.models if model.converged]
    if not models:
        return ()
    models.sort(key=lambda one: one.aicc if isfinite(one.aicc) else 1e300 - one.log_likelihood)
    unit = one_line(group.test.unit)
    columns = (
        doc.Column(said("distribution"), [said(MODELS[one.name]) for one in models], "model"),
        doc.Column(said("parameters"), [len(m.parameters) for m in models], "parameters"),
        doc.Column("ln ℓ", [m.log_likelihood for m in models], "log_likelihood", form=".2f"),
        doc.Column("AICc", [m.aicc for m in models], "aicc", form=".1f"),
        doc.Column(f"L10 {unit}", alike([m.l10 for m in models]), "l10"),
    )
    legends = (
        said(
            "ln ℓ: logarithm of the likelihood of the times; AICc: smaller is better, differences"
            " below 2 say little."
        ),
        *(_described(model, unit) for model in models if model.name in _TRY),
    )
    table = doc.Table(columns, "models", legends=legends)
    return ((said("Other distributions"), table),)


def _described(model: LifeModel, unit: str) -> str:
    """Name a distribution with its parameters."""
    p = {name: written(brief(value)) for name, value in model.parameters.items()}
    name = said(MODELS[model.name])
    if "share" in p:
        p["share"] = percent(round(model.parameters["share"], 4))
    if model.name == "lognormal":
        return said("{name}: median {median} {unit}, σ of ln t {sigma}", name=name, unit=unit,
                    median=written(brief(float(np.exp(model.parameters["mu"])))),
                    sigma=p["sigma"])  # fmt: skip
    first = said("β {shape}, η {scale} {unit}", shape=p["shape"], scale=p["scale"], unit=unit)
    if model.name == "three_parameter":
        return said("{name}: {first}, counted from {location} {unit}", name=name, first=first,
                    location=p["location"], unit=unit)  # fmt: skip
    if model.name == "limited_population":
        return said("{name}: {share} % can fail; {first}", name=name, share=p["share"], first=first)
    second = said("β {shape}, η {scale} {unit}", shape=p["shape_2"], scale=p["scale_2"], unit=unit)
    if model.name == "mixture":
        return said("{name}: {first} of {share} %; {second} of the others", name=name, first=first,
                    share=p["share"], second=second)  # fmt: skip
    return said("{name}: {first}; {second}", name=name, first=first, second=second)


# --- failure modes together ------------------------------------------------------------------


def _whole(found: LifeTestSummary) -> list[doc.Section | doc.Beside]:
    """Say what comes of all modes together; nothing where modes are not distinguished."""
    system, wanted = found.system, found.request
    if system is None:
        return []
    unit = one_line(found.test.unit)
    blocks: list[doc.Block] = []
    if system.advice is not None:
        text = said("All modes together: no result. {advice}", advice=system.advice.text)
        blocks.append(doc.Statement(text, indent=2, mark="✗", mark_tone="bad"))
    lives = [_life_sentence(bound, wanted, unit, said("All modes together:") + " ")
             for bound in system.bounds[:1] if bound.converged]  # fmt: skip
    blocks += _bullets([text for text in lives if text])
    sections: list[doc.Section | doc.Beside] = [
        doc.Section(said("Failure modes"), (*blocks, _table_of_modes(found)), "modes", 1)
    ]
    if system.bounds:
        sections.append(_table_of_system(found))
    return sections


def _table_of_modes(found: LifeTestSummary) -> doc.Table:
    system = found.system
    assert system is not None
    life, unit = found.request.lives[0], one_line(found.test.unit)
    bounds = [group.bound(life) for group in found.groups]
    heads = _limit_heads(bounds[0]) if bounds[0] is not None else {}
    fits = [one.fit for one in system.modes]
    limits = {
        key: alike([float("nan") if b is None else getattr(b, key) for b in bounds])
        for key in heads
    }
    tests = [group.goodness for group in found.groups]
    columns = [
        doc.Column(
            said("mode"), [shortened(one_line(one.name), 24) for one in system.modes], "mode"
        ),
        doc.Column(said("failures"), [fit.failures for fit in fits], "failures"),
        doc.Column(said("shape β"), alike([fit.shape for fit in fits]), "shape"),
        doc.Column(said("scale η"), alike([fit.scale for fit in fits]), "scale"),
        doc.Column(
            f"{life_name(life)} {unit}",
            alike([float(fit.life_at(life.value)) for fit in fits]),
            "life",
        ),
        *(doc.Column(head, limits[key], key, align="right") for key, head in heads.items()),
        doc.Column(
            said("fit p"), [_p_cell(one.p_value) for one in tests], "goodness_of_fit", align="right"
        ),
        doc.Column(
            said("hazard"),
            [one.hazard_share for one in system.modes],
            "hazard_share",
            "%",
            form=".1f [%]",
        ),
    ]
    legends = [
        said(
            "fit p: p-value of the goodness-of-fit test; hazard: share of the mode in the"
            " cumulative hazard up to the {life} of all modes together.",
            life=life_name(life),
        )
    ]
    legends += [
        said(
            "If the failures of unknown mode were all {mode}: β {shape}, {life} {value} {unit}.",
            mode=shortened(one_line(one.name), 24),
            shape=written(brief(one.earliest.shape)),
            life=life_name(life),
            value=written(brief(float(one.earliest.life_at(life.value)))),
            unit=unit,
        )
        for one in system.modes
        if one.earliest is not None and one.earliest.converged
    ]
    return doc.Table(tuple(columns), "modes", legends=tuple(legends))


def _table_of_system(found: LifeTestSummary) -> doc.Section:
    """Lives of the bearing as a whole, beside those of one distribution for all failures."""
    system = found.system
    assert system is not None
    bounds, unit, pooled = system.bounds, one_line(found.test.unit), system.pooled
    quantities = [Estimand.of(bound.quantity) for bound in bounds]
    heads = {"estimate": said("estimate"), **_limit_heads(bounds[0]), "pooled": said("pooled")}
    rows = []
    for bound, quantity in zip(bounds, quantities, strict=True):
        alone = float(quantity.at(np.array([pooled.shape]), np.log([pooled.scale]))[0])
        values = [bound.estimate, *_limits(bound), alone]
        rows.append(alike(values, share=quantity.kind == "reliability"))
    columns = (
        _names(quantities, unit),
        *(
            doc.Column(head, column, key, align="right")
            for (key, head), column in zip(heads.items(), zip(*rows, strict=True), strict=True)
        ),
    )
    legends = (
        said(
            "estimate: product of the reliabilities of the modes, ln ℓ {whole}; pooled: one Weibull"
            " distribution for all failures, β {shape}, ln ℓ {alone}.",
            whole=manner().fixed(system.log_likelihood, 2),
            shape=written(brief(pooled.shape)),
            alone=manner().fixed(pooled.log_likelihood, 2),
        ),
        *(note.text for note in system.goodness.contradictions(unit)),
    )
    heading = said(
        "All modes together ({bounds})",
        bounds=_bounds_heading(bounds[0].sides, bounds[0].confidence),
    )
    return doc.Section(heading, (doc.Table(columns, "system", legends=legends),), "system")


def _warning(text: str) -> doc.Statement:
    return doc.Statement(text, "warning", indent=2, mark="!", mark_tone="warning")


def _table_of_posterior(group: GroupSummary, wanted: LifeTestRequest) -> _Headed:
    prior = wanted.prior
    if not group.credible or prior is None:
        return ()
    low, high = manner().short(prior.low, 3), manner().short(prior.high, 3)
    heading = (
        said("With prior knowledge: shape uniform between {low} and {high}", low=low, high=high)
        if prior.kind == "uniform"
        else said(
            "With prior knowledge: shape lognormal, {low} to {high} with {probability} %"
            " probability",
            low=low,
            high=high,
            probability=percent(prior.probability),
        )
    )
    quantities = [Estimand.of(one.quantity) for one in group.credible]
    rows = [
        alike([one.median, one.lower, one.upper], share=quantity.kind == "reliability")
        for one, quantity in zip(group.credible, quantities, strict=True)
    ]
    heads = {"median": said("median"), "lower": said("from"), "upper": said("to")}
    columns = (
        _names(quantities, group.test.unit),
        *(
            doc.Column(head, column, key, align="right")
            for (key, head), column in zip(heads.items(), zip(*rows, strict=True), strict=True)
        ),
    )
    return ((heading, doc.Table(columns, "posterior")),)


def _table_of_calculated(group: GroupSummary, wanted: LifeTestRequest) -> _Headed:
    found = group.calculated
    if not any(one.code == "converged" for one in found.values()):
        return ()
    heads = {"ratio": said("observed/calculated"), "lower": said("from"), "upper": said("to")}
    columns = (
        doc.Column("", [shortened(one_line(name), _LONGEST_NAME) for name in found], "name"),
        doc.Column(
            shortened(one_line(group.test.unit), _LONGEST_UNIT),
            [brief(one.calculated) for one in found.values()],
            "calculated",
        ),
        *(
            doc.Column(head, [brief(getattr(one, key), 3) for one in found.values()], key)
            for key, head in heads.items()
        ),
        doc.Column("p", [_p_cell(one.p_value) for one in found.values()], "p_value"),
        doc.Column(
            said("contradicted"),
            [
                said(_VERDICTS[one.bearings_live]) if one.code == "converged" else ABSENT
                for one in found.values()
            ],
            "contradicted",
        ),
    )
    heading = said(
        "Comparison with calculated life ({quantity}, {confidence} %)",
        quantity=life_name(wanted.lives[0]),
        confidence=percent(wanted.confidence),
    )
    legend = said(
        "p: probability of a test result at least this far from the calculated life, if that life"
        " is true."
    )
    return ((heading, doc.Table(columns, "calculated", legends=(legend,))),)


# --- sentences -------------------------------------------------------------------------------


def _statements(group: GroupSummary, wanted: LifeTestRequest) -> list[doc.Statement]:
    """Say in sentences what one group says."""
    lines = [_warning(note.text) for note in group.goodness.contradictions(group.test.unit)]
    lines += [_warning(text) for text in _of_the_models(group)]
    advice = group.main.advice
    if not group.bounded and advice is not None:
        text = said("No result. {advice}", advice=advice.text)
        lines.append(doc.Statement(text, indent=2, mark="✗", mark_tone="bad"))
    sentences = _of_the_life(group, wanted)
    if wanted.shape is None:
        sentences += _of_the_shape(group)
    elif sentences:
        sentences.append(
            said("All results assume the given shape of {shape:.4}.", shape=wanted.shape)
        )
    return lines + _bullets([*sentences, *_of_the_calculation(group), *_of_the_fit(group)])


def _of_the_fit(group: GroupSummary) -> list[str]:
    """Sentence of the goodness of the fit, where the data do not contradict it."""
    found = group.goodness
    if not found.converged or found.contradicted:
        return []
    p = written(_p_cell(found.p_value))
    if found.method == "anderson_darling":
        return [
            said(
                "The data do not contradict a Weibull distribution (Anderson-Darling test by"
                " simulation, p = {p}).",
                p=p,
            )
        ]
    return [
        said(
            "The data do not contradict a Weibull distribution (likelihood-ratio test of the"
            " intervals by simulation, p = {p}).",
            p=p,
        )
    ]


def _of_the_models(group: GroupSummary) -> list[str]:
    """Sentence of a distribution that fits better, if the data contradict Weibull's."""
    known = {model.name: model for model in group.models if isfinite(model.aicc)}
    plain = known.get("weibull")
    if plain is None or not group.goodness.contradicted:
        return []
    best = min(known.values(), key=lambda one: one.aicc)
    if best.name not in _TRY or best.aicc > plain.aicc - _WORTH:
        return [said("No other distribution that was tried fits clearly better.")]
    values = {"share": "", "location": ""} | {
        name: written(brief(value, 3)) for name, value in best.parameters.items()
    }
    if "share" in best.parameters:
        values["share"] = percent(round(best.parameters["share"], 2))
    return [
        said(
            _TRY[best.name],
            name=said(MODELS[best.name]),
            share=values["share"],
            location=values["location"],
            unit=group.test.unit,
        )
    ]


def _bullets(sentences: Sequence[str]) -> list[doc.Statement]:
    return [doc.Statement(text, indent=2, mark="•", mark_tone="good") for text in sentences]


def _of_the_life(group: GroupSummary, wanted: LifeTestRequest) -> list[str]:
    """Sentence of the first life that is required."""
    bound = group.bound(wanted.lives[0])
    text = None
    if bound is not None and bound.converged:
        text = _life_sentence(bound, wanted, group.test.unit)
    return [text] if text else []


def _life_sentence(bound: Bounds, wanted: LifeTestRequest, unit: str, lead: str = "") -> str | None:
    """Say what is known of the first life; None where that is nothing."""
    life = wanted.lives[0]
    lower, upper = (written(one) for one in alike([bound.lower, bound.upper]))
    shown = {
        "confidence": percent(bound.one_sided_confidence),
        "share": percent(life.value),
        "lower": lower,
        "upper": upper,
        "unit": unit,
        "quantity": life_name(life),
    }
    if bound.sides == "upper":
        if not isfinite(bound.upper):
            return None
        return lead + said(
            "With {confidence} % confidence, at most {share} % of such bearings run longer than"
            " {upper} {unit}.",
            **shown,
        )
    if bound.lower <= 0.0:
        return None
    if bound.sides == "two" and isfinite(bound.upper):
        return lead + said(
            "With {confidence} % confidence, {share} % of such bearings reach {lower} {unit}."
            " {quantity} is known to within a factor of {factor}: {lower} to {upper} {unit}.",
            **shown,
            factor=written(doc.Number(bound.ratio, ".2r")),
        )
    return lead + said(
        "With {confidence} % confidence, {share} % of such bearings reach {lower} {unit}.", **shown
    )


def _of_the_shape(group: GroupSummary) -> list[str]:
    bound = group.bound(Estimand.of("shape"))
    if bound is None or not bound.converged or bound.sides != "two":
        return []
    if bound.upper < 1.0:
        of_one = said(
            "Shape below 1: the failure rate falls with time, as with early failures from"
            " manufacturing defects."
        )
    elif bound.lower > 1.0:
        of_one = said("Shape above 1: the failure rate rises with time, as with fatigue and wear.")
    else:
        of_one = said(
            "Shape 1 lies within the bounds: the data do not show whether the failure rate rises or"
            " falls with time."
        )
    if bound.contains(EXPONENTS["ball"]):
        return [of_one, said("10/9, the shape of the rating standards, lies within the bounds.")]
    return [of_one, said("10/9, the shape of the rating standards, lies outside the bounds.")]


def _of_the_calculation(group: GroupSummary) -> list[str]:
    judged = {name: one for name, one in group.calculated.items() if one.code == "converged"}
    names = {
        live: "; ".join(one_line(name) for name, one in judged.items() if one.bearings_live == live)
        for live in ("longer", "shorter")
    }
    sentences = []
    if names["longer"]:
        sentences.append(
            said("The data contradict {names}: the bearings last longer.", names=names["longer"])
        )
    if names["shorter"]:
        sentences.append(
            said("The data contradict {names}: the bearings fail sooner.", names=names["shorter"])
        )
    if judged and not sentences:
        sentences.append(
            said(
                "The data contradict none of the calculated lives given. That does not confirm"
                " them: few failures contradict little."
            )
        )
    return sentences


def _comparison(found: LifeTestSummary) -> list[doc.Section | doc.Beside]:
    """Show whether the groups differ, and by how much."""
    if not found.comparisons:
        return []
    judged = [one for one in found.comparisons if one.converged]
    sentences = _sentence_of_difference(judged, found.request.confidence)
    sentences += [_sentence_of_ratio(ratio) for ratio in found.ratios]
    blocks: list[doc.Block] = [*_bullets(sentences)]
    if judged:
        columns = (
            doc.Column("", [said(HYPOTHESES[o.hypothesis]) for o in judged], "hypothesis"),
            doc.Column("p", [_p_cell(o.p_value) for o in judged], "p_value", align="right"),
        )
        blocks.append(doc.Table(columns, "comparisons"))
    return [doc.Section(said("Comparison of the groups"), tuple(blocks), "comparison", 1)]


def _sentence_of_difference(judged: Sequence[Comparison], confidence: float) -> list[str]:
    """Sentence of the hypotheses that have a p-value, the first that is rejected; else the last."""
    if not judged:
        return []
    rejected = [one for one in judged if one.rejected(confidence)]
    one = rejected[0] if rejected else judged[-1]
    values = {"hypothesis": said(HYPOTHESES[one.hypothesis]), "p": written(_p_cell(one.p_value))}
    if rejected:
        return [said("The groups differ ({hypothesis}: p = {p}).", **values)]
    return [said("The groups do not differ significantly ({hypothesis}: p = {p}).", **values)]


def _sentence_of_ratio(ratio: LifeRatio) -> str:
    first, second = (one_line(name) for name in ratio.groups)
    names = {"quantity": life_name(Estimand.life(ratio.reliability)), "first": first,
             "second": second}  # fmt: skip
    if ratio.advice is not None:
        return said(
            "{quantity} of {first} over {second}: no result. {advice}",
            **names,
            advice=ratio.advice.text,
        )
    shown = alike([ratio.ratio, ratio.lower, ratio.upper], 3)
    numbers = {
        **dict(zip(("ratio", "lower", "upper"), map(written, shown), strict=True)),
        "confidence": percent(ratio.confidence),
        "p": written(_p_cell(ratio.p_value)),
    }
    if ratio.common_shape:
        return said(
            "{quantity} of {first} over {second}: {ratio} ({confidence} % bounds {lower} to"
            " {upper}, common shape {shape:.3}); equal lives: p = {p}.",
            **names,
            **numbers,
            shape=ratio.shape,
        )
    return said(
        "{quantity} of {first} over {second}: {ratio} ({confidence} % bounds {lower} to {upper},"
        " separate shapes); equal lives: p = {p}.",
        **names,
        **numbers,
    )


def _notes(found: LifeTestSummary) -> dict[Note, None]:
    """Return what limits the results, each once."""
    notes = dict.fromkeys((*found.notes, *found.test.notes))
    if found.system is not None:
        notes |= dict.fromkeys(found.system.notes)
    for group in found.groups:
        for one in (*group.fits, *group.bounds):
            notes |= dict.fromkeys(one.notes)
    for one in (*found.comparisons, *found.ratios):
        notes |= dict.fromkeys(one.notes)
    if found.test.inspected:
        notes[Note("inspected_without_ranks")] = None
        if len(found.groups) > 1 and found.system is None:
            notes[Note("inspected_groups_not_compared")] = None
    elif not all(group.ranked for group in found.groups):
        notes[Note("too_many_for_ranks")] = None
    return notes


# --- pictures --------------------------------------------------------------------------------


def _pictures(found: LifeTestSummary) -> list[doc.Section | doc.Beside]:
    """Weibull paper, and the regions of equal likelihood where there is a fit."""
    if not found.has_result:
        return []
    caption = said("Weibull probability plot: failures, fitted lines and their bounds")
    figures = [
        doc.Figure(caption, lambda: plots.weibull_figure(found, bands_of(found)), "weibull_paper")
    ]
    if any(group.main.converged and found.request.shape is None for group in found.groups):
        caption = said(
            "Shape and {quantity}: regions of equal likelihood",
            quantity=life_name(found.request.lives[0]),
        )
        figures.append(
            doc.Figure(
                caption,
                lambda: plots.contour_figure(found, regions_of(found, found.request.lives[0].name)),
                "likelihood_regions",
            )
        )
    return [doc.Section(blocks=tuple(figures), key="figures")]


# --- names and numbers -----------------------------------------------------------------------


def _p_cell(p: float) -> doc.Number | str:
    """Return a p-value; the smallest only as being small."""
    if isfinite(p) and p < _LEAST_P:
        return f"< {manner().short(_LEAST_P, 1)}"
    return doc.Number(p, ".2")


def _names(quantities: Sequence[Estimand], unit: str) -> doc.Column:
    return doc.Column("", [_name_with_unit(quantity, unit) for quantity in quantities], "quantity")


def _name_with_unit(quantity: Estimand, unit: str) -> str:
    """Write what a quantity is, with its unit."""
    if quantity.kind == "shape":
        return said("shape β")
    unit = shortened(one_line(unit), _LONGEST_SHOWN_UNIT)
    if quantity.kind == "reliability":
        return said("R({time} {unit}) %", time=manner().short(quantity.value, 6), unit=unit)
    if quantity.name == "scale":
        return said("scale η {unit}", unit=unit)
    return f"{life_name(quantity)} {unit}"
