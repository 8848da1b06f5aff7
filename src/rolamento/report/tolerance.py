"""Tolerance bands for a reader: percentiles of every output, and the inputs that move it; JSON."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from rich.text import Text

from rolamento._json import dumps
from rolamento.document.medium import Medium
from rolamento.errors import InputError
from rolamento.plots.axes_units import ReadableUnit, readable_unit
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, rendered
from rolamento.studies.sensitivity import RankCorrelations, SobolIndices, ToleranceStudy
from rolamento.studies.tolerance import Samples, ToleranceBand

__all__ = ["MOST_POINTS", "ToleranceStudy", "tolerance_json", "tolerance_report"]

SCHEMA: Final = 1
MOST_POINTS: Final = 20
"""Points of a study's axes that a page has room for; JSON takes any number."""

_SHOWN: Final = (5.0, 50.0, 95.0)
_MOST_INPUTS: Final = 6
_BAR: Final = 18


@dataclass(frozen=True, slots=True)
class _Words:
    untitled: str
    study: str
    counted: str
    result: str
    all_solved: str
    some_failed: str
    bands: str
    deviation: str
    rank: str
    partial: str
    no_variation: str
    sobol: str
    first: str
    total: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        untitled="Tolerance study",
        study="study",
        counted="{samples} samples of {inputs} inputs",
        result="result",
        all_solved="every sample has a result",
        some_failed="{failed} of {count} samples have no result ({share} %): {reasons}",
        bands="Percentiles of the outputs",
        deviation="std. dev.",
        rank="Rank correlation, {confidence} % interval",
        partial="Partial rank correlation (the inputs are correlated), {confidence} % interval",
        no_variation="does not vary",
        sobol="Sobol's indices from {runs} runs, {confidence} % interval",
        first="by itself",
        total="in all",
    ),
    "pt": _Words(
        untitled="Estudo de tolerâncias",
        study="estudo",
        counted="{samples} amostras de {inputs} entradas",
        result="resultado",
        all_solved="todas as amostras têm resultado",
        some_failed="{failed} de {count} amostras não têm resultado ({share} %): {reasons}",
        bands="Percentis das saídas",
        deviation="desvio p.",
        rank="Correlação de postos, intervalo de {confidence} %",
        partial=(
            "Correlação parcial de postos (as entradas são correlacionadas),"
            " intervalo de {confidence} %"
        ),
        no_variation="não varia",
        sobol="Índices de Sobol de {runs} rodadas, intervalo de {confidence} %",
        first="sozinha",
        total="ao todo",
    ),
}


