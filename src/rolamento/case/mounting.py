"""How a bearing is mounted: the [mounting] table, with shaft and housing."""

from typing import Annotated, ClassVar, Literal, Self

from pydantic import BeforeValidator, ConfigDict, Field, model_validator

from rolamento.case.named import NamedRecord
from rolamento.case.quantity import Line, Quantity, Replaces
from rolamento.case.record import Record, refuse_rivals
from rolamento.errors import InputError
from rolamento.units import readable
from rolamento.words import marked, said

__all__ = ["Mounting", "SeatMaterial"]

_Expansion = Annotated[
    float, Quantity("thermal_expansion", at_least="0 1/K", at_most="1e-3 1/K", varies=True)
]
_Deviation = Annotated[float, Quantity("length", at_least="-1 mm", at_most="1 mm", varies=True)]
_Roughness = Annotated[float, Quantity("length", at_least="0 um", at_most="1 mm", varies=True)]
_Diameter = Annotated[float, Quantity("length", above="0 mm", at_most="20 m")]


class SeatMaterial(NamedRecord):
    """What shaft or housing is made of.

    Parameters
    ----------
    name
        What to call it.
    youngs_modulus
        E, in Pa.
    poisson_ratio
        ν.
    density
        ρ, in kg/m³.
    thermal_expansion
        Coefficient of linear expansion, in 1/K.
    source
        Where the values come from.

    Raises
    ------
    InputError
        If a value is missing or out of range.
    """

    data_file: ClassVar = "seat_materials"
    called: ClassVar = marked("material of a seat")
    usual: ClassVar = "steel"

    name: Line = Field("custom", examples=["AlSi7Mg, supplier's certificate"])
    youngs_modulus: Annotated[float, Quantity("stress", at_least="1 GPa", at_most="2000 GPa")] = (
        Field(examples=["70 GPa"])
    )
    poisson_ratio: Annotated[float, Quantity(at_least=0.0, at_most=0.49)] = Field(examples=[0.33])
    density: Annotated[
        float, Quantity("density", at_least="100 kg/m^3", at_most="25000 kg/m^3")
    ] = Field(examples=["2700 kg/m^3"])
    thermal_expansion: Annotated[
        float, Quantity("thermal_expansion", at_least="0 1/K", at_most="1e-3 1/K")
    ] = Field(examples=["23e-6 1/K"])
    source: Line = Field("", repr=False, examples=["supplier's certificate"])


_SeatMaterialField = Annotated[
    SeatMaterial,
    BeforeValidator(SeatMaterial.name_or_table, json_schema_input_type=SeatMaterial | str),
    Field(description="a name or a table", examples=["aluminium"]),
]


