"""Field types of what the user gives: quantities, counts, names.

A quantity is an SI float inside. In Python it is given as that float, or as text with
a unit. In a file it must be text with a unit: pydantic's validation context says
which of the two is being read.
"""

from __future__ import annotations

import math
import numbers
import operator
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal

from pydantic import (
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
from rolamento.words import Written, marked, said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["AT_THE_BORDER", "Count", "InSI", "Line", "Quantity", "Replaces", "finite_number"]

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


class InSI(float):
    """A value that the catalogue puts beside those of a file: without a unit, in SI units."""


@frozen(slots=False)
class Quantity:
    """Annotation of a float field: its dimension, and its limits as text with a unit.

    A quantity without a dimension is a plain number, and so are its limits.

    varies: whether many cases that are solved together may differ in it.
    """

    dimension: Dimension | None = None
    above: str | float | None = None
    at_least: str | float | None = None
    below: str | float | None = None
    at_most: str | float | None = None
    varies: bool = False

    @cached_property
    def limits_in_si(self) -> dict[Relation, float]:
        """The bounds as numbers."""
        return {
            relation: limit if self.dimension is None else to_si(limit, self.dimension)
            for relation in _RELATIONS
            if (limit := getattr(self, relation)) is not None
        }

    @property
    def limits(self) -> str:
        """The bounds in words; empty if there are none."""
        limits = {relation: getattr(self, relation) for relation in self.limits_in_si}
        texts = {
            relation: Written(f"{limit:g}" if self.dimension is None else limit)
            for relation, limit in limits.items()
        }
        return said(_LIMITS[tuple(texts)], **texts) if texts else ""

    def allows(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return which of the SI values are finite and within the bounds."""
        import numpy as np

        inside = np.isfinite(values)
        for relation, limit in self.limits_in_si.items():
            inside &= _RELATIONS[relation](values, limit)
        return inside

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
        limits = {_JSON_SCHEMA[relation]: limit for relation, limit in self.limits_in_si.items()}
        number: dict[str, Any] = {"type": "number", **limits}
        if self.dimension is None:
            return number
        number["unit"] = SI_UNIT[self.dimension]
        text = {"type": "string", "dimension": self.dimension, "limits": self.limits}
        return number if handler.mode == "serialization" else {"anyOf": [text, number]}

    def _validated(self, value: object, info: ValidationInfo) -> float:
        """Return a value in SI units, with no negative zero, or name the rule that it breaks."""
        if isinstance(value, str) and self.dimension is not None:
            number = to_si(value, self.dimension)
        else:
            number = finite_number(value)
            bare = info.context == AT_THE_BORDER and not isinstance(value, InSI)
            if self.dimension is not None and bare:
                name = name_of(self.dimension)
                rule = said("needs a unit of {dimension}, written as text", dimension=name)
                raise UnitError(rule, value=value)
        for relation, limit in self.limits_in_si.items():
            if not _RELATIONS[relation](number, limit):
                raise InputError(said("must be {limits}", limits=self.limits), value=value)
        return number + 0.0

    def _serialised(self, value: float, info: core_schema.SerializationInfo) -> float | str:
        if self.dimension is None or info.context != AT_THE_BORDER:
            return value
        return from_si(value, self.dimension)


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


def finite_number(value: object) -> float:
    """Return a real number, one of NumPy too, as a float.

    Raises
    ------
    InputError
        If it is none, or not finite.
    """
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise InputError(said("must be a number"), value=value)
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(said("must be a finite number"), value=value)
    return number


def _whole_number(value: object) -> object:
    """Let other integer types in (NumPy's), but neither 16.0 nor True."""
    if isinstance(value, numbers.Integral) and not isinstance(value, bool):
        return int(value)
    return value


Count = BeforeValidator(_whole_number)
"""Annotation of an int field; use it with ``Field(strict=True)``."""

_ONE_LINE: Final = r"^[^\x00-\x1f\x7f-\x9f\u2028\u2029]*$"
Line = Annotated[str, Field(strict=True, max_length=200, pattern=_ONE_LINE)]
"""One line of text, at most 200 characters, none of which controls a terminal."""
