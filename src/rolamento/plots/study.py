"""What figures read of a study: variables with names, units and axes, failed cases left out.

A study is an xarray Dataset, or whatever has its `data_vars`, `coords` and `attrs`; xarray itself
is not needed here.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from math import prod
from types import MappingProxyType
from typing import Any, Final, Protocol

import numpy as np
from numpy.typing import NDArray

from rolamento.charts import Axis
from rolamento.charts.axes_units import CELSIUS, NONE, ReadableUnit, readable_unit
from rolamento.charts.texts import capitalised, shown_text
from rolamento.errors import InputError, nearest
from rolamento.records import frozen
from rolamento.studies.names import setting_name, variable_name
from rolamento.studies.study import SAMPLE, VARIANT
from rolamento.units import ZERO_CELSIUS
from rolamento.words import said

Floats = NDArray[np.float64]


_STATUS: Final = "status"
_REASON, _REASON_TEXT = "reason", "reason_text"
_CONVERGED: Final = "converged"
_TELLING: Final = (
    "max_inner_max_pressure",
    "max_outer_max_pressure",
    "life_hours",
    "max_inner_load",
    "stiffness_zz",
    "stiffness_xx",
    "x",
)
"""What a study is asked for first, if it has it."""
_MOST_VALUES: Final = 4_000_000
_LISTED: Final = 8


class Variable(Protocol):
    """An array with named axes."""

    @property
    def dims(self) -> tuple[Hashable, ...]:
        """Names of the axes."""
        ...

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths of the axes."""
        ...

    @property
    def dtype(self) -> Any:
        """Type of the values."""
        ...

    @property
    def values(self) -> Any:
        """The numbers, SI."""
        ...

    @property
    def attrs(self) -> Mapping[Any, Any]:
        """units, long_name and others."""
        ...


class StudyData(Protocol):
    """What is read of a Dataset."""

    @property
    def data_vars(self) -> Mapping[Any, Any]:
        """Outputs by name."""
        ...

    @property
    def coords(self) -> Mapping[Any, Any]:
        """Inputs by name."""
        ...

    @property
    def attrs(self) -> Mapping[Any, Any]:
        """title, case."""
        ...


@frozen(eq=False)
class PlottedVariable:
    """One variable, ready to be drawn.

    Attributes
    ----------
    name
        in the study
    dims
        names of its axes, those of one value left out
    values
        in the unit shown; NaN where there is no result; positions, if there are texts
    label
        what it is called
    unit
        that is shown
    texts
        of an input that takes words instead of numbers
    """

    name: str
    dims: tuple[str, ...]
    values: Floats
    label: str
    unit: ReadableUnit
    texts: tuple[str, ...] = ()

    @property
    def axis(self) -> Axis:
        """The axis that it runs along, without limits."""
        return Axis(self.label, self.unit.symbol)


def outputs(study: StudyData) -> list[str]:
    """Return the names of the outputs that are numbers."""
    names = [str(name) for name in study.data_vars if str(name) not in (_STATUS, _REASON)]
    return [name for name in names if _numeric(study.data_vars[name])]


def most_telling(study: StudyData) -> str:
    """Return the output to show when none is asked for.

    Raises
    ------
    InputError
        If the study has no output.
    """
    known = outputs(study)
    if not known:
        raise InputError(said("has no output that can be drawn"), field="data")
    return next((name for name in _TELLING if name in known), known[0])


def output_of(study: StudyData, name: str) -> PlottedVariable:
    """Return an output, NaN where the status says that there is no result.

    Raises
    ------
    InputError
        If there is no such output, or it is too large to be drawn.
    """
    if name not in outputs(study):
        raise _unknown("variable", name, outputs(study))
    variable = study.data_vars[name]
    if (size := prod(variable.shape)) > _MOST_VALUES:
        raise InputError(said("is too large for a figure: {size} values", size=size), field=name)
    if not size:
        raise InputError(said("has no values"), field=name)
    values = np.array(variable.values, dtype=np.float64)
    values = np.where(_failed(study, variable) | ~np.isfinite(values), np.nan, values)
    kept = [size != 1 for size in values.shape]
    dims = tuple(str(dim) for dim, keep in zip(variable.dims, kept, strict=True) if keep)
    return _plotted(name, dims, np.squeeze(values), variable)


def axis_of(study: StudyData, name: str, size: int) -> PlottedVariable:
    """Return the values along an axis; numbers from 0 where the study does not say.

    An axis along which several inputs vary together is named after the first of them.
    """
    along = [n for n in inputs(study) if n == name or str(study.coords[n].dims[0]) == name]
    coordinate = study.coords[name if name in along else along[0]] if along else None
    if coordinate is None:
        return PlottedVariable(name, (name,), np.arange(float(size)), variable_label(name), NONE)
    column = _input(name if name in along else along[0], coordinate)
    if not np.isfinite(column.values).all():
        raise InputError(said("contains something that is not a number"), field=name)
    return column


