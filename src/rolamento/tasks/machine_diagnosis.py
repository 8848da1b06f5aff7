"""A machine with several bearings, shafts and gears, tested together by one record."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

from rolamento.case import case_of
from rolamento.case.case import BearingLike
from rolamento.case.machine import Machine as ShaftsMachine
from rolamento.case.machine import parse_machine
from rolamento.errors import InputError, arguments, nearest
from rolamento.io.text import format_of_path, format_of_text, parse_mapping, read_text
from rolamento.records import frozen
from rolamento.tasks.diagnosis import (
    Concluded,
    Conclusion,
    DiagnosisResult,
    diagnose,
)
from rolamento.units import rpm_of
from rolamento.vibration.diagnosis import Component, FaultOrders
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.words import Note, said

if TYPE_CHECKING:
    from rolamento.document import Document

__all__ = ["Machine", "MachineDiagnosis", "Mounted", "diagnose_machine", "read_machine"]

_MOST: Final = 20
_SAME: Final = 0.004
"""Part of a frequency within which the peaks of two bearings are one."""
_SLOWEST, _FASTEST = 0.01, 1000.0
"""Orders that a diagnosis looks at."""
_LONGEST_NAME: Final = 60
_MAIN: Final = "main"
"""Name of the shaft whose speed is given."""
_KEYS: Final[Mapping[str, frozenset[str]]] = {
    "bearings": frozenset({"name", "designation", "shaft"}),
    "shafts": frozenset({"name", "ratio"}),
    "gears": frozenset({"teeth", "shaft"}),
}


@frozen
class Mounted:
    """A bearing of a machine.

    Attributes
    ----------
    name
        in the machine, such as "motor, drive end"
    bearing
        designation of the catalogue, case file, or case
    ratio
        speed of its shaft over that of the main one
    outer_ratio
        likewise of its outer ring; 0 in a housing
    """

    name: str
    bearing: BearingLike
    ratio: float
    outer_ratio: float = 0.0

    def orders(self) -> tuple[float, ...]:
        """Return the orders of its faults over the main shaft."""
        bearing = case_of(self.bearing).bearing
        found = FaultOrders.of(nominal_frequencies(bearing, self.ratio, self.outer_ratio))
        own = (found.fundamental(part) for part in ("outer_race", "inner_race", "ball"))
        return tuple(abs(self.turn) * order for order in own if order is not None)

    @property
    def turn(self) -> float:
        """Speed of the ring that turns, the inner one if both do, over the main shaft's."""
        return self.ratio or self.outer_ratio


@frozen
class Machine:
    """What turns in a machine.

    Attributes
    ----------
    bearings
        that are tested
    shafts
        speeds of the other shafts over that of the main one, by name
    meshes
        teeth that mesh in a turn of the main shaft, of each gear
    speed
        of the main shaft, rad/s; None if the file is silent
    """

    bearings: tuple[Mounted, ...]
    shafts: Mapping[str, float]
    meshes: tuple[float, ...]
    speed: float | None = None

    def turning(self, ratio: float) -> tuple[float, ...]:
        """Return the orders, over a shaft of some ratio, of all else that turns."""
        orders = (*self.shafts.values(), 1.0, *self.meshes)
        own = (abs(order / ratio) for order in orders if order != ratio)
        return tuple(dict.fromkeys(order for order in own if _SLOWEST <= order <= _FASTEST))[:_MOST]


def read_machine(path: str | os.PathLike[str]) -> Machine:
    """Read the file of a machine: ``[[bearings]]``, ``[[shafts]]`` and ``[[gears]]``.

    Either the few keys that a diagnosis needs, or a machine file of `rolamento shaft`, whose first
    shaft that turns is the main one.

    Raises
    ------
    FileError
        If it cannot be read, is larger than 1 MB, or is not TOML or JSON.
    InputError
        If a shaft is not known or named twice, or a number is none; or as `case.load_machine`.
    """
    text, source = read_text(path)
    text_format = format_of_path(path) or format_of_text(text)
    mapping = parse_mapping(text, text_format, source)
    if _has_sections(mapping):
        folder = os.path.dirname(os.fspath(path))
        return _of_shafts(parse_machine(text, format=text_format, source=source, folder=folder))
    try:
        return _machine(mapping)
    except InputError as error:
        raise error.with_details(source=source) from None


def _has_sections(mapping: Mapping[str, Any]) -> bool:
    """Whether it is a file for shafts that bend."""
    shafts = mapping.get("shafts")
    rows = shafts if isinstance(shafts, list) else []
    return any(isinstance(row, dict) and "sections" in row for row in rows)


