"""Axes of a study: a list of values, a range, or several fields that vary together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Final, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    ValidationInfo,
    model_serializer,
    model_validator,
)

from rolamento.case.former import current
from rolamento.case.quantity import AT_THE_BORDER, Count, Line
from rolamento.case.record import Record
from rolamento.errors import ABSENT, InputError
from rolamento.studies import fields
from rolamento.words import said

__all__ = ["MOST_VALUES", "Axis", "Column", "DimensionName", "FieldName"]

MOST_VALUES: Final = 1_000_000
"""Maximum number of values of one axis."""

Column = NDArray[np.float64] | tuple[fields.Value, ...]
"""What a field takes along an axis: SI floats of a continuous field, else values as in a file."""


def _as_list(values: object) -> object:
    """Take arrays as lists."""
    return values.tolist() if isinstance(values, np.ndarray) else values


def _checked_name(name: str) -> str:
    plain = name.replace(" ", "").replace("_", "").replace("-", "").replace(".", "")
    if name and not (plain.isalnum() and plain.isascii() and name[0].isalpha() and name[-1] != " "):
        raise InputError(
            said(
                "must be letters, digits, spaces, points, hyphens and underscores, "
                "beginning with a letter"
            ),
            value=name,
        )
    return name


FieldName = Annotated[
    str, Field(strict=True, max_length=200), AfterValidator(lambda name: current(name))
]
DimensionName = Annotated[Line, AfterValidator(_checked_name), Field(max_length=60)]
_Values = Annotated[tuple[Any, ...], BeforeValidator(_as_list), Field(max_length=MOST_VALUES)]


class Axis(Record):
    """One dimension of a study: a field and its values, or several fields that vary together.

    Give `field` with `values`, or with `first`, `last` and `count`, or `zipped`.

    Parameters
    ----------
    name
        Of the dimension; by default that of the field.
    field
        Dotted name of a field of the case; of a machine, as ``--set`` of ``rolamento shaft`` has
        it: ``"loads.0.fz"``.
    values
        As in a case file: quantities with units; in Python also SI floats.
    first, last
        Ends of a range, both included.
    count
        Values in the range.
    spacing
        Of the range: ``"linear"`` or ``"log"``.
    zipped
        Values by field, all of one length: case by case, the fields take their values together.

    Raises
    ------
    InputError
        If a field is not known, it does not take a value, or the axis is not one of the three.
    """

    name: DimensionName = Field("", examples=["load case"])
    field: FieldName | None = Field(None, examples=["duty.load.fx"])
    values: _Values | None = Field(None, min_length=1, examples=['["1 kN", "2 kN"]'])
    first: Any = Field(None, examples=["1 kN"])
    last: Any = Field(None, examples=["45 kN"])
    count: Annotated[int, Count] | None = Field(
        None, strict=True, ge=1, le=MOST_VALUES, examples=[45]
    )
    spacing: Literal["linear", "log"] = Field("linear", examples=["log"])
    zipped: dict[FieldName, _Values] | None = Field(None, min_length=1, max_length=50)

    @property
    def fields(self) -> tuple[str, ...]:
        """The fields that vary along the axis."""
        return tuple(self.zipped or ()) if self.field is None else (self.field,)

    @property
    def size(self) -> int:
        """Number of values."""
        if self.zipped is not None:
            return len(next(iter(self.zipped.values())))
        return self.count or 1 if self.values is None else len(self.values)

    def columns(self) -> dict[str, Column]:
        """Return the values by field; quantities in SI units."""
        if self.values is None and self.field is not None:
            return {self.field: self._range(in_file=False)}
        lists = self.zipped if self.field is None else {self.field: self.values}
        return {
            name: _column(name, values or (), in_file=False)
            for name, values in (lists or {}).items()
        }

    def given(self, name: str) -> tuple[Any, ...]:
        """Return what was written for a field: its values, or the ends of its range."""
        if self.zipped is not None:
            return self.zipped[name]
        return (self.first, self.last) if self.values is None else self.values

    @model_validator(mode="after")
    def _one_kind(self, info: ValidationInfo) -> Self:
        in_file = info.context == AT_THE_BORDER
        if (self.field is None) == (self.zipped is None):
            raise InputError(
                said("must be given; alternatively, zip several fields"),
                field="field",
                value=ABSENT if self.field is None else self.field,
                example='field = "duty.load.fx"',
            )
        if self.zipped is not None:
            self._check_zipped(self.zipped, in_file)
        elif self.values is not None:
            rule = said("cannot be combined with values, of which a range has none")
            self._refuse(("first", "last", "count"), rule)
            _column(self.field or "", self.values, in_file=in_file, at="values")
        else:
            self._check_range(in_file)
        return self

    def _check_zipped(self, zipped: Mapping[str, tuple[Any, ...]], in_file: bool) -> None:
        rule = said("is given beside zipped, which has lists")
        self._refuse(("values", "first", "last", "count"), rule)
        fields.refuse_rivals(tuple(zipped), at="zipped")
        size = len(next(iter(zipped.values())))
        for name, values in zipped.items():
            fields.read_varied(name, at="zipped")
            if len(values) != size or not values:
                raise InputError(
                    said(
                        "must have as many values as the first field, {size}, and at least one",
                        size=size,
                    ),
                    field=f"zipped.{name}",
                    value=values,
                )
            _column(name, values, in_file=in_file, at=f"zipped.{name}")

    def _check_range(self, in_file: bool) -> None:
        for name in ("first", "last", "count"):
            if getattr(self, name) is None:
                raise InputError(
                    said("is missing: give values, or first, last and count"),
                    field=name,
                    example='first = "1 kN", last = "45 kN", count = 45',
                )
        self._range(in_file=in_file)

    def _refuse(self, names: tuple[str, ...], rule: str) -> None:
        for name in names:
            if getattr(self, name) is not None:
                raise InputError(rule, field=name)

    def _range(self, *, in_file: bool) -> Column:
        """The values of the range; its ends are exact."""
        field = fields.read_varied(self.field or "")
        count = self.count or 1
        first, last = (
            _checked(field, getattr(self, name), in_file=in_file, at=name)
            for name in ("first", "last")
        )
        if isinstance(first, bool | str) or isinstance(last, bool | str):
            raise InputError(
                said("{rule}; give values", rule=fields.no_range(field.name)),
                field="field",
                value=field.name,
            )
        if count == 1 and first != last:
            raise InputError(said("must be at least 2 for a range"), field="count", value=count)
        if self.spacing == "log" and not first * last > 0.0:
            raise InputError(
                said("must not be zero or change sign in a range with logarithmic spacing"),
                field="first",
                value=self.first,
            )
        space = np.geomspace if self.spacing == "log" else np.linspace
        values = space(first, last, count).astype(np.float64)
        if field.continuous:
            return values
        whole = np.rint(values)
        if not (np.abs(values - whole) < 1e-9 * np.maximum(np.abs(whole), 1.0)).all():
            raise InputError(
                said("does not give integers; give values"), field="count", value=count
            )
        return tuple(int(value) for value in whole)

    @model_serializer(mode="wrap")
    def _with_units(self, handler: SerializerFunctionWrapHandler, info: SerializationInfo) -> Any:
        """Write quantities with units where a person reads, and leave out what says nothing."""
        table: dict[str, Any] = handler(self)
        if info.context != AT_THE_BORDER:
            return table
        kept = {key: value for key, value in table.items() if value not in (None, "", "linear")}
        if self.field is not None:
            field = fields.read_varied(self.field)
            for key in {"first", "last"} & kept.keys():
                kept[key] = _text_of(field, kept[key])
            if "values" in kept:
                kept["values"] = [_text_of(field, value) for value in kept["values"]]
        else:
            kept["zipped"] = {
                name: [_text_of(fields.read_varied(name), value) for value in values]
                for name, values in kept["zipped"].items()
            }
        return kept


def _text_of(field: fields.Field, given: object) -> fields.Value:
    if isinstance(given, str):
        return given
    return field.written(field.checked(given, in_file=False))


def _column(name: str, values: tuple[Any, ...], *, in_file: bool, at: str = "") -> Column:
    """Return the checked values of a field."""
    field = fields.read_varied(name)
    checked = tuple(_checked(field, value, in_file=in_file, at=at) for value in values)
    return np.array(checked, dtype=np.float64) if field.continuous else checked


def _checked(field: fields.Field, value: object, *, in_file: bool, at: str) -> fields.Value:
    try:
        return field.checked(value, in_file=in_file)
    except InputError as error:
        raise error.with_details(field=at or None) from None
