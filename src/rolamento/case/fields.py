"""The fields of a case, made from its records: names, quantities, bounds, rivals, labels.

Whoever reads, sets, varies, lists or draws a field asks here. What a record does not give by the
type of a field stands at the field: `Quantity` says whether it may vary in a batch, `Replaces`
what it takes the place of; what readers call it stands in `labels`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from copy import copy
from functools import cache, cached_property, lru_cache
from typing import Any, Final, Literal, NamedTuple, TypeVar, get_args, get_origin

from pydantic import BaseModel, create_model
from pydantic.fields import FieldInfo

from rolamento.case.former import current
from rolamento.case.hints import hint
from rolamento.case.labels import label_of
from rolamento.case.quantity import AT_THE_BORDER, Quantity
from rolamento.case.record import (
    Record,
    example_of,
    meanings,
    record_for,
    records_of,
    replaced,
)
from rolamento.errors import FileError, InputError, UnknownKeyError
from rolamento.io.text import parse_mapping
from rolamento.records import frozen
from rolamento.types import BALL
from rolamento.units import SI_UNIT, Dimension, from_si
from rolamento.words import said, speaking

__all__ = [
    "LONGEST_SETTING",
    "OVERRIDE_SOURCE",
    "Changes",
    "Field",
    "Value",
    "changed",
    "field_of",
    "fields_of",
    "in_file_form",
    "inline_value",
    "of_elements",
    "plain_value",
    "read_changed",
    "values_of",
]

OVERRIDE_SOURCE: Final = "--set"

_OF_BALLS: Final = frozenset({
    "model.raceway_control", "model.cage", "model.cage_drag", "model.mesh", "model.traction",
    "model.film_in_contact",
})  # fmt: skip
_OF_ROLLERS: Final = frozenset({"model.roller_contact", "model.slices", "film.line"})

Value = float | int | bool | str
"""What a field takes: SI floats of quantities, and what files hold of the others."""

R = TypeVar("R", bound=Record)
Kind = Literal["number", "count", "switch", "text", "list"]

_EXAMPLE: Final = 'duty.load.fz="10 kN"'
_COMMA: Final = re.compile(r"[+-]?\d*,\d+")
_INLINE_EXAMPLE: Final = """'bearing.preload={ force = "500 N" }'"""
LONGEST_SETTING: Final = 2000


@frozen(eq=False, slots=False)
class Field:
    """A field of a case.

    Attributes
    ----------
    name
        Dotted, such as ``"duty.load.fx"``.
    replaces
        Names of the fields that a value of this one takes the place of.
    rivals
        Those of them that replace this one too: a case takes one of them.
    """

    name: str
    replaces: tuple[str, ...]
    rivals: tuple[str, ...]
    _record: type[BaseModel]
    _info: FieldInfo

    @cached_property
    def kind(self) -> Kind:
        """``"number"``, ``"count"``, ``"switch"``, ``"list"``; ``"text"`` of choices and names."""
        return "number" if self.bounds is not None else _kind_of(self._info)

    @cached_property
    def bounds(self) -> Quantity | None:
        """The `Quantity` of a number."""
        return _bounds_in(self._info)

    @property
    def leaf(self) -> str:
        """The last part of the name."""
        return self.name.rpartition(".")[2]

    @property
    def dimension(self) -> Dimension | None:
        """Dimension of a quantity; None of anything else."""
        return None if self.bounds is None else self.bounds.dimension

    @property
    def continuous(self) -> bool:
        """Whether its values are real numbers: a quantity or a ratio."""
        return self.bounds is not None

    @property
    def varies(self) -> bool:
        """Whether many cases that are solved together may differ in it."""
        return self.bounds is not None and self.bounds.varies

    @property
    def unit(self) -> str:
        """The SI unit; ``"1"`` of a number without one, empty of what is no number."""
        if self.dimension is not None:
            return SI_UNIT[self.dimension].replace(" ", "*")
        return "1" if self.continuous else ""

    @property
    def shown_unit(self) -> str:
        """The unit in which a person gives it, such as ``"mm"``; empty without one."""
        example = str(self._info.examples[0]) if self._info.examples else ""
        return example.partition(" ")[2] if self.dimension is not None else ""

    @property
    def entries(self) -> Mapping[str, Field]:
        """The fields of the tables that a list holds, by their names in it; else empty."""
        listed = records_of(self._info.annotation) if self.kind == "list" else ()
        records = [record for record in listed if issubclass(record, Record)]
        return {name: one for record in records[::-1] for name, one in fields_of(record).items()}

    @property
    def choices(self) -> tuple[str, ...]:
        """The words that it may be; empty if it takes others."""
        return tuple(dict.fromkeys(_choices_in(self._info.annotation)))

    @property
    def names(self) -> tuple[str, ...]:
        """The names that a data file knows, of a material or a lubricant; else empty."""
        named = (one for one in records_of(self._info.annotation) if hasattr(one, "data_file"))
        return next((tuple(one.names()) for one in named), ())  # type: ignore[attr-defined]

    @property
    def limits(self) -> str:
        """The bounds in words; empty if there are none."""
        return self.bounds.limits if self.bounds is not None else ""

    @property
    def example(self) -> str:
        """A value as it is written in a file."""
        return example_of(self._record, (self.leaf,)).partition(" = ")[2]

    @property
    def meaning(self) -> str:
        """What the record's documentation says of it, with the SI unit."""
        return meanings(self._record).get(self.leaf, "")

    @property
    def label(self) -> str:
        """What it is called, in the language that is spoken: ``"lubricant temperature"``."""
        return label_of(self.name)

    @property
    def long_name(self) -> str:
        """What it is called in files: its label in English."""
        with speaking("en"):
            return self.label

    def checked(self, value: object, *, in_file: bool) -> Value:
        """Return a value as the case takes it: a quantity in SI units, a material's name.

        Raises
        ------
        InputError
            If the field does not take it; `in_file` demands quantities with their units.
        """
        if value is None or isinstance(value, Mapping | list | tuple):
            raise InputError(
                said("must be a single value, not a table or a list"),
                field=self.name,
                value=value,
                example=self.example,
            )
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

    @cached_property
    def _checker(self) -> type[Record]:
        annotation: Any = (self._info.annotation, self._info)
        return create_model("Value", __base__=Record, **{self.leaf: annotation})