def tolerance_report(
    study: ToleranceStudy, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the report of a tolerance study as text that ends in a newline.

    Parameters
    ----------
    study
        Shown are 5, 50 and 95 % where the bands have them, else all percentiles.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.

    Raises
    ------
    InputError
        If the study's axes have more points than a page has room for.
    """
    page, said = Page(words, medium or Medium()), _WORDS.get(words.code, _WORDS["en"])
    points = list(np.ndindex(study.bands.without_result.shape))
    if len(points) > MOST_POINTS:
        raise InputError(
            f"make {len(points)} points, and a page has room for {MOST_POINTS};"
            " JSON holds them all",
            field="axes",
            example="--json FILE",
        )
    parts = [_head(page, said, study)]
    for place in points:
        if place:
            parts.append(_point(page, study.samples, place))
        parts.append(_bands(page, said, study, place))
        if study.ranks is not None:
            parts.append(_ranks(page, said, study, study.ranks, place))
    if study.sobol is not None:
        parts.append(_sobol(page, said, study.sobol))
    return rendered(page.medium, parts)


def _head(page: Page, said: _Words, study: ToleranceStudy) -> Lines:
    counted = said.counted.format(
        samples=page.digits.fixed(len(study.samples), 0), inputs=len(study.samples.inputs)
    )
    failed = int(study.bands.without_result.sum())
    entries = [
        (said.study, counted, ""),
        (said.result, _result(page, said, study), "bold red" if failed else "green"),
    ]
    return [*page.title(study.title or said.untitled), *page.labelled(entries)]


def _result(page: Page, said: _Words, study: ToleranceStudy) -> str:
    failed = int(study.bands.without_result.sum())
    if not failed:
        return f"✓ {said.all_solved}"
    count = study.bands.samples * study.bands.without_result.size
    reasons = ", ".join(
        f"{page.words.reasons.get(code, code)} {number}"
        for code, number in study.bands.failures.items()
    )
    text = said.some_failed.format(
        failed=page.digits.fixed(failed, 0),
        count=page.digits.fixed(count, 0),
        share=page.digits.short(100.0 * failed / count, 2),
        reasons=reasons,
    )
    return f"✗ {text}"


def _point(page: Page, samples: Samples, place: tuple[int, ...]) -> Lines:
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
        unit = readable_unit(str(coordinate.attrs.get("units", "")), coordinate.values)
        written = page.digits.short(float(unit.of(value)))
        parts.append(f"{axis} = {written} {unit.symbol}".removesuffix(" –"))
    return [page.text(", ".join(parts), "bold")]


def _at(band: ToleranceBand, study: ToleranceStudy, place: tuple[int, ...]) -> Iterator[Any]:
    """Places in an output's arrays that belong to a point of the axes: one for each ball, say."""
    known = dict(zip(study.samples.axes, place, strict=True))
    sizes = dict(zip(band.axes, band.count.shape, strict=True))
    further = [axis for axis in band.axes if axis not in known]
    for inside in np.ndindex(*(sizes[axis] for axis in further)):
        chosen = {**known, **dict(zip(further, inside, strict=True))}
        label = "".join(f" [{axis} {index}]" for axis, index in zip(further, inside, strict=True))
        yield tuple(chosen[axis] for axis in band.axes), label


def _bands(page: Page, said: _Words, study: ToleranceStudy, place: tuple[int, ...]) -> Lines:
    percentiles = study.bands.percentiles
    shown = [i for i, value in enumerate(percentiles) if value in _SHOWN]
    shown = shown if len(shown) == len(_SHOWN) else list(range(len(percentiles)))
    heads = [f"{page.digits.short(percentiles[i], 6)} %" for i in shown]
    rows = [[page.text(text, "dim") for text in ("", *heads, said.deviation, "")]]
    for band in study.bands.bands:
        for inside, label in _at(band, study, place):
            values = [float(band.percentile[(i, *inside)]) for i in shown]
            deviation = float(band.standard_deviation[inside])
            unit = readable_unit(band.units, band.percentile[(slice(None), *inside)])
            rows.append(
                [
                    page.text(f"{band.name}{label}"),
                    *_numbers(page, unit, [*values, deviation]),
                    page.text("" if unit.symbol == "–" else unit.symbol),
                ]
            )
    return [page.heading(said.bands), *page.columns(rows, "l" + "r" * (len(shown) + 1) + "l")]


def _numbers(page: Page, unit: ReadableUnit, values: list[float]) -> list[Text]:
    """Write one output's numbers with the same decimals."""
    return [page.text(text) for text in page.digits.column(unit.of(values).tolist(), digits=5)]


def _ranks(
    page: Page,
    said: _Words,
    study: ToleranceStudy,
    ranks: RankCorrelations,
    place: tuple[int, ...],
) -> Lines:
    template = said.partial if ranks.correlated else said.rank
    rows: list[list[Text]] = []
    for band in study.bands.bands:
        for inside, label in _at(band, study, place):
            rows.append([page.text(f"{band.name}{label}"), *(Text() for _ in range(4))])
            rows += _inputs_of(page, said, ranks, band.name, inside)
    heading = template.format(confidence=page.digits.short(100.0 * ranks.confidence))
    return [page.heading(heading), *page.columns(rows, "lrlll")]


def _inputs_of(
    page: Page, said: _Words, ranks: RankCorrelations, output: str, inside: tuple[int, ...]
) -> list[list[Text]]:
    order = ranks.ranking(output, inside)[:_MOST_INPUTS]
    if not order:
        return [[page.text(f"  {said.no_variation}", "dim"), *(Text() for _ in range(4))]]
    rows = []
    for index in order:
        value, low, high = (float(a[(index, *inside)]) for a in ranks.telling(output))
        rows.append(
            [
                page.text(f"  {ranks.inputs[index]}"),
                page.text(page.digits.fixed(value, 2), "bold"),
                page.text(_interval(page, low, high), "dim"),
                page.text(_bar(page, abs(value)), "cyan" if value >= 0.0 else "yellow"),
                Text(),
            ]
        )
    return rows


def _interval(page: Page, low: float, high: float) -> str:
    return f"{page.digits.fixed(low, 2)} … {page.digits.fixed(high, 2)}"


def _bar(page: Page, share: float) -> str:
    """Draw a part of one as a bar."""
    length = round(_BAR * min(max(share, 0.0), 1.0))
    return ("█" if page.medium.draws else "#") * length


def _sobol(page: Page, said: _Words, found: SobolIndices) -> Lines:
    heading = said.sobol.format(
        runs=page.digits.fixed(found.runs, 0),
        confidence=page.digits.short(100.0 * found.confidence),
    )
    heads = ("", said.first, "", said.total, "", "")
    rows = [[page.text(text, "dim") for text in heads]]
    names = _leaves(found.inputs)
    for row, output in enumerate(found.outputs):
        rows.append([page.text(output), *(Text() for _ in heads[1:])])
        totals = found.total[row]
        if np.isnan(totals).all():
            empty = [Text() for _ in heads[1:]]
            rows.append([page.text(f"  {said.no_variation}", "dim"), *empty])
            continue
        order = np.argsort(-totals, kind="stable")[:_MOST_INPUTS]
        rows += [_indices(page, found, (row, index), names[index]) for index in order.tolist()]
    return [page.heading(heading), *page.columns(rows, "lrlrll")]


def _indices(page: Page, found: SobolIndices, place: tuple[int, int], name: str) -> list[Text]:
    def share(values: Any, low: Any, high: Any) -> list[Text]:
        interval = _interval(page, float(low[place]), float(high[place]))
        number = page.digits.fixed(float(values[place]), 2)
        return [page.text(number, "bold"), page.text(interval, "dim")]

    return [
        page.text(f"  {name}"),
        *share(found.first_order, found.first_low, found.first_high),
        *share(found.total, found.total_low, found.total_high),
        page.text(_bar(page, float(found.total[place])), "cyan"),
    ]


def _leaves(names: Sequence[str]) -> list[str]:
    """Return the last part of dotted names, where that is one name alone."""
    leaves = [name.rpartition(".")[2] for name in names]
    return [
        leaf if leaves.count(leaf) == 1 else name for leaf, name in zip(leaves, names, strict=True)
    ]


# --- JSON -------------------------------------------------------------------------------------


def tolerance_json(study: ToleranceStudy) -> str:
    """Return everything as one JSON object in SI units, ``null`` for what does not exist."""
    bands = study.bands
    mapping: dict[str, Any] = {
        "schema": SCHEMA,
        "kind": "tolerance",
        "title": study.title,
        "samples": bands.samples,
        "without_result": bands.without_result,
        "failures": dict(bands.failures),
        "axes": {name: _coordinate(study.samples, name) for name in study.samples.axes},
        "inputs": {
            one.name: {"field": one.field, "units": one.units} for one in study.samples.inputs
        },
        "confidence": bands.confidence,
        "percentiles": bands.percentiles,
        "outputs": {band.name: _band_mapping(band) for band in bands.bands},
    }
    if study.ranks is not None:
        mapping["rank_correlation"] = _rank_mapping(study.ranks)
    if study.sobol is not None:
        names = ("first_order", "first_low", "first_high", "total", "total_low", "total_high")
        sobol = study.sobol
        mapping["sobol"] = {
            "inputs": sobol.inputs,
            "outputs": sobol.outputs,
            "samples": sobol.samples,
            "runs": sobol.runs,
            "confidence": sobol.confidence,
            **{name: getattr(sobol, name) for name in names},
        }
    return dumps(mapping)


def _coordinate(samples: Samples, name: str) -> Any:
    coordinate = samples.coordinates.get(name)
    return None if coordinate is None else np.asarray(coordinate.values)


def _band_mapping(band: ToleranceBand) -> dict[str, Any]:
    return {
        "long_name": band.long_name,
        "units": band.units,
        "axes": band.axes,
        "count": band.count,
        "mean": band.mean,
        "standard_deviation": band.standard_deviation,
        "percentile": band.percentile,
        "low": band.low,
        "high": band.high,
    }


def _rank_mapping(ranks: RankCorrelations) -> dict[str, Any]:
    names = ("coefficient", "low", "high", "partial", "partial_low", "partial_high")
    return {
        "inputs": ranks.inputs,
        "among_inputs": ranks.among_inputs,
        "correlated": ranks.correlated,
        "confidence": ranks.confidence,
        "outputs": {
            one.output: {name: getattr(one, name) for name in names} for one in ranks.outputs
        },
    }
