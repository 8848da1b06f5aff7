"""Field types of what the user gives: quantities, ratios, counts, names.

A quantity is an SI float inside. In Python it is given as that float, or as text with
a unit. In a file it must be text with a unit: pydantic's validation context says
which of the two is being read.
"""

from __future__ import annotations

import math
import numbers
import operator
import unicodedata
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ValidationInfo,
)
from pydantic_core import CoreSchema, core_schema

from rolamento.errors import InputError, UnitError
from rolamento.records import frozen
from rolamento.units import SI_UNIT, Dimension, from_si, name_of, to_si
from rolamento.words import marked, said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["AT_THE_BORDER", "Count", "Line", "Quantity", "Ratio", "Replaces", "at_the_border"]

AT_THE_BORDER: Final = {"border": True}
"""The context in which values cross between text and SI: a file is read or written."""

Relation = Literal["above", "at_least", "below", "at_most"]

_RELATIONS: Final[dict[Relation, Callable[[Any, float], Any]]] = {
    "above": operator.gt,
    "at_least": operator.ge,
    "below": operator.lt,
    "at_most": operator.le,
}
_LIMITS: Final[dict[tuple[Relation, ...], str]] = {
    ("above",): marked("greater than {above}"),
    ("at_least",): marked("at least {at_least}"),
    ("below",): marked("less than {below}"),
    ("at_most",): marked("at most {at_most}"),
    ("above", "below"): marked("greater than {above} and less than {below}"),
    ("above", "at_most"): marked("greater than {above} and at most {at_most}"),
    ("at_least", "below"): marked("at least {at_least} and less than {below}"),
    ("at_least", "at_most"): marked("at least {at_least} and at most {at_most}"),
}
_JSON_SCHEMA: Final[dict[Relation, str]] = {
    "above": "exclusiveMinimum",
    "at_least": "minimum",
    "below": "exclusiveMaximum",
    "at_most": "maximum",
}
Bounds = dict[Relation, tuple[float, str]]
"""Limits by their relation, in SI units and as they are written."""


def at_the_border(context: object) -> bool:
    """Return whether a pydantic context is that of a file being read or written."""
    return context == AT_THE_BORDER


def _checked_bounds(value: float, given: object, bounds: Bounds) -> float:
    """Return the value, with no negative zero, or name the bounds that it breaks."""
    if not math.isfinite(value):
        raise InputError(said("must be a finite number"), value=given)
    if any(not _RELATIONS[relation](value, limit) for relation, (limit, _) in bounds.items()):
        raise InputError(said("must be {limits}", limits=limits_of(bounds)), value=given)
    return value + 0.0


def limits_of(bounds: Bounds) -> str:
    """Return bounds in words; empty if there are none."""
    texts = {relation: text for relation, (_, text) in bounds.items()}
    return said(_LIMITS[tuple(bounds)], **texts) if texts else ""


def _number_schema(bounds: Bounds) -> dict[str, Any]:
    limits = {_JSON_SCHEMA[relation]: limit for relation, (limit, _) in bounds.items()}
    return {"type": "number", **limits}


def _number(value: object) -> float:
    """Return a real number as a float; text and booleans are not numbers."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise InputError(said("must be a number"), value=value)
    try:
        return float(value)
    except OverflowError:
        raise InputError(said("must be a finite number"), value=value) from None


@frozen
class Quantity:
    """Annotation of a float field that has a dimension; limits are text with a unit.

    varies: whether many cases that are solved together may differ in it.
    """

    dimension: Dimension
    above: str = ""
    at_least: str = ""
    below: str = ""
    at_most: str = ""
    varies: bool = False

    @property
    def limits(self) -> str:
        """The bounds in words; empty if there are none."""
        return limits_of(_bounds(self))

    @property
    def limits_in_si(self) -> dict[Relation, float]:
        """The bounds as numbers."""
        return {relation: limit for relation, (limit, _) in _bounds(self).items()}

    def allows(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return which of the SI values are finite and within the bounds."""
        return _within(values, _bounds(self))

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Have pydantic read and write the field with this object."""
        return core_schema.with_info_plain_validator_function(
            self._validated,
            serialization=core_schema.plain_serializer_function_ser_schema(
                self._serialised, info_arg=True
            ),
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Text with a unit, as in files, or a number in the SI unit, as in Python."""
        number = {**_number_schema(_bounds(self)), "unit": SI_UNIT[self.dimension]}
        text = {"type": "string", "dimension": self.dimension, "limits": self.limits}
        return number if handler.mode == "serialization" else {"anyOf": [text, number]}

    def _validated(self, value: object, info: ValidationInfo) -> float:
        if isinstance(value, str):
            return _checked_bounds(to_si(value, self.dimension), value, _bounds(self))
        number = _number(value)
        if at_the_border(info.context):
            raise UnitError(
                said(
                    "needs a unit of {dimension}, written as text",
                    dimension=name_of(self.dimension),
                ),
                value=value,
            )
        return _checked_bounds(number, value, _bounds(self))

    def _serialised(self, value: float, info: core_schema.SerializationInfo) -> float | str:
        return from_si(value, self.dimension) if at_the_border(info.context) else value


@frozen
class Ratio:
    """Annotation of a float field without a dimension; varies as in `Quantity`."""

    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None
    varies: bool = False

    @property
    def limits(self) -> str:
        """The bounds in words; empty if there are none."""
        return limits_of(_bounds(self))

    @property
    def limits_in_si(self) -> dict[Relation, float]:
        """The bounds as numbers."""
        return {relation: limit for relation, (limit, _) in _bounds(self).items()}

    def allows(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return which of the values are finite and within the bounds."""
        return _within(values, _bounds(self))

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Have pydantic read the field with this object."""
        return core_schema.no_info_plain_validator_function(self._validated)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Return the number."""
        return _number_schema(_bounds(self))

    def _validated(self, value: object) -> float:
        return _checked_bounds(_number(value), value, _bounds(self))


@cache
def _bounds(annotation: Quantity | Ratio) -> Bounds:
    found: Bounds = {}
    for relation in _RELATIONS:
        limit = getattr(annotation, relation, None)
        if isinstance(annotation, Quantity) and limit:
            found[relation] = (to_si(limit, annotation.dimension), limit)
        elif isinstance(annotation, Ratio) and limit is not None:
            found[relation] = (limit, f"{limit:g}")
    return found


def _within(values: NDArray[np.float64], bounds: Bounds) -> NDArray[np.bool_]:
    import numpy as np

    inside = np.isfinite(values)
    for relation, (limit, _) in bounds.items():
        inside &= _RELATIONS[relation](values, limit)
    return inside


class Replaces:
    """Annotation of a field whose value takes the place of that of others.

    Of fields that replace each other, its rivals, a case takes one.

    Parameters
    ----------
    names
        Of fields of the same table, or dotted from the case.
    """

    def __init__(self, *names: str) -> None:
        self.names = names


def _whole_number(value: object) -> object:
    """Let other integer types in (NumPy's), but neither 16.0 nor True."""
    if isinstance(value, numbers.Integral) and not isinstance(value, bool):
        return int(value)
    return value


def _one_line(text: str) -> str:
    if any(unicodedata.category(character) in {"Cc", "Cs", "Zl", "Zp"} for character in text):
        raise InputError(said("must be one line without control characters"), value=text)
    return text


Count = BeforeValidator(_whole_number)
"""Annotation of an int field; use it with ``Field(strict=True)``."""

Line = Annotated[str, Field(strict=True, max_length=200), AfterValidator(_one_line)]
"""One line of text, at most 200 characters."""