def of_elements(name: str, elements: Iterable[str]) -> bool:
    """Return whether a field outside [bearing] matters to bearings in which these elements roll.

    Parameters
    ----------
    name
        Dotted, of the field.
    elements
        Of the rows, such as ``"ball"`` or ``"tapered"``.
    """
    balls = {element == BALL for element in elements}
    return not (name in _OF_BALLS and True not in balls) and not (
        name in _OF_ROLLERS and False not in balls
    )


@cache
def fields_of(record: type[Record]) -> Mapping[str, Field]:
    """Return the fields of a record and of the records in it, by their dotted names.

    A record that may also be given as text is a field itself, beside its own. What stands in a
    list of tables is not distinguished.
    """
    found = {one.name: one for one in _fields_in(record, "")}
    return {name: _field_found(one, found) for name, one in found.items()}


@lru_cache(maxsize=1024)
def field_of(record: type[Record], name: str) -> Field | None:
    """Return one of the fields of a record by its dotted name; the others are not looked at."""
    found = {one.name: one for one in _fields_in(record, "", name)}
    if name not in found:
        return None
    others = found[name].others
    found |= {one.name: one for other in others for one in _fields_in(record, "", other)}
    return _field_found(found[name], found)


class _Found(NamedTuple):
    name: str
    others: tuple[str, ...]
    holder: type[BaseModel]
    info: FieldInfo


def _field_found(one: _Found, found: Mapping[str, _Found]) -> Field:
    rivals = tuple(
        other for other in one.others if other in found and one.name in found[other].others
    )
    return Field(one.name, one.others, rivals, one.holder, one.info)


