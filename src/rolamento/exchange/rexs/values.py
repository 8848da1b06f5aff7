"""Values of REXS attributes as SI floats and back: each has the unit that its file states."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from decimal import Context, Decimal
from functools import cache
from typing import Any, Final, NamedTuple

from rolamento.errors import FileError, UnitError
from rolamento.exchange.rexs.model import Attribute, Component
from rolamento.io.data import toml_of
from rolamento.units import Dimension, to_si
from rolamento.words import said

__all__ = [
    "Standard",
    "attribute_of",
    "former_names",
    "number_of",
    "numbers_of",
    "placed",
    "plain_number",
    "quantity_of",
    "standard_of",
    "words",
]

_MOST_DIGITS: Final = 20
"""Seventeen give back any float of its own unit; π and offsets take one or two more."""


class Standard(NamedTuple):
    """What REXS says of an attribute: its dimension and unit."""

    dimension: Dimension
    unit: str


def words() -> Mapping[str, Any]:
    """Return the words of REXS, of ``data/rexs.toml``."""
    return toml_of("rexs")


@cache
def _standards() -> Mapping[str, Standard]:
    return {
        name: Standard(group["dimension"], group["unit"])
        for group in words()["quantities"]
        for name in group["attributes"]
    }


def standard_of(name: str) -> Standard | None:
    """Return dimension and unit of an attribute; None of one that is no quantity."""
    return _standards().get(name)


def former_names(name: str) -> tuple[str, ...]:
    """Return an attribute's name, and those that it had before."""
    return (name, *words()["former"].get(name, ()))


# --- reading --------------------------------------------------------------------------------------


def placed(error: UnitError | FileError, component: Component, name: str) -> FileError:
    """Return an error with its place: the component and the attribute."""
    return FileError(
        error.rule,
        field=f"{component.type} {component.id}.{name}",
        value=error.value,
        example=error.example,
    )


def _quantity(text: str, unit: str, standard: Standard) -> float:
    """Return a number with a unit in SI.

    Raises
    ------
    UnitError
        If it is none, or the unit is of another quantity.
    """
    spelled = words()["units"].get(unit, unit) or standard.unit
    spelled = words()["units"].get(spelled, spelled)
    text = text.strip()
    if text.lower().lstrip("+-") in ("nan", "inf", "infinity"):
        raise UnitError(said("must be a finite number"), value=text)
    return to_si(f"{text} {spelled}", standard.dimension)


def quantity_of(component: Component, attribute: Attribute, name: str) -> float:
    """Return a scalar attribute in SI.

    Parameters
    ----------
    component
        That has it, for messages.
    attribute
        Which, perhaps under a former name.
    name
        That it has now, by which its dimension goes.

    Raises
    ------
    FileError
        If it is no number, or its unit is one of another quantity.
    """
    standard = standard_of(name)
    assert standard is not None, name
    if not isinstance(attribute.value, str):
        error = FileError(said("must be a single value, not a table or a list"))
        raise placed(error, component, name)
    unit = "" if attribute.unit in ("none", "-") else attribute.unit
    try:
        return _quantity(attribute.value, unit, standard)
    except UnitError as error:
        raise placed(error, component, attribute.id) from None


def numbers_of(component: Component, attribute: Attribute, name: str) -> tuple[float, ...]:
    """Return an array in SI; of unit vectors the plain numbers. Errors as of `quantity_of`."""
    value = attribute.value
    cells = value if isinstance(value, tuple) else (value,)
    standard = standard_of(name)
    found = []
    for cell in cells:
        if isinstance(cell, tuple):
            error = FileError(said("must be a list of numbers"))
            raise placed(error, component, name)
        one = Attribute(attribute.id, cell, attribute.unit)
        found.append(
            number_of(component, one) if standard is None else quantity_of(component, one, name)
        )
    return tuple(found)


def number_of(component: Component, attribute: Attribute) -> float:
    """Return a plain number. Errors as of `quantity_of`."""
    try:
        number = float(attribute.text)
        if not math.isfinite(number):
            raise ValueError
    except ValueError:
        error = FileError(said("must be a finite number"), value=attribute.value)
        raise placed(error, component, attribute.id) from None
    return number


# --- writing --------------------------------------------------------------------------------------


def _written(value: float, standard: Standard) -> str:
    """Return the number of an SI value in a unit, so that reading gives the identical float."""
    guess = _guess(value, standard)
    for digits in range(15, _MOST_DIGITS + 1):
        text = plain_number(Context(prec=digits).plus(guess))
        if _quantity(text, standard.unit, standard) == value:
            return text
    return text


def _guess(value: float, standard: Standard) -> Decimal:
    """Return a value in a unit, with more digits than are needed."""
    context = Context(prec=40)
    one, zero = (Decimal(_quantity(text, standard.unit, standard)) for text in ("1", "0"))
    if standard.dimension == "temperature":
        zero, one = Decimal("273.15"), Decimal("274.15")
    elif standard.dimension in ("angle", "angular_speed") and one != 1:
        pi = Decimal("3.14159265358979323846264338327950288419716939937510")
        one = context.divide(pi, Decimal(180 if standard.dimension == "angle" else 30))
    else:
        one = Decimal(f"{float(one):.15g}")
    return context.divide(context.subtract(Decimal(value), zero), context.subtract(one, zero))


def plain_number(number: float | Decimal) -> str:
    """Return a number as REXS writes it: with a point, without trailing zeros."""
    decimal = number if isinstance(number, Decimal) else Decimal(repr(float(number)))
    if not decimal:
        return "0.0"
    short = decimal.normalize()
    text = f"{short:f}" if -7 < short.adjusted() < 20 else f"{short:E}"
    return text if "." in text or "E" in text else f"{text}.0"


def attribute_of(name: str, value: Any) -> Attribute:
    """Return an attribute with the unit that REXS gives it.

    Parameters
    ----------
    name
        Of the attribute.
    value
        In SI; a sequence of numbers, a whole number, a truth or a text.
    """
    standard = standard_of(name)
    if isinstance(value, bool):
        return Attribute(name, "true" if value else "false", "none", "boolean")
    if isinstance(value, int):
        return Attribute(name, str(value), "none", "integer")
    if isinstance(value, str):
        return Attribute(name, value, "none", "string")
    if isinstance(value, Sequence):
        cells = tuple(
            plain_number(one) if standard is None else _written(one, standard) for one in value
        )
        unit = "none" if standard is None else standard.unit
        return Attribute(name, cells, unit, "floating_point_array")
    if standard is None:
        unit = "%" if name in words()["percentages"]["attributes"] else "none"
        return Attribute(name, plain_number(value), unit, "floating_point")
    return Attribute(name, _written(value, standard), standard.unit, "floating_point")
