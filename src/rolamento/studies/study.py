"""A study: a case or a machine, what varies in it, the outputs of each case; and its file."""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Final, Self

from pydantic import (
    AfterValidator,
    Field,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    model_serializer,
    model_validator,
)

from rolamento.case import Case, is_designation, load_case
from rolamento.case.fields import Changes, read_changed
from rolamento.case.former import OUTPUTS, current
from rolamento.case.machine import (
    Machine,
    machine_reader,
    parts_of_key,
    with_settings,
    with_values,
)
from rolamento.case.machine_files import with_files
from rolamento.case.quantity import AT_THE_BORDER, Count, Line
from rolamento.case.record import Record
from rolamento.case.variant import Variant, with_the_case
from rolamento.errors import InputError
from rolamento.io.text import (
    STANDARD_INPUT,
    LineIndex,
    TextFormat,
    format_of_path,
    format_of_text,
    line_of,
    lines_of_keys,
    parse_mapping,
    read_text,
    text_of_mapping,
)
from rolamento.studies import fields
from rolamento.studies.axes import Axis
from rolamento.studies.machine_outputs import DEFAULT_OF_MACHINE, in_files
from rolamento.studies.of_case import OfCase
from rolamento.studies.of_machine import OfMachine
from rolamento.studies.outputs import DEFAULT_OUTPUTS, Output
from rolamento.studies.scatter import MOST_CASES, Scatter
from rolamento.studies.subject import Subject
from rolamento.words import said

SAMPLE: Final = "sample"
"""The dimension of scatter."""
VARIANT: Final = "variant"
"""The dimension of variants."""

_RESERVED: Final = (SAMPLE, VARIANT, "status", "ball", "row", "case")
_MOST_AXES: Final = 8
_OutputName = Annotated[
    str, Field(strict=True, max_length=100), AfterValidator(lambda name: current(name, OUTPUTS))
]
_MOST_OUTPUTS: Final = 100
MOST_GROUPS: Final = 10_000
"""Combinations of values, such as numbers of balls, each of which makes a case of its own."""