def _of_shafts(machine: ShaftsMachine) -> Machine:
    """What turns in a machine whose shafts are described whole."""
    speeds = {shaft.name: machine.speed(shaft.name) for shaft in machine.shafts}
    main = next((name for name, speed in speeds.items() if speed), None)
    if main is None:
        raise InputError(
            said("must turn, at least one of them"),
            field="shafts.0.speed",
            example='speed = "1480 rpm"',
        )
    ratios = {name: speed / speeds[main] for name, speed in speeds.items()}
    mounted = (
        Mounted(
            one.name,
            one.case,
            ratios[one.shaft],
            0.0 if one.outer_shaft is None else ratios[one.outer_shaft],
        )
        for one in machine.bearings
    )
    meshes = (
        gear.teeth * abs(ratios[gear.shaft]) for gear in machine.gears if gear.teeth is not None
    )
    return Machine(
        bearings=tuple(one for one in mounted if one.ratio != one.outer_ratio),
        shafts={name: ratio for name, ratio in ratios.items() if name != main},
        meshes=tuple(dict.fromkeys(meshes)),
        speed=abs(speeds[main]),
    )


def _machine(data: Mapping[str, Any]) -> Machine:
    for table in data:
        if table not in _KEYS:
            raise InputError(
                said("is not known"), field=table, example=f"[[{nearest(table, _KEYS) or 'gears'}]]"
            )
    rows = {table: _rows(data, table) for table in _KEYS}
    if not rows["bearings"]:
        raise InputError(
            said("must name at least one"),
            field="bearings",
            example='[[bearings]]\ndesignation = "6205"',
        )
    shafts: dict[str, float] = {}
    ratios = {_MAIN: 1.0}
    for row in rows["shafts"]:
        name, ratio = _text(row, "name"), _number(row, "ratio")
        if name in ratios:
            raise InputError(said("is already a shaft"), field="name", value=name)
        shafts[name] = ratios[name] = ratio
    bearings = tuple(
        Mounted(
            _text(row, "name") if "name" in row else f"{place} {_text(row, 'designation')}",
            _text(row, "designation"),
            _ratio(row, ratios),
        )
        for place, row in enumerate(rows["bearings"], start=1)
    )
    meshes = tuple(_number(row, "teeth") * _ratio(row, ratios) for row in rows["gears"])
    return Machine(bearings, shafts, meshes)


def _rows(data: Mapping[str, Any], table: str) -> Sequence[Mapping[str, Any]]:
    rows = data.get(table, [])
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise InputError(said("must be a list of tables"), field=table, example=f"[[{table}]]")
    if len(rows) > _MOST:
        raise InputError(said("must be at most {most}", most=_MOST), field=table, value=len(rows))
    for row in rows:
        for key in row.keys() - _KEYS[table]:
            raise InputError(
                said("is not known; known: {known}", known=", ".join(sorted(_KEYS[table]))),
                field=f"{table}.{key}",
            )
    return rows


def _text(row: Mapping[str, Any], key: str) -> str:
    value = row.get(key)
    if not isinstance(value, str) or not value.strip():
        raise InputError(said("must be text"), field=key, value=value, example=f'{key} = "6205"')
    if len(value) > _LONGEST_NAME:
        rule = said("must be at most {max_length} characters long", max_length=_LONGEST_NAME)
        raise InputError(rule, field=key, value=value)
    return value


def _number(row: Mapping[str, Any], key: str) -> float:
    value = row.get(key)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if value is None or not is_number or not 0.01 <= value <= 1000.0:
        rule = said("must be a number from 0.01 to 1000")
        raise InputError(rule, field=key, value=value, example=f"{key} = 31")
    return float(value)


def _ratio(row: Mapping[str, Any], ratios: Mapping[str, float]) -> float:
    name = row.get("shaft", _MAIN)
    if not isinstance(name, str) or name not in ratios:
        raise InputError(
            said("is none of the shafts: {known}", known=", ".join(ratios)),
            field="shaft",
            value=name,
        )
    return ratios[name]


# --- the diagnosis -------------------------------------------------------------------------------