class Mounting(Record):
    """Clearance before mounting, seats, temperatures of mounting, wear.

    Parameters
    ----------
    bore, outside_diameter
        d and D of the bearing, in m.
    clearance_class
        C2, CN, C3, C4, C5, or CM of electric motors; of rollers also CT of electric motors and CC1
        to CC5 (normal: CC) of rings that are not interchangeable; or
    measured_clearance
        What a gauge shows, in m, under
    measuring_load
        in N; that which is usual for the bore if not given. With neither class nor measurement
        the bearing's own clearance or contact angle is that before mounting.
    shaft_tolerance, housing_tolerance
        ISO classes such as k5 and J7; or
    shaft_interference, housing_interference
        in m, negative for a gap. A ring without either is taken to be free.
    tolerance_class
        Of the bearing: normal, P6 or P5.
    shaft_bore
        Of a hollow shaft, in m; 0 is solid.
    housing_outside_diameter
        In m; massive if not given.
    shaft_material, housing_material
        A `SeatMaterial`, its name or its table; that of the rings if not given.
    shaft_finish, housing_finish
        ground or turned: what smoothing takes from an interference, by NSK's rule; or
    shaft_roughness, housing_roughness
        Sum of Rz of seat and ring, in m, by DIN 7190-1. Nothing is lost if neither is given.
    width
        B of one bearing, in m. In a set its rings and the spacers between them then make the
        distance of the rows; where it is not given (nor given by a designation), shaft and housing
        do. It also goes into the thermal reference speed.
    inner_spacer_material, outer_spacer_material
        A `SeatMaterial`, its name or its table; that of shaft and housing if not given. For sets
        only.
    ring_expansion, ball_expansion
        Coefficients of expansion, in 1/K; those on file for the bearing's materials if not given.
    assembly_temperature
        At which all the above holds, in K; in files in °C.
    wear
        What the clearance has grown by since, in m.
    limit
        Which of the clearances in operation `solve` takes: the mean one of mean dimensions, or the
        minimum or maximum with all tolerances at their worst. The minimum clearance is the
        greatest preload of a clamped set.

    Raises
    ------
    InputError
        If a value is missing or out of range, or the values contradict each other.
    """

    # a designation may tell the sizes
    model_config = ConfigDict(json_schema_extra=lambda schema: schema.pop("required", None))

    bore: _Diameter = Field(examples=["25 mm"])
    outside_diameter: _Diameter = Field(examples=["62 mm"])
    clearance_class: Annotated[
        Literal["C2", "CN", "C3", "C4", "C5", "CM", "CT", "CC1", "CC2", "CC", "CC3", "CC4", "CC5"]
        | None,
        Replaces("measured_clearance"),
    ] = Field(None, examples=["C3"])
    measured_clearance: Annotated[
        Annotated[float, Quantity("length", above="0 mm", at_most="5 mm")] | None,
        Replaces("clearance_class"),
    ] = Field(None, examples=["0.026 mm"])
    measuring_load: Annotated[float, Quantity("force", above="0 N", at_most="1000 kN")] | None = (
        Field(None, examples=["49 N"])
    )
    shaft_tolerance: Annotated[Line | None, Replaces("shaft_interference")] = Field(
        None, examples=["k5"]
    )
    shaft_interference: Annotated[_Deviation | None, Replaces("shaft_tolerance")] = Field(
        None, examples=["0.008 mm"]
    )
    housing_tolerance: Annotated[Line | None, Replaces("housing_interference")] = Field(
        None, examples=["J7"]
    )
    housing_interference: Annotated[_Deviation | None, Replaces("housing_tolerance")] = Field(
        None, examples=["-0.01 mm"]
    )
    tolerance_class: Literal["normal", "P6", "P5"] = Field("normal", examples=["normal"])
    shaft_bore: Annotated[
        float, Quantity("length", at_least="0 mm", at_most="20 m", varies=True)
    ] = Field(0.0, examples=["10 mm"])
    housing_outside_diameter: (
        Annotated[float, Quantity("length", above="0 mm", at_most="20 m", varies=True)] | None
    ) = Field(None, examples=["100 mm"])
    shaft_material: _SeatMaterialField | None = Field(None, examples=["aluminium"])
    housing_material: _SeatMaterialField | None = Field(None, examples=["aluminium"])
    shaft_finish: Annotated[Literal["ground", "turned"] | None, Replaces("shaft_roughness")] = (
        Field(None, examples=["ground"])
    )
    shaft_roughness: Annotated[_Roughness | None, Replaces("shaft_finish")] = Field(
        None, examples=["4 um"]
    )
    housing_finish: Annotated[Literal["ground", "turned"] | None, Replaces("housing_roughness")] = (
        Field(None, examples=["turned"])
    )
    housing_roughness: Annotated[_Roughness | None, Replaces("housing_finish")] = Field(
        None, examples=["6 um"]
    )
    width: _Diameter | None = Field(None, examples=["20 mm"])
    inner_spacer_material: _SeatMaterialField | None = Field(None, examples=["steel"])
    outer_spacer_material: _SeatMaterialField | None = Field(None, examples=["steel"])
    ring_expansion: _Expansion | None = Field(None, examples=["12.5e-6 1/K"])
    ball_expansion: _Expansion | None = Field(None, examples=["2.8e-6 1/K"])
    assembly_temperature: Annotated[
        float, Quantity("temperature", at_least="-100 degC", at_most="400 degC", varies=True)
    ] = Field(293.15, examples=["20 degC"])
    wear: Annotated[float, Quantity("length", at_least="0 mm", at_most="5 mm", varies=True)] = (
        Field(0.0, examples=["0.01 mm"])
    )
    limit: Literal["minimum", "mean", "maximum"] = Field("mean", examples=["minimum"])

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        refuse_rivals(self)
        if self.measuring_load is not None and self.measured_clearance is None:
            raise InputError(
                said("needs the clearance that was measured"),
                field="measuring_load",
                value=readable(self.measuring_load, "force"),
                example='measured_clearance = "0.026 mm"',
            )
        self._check_diameters()
        return self

    def _check_diameters(self) -> None:
        rules = (
            ("shaft_bore", self.shaft_bore, "bore", self.bore),
            ("bore", self.bore, "outside_diameter", self.outside_diameter),
            (
                "outside_diameter",
                self.outside_diameter,
                "housing_outside_diameter",
                self.housing_outside_diameter,
            ),
        )
        for field, inner, limit, outer in rules:
            if outer is not None and inner >= outer:
                raise InputError(
                    said(
                        "must be less than {limit}, {outer}",
                        limit=limit,
                        outer=readable(outer, "length"),
                    ),
                    field=field,
                    value=readable(inner, "length"),
                )
