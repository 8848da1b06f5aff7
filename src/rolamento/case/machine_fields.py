"""The fields of a machine by their dotted keys, as `--set` has them: what a study may vary."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields as parts_of
from typing import Annotated, Any, Final

from pydantic import Field as Described

from rolamento.case.case import Case
from rolamento.case.fields import Field, fields_of
from rolamento.case.labels import label_of
from rolamento.case.machine import Machine, MachineBearing, parts_of_key
from rolamento.case.machine_files import CASE_TABLES
from rolamento.case.quantity import Quantity
from rolamento.case.record import Record, records_of
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.words import said

__all__ = ["MachineField", "field_of_machine", "fields_of_machine", "is_of_part", "place_of_key"]

_LABELS: Final = ("title", "name", "source")
"""Last parts of the names of fields that change nothing."""
_TOP: Final = "gravity"
"""The table of a machine that no case has."""


class _Rates(Record):
    """What one of the numbers of a stiffness takes."""

    stiffness: Annotated[float, Quantity("stiffness", at_least="0 N/m")] = Described(
        examples=["200 N/um"]
    )
    angular_stiffness: Annotated[float, Quantity("angular_stiffness", at_least="0 N m/rad")] = (
        Described(examples=["5 kN m/rad"])
    )


_RATES: Final = (*("stiffness",) * 3, *("angular_stiffness",) * 2)


@frozen(eq=False, slots=False)
class MachineField(Field):
    """A field of a part of a machine, such as ``"loads.0.fz"``.

    inner: what its record calls it; part: which part it is of.
    """

    inner: str = ""
    part: str = ""

    @property
    def leaf(self) -> str:
        """The last part of the name that its record gives it."""
        return self.inner.rpartition(".")[2]

    @property
    def label(self) -> str:
        """What it is called, and of which part it is."""
        name = label_of(self.inner)
        return said("{quantity}, {part}", quantity=name, part=self.part) if self.part else name


def is_of_part(name: str) -> bool:
    """Return whether a dotted key is that of a part of a machine, which no case has."""
    first = name.partition(".")[0].strip().strip('"')
    info = Machine.model_fields.get(first)
    return first == _TOP or (info is not None and first not in Case.model_fields)


def field_of_machine(name: str) -> MachineField | None:
    """Return the field of a part of a machine; None if no machine has it.

    Parameters
    ----------
    name
        Dotted; parts by their names, or by their numbers from 0. Whether there is such a part only
        the machine knows.
    """
    try:
        key = parts_of_key(name)
    except InputError:
        return None
    if key[0] == _TOP:
        own = fields_of(Machine).get(".".join(key))
        return None if own is None else _named(own, name, own.name, "")
    info = Machine.model_fields.get(key[0])
    records = records_of(info.annotation) if info is not None and is_of_part(name) else ()
    if not records or len(key) < 3:
        return None
    record = records[0]
    assert issubclass(record, Record)
    found = _inside(record, key[2:])
    if found is None or found.kind == "list" or found.leaf in _LABELS:
        return None
    part = key[1] if not key[1].isdigit() else f"{key[0]}.{key[1]}"
    return _named(found, name, found.name, part)


def _inside(record: type[Record], rest: Sequence[str]) -> Field | None:
    """A field of a record, of one of the tables of a list in it, or of a case in it."""
    if issubclass(record, MachineBearing) and rest[0] in CASE_TABLES:
        return Case.fields().get(".".join(rest))
    known = fields_of(record)
    own = known.get(rest[0])
    if own is None or own.kind != "list" or len(rest) == 1:
        return known.get(".".join(rest))
    if own.name == "stiffness" and len(rest) == 2 and rest[1] in ("0", "1", "2", "3", "4"):
        return fields_of(_Rates)[_RATES[int(rest[1])]]
    return own.entries.get(rest[2]) if len(rest) == 3 and rest[1].isdigit() else None


def _named(field: Field, name: str, inner: str, part: str) -> MachineField:
    given = {one.name: getattr(field, one.name) for one in parts_of(field)}
    table = name[: len(name) - len(inner)] if name.endswith(inner) else None
    rivals = () if table is None else tuple(f"{table}{rival}" for rival in field.rivals)
    return MachineField(**{**given, "name": name, "rivals": rivals, "replaces": rivals,
                           "inner": inner, "part": part})  # fmt: skip


def place_of_key(machine: Machine, name: str) -> tuple[str, ...]:
    """Return the parts of a key with the numbers of parts in the places of their names."""
    key = parts_of_key(name)
    parts = getattr(machine, key[0], None)
    if not isinstance(parts, tuple) or len(key) < 2:
        return key
    names = [part.name for part in parts]
    return (key[0], str(names.index(key[1])) if key[1] in names else key[1], *key[2:])


def fields_of_machine(machine: Machine) -> Mapping[str, Field]:
    """Return the fields of a machine that a study may vary, by their dotted keys."""
    return dict(_fields_of_machine(machine))


def _fields_of_machine(machine: Machine) -> Iterator[tuple[str, Field]]:
    for name, info in Machine.model_fields.items():
        parts: Any = getattr(machine, name)
        if not isinstance(parts, tuple) or not records_of(info.annotation):
            continue
        for index, part in enumerate(parts):
            table = f"{name}.{_written(part.name) or index}"
            for leaf in _leaves(part):
                if (found := field_of_machine(f"{table}.{leaf}")) is not None:
                    yield found.name, found
    for name in fields_of(Machine) if machine.gravity is not None else ():
        if (found := field_of_machine(name)) is not None:
            yield name, found
    shared = {name for name in CASE_TABLES if name in Machine.model_fields}
    for name, field in Case.fields().items():
        if name.partition(".")[0] in shared and field.kind != "list" and field.leaf not in _LABELS:
            yield name, field


def _leaves(part: Record) -> Iterator[str]:
    for name, field in fields_of(type(part)).items():
        values = getattr(part, name, None)
        if field.kind != "list":
            yield name
        elif name == "stiffness" and values is not None:
            yield from (f"stiffness.{place}" for place in range(len(values)))
        else:
            for place in range(len(values or ())):
                yield from (f"{name}.{place}.{leaf}" for leaf in field.entries)
    if isinstance(part, MachineBearing):
        yield from (name for name in Case.fields() if name.partition(".")[0] in CASE_TABLES)


def _written(name: str) -> str:
    """A name as a key has it: in quotes where it has a dot or an equals sign."""
    return f'"{name}"' if "." in name or "=" in name else name