class Study(Record):
    """Many cases: those of all combinations of the axes' values, each scattered if so wanted.

    Parameters
    ----------
    title
        One line, at most 200 characters.
    case
        The `Case` that supplies what does not vary; or:
    machine
        a `Machine`. Its fields vary by the keys of ``--set``, such as ``"loads.0.fz"``.
    seed
        Of the scatter.
    outputs
        Names of the catalogue; ``rolamento sweep --list outputs`` shows it. Those of a machine
        have a variable for each of its bearings or shafts.
    variants
        `Variant` records, of a case: cases that differ in some fields, side by side, the first
        dimension of the result, ``"variant"``. The case itself is the first of them, unless a
        variant without changes names it.
    axes
        `Axis` records, at most 8: the dimensions of the result, the first the slowest, but those
        whose values need a case each (numbers of balls, names) before the others.
    scatter
        A `Scatter`: one more dimension, ``"sample"``. Every combination of the axes' values sees
        the same draws.

    Raises
    ------
    InputError
        If a part is not valid, nothing varies, a field varies twice, or there are more than
        10⁹ cases, of a machine 10 000.
    """

    title: Line = Field("", examples=["218 over its speed range"])
    case: Case | None = Field(None, examples=["case.toml"])
    machine: Machine | None = Field(None, examples=["machine.toml"])
    seed: Annotated[int, Count] = Field(0, strict=True, ge=0, le=2**63 - 1, examples=[1])
    outputs: tuple[_OutputName, ...] = Field(
        DEFAULT_OUTPUTS, min_length=1, max_length=_MOST_OUTPUTS, examples=['["x", "stiffness_zz"]']
    )
    variants: tuple[Variant, ...] = ()
    axes: tuple[Axis, ...] = Field((), max_length=_MOST_AXES)
    scatter: Scatter | None = None

    @cached_property
    def subject(self) -> Subject:
        """The case or the machine, as what is varied."""
        if self.machine is not None:
            return OfMachine(self.machine)
        assert self.case is not None
        return OfCase(self.case, self.cases_compared)

    @cached_property
    def variables(self) -> tuple[Output, ...]:
        """The outputs as they are in the result: of a machine one for each of its parts."""
        return self.subject.outputs_of(self.outputs)

    @cached_property
    def sizes(self) -> Mapping[str, int]:
        """Length of each dimension, in order."""
        names = dict(zip(map(id, self.axes), _dimension_names(self), strict=True))
        sizes = {VARIANT: len(self.compared)} if self.variants else {}
        sizes |= {names[id(axis)]: axis.size for axis in self.ordered_axes}
        return {**sizes, SAMPLE: self.scatter.count} if self.scatter is not None else sizes

    @property
    def compared(self) -> tuple[Variant, ...]:
        """The variants with the case itself; none where nothing is compared."""
        return with_the_case(self.variants)

    @cached_property
    def cases_compared(self) -> tuple[Case, ...]:
        """The case, or that of each variant; none of a machine."""
        if self.case is None:
            return ()
        return tuple(one.of(self.case) for one in self.compared) or (self.case,)

    @property
    def ordered_axes(self) -> tuple[Axis, ...]:
        """The axes as dimensions: those that group the cases first, so that groups are runs."""
        return tuple(sorted(self.axes, key=lambda axis: not self.is_grouped(axis)))

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths of the dimensions."""
        return tuple(self.sizes.values())

    @property
    def cases(self) -> int:
        """Number of cases."""
        return math.prod(self.shape)

    @property
    def varied(self) -> tuple[str, ...]:
        """The fields that vary, those of the axes first."""
        scattered = tuple(self.scatter.fields) if self.scatter is not None else ()
        return (*(name for axis in self.axes for name in axis.fields), *scattered)

    @model_validator(mode="before")
    @classmethod
    def _outputs_of_its_own(cls, given: Any) -> Any:
        """Take the usual outputs of a machine where none are named."""
        if isinstance(given, Mapping) and given.get("machine") is not None:
            return {"outputs": DEFAULT_OF_MACHINE, **given}
        return given

    @model_validator(mode="after")
    def _sound(self) -> Self:
        self._check_subject()
        self._check_variants()
        self.subject.refuse_missing(self.outputs, self.varied)
        for name in self.outputs:
            if self.outputs.count(name) > 1:
                raise InputError(said("occurs twice"), field="outputs", value=name)
        if not self.axes and self.scatter is None and not self.variants:
            raise InputError(
                said("is missing: give axes, a scatter, or variants"),
                field="axes",
                example='[[axes]] field = "duty.inner_speed", values = ["0 rpm", "9000 rpm"]',
            )
        self._check_fields()
        self._check_names()
        self._check_numbers()
        return self

    def _check_subject(self) -> None:
        """Refuse a study of nothing, or of two things."""
        if self.case is None and self.machine is None:
            raise InputError(said("is missing"), field="case", example='case = "case.toml"')
        if self.case is not None and self.machine is not None:
            raise InputError(said("cannot be combined with {before}", before="case"),
                             field="machine")  # fmt: skip
        if self.machine is not None and self.variants:
            raise InputError(
                said("are of a case; in a machine a field with several values is an axis"),
                field="variants",
                example='[[axes]] field = "bearings.0.designation", values = ["6308", "6309"]',
            )

    def _check_variants(self) -> None:
        """Refuse variants that are none of this case, or that what varies would undo."""
        if self.case is None:
            return
        given = {variant.name: number for number, variant in enumerate(self.variants)}
        for variant in self.compared:
            at = f"variants.{given.get(variant.name, 0)}.changes"
            for name in variant.changes:
                if name in self.varied:
                    raise InputError(
                        said("varies in the study: its values there would take the place of this"),
                        field=f"{at}.{name}",
                        value=str(variant.changes[name]),
                    )
            try:
                variant.of(self.case)
            except InputError as error:
                raise error.with_details(field=f"{at}.{error.field}".rstrip(".")) from None

    def _check_fields(self) -> None:
        varied = self.varied
        for name in varied:
            self.subject.check_field(name, self._place(name))
        places = [self.subject.place_of(name) for name in varied]
        for name, place in zip(varied[::-1], places[::-1], strict=True):
            if places.count(place) > 1:
                raise InputError(said("is varied twice"), field=self._place(name), value=name)
        if varied:
            fields.refuse_rivals(varied, at=self._place(varied[-1]))
        for name in self.scatter.fields if self.scatter is not None else ():
            if not self.subject.varies_in_batch(name):
                raise InputError(
                    said("cannot be scattered; use an axis"), field=f"scatter.fields.{name}"
                )

    def _check_names(self) -> None:
        names, outputs = _dimension_names(self), {one.name for one in self.variables}
        for number, name in enumerate(names):
            if name in _RESERVED or name in outputs or names.count(name) > 1:
                raise InputError(
                    said("is already a name in the result"),
                    field=f"axes.{number}.name",
                    value=name,
                    example='name = "load case"',
                )

    def _check_numbers(self) -> None:
        if self.cases > MOST_CASES:
            raise InputError(
                said(
                    "give {cases:.3g} cases; a study has at most {most:.0e}",
                    cases=self.cases,
                    most=MOST_CASES,
                ),
                field="axes" if self.axes else "scatter.count",
            )
        try:
            self.subject.check_size(self.cases)
        except InputError as error:
            raise error.with_details(field="axes" if self.axes else "scatter.count") from None
        groups = math.prod(axis.size for axis in self.axes if self.is_grouped(axis))
        groups *= len(self.cases_compared) or 1
        if groups > MOST_GROUPS:
            raise InputError(
                said(
                    "give {groups} combinations of values that each need a case of their "
                    "own; at most {most} are allowed",
                    groups=groups,
                    most=MOST_GROUPS,
                ),
                field="axes",
            )

    def is_grouped(self, axis: Axis) -> bool:
        """Return whether a field of an axis cannot vary within a batch."""
        return not all(self.subject.varies_in_batch(name) for name in axis.fields)

    def _place(self, name: str) -> str:
        """Where in the study a field is varied for the last time."""
        if self.scatter is not None and name in self.scatter.fields:
            return f"scatter.fields.{name}"
        numbers = [number for number, axis in enumerate(self.axes) if name in axis.fields]
        return f"axes.{numbers[-1]}.field"

    @model_serializer(mode="wrap")
    def _written(self, handler: SerializerFunctionWrapHandler, info: SerializationInfo) -> Any:
        """Leave out what says nothing, where a person reads."""
        table: dict[str, Any] = handler(self)
        if info.context != AT_THE_BORDER:
            return table
        kept = {key: value for key, value in table.items() if value not in ("", (), [], None)}
        return {
            key: list(value) if isinstance(value, tuple) else value for key, value in kept.items()
        }


def coordinate_names(study: Study) -> dict[str, str]:
    """Return what the coordinate of each varied field is called.

    As the axis is, if it has one field and a name; else the field's last part, if that is free.
    """
    varied = study.varied
    leaves = [fields.read_varied(name).leaf for name in varied]
    outputs = (one.name for one in study.variables)
    taken = (*_RESERVED, *outputs, *(axis.name for axis in study.axes))
    names = {
        name: leaf if leaves.count(leaf) == 1 and leaf not in taken else in_files(name)
        for name, leaf in zip(varied, leaves, strict=True)
    }
    given = {axis.field: axis.name for axis in study.axes if axis.field is not None and axis.name}
    return {**names, **given}


def _dimension_names(study: Study) -> list[str]:
    """Names of the axes: as given, or after the field, or the fields' last parts together."""
    coordinates = coordinate_names(study)
    names = []
    for axis in study.axes:
        joined = "_".join(coordinates[name].rpartition(".")[2] for name in axis.fields)
        alone = coordinates[axis.fields[0]] if axis.field is not None else joined
        names.append(axis.name or alone)
    return names


