"""Figures of studies: lines and maps over inputs varied in steps, histograms and scatter plots."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final, Literal, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from rolamento.charts import (
    Axis,
    Chart,
    Field,
    Line,
    Look,
    Mark,
    Spread,
    key,
    nothing,
    series_look,
    step_line,
)
from rolamento.charts.axes_units import NONE, PERCENT, ReadableUnit
from rolamento.charts.courses import extremes
from rolamento.charts.drawing import draw
from rolamento.charts.palette import SERIES
from rolamento.charts.texts import no_result, no_result_count, number
from rolamento.errors import InputError
from rolamento.numerics.percentiles import percentile
from rolamento.plots.curves import form_of
from rolamento.plots.study import (
    PlottedVariable,
    StudyData,
    axis_of,
    common_failure,
    first_reason,
    input_of,
    inputs,
    most_telling,
    output_of,
)
from rolamento.studies.study import SAMPLE, VARIANT
from rolamento.words import said

Floats = NDArray[np.float64]

MOST_LINES: Final = len(SERIES)
_BAND: Final = (5.0, 95.0)
_LOG_SPAN: Final = 10.0
_PERCENTS: Final = ((5.0, "dash"), (50.0, "solid"), (95.0, "dashdot"))
_COUNTED: Final = ("ball", "row")
_FEWEST_BINS: Final = 5
_MOST_BINS: Final = 60
_MISSING: Final = Look("grey", mark="thin", width=0.8)


def telling_kind(study: StudyData, variable: str = "") -> str:
    """Return how an output shows best: "lines", "map" or "histogram".

    Raises
    ------
    InputError
        If there is no such output.
    """
    column = output_of(study, variable or most_telling(study))
    if column.dims == (SAMPLE,):
        return "histogram"
    if set(column.dims) == {VARIANT, SAMPLE}:
        return "histogram"
    few = len(column.dims) != 2 or SAMPLE in column.dims or min(column.values.shape) <= MOST_LINES
    return "lines" if few else "map"


def study_lines(
    study: StudyData, variable: str = "", axes: Axes | None = None, *, over: str = ""
) -> Axes:
    """Draw an output over one axis of a study, as `lines_chart` has it."""
    return compared_lines({"": study}, variable, axes, over=over)


def compared_lines(
    studies: Mapping[str, StudyData],
    variable: str = "",
    axes: Axes | None = None,
    *,
    over: str = "",
) -> Axes:
    """Draw an output of several studies over one axis that they all have, as `lines_chart` has it.

    axes: to draw on; of a new figure if not given.
    """
    return draw(lines_chart(studies, variable, over), axes)


def lines_chart(studies: Mapping[str, StudyData], variable: str = "", over: str = "") -> Chart:
    """Return an output over one axis of studies; of further axes, a line for each of their values.

    Along samples, the median is drawn and a band from the 5th to the 95th percentile. A case
    without a result leaves a gap, with a cross below it. Variants, rows and balls are lines.

    Parameters
    ----------
    studies
        Datasets of `rolamento.studies` by what the legend is to call them; of a single one the
        name may be empty. Their grids may differ.
    variable
        Name of the output; the most specific one if not given.
    over
        The axis that runs across; if not given the longer one.

    Raises
    ------
    InputError
        If there is no such output or axis, there would be more lines than can be distinguished,
        or the studies do not fit: naming what differs.
    """
    tables = _fitting(studies, variable, over)
    several = len(tables) > 1
    if any(t.along == SAMPLE and (several or not t.others) for t in tables.values()):
        raise InputError(
            said("cannot show a study of samples alone"), field="kind", value="lines",
            example="histogram",
        )  # fmt: skip
    first, study = next(iter(tables.values())), next(iter(studies.values()))
    if not any(np.isfinite(table.values).any() for table in tables.values()):
        return nothing(why_nothing(study))
    lines = [line for label, table in tables.items() for line in _lines(label, table)]
    banded = any(line.values.ndim == 2 for line in lines)
    if len(lines) > MOST_LINES:
        raise InputError(
            said(
                "would draw {count} lines along {other}; more than {most} cannot be told apart",
                count=len(lines),
                other=", ".join(dict.fromkeys(dim for t in tables.values() for dim in t.others)),
                most=MOST_LINES,
            ),
            field="kind",
            value="lines",
            example="map" if len(first.others) == 1 and len(tables) == 1 else "study.isel(row=0)",
        )
    x = _joined([table.x for table in tables.values()])
    y = _joined([table.output for table in tables.values()])
    series: list[Line | Spread] = []
    for index, line in enumerate(lines):
        across, values = _shown(line.table.x, x), _shown(line.table.output, y, line.values)
        look, form = series_look(index), "both" if x.texts else form_of(len(values))
        if line.values.ndim == 1:
            series.append(Line(across, values, line.label, look, form))
            continue
        low, middle, high = (_percentile(values, one) for one in (_BAND[0], 50.0, _BAND[1]))
        band = said("{least} % to {most} %", least=_BAND[0], most=_BAND[1])
        before = f"{line.label}: " if line.label else ""
        series.append(Spread(across, low, high, before + band, look))
        series.append(Line(across, middle, before + said("median"), look, form))
    why = first_reason(*studies.values())
    for table in tables.values():
        missing = np.isnan(table.values)
        if missing.any():
            places = _shown(table.x, x)[missing.reshape(len(missing), -1).any(axis=1)]
            name = no_result_count(int(missing.sum()), missing.size, why)
            series.append(Line(places, np.zeros(len(places)), name, _MISSING, "points",
                               height=0.02))  # fmt: skip
    alone = len(tables) == 1 and len(first.others) == 1 and not banded
    over_names = _dim_label(study, first.others[0]) if alone else ""
    return Chart(tuple(series), _axis(x), y.axis, over_names=over_names)


def study_map(
    study: StudyData, variable: str = "", axes: Axes | None = None, *, over: str = ""
) -> Axes:
    """Draw an output over two axes of a study, as `map_chart` has it."""
    return draw(map_chart(study, variable, over), axes, height=100.0)


def map_chart(study: StudyData, variable: str = "", over: str = "") -> Chart:
    """Return an output over two axes of a study as a map of colours; no result is hatched.

    Parameters and errors as of `lines_chart`; `over` is the axis that runs across.
    """
    table = _table(study, variable, over)
    if len(table.others) != 1 or table.samples or table.along == SAMPLE:
        raise InputError(
            said("needs a study with two axes"), field="kind", value="map",
            example="histogram" if table.samples or table.along == SAMPLE else "lines",
        )  # fmt: skip
    if not np.isfinite(table.values).any():
        return nothing(why_nothing(study))
    x, y = table.x, axis_of(study, table.others[0], table.values.shape[1])
    order_x, order_y = np.argsort(x.values), np.argsort(y.values)
    missing = int(np.sum(np.isnan(table.values)))
    count = no_result_count(missing, table.values.size, first_reason(study)) if missing else ""
    colours = Field(
        _edges(x.values[order_x]), _edges(y.values[order_y]),
        table.values[np.ix_(order_x, order_y)].T, table.output.axis, missing=count,
    )  # fmt: skip
    return Chart((colours,), _axis(x, ends=True), _axis(y, ends=True))


def why_nothing(study: StudyData) -> str:
    """Say why there is nothing to draw: the reason that most cases give."""
    failure = common_failure(study)
    if not failure:
        return said("No case has this number")
    return ": ".join(filter(None, (no_result(failure), first_reason(study))))


class _Table(NamedTuple):
    """An output over the axis that runs across, and others.

    values: (along, …, samples if there are any); along: the axis; others: the ones that are
    neither that nor samples; x: what it is named by; labels: of each place along the others.
    """

    output: PlottedVariable
    values: Floats
    along: str
    others: tuple[str, ...]
    samples: bool
    x: PlottedVariable
    labels: tuple[tuple[str, ...], ...]


class _Lines(NamedTuple):
    """One line: (along,), or (along, samples) of one with a band."""

    label: str
    values: Floats
    table: _Table


def _fitting(studies: Mapping[str, StudyData], variable: str, over: str) -> dict[str, _Table]:
    """Return the tables of studies that have an output and an axis across in common."""
    first = next(iter(studies.values()))
    name = variable or most_telling(first)
    tables: dict[str, _Table] = {}
    for label, study in studies.items():
        across = over
        if tables and not over:
            across = next(iter(tables.values())).x.name
        try:
            tables[label] = _table(study, name, across)
        except InputError as error:
            raise error if not label else error.with_details(source=label) from None
    begun = next(iter(studies))
    for label, study in studies.items():
        one, other = tables[begun], tables[label]
        for what, pair in (
            (name, (first.data_vars[name], study.data_vars[name])),
            (one.x.name, (first.coords.get(one.x.name), study.coords.get(other.x.name))),
        ):
            units, others = (_meaning(one) for one in pair)
            if units != others:
                raise InputError(
                    said(
                        "is not the same in {one} ({meaning}) and {other} ({other_meaning}): they"
                        " share no figure",
                        one=begun,
                        meaning=", ".join(units),
                        other=label,
                        other_meaning=", ".join(others),
                    ),
                    field=what,
                )
    return tables


def _meaning(variable: Any) -> tuple[str, ...]:
    """What a variable holds: its field, if it is of one, and its unit."""
    attrs = {} if variable is None else variable.attrs
    return tuple(str(attrs[key]) for key in ("field", "units") if key in attrs)


def _table(study: StudyData, variable: str, over: str) -> _Table:
    output = output_of(study, variable or most_telling(study))
    dims = output.dims
    known = [dim for dim in dims if dim != SAMPLE]
    few = _few_lines(output, dims)
    if not dims or (len(known) > 2 and not few):
        raise InputError(
            said(
                "varies along {dims}; a figure shows one or two axes: select some values first",
                dims=", ".join(dims),
            )
            if dims
            else said("is of a single case; a figure shows one or two axes"),
            field=output.name,
            example="study.sel(fx=20e3), study.isel(ball=0)",
        )
    along = _axis_named(study, over, output) if over else _longest(study, output)
    others = tuple(dim for dim in known if dim != along)
    order = (along, *others, *([SAMPLE] if SAMPLE in dims and along != SAMPLE else []))
    values = np.transpose(output.values, [dims.index(dim) for dim in order])
    x = axis_of(study, over or along, len(values))
    labels = tuple(_labels(study, dim, output, alone=len(others) == 1) for dim in others)
    return _Table(output, values, along, others, order[-1] == SAMPLE != along, x, labels)


def _few_lines(output: PlottedVariable, dims: tuple[str, ...]) -> bool:
    """Whether what varies beside the longest axis makes few enough lines."""
    sizes = sorted(
        size for dim, size in zip(dims, output.values.shape, strict=True) if dim != SAMPLE
    )
    return int(np.prod(sizes[:-1])) <= MOST_LINES


def _labels(study: StudyData, dim: str, output: PlottedVariable, *, alone: bool) -> tuple[str, ...]:
    """Return what each value along an axis is called; with its axis where there are several."""
    size = output.values.shape[output.dims.index(dim)]
    family = axis_of(study, dim, size)
    values = [_value(family, index) for index in range(size)]
    if alone or family.texts:
        return tuple(values)
    if dim in _COUNTED:
        return tuple(f"{family.label.lower()} {value}" for value in values)
    return tuple(f"{family.axis.title}: {value}" for value in values)


def _lines(label: str, table: _Table) -> Iterator[_Lines]:
    """Cut a table into its lines, each with what it is called."""
    for place in np.ndindex(*(len(labels) for labels in table.labels)):
        own = (labels[index] for labels, index in zip(table.labels, place, strict=True))
        name = ", ".join(part for part in (label, *own) if part)
        yield _Lines(name, table.values[(slice(None), *place)], table)


def _dim_label(study: StudyData, dim: str) -> str:
    """Return what stands over the lines of an axis; variants need nothing."""
    return "" if dim == VARIANT else axis_of(study, dim, 1).axis.title


def _joined(columns: Sequence[PlottedVariable]) -> PlottedVariable:
    """Return one column of several that share an axis, in a unit that suits them all."""
    first = columns[0]
    texts = tuple(dict.fromkeys(text for column in columns for text in column.texts))
    units = [column.unit for column in columns]
    greatest = max(
        range(len(columns)),
        key=lambda i: np.nanmax(np.abs(columns[i].values / units[i].factor), initial=0.0),
    )
    unit = units[greatest]
    values = first.values
    if len(columns) > 1:
        own = (np.ravel(c.values) / c.unit.factor * unit.factor for c in columns)
        values = np.concatenate(list(own))
    return replace(first, values=values, label=columns[greatest].label, unit=unit, texts=texts)


def _shown(own: PlottedVariable, joined: PlottedVariable, values: Floats | None = None) -> Floats:
    """Return values of one column in the unit of all, texts at their common places."""
    given = own.values if values is None else values
    if own.texts:
        return np.array([float(joined.texts.index(own.texts[int(place)])) for place in given])
    return given if own.unit == joined.unit else given / own.unit.factor * joined.unit.factor


def _axis_named(study: StudyData, name: str, output: PlottedVariable) -> str:
    """Return the axis that is called so, or along which an input of that name varies."""
    axes = {dim: dim for dim in output.dims}
    axes.update({n: str(study.coords[n].dims[0]) for n in inputs(study)})
    if axes.get(name) not in output.dims:
        known = [n for n, axis in axes.items() if axis in output.dims]
        raise InputError(
            said(
                "is not an axis of {name}; it has {known}", name=output.name, known=", ".join(known)
            ),
            field="over",
            value=name,
        )
    return axes[name]


def _longest(study: StudyData, output: PlottedVariable) -> str:
    """Return the axis that best runs across: not samples, not balls, numbers, many of them."""

    def rank(dim: str) -> tuple[bool, bool, bool, int]:
        size = output.values.shape[output.dims.index(dim)]
        texts = axis_of(study, dim, size).texts
        return dim != SAMPLE, dim not in _COUNTED, not texts, size

    return max(output.dims, key=rank)


def _value(column: PlottedVariable, index: int) -> str:
    if column.texts:
        return column.texts[int(column.values[index])]
    return number(float(column.values[index]))


def _percentile(values: Floats, percent: float) -> Floats:
    """Return a percentile of each row's numbers; NaN for a row with too few."""
    return np.array([percentile(row, percent) for row in values])


