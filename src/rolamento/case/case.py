"""A case: one bearing and its duty, read from a file or built in Python."""

import os
from collections.abc import Iterable, Mapping, Sequence
from math import isclose
from typing import TYPE_CHECKING, Annotated, Any, Final, Self

from pydantic import Field, ModelWrapValidatorHandler, ValidationInfo, model_validator

from rolamento.case.arrangement import designation_of
from rolamento.case.bearing import Bearing
from rolamento.case.duty import SHORT_NAMES, Displacement, Duty, Load
from rolamento.case.electrical import Electrical
from rolamento.case.fields import Changes, changed, fields_of, read_changed, values_of
from rolamento.case.fields import Field as CaseField
from rolamento.case.film_model import FilmModel
from rolamento.case.grease import Grease
from rolamento.case.heat import Heat
from rolamento.case.life_model import LifeModel
from rolamento.case.losses import Losses
from rolamento.case.lubricant import Lubricant, LubricantField
from rolamento.case.model import Model
from rolamento.case.mounting import Mounting
from rolamento.case.quantity import AT_THE_BORDER, InSI, Line
from rolamento.case.record import ByElement, Record
from rolamento.case.report import ReportHead
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.rolling_bearing import RollingBearing, element_named
from rolamento.case.static import Static
from rolamento.case.surface import Surface
from rolamento.case.temperature import Temperature
from rolamento.errors import FileError, InputError, nearest
from rolamento.io.text import (
    TextFormat,
    format_of_path,
    format_of_text,
    line_of,
    lines_of_keys,
    parse_mapping,
    read_text,
    text_of_mapping,
)
from rolamento.io.writing import write_mapping
from rolamento.units import readable, to_si
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.catalogue import CatalogueBearing

__all__ = [
    "BearingLike",
    "Case",
    "case_of",
    "case_to_json",
    "case_to_toml",
    "is_designation",
    "load_case",
    "lubricant_of",
    "name_of",
    "override",
    "parse_case",
    "save_case",
    "with_changes",
]


_SIZES: Final = ("bore", "outside_diameter")
_OF_SPACERS: Final = (
    "temperature.inner_spacer", "temperature.outer_spacer", "mounting.inner_spacer_material",
    "mounting.outer_spacer_material",
)  # fmt: skip
_ROUNDING: Final = 1e-9
_MOST_FORCE: Final = 1e9
"""N, of a rating."""


