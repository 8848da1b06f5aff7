"""A machine of a REXS model: what is taken, what is inferred, and what is left out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Any, Final

from rolamento.case.machine import Machine
from rolamento.case.machine_files import MOST_SECTIONS
from rolamento.errors import FileError, InputError
from rolamento.exchange.rexs.bearings import BearingReader
from rolamento.exchange.rexs.gears import GearReader
from rolamento.exchange.rexs.loads import LoadReader
from rolamento.exchange.rexs.model import Component, RexsModel
from rolamento.exchange.rexs.reader import (
    BEARINGS,
    CUSTOM,
    DIGEST,
    GEARS,
    SPRINGS,
    Part,
    Remark,
)
from rolamento.exchange.rexs.restoring import Restorer
from rolamento.exchange.rexs.values import words
from rolamento.io.json import plain
from rolamento.records import frozen
from rolamento.words import Note, said

__all__ = [
    "APPLICATION",
    "CUSTOM",
    "DIGEST",
    "Imported",
    "Part",
    "Remark",
    "Taken",
    "machine_of_rexs",
    "parts_of",
]

SCHEMA: Final = 1
KIND: Final = "rexs_import"
APPLICATION: Final = "Rolamento"
_READ: Final = (
    "gear_unit", "gear_casing", "shaft", "shaft_section", "external_load", *GEARS,
    "cylindrical_stage", "bevel_stage", "additional_mass", "lubricant", "material",
    "rolling_bearing_row", "rolling_element", "flank_geometry", *BEARINGS, *SPRINGS,
)  # fmt: skip
_MOST: Final = (
    (("shaft",), 20), (BEARINGS, 100), (("external_load",), 500), (GEARS, 100),
    (("cylindrical_stage", "bevel_stage"), 100), (("additional_mass",), 500), (SPRINGS, 200),
    (("shaft_section",), 20 * MOST_SECTIONS),
)  # fmt: skip
"""As many components of some types as a machine has; no more are looked at."""
_SILENT: Final = ("stage_gear_data", "rolling_element_contact")
"""What holds no more than results, or nothing."""


@frozen
class Taken:
    """A component that became a part of the machine.

    Attributes
    ----------
    component, type, name
        as in the file
    part
        of the machine, such as ``"shafts.0"``; empty of one that counts elsewhere
    attributes
        that were read
    """

    component: int
    type: str
    name: str
    part: str
    attributes: tuple[str, ...]


@frozen(eq=False)
class Imported:
    """A machine that was read from a REXS model.

    Attributes
    ----------
    machine
        what it became
    version, application
        of the file
    taken
        components that were read, in the order of the file
    remarks
        what was inferred or left out
    """

    machine: Machine
    version: str
    application: str
    taken: tuple[Taken, ...]
    remarks: tuple[Remark, ...]

    def of_sort(self, sort: str) -> tuple[Remark, ...]:
        """Return the remarks on what was ``"inferred"``, or ``"left"`` out."""
        return tuple(one for one in self.remarks if one.sort == sort)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists."""
        return {
            "schema": SCHEMA,
            "kind": KIND,
            "version": self.version,
            "application": self.application,
            "taken": [
                {
                    "component": one.component,
                    "type": one.type,
                    "name": one.name,
                    "part": one.part or None,
                    "attributes": list(one.attributes),
                }
                for one in self.taken
            ],
            **{
                sort: [
                    {"component": one.component, **one.note.to_mapping()}
                    for one in self.of_sort(sort)
                ]
                for sort in ("inferred", "left")
            },
            "machine": plain(self.machine.to_mapping()),
        }


def machine_of_rexs(model: RexsModel, *, load_case: int | None = None) -> Imported:
    """Return the machine that a REXS model describes.

    Parameters
    ----------
    model
        Of `rolamento.exchange.rexs.read_rexs`.
    load_case
        Id of the one to take; by default the whole load spectrum, where one factor of load and one
        of speed part its load cases, else the first.

    Raises
    ------
    FileError
        If a number or a unit is none, components refer to each other in a circle, or there is no
        such load case.
    InputError
        If what is there makes no machine: no shaft, or no bearing.
    """
    reader = _Reader(model, load_case)
    plain_parts = reader.parts()
    parts = list(reader.restored(plain_parts))
    if not any(part.kind == "shafts" for part in parts):
        raise InputError(said("has no shaft with sections, of which a machine is made"))
    try:
        machine = Machine.from_mapping(_assembled(parts))
    except InputError:
        if not reader.was_changed:
            raise
        parts = plain_parts  # parts that do not go together with what was changed
        machine = Machine.from_mapping(_assembled(parts))
    counts: dict[str, int] = {}
    names: dict[int, list[str]] = {}
    for part in parts:
        if part.kind != "machine":
            place = counts.get(part.kind, -1) + 1
            counts[part.kind] = place
            names.setdefault(part.component, []).append(f"{part.kind}.{place}")
    taken = tuple(
        Taken(one.id, one.type, one.name, ", ".join(names.get(one.id, ())), used)
        for one in model.components
        if (used := tuple(reader.used.get(one.id, ()))) or one.id in names
    )
    reader.name_what_is_left()
    return Imported(machine, model.version, model.application, taken, tuple(reader.remarks))


