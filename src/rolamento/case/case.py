"""A case: one bearing and its duty, read from a file or built in Python."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from typing import Any, Self

from pydantic import Field, ValidationInfo, model_validator

from rolamento._reading import (
    TextFormat,
    format_of_path,
    format_of_text,
    parse_mapping,
    read_text,
)
from rolamento._writing import write_text
from rolamento.case._catalogue_sizes import check_catalogue_sizes, with_catalogue_sizes
from rolamento.case._lines import line_of, lines_of_keys
from rolamento.case._overrides import OVERRIDE_SOURCE, overridden
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty
from rolamento.case.film_model import FilmModel
from rolamento.case.life_model import LifeModel
from rolamento.case.lubricant import LubricantField
from rolamento.case.model import Model
from rolamento.case.mounting import Mounting
from rolamento.case.quantity import Line, at_the_border
from rolamento.case.record import Record
from rolamento.case.surface import Surface
from rolamento.case.temperature import Temperature
from rolamento.errors import FileError, InputError
from rolamento.units import from_si

__all__ = [
    "Case",
    "case_to_json",
    "case_to_toml",
    "load_case",
    "override",
    "parse_case",
    "save_case",
]


class Case(Record):
    """One bearing, its duty, and the models to be used.

    Parameters
    ----------
    title
        One line, at most 200 characters.
    bearing
        A `Bearing`.
    duty
        A `Duty`.
    model
        A `Model`.
    lubricant
        A `Lubricant`, its name or its table; without one there is no film.
    surface
        A `Surface`, for the film parameter.
    temperature
        A `Temperature`, for the film and the clearance in operation.
    mounting
        A `Mounting`; with one the bearing is solved with the clearance that it leaves. Its bore and
        outside diameter may be left out of a table where the bearing has a designation.
    film
        A `FilmModel`; its defaults if not given.
    life
        A `LifeModel`; ratings, cleanliness and wishes for the life.

    Raises
    ------
    InputError
        If a part is missing or not valid, or the parts contradict each other.
    """

    title: Line = Field("", examples=["218 angular-contact ball bearing"])
    bearing: Bearing = Field(examples=["[bearing] as a table"])
    duty: Duty = Field(examples=["[duty] as a table"])
    model: Model = Field(default_factory=Model)
    lubricant: LubricantField | None = Field(None, examples=["ISO VG 68"])
    surface: Surface | None = Field(None, examples=["[surface] as a table"])
    temperature: Temperature | None = Field(None, examples=["[temperature] as a table"])
    mounting: Mounting | None = Field(None, examples=["[mounting] as a table"])
    film: FilmModel | None = Field(None, examples=["[film] as a table"])
    life: LifeModel | None = Field(None, examples=["[life] as a table"])

    @model_validator(mode="before")
    @classmethod
    def _with_sizes(cls, given: Any, info: ValidationInfo) -> Any:
        """Fill in bore and outside diameter that a designation tells."""
        if not isinstance(given, Mapping):
            return given
        return with_catalogue_sizes(given, in_file=at_the_border(info.context))

    @model_validator(mode="after")
    def _sizes_agree(self) -> Self:
        if self.mounting is not None:
            check_catalogue_sizes(self.bearing, self.mounting)
        return self

    @property
    def lubricant_temperature(self) -> float | None:
        """Temperature of the lubricant in K, if it is given."""
        return None if self.temperature is None else self.temperature.lubricant

    @model_validator(mode="after")
    def _displacement_within_reason(self) -> Self:
        """A ring does not move by a ball: such a value has the wrong unit."""
        limit = self.bearing.ball_diameter
        for axis in ("x", "y", "z"):
            shift = getattr(self.duty.displacement, axis)
            if shift is not None and abs(shift) > limit:
                raise InputError(
                    f"must be at most the ball diameter, {from_si(limit, 'length')}",
                    field=f"duty.displacement.{axis}",
                    value=from_si(shift, "length"),
                    example=f'{axis} = "0.01 mm"',
                )
        return self

    @model_validator(mode="after")
    def _warm_parts_are_mounted(self) -> Self:
        """Temperatures of the seats act on the clearance by way of the mounting alone."""
        if self.mounting is None and self.temperature is not None:
            for part in ("shaft", "housing"):
                warm = getattr(self.temperature, part)
                if warm is not None:
                    raise InputError(
                        "is given without [mounting], and has no effect",
                        field=f"temperature.{part}",
                        value=from_si(warm, "temperature"),
                        example='[mounting] with bore = "25 mm" and outside_diameter = "62 mm"',
                    )
        return self

    @model_validator(mode="after")
    def _friction_control_has_friction(self) -> Self:
        """Balls that only friction controls need a coefficient of it, and one row."""
        if self.model.raceway_control != "friction":
            return self._without_film()
        if self.bearing.is_set:
            raise InputError(
                "is available for single bearings; a set takes outer, inner, jones or none",
                field="model.raceway_control",
                value="friction",
                example='raceway_control = "jones"',
            )
        if self.lubricant is None or not self.lubricant.friction_coefficient:
            raise InputError(
                'is missing, and raceway_control = "friction" rests on it',
                field="lubricant.friction_coefficient",
                example='[lubricant] with kind = "dry" and friction_coefficient = 0.1',
            )
        if self.model.needs_film and (
            self.lubricant.kind == "dry" or self.lubricant_temperature is None
        ):
            raise InputError(
                "needs an oil or a grease in [lubricant], and its temperature in [temperature]",
                field="model.traction"
                if self.model.traction == "film"
                else "model.film_in_contact",
                example='lubricant = "60 degC" in [temperature]',
            )
        return self

    def _without_film(self) -> Self:
        if self.model.needs_film:
            raise InputError(
                'is for raceway_control = "friction" only',
                field="model.traction"
                if self.model.traction == "film"
                else "model.film_in_contact",
                example='raceway_control = "friction"',
            )
        return self


def load_case(path: str | os.PathLike[str], overrides: Iterable[str] = ()) -> Case:
    """Read a case file.

    Parameters
    ----------
    path
        A TOML or JSON file, told apart by the name's ending, else by the first
        character; ``"-"`` for standard input.
    overrides
        Settings ``KEY=VALUE`` that go over the file, such as ``"duty.load.fz=10 kN"``.

    Raises
    ------
    FileError
        If the file cannot be read, or is neither TOML nor JSON.
    InputError
        If it does not describe a valid case; with the line number.
    """
    text, source = read_text(path)
    return parse_case(text, format=format_of_path(path), source=source, overrides=overrides)


def parse_case(
    text: str,
    *,
    format: TextFormat | None = None,
    source: str = "",
    overrides: Iterable[str] = (),
) -> Case:
    """Return the case that a TOML or JSON text describes.

    Parameters
    ----------
    text
        The text of a case file.
    format
        ``"toml"``, ``"json"``, or ``None`` to go by the first character.
    source
        What to call the text in messages.
    overrides
        As in `load_case`.

    Raises
    ------
    InputError
        As `load_case`.
    """
    known_format = format or format_of_text(text)
    mapping = parse_mapping(text, known_format, source)
    try:
        return _case_from(mapping, overrides)
    except InputError as error:
        if error.source:
            raise
        line = line_of(error.field, lines_of_keys(text, known_format))
        raise error.with_details(source=source, line=line) from None


def override(case: Case, settings: Iterable[str]) -> Case:
    """Return a case with settings applied, such as ``["duty.load.fz=10 kN"]``.

    A setting replaces its rival: a clearance takes the place of the contact angle, a
    displacement that of the load on the same degree of freedom.

    Raises
    ------
    InputError
        If a setting names no field, or the result is not valid.
    """
    return _case_from(case.to_mapping(), settings)


def save_case(case: Case, path: str | os.PathLike[str]) -> None:
    """Write a case to a file; `load_case` reads the identical case back.

    Parameters
    ----------
    case
        The case.
    path
        A name that ends in ``.toml`` or ``.json``.

    Raises
    ------
    FileError
        If the name ends otherwise or the file cannot be written.
    """
    known_format = format_of_path(path)
    if known_format is None:
        raise FileError("must end in .toml or .json", source=os.fspath(path), example="case.toml")
    write_text(case_to_json(case) if known_format == "json" else case_to_toml(case), path)


def case_to_toml(case: Case) -> str:
    """Return a case as the text of a TOML case file."""
    import tomli_w  # when a case is written, not whenever one is read

    return tomli_w.dumps(case.to_mapping())


def case_to_json(case: Case) -> str:
    """Return a case as the text of a JSON case file."""
    return json.dumps(case.to_mapping(), indent=2, ensure_ascii=False) + "\n"


def _case_from(mapping: Mapping[str, Any], settings: Iterable[str]) -> Case:
    changed, fields = overridden(mapping, settings, Case)
    try:
        return Case.from_mapping(changed)
    except InputError as error:
        if error.field in fields:
            raise error.with_details(source=OVERRIDE_SOURCE) from None
        raise