def _fields_in(record: type[BaseModel], table: str, name: str = "") -> Iterator[_Found]:
    """The fields of a record; name: only that one, and what it stands in."""
    for leaf, info in record.model_fields.items():
        dotted = f"{table}{leaf}"
        if name and name != dotted and not name.startswith(f"{dotted}."):
            continue
        inner = () if _is_list(info) else records_of(info.annotation)
        if not inner or getattr(inner[0], "has_short_form", False):
            others = (
                other if "." in other else f"{table}{other}" for other in replaced(record, leaf)
            )
            yield _Found(dotted, tuple(others), record, info)
        known: dict[str, _Found] = {}
        for one in inner:  # what they have in common is one field
            for found in _fields_in(one, f"{dotted}.", name):
                first = known.setdefault(found.name, found)
                known[found.name] = first._replace(info=_of_both(first.info, found.info))
        yield from known.values()


def _of_both(first: FieldInfo, second: FieldInfo) -> FieldInfo:
    """The field of two records: the first one's, with the words that either may be."""
    if first.annotation == second.annotation:
        return first
    words = dict.fromkeys((*_choices_in(first.annotation), *_choices_in(second.annotation)))
    if len(words) == len({*_choices_in(first.annotation)}):
        return first
    both = copy(first)
    both.annotation = Literal[*words] | None  # type: ignore[assignment]
    return both


def _kind_of(info: FieldInfo) -> Kind:
    """The kind of a field that is no number."""
    if _is_list(info):
        return "list"
    types = set(_types_in(info.annotation))
    return "switch" if bool in types else "count" if int in types else "text"


def _is_list(info: FieldInfo) -> bool:
    return tuple in _types_in(info.annotation)


def _types_in(annotation: object) -> Iterator[object]:
    if get_origin(annotation) is not Literal:
        yield get_origin(annotation) or annotation
        for part in get_args(annotation):
            yield from _types_in(part)


def _choices_in(annotation: object) -> Iterator[str]:
    for part in get_args(annotation):
        if get_origin(annotation) is Literal:
            yield str(part)
        else:
            yield from _choices_in(part)


def _bounds_in(info: FieldInfo) -> Quantity | None:
    """The annotation that bounds a number; None of a list of them."""
    if _is_list(info):
        return None
    return next(_numbers_in((*info.metadata, info.annotation)), None)


def _numbers_in(parts: tuple[Any, ...]) -> Iterator[Quantity]:
    for part in parts:
        if isinstance(part, Quantity):
            yield part
        yield from _numbers_in((*getattr(part, "__metadata__", ()), *get_args(part)))


# --- changes to a case file -----------------------------------------------------------------------


Changes = Mapping[str, Any] | Iterable[str]
"""What goes over a case: values by the dotted names of fields, in SI units or as a file holds them;
or ``KEY=VALUE``, as a command's options have it."""


def read_changed(mapping: Mapping[str, Any], changes: Changes, record: type[R]) -> R:
    """Return the record that tables describe, with changes put over them.

    Parameters
    ----------
    mapping, record
        As in `changed`.
    changes
        Values by dotted name. Or texts ``KEY=VALUE``, each with a dotted key and the value as in
        a case file, a table or a list as TOML writes it in one line; the quotes around text may
        be left out.

    Raises
    ------
    InputError
        If a text is not of that form, a key names no field, or the record is not valid. What a
        text sets has its source, ``--set``.
    """
    if isinstance(changes, Mapping):
        return record.from_mapping(changed(mapping, changes, record))
    try:
        values = values_of(changes, record)
        tables = changed(mapping, values, record, in_file=True)
    except InputError as error:
        raise error.with_details(source=OVERRIDE_SOURCE) from None
    try:
        return record.from_mapping(tables)
    except InputError as error:
        if any(f"{error.field}.".startswith(f"{one}.") for one in values):
            raise error.with_details(source=OVERRIDE_SOURCE) from None
        raise