class Case(Record):
    """One bearing, its duty, and the models to be used.

    Parameters
    ----------
    title
        One line, at most 200 characters.
    bearing
        A `Bearing` or a `RollerBearing`, distinguished by `element`, else by the designation or the
        rows; in Python a designation will do, such as ``"6310/C3"``.
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
    grease
        A `Grease`: thickener, seals, shaft, for the life of the grease.
    heat
        A `Heat`: ways of the heat out of the bearing, for its heat balance.
    static
        A `Static`: demands on the static safety, hardness, allowable pressure.
    electrical
        An `Electrical`: voltage and current across the bearing.
    losses
        A `Losses`: seals and oil bath, for the friction.
    life
        A `LifeModel`; ratings, cleanliness and wishes for the life.
    report
        A `ReportHead`: project, author, revision and date of a report.

    Raises
    ------
    InputError
        If a part is missing or not valid, or the parts contradict each other.
    """

    title: Line = Field("", examples=["218 angular-contact ball bearing"])
    bearing: Annotated[Bearing | RollerBearing, ByElement(element_named)] = Field(
        examples=["[bearing] as a table"]
    )
    duty: Duty = Field(examples=["[duty] as a table"])
    model: Model = Field(default_factory=Model.model_construct)
    lubricant: LubricantField | None = Field(None, examples=["ISO VG 68"])
    surface: Surface | None = Field(None, examples=["[surface] as a table"])
    temperature: Temperature | None = Field(None, examples=["[temperature] as a table"])
    mounting: Mounting | None = Field(None, examples=["[mounting] as a table"])
    film: FilmModel | None = Field(None, examples=["[film] as a table"])
    grease: Grease | None = Field(None, examples=["[grease] as a table"])
    heat: Heat | None = Field(None, examples=["[heat] as a table"])
    static: Static | None = Field(None, examples=["[static] as a table"])
    electrical: Electrical | None = Field(None, examples=["[electrical] as a table"])
    losses: Losses | None = Field(None, examples=["[losses] as a table"])
    life: LifeModel | None = Field(None, examples=["[life] as a table"])
    report: ReportHead | None = Field(None, examples=["[report] as a table"])

    @model_validator(mode="wrap")
    @classmethod
    def _with_catalogue(
        cls, given: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo
    ) -> Self:
        """Fill in sizes that a designation gives, and pass it the ratings that are given."""
        if not isinstance(given, Mapping):
            return handler(given)
        if isinstance(given.get("bearing"), str) and info.context != AT_THE_BORDER:
            given = {"duty": Duty(), **given, "bearing": {"designation": given["bearing"]}}
        designation = designation_of(given.get("bearing"))
        if designation is None:
            return handler(given)
        from rolamento.catalogue import listed

        with listed(_rated_bearing(given, designation)):
            filled = _with_catalogue_sizes(given, designation)
            bearing = filled.get("bearing")
            if isinstance(bearing, RollingBearing) and bearing.from_given_ratings:
                filled["bearing"] = bearing.looked_up_again()
            return handler(filled)

    @classmethod
    def fields(cls) -> Mapping[str, CaseField]:
        """Return what there is to know of each field of a case, by its dotted name."""
        return fields_of(cls)

    def with_(self, values: Mapping[str, Any] | None = None, /, **nested: Any) -> "Case":
        """Return a case with some values changed, such as ``case.with_(fz="10 kN")``.

        A value replaces its rival: a clearance takes the place of the contact angle, a
        displacement that of the load on the same degree of freedom. Balls whose material is not
        given go on following that of the rings.

        Parameters
        ----------
        values
            By dotted name, ``{"duty.load.fz": "10 kN"}``: text as in a case file or numbers in SI
            units, records or tables for tables; None takes an optional value away.
        nested
            Likewise: the duty's by their short names, such as ``fz`` and ``inner_speed``, others
            with two underscores for the dot, ``temperature__lubricant="70 degC"``.

        Raises
        ------
        InputError
            If there is no such field, it is given twice, or the result is not valid.
        """
        dotted = ((key.replace("__", "."), value) for key, value in nested.items())
        given = _full_names([*(values or {}).items(), *dotted])
        with self.bearing.looked_up():
            return Case.from_mapping(changed(self._own_mapping(given), given, Case))

    def _own_mapping(self, changes: Iterable[str]) -> dict[str, Any]:
        """The tables of the case's file, with the elements' material where a part of it changes."""
        mapping, material = self.to_mapping(), self.bearing.MATERIAL
        if any(change.startswith(f"bearing.{material}.") for change in changes):
            mapping["bearing"].setdefault(material, self.bearing.element_material.to_mapping())
        return mapping

    @property
    def lubricant_temperature(self) -> float | None:
        """Temperature of the lubricant in K, if it is given."""
        return None if self.temperature is None else self.temperature.lubricant

    @property
    def without_load(self) -> "Case":
        """The case with nothing acting from outside: its speeds, and where its elements begin."""
        free = {"load": Load.model_construct(), "displacement": Displacement.model_construct()}
        return self.model_copy(update={"duty": self.duty.model_copy(update=free)})

    @model_validator(mode="after")
    def _displacement_within_reason(self) -> Self:
        """A ring does not move by a ball: such a value has the wrong unit."""
        for axis in ("x", "y", "z"):
            shift = getattr(self.duty.displacement, axis)
            if shift is not None and abs(shift) > (limit := self.bearing.element_diameter):
                longest = readable(limit, "length")
                raise InputError(
                    said("must be at most the ball diameter, {limit}", limit=longest)
                    if not self.bearing.bearing_type.has_rollers
                    else said("must be at most the roller diameter, {limit}", limit=longest),
                    field=f"duty.displacement.{axis}",
                    value=readable(shift, "length"),
                    example=f'{axis} = "0.01 mm"',
                )
        return self

    @model_validator(mode="after")
    def _mounting_fits(self) -> Self:
        """Fits are modelled of plain rows of the designation's size, spacers of sets.

        Temperatures of the seats act on the clearance by way of the mounting alone.
        """
        bearing, resolved = self.bearing, self.bearing.resolved
        if self.mounting is None:
            for part in ("shaft", "housing", "inner_spacer", "outer_spacer"):
                warm = getattr(self.temperature, part, None)
                if warm is not None:
                    raise InputError(
                        said("has no effect without [mounting]"),
                        field=f"temperature.{part}",
                        value=readable(warm, "temperature"),
                        example='mounting = { bore = "25 mm", outside_diameter = "62 mm" }',
                    )
            return self
        for name in _SIZES if resolved is not None else ():
            told, own = getattr(bearing.published, name), getattr(self.mounting, name)
            if not isclose(told, own, rel_tol=_ROUNDING):
                size = readable(told, "length")
                raise InputError(
                    said(
                        "must be {told}, the value of {designation}",
                        told=size,
                        designation=bearing.designation,
                    ),
                    field=f"mounting.{name}",
                    value=readable(own, "length"),
                    example=f'{name} = "{size}"',
                )
        if not bearing.bearing_type.mountable:
            raise InputError(
                said("is not available for bearings of kind {kind}", kind=bearing.kind),
                field="mounting",
                example="[bearing] with diametral_clearance or contact_angle as it runs",
            )
        if resolved is not None and resolved.is_on_a_taper:
            raise InputError(
                said("is not available for a tapered bore: its fit is how far the ring is driven"),
                field="mounting",
                example="[bearing] with diametral_clearance as it runs",
            )
        for field in () if bearing.is_set else _OF_SPACERS:
            table, _, name = field.partition(".")
            if getattr(getattr(self, table), name, None) is not None:
                raise InputError(
                    said("is for sets of rows only: it acts along their spacing"),
                    field=field,
                    example='bearing.arrangement = "DB"',
                )
        return self

    @model_validator(mode="after")
    def _model_fits(self) -> Self:
        """Other grooves, rollers and sets have fewer choices of control.

        Balls that only friction controls need a coefficient of it, and one row.
        """
        model, bearing, of = self.model, self.bearing, self.bearing.bearing_type
        control, film, refused = model.raceway_control, model.film_field, "model.raceway_control"
        allowed = ("outer", "inner", *(() if of.with_cage_only else ("jones", "none")))
        if bearing.kind is not None and control not in allowed:
            raise InputError(
                said(
                    'must be one of {allowed} with `bearing.kind` = "{kind}"',
                    allowed=", ".join(allowed),
                    kind=bearing.kind,
                ),
                field=refused,
                value=control,
                example='raceway_control = "outer"',
            )
        if bearing.kind is not None and of.with_cage_only and model.cage == "none":
            raise InputError(
                said(
                    'must be loose or rigid with `bearing.kind` = "{kind}": the balls orbit with'
                    " the cage",
                    kind=bearing.kind,
                ),
                field="model.cage",
                value=model.cage,
                example='cage = "loose"',
            )
        if control != "friction":
            if film is None:
                return self
            raise InputError(
                said('is for raceway_control = "friction" only'),
                field=film,
                example='raceway_control = "friction"',
            )
        if of.has_rollers:
            raise InputError(
                said("is for balls only: rollers turn as both races roll them"),
                field=refused,
                value=control,
                example='raceway_control = "outer"',
            )
        if bearing.is_set:
            raise InputError(
                said(
                    "is available for single bearings only; a set takes outer, inner, jones or none"
                ),
                field=refused,
                value=control,
                example='raceway_control = "jones"',
            )
        lubricant = self.lubricant
        if lubricant is None or not lubricant.friction_coefficient:
            raise InputError(
                said('is missing; raceway_control = "friction" needs it'),
                field="lubricant.friction_coefficient",
                example='[lubricant] with kind = "dry" and friction_coefficient = 0.1',
            )
        if film and (lubricant.kind == "dry" or self.lubricant_temperature is None):
            raise InputError(
                said(
                    "needs an oil or a grease in [lubricant] and its temperature in [temperature]"
                ),
                field=film,
                example='lubricant = "60 degC" in [temperature]',
            )
        return self