@frozen(eq=False, slots=False)
class MachineDiagnosis(Concluded):
    """Every bearing of a machine, by one record.

    Attributes
    ----------
    machine
        as given
    found
        a diagnosis for each bearing, in its order
    shared
        pairs of damaged parts of different bearings that have the same peak: bearing's place and
        part of each; the peak decides between neither
    """

    machine: Machine
    found: tuple[DiagnosisResult, ...]
    shared: tuple[tuple[tuple[int, Component], tuple[int, Component]], ...]

    def alone(self, place: int) -> tuple[Component, ...]:
        """Return the damaged parts of a bearing whose peaks no other bearing shares."""
        of_both = {one for pair in self.shared for one in pair}
        faults = self.found[place].faults
        return tuple(part for part in faults if (place, part) not in of_both)

    @property
    def verdict(self) -> Conclusion:
        """Verdict of the worst bearing: one part that is damaged alone is a fault."""
        places = range(len(self.found))
        if any(self.alone(place) for place in places):
            return "fault"
        verdicts = [one.verdict for one in self.found]
        if self.shared or "undecided" in verdicts:
            return "undecided"
        worst: tuple[Conclusion, ...] = ("watch", "no_verdict", "nothing_found")
        return next(one for one in worst if one in verdicts)

    @property
    def statement(self) -> tuple[Note, ...]:
        """What it comes to, bearing by bearing."""
        notes = []
        for (first, part), (second, other) in self.shared:
            named = [self.machine.bearings[place].name for place in (first, second)]
            frequency = self.found[first].diagnosis.of(part).frequency
            values = {"bearings": named, "parts": [part, other], "frequency": frequency}
            notes.append(Note("peak_of_either", values))
        of_both = {one for pair in self.shared for one in pair}
        for place, (bearing, one) in enumerate(zip(self.machine.bearings, self.found, strict=True)):
            faults = one.faults
            if faults and all((place, part) in of_both for part in faults):
                continue
            notes += [Note("of_bearing", {"name": bearing.name}), *one.statement]
        return tuple(notes)

    def page(self) -> Document:
        """Return what people read of it."""
        from rolamento.pages.history import machine_page

        return machine_page(self)

    def to_mapping(self) -> dict[str, Any]:
        """Return everything as plain data, in SI units and Hz."""
        return {
            **self._head("diagnosis_machine"),
            "shared": [
                [
                    {"bearing": self.machine.bearings[place].name, "component": part}
                    for place, part in pair
                ]
                for pair in self.shared
            ],
            "bearings": [
                {"name": bearing.name, "ratio": bearing.ratio, **one.to_mapping()}
                for bearing, one in zip(self.machine.bearings, self.found, strict=True)
            ],
        }


def diagnose_machine(
    path: str | os.PathLike[str], machine: Machine | str | os.PathLike[str], **inputs: Any
) -> MachineDiagnosis:
    """Diagnose all bearings of a machine by one record.

    The other shafts and the meshes of the gears are left out of the search for each bearing, and
    the frequencies of the other bearings are no unexplained peaks. Where damaged parts of two
    bearings have the same peak, neither is stated.

    Parameters
    ----------
    path, inputs
        As of `rolamento.tasks.diagnose`; the speed is that of the main shaft, and steady.
    machine
        Or the name of its file.

    Raises
    ------
    FileError, InputError
        As of `rolamento.tasks.diagnose`, or if the machine's file is none.
    """
    from rolamento.tasks.parameters import speed_of

    if not isinstance(machine, Machine):
        machine = read_machine(machine)
    speed = speed_of(inputs.pop("speed", None), "speed") or machine.speed
    if speed is None:
        raise InputError(
            said("must be given with a machine: that of its main shaft"),
            field="speed",
            example=arguments(speed="1480 rpm"),
        )
    orders = [one.orders() for one in machine.bearings]
    found = []
    for place, bearing in enumerate(machine.bearings):
        others = tuple(
            order / abs(bearing.turn)
            for number, own in enumerate(orders)
            if number != place
            for order in own
        )
        speeds = [f"{rpm_of(speed * ratio)} rpm" for ratio in (bearing.ratio, bearing.outer_ratio)]
        one = diagnose(
            path,
            bearing.bearing,
            speed=speeds[0],
            outer_speed=speeds[1] if bearing.outer_ratio else None,
            turning=machine.turning(bearing.turn),
            elsewhere=others,
            **inputs,
        )
        found.append(replace(one, bearing_name=f"{bearing.name} ({one.bearing_name})"))
    return MachineDiagnosis(machine, tuple(found), _shared(found))


def _shared(
    found: Sequence[DiagnosisResult],
) -> tuple[tuple[tuple[int, Component], tuple[int, Component]], ...]:
    """Pairs of damaged parts of different bearings with the same peak."""
    damaged: list[tuple[int, Component, float]] = [
        (place, part, one.diagnosis.of(part).frequency)
        for place, one in enumerate(found)
        for part in one.faults
    ]
    return tuple(
        ((first[0], first[1]), (second[0], second[1]))
        for number, first in enumerate(damaged)
        for second in damaged[number + 1 :]
        if first[0] != second[0] and abs(second[2] / first[2] - 1.0) <= _SAME
    )