def parts_of(model: RexsModel) -> list[Part]:
    """Return the parts of a machine as any reader of REXS finds them, without Rolamento's own."""
    return _Reader(model, None).parts()


def _assembled(parts: Iterable[Part]) -> dict[str, Any]:
    mapping: dict[str, Any] = {}
    for part in parts:
        if part.kind == "machine":
            mapping.update(part.table)
        else:
            mapping.setdefault(part.kind, []).append(part.table)
    return mapping


class _Reader(BearingReader, LoadReader, GearReader, Restorer):
    """Reads a model once."""

    def parts(self) -> list[Part]:
        """Return the parts of the machine, as any reader finds them."""
        if not self.model.version.startswith(("1.", "2.0")):
            self._note("left", None, "rexs_version", version=self.model.version[:20])
        self._check_counts()
        self._check_relations()
        shafts = self._read_shafts()
        bearings = list(self._read_bearings())
        springs = list(self._read_springs())
        loads, gears = list(self._read_loads()), list(self._read_gears())
        masses = list(self._read_masses())
        units = list(self.model.of_type("gear_unit"))
        head = self._read_head(units[0] if units else None)
        return [
            Part("machine", units[0].id if units else 0, head),
            *shafts, *bearings, *springs, *loads, *gears, *masses,
        ]  # fmt: skip

    def _check_counts(self) -> None:
        counts = Counter(one.type for one in self.model.components)
        for types, most in _MOST:
            count = sum(counts[name] for name in types)
            if count > most:
                raise FileError(
                    said("is there {count} times; a machine has at most {most}",
                         count=count, most=most),
                    field=types[0],
                )  # fmt: skip

    def _check_relations(self) -> None:
        missing: set[int] = set()
        for relation in self.model.relations:
            for ref in relation.refs:
                if ref.id not in self.model.by_id and ref.id not in missing:
                    missing.add(ref.id)
                    self._note(
                        "left", None, "rexs_missing_component", relation=relation.id, id=ref.id
                    )

    @property
    def was_changed(self) -> bool:
        """Whether another program has changed what Rolamento had written."""
        return any(one.note.key == "rexs_changed" for one in self.remarks)

    def name_what_is_left(self) -> None:
        """Note components and attributes that nobody read, those of a type together."""
        others: dict[str, list[Component]] = {}
        unread: dict[str, dict[str, None]] = {}
        read: dict[str, set[str]] = {}
        for one in self.whole.components:
            read.setdefault(one.type, {CUSTOM, DIGEST}).update(self.used.get(one.id, ()))
        for one in self.whole.components:
            if one.type not in _READ and one.type not in _SILENT:
                others.setdefault(one.type, []).append(one)
            elif one.type in _READ:
                left = [
                    name
                    for name in one.attributes
                    if name not in read[one.type] and not _is_result(name)
                ]
                if left:
                    unread.setdefault(one.type, {}).update(dict.fromkeys(left))
        if any(_is_result(name) for one in self.whole.components for name in one.attributes):
            self._note("left", None, "rexs_results_left")
        if self.whole.application == APPLICATION and not self.was_changed:
            return  # what nobody read stands in its own attributes
        for kind, found in others.items():
            self.remarks.append(
                Remark("left", None, Note("rexs_components_left", {
                    "type": kind, "count": len(found),
                    "ids": ", ".join(str(one.id) for one in found[:20]),
                }))
            )  # fmt: skip
        for kind, names in unread.items():
            self.remarks.append(
                Remark("left", None, Note("rexs_attributes_left", {
                    "type": kind, "attributes": ", ".join(sorted(names)),
                }))
            )  # fmt: skip


def _is_result(name: str) -> bool:
    """Whether an attribute holds what a program calculated."""
    results = words()["results"]
    return name.startswith(tuple(results["begin"])) and name not in results["inputs"]