def values_of(settings: Iterable[str], record: type[Record]) -> dict[str, object]:
    """Return what settings set: values as a file holds them, by dotted name.

    Parameters and errors as of `read_changed`.
    """
    values: dict[str, object] = {}
    for setting in settings:
        key, equals, text = setting.partition("=")
        if not equals or not key.strip() or len(setting) > LONGEST_SETTING:
            raise InputError(said("must be KEY=VALUE"), value=setting, example=_EXAMPLE)
        name = current(".".join(part.strip() for part in key.split(".")))
        values.pop(name, None)  # the last one counts
        values[name] = _given(name, text.strip(), record)
    return values


def changed(
    mapping: Mapping[str, Any],
    values: Mapping[str, Any],
    record: type[Record],
    *,
    in_file: bool = False,
) -> dict[str, Any]:
    """Return a copy of the tables of a case file with some values changed.

    It is not validated: a value can put right what would be refused. What replaces a rival (a
    clearance a contact angle, a displacement a load) takes its place.

    Parameters
    ----------
    mapping
        The tables.
    values
        By dotted name, as a file holds them; None takes a value away.
    record
        That the mapping describes.
    in_file
        Whether the values are from a file too; else quantities may be numbers in SI units, and
        tables records.

    Raises
    ------
    InputError
        If there is no such field, or it takes no such number.
    """
    result = dict(mapping)
    values = {current(name): value for name, value in values.items()}
    for name, value in values.items():
        _put(result, name, value if in_file else in_file_form(name, value, record), record)
        for rival in _rivals(name, value, record):
            if rival not in values:
                _put(result, rival, None, record)
    return result


def _rivals(name: str, value: object, record: type[Record]) -> Iterator[str]:
    """The names of the fields that a value, or those of a table, take the place of."""
    field = field_of(record, name)
    if field is not None and value is not None:
        yield from field.replaces
    for leaf, inner in value.items() if isinstance(value, Mapping) else ():
        yield from _rivals(f"{name}.{leaf}", inner, record)


def in_file_form(name: str, value: Any, record: type[Record]) -> object:
    """Return a value of a field or a table, SI or a record, as a file holds it.

    Raises
    ------
    InputError
        If there is no such field, or it takes no such value.
    """
    info, table = _info(name, record), _table(name, record, value)
    if table is not None and (value is None or isinstance(value, Mapping | Record)):
        return value if value is None else _mapping_of(value, table)
    if info is not None and _is_list(info) and isinstance(value, list | tuple):
        return [_mapping_of(entry, record_for(info, entry)) for entry in value]
    field = _field(name, record)
    if getattr(value, "ndim", None) == 0:  # of NumPy
        value = value.item()
    if value is None or isinstance(value, str) or field.dimension is None:
        return value
    return field.written(field.checked(value, in_file=False))


def _mapping_of(value: object, record: type[Record] | None) -> object:
    if isinstance(value, Mapping) and record is not None:  # what it leaves unsaid stays so
        read = record(**value)
        return read.model_dump(context=AT_THE_BORDER, exclude_none=True, exclude_unset=True)
    return value.to_mapping() if isinstance(value, Record) else value


def _table(name: str, record: type[BaseModel], given: object = None) -> type[Record] | None:
    """Return the record of a table of that name; given: what is to be read as it."""
    info = _info(name, record)
    return None if info is None or _is_list(info) else record_for(info, given)


def _info(name: str, record: type[BaseModel]) -> FieldInfo | None:
    """What is known of a field or a table, by its dotted name; None if there is none."""
    tables: tuple[type[BaseModel], ...] = (record,)
    info = None
    for part in name.split("."):
        fields = (table.model_fields.get(part) for table in tables)
        info = next((field for field in fields if field is not None), None)
        if info is None:
            return None
        tables = records_of(info.annotation)
    return info


