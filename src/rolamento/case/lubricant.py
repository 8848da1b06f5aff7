"""Lubricants: named ones from a data file, or the values of a data sheet."""

from functools import cached_property
from math import isnan
from typing import Annotated, Any, ClassVar, Final, Literal, NamedTuple, Self

from pydantic import BeforeValidator, Field, model_validator

from rolamento.case.named import NamedRecord
from rolamento.case.quantity import Line, Quantity, Replaces
from rolamento.case.record import Record
from rolamento.errors import InputError, phrase
from rolamento.io.data import toml_of
from rolamento.units import readable
from rolamento.words import marked, said

__all__ = [
    "Lubricant",
    "LubricantField",
    "OilType",
    "PressureViscosityMethod",
    "ViscosityPoint",
]

Kind = Literal["oil", "grease", "dry"]
OilType = Literal["mineral", "synthetic", "transmission_fluid"]
PressureViscosityMethod = Literal["wooster", "so_klaus"]

_EXAMPLE: Final = "ISO VG 68"
_TWO_POINTS: Final = (
    '[{ temperature = "20 degC", viscosity = "170 mm^2/s" }, '
    '{ temperature = "60 degC", viscosity = "29 mm^2/s" }]'
)
_CENTIGRADE_40: Final = 313.15
_CENTIGRADE_100: Final = 373.15
_WAYS: Final = ("viscosity_40", "viscosities", "base_oil")
_HOT: Final = ("viscosity_100", "viscosity_index")
"""What goes with a viscosity at 40 °C alone."""
_SUPERSEDED: Final = (
    ("density", "density_temperature"),
    ("pressure_viscosity", "pressure_viscosity_method"),
    ("pressure_viscosity_method", "pressure_viscosity"),
)
"""What an oil gives of its own, and what of its base oil no longer holds then."""

_Viscosity = Annotated[
    float, Quantity("kinematic_viscosity", at_least="0.5 mm^2/s", at_most="1e7 mm^2/s")
]
_Temperature = Annotated[float, Quantity("temperature", at_least="-150 degC", at_most="500 degC")]
_Density = Annotated[float, Quantity("density", at_least="500 kg/m^3", at_most="3000 kg/m^3")]


class ViscosityPoint(Record):
    """A kinematic viscosity at a temperature, in m²/s and K."""

    temperature: _Temperature = Field(examples=["40 degC"])
    viscosity: _Viscosity = Field(examples=["68 mm^2/s"])


class OilPoint(NamedTuple):
    """A temperature (K) and the kinematic viscosity there (m²/s)."""

    temperature: float
    viscosity: float