def load_case(
    path: str | os.PathLike[str],
    overrides: Changes = (),
    *,
    otherwise: Iterable[str] = (),
) -> Case:
    """Read a case file, or make the case of a designation: that bearing without a load.

    Parameters
    ----------
    path
        A TOML or JSON file, distinguished by the name's ending, else by the first
        character; ``"-"`` for standard input; or a designation such as ``"6310/C3"``.
    overrides
        What goes over the case, such as ``{"duty.load.fz": "10 kN"}``: values by dotted name as
        `Case.with_` takes them, or texts as ``--set`` does, ``["duty.load.fz=10 kN"]``.
    otherwise
        Settings of tables that the file does not have, such as ``"lubricant.kind=dry"``; in a
        table that it has they do not count.

    Returns
    -------
    Case
        All quantities in SI.

    Raises
    ------
    FileError
        If the file cannot be read, or is neither TOML nor JSON.
    InputError
        If it does not describe a valid case, with the line number; or there is neither such a
        file nor such a bearing.
    """
    if is_designation(path):
        return _case_of_designation(str(path), overrides, otherwise)
    text, source = read_text(path)
    return parse_case(
        text,
        format=format_of_path(path),
        source=source,
        overrides=overrides,
        otherwise=otherwise,
    )


BearingLike = str | os.PathLike[str] | Bearing | RollerBearing | Case
"""A designation, a case file (``"-"``: on standard input), a bearing or a case."""