def _field(name: str, record: type[Record]) -> Field:
    """Return the field of a name; it must be neither a whole table nor a list."""
    field = field_of(record, name)
    if field is not None and field.kind != "list":
        return field
    known = fields_of(record)
    parts = name.split(".")
    for depth, part in enumerate(parts):
        table = "".join(f"{above}." for above in parts[:depth])
        inside = [other[len(table) :] for other in known if other.startswith(table)]
        here = tuple(dict.fromkeys(other.split(".")[0] for other in inside))
        if part not in here:
            rule = (
                said("is an unknown key; {guess}", guess=hint(table + part, known, here))
                if here
                else said("is an unknown key; {table} is not a table", table=table[:-1])
            )
            raise UnknownKeyError(rule, field=name, example=_EXAMPLE)
        if (leaf := known.get(f"{table}{part}")) is not None and leaf.kind == "list":
            raise InputError(
                said("is a list; give all of it, or set it in the file"),
                field=leaf.name,
                example=f"{leaf.name}=[…]",
            )
    inside = [other[len(name) + 1 :] for other in known if other.startswith(f"{name}.")]
    here = tuple(dict.fromkeys(other.split(".")[0] for other in inside))
    raise InputError(
        said("is a table; set all of it, or one of its fields: {here}", here=", ".join(here)),
        field=name,
        example=_INLINE_EXAMPLE,
    )


def _given(name: str, text: str, record: type[Record]) -> object:
    """Return what a setting gives: a value, or the table or list that TOML has in one line."""
    field = field_of(record, name)
    is_list = field is not None and field.kind == "list"
    if text.startswith("[" if is_list else "{") and (is_list or _table(name, record) is not None):
        return inline_value(name, text, _INLINE_EXAMPLE)
    return _value(text, _field(name, record))


def inline_value(name: str, text: str, example: str) -> object:
    """Return the table or list that TOML has in one line.

    Raises
    ------
    InputError
        Of that name and example, if it is none.
    """
    try:
        mapping = parse_mapping(f"value = {text}", "toml", "")
        if len(mapping) == 1:
            return mapping["value"]
        rule = said("must be a single value")
    except FileError as error:
        rule = error.rule
    raise InputError(rule, field=name, value=text, example=example)


def _value(text: str, field: Field) -> object:
    """Return the value that a setting's text stands for, as a file would have held it."""
    unquoted = _unquoted(text)
    if field.kind == "number" and unquoted is None and _COMMA.fullmatch(text):
        text = text.replace(",", ".")  # a decimal comma, as every other option takes it
    return text if unquoted is None and field.kind == "text" else plain_value(text)


def plain_value(text: str) -> object:
    """Return what a text stands for, as TOML has it in one line; the quotes may be left out."""
    unquoted = _unquoted(text)
    if unquoted is not None:
        return unquoted
    if text in ("true", "false"):
        return text == "true"
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            continue
    return text


def _unquoted(text: str) -> str | None:
    quoted = len(text) >= 2 and text[0] == text[-1] and text[0] in "\"'"
    return text[1:-1] if quoted else None


def _put(mapping: dict[str, Any], name: str, value: object, record: type[Record]) -> None:
    """Set a value or take it away, copying the tables on its path: the caller's stay as they are.

    A table that is given as text is spelt out, so that a field can be set in it.
    """
    *path, leaf = name.split(".")
    table = mapping
    for depth, part in enumerate(path, start=1):
        inner = table.get(part, {})
        here = ".".join(path[:depth])
        if isinstance(inner, str) and value is not None:
            above = _table(here, record)
            if above is not None and above.has_short_form:
                inner = _spelt_out(inner, above, here)
        if not isinstance(inner, dict):
            if value is None:
                return
            raise InputError(
                said(
                    "is not a table in this case; set it as a whole, or write a table in the file"
                ),
                field=here,
                value=inner,
            )
        if value is None and part not in table:
            return
        table[part] = table = dict(inner)
    if value is None:
        table.pop(leaf, None)
    else:
        table[leaf] = value


def _spelt_out(text: str, record: type[Record], name: str) -> dict[str, Any]:
    try:
        return record.table_of_text(text)
    except InputError as error:
        raise error.with_details(field=name) from None