def _axis(column: PlottedVariable, *, ends: bool = False) -> Axis:
    """Return the axis along which something runs; ends: whether it has the ends of the numbers."""
    if column.texts:
        ticks = tuple((float(i), one) for i, one in enumerate(column.texts))
        return replace(column.axis, ticks=ticks)
    low, high = float(column.values.min()), float(column.values.max())
    log = _in_ratios(column.values)
    whole = column.unit is NONE and np.array_equal(column.values, np.round(column.values))
    limits = (low, high) if ends and low < high else None
    return replace(column.axis, limits=limits, log=log, whole=whole and not log)


def _in_ratios(values: Floats) -> bool:
    """Return whether values grow by a steady ratio rather than by steady steps."""
    if len(values) < 4 or not (values > 0.0).all() or values.max() < _LOG_SPAN * values.min():
        return False
    ratios = np.diff(np.log(values))
    return bool(np.allclose(ratios, ratios[0], rtol=0.05))


def _edges(values: Floats) -> Floats:
    """Return where cells around values begin and end: halfway, or at the mean ratio."""
    if _in_ratios(values):
        return np.asarray(np.exp(_edges(np.log(values))), dtype=np.float64)
    middle = 0.5 * (values[1:] + values[:-1])
    first, last = 1.5 * values[0] - 0.5 * values[1], 1.5 * values[-1] - 0.5 * values[-2]
    edges: Floats = np.concatenate([[first], middle, [last]])
    return edges


