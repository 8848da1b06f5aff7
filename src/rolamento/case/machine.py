"""A machine: shafts, their bearings and what acts on them, read from a file or built in Python.

Bearing loads and tilts come from the shaft; the duty of each bearing's case is therefore empty
here, and oil, temperature, life and the rest are given once for all bearings or for each of them.
Everything is counted along one x: that of the shafts, which are parallel to it.
"""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Final,
    Literal,
    NamedTuple,
    Protocol,
    Self,
    TypeVar,
    cast,
)

from pydantic import (
    BeforeValidator,
    Field,
    ModelWrapValidatorHandler,
    PrivateAttr,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    ValidationInfo,
    WithJsonSchema,
    WrapSerializer,
    model_validator,
)

from rolamento.case.case import Case
from rolamento.case.fields import (
    LONGEST_SETTING,
    OVERRIDE_SOURCE,
    changed,
    fields_of,
    inline_value,
    plain_value,
)
from rolamento.case.film_model import FilmModel
from rolamento.case.heat import Heat
from rolamento.case.housing_nodes import Others, elastic, reduced_to_rings
from rolamento.case.life_model import LifeModel
from rolamento.case.lubricant import Lubricant, LubricantField
from rolamento.case.machine_files import (
    CASE_TABLES,
    MOST_SECTIONS,
    MOST_UNKNOWNS,
    lines_of_machine,
    with_files,
)
from rolamento.case.machine_loads import (
    Belt,
    Gear,
    Gravity,
    Mass,
    Name,
    Place,
    ShaftLoad,
    Six,
    Speed,
    mirrored,
)
from rolamento.case.machine_sheets import holds_sheets, read_sheets
from rolamento.case.material import Material
from rolamento.case.model import Model
from rolamento.case.quantity import AT_THE_BORDER, Line, Quantity, Replaces, finite_number
from rolamento.case.record import Record
from rolamento.case.rolling_bearing import Designation
from rolamento.case.surface import Surface
from rolamento.case.temperature import Temperature
from rolamento.errors import ABSENT, InputError, guess, kind_of
from rolamento.io.text import (
    TextFormat,
    format_of_path,
    format_of_text,
    line_of,
    parse_mapping,
    read_text,
    text_of_mapping,
)
from rolamento.io.writing import write_mapping
from rolamento.units import readable, to_si
from rolamento.words import Note, said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = [
    "SHAFT_STEEL",
    "Belt",
    "Gear",
    "Gravity",
    "Housing",
    "Machine",
    "MachineBearing",
    "Mass",
    "PointForce",
    "Section",
    "Shaft",
    "ShaftLoad",
    "Spring",
    "Step",
    "load_machine",
    "machine_of_tables",
    "machine_reader",
    "machine_to_json",
    "machine_to_toml",
    "parse_machine",
    "parts_of_key",
    "save_machine",
    "with_changes",
    "with_settings",
    "with_values",
]

_ROUNDING: Final = 1e-9
_SHARES: Final = 1e-6
_RATIO: Final = 0.01
"""By how much the pitch-line speeds of gears in mesh may differ."""
_SEAT: Final = 0.05
"""By how much a shaft may differ from a bore before that is said."""
_DEGREES_OF_FREEDOM: Final = 5
_SEATS: Final = ("shaft", "housing", "inner_spacer", "outer_spacer")
"""Temperatures that act by way of the mounting alone."""
_SPACERS: Final = ("inner_spacer", "outer_spacer")

_Diameter = Annotated[float, Quantity("length", above="0 mm", at_most="20 m", varies=True)]
_Bore = Annotated[float, Quantity("length", at_least="0 mm", at_most="20 m", varies=True)]
_Factor = Annotated[float, Quantity(at_least=-100.0, at_most=100.0)]


# --- shafts ---------------------------------------------------------------------------------------

SHAFT_STEEL: Final = Material(
    name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="usual values"
)
"""What shafts are of if nothing is said."""


def _shaft_material(value: object) -> object:
    if isinstance(value, str) and value.strip().casefold() == SHAFT_STEEL.name:
        return SHAFT_STEEL
    return Material.name_or_table(value)


def _written_material(
    material: Material, handler: SerializerFunctionWrapHandler, info: SerializationInfo
) -> Any:
    if info.context == AT_THE_BORDER and material == SHAFT_STEEL:
        return SHAFT_STEEL.name
    return handler(material)


_ShaftMaterial = Annotated[
    Material,
    BeforeValidator(_shaft_material, json_schema_input_type=Material | str),
    WrapSerializer(_written_material),
]


class Section(Record):
    """A piece of a shaft: a cylinder, or a cone.

    Parameters
    ----------
    length
        In m.
    diameter
        Outside, at the left end of a cone, in m.
    bore
        Of a hollow shaft, at the left end, in m.
    end_diameter, end_bore
        Of a cone, at its right end, in m; as at the left end if not given.

    Raises
    ------
    InputError
        If a value is out of range, or a bore leaves no wall.
    """

    length: Annotated[float, Quantity("length", above="0 mm", at_most="100 m", varies=True)] = (
        Field(examples=["80 mm"])
    )
    diameter: _Diameter = Field(examples=["40 mm"])
    bore: _Bore = Field(0.0, examples=["10 mm"])
    end_diameter: _Diameter | None = Field(None, examples=["50 mm"])
    end_bore: _Bore | None = Field(None, examples=["10 mm"])

    @model_validator(mode="after")
    def _has_a_wall(self) -> Self:
        for field, inner, limit, outer in (
            ("bore", self.bore, "diameter", self.diameter),
            ("end_bore", self.right_bore, "end_diameter", self.right_diameter),
        ):
            if inner >= outer:
                named = field if getattr(self, field) is not None else "bore"
                raise InputError(
                    said(
                        "must be less than {limit}, {outer}",
                        limit=limit,
                        outer=readable(outer, "length"),
                    ),
                    field=named,
                    value=readable(inner, "length"),
                    example=f'{named} = "{readable(0.5 * outer, "length")}"',
                )
        return self

    @property
    def right_diameter(self) -> float:
        """Outside diameter at the right end; m."""
        return self.diameter if self.end_diameter is None else self.end_diameter

    @property
    def right_bore(self) -> float:
        """Bore at the right end; m."""
        return self.bore if self.end_bore is None else self.end_bore

    @property
    def tapers(self) -> bool:
        """Whether it is a cone, outside or inside."""
        return self.right_diameter != self.diameter or self.right_bore != self.bore


