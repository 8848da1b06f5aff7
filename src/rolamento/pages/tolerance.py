"""The page of a tolerance study: percentiles of every output, and the inputs that move it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isclose
from typing import Any, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.case.labels import label_of
from rolamento.charts import Axis, Chart, Line, Look, Mark, Spread, nothing
from rolamento.charts.axes_units import PERCENT, ReadableUnit, readable_unit
from rolamento.charts.texts import capitalised
from rolamento.errors import InputError
from rolamento.pages.given import picture
from rolamento.pages.life import LONGEST_LIFE, hours_text
from rolamento.pages.study import in_row
from rolamento.studies.outputs import catalogue
from rolamento.studies.sensitivity import RankCorrelations, SobolIndices, ToleranceStudy
from rolamento.studies.tolerance import Samples, ToleranceBand, histogram, varies
from rolamento.words import ABSENT, UNITS, manner, said
from rolamento.words.reasons import reason

__all__ = ["MOST_POINTS", "distribution_chart", "tolerance_page", "tolerance_summary"]

MOST_POINTS: Final = 20
"""Points of a study's axes that a page has room for; JSON takes any number."""

_SHOWN: Final = (5.0, 50.0, 95.0)
_HOURS: Final = "life_hours"
_MOVES: Final = 0.3
"""Rank correlation from which on an input is said to move an output."""
_MOST_INPUTS: Final = 6


def tolerance_page(study: ToleranceStudy) -> doc.Document:
    """Return the page of a tolerance study.

    Parameters
    ----------
    study
        Shown are 5, 50 and 95 % where the bands have them, else all percentiles.

    Raises
    ------
    InputError
        If the study's axes have more points than a page has room for.
    """
    points = list(np.ndindex(study.bands.without_result.shape))
    if len(points) > MOST_POINTS:
        raise InputError(
            said(
                "make {count} points, and a page has room for {most}; JSON holds them all",
                count=len(points),
                most=MOST_POINTS,
            ),
            field="axes",
            example="--json FILE",
        )
    title = study.title or said("Tolerance study")
    sections = [doc.Section(blocks=(doc.Title(title), _head(study)), key="head")]
    for number, place in enumerate(points):
        suffix = f"_{number + 1}" if place else ""
        if place:
            sections.append(
                doc.Section(blocks=(doc.Statement(_point(study.samples, place), "strong"),))
            )
        sections.append(_bands(study, place, suffix))
        if study.ranks is not None:
            sections.append(_ranks(study, study.ranks, place, suffix))
    if study.sobol is not None:
        sections.append(_sobol(study.sobol))
    if study.ranks is not None and not any(points):
        caption = said("Distributions of the outputs, and the inputs that move them")
        sections.append(picture(caption, lambda: plots.tolerance_figure(study), "tolerance", ""))
    return doc.Document(title, tuple(sections), "tolerance")


def tolerance_summary(study: ToleranceStudy) -> doc.Section:
    """Return what the outputs of a scattered case come to, one a row, and what moves each most.

    study: without axes beside its samples.
    """
    known, rows, units = catalogue(), [], []
    bands = study.bands.bands
    for band in bands:
        values = [float(value) for value in band.percentile]
        unit = readable_unit(band.units, values, band.name)
        cells = _row(values, unit)
        if band.name == _HOURS:
            pairs = zip(values, cells, strict=True)
            cells = [hours_text(own) if own > LONGEST_LIFE else cell for own, cell in pairs]
        rows.append(cells)
        units.append("" if unit.symbol == "–" else unit.symbol)
    heads = [f"{manner().short(percent, 6)} %" for percent in study.bands.percentiles]
    columns = (
        doc.Column(head="", key="output", values=[known[band.name].label for band in bands]),
        *(
            doc.Column(head=head, key=f"percentile_{place}", values=values, align="right")
            for place, (head, values) in enumerate(
                zip(heads, zip(*rows, strict=True), strict=True)
            )
        ),
        doc.Column(head="", key="unit", values=units, align="left"),
        doc.Column(head=said("moved most by"), key="moved",
               values=[_moved(study, band) for band in bands], align="left"),
    )  # fmt: skip
    failed = int(study.bands.without_result.sum())
    blocks = [doc.Statement(_result(study, failed), "bad")] if failed else []
    return doc.Section("", (*blocks, doc.Table(columns=columns, key="percentiles")), "percentiles")


def _moved(study: ToleranceStudy, band: ToleranceBand) -> str:
    """Name the input that an output depends on most, and which way; "–" of one that rests."""
    ranks = study.ranks
    values = study.samples.values(band.name)
    there = values[np.isfinite(values)]
    if ranks is None or not there.size or not varies(there, band.units):
        return ABSENT
    order = ranks.ranking(band.name)
    if not order:
        return ABSENT
    own, strength = study.samples.inputs[order[0]], float(ranks.telling(band.name)[0][order[0]])
    if abs(strength) < _MOVES:
        return said("nothing alone")
    name = label_of(own.field)
    if strength > 0.0:
        return said("{input}, rises with it", input=name)
    return said("{input}, falls with it", input=name)