def study_histogram(study: StudyData, variable: str = "", axes: Axes | None = None) -> Axes:
    """Draw how an output is distributed over the samples, as `histogram_chart` has it."""
    return compared_histograms({"": study}, variable, axes)


def compared_histograms(
    studies: Mapping[str, StudyData], variable: str = "", axes: Axes | None = None
) -> Axes:
    """Draw how an output of several studies is distributed, as `histogram_chart` has it."""
    return draw(histogram_chart(studies, variable), axes)


def histogram_chart(studies: Mapping[str, StudyData], variable: str = "") -> Chart:
    """Return how an output is distributed over the samples of studies, or of variants.

    Parameters
    ----------
    studies
        Datasets by what the legend is to call them; of a single one the name may be empty.
    variable
        Name of the output; the most specific one if not given.

    Returns
    -------
    Chart
        Shares are of the samples that have a result; of one distribution with its percentiles.

    Raises
    ------
    InputError
        If there is no such output, it does not vary along samples alone, or there are more than
        can be distinguished.
    """
    first = next(iter(studies.values()))
    name = variable or most_telling(first)
    columns = {
        label: column
        for own, study in studies.items()
        for label, column in _samples_by_label(own, study, name)
    }
    if len(columns) > MOST_LINES:
        raise InputError(
            said(
                "would draw {count} distributions; more than {most} cannot be told apart",
                count=len(columns),
                most=MOST_LINES,
            ),
            field="kind",
            value="histogram",
        )
    output = _joined(list(columns.values()))
    shown = {label: _shown(column, output) for label, column in columns.items()}
    values = np.concatenate(list(shown.values()))
    found = values[np.isfinite(values)]
    if not found.size:
        return nothing(why_nothing(first))
    fewest = min(int(np.isfinite(own).sum()) for own in shown.values()) or 1
    bins = int(np.clip(np.ceil(2.0 * fewest ** (1.0 / 3.0)), _FEWEST_BINS, _MOST_BINS))
    edges = np.histogram_bin_edges(found, bins)
    alone, marks = len(shown) == 1, []
    series: list[Line] = []
    for index, (label, own) in enumerate(shown.items()):
        there = own[np.isfinite(own)]
        shares = PERCENT.of(np.histogram(there, edges)[0] / max(there.size, 1))
        if alone:
            marks = percentile_marks(there, output.unit, "x")
        middle = number(percentile(there, 50.0), 5) if there.size else no_result()
        median = said("median {value} {unit}", value=middle, unit=output.unit.symbol)
        name = "" if alone else f"{label}: {median}".removesuffix(f" {NONE.symbol}")
        series.append(Line(*step_line(edges, shares), name, series_look(index), filled=alone))
    series += _missing(values, first_reason(*studies.values()))
    return Chart(
        tuple(series),
        output.axis,
        Axis(said("Share of the samples"), PERCENT.symbol, zero=True),
        marks[1].name if len(marks) > 1 else "; ".join(one.name for one in series if one.name),
        marks=tuple(marks),
    )