class Shaft(Record):
    """A shaft of sections, from its left end toward +x.

    Parameters
    ----------
    name
        What to call it; bearings and loads name it so.
    sections
        From left to right; in a file also the name of a table beside it, ``"shaft.csv"``, with the
        columns length, diameter, bore, end_diameter, end_bore and their units.
    speed
        About +x, in rad/s; or:
    ratio
        Its speed over that
    of
        of another shaft; negative where they turn against each other, as with a pair of gears.
    position
        Of its left end along the machine's x, in m.
    material
        A `Material`, its name or its table; steel of 206 GPa, 0.3 and 7850 kg/m³ if not given.

    Raises
    ------
    InputError
        If a value is missing or out of range.
    """

    name: Name = Field(examples=["shaft"])
    sections: tuple[Section, ...] = Field(
        min_length=1,
        max_length=MOST_SECTIONS,
        examples=['[{ length = "80 mm", diameter = "40 mm" }]'],
    )
    speed: Annotated[Speed, Replaces("ratio", "of")] = Field(0.0, examples=["1480 rpm"])
    ratio: Annotated[
        Annotated[float, Quantity(at_least=-1000.0, at_most=1000.0, varies=True)] | None,
        Replaces("speed"),
    ] = Field(None, examples=[-0.4])
    of: Annotated[Name | None, Replaces("speed")] = Field(None, examples=["input shaft"])
    position: Annotated[
        float, Quantity("length", at_least="-100 m", at_most="100 m", varies=True)
    ] = Field(0.0, examples=["0 mm"])
    material: _ShaftMaterial = Field(SHAFT_STEEL, examples=["steel"])

    @model_validator(mode="after")
    def _one_speed(self) -> Self:
        for missing, beside in (("of", "ratio"), ("ratio", "of")):
            if getattr(self, missing) is None and getattr(self, beside) is not None:
                raise InputError(
                    said("is missing; {beside} needs it", beside=beside),
                    field=missing,
                    example='ratio = -0.4, of = "input shaft"',
                )
        if self.ratio is not None and self.speed != 0.0:
            raise InputError(
                said("cannot be combined with {before}", before="ratio"),
                field="speed",
                value=readable(self.speed, "angular_speed"),
            )
        return self

    @property
    def length(self) -> float:
        """Length of all sections; m."""
        return math.fsum(section.length for section in self.sections)

    @property
    def youngs_modulus(self) -> float:
        """Modulus of elasticity E; Pa."""
        return self.material.youngs_modulus

    @property
    def poisson_ratio(self) -> float:
        """Poisson's ratio ν."""
        return self.material.poisson_ratio

    @property
    def shear_modulus(self) -> float:
        """Shear modulus G = E/(2 (1 + ν)); Pa."""
        return self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))

    @property
    def density(self) -> float:
        """Density ρ; kg/m³."""
        return self.material.density

    @property
    def edges(self) -> tuple[float, ...]:
        """Where sections begin and end, from the left end; m."""
        lengths = [section.length for section in self.sections]
        return tuple(math.fsum(lengths[:count]) for count in range(len(lengths) + 1))

    def diameters_at(self, position: float) -> tuple[float, ...]:
        """Return the outside diameter at a place, both of them at a shoulder; m.

        Parameters
        ----------
        position
            From the left end, in m.
        """
        slack = _ROUNDING * self.length
        found = []
        for section, left in zip(self.sections, self.edges, strict=False):
            part = (position - left) / section.length
            if -slack <= position - left <= section.length + slack:
                part = min(max(part, 0.0), 1.0)
                found.append(section.diameter + part * (section.right_diameter - section.diameter))
        return tuple(dict.fromkeys(found))


# --- stiffness ------------------------------------------------------------------------------------

Units = Literal["N/m", "N/mm"]
Numbers = tuple[float, ...]
Rows = tuple[tuple[float, ...], ...]
_SCALES: Final[dict[Units, tuple[float, float, float]]] = {
    "N/m": (1.0, 1.0, 1.0),
    "N/mm": (1e3, 1.0, 1e-3),
}
"""What shifts, a shift beside a tilt, and tilts count in SI, for a matrix in N and m or mm."""
_EXAMPLE: Final = 'stiffness = ["200 N/um", "150 N/um", "150 N/um"]'


def _stiffness(value: Any, units: Units | None, *, in_file: bool) -> Numbers | Rows:
    """Return 3 or 5 numbers, or a matrix, in SI.

    Raises
    ------
    InputError
        If it is neither, lacks units, or no structure has it.
    """
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, list | tuple) or len(value) not in (3, _DEGREES_OF_FREEDOM):
        raise InputError(
            said("must be 3 numbers (x, y, z), 5 (x, y, z, ry, rz) or a matrix of 5 rows"),
            value=value,
            example=_EXAMPLE,
        )
    if any(isinstance(row, list | tuple) for row in value):
        return _matrix(value, units, _DEGREES_OF_FREEDOM, in_file=in_file)
    found = []
    for place, entry in enumerate(value):
        tilts = place > 2
        if isinstance(entry, str):
            number = to_si(entry, "angular_stiffness" if tilts else "stiffness")
        else:
            _check_units(units, in_file=in_file)
            number = finite_number(entry) * _SCALES[units or "N/m"][2 if tilts else 0]
        if number < 0.0 or not math.isfinite(number):
            raise InputError(said("must be at least {at_least}", at_least="0"), value=entry,
                             example=_EXAMPLE)  # fmt: skip
        found.append(number)
    return tuple(found)


def _check_units(units: Units | None, *, in_file: bool) -> None:
    if in_file and units is None:
        raise InputError(
            said("needs units: write them behind the numbers, or give them for all"),
            example='units = "N/mm"',
        )


def _matrix(value: Any, units: Units | None, size: int, *, in_file: bool) -> Rows:
    """Return a symmetric, positive semi-definite matrix in SI.

    Raises
    ------
    InputError
        If it is none.
    """
    import numpy as np

    value = value.tolist() if hasattr(value, "tolist") else value
    wrong = not isinstance(value, list | tuple) or len(value) != size
    if wrong or any(not isinstance(row, list | tuple) or len(row) != size for row in value):
        raise InputError(
            said("must be a matrix of {size} rows and columns", size=size), value=value
        )
    _check_units(units, in_file=in_file)
    matrix = np.array([[finite_number(one) for one in row] for row in value])
    shift, mixed, tilt = _SCALES[units or "N/m"]
    tilts = np.arange(size) % _DEGREES_OF_FREEDOM > 2
    both = tilts[:, None].astype(int) + tilts
    matrix *= np.choose(both, (shift, mixed, tilt))
    matrix = elastic(matrix)
    return tuple(map(tuple, matrix.tolist()))


def _padded(stiffness: Numbers | Rows) -> NDArray[np.float64]:
    import numpy as np

    numbers = np.asarray(stiffness, dtype=float)
    if numbers.ndim == 2:
        return numbers
    return np.diag(np.pad(numbers, (0, _DEGREES_OF_FREEDOM - numbers.size)))


def _with_stiffness(given: Any, info: ValidationInfo) -> Any:
    """Return the fields of an elastic part with its stiffness in SI."""
    if not isinstance(given, Mapping):
        return given
    units, in_file = given.get("units"), info.context == AT_THE_BORDER
    if units is not None and not (isinstance(units, str) and units in _SCALES):
        return given  # which is refused
    result = dict(given)
    for name in ("stiffness", "matrix"):
        if (value := given.get(name)) is None:
            continue
        try:
            if name == "stiffness":
                result[name] = _stiffness(value, units, in_file=in_file)
            else:
                members = given.get("bearings")
                count = len(members) if isinstance(members, list | tuple) else 0
                size = _DEGREES_OF_FREEDOM * count
                result[name] = _matrix(value, units, size, in_file=in_file)
        except InputError as error:
            field = f"{name}.{error.field}" if error.field else name
            raise error.with_details(field=field) from None
    return {**result, "units": "N/m"}


_Stiffness = Annotated[
    Numbers | Rows,
    Field(examples=['["200 N/um", "150 N/um", "150 N/um"]']),
    WithJsonSchema(
        {
            "type": "array",
            "items": {
                "anyOf": [
                    {"type": "number"},
                    {"type": "string"},  # with a unit
                    {"type": "array", "items": {"type": "number"}},
                ]
            },
        }
    ),
]
_UnitsField = Annotated[Units, Field(examples=["N/mm"])]


