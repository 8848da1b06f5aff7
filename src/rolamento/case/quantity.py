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
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal

from pydantic import AfterValidator, BeforeValidator, Field, GetCoreSchemaHandler, ValidationInfo
from pydantic_core import CoreSchema, core_schema

from rolamento.errors import InputError, UnitError
from rolamento.units import Dimension, from_si, to_si

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["AT_THE_BORDER", "Count", "Line", "Quantity", "Ratio", "at_the_border"]

AT_THE_BORDER: Final = {"border": True}
"""The context in which values cross between text and SI: a file is read or written."""

Relation = Literal["above", "at_least", "below", "at_most"]

_RELATIONS: Final[dict[Relation, tuple[str, Callable[[Any, float], Any]]]] = {
    "above": ("greater than", operator.gt),
    "at_least": ("at least", operator.ge),
    "below": ("less than", operator.lt),
    "at_most": ("at most", operator.le),
}


def at_the_border(context: object) -> bool:
    """Tell whether a pydantic context is that of a file being read or written."""
    return context == AT_THE_BORDER


def _checked_bounds(
    value: float, given: object, bounds: dict[Relation, tuple[float, str]]
) -> float:
    """Return the value, with no negative zero, or name the bounds that it breaks."""
    if not math.isfinite(value):
        raise InputError("must be a finite number", value=given)
    if any(not _RELATIONS[relation][1](value, limit) for relation, (limit, _) in bounds.items()):
        limits = (f"{_RELATIONS[relation][0]} {text}" for relation, (_, text) in bounds.items())
        raise InputError(f"must be {' and '.join(limits)}", value=given)
    return value + 0.0


def _number(value: object) -> float:
    """Return a real number as a float; text and booleans are not numbers."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise InputError("must be a number", value=value)
    try:
        return float(value)
    except OverflowError:
        raise InputError("must be a finite number", value=value) from None


@dataclass(frozen=True, slots=True)
class Quantity:
    """Annotation of a float field that has a dimension; limits are text with a unit."""

    dimension: Dimension
    above: str = ""
    at_least: str = ""
    below: str = ""
    at_most: str = ""

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Tell pydantic to read and write the field with this object."""
        return core_schema.with_info_plain_validator_function(
            self._validated,
            serialization=core_schema.plain_serializer_function_ser_schema(
                self._serialised, info_arg=True
            ),
        )

    def allows(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Tell which of the SI values are finite and within the bounds."""
        return _within(values, self._bounds())

    def _validated(self, value: object, info: ValidationInfo) -> float:
        if isinstance(value, str):
            return _checked_bounds(to_si(value, self.dimension), value, self._bounds())
        number = _number(value)
        if at_the_border(info.context):
            name = self.dimension.replace("_", " ")
            raise UnitError(f"needs its unit: a {name} is written as text with a unit", value=value)
        return _checked_bounds(number, value, self._bounds())

    def _serialised(self, value: float, info: core_schema.SerializationInfo) -> float | str:
        return from_si(value, self.dimension) if at_the_border(info.context) else value

    def _bounds(self) -> dict[Relation, tuple[float, str]]:
        texts: dict[Relation, str] = {
            "above": self.above,
            "at_least": self.at_least,
            "below": self.below,
            "at_most": self.at_most,
        }
        return {
            relation: (to_si(text, self.dimension), text)
            for relation, text in texts.items()
            if text
        }


@dataclass(frozen=True, slots=True)
class Ratio:
    """Annotation of a float field without a dimension."""

    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Tell pydantic to read the field with this object."""
        return core_schema.no_info_plain_validator_function(self._validated)

    def allows(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Tell which of the values are finite and within the bounds."""
        return _within(values, self._bounds())

    def _validated(self, value: object) -> float:
        return _checked_bounds(_number(value), value, self._bounds())

    def _bounds(self) -> dict[Relation, tuple[float, str]]:
        limits: dict[Relation, float | None] = {
            "above": self.above,
            "at_least": self.at_least,
            "at_most": self.at_most,
        }
        return {name: (limit, f"{limit:g}") for name, limit in limits.items() if limit is not None}


def _within(
    values: NDArray[np.float64], bounds: dict[Relation, tuple[float, str]]
) -> NDArray[np.bool_]:
    import numpy as np

    inside = np.isfinite(values)
    for relation, (limit, _) in bounds.items():
        inside &= _RELATIONS[relation][1](values, limit)
    return inside


def _whole_number(value: object) -> object:
    """Let other integer types in (NumPy's), but neither 16.0 nor True."""
    if isinstance(value, numbers.Integral) and not isinstance(value, bool):
        return int(value)
    return value


def _one_line(text: str) -> str:
    if any(unicodedata.category(character) in {"Cc", "Cs", "Zl", "Zp"} for character in text):
        raise InputError("must be one line without control characters", value=text)
    return text


Count = BeforeValidator(_whole_number)
"""Annotation of an int field; use it with ``Field(strict=True)``."""

Line = Annotated[str, Field(strict=True, max_length=200), AfterValidator(_one_line)]
"""One line of text, at most 200 characters."""