def _samples_by_label(
    label: str, study: StudyData, name: str
) -> Iterator[tuple[str, PlottedVariable]]:
    """Return an output over the samples; of variants each by its name."""
    output = output_of(study, name)
    if set(output.dims) != {VARIANT, SAMPLE}:
        yield label, _along_samples(study, name, "histogram")
        return
    place = output.dims.index(VARIANT)
    for index, own in enumerate(_labels(study, VARIANT, output, alone=True)):
        called = ", ".join(part for part in (label, own) if part)
        values = np.take(output.values, index, axis=place)
        yield called, replace(output, dims=(SAMPLE,), values=values)


def study_scatter(
    study: StudyData, variable: str = "", axes: Axes | None = None, *, over: str = ""
) -> Axes:
    """Draw an output of every sample over an input, as `scatter_chart` has it."""
    return draw(scatter_chart(study, variable, over), axes)


def scatter_chart(study: StudyData, variable: str = "", over: str = "") -> Chart:
    """Return an output of every sample over an input, with median and percentiles of the output.

    Parameters and errors as of `histogram_chart`; `over` names an input, or another output; the
    first input if not given.
    """
    output = _along_samples(study, variable, "scatter")
    across = input_of(study, over or _first_input(study))
    if across.dims != (SAMPLE,):
        raise InputError(said("does not vary along the samples"), field="over", value=across.name)
    values = output.values[np.isfinite(output.values)]
    if not values.size:
        return nothing(why_nothing(study))
    look = Look(series_look(0).color, width=0.5, opacity=0.5)
    marks = percentile_marks(values, output.unit, "y")
    return Chart(
        (Line(across.values, output.values, "", look, "points"),
         *_missing(output.values, first_reason(study))),
        replace(_axis(across), log=False, whole=False),
        output.axis,
        marks[1].name if len(marks) > 1 else extremes(
            [("", across.values, output.values)], across.axis, output.axis
        ),
        marks=tuple(marks),
    )  # fmt: skip