class Housing(Record):
    """What stands under the outer rings of bearings, between them and the ground.

    Parameters
    ----------
    name
        What to call it; bearings name it so.
    stiffness
        3 numbers (x, y, z, in N/m; tilts are held), 5 numbers (and ry, rz, in N·m/rad) or a 5 × 5
        matrix in that order. Several bearings may name such a housing: each has one of its own.
    bearings, matrix
        Instead, names of bearings and one matrix over all of them, as a finite-element program
        reduces it: 5 rows a bearing, x, y, z, ry, rz, in the order of the names. In a file also
        the name of a table of numbers beside it, ``"housing.csv"``, or of a Matrix Market file,
        ``"housing.mtx"``.
    units
        Of numbers without a unit: ``"N/m"`` (N, m and rad) or ``"N/mm"`` (N, mm and rad). What is
        read is turned into SI, and this into ``"N/m"``.

    Raises
    ------
    InputError
        If a matrix is not symmetric, or not positive semi-definite.

    In a file `nodes` says what the rows of the matrix are, where they are not those of the bearings
    in order: a table beside it, ``"nodes.csv"``; `others` what becomes of the rest. In Python
    `of_nodes` takes them.
    """

    name: Name = Field(examples=["housing"])
    stiffness: _Stiffness | None = None
    bearings: Annotated[
        tuple[Name, ...],
        Field(max_length=MOST_UNKNOWNS // _DEGREES_OF_FREEDOM, examples=['["A", "B"]']),
    ] = ()
    matrix: Annotated[Rows | None, Field(examples=["housing.csv"])] = None
    units: _UnitsField = "N/m"

    @model_validator(mode="before")
    @classmethod
    def _in_si(cls, given: Any, info: ValidationInfo) -> Any:
        if isinstance(given, Mapping) and given.get("matrix") is not None:
            members = given.get("bearings")
            if not isinstance(members, list | tuple) or not members:
                raise InputError(
                    said("is missing; {beside} needs it", beside="matrix"),
                    field="bearings",
                    example='bearings = ["A", "B"]',
                )
        return _with_stiffness(given, info)

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if self.stiffness is not None and self.matrix is not None:
            raise InputError(
                said("cannot be combined with {before}", before="stiffness"), field="matrix"
            )
        if self.matrix is None and self.bearings:
            raise InputError(
                said("is missing; {beside} needs it", beside="bearings"),
                field="matrix",
                example='matrix = "housing.csv"',
            )
        if self.stiffness is None and self.matrix is None:
            raise InputError(
                said("is missing; or matrix and bearings"), field="stiffness", example=_EXAMPLE
            )
        _refuse_repeated(self.bearings, "bearings")
        return self

    @classmethod
    def of_nodes(
        cls,
        name: str,
        matrix: Sequence[Sequence[float]] | NDArray[np.float64],
        nodes: Sequence[Mapping[str, Any]],
        *,
        bearings: Sequence[str] = (),
        units: Units | None = None,
        others: Others | None = None,
    ) -> Self:
        """Return the housing of a matrix over nodes in the order and units of a program.

        Parameters
        ----------
        name
            What to call it.
        matrix, nodes, bearings, units, others
            As of a machine file: what each row is, such as ``{"node": 1041, "dof": "x",
            "displacement": "mm", "force": "N", "bearing": "A"}``; rows of no ring are
            ``"free"`` or ``"held"``.

        Raises
        ------
        InputError
            If list and matrix do not fit, or no structure has the matrix.
        """
        rows = matrix.tolist() if hasattr(matrix, "tolist") else matrix
        names, stiffness = reduced_to_rings(
            rows, nodes, bearings=bearings, units=units, others=others
        )
        return cls(name=name, bearings=names, matrix=stiffness)

    @property
    def holds_tilt(self) -> bool:
        """Whether it lets no outer ring tilt: three numbers are given."""
        return self.stiffness is not None and len(self.stiffness) == 3

    @property
    def stiffness_matrix(self) -> NDArray[np.float64]:
        """Its matrix in SI, 5 × 5 or 5 rows for each of its bearings; tilts that are held zero."""
        return _padded(cast("Rows", self.matrix) if self.stiffness is None else self.stiffness)


class Spring(Record):
    """An elastic part between a shaft and the ground, or another shaft.

    Parameters
    ----------
    name
        What to call it.
    shaft, position
        Where it holds on, from the shaft's left end, in m.
    stiffness
        3 numbers (x, y, z, in N/m), 5 (and ry, rz, in N·m/rad) or a 5 × 5 matrix in that order.
    to_shaft, to_position
        The other end; the ground if not given.
    units
        As of a `Housing`.

    Raises
    ------
    InputError
        As of a `Housing`.
    """

    name: Line = Field("", examples=["coupling"])
    shaft: Name = Field(examples=["shaft"])
    position: Place = Field(examples=["150 mm"])
    stiffness: _Stiffness
    to_shaft: Name | None = Field(None, examples=["other shaft"])
    to_position: Place | None = Field(None, examples=["0 mm"])
    units: _UnitsField = "N/m"

    @model_validator(mode="before")
    @classmethod
    def _in_si(cls, given: Any, info: ValidationInfo) -> Any:
        return _with_stiffness(given, info)

    @model_validator(mode="after")
    def _both_ends(self) -> Self:
        for missing, beside in (("to_position", "to_shaft"), ("to_shaft", "to_position")):
            if getattr(self, missing) is None and getattr(self, beside) is not None:
                raise InputError(
                    said("is missing; {beside} needs it", beside=beside),
                    field=missing,
                    example='to_shaft = "other shaft", to_position = "0 mm"',
                )
        return self

    @property
    def stiffness_matrix(self) -> NDArray[np.float64]:
        """Its 5 × 5 matrix in SI."""
        return _padded(self.stiffness)


# --- bearings -------------------------------------------------------------------------------------


class _CaseTable(dict[str, Any]):
    """A table of a case as a file has it, not to be changed; hashable by value."""

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(json.dumps(self, sort_keys=True, default=str))


def _given_in(table: Any) -> Any:
    """Return a table without what is null in JSON; anything else as it is."""
    if not isinstance(table, Mapping):
        return table
    return _CaseTable(
        {name: _given_in(value) for name, value in table.items() if value is not None}
    )


_Table = Annotated[Any, Field(examples=["[bearings.lubricant] as a table"])]


def _file_form(name: str, value: Any) -> Any:
    """Return a table of a case, a record, or a part of them, as a file has it."""
    if isinstance(value, Record):
        return value.model_dump(context=AT_THE_BORDER, exclude_none=True, exclude_unset=True)
    if isinstance(value, Mapping):
        return {key: _file_form(f"{name}.{key}", inner) for key, inner in value.items()}
    field = fields_of(Case).get(name)
    if isinstance(value, list | tuple):
        entries = field.entries if field is not None else {}
        return [
            {
                key: entries[key].written(inner) if key in entries else inner
                for key, inner in entry.items()
            }
            if isinstance(entry, Mapping)
            else _file_form(name, entry)
            for entry in value
        ]
    if field is None or field.dimension is None or isinstance(value, str | bool | None):
        return value
    return field.written(value)


def _over(tables: Mapping[str, Any], name: str, table: Any) -> dict[str, Any]:
    """Return the tables of a case with one over what is there: field by field, or as a whole."""
    below = tables.get(name)
    whole = name in ("bearing", "lubricant") or not isinstance(table, Mapping)
    if whole or not isinstance(below, Mapping):
        return {**tables, name: table}
    values = {f"{name}.{leaf}": value for leaf, value in table.items()}
    return changed(tables, values, Case, in_file=True)


class MachineBearing(Record):
    """A bearing on a shaft of a machine.

    What is not given of model, lubricant, surface, temperature, film, heat, life is the machine's,
    field by field (a lubricant as a whole).

    Parameters
    ----------
    name
        What to call it.
    shaft
        On which its inner ring is.
    position
        Of its middle from the shaft's left end, in m; of a single row that of its elements.
    designation
        Of the catalogue; or:
    bearing
        The table of a case, a `Bearing` or a `RollerBearing`. In a file also `case`, the name of a
        case file beside it, and in Python a `Case`: its duty counts nothing.
    model, lubricant, surface, temperature, mounting, film, heat, life
        Tables of a case, for this bearing alone.
    faces
        Which way it carries axial load: ``"+x"`` where the shaft may push its inner ring toward
        +x; a set is turned round by ``"-x"``. As the bearing itself has it if not given. Two rows
        back to back (O): the left one faces ``"+x"``, the right one ``"-x"``.
    located
        How the outer ring is held along x: ``"both"``; ``"+x"`` or ``"-x"``, against motion in that
        direction only; ``"floating"``, free to slide in its seat.
    spring_force
        Of springs on a floating outer ring, which press the row in, in N.
    outer_shaft
        On which the outer ring is, of a bearing between two shafts.
    housing
        Name of the housing under its outer ring; rigid if not given.
    offset
        How far a single row is pressed in, in m; or
    preload
        by which force, in N. Sets have that of their bearing.

    Raises
    ------
    InputError
        If a value is missing or out of range, or values contradict each other.
    """

    name: Name = Field(examples=["A"])
    shaft: Name = Field(examples=["shaft"])
    position: Place = Field(examples=["20 mm"])
    designation: Designation | None = Field(None, examples=["6308"])
    bearing: _Table = None
    model: _Table = None
    lubricant: _Table = None
    surface: _Table = None
    temperature: _Table = None
    mounting: _Table = None
    film: _Table = None
    heat: _Table = None
    life: _Table = None
    faces: Literal["+x", "-x"] | None = Field(None, examples=["-x"])
    located: Literal["both", "+x", "-x", "floating"] = Field("both", examples=["floating"])
    spring_force: (
        Annotated[float, Quantity("force", at_least="0 N", at_most="1e6 kN", varies=True)] | None
    ) = Field(None, examples=["300 N"])
    outer_shaft: Name | None = Field(None, examples=["hollow shaft"])
    housing: Name | None = Field(None, examples=["housing"])
    offset: Annotated[
        Annotated[float, Quantity("length", at_least="-1 mm", at_most="1 mm", varies=True)] | None,
        Replaces("preload"),
    ] = Field(None, examples=["5 um"])
    preload: Annotated[
        Annotated[float, Quantity("force", at_least="0 N", at_most="1e6 kN", varies=True)] | None,
        Replaces("offset"),
    ] = Field(None, examples=["500 N"])

    _shared: dict[str, Any] = PrivateAttr(default_factory=dict)
    """Tables of the machine, as a file has them."""

    @model_validator(mode="before")
    @classmethod
    def _with_tables(cls, given: Any, info: ValidationInfo) -> Any:
        """Take the tables of a case, however they are given, as a file has them."""
        if not isinstance(given, Mapping):
            return given
        in_file = info.context == AT_THE_BORDER
        result = {name: value for name, value in given.items() if name != "case"}
        tables = _tables_of_case(given.get("case"), in_file=in_file)
        for name in CASE_TABLES:
            if (table := given.get(name)) is None:
                continue
            if not isinstance(table, Mapping | Record | str):
                raise InputError(said("must be a table"), field=name, value=table)
            tables = _over(tables, name, table if in_file else _file_form(name, table))
        for name, table in tables.items():
            result[name] = _given_in(table)
        return result

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        within = self.bearing.get("designation") if isinstance(self.bearing, Mapping) else None
        if self.designation is not None and within is not None:
            raise InputError(said("is given twice"), field="bearing.designation", value=within)
        if self.designation is None and self.bearing is None:
            raise InputError(
                said("is missing; or the bearing as a table, or a case file"),
                field="designation",
                example='designation = "6308"',
            )
        for name, before in (("preload", "offset"), ("housing", "outer_shaft")):
            if getattr(self, name) is not None and getattr(self, before) is not None:
                raise InputError(
                    said("cannot be combined with {before}", before=before), field=name
                )
        if self.spring_force is not None and self.located != "floating":
            raise InputError(
                said('is for located = "floating": it slides the outer ring in its seat'),
                field="spring_force",
                value=readable(self.spring_force, "force"),
                example='located = "floating"',
            )
        return self

    @cached_property
    def case(self) -> Case:
        """The bearing with its lubricant, temperature, life and so on, and an empty duty.

        Raises
        ------
        InputError
            If that is no valid case.
        """
        own = {name: table for name in CASE_TABLES if (table := getattr(self, name)) is not None}
        tables = {name: table for name, table in self._shared.items() if table is not None}
        if isinstance(warm := tables.get("temperature"), Mapping):
            bearing = own.get("bearing") or {}
            is_set = isinstance(bearing, Mapping) and {"arrangement", "rows"} & bearing.keys()
            unused = (() if is_set else _SPACERS) if "mounting" in own else _SEATS
            tables["temperature"] = {
                name: value for name, value in warm.items() if name not in unused
            }
        for name, table in own.items():
            tables = _over(tables, name, table)
        if self.designation is not None:
            bearing = tables.get("bearing", {})
            if not isinstance(bearing, Mapping):
                raise InputError(said("must be a table"), field="bearing", value=bearing)
            tables["bearing"] = {"designation": self.designation, **bearing}
        try:
            return Case.from_mapping({**tables, "title": self.name, "duty": {}})
        except InputError as error:
            if self.designation is not None and error.field == "bearing.designation":
                raise error.with_details(field="designation") from None
            raise

    @property
    def turned(self) -> bool:
        """Whether it is mounted the other way round than its case has it."""
        return self.faces == "-x"

    @property
    def side(self) -> int:
        """The sign s of its rows: +1 as its case has it, -1 turned round."""
        return -1 if self.turned else 1

    def _in_machine(self, shared: Mapping[str, Any]) -> Self:
        """Return a copy that has the machine's tables besides its own."""
        copied = self.model_copy()
        copied.__dict__.pop("case", None)
        cast("dict[str, Any]", copied.__pydantic_private__)["_shared"] = dict(shared)
        return copied


def _tables_of_case(case: Any, *, in_file: bool) -> dict[str, Any]:
    """Return the tables of a case that are the bearing's, as a file has them."""
    if case is None:
        return {}
    if isinstance(case, Mapping) and in_file:
        return {name: case[name] for name in CASE_TABLES if case.get(name) is not None}
    if isinstance(case, Case) and not in_file:
        given = {name: getattr(case, name) for name in CASE_TABLES if name in case.model_fields_set}
        return {name: _file_form(name, table) for name, table in given.items() if table is not None}
    raise InputError(
        said("must be the name of a case file; in Python a Case"),
        field="case",
        value=kind_of(case),
        example='case = "6308.toml"',
    )


# --- the machine ----------------------------------------------------------------------------------


class Step(Record):
    """A step of a spectrum: how fast and how heavily loaded, for which share of the time.

    Parameters
    ----------
    name
        What to call it.
    share
        Of the time, 0 to 1; those of all steps sum to 1.
    speed_factor
        By which the speeds of all shafts are multiplied.
    load_factor
        By which forces, moments and torques are multiplied; weights are not.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    name: Line = Field("", examples=["idling"])
    share: Annotated[float, Quantity(at_least=0.0, at_most=1.0)] = Field(examples=[0.25])
    speed_factor: _Factor = Field(1.0, examples=[0.5])
    load_factor: _Factor = Field(1.0, examples=[1.5])


class PointForce(NamedTuple):
    """Force and moment on a shaft at a place.

    source: the dotted field of the machine that it comes from, such as ``"gears.0"``; force: fx,
    fy, fz, mx, my, mz, in N and N·m.
    """

    source: str
    name: str
    shaft: str
    position: float
    force: Six


_SHARED: Final = ("model", "lubricant", "surface", "temperature", "film", "heat", "life")
_ON_SHAFTS: Final = ("bearings", "springs", "loads", "gears", "belts", "masses")


class Machine(Record):
    """Shafts, their bearings, and what acts on them.

    Parameters
    ----------
    title
        One line, at most 200 characters.
    shafts
        `Shaft` records, at most 20.
    bearings
        `MachineBearing` records, at most 100.
    housings, springs, loads, gears, belts, masses
        `Housing`, `Spring`, `ShaftLoad`, `Gear`, `Belt` and `Mass` records.
    gravity
        A `Gravity`; weights count nothing without it.
    spectrum
        `Step` records, whose shares sum to 1; without them there is one load.
    model, lubricant, surface, temperature, film, heat, life
        As of a `Case`, for all bearings that have none of their own.

    Raises
    ------
    InputError
        If a part is missing or not valid, or the parts contradict each other.
    """

    title: Line = Field("", examples=["Gear shaft"])
    shafts: tuple[Shaft, ...] = Field(
        min_length=1, max_length=20, examples=["[[shafts]] as a table"]
    )
    bearings: tuple[MachineBearing, ...] = Field(
        (), max_length=100, examples=["[[bearings]] as a table"]
    )
    housings: tuple[Housing, ...] = Field((), max_length=100, examples=["[[housings]] as a table"])
    springs: tuple[Spring, ...] = Field((), max_length=200, examples=["[[springs]] as a table"])
    loads: tuple[ShaftLoad, ...] = Field((), max_length=500, examples=["[[loads]] as a table"])
    gears: tuple[Gear, ...] = Field((), max_length=100, examples=["[[gears]] as a table"])
    belts: tuple[Belt, ...] = Field((), max_length=100, examples=["[[belts]] as a table"])
    masses: tuple[Mass, ...] = Field((), max_length=500, examples=["[[masses]] as a table"])
    gravity: Gravity | None = Field(None, examples=["[gravity] as a table"])
    spectrum: tuple[Step, ...] = Field((), max_length=10_000, examples=["[[spectrum]] as a table"])
    model: Model | None = Field(None, examples=["[model] as a table"])
    lubricant: LubricantField | None = Field(None, examples=["ISO VG 68"])
    surface: Surface | None = Field(None, examples=["[surface] as a table"])
    temperature: Temperature | None = Field(None, examples=["[temperature] as a table"])
    film: FilmModel | None = Field(None, examples=["[film] as a table"])
    heat: Heat | None = Field(None, examples=["[heat] as a table"])
    life: LifeModel | None = Field(None, examples=["[life] as a table"])

    @model_validator(mode="wrap")
    @classmethod
    def _checked(cls, given: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        machine = handler(given)
        if machine is given:
            return machine
        shared = {
            name: table.to_mapping()
            for name in _SHARED
            if (table := getattr(machine, name)) is not None
        }
        machine.__dict__["bearings"] = tuple(one._in_machine(shared) for one in machine.bearings)
        machine._check()
        return machine

    def _check(self) -> None:
        """Refuse parts that do not go together."""
        _check_names(self)
        _check_speeds(self)
        for kind in _ON_SHAFTS:
            for index, part in enumerate(getattr(self, kind)):
                _check_place(self, part.shaft, part.position, f"{kind}.{index}")
        for index, spring in enumerate(self.springs):
            if spring.to_shaft is not None and spring.to_position is not None:
                field = f"springs.{index}"
                _check_place(self, spring.to_shaft, spring.to_position, field, "to_")
        for index, bearing in enumerate(self.bearings):
            _check_bearing(self, bearing, f"bearings.{index}")
        _check_housings(self)
        for index, gear in enumerate(self.gears):
            _check_mate(self, gear, f"gears.{index}")
        _check_spectrum(self)
        self.forces()

    def to_mapping(self) -> dict[str, Any]:
        """Return the tables of its file, without lists and names that are empty."""
        mapping = _without_empty(super().to_mapping())
        for kind, parts in mapping.items():
            if isinstance(parts, list | tuple):
                mapping[kind] = [_without_empty(part) for part in parts]
        return mapping

    def shaft(self, name: str) -> Shaft:
        """Return a shaft by its name.

        Raises
        ------
        InputError
            If there is none.
        """
        return _of_name(self.shafts, name, "shaft")

    def bearing(self, name: str) -> MachineBearing:
        """Return a bearing by its name; errors as of `shaft`."""
        return _of_name(self.bearings, name, "bearing")

    def housing(self, name: str) -> Housing:
        """Return a housing by its name; errors as of `shaft`."""
        return _of_name(self.housings, name, "housing")

    def gear(self, name: str) -> Gear:
        """Return a gear by its name; errors as of `shaft`."""
        return _of_name(self.gears, name, "gear")

    def housing_of(self, bearing: str) -> Housing | None:
        """Return the housing under a bearing's outer ring; None where it is rigid."""
        own = self.bearing(bearing).housing
        if own is not None:
            return self.housing(own)
        return next((one for one in self.housings if bearing in one.bearings), None)

    def speed(self, shaft: str, factor: float = 1.0) -> float:
        """Return the speed of a shaft about +x; rad/s.

        Parameters
        ----------
        shaft
            Its name.
        factor
            By which it is multiplied.

        Raises
        ------
        InputError
            If there is no such shaft.
        """
        one = self.shaft(shaft)
        while one.ratio is not None and one.of is not None:
            factor *= one.ratio
            one = self.shaft(one.of)
        return factor * one.speed + 0.0

    @property
    def step_shares(self) -> NDArray[np.float64]:
        """Shares of the time of the steps of the spectrum, or 1; (steps,)."""
        import numpy as np

        return np.array([step.share for step in self.spectrum] or [1.0])

    def outer_position(self, bearing: str) -> float:
        """Return where a bearing between two shafts is on its outer shaft, from its left end; m."""
        one = self.bearing(bearing)
        if one.outer_shaft is None:
            raise InputError(said("is not between two shafts"), field="bearing", value=bearing)
        return one.position + self.shaft(one.shaft).position - self.shaft(one.outer_shaft).position

    def forces(self, step: Step | None = None) -> tuple[PointForce, ...]:
        """Return forces and moments of loads, gears and belts on the shafts.

        Weights and unbalance are not among them: see `gravity` and `masses`.

        Parameters
        ----------
        step
            Of the spectrum; powers are taken at full speed.

        Raises
        ------
        InputError
            If a power is given and the shaft does not turn, or a belt would slip.
        """
        faster, heavier = (1.0, 1.0) if step is None else (step.speed_factor, step.load_factor)
        found = []
        for index, load in enumerate(self.loads):
            force = cast("Six", tuple(heavier * part + 0.0 for part in load.forces()))
            found.append(_point(f"loads.{index}", load, force))
        for index, gear in enumerate(self.gears):
            try:
                force = self._gear_forces(gear, faster, heavier)
            except InputError as error:
                raise _within(f"gears.{index}", error) from None
            found.append(_point(f"gears.{index}", gear, force))
        for index, belt in enumerate(self.belts):
            nominal = self.speed(belt.shaft)
            try:
                pulled = _scaled(belt, nominal, heavier).forces(nominal * faster)
            except InputError as error:
                raise _within(f"belts.{index}", error) from None
            found.append(_point(f"belts.{index}", belt, pulled))
        return tuple(found)

    def _gear_forces(self, gear: Gear, faster: float, heavier: float) -> Six:
        giver = self.gear(gear.mate) if gear.follows_mate and gear.mate else gear
        nominal = self.speed(giver.shaft)
        # a torque without a sign: a load factor below zero turns the power round
        torque, drives = giver.torque_at(nominal) * heavier, bool(giver.drives)
        loaded = giver.model_copy(
            update={"torque": abs(torque), "power": None, "drives": drives == (heavier >= 0.0)}
        )
        forces = loaded.forces(nominal * faster)
        return forces if giver is gear else mirrored(gear, giver, forces)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is unusual, though not wrong: bearings that do not fit their seats by far."""
        found = []
        for bearing in self.bearings:
            published, mounting = bearing.case.bearing.published, bearing.case.mounting
            bore = mounting.bore if mounting is not None else getattr(published, "bore", None)
            if bore is None:
                continue
            seats = self.shaft(bearing.shaft).diameters_at(bearing.position)
            nearest = min(seats, key=lambda seat: abs(seat - bore))
            if abs(nearest - bore) > _SEAT * bore:
                values = {"bearing": bearing.name, "bore": bore, "seat": nearest}
                found.append(Note("bore_beside_shaft", values))
        return tuple(found)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Machine:
        """Read a machine file; as `load_machine`."""
        return load_machine(path)

    @classmethod
    def from_toml(cls, text: str, folder: str | os.PathLike[str] | None = None) -> Machine:
        """Return the machine that a TOML text describes; as `parse_machine`."""
        return parse_machine(text, format="toml", folder=folder)

    def to_toml(self) -> str:
        """Return the machine as the text of a TOML file, which reads back identically."""
        return machine_to_toml(self)

    def to_json(self) -> str:
        """Return the machine as the text of a JSON file, which reads back identically."""
        return machine_to_json(self)


def load_machine(path: str | os.PathLike[str], settings: Iterable[str] = ()) -> Machine:
    """Read a machine file, and the files beside it that it names.

    Parameters
    ----------
    path
        A TOML or JSON file, distinguished by the name's ending, else by the first character;
        ``"-"`` for standard input; or a workbook (.xlsx), one sheet a table.
    settings
        Texts ``KEY=VALUE`` that go over the file: parts of a list by their names, or by their
        numbers from 0, such as ``bearings.A.designation=6310`` or ``loads.0.fz=-8 kN``.

    Returns
    -------
    Machine
        Validated, every quantity in SI units.

    Raises
    ------
    FileError
        If a file cannot be read.
    InputError
        If it does not describe a valid machine, with the line number.
    """
    return machine_reader(path)(settings)


_Values = Iterable[tuple[Sequence[str], object]]


class MachineReader(Protocol):
    """Makes a machine of what was read, under settings and values that go over it."""

    def __call__(self, settings: Iterable[str], values: _Values = ()) -> Machine:
        """Return the machine; as `load_machine`."""
        ...


def machine_reader(path: str | os.PathLike[str]) -> MachineReader:
    """Read a machine file once; return what makes the machine of it under some changes.

    Parameters and errors as of `load_machine`; beside settings also values as of `with_values`.
    """
    if holds_sheets(path):
        return _workbook_reader(path)
    text, source = read_text(path)
    folder = "" if os.fspath(path) == "-" else os.path.dirname(os.fspath(path))

    def read(settings: Iterable[str], values: _Values = ()) -> Machine:
        return _parsed(text, format_of_path(path), source, folder, settings, values)

    return read


def _workbook_reader(path: str | os.PathLike[str]) -> MachineReader:
    """As `machine_reader`, of a workbook, one sheet a table."""
    mapping = read_sheets(path)

    def read(settings: Iterable[str], values: _Values = ()) -> Machine:
        whole = with_values(with_settings(mapping, settings), values)
        try:
            return Machine.from_mapping(with_files(whole, os.path.dirname(os.fspath(path))))
        except InputError as error:
            raise error if error.source else error.with_details(source=os.fspath(path)) from None

    return read


def parse_machine(
    text: str,
    *,
    format: TextFormat | None = None,
    source: str = "",
    folder: str | os.PathLike[str] | None = None,
    settings: Iterable[str] = (),
) -> Machine:
    """Return the machine that a TOML or JSON text describes.

    Parameters
    ----------
    text
        The text of a machine file.
    format
        ``"toml"``, ``"json"``, or None to go by the first character.
    source
        What to call the text in messages.
    folder
        In which files that it names are; without one it may name none.
    settings
        As of `load_machine`.

    Raises
    ------
    FileError, InputError
        As `load_machine`.
    """
    return _parsed(text, format, source, folder, settings)


def _parsed(
    text: str,
    format: TextFormat | None,
    source: str,
    folder: str | os.PathLike[str] | None,
    settings: Iterable[str],
    values: _Values = (),
) -> Machine:
    known_format = format or format_of_text(text)
    given = parse_mapping(text, known_format, source)
    changed = with_settings(given, settings)
    try:
        return Machine.from_mapping(with_files(with_values(changed, values), folder))
    except InputError as error:
        if error.source:
            raise
        if _value_at(given, error.field) != _value_at(changed, error.field):
            raise error.with_details(source=OVERRIDE_SOURCE) from None
        line = line_of(error.field, lines_of_machine(text, known_format))
        raise error.with_details(source=source, line=line) from None


def machine_of_tables(
    mapping: Mapping[str, Any], values: Mapping[str, Any] | None = None
) -> Machine:
    """Return the machine that the tables of a file describe, which may name no other file.

    Parameters
    ----------
    mapping
        As a file has them.
    values
        That go over them, as of `with_changes`.

    Raises
    ------
    InputError
        If they do not describe a valid machine, or name a file.
    """
    return Machine.from_mapping(with_files(with_changes(mapping, values or {}), None))


_PART: Final = re.compile(r'\s*(?:"([^"]*)"|([^.="]+?))\s*(\.|=)')
"""A name of a dotted key, in quotes where it has a dot, and what comes behind it."""
_LONGEST_NAME: Final = 100
_INLINE: Final = """'loads.0={ shaft = "shaft", position = "50 mm", fz = "-8 kN" }'"""


def with_settings(mapping: Mapping[str, Any], settings: Iterable[str]) -> dict[str, Any]:
    """Return the tables of a machine file with some values set; they are not validated.

    Raises
    ------
    InputError
        If a setting is not ``KEY=VALUE``, or names a part that is not there.
    """
    values = []
    try:
        for setting in settings:
            names, text = _parted(setting)
            inline = text.startswith(("{", "["))
            value = inline_value(".".join(names), text, _INLINE) if inline else plain_value(text)
            values.append((names, value))
        return with_values(mapping, values)
    except InputError as error:
        raise error.with_details(source=OVERRIDE_SOURCE) from None


def with_values(
    mapping: Mapping[str, Any], values: Iterable[tuple[Sequence[str], object]]
) -> dict[str, Any]:
    """Return the tables of a machine file with some values set; they are not validated.

    Parameters
    ----------
    mapping
        The tables, which stay as they are.
    values
        The parts of a key, as of `parts_of_key`, and what a file has there.

    Raises
    ------
    InputError
        If a key names a part that is not there.
    """
    result = dict(mapping)
    for names, value in values:
        _set(result, names, value)
    return result


def _value_at(tables: Any, field: str) -> Any:
    """What tables have at the dotted name of a field, or at the last part of it that is there."""
    for name in field.split("."):
        try:
            tables = tables[int(name) if isinstance(tables, list) else name]
        except (IndexError, KeyError, TypeError, ValueError):
            break
    return tables if not isinstance(tables, dict | list) else None


def with_changes(mapping: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """As `with_values`, by the dotted keys of fields; None takes a value away.

    Raises
    ------
    InputError
        If a key is none, or names a part that is not there.
    """
    return with_values(mapping, [(parts_of_key(key), value) for key, value in changes.items()])


def parts_of_key(key: str) -> tuple[str, ...]:
    """Return the parts of the dotted key of a field, without the quotes around names.

    Raises
    ------
    InputError
        If it is none.
    """
    try:
        names, rest = _parted(f"{key}=")
    except InputError:
        names, rest = [], ""
    if rest or not names:
        rule = said("is not the key of a field")
        raise InputError(rule, field=key[:_LONGEST_NAME], example="loads.0.fz")
    return tuple(names)


def _parted(setting: str) -> tuple[list[str], str]:
    """The names of a dotted key, and what stands behind it."""
    names, at = [], 0
    while len(setting) <= LONGEST_SETTING and (found := _PART.match(setting, at)):
        names.append(found[1] if found[1] is not None else found[2])
        at = found.end()
        if found[3] == "=":
            return names, setting[at:].strip()
    raise InputError(said("must be KEY=VALUE"), value=setting, example="loads.0.fz=-8 kN")


def _set(mapping: dict[str, Any], names: Sequence[str], value: object) -> None:
    """Put a value under some names, copying what is on its way."""
    table: Any = mapping
    for depth, name in enumerate(names, start=1):
        here = ".".join(names[:depth])
        key: Any = _place_in(table, name, here) if isinstance(table, list) else name
        if depth == len(names):
            if value is not None:
                table[key] = value
            elif isinstance(table, dict):
                table.pop(key, None)
            else:
                del table[key]
            return
        if value is None and isinstance(table, dict) and key not in table:
            return
        below = table[key] if isinstance(table, list) else table.get(key, _unsaid(name, depth))
        if isinstance(below, str) and name in _SPELT_OUT:
            below = _spelt_out(name, below, here)
        if not isinstance(below, dict | list | tuple):
            raise InputError(said("must be a table"), field=here)
        table[key] = dict(below) if isinstance(below, dict) else list(below)
        table = table[key]


_SPELT_OUT: Final[dict[str, type[Record]]] = {"material": Material, "lubricant": Lubricant}
"""Tables that a text may stand for, by their keys."""


def _unsaid(name: str, depth: int) -> Any:
    """What stands where nothing is given."""
    if name == "material":
        return SHAFT_STEEL.name
    return [] if depth == 1 and name in ("shafts", "housings", *_ON_SHAFTS, "spectrum") else {}


def _spelt_out(name: str, text: str, field: str) -> dict[str, Any]:
    """The table that a text stands for, so that a field can be set in it."""
    if name == "material" and text.strip().casefold() == SHAFT_STEEL.name:
        return SHAFT_STEEL.to_mapping()
    try:
        return _SPELT_OUT[name].table_of_text(text)
    except InputError as error:
        raise error.with_details(field=field) from None


def _place_in(parts: list[Any], name: str, field: str) -> int:
    """Where a part of a list is, by its name or its number."""
    known = [str(part.get("name", "")) for part in parts if isinstance(part, dict)]
    if name in known:
        return known.index(name)
    if name.isascii() and name.isdigit() and len(name) < 6 and int(name) < len(parts):
        return int(name)
    raise _unknown(name, [one for one in known if one], field)


def machine_to_toml(machine: Machine) -> str:
    """Return a machine as the text of a TOML file; `parse_machine` reads the identical one back."""
    return text_of_mapping(machine.to_mapping(), "toml")


def machine_to_json(machine: Machine) -> str:
    """Return a machine as the text of a JSON file; `parse_machine` reads the identical one back."""
    return text_of_mapping(machine.to_mapping(), "json")


def save_machine(machine: Machine, path: str | os.PathLike[str]) -> None:
    """Write a machine to a file; `load_machine` reads the identical machine back.

    Parameters
    ----------
    machine
        The machine.
    path
        A name that ends in ``.toml`` or ``.json``.

    Raises
    ------
    FileError
        If the name ends otherwise or the file cannot be written.
    """
    write_mapping(machine.to_mapping(), path, example="machine.toml")


# --- what goes together ---------------------------------------------------------------------------


def _without_empty(table: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in table.items() if value not in ("", (), [])}


def _point(source: str, part: ShaftLoad | Gear | Belt, force: Six) -> PointForce:
    return PointForce(source, part.name, part.shaft, part.position, force)


def _scaled(belt: Belt, nominal: float, heavier: float) -> Belt:
    """A belt under more or less load: its torque changes, or the pulls of both strands."""
    if belt.tight is not None and belt.slack is not None:
        pulls = {"tight": abs(heavier) * belt.tight, "slack": abs(heavier) * belt.slack}
        return belt.model_copy(update={**pulls, "drives": belt.drives == (heavier >= 0.0)})
    tight, slack = belt.strands(nominal)
    torque = 0.5 * belt.diameter * (tight - slack) * heavier
    turned = {"drives": belt.drives == (heavier >= 0.0)}
    return belt.model_copy(update={"torque": abs(torque), "power": None, **turned})


def _within(table: str, error: InputError) -> InputError:
    """An error of a part, with the place of the part."""
    return error.with_details(field=f"{table}.{error.field}" if error.field else table)


_Part = TypeVar("_Part", Shaft, MachineBearing, Housing, Gear)


def _of_name(parts: Sequence[_Part], name: str, kind: str) -> _Part:
    for part in parts:
        if part.name == name:
            return part
    raise _unknown(name, (part.name for part in parts if part.name), kind)


def _refuse_repeated(names: Iterable[str], field: str) -> None:
    seen: set[str] = set()
    for index, name in enumerate(names):
        if name in seen:
            raise InputError(said("is given twice"), field=f"{field}.{index}", value=name)
        seen.add(name)


def _unknown(name: str, known: Iterable[str], field: str) -> InputError:
    known = tuple(known)
    rule = said("is an unknown name; {guess}", guess=guess(name, known))
    if not known:
        rule = said("is an unknown name: there is none of this kind")
    return InputError(rule, field=field, value=name)


def _check_names(machine: Machine) -> None:
    for kind in ("shafts", *_ON_SHAFTS, "housings"):
        seen: set[str] = set()
        for index, part in enumerate(getattr(machine, kind)):
            if part.name and part.name in seen:
                raise InputError(
                    said("is given twice"), field=f"{kind}.{index}.name", value=part.name
                )
            seen.add(part.name)
    if not machine.bearings:
        raise InputError(
            said("is missing: a machine has at least one bearing"),
            field="bearings",
            value=ABSENT,
            example="[[bearings]] as a table",
        )


def _check_speeds(machine: Machine) -> None:
    """Refuse ratios to shafts that nobody knows, and loops of them."""
    shafts = {shaft.name: shaft for shaft in machine.shafts}
    for index, shaft in enumerate(machine.shafts):
        one, seen = shaft, {shaft.name}
        while one.of is not None:
            if one.of not in shafts:
                place = machine.shafts.index(one)
                raise _unknown(one.of, shafts, f"shafts.{place}.of")
            if one.of in seen:
                raise InputError(
                    said("closes a loop of ratios: no shaft in it has a speed of its own"),
                    field=f"shafts.{index}.of",
                    value=shaft.of,
                    example='speed = "1480 rpm"',
                )
            one = shafts[one.of]
            seen.add(one.name)


def _check_place(
    machine: Machine, shaft: str, position: float, field: str, prefix: str = ""
) -> None:
    known = {one.name: one for one in machine.shafts}
    if shaft not in known:
        raise _unknown(shaft, known, f"{field}.{prefix}shaft")
    length = known[shaft].length
    if not -_ROUNDING * length <= position <= length * (1.0 + _ROUNDING):
        raise _outside(position, shaft, length, f"{field}.{prefix}position")


def _outside(position: float, shaft: str, length: float, field: str) -> InputError:
    return InputError(
        said(
            "is not on shaft {shaft}, which is {length} long",
            shaft=f'"{shaft}"',
            length=readable(length, "length"),
        ),
        field=field,
        value=readable(position, "length"),
        example=f'{field.rpartition(".")[2]} = "{readable(0.5 * length, "length")}"',
    )


def _check_bearing(machine: Machine, bearing: MachineBearing, field: str) -> None:
    try:
        case = bearing.case
    except InputError as error:
        raise _within(field, error) from None
    for name in ("offset", "preload"):
        if getattr(bearing, name) is None:
            continue
        if case.bearing.is_set:
            raise InputError(
                said("is for single rows; a set takes its preload from its bearing table"),
                field=f"{field}.{name}",
                example='[bearings.bearing] preload = "500 N"',
            )
        if not case.bearing.locates:
            raise InputError(
                said("is not for a bearing that takes no axial load"), field=f"{field}.{name}"
            )
    outer = bearing.outer_shaft
    if outer is None:
        return
    known = {one.name: one for one in machine.shafts}
    if outer not in known:
        raise _unknown(outer, known, f"{field}.outer_shaft")
    if outer == bearing.shaft:
        raise InputError(
            said("must be another shaft than that of the inner ring"),
            field=f"{field}.outer_shaft",
            value=outer,
        )
    position, length = machine.outer_position(bearing.name), known[outer].length
    if not -_ROUNDING * length <= position <= length * (1.0 + _ROUNDING):
        raise _outside(position, outer, length, f"{field}.position")


def _check_housings(machine: Machine) -> None:
    bearings = {bearing.name: bearing for bearing in machine.bearings}
    housings = {housing.name: housing for housing in machine.housings}
    under: dict[str, str] = {}
    for index, housing in enumerate(machine.housings):
        for place, name in enumerate(housing.bearings):
            field = f"housings.{index}.bearings.{place}"
            if name not in bearings:
                raise _unknown(name, bearings, field)
            if name in under or bearings[name].housing not in (None, housing.name):
                raise InputError(said("has another housing too"), field=field, value=name)
            if bearings[name].outer_shaft is not None:
                raise InputError(
                    said("has its outer ring on a shaft, not in a housing"),
                    field=field,
                    value=name,
                )
            under[name] = housing.name
    for index, bearing in enumerate(machine.bearings):
        own = bearing.housing
        if own is None:
            continue
        if own not in housings:
            raise _unknown(own, housings, f"bearings.{index}.housing")
        if housings[own].bearings and bearing.name not in housings[own].bearings:
            raise InputError(
                said("is of other bearings: {names}", names=", ".join(housings[own].bearings)),
                field=f"bearings.{index}.housing",
                value=own,
            )


def _check_mate(machine: Machine, gear: Gear, field: str) -> None:
    """Refuse gears in mesh that do not fit each other."""
    if gear.mate is None:
        return
    known = {one.name: one for one in machine.gears if one.name and one is not gear}
    if gear.mate not in known:
        raise _unknown(gear.mate, known, f"{field}.mate")
    mate = known[gear.mate]
    if mate.mate not in (None, gear.name):
        raise InputError(
            said("is in mesh with {other}", other=f'"{mate.mate}"'),
            field=f"{field}.mate",
            value=gear.mate,
        )
    if gear.follows_mate == mate.follows_mate:
        raise InputError(
            said("is missing: one of two gears in mesh has it")
            if gear.follows_mate
            else said("is given by its mate too: one of two gears in mesh has it"),
            field=f"{field}.torque",
            example='torque = "250 N m"',
        )
    if gear.shaft == mate.shaft:
        raise InputError(said("must be on another shaft"), field=f"{field}.mate", value=gear.mate)
    for name in ("kind", "pressure_angle", "helix_angle"):
        if getattr(gear, name) != getattr(mate, name):
            raise InputError(
                said("must be that of its mate, {other}", other=mate.to_mapping()[name]),
                field=f"{field}.{name}",
                value=gear.to_mapping()[name],
            )
    if gear.helix_angle and gear.hand == mate.hand:
        raise InputError(
            said("must not be that of its mate: external gears in mesh have opposite hands"),
            field=f"{field}.hand",
            value=gear.hand,
            example=f'hand = "{"left" if gear.hand == "right" else "right"}"',
        )
    for name in ("mesh_azimuth", "drives"):
        if gear.follows_mate and getattr(gear, name) is not None:
            raise InputError(
                said("follows from its mate; leave it out"),
                field=f"{field}.{name}",
                value=gear.to_mapping()[name],
            )
    own, other = (machine.speed(one.shaft) * one.diameter for one in (gear, mate))
    if own and other and abs(own + other) > _RATIO * abs(own):
        raise InputError(
            said(
                "must turn at {speed}: gears in mesh have one pitch-line speed, and turn against"
                " each other",
                speed=readable(-other / gear.diameter, "angular_speed"),
            ),
            field=f"{field}.shaft",
            value=gear.shaft,
            example=f"ratio = {-mate.diameter / gear.diameter:.6g}",
        )


def _check_spectrum(machine: Machine) -> None:
    if not machine.spectrum:
        return
    total = math.fsum(step.share for step in machine.spectrum)
    if abs(total - 1.0) > _SHARES:
        raise InputError(
            said("must have shares that sum to 1"), field="spectrum", value=round(total, 9)
        )
    for extreme in (min, max):
        machine.forces(extreme(machine.spectrum, key=lambda step: step.load_factor))