def name_of(bearing: BearingLike, case: Case) -> str:
    """Return what to call a bearing: by the title of its case, or as it was given."""
    return case.title or (os.fspath(bearing) if isinstance(bearing, str | os.PathLike) else "")


def case_of(source: BearingLike, changes: Changes = ()) -> Case:
    """Return a case, that of a file or a designation, or that of a bearing without a load.

    Parameters
    ----------
    source
        Whose case.
    changes
        What goes over it, as of `load_case`.

    Raises
    ------
    InputError, FileError
        If there is no such bearing, or the file is no case.
    """
    if isinstance(source, str | os.PathLike):
        return load_case(source, changes)
    if isinstance(source, Bearing | RollerBearing):
        source = Case(bearing=source, duty=Duty())
    elif not isinstance(source, Case):
        raise InputError(
            said("must be a Case, a bearing, a designation or the path of a case file"),
            field="case",
            value=type(source).__name__,
            example='"6310/C3"',
        )
    return override(source, changes) if changes else source


def lubricant_of(case: Case) -> Lubricant:
    """Return the lubricant of a case.

    Raises
    ------
    InputError
        If it has none.
    """
    if case.lubricant is None:
        raise InputError(
            said(
                "is missing: without a lubricant or a coefficient of friction there is "
                "no film and no friction"
            ),
            field="lubricant",
            example='lubricant = "ISO VG 68"',
        )
    return case.lubricant


def is_designation(name: object, folder: str | os.PathLike[str] = "") -> bool:
    """Distinguish a designation from a file: by its ending, or by its being there.

    Parameters
    ----------
    name
        What was given; a text that is no file may be a designation.
    folder
        Where the file would be; by default the current one.
    """
    if not isinstance(name, str) or name == "-" or "\0" in name:
        return False
    if format_of_path(name) is not None:
        return False
    path = os.path.join(folder, name)
    if os.path.isdir(path):  # of results, perhaps, named after their bearing
        return any(character.isdigit() for character in name)
    return not os.path.exists(path)


def _case_of_designation(designation: str, changes: Changes, otherwise: Iterable[str]) -> Case:
    """Return the case of a bearing without a load, its title the designation."""
    try:
        named = {"bearing": {"designation": designation}, "duty": {}}
        case = _case_from(named, changes, otherwise)
    except InputError as error:
        if error.source or error.field != "bearing.designation":
            raise
        raise _neither(designation, error) from None
    return case if case.title else case.replace(title=designation)


def _neither(name: str, error: InputError) -> InputError:
    """Say of what names no bearing that it is no file either; with the file that may be meant."""
    near = _file_like(name)
    if near:
        rule = said("is no file; did you mean {near}?", near=near)
        return FileError(rule, source=name)
    if not any(character.isdigit() for character in name):
        return FileError(
            said("is neither a file nor the designation of a bearing"),
            source=name,
            example="case.toml, 6310/C3",
        )
    return error


def _file_like(name: str) -> str:
    """Return the case file that a name without its ending, or a misspelt one, may mean."""
    folder, base = os.path.split(name)
    try:
        files = [one for one in os.listdir(folder or ".") if format_of_path(one) is not None]
    except (OSError, ValueError):
        return ""
    if f"{base}.toml" in files or f"{base}.json" in files:
        ending = "toml" if f"{base}.toml" in files else "json"
        return os.path.join(folder, f"{base}.{ending}")
    if any(character.isdigit() for character in base):  # rather another bearing
        return ""
    near = nearest(base, (os.path.splitext(one)[0] for one in files))
    found = next((one for one in sorted(files) if os.path.splitext(one)[0] == near), "")
    return os.path.join(folder, found) if found else ""