def distribution_chart(study: ToleranceStudy, name: str) -> Chart:
    """Return how an output of a scattered case is distributed, and its percentiles.

    Parameters
    ----------
    study
        Without axes beside its samples.
    name
        Of the output.
    """
    band, values = study.bands[name], study.samples.values(name)
    there = values[np.isfinite(values)]
    label = catalogue()[name].label
    if not there.size:
        return nothing(said("no sample has a result"))
    unit = readable_unit(band.units, there, name)
    if name == _HOURS and np.percentile(there, _SHOWN[0]) > LONGEST_LIFE:
        return nothing(
            said("more than {hours} h: fatigue does not end the life", hours=int(LONGEST_LIFE))
        )
    texts = [
        hours_text(value) + " h"
        if name == _HOURS
        else f"{manner().short(float(unit.of(value)), 4)} {unit.symbol}".removesuffix(" –")
        for value in band.percentile.tolist()
    ]
    if not varies(there, band.units):
        return nothing(said("does not vary: {value}", value=texts[len(texts) // 2]))
    shares, edges = histogram(np.asarray(unit.of(there)))
    x = np.repeat(edges, 2)
    heights = np.r_[0.0, np.repeat(PERCENT.factor * shares, 2), 0.0]
    named = zip(study.bands.percentiles, band.percentile, texts, strict=True)
    marks = tuple(
        Mark(float(unit.of(value)), f"{manner().short(percent, 6)} %: {text}",
             Look("ink", "dash" if percent == 50.0 else "dot"), "x")
        for percent, value, text in named
        if np.isfinite(value)
    )  # fmt: skip
    told = said(
        "{output}: {low} to {high} in nine of ten cases, {middle} in the middle.",
        output=capitalised(label), low=texts[0], middle=texts[1], high=texts[2],
    )  # fmt: skip
    spread = Spread(x, np.zeros_like(x), heights, capitalised(said("cases")), Look("inner"))
    outline = Line(x, heights, "", Look("inner"))
    return Chart(
        (spread, outline),
        Axis(capitalised(label), unit.symbol),
        Axis(said("Share of the samples"), PERCENT.symbol, zero=True),
        told,
        marks=marks,
    )


def _head(study: ToleranceStudy) -> doc.KeyValues:
    counted = said(
        "{samples} samples of {inputs} inputs",
        samples=len(study.samples),
        inputs=len(study.samples.inputs),
    )
    failed = int(study.bands.without_result.sum())
    return doc.KeyValues(
        (
            doc.Entry(said("study"), counted),
            doc.Entry(said("result"), _result(study, failed), "bad-strong" if failed else "good"),
        )
    )


def _result(study: ToleranceStudy, failed: int) -> str:
    if not failed:
        return said("✓ all samples have a result")
    count = study.bands.samples * study.bands.without_result.size
    reasons = ", ".join(
        f"{reason(code)} {manner().fixed(number, 0)}"
        for code, number in study.bands.failures.items()
    )
    return said(
        "✗ {failed} of {count} samples have no result ({share:.2 %}): {reasons}",
        failed=failed,
        count=count,
        share=failed / count,
        reasons=reasons,
    )


def _point(samples: Samples, place: tuple[int, ...]) -> str:
    """Name a point of the axes: what each takes there."""
    parts = []
    for axis, index in zip(samples.axes, place, strict=True):
        coordinate = samples.coordinates.get(axis)
        if coordinate is None:
            parts.append(f"{axis} {index + 1}")
            continue
        value = coordinate.values[index]
        if not np.issubdtype(np.asarray(value).dtype, np.number):
            parts.append(f"{axis} = {value}")
            continue
        unit = readable_unit(str(coordinate.attrs.get("units", "")), coordinate.values, str(axis))
        written = manner().short(float(unit.of(value)))
        parts.append(f"{axis} = {written} {unit.symbol}".removesuffix(" –"))
    return ", ".join(parts)


def _at(band: ToleranceBand, study: ToleranceStudy, place: tuple[int, ...]) -> Iterator[Any]:
    """Places in an output's arrays that belong to a point of the axes: one for each ball, say."""
    known = dict(zip(study.samples.axes, place, strict=True))
    sizes = dict(zip(band.axes, band.count.shape, strict=True))
    further = [axis for axis in band.axes if axis not in known]
    for inside in np.ndindex(*(sizes[axis] for axis in further)):
        chosen = {**known, **dict(zip(further, inside, strict=True))}
        label = "".join(f" [{axis} {index}]" for axis, index in zip(further, inside, strict=True))
        yield tuple(chosen[axis] for axis in band.axes), label


def _bands(study: ToleranceStudy, place: tuple[int, ...], suffix: str) -> doc.Section:
    percentiles = study.bands.percentiles
    shown = [i for i, value in enumerate(percentiles) if value in _SHOWN]
    shown = shown if len(shown) == len(_SHOWN) else list(range(len(percentiles)))
    names, rows, units = [], [], []
    for band in study.bands.bands:
        for inside, label in _at(band, study, place):
            values = [float(band.percentile[(i, *inside)]) for i in shown]
            deviation = float(band.standard_deviation[inside])
            unit = readable_unit(band.units, band.percentile[(slice(None), *inside)], band.name)
            names.append(f"{band.name}{label}")
            rows.append(_row([*values, deviation], unit))
            units.append("" if unit.symbol == "–" else unit.symbol)
    heads = {f"percentile_{i}": f"{manner().short(percentiles[i], 6)} %" for i in shown}
    heads["standard_deviation"] = said("std. dev.")
    columns = (
        doc.Column("", names, "output"),
        *(
            doc.Column(head, values, key, align="right")
            for (key, head), values in zip(heads.items(), zip(*rows, strict=True), strict=True)
        ),
        doc.Column("", units, "unit", align="left"),
    )
    table = doc.Table(columns, f"percentiles{suffix}")
    return doc.Section(said("Percentiles of the outputs"), (table,), f"percentiles{suffix}")


def _row(values: Sequence[float], unit: ReadableUnit) -> list[doc.CellContent]:
    """Return one output's numbers with the same decimals."""
    factor, offset = UNITS.get(unit.symbol, (0.0, 0.0))
    if isclose(factor, unit.factor, rel_tol=1e-12) and not offset:
        return in_row(values, unit.symbol)
    return in_row(unit.of(values).tolist())


def _ranks(
    study: ToleranceStudy, ranks: RankCorrelations, place: tuple[int, ...], suffix: str
) -> doc.Section:
    groups: list[tuple[int, str]] = []
    rows: list[tuple[doc.CellContent, ...]] = []
    for band in study.bands.bands:
        for inside, label in _at(band, study, place):
            groups.append((len(rows), f"{band.name}{label}"))
            values, low, high = (
                array[(slice(None), *inside)] for array in ranks.telling(band.name)
            )
            order = ranks.ranking(band.name, inside)[:_MOST_INPUTS]
            rows += [
                (f"  {ranks.inputs[i]}", float(values[i]), float(low[i]), float(high[i]),
                 abs(float(values[i])))
                for i in order
            ]  # fmt: skip
            if not order:
                rows.append((said("  does not vary"), None, None, None, None))
    confidence = manner().short(100.0 * ranks.confidence)
    heading = (
        said(
            "Partial rank correlation (the inputs are correlated), {confidence} % interval",
            confidence=confidence,
        )
        if ranks.correlated
        else said("Rank correlation, {confidence} % interval", confidence=confidence)
    )
    inputs, numbers, lows, highs, bars = zip(*rows, strict=True)
    columns = (
        doc.Column("", inputs, "input"),
        doc.Column("", numbers, "correlation", form=".2f", tone="strong"),
        doc.Column(said("from"), lows, "low", form=".2f", tone="faint"),
        doc.Column(said("to"), highs, "high", form=".2f", tone="faint"),
        doc.Column("", bars, "bar", bar=True),
    )
    key = f"rank_correlation{suffix}"
    return doc.Section(heading, (doc.Table(columns, key, groups=tuple(groups)),), key)


def _sobol(found: SobolIndices) -> doc.Section:
    heading = said(
        "Sobol indices from {runs} runs, {confidence} % interval",
        runs=found.runs,
        confidence=manner().short(100.0 * found.confidence),
    )
    names = _leaves(found.inputs)
    arrays = (
        found.first_order, found.first_low, found.first_high,
        found.total, found.total_low, found.total_high,
    )  # fmt: skip
    groups: list[tuple[int, str]] = []
    rows: list[tuple[doc.CellContent, ...]] = []
    for row, output in enumerate(found.outputs):
        groups.append((len(rows), output))
        totals = found.total[row]
        if np.isnan(totals).all():
            rows.append((said("  does not vary"), *[None] * (len(arrays) + 1)))
            continue
        for index in np.argsort(-totals, kind="stable")[:_MOST_INPUTS].tolist():
            numbers = [float(array[row, index]) for array in arrays]
            rows.append((f"  {names[index]}", *numbers, max(numbers[3], 0.0)))
    heads = {
        "first_order": said("first-order"),
        "first_low": said("from"),
        "first_high": said("to"),
        "total": said("total"),
        "total_low": said("from"),
        "total_high": said("to"),
    }
    inputs, *numbers_, bars = zip(*rows, strict=True)
    columns = (
        doc.Column("", inputs, "input"),
        *(
            doc.Column(
                head,
                values,
                key,
                form=".2f",
                tone="strong" if key in ("first_order", "total") else "faint",
            )
            for (key, head), values in zip(heads.items(), numbers_, strict=True)
        ),
        doc.Column("", bars, "bar", bar=True),
    )
    table = doc.Table(columns, "sobol", groups=tuple(groups))
    return doc.Section(heading, (table,), "sobol")


def _leaves(names: Sequence[str]) -> list[str]:
    """Return the last part of dotted names, where that is one name alone."""
    leaves = [name.rpartition(".")[2] for name in names]
    return [
        leaf if leaves.count(leaf) == 1 else name for leaf, name in zip(leaves, names, strict=True)
    ]
