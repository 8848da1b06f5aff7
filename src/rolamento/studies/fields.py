"""The fields of a case that a study may vary: names, units, and what each takes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Final, get_args

from pydantic import BaseModel, create_model
from pydantic.fields import FieldInfo

from rolamento.case import Case
from rolamento.case.arrangement import Preload
from rolamento.case.duty import AXES, LOADS
from rolamento.case.life_model import DIRT
from rolamento.case.material import Material
from rolamento.case.quantity import Quantity, Ratio
from rolamento.case.record import Record, record_of
from rolamento.errors import InputError, UnknownKeyError, nearest
from rolamento.units import SI_UNIT, Dimension, from_si

__all__ = ["Field", "Value", "known_fields", "read_field", "refuse_rivals", "unit_name"]

Value = float | int | bool | str
"""What a field takes in a study: SI floats of quantities, and what files hold of the others."""

_NOT_VARIED: Final = ("title", "bearing.rows")
_NAMED_RECORDS: Final = (Material,)
"""Tables that are also known by a name."""

_RIVALS: Final = (
    ("bearing.contact_angle", "bearing.diametral_clearance"),
    *((f"duty.load.{b}", f"duty.displacement.{a}") for a, b in zip(AXES, LOADS, strict=True)),
    tuple(f"bearing.preload.{name}" for name in Preload.model_fields),
    tuple(f"life.{name}" for name in DIRT),
)
"""Of each group, a case takes one."""


@dataclass(frozen=True, slots=True)
class Field:
    """A field of a case.

    Attributes
    ----------
    name
        dotted, such as ``"duty.load.fx"``
    dimension
        of a quantity; ``None`` of anything else
    continuous
        whether its values are real numbers: a quantity or a ratio
    example
        as it is written in a file
    """

    name: str
    dimension: Dimension | None
    continuous: bool
    example: str
    _checker: type[Record]

    @property
    def leaf(self) -> str:
        """The last part of the name."""
        return self.name.rpartition(".")[2]

    @property
    def unit(self) -> str:
        """The SI unit; ``"1"`` of a number without one, empty of what is no number."""
        if self.dimension is not None:
            return unit_name(self.dimension)
        return "1" if self.continuous else ""

    @property
    def long_name(self) -> str:
        """The name in words: the field, and the table it stands in."""
        *tables, leaf = self.name.split(".")
        words = [leaf, *(["of", tables[-1]] if len(tables) > 1 else [])]
        return " ".join(words).replace("_", " ")

    def checked(self, value: object, *, in_file: bool) -> Value:
        """Return a value as the case takes it: a quantity in SI units, a material's name.

        Raises
        ------
        InputError
            If the field does not take it; `in_file` demands quantities with their units.
        """
        if value is None or isinstance(value, Mapping | list | tuple):
            raise self._refused(value, "must be one value, not a table or a list of values")
        given = {self.leaf: value}
        try:
            record = self._checker.from_mapping(given) if in_file else self._checker(**given)
        except InputError as error:
            raise error.with_details(field=self.name, example=self.example) from None
        checked = getattr(record, self.leaf)
        return str(value) if isinstance(checked, BaseModel) else checked

    def written(self, value: Value) -> Value:
        """Return a checked value as a file holds it; inverse of `checked`."""
        if self.dimension is not None and not isinstance(value, str):
            return from_si(float(value), self.dimension)
        return value

    def _refused(self, value: object, rule: str) -> InputError:
        return InputError(rule, field=self.name, value=value, example=self.example)


def unit_name(dimension: Dimension) -> str:
    """Return the SI unit of a dimension, as results have it: ``"N*m"``."""
    return SI_UNIT[dimension].replace(" ", "*")


@cache
def known_fields() -> Mapping[str, Field]:
    """Return the fields that a study may vary, by their dotted names."""
    return {field.name: field for field in _fields_of(Case, ())}


def read_field(name: str, *, at: str = "field") -> Field:
    """Return the field of a name.

    Parameters
    ----------
    name
        Dotted.
    at
        Where the study has it, for the message.

    Raises
    ------
    UnknownKeyError
        If no case has it; the message gives the nearest one.
    """
    known = known_fields()
    field = known.get(name)
    if field is not None:
        return field
    raise UnknownKeyError(
        f"is not a field that can be varied; {_advice(name, known)}",
        field=at,
        value=name,
        example='"duty.load.fx"',
    )


def _advice(name: str, known: Mapping[str, Field]) -> str:
    inside = [other for other in known if other.startswith(f"{name}.")]
    if inside:
        return f"it is a table with {', '.join(inside)}"
    same_leaf = [other for other, field in known.items() if field.leaf == name]
    near = same_leaf[0] if same_leaf else nearest(name, known)
    return f"did you mean {near}?" if near else "rolamento sweep --list fields shows all"


def refuse_rivals(names: tuple[str, ...], *, at: str) -> None:
    """Refuse to vary two fields of which a case takes one.

    Raises
    ------
    InputError
        Naming both.
    """
    for group in _RIVALS:
        given = [name for name in group if name in names]
        if len(given) > 1:
            raise InputError(
                f"is varied beside {given[0]}; a case takes one of them", field=at, value=given[1]
            )


def _fields_of(record: type[BaseModel], path: tuple[str, ...]) -> Iterator[Field]:
    for leaf, info in record.model_fields.items():
        name = ".".join((*path, leaf))
        inner = record_of(info.annotation)
        if name in _NOT_VARIED or (record is Material and leaf in ("name", "source")):
            continue
        if inner is None or inner in _NAMED_RECORDS:
            yield _field(name, leaf, info)
        if inner is not None:
            yield from _fields_of(inner, (*path, leaf))


def _field(name: str, leaf: str, info: FieldInfo) -> Field:
    found = next(_numbers_in((*info.metadata, info.annotation)), None)
    example = info.examples[0] if info.examples else ""
    return Field(
        name=name,
        dimension=found.dimension if isinstance(found, Quantity) else None,
        continuous=found is not None,
        example=f'"{example}"' if isinstance(example, str) else str(example).lower(),
        _checker=create_model("Value", __base__=Record, **{leaf: (info.annotation, info)}),  # type: ignore[call-overload]
    )


def _numbers_in(parts: tuple[Any, ...]) -> Iterator[Quantity | Ratio]:
    for part in parts:
        if isinstance(part, Quantity | Ratio):
            yield part
        yield from _numbers_in((*getattr(part, "__metadata__", ()), *get_args(part)))