def _along_samples(study: StudyData, variable: str, kind: str) -> PlottedVariable:
    output = output_of(study, variable or most_telling(study))
    if output.dims != (SAMPLE,):
        raise InputError(
            said(
                "needs an output that varies along the samples alone; {name} varies along {dims}",
                name=output.name,
                dims=", ".join(output.dims) or "–",
            ),
            field="kind",
            value=kind,
            example="lines",
        )
    return output


def _first_input(study: StudyData) -> str:
    """Return the first input that was drawn at random."""
    along = (name for name in inputs(study) if tuple(study.coords[name].dims) == (SAMPLE,))
    name = next((name for name in along if name != SAMPLE), "")
    if not name:
        raise InputError(said("is missing: the study names no input"), field="over")
    return name


def percentile_marks(values: Floats, unit: ReadableUnit, axis: Literal["x", "y"]) -> list[Mark]:
    """Return the 5th, 50th and 95th percentile; none beyond so few samples."""
    marks = []
    for percent, dash in _PERCENTS:
        value = percentile(values, percent)
        if np.isnan(value):
            continue
        name = said("median") if percent == 50.0 else f"{percent:.0f} %"
        label = f"{name}: {number(value, 5)} {unit.symbol}".removesuffix(f" {NONE.symbol}")
        marks.append(Mark(value, label, Look("ink", dash, width=0.8), axis))
    return marks


def _missing(values: Floats, why: str) -> list[Line]:
    """Say in the legend how many samples have no result, and why the first has none."""
    missing = int(np.isnan(values).sum())
    name = no_result_count(missing, values.size, why)
    return [key(name, _MISSING, "points")] if missing else []