_LIST_HEADER: Final = re.compile(r"^([ \t]*)\[\[[ \t]*([A-Za-z_.]{1,60})[ \t]*\]\]", re.MULTILINE)


def file_in_study(path: str | os.PathLike[str]) -> Path | None:
    """Return the file of a case or a machine that a study file names, if it does.

    Raises
    ------
    FileError
        As `load_study`.
    """
    text, source = read_text(path)
    mapping = parse_mapping(text, format_of_path(path) or format_of_text(text), source)
    folder = Path(path).parent
    machine, case = mapping.get("machine"), mapping.get("case")
    if isinstance(machine, str) and machine:
        return folder / machine
    if not isinstance(case, str) or not case or is_designation(case, folder):
        return None
    return folder / case


def load_study(path: str | os.PathLike[str], overrides: Changes = ()) -> Study:
    """Read a study file.

    Parameters
    ----------
    path
        A TOML or JSON file; ``"-"`` for standard input. A case or a machine that it names is looked
        for beside it; a case that is no file is a designation.
    overrides
        What goes over the case, as of `rolamento.load_case`, or over the machine.

    Raises
    ------
    FileError
        If the file or its case cannot be read, or is neither TOML nor JSON.
    InputError
        If it does not describe a valid study; with the line number.
    """
    text, source = read_text(path)
    folder = Path() if source == STANDARD_INPUT else Path(path).parent
    return parse_study(
        text, format=format_of_path(path), source=source, folder=folder, overrides=overrides
    )