class Lubricant(NamedRecord):
    """An oil, a grease, or a lubrication without a film.

    An oil, and the base oil of a grease, is given by two viscosities: at 40 and 100 °C, at 40 °C
    with the viscosity index, at two temperatures of one's own, or by the name of a base oil in
    the data file, from which then everything comes that is not given.

    Parameters
    ----------
    name
        What to call it.
    kind
        ``"oil"``, ``"grease"`` or ``"dry"``.
    base_oil
        Name of an oil in the data file.
    viscosity_40, viscosity_100
        Kinematic, at 40 and 100 °C, in m²/s.
    viscosity_index
        By ISO 2909, in the place of the viscosity at 100 °C.
    viscosities
        Two `ViscosityPoint`.
    density
        In kg/m³.
    density_temperature
        Of that density, in K; 15 °C if not given.
    thermal_expansion
        Of the volume, in 1/K; if not given, that of mineral oils by API table 54D.
    pressure_viscosity
        α at the temperature of operation, in 1/Pa; if not given, estimated.
    pressure_viscosity_method
        How: ``"wooster"`` or ``"so_klaus"``, both for mineral oils.
    thermal_conductivity
        In W/(m·K).
    minimum_temperature, maximum_temperature
        Between which the lubricant may be used, in K; not checked if not given.
    oil_type
        ``"mineral"``, ``"synthetic"`` or ``"transmission_fluid"``: decides the coefficient of
        friction of a full film where none is given; mineral if not given.
    friction_coefficient
        Of dry or boundary lubrication; of an oil or a grease by the regime if not given.
    source
        Where the values come from.

    Raises
    ------
    InputError
        If a value is missing or out of range, or the values contradict each other.
    """

    data_file: ClassVar = "lubricants"
    data_key: ClassVar = "lubricant"
    called: ClassVar = marked("lubricant")
    usual: ClassVar = _EXAMPLE

    name: Line = Field("custom", examples=["our gear oil"])
    kind: Kind = Field("oil", examples=["oil"])
    base_oil: Annotated[Line | None, Replaces(*_WAYS, *_HOT)] = Field(None, examples=[_EXAMPLE])
    viscosity_40: Annotated[_Viscosity | None, Replaces(*_WAYS)] = Field(
        None, examples=["68 mm^2/s"]
    )
    viscosity_100: Annotated[_Viscosity | None, Replaces("viscosity_index")] = Field(
        None, examples=["8.6 mm^2/s"]
    )
    viscosity_index: Annotated[
        Annotated[float, Quantity(at_least=-60.0, at_most=400.0)] | None, Replaces("viscosity_100")
    ] = Field(None, examples=[95])
    viscosities: Annotated[tuple[ViscosityPoint, ...] | None, Replaces(*_WAYS, *_HOT)] = Field(
        None, min_length=2, max_length=2, examples=[_TWO_POINTS]
    )
    density: _Density | None = Field(None, examples=["880 kg/m^3"])
    density_temperature: _Temperature | None = Field(None, examples=["15 degC"])
    thermal_expansion: (
        Annotated[float, Quantity("thermal_expansion", at_least="0 1/K", at_most="0.01 1/K")] | None
    ) = Field(None, examples=["7e-4 1/K"])
    pressure_viscosity: Annotated[
        Annotated[
            float,
            Quantity("pressure_viscosity_coefficient", at_least="0 1/GPa", at_most="200 1/GPa"),
        ]
        | None,
        Replaces("pressure_viscosity_method"),
    ] = Field(None, examples=["18 1/GPa"])
    pressure_viscosity_method: Annotated[
        PressureViscosityMethod | None, Replaces("pressure_viscosity")
    ] = Field(None, examples=["wooster"])
    thermal_conductivity: (
        Annotated[
            float, Quantity("thermal_conductivity", at_least="0.01 W/m/K", at_most="10 W/m/K")
        ]
        | None
    ) = Field(None, examples=["0.145 W/m/K"])
    minimum_temperature: _Temperature | None = Field(None, examples=["-20 degC"])
    maximum_temperature: _Temperature | None = Field(None, examples=["120 degC"])
    oil_type: OilType | None = Field(None, examples=["synthetic"])
    friction_coefficient: Annotated[float, Quantity(above=0.0, at_most=1.0, varies=True)] | None = (
        Field(None, examples=[0.17])
    )
    source: Line = Field("", repr=False, examples=["maker's data sheet"])

    @classmethod
    def tables(cls) -> tuple[dict[str, Any], ...]:
        """Return the tables of the data file, the grades of viscosity spelt out."""
        shared = dict(toml_of(cls.data_file)["grades"])
        grades = (
            {
                "name": f"ISO VG {grade}",
                "aliases": [f"VG {grade}"],
                "viscosity_40": f"{grade} mm^2/s",
                **shared,
            }
            for grade in shared.pop("names")
        )
        return (*grades, *super().tables())

    @property
    def oil(self) -> "Lubricant":
        """The oil with everything that its base oil supplies; itself without a base oil."""
        return self if self.base_oil is None else self._with_base

    @cached_property
    def _with_base(self) -> "Lubricant":
        """Made once: a case asks for it a dozen times."""
        assert self.base_oil is not None
        base = Lubricant.named(self.base_oil).oil
        own, fields = self._given, base._given
        for name, rival in _SUPERSEDED:
            if name in own:
                fields.pop(rival, None)
        return Lubricant(**{**fields, **own, "base_oil": None})

    @property
    def _given(self) -> dict[str, Any]:
        given = ((name, getattr(self, name)) for name in self.model_fields_set)
        return {name: value for name, value in given if value is not None}

    @property
    def points(self) -> tuple[OilPoint, OilPoint]:
        """Two temperatures with their kinematic viscosities, the cooler first.

        Raises
        ------
        InputError
            If the lubrication is dry.
        """
        oil = self.oil
        if oil.viscosities is not None:
            first, second = sorted(oil.viscosities, key=lambda point: point.temperature)
            return (
                OilPoint(first.temperature, first.viscosity),
                OilPoint(second.temperature, second.viscosity),
            )
        if oil.viscosity_40 is None:
            raise InputError(
                said("has no viscosity: the lubrication is dry"), field="lubricant.kind"
            )
        cool = OilPoint(_CENTIGRADE_40, oil.viscosity_40)
        return cool, OilPoint(_CENTIGRADE_100, oil._hot_viscosity(oil.viscosity_40))

    def _hot_viscosity(self, viscosity_40: float) -> float:
        """At 100 °C, as given or by the viscosity index; NaN if there is none."""
        from rolamento.oil import viscosity_100_of_index

        if self.viscosity_100 is not None:
            return self.viscosity_100
        assert self.viscosity_index is not None
        return viscosity_100_of_index(viscosity_40, self.viscosity_index)

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.kind == "dry":
            self._check_dry()
        else:
            self._check_one_way()
            self._check_viscosities()
            self._check_density()
        self._check_pressure_viscosity()
        self._check_range()
        return self

    def _check_dry(self) -> None:
        if self.friction_coefficient is None:
            raise InputError(
                said("is missing; dry lubrication is defined by nothing else"),
                field="friction_coefficient",
                example="friction_coefficient = 0.17",
            )
        given = [name for name in _WAYS if getattr(self, name) is not None]
        if given:
            raise InputError(
                said('cannot be combined with kind = "dry": there is no oil'),
                field=given[0],
                example=f"{given[0]} left out",
            )

    def _check_one_way(self) -> None:
        given = [name for name in _WAYS if getattr(self, name) is not None]
        if len(given) != 1:
            also = " and ".join(given) or "nothing"
            raise InputError(
                said("needs one of {ways}, and has {also}", ways=", ".join(_WAYS), also=also),
                field="viscosity_40",
                example='viscosity_40 = "68 mm^2/s" and viscosity_100 = "8.6 mm^2/s"',
            )
        hot = [
            name for name in ("viscosity_100", "viscosity_index") if getattr(self, name) is not None
        ]
        wanted = 1 if given == ["viscosity_40"] else 0
        if len(hot) != wanted:
            rule = (
                phrase(
                    marked("is needed with {given}, or else the viscosity index; not both"),
                    given="viscosity_40",
                )
                if wanted
                else phrase(marked("cannot be combined with {before}"), before=given[0])
            )
            raise InputError(
                rule,
                field=hot[0] if hot else "viscosity_100",
                example='viscosity_40 = "68 mm^2/s" and viscosity_100 = "8.6 mm^2/s"',
            )
        if self.base_oil is not None:
            self._check_base(self.base_oil)

    def _check_base(self, name: str) -> None:
        try:
            base = Lubricant.named(name)
        except InputError as error:
            raise error.with_details(field="base_oil") from None
        if base.kind != "oil":
            raise InputError(
                said("must be an oil, and is of kind {kind}", kind=base.kind),
                field="base_oil",
                value=name,
                example=f'base_oil = "{_EXAMPLE}"',
            )

    def _check_viscosities(self) -> None:
        cool, hot = self.points
        if cool.temperature == hot.temperature:
            raise InputError(
                said("are both at the same temperature; two are needed"),
                field="viscosities",
                value=readable(cool.temperature, "temperature"),
            )
        if isnan(hot.viscosity):
            raise InputError(
                said(
                    "gives less than 2 mm^2/s at 100 degC or more than at 40 degC; give "
                    "viscosity_100"
                ),
                field="viscosity_index",
                value=self.viscosity_index,
                example='viscosity_100 = "8.6 mm^2/s"',
            )
        if hot.viscosity >= cool.viscosity:
            most = readable(cool.viscosity, "kinematic_viscosity")
            at = readable(cool.temperature, "temperature")
            raise InputError(
                said(
                    "must be less than {most}, the viscosity at {at}: an oil thins as it warms",
                    most=most,
                    at=at,
                ),
                field="viscosities" if self.viscosities is not None else "viscosity_100",
                value=readable(hot.viscosity, "kinematic_viscosity"),
                example='viscosity_40 = "68 mm^2/s" and viscosity_100 = "8.6 mm^2/s"',
            )

    def _check_density(self) -> None:
        if self.oil.density is None:
            raise InputError(said("is missing"), field="density", example='density = "880 kg/m^3"')

    def _check_pressure_viscosity(self) -> None:
        if self.pressure_viscosity is not None and self.pressure_viscosity_method is not None:
            raise InputError(
                said("cannot be combined with its estimate"),
                field="pressure_viscosity",
                value=readable(self.pressure_viscosity, "pressure_viscosity_coefficient"),
                example="pressure_viscosity without pressure_viscosity_method",
            )

    def _check_range(self) -> None:
        least, most = self.minimum_temperature, self.maximum_temperature
        if least is not None and most is not None and least >= most:
            raise InputError(
                said("must be less than the maximum, {most}", most=readable(most, "temperature")),
                field="minimum_temperature",
                value=readable(least, "temperature"),
                example='minimum_temperature = "-20 degC"',
            )


LubricantField = Annotated[
    Lubricant,
    BeforeValidator(Lubricant.name_or_table, json_schema_input_type=Lubricant | str),
    Field(description="a name or a table", examples=[_EXAMPLE]),
]
"""Annotation of a field that takes a lubricant, its name or its table."""
