"""What solving returns: one result for one case and for a million."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from functools import cached_property
from math import isfinite
from typing import TYPE_CHECKING, Any, Final, TypeVar

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.case import lubricant_of
from rolamento.case.duty import AXES, LOADS
from rolamento.errors import FileError, InputError, UnknownKeyError, nearest
from rolamento.geometry import Angle, Race
from rolamento.io.json import dumps, plain
from rolamento.io.text import format_of_path, format_of_text, parse_mapping, read_text
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solved.form import EXAMPLE, SCHEMA, ReadAnswer, mapping_of, part_of, pieces_of
from rolamento.solved.notes import advice_on, notes_on
from rolamento.solved.rollers import Rollers
from rolamento.solved.tables import (
    CONTACT_COLUMNS,
    ELEMENT_COLUMNS,
    MORE_COLUMNS,
    RACES,
    Answer,
    Contacts,
    Elements,
    Index,
    IntArray,
    Loaded,
    Preloading,
    Pressed,
    Refusals,
    RingDisplacement,
    RingLoad,
    Rolling,
    Rows,
    Status,
    Stiffness,
    Tables,
    taken,
)
from rolamento.status import INVALID_INPUT
from rolamento.types import BALL
from rolamento.words import Note, said

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from rolamento.oil.state import OilState

NO_LOAD: Final = 1e-9
"""Fraction of the load at the other race: what is less is rounding, and no contact."""

ROOM_TEMPERATURE: Final = 293.15
"""K, of an oil whose temperature is not known."""

T = TypeVar("T")


@frozen(eq=False)
class Delivered:
    """A bearing before fits, heat and speed have changed it.

    Attributes
    ----------
    case
        with its mounting
    contact_angle
        nominal, 0 of rows given by their clearance; (cases, rows), rad
    inner_conformity, outer_conformity
        of the grooves, NaN of rollers; (cases, rows)
    """

    case: Case
    contact_angle: FloatArray
    inner_conformity: FloatArray
    outer_conformity: FloatArray


@frozen(eq=False, slots=False)
class Solved:
    """Equilibria of many cases of a bearing; one case is a batch of one.

    Attributes
    ----------
    case
        what was solved
    varied
        what varied from it, by the dotted names of the fields; (cases,) each
    status
        whether and how each case was solved
    displacement
        of the inner ring
    load
        that the shaft puts on the inner ring: given loads, and the reactions of what is held
    stiffness
        ``stiffness["fz", "z"]``, or its `array`
    rows
        of rolling elements: one, unless the bearing is a set
    before_mounting
        the bearing as it is delivered, which standards rate; None without a mounting
    refusals
        of many cases, the rules that those with the status "invalid_input" violate; see `advice`
    preloading
        the `preload`, or how to find it
    """

    case: Case
    varied: Mapping[str, FloatArray]
    status: Status
    displacement: RingDisplacement
    load: RingLoad
    stiffness: Stiffness
    rows: Rows
    answer: Answer
    before_mounting: Delivered | None = None
    refusals: Refusals | None = None
    preloading: Preloading | Callable[[], Preloading | None] | None = None
    first_notes: tuple[Note, ...] = ()
    """Notes before those on the equilibrium: the clearance in operation."""
    written_notes: tuple[tuple[Note, ...], ...] | None = None
    written_advice: tuple[Note | None, ...] | None = None
    """Advice of a result that was read: what was said of it then."""

    # --- cases ----------------------------------------------------------------------------------

    @property
    def delivered_case(self) -> Case:
        """The case with its bearing as the maker delivers it, by which standards rate it."""
        return self.case if self.before_mounting is None else self.before_mounting.case

    def case_at(self, index: int) -> Case:
        """Return one of the cases with what varied put in: solved alone, it gives this result."""
        return self.case.with_({name: float(values[index]) for name, values in self.varied.items()})

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.status.number)

    def __getitem__(self, index: int | slice | NDArray[Any] | list[Any]) -> Solved:
        """Return some of the cases, as a result of its own."""
        some: Index
        if isinstance(index, int | np.integer):
            if not -len(self) <= index < len(self):
                raise IndexError(f"case {index} of {len(self)}")
            some = slice(int(index), int(index) + 1 or None)
        else:
            some = index if isinstance(index, slice) else np.asarray(index)
        return replace(
            self,
            varied={name: values[some] for name, values in self.varied.items()},
            status=taken(self.status, some),
            displacement=RingDisplacement(*(axis[some] for axis in self.displacement)),
            load=RingLoad(*(part[some] for part in self.load)),
            stiffness=Stiffness(self.stiffness.array[some]),
            rows=taken(self.rows, some, shared=("sign", "element_count", "element")),
            answer=self.answer.part(some),
            refusals=None if self.refusals is None else self.refusals.part(some),
            before_mounting=None
            if self.before_mounting is None
            else taken(self.before_mounting, some, shared=("case",)),
            preloading=vars(self).get("preload", self.preloading),
            written_notes=_chosen(self.written_notes, some),
            written_advice=_chosen(self.written_advice, some),
        )

    @property
    def title(self) -> str:
        """The title of the case."""
        return self.case.title

    @property
    def converged(self) -> BoolArray:
        """Whether each case has a result; (cases,)."""
        return self.status.converged

    @cached_property
    def preload(self) -> Preloading | None:
        """How the rows of a set press on each other, of a single case; else None.

        Some twenty solutions more are needed: it is found when it is first asked for.
        """
        return self.preloading() if callable(self.preloading) else self.preloading

    def field(self, name: str) -> FloatArray:
        """A field of the cases, whether it varied or not, by its dotted name; (cases,), SI.

        NaN where the case does not have it. Where a value made a case invalid, the case's own
        number stands instead, or 1: nothing that follows has a result there.

        Raises
        ------
        UnknownKeyError
            If a case has no such number.
        """
        value: Any = self.case
        for part in name.split("."):
            if value is not None and not hasattr(value, part):
                near = nearest(name, self.varied) or "duty.inner_speed"
                raise UnknownKeyError(
                    said("is not a quantity of the case"),
                    field=name,
                    example=f'solved.field("{near}")',
                )
            value = None if value is None else getattr(value, part)
        own = float("nan") if value is None else float(value)
        given = self.varied.get(name)
        if given is None:
            return np.full(len(self), own)
        invalid = self.status.number == INVALID_INPUT
        return np.where(invalid, own if isfinite(own) else 1.0, given)

    # --- tables ---------------------------------------------------------------------------------

    @cached_property
    def _tables(self) -> Tables:
        return self.answer.tables()

    @property
    def elements(self) -> Elements:
        """Every rolling element of every case."""
        return self._tables.elements

    @cached_property
    def contacts(self) -> Mapping[Race, Contacts]:
        """The contacts by race."""
        rows, rollers, races = self.rows, self.rollers, {}
        shared = {
            "ball_diameter": rows.per_element(rows.ball_diameter),
            "pitch_diameter": rows.per_element(rows.pitch_diameter),
            "modulus": rows.per_element(rows.modulus),
            "effective_length": rows.per_element(rows.effective_length),
        }
        for race in RACES:
            pressed: Pressed = getattr(self._tables, race)
            races[race] = Contacts(
                race=race,
                load=pressed.load,
                angle=pressed.angle,
                deflection=pressed.deflection,
                approach=pressed.approach,
                spin=pressed.spin,
                roll=pressed.roll,
                conformity=rows.per_element(getattr(rows, f"{race}_conformity")),
                ring_poisson_ratio=self.case.bearing.ring_material.poisson_ratio,
                ring_speed=self.field(f"duty.{race}_speed")[:, np.newaxis],
                elements=self.elements,
                line=None if rollers is None else getattr(rollers, race),
                **shared,
            )
            if isinstance(self.answer, ReadAnswer):  # as they were written, to the last bit
                vars(races[race]).update(self.answer.kept[race])
        return races

    @property
    def inner(self) -> Contacts:
        """The contacts with the inner race."""
        return self.contacts["inner"]

    @property
    def outer(self) -> Contacts:
        """The contacts with the outer race."""
        return self.contacts["outer"]

    @cached_property
    def oil(self) -> OilState:
        """The oil, or the base oil of the grease, at its temperature; NaN of dry lubrication.

        Raises
        ------
        InputError
            If the case has no lubricant.
        """
        from rolamento.oil.state import OilState, oil_state

        lubricant = lubricant_of(self.case)
        given = self.field("temperature.lubricant")
        temperature = np.where(given > 1.0, given, ROOM_TEMPERATURE)  # 1: of one that is not valid
        if lubricant.kind != "dry":
            return oil_state(lubricant, temperature)
        nothing = np.full_like(temperature, np.nan)
        return OilState(temperature, nothing, nothing, nothing, nothing, nothing, float("nan"))

    def pressed_on(self, race: Race) -> tuple[FloatArray, Angle]:
        """Return load and angle of the contacts with a race, alone; (cases, elements), N and rad.

        Where nobody has asked for the tables, rows that can leave out how their elements move.
        """
        if "_tables" not in vars(self) and isinstance(self.answer, Loaded):
            return self.answer.pressed_on(race)
        contacts = self.contacts[race]
        return contacts.load, contacts.angle

    @property
    def rolling(self) -> Rolling | None:
        """How friction moves the elements, where nothing else does; else None."""
        return self._tables.rolling

    @property
    def rollers(self) -> Rollers | None:
        """The rollers, slice by slice; None of a bearing that has balls only."""
        return self._tables.rollers

    @cached_property
    def relative_speed(self) -> FloatArray:
        """Speed of the rings against each other, without a sign; (cases,), rad/s."""
        return np.abs(self.field("duty.inner_speed") - self.field("duty.outer_speed"))

    @cached_property
    def are_rollers(self) -> BoolArray:
        """Which elements are rollers; (elements,)."""
        rollers = np.array([element != BALL for element in self.rows.element])
        return np.asarray(rollers[self.rows.row_of_element])

    @cached_property
    def balls_bear(self) -> BoolArray:
        """Whether an element is a ball that bears on both races; (cases, elements)."""
        return self._bear & ~self.are_rollers

    @cached_property
    def rollers_bear(self) -> BoolArray:
        """Whether an element is a roller that bears on both races; (cases, elements)."""
        return self._bear & self.are_rollers

    @cached_property
    def _bear(self) -> BoolArray:
        with np.errstate(invalid="ignore"):
            return np.asarray(self.loaded & (self._tables.outer.load > 0.0))

    @cached_property
    def loaded(self) -> BoolArray:
        """Whether an element bears on the inner race; (cases, elements)."""
        inner, outer = self._tables.inner, self._tables.outer
        with np.errstate(invalid="ignore"):
            return np.asarray(inner.load > NO_LOAD * outer.load)

    @cached_property
    def loaded_elements(self) -> IntArray:
        """Number of loaded elements in each row, (cases, rows)."""
        return np.add.reduceat(self.loaded.astype(np.int64), self.rows.starts, axis=1)

    # --- what is said of it ---------------------------------------------------------------------

    @cached_property
    def notes(self) -> tuple[tuple[Note, ...], ...]:
        """What to know about each case; a tuple over cases of tuples."""
        if self.written_notes is not None:
            return self.written_notes
        if len(self) == 1:
            return ((*self.first_notes, *notes_on(self)),)
        return tuple(self[case].notes[0] for case in range(len(self)))

    @cached_property
    def advice(self) -> tuple[Note | None, ...]:
        """Why each case has no result and what a person can do; None where there is one.

        Of an "invalid_input" the field, the value and the rule that it violates.
        """
        if self.written_advice is not None:
            return self.written_advice
        found: list[Note | None] = [None] * len(self)
        for case in np.flatnonzero(~self.converged).tolist():
            found[case] = advice_on(self, case)
        return tuple(found)

    def __repr__(self) -> str:
        """Say in some ten lines what was solved and what came out."""
        return "\n".join(_summary(self))

    def _repr_html_(self) -> str:
        from html import escape

        lines = (line.partition(":") for line in _summary(self)[1:])
        cells = "".join(
            f"<tr><th>{escape(name.strip())}</th><td>{escape(value.strip())}</td></tr>"
            for name, _, value in lines
        )
        return f"<table><caption>{escape(_summary(self)[0])}</caption>{cells}</table>"

    # --- out and back ---------------------------------------------------------------------------

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain mappings and lists in SI units, NaN as None."""
        return mapping_of(self if len(self) == 1 else self[case])

    def part(self, name: str) -> Any:
        """Give one part of the mapping of a single case by its key, such as ``"stiffness"``.

        Of those that need no tables of the elements.
        """
        return part_of(self, name)

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give a single case, or all under "states" with what varied, as a JSON object in SI."""
        return dumps(self.whole_mapping(), indent)

    def whole_mapping(self) -> dict[str, Any]:
        """Give what `to_json` writes, as plain mappings and lists; `from_mapping` reads it."""
        mapping: dict[str, Any] = self.to_mapping() if len(self) == 1 else {"schema": SCHEMA}
        if len(self) != 1:
            states = [self.to_mapping(case) for case in range(len(self))]
            mapping["case"] = self.case.to_mapping()
            mapping["states"] = [{k: v for k, v in s.items() if k != "case"} for s in states]
        if self.varied:
            mapping["varied"] = {name: plain(v.tolist()) for name, v in self.varied.items()}
        return mapping

    @classmethod
    def from_mapping(cls, mapping: Mapping[str, Any]) -> Solved:
        """Read what `to_json` wrote, parsed: every number as it was written.

        Raises
        ------
        FileError
            If this is no result at all, or one of another schema.
        InputError
            If a key is missing or not what it should be.
        """
        case, varied, pieces = pieces_of(mapping)
        parts = {part.name: getattr(pieces, part.name) for part in fields(pieces)}
        return cls(case=case, varied=varied, **parts)

    @classmethod
    def from_json(cls, text: str) -> Solved:
        """Read what `to_json` wrote.

        Raises
        ------
        FileError, InputError
            As `from_mapping`, and if this is not JSON.
        """
        return cls.from_mapping(parse_mapping(text, "json", "<text>"))

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Solved:
        """Read the JSON that ``rolamento solve --json`` wrote; ``"-"`` is standard input.

        Raises
        ------
        FileError, InputError
            As `from_json`, and if the file cannot be read.
        """
        text, source = read_text(path)
        if (format_of_path(path) or format_of_text(text)) != "json":
            raise FileError(
                said("is not the JSON of a solved state; solve a case first"),
                source=source,
                example=EXAMPLE,
            )
        try:
            return cls.from_mapping(parse_mapping(text, "json", source))
        except InputError as error:
            raise error if error.source else error.with_details(source=source) from None

    def to_xarray(self) -> xr.Dataset:
        """Give everything as a dataset over case, element and degree of freedom; SI."""
        import xarray as xr

        data: dict[str, Any] = {
            "status": ("case", self.status.code),
            "residual": ("case", self.status.residual),
            "stiffness": (("case", "load", "axis"), self.stiffness.array),
        }
        data |= {name: ("case", values) for name, values in self.varied.items()}
        for part in (self.displacement, self.load):
            data |= {name: ("case", values) for name, values in part._asdict().items()}
        data |= {name: (("case", "element"), v) for name, v in self._element_columns().items()}
        for race, contacts in self.contacts.items():
            columns = {name: getattr(contacts, name) for name in (*CONTACT_COLUMNS, *MORE_COLUMNS)}
            data |= {f"{race}_{name}": (("case", "element"), v) for name, v in columns.items()}
        coordinates = {
            "row": ("element", self.elements.row), "axis": list(AXES), "load": list(LOADS)
        }  # fmt: skip
        return xr.Dataset(data, coordinates, {"title": self.title})

    def to_pandas(self, table: str = "cases") -> pd.DataFrame:
        """Give one table as a data frame; SI.

        Parameters
        ----------
        table
            ``"cases"``: what varied, status, displacement and load, a line a case;
            ``"elements"`` or ``"contacts"``: a line for each, with its case and row.

        Raises
        ------
        InputError
            For another table.
        """
        import pandas as pd

        if table == "cases":
            columns = {**self.varied, "status": self.status.code}
            return pd.DataFrame(
                {**columns, **self.displacement._asdict(), **self.load._asdict()}
            ).rename_axis("case")
        if table not in ("elements", "contacts"):
            raise InputError(
                said("must be cases, elements or contacts"),
                field="table",
                value=table,
                example='solved.to_pandas("contacts")',
            )
        cases, elements = self.elements.azimuth.shape
        place = {
            "case": np.repeat(np.arange(cases), elements),
            "element": np.tile(np.arange(elements), cases),
            "row": np.tile(self.elements.row, cases),
        }
        if table == "elements":
            own = {name: values.ravel() for name, values in self._element_columns().items()}
            return pd.DataFrame({**place, **own})
        frames = []
        for race, contacts in self.contacts.items():
            own = {
                name: getattr(contacts, name).ravel() for name in (*CONTACT_COLUMNS, *MORE_COLUMNS)
            }
            frames.append(pd.DataFrame({**place, "race": race, **own}))
        return pd.concat(frames, ignore_index=True)

    def _element_columns(self) -> dict[str, FloatArray]:
        return {name: getattr(self.elements, name) for name in (*ELEMENT_COLUMNS, "yaw")}


def _chosen(items: tuple[T, ...] | None, index: Index) -> tuple[T, ...] | None:
    """Some of the items, by an index of an array."""
    return None if items is None else tuple(items[i] for i in np.arange(len(items))[index])


def _summary(solved: Solved) -> list[str]:
    """Ten lines at most, each a name and what it is."""
    count = len(solved)
    names, counts = np.unique(solved.status.code, return_counts=True)
    status = ", ".join(
        f"{name} {n}" if count > 1 else name for name, n in zip(names, counts, strict=True)
    )
    lines = [
        f"Solved: {solved.title or 'a case without a title'}",
        f"  cases: {count}, {status or 'none'}",
        f"  elements: {' + '.join(map(str, solved.rows.element_count))} "
        f"in {len(solved.rows)} {'row' if len(solved.rows) == 1 else 'rows'}",
    ]
    if solved.varied:
        lines.append(f"  varied: {', '.join(solved.varied)}")
    if not solved.converged.any():
        return lines
    units = dict(
        zip(
            (*AXES, *LOADS), ["m", "m", "m", "rad", "rad", "N", "N", "N", "N·m", "N·m"], strict=True
        )
    )
    for name, part in (("displacement", solved.displacement), ("load", solved.load)):
        shown = (
            f"{axis} {_range(values)} {units[axis]}" for axis, values in part._asdict().items()
        )
        lines.append(f"  {name}: {', '.join(shown)}")
    for race, contacts in solved.contacts.items():
        pressure = np.nanmax(contacts.max_pressure[solved.converged], axis=1)
        load = np.nanmax(contacts.load[solved.converged], axis=1)
        lines.append(f"  maximum at the {race} race: {_range(load)} N, {_range(pressure)} Pa")
    if count == 1 and solved.notes[0]:
        lines.append(f"  notes: {len(solved.notes[0])}, in .notes")
    return lines


def _range(values: FloatArray) -> str:
    known = values[np.isfinite(values)]
    if not len(known):
        return "nan"
    low, high = known.min(), known.max()
    return f"{low:.4g}" if len(known) == 1 or low == high else f"{low:.4g} to {high:.4g}"


def refuse_other(given: object, function: str) -> None:
    """Refuse what is not a result, in the words that all laws share.

    Raises
    ------
    InputError
        If it is not a `Solved`.
    """
    if not isinstance(given, Solved):
        raise InputError(
            said("must be the result of rolamento.solve"),
            field="solved",
            value=type(given).__name__,
            example=f"{function}(rolamento.solve(case))",
        )