def parse_study(
    text: str,
    *,
    format: TextFormat | None = None,
    source: str = "",
    folder: str | os.PathLike[str] = ".",
    overrides: Changes = (),
) -> Study:
    """Return the study that a TOML or JSON text describes.

    Parameters
    ----------
    text
        The text of a study file.
    format
        ``"toml"``, ``"json"``, or ``None`` to go by the first character.
    source
        What to call the text in messages.
    folder
        Where to look for the file of a case or a machine that it names.
    overrides
        As in `load_study`.

    Raises
    ------
    InputError
        As `load_study`.
    """
    known_format = format or format_of_text(text)
    mapping = parse_mapping(text, known_format, source)
    try:
        if "shafts" in mapping:
            raise InputError(
                said("is a machine itself; a study names one, and says what varies"),
                field="shafts",
                example='machine = "machine.toml"',
            )
        read = {
            "case": _case_of(mapping, Path(folder), overrides),
            "machine": _machine_of(mapping, Path(folder), overrides),
        }
        return Study.from_mapping({**mapping, **{k: v for k, v in read.items() if v is not None}})
    except InputError as error:
        if error.source:
            raise
        line = line_of(error.field, _key_lines(text, known_format))
        raise error.with_details(source=source, line=line) from None


def study_to_toml(study: Study) -> str:
    """Return a study as the text of a study file that holds its case: one file says it all."""
    return text_of_mapping(study.to_mapping(), "toml")


def study_to_json(study: Study) -> str:
    """Return a study as JSON, its case included."""
    return json.dumps(study.to_mapping(), ensure_ascii=False)


def _case_of(mapping: Mapping[str, Any], folder: Path, changes: Changes) -> Case | None:
    """Return the case that a study names or holds, with changes put over it."""
    given = mapping.get("case")
    if given is None:
        return None
    if isinstance(given, str):
        try:
            named = is_designation(given, folder)
            return load_case(given if named else folder / given, changes)
        except InputError as error:
            raise error.with_details(source=error.source or given) from None
    if not isinstance(given, dict):
        raise InputError(
            said("must be the name of a case file or a table"),
            field="case",
            value=given,
            example='case = "case.toml"',
        )
    try:
        return read_changed(given, changes, Case)
    except InputError as error:
        if error.source:
            raise
        raise error.with_details(field=f"case.{error.field}".rstrip(".")) from None


def _machine_of(mapping: Mapping[str, Any], folder: Path, changes: Changes) -> Machine | None:
    """Return the machine that a study names or holds, with changes put over it."""
    given = mapping.get("machine")
    if given is None:
        return None
    if isinstance(changes, Mapping):
        values = [(parts_of_key(name), value) for name, value in changes.items()]
        settings: tuple[str, ...] = ()
    else:
        values, settings = [], tuple(changes)
    if isinstance(given, str):
        try:
            return machine_reader(folder / given)(settings, values)
        except InputError as error:
            raise error.with_details(source=error.source or given) from None
    if not isinstance(given, dict):
        raise InputError(
            said("must be the name of a machine file or a table"),
            field="machine",
            value=given,
            example='machine = "machine.toml"',
        )
    try:
        tables = with_values(with_settings(given, settings), values)
        return Machine.from_mapping(with_files(tables, folder))
    except InputError as error:
        if error.source:
            raise
        raise error.with_details(field=f"machine.{error.field}".rstrip(".")) from None


def _key_lines(text: str, text_format: TextFormat) -> LineIndex:
    """Return the lines of keys; tables in lists by their number, as errors name them."""
    if text_format == "toml":
        counts: dict[str, int] = {}

        def numbered(match: re.Match[str]) -> str:
            number = counts[match[2]] = counts.get(match[2], -1) + 1
            return f"{match[1]}[{match[2]}.{number}]"

        text = _LIST_HEADER.sub(numbered, text)
    index: LineIndex = {}
    for path, line in lines_of_keys(text, text_format).items():
        index.setdefault(tuple(".".join(path).split(".")), line)
    return index