def parse_case(
    text: str,
    *,
    format: TextFormat | None = None,
    source: str = "",
    overrides: Changes = (),
    otherwise: Iterable[str] = (),
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
    overrides, otherwise
        As in `load_case`.

    Raises
    ------
    InputError
        As `load_case`.
    """
    known_format = format or format_of_text(text)
    mapping = parse_mapping(text, known_format, source)
    try:
        return _case_from(mapping, overrides, otherwise)
    except InputError as error:
        if error.source:
            raise
        line = line_of(error.field, lines_of_keys(text, known_format))
        raise error.with_details(source=source, line=line) from None


def override(case: Case, changes: Changes) -> Case:
    """Return a case with changes applied: as `Case.with_`, or texts as ``--set`` takes them.

    Parameters
    ----------
    case
        The case, which stays as it is.
    changes
        Values by dotted name, ``{"duty.load.fz": "10 kN"}``, or texts, ``["duty.load.fz=10 kN"]``.

    Raises
    ------
    InputError
        If a setting names no field, or the result is not valid.
    """
    changes = changes if isinstance(changes, Mapping) else tuple(changes)
    with case.bearing.looked_up():
        return _case_from(case._own_mapping(changes), changes)


def with_changes(case: Case, changes: Mapping[str, Any]) -> Case:
    """Return a case with values changed as `Case.with_` does, given as a file holds them.

    Raises
    ------
    InputError
        If there is no such field, or the result is not valid.
    """
    return Case.from_mapping(changed(case._own_mapping(changes), changes, Case, in_file=True))


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
    write_mapping(case.to_mapping(), path, example="case.toml")


def case_to_toml(case: Case) -> str:
    """Return a case as the text of a TOML case file.

    Parameters
    ----------
    case
        The case; `parse_case` reads the identical case back.
    """
    return text_of_mapping(case.to_mapping(), "toml")


def case_to_json(case: Case) -> str:
    """Return a case as the text of a JSON case file.

    Parameters
    ----------
    case
        The case; `parse_case` reads the identical case back.
    """
    return text_of_mapping(case.to_mapping(), "json")


def _with_catalogue_sizes(given: Mapping[str, Any], designation: str) -> dict[str, Any]:
    """Return the tables of a case with the sizes that they need and the catalogue gives.

    Parameters
    ----------
    given
        The fields of a case: tables or records.
    designation
        Of its bearing.
    """
    missing = {
        name: [size for size in _SIZES if size not in table]
        for name in ("mounting", "film")
        if isinstance(table := given.get(name), Mapping) and _needs_sizes(name, table)
    }
    filled = dict(given)
    sizes = _sizes_of(given.get("bearing"), designation) if any(missing.values()) else {}
    if not sizes:
        return filled
    for name, names in missing.items():
        own = {size: InSI(sizes[size]) for size in names}
        filled[name] = {**given[name], **own}
    return filled


def _rated_bearing(given: Mapping[str, Any], designation: str) -> "Sequence[CatalogueBearing]":
    """Return the bearing of the designation with the ratings of the life table, where it has none.

    Nothing of what is wrong: others refuse it.
    """
    bearing, life = given.get("bearing"), given.get("life")
    told = life if isinstance(life, Mapping) else getattr(life, "__dict__", {})
    if isinstance(bearing, RollingBearing) and not bearing.from_given_ratings:
        return ()  # it knows its balls
    from rolamento.catalogue import with_ratings

    ratings = [_force(told.get(name)) for name in ("dynamic_rating", "static_rating")]
    try:
        return with_ratings(designation, *ratings)
    except InputError:
        return ()


def _force(value: Any) -> float | None:
    """A rating in N, of a number or a text with its unit; None of anything else."""
    try:
        found = to_si(value, "force") if isinstance(value, str) else value
    except InputError:
        return None
    is_number = isinstance(found, int | float) and not isinstance(found, bool)
    return float(found) if is_number and 0.0 < found < _MOST_FORCE else None


def _needs_sizes(name: str, table: Mapping[str, Any]) -> bool:
    return name == "mounting" or table.get("starvation") == "replenishment"


def _sizes_of(bearing: Any, designation: str) -> dict[str, float]:
    """What the catalogue gives; nothing of what is no designation, which others refuse."""
    if isinstance(bearing, RollingBearing):
        known = bearing.published
    else:
        from rolamento.catalogue import catalogue

        try:
            known = catalogue().find(designation).bearing
        except InputError:
            return {}
    return {name: getattr(known, name) for name in _SIZES}


def _full_names(changes: Iterable[tuple[str, Any]]) -> dict[str, Any]:
    """Values by the dotted names of fields, of which the duty's may have been given by short ones.

    Raises
    ------
    InputError
        If one is given twice.
    """
    found: dict[str, Any] = {}
    for key, value in changes:
        name = SHORT_NAMES.get(key, key)
        if name in found:
            raise InputError(said("is given twice"), field=name)
        found[name] = value
    return found


def _case_from(mapping: Mapping[str, Any], changes: Changes, otherwise: Iterable[str] = ()) -> Case:
    lacking = [one for one in otherwise if one.partition(".")[0] not in mapping]
    if lacking:
        mapping = changed(mapping, values_of(lacking, Case), Case, in_file=True)
    if not changes:
        return Case.from_mapping(mapping)
    changes = _full_names(changes.items()) if isinstance(changes, Mapping) else changes
    return read_changed(mapping, changes, Case)