def input_of(study: StudyData, name: str) -> PlottedVariable:
    """Return a varied input, or an output, of a study of samples.

    Raises
    ------
    InputError
        If there is no such variable along the samples.
    """
    known = [n for n in inputs(study) if n != SAMPLE]
    if name in known:
        return _input(name, study.coords[name])
    if name not in outputs(study):
        raise _unknown("over", name, [*known, *outputs(study)])
    return output_of(study, name)


def inputs(study: StudyData) -> list[str]:
    """Return the names of the inputs that vary along one axis."""
    named = {str(name): coordinate for name, coordinate in study.coords.items()}
    return [
        name
        for name, coordinate in named.items()
        if len(coordinate.dims) == 1 and name != _REASON_TEXT
    ]


def has_result(study: StudyData, name: str) -> bool:
    """Return whether an output has a value in any case."""
    variable = study.data_vars[name]
    return bool(np.any(np.isfinite(variable.values) & ~_failed(study, variable)))


def common_failure(study: StudyData) -> str:
    """Return the code of the status that most cases without a result have; nothing if unknown."""
    status = study.data_vars.get(_STATUS)
    if status is None:
        return ""
    flags = np.asarray(status.values)
    known = {code: int(np.sum(flags == flag)) for code, flag in _flags(status).items()}
    known.pop(_CONVERGED, None)
    worst = max(known, key=lambda code: known[code], default="")
    return worst if known.get(worst) else ""


def first_reason(*studies: StudyData) -> str:
    """Return why the first case without a result has none, on one line; nothing if unknown."""
    for study in studies:
        if _REASON in study.data_vars and _REASON_TEXT in study.coords:
            numbers = np.asarray(study.data_vars[_REASON].values)
            known = numbers[numbers >= 0]
            if len(known):
                return shown_text(str(study.coords[_REASON_TEXT].values[known[0]]))
    return ""


def _input(name: str, coordinate: Variable) -> PlottedVariable:
    dims = tuple(str(dim) for dim in coordinate.dims)
    values = np.asarray(coordinate.values)
    if _numeric(coordinate):
        return _plotted(name, dims, values.astype(np.float64), coordinate)
    called = setting_name if name == VARIANT else str
    texts, places = _positions([called(str(value))[:60] for value in values.tolist()])
    label = variable_label(name, coordinate.attrs)
    return PlottedVariable(name, dims, places, label, NONE, texts)


def _positions(texts: Sequence[str]) -> tuple[tuple[str, ...], Floats]:
    """Return the different texts, and for each value the place of its text among them."""
    different = tuple(dict.fromkeys(texts))
    place = {text: float(index) for index, text in enumerate(different)}
    return different, np.array([place[text] for text in texts])


def _plotted(
    name: str, dims: tuple[str, ...], values: Floats, variable: Variable
) -> PlottedVariable:
    unit = readable_unit(str(variable.attrs.get("units", "1")), values, name)
    if unit.symbol == "K" and "given_in" in variable.attrs:  # in a scale that people read
        values, unit = np.round(values - ZERO_CELSIUS, 9), CELSIUS
    label = variable_label(name, variable.attrs)
    return PlottedVariable(name, dims, unit.of(values), label, unit)


def variable_label(name: str, attrs: Mapping[Any, Any] = MappingProxyType({})) -> str:
    """Return what a variable is called: as we know it, else as its file does."""
    known = variable_name(name, str(attrs.get("field", "")))
    return capitalised(known or str(attrs.get("long_name", "")) or name.replace("_", " "))


def _numeric(variable: Variable) -> bool:
    return bool(variable.dtype.kind in "fiu")


def _failed(study: StudyData, variable: Variable) -> NDArray[np.bool_]:
    """Return where a case has no result, along the axes of a variable."""
    dims = [str(dim) for dim in variable.dims]
    nowhere = np.zeros((1,) * len(dims), dtype=np.bool_)
    status = study.data_vars.get(_STATUS)
    if status is None:
        return nowhere
    axes = [str(dim) for dim in status.dims]
    known = _flags(status)
    if not set(axes) <= set(dims) or _CONVERGED not in known:
        return nowhere
    order = [axes.index(dim) for dim in dims if dim in axes]
    failed = np.transpose(np.asarray(status.values) != known[_CONVERGED], order)
    apart = tuple(place for place, dim in enumerate(dims) if dim not in axes)
    return np.expand_dims(failed, apart)


def _flags(status: Variable) -> dict[str, Any]:
    """Return what the numbers of a status mean, as the CF conventions have it."""
    meanings = str(status.attrs.get("flag_meanings", "")).split()
    return dict(zip(meanings, np.ravel(status.attrs.get("flag_values", ())), strict=False))


def _unknown(field: str, name: str, known: Sequence[str]) -> InputError:
    near = nearest(name, known)
    listed = ", ".join(known[:_LISTED]) + (" …" if len(known) > _LISTED else "")
    if near:
        rule = said("is not in the study; did you mean {near}?", near=near)
    elif known:
        rule = said("is not in the study; known: {known}", known=listed)
    else:
        rule = said("is not in the study")
    return InputError(rule, field=field, value=name)
