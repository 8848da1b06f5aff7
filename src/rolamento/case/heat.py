"""Where the heat of a bearing goes: the [heat] table of a case."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from rolamento.case.quantity import Line, Quantity
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.units import readable
from rolamento.words import said

__all__ = ["Heat", "HeatFriction", "HeatStep"]

HeatFriction = Literal["contacts", "palmgren", "skf"]

_Conductance = Annotated[
    float, Quantity("thermal_conductance", at_least="0 W/K", at_most="1e9 W/K")
]
_Celsius = Annotated[float, Quantity("temperature", at_least="-100 degC", at_most="300 degC")]
_Power = Annotated[float, Quantity("power", at_least="-1000 kW", at_most="1000 kW")]
_Size = Annotated[float, Quantity("length", above="0 mm", at_most="20 m")]
_Capacity = Annotated[float, Quantity("heat_capacity", above="0 J/K", at_most="1e9 J/K")]
_Factor = Annotated[float, Quantity(at_least=0.0, at_most=100.0)]


class HeatStep(Record):
    """A piece of the time that a bearing runs: how long, how fast, how heavily loaded.

    Parameters
    ----------
    duration
        In s.
    speed_factor, load_factor
        By which the speeds and the loads of the case are multiplied.
    name
        What to call it.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    duration: Annotated[float, Quantity("time", above="0 s", at_most="1e5 h")] = Field(
        examples=["10 min"]
    )
    speed_factor: _Factor = Field(1.0, examples=[0.5])
    load_factor: _Factor = Field(1.0, examples=[1.5])
    name: Line = Field("", examples=["idling"])


class Heat(Record):
    """Ways of the heat out of a bearing or a set, for its heat balance.

    A conductance that is not given is estimated, with a note in the result.

    Parameters
    ----------
    ambient
        Temperature around shaft and housing, in K; in files in °C.
    inner_ring_elements, elements_outer_ring
        Conductances between the rings and the rolling elements, of all of them together, in W/K;
        estimated as conduction through the moving contacts of the cold state.
    inner_ring_shaft, outer_ring_housing
        Conductances of the seats, in W/K; estimated as 5 kW/(m² K) over π d B and π D B.
    shaft_ambient, housing_ambient
        Conductances from shaft and housing to the surroundings, in W/K; estimated by the reference
        heat flow of ISO 15312 over 50 K, in proportion to d and D.
    housing_along
        Of a machine: conductance of the housing from this bearing to the next one along x, in W/K;
        none if not given. Shafts conduct by their sections.
    oil_flow
        Oil that flows through the bearing, in m³/s; it takes 30 W per l/min and K away from the
        elements.
    oil_inlet
        Temperature at which it comes, in K; that of the surroundings if not given.
    shaft_heat, housing_heat
        From outside into the shaft and the housing, in W; negative where they are cooled.
    inner_share
        Share of the friction that warms the inner ring, 0 to 1; the rest warms the outer one.
    friction
        By what the friction is calculated: ``"contacts"`` (and rolling resistance), or by
        Palmgren's or SKF's model of the whole bearing, ``"palmgren"`` or ``"skf"``.
    limit
        Temperature that no part may pass, in K.
    bore, outside_diameter, width
        d, D and B of one bearing, for the estimates, in m; those of the mounting or of the
        designation if not given.
    inner_ring_capacity, elements_capacity, outer_ring_capacity, shaft_capacity, housing_capacity
        Heat that warms each by 1 K, in J/K, for what happens in time; estimated from the sizes of
        the bearing, with three widths of its shaft and of a housing with 1.5 D outside.
    steps
        `HeatStep` records, one after another, for what happens in time.

    Raises
    ------
    InputError
        If a value is out of range, or the values contradict each other.
    """

    ambient: _Celsius = Field(293.15, examples=["20 degC"])
    inner_ring_elements: _Conductance | None = Field(None, examples=["8 W/K"])
    elements_outer_ring: _Conductance | None = Field(None, examples=["8 W/K"])
    inner_ring_shaft: _Conductance | None = Field(None, examples=["12 W/K"])
    outer_ring_housing: _Conductance | None = Field(None, examples=["25 W/K"])
    shaft_ambient: _Conductance | None = Field(None, examples=["0.8 W/K"])
    housing_ambient: _Conductance | None = Field(None, examples=["1.6 W/K"])
    housing_along: _Conductance | None = Field(None, examples=["2 W/K"])
    oil_flow: Annotated[float, Quantity("flow_rate", at_least="0 l/min", at_most="1e4 l/min")] = (
        Field(0.0, examples=["0.5 l/min"])
    )
    oil_inlet: _Celsius | None = Field(None, examples=["40 degC"])
    shaft_heat: _Power = Field(0.0, examples=["20 W"])
    housing_heat: _Power = Field(0.0, examples=["0 W"])
    inner_share: Annotated[float, Quantity(at_least=0.0, at_most=1.0)] = Field(0.5, examples=[0.5])
    friction: HeatFriction = Field("contacts", examples=["palmgren"])
    limit: _Celsius = Field(423.15, examples=["150 degC"])
    bore: _Size | None = Field(None, examples=["40 mm"])
    outside_diameter: _Size | None = Field(None, examples=["80 mm"])
    width: _Size | None = Field(None, examples=["18 mm"])
    inner_ring_capacity: _Capacity | None = Field(None, examples=["150 J/K"])
    elements_capacity: _Capacity | None = Field(None, examples=["60 J/K"])
    outer_ring_capacity: _Capacity | None = Field(None, examples=["200 J/K"])
    shaft_capacity: _Capacity | None = Field(None, examples=["600 J/K"])
    housing_capacity: _Capacity | None = Field(None, examples=["4000 J/K"])
    steps: tuple[HeatStep, ...] = Field(
        (), max_length=1000, examples=['[{ duration = "10 min", speed_factor = 0.5 }]']
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.limit <= self.ambient:
            raise InputError(
                said(
                    "must be above the ambient temperature, {ambient}",
                    ambient=readable(self.ambient, "temperature"),
                ),
                field="limit",
                value=readable(self.limit, "temperature"),
                example='limit = "150 degC"',
            )
        if self.oil_inlet is not None and not self.oil_flow:
            raise InputError(
                said("has no effect without oil_flow"),
                field="oil_inlet",
                value=readable(self.oil_inlet, "temperature"),
                example='oil_flow = "0.5 l/min"',
            )
        bore, outside = self.bore, self.outside_diameter
        if bore is not None and outside is not None and bore >= outside:
            raise InputError(
                said("must be greater than the bore, {bore}", bore=readable(bore, "length")),
                field="outside_diameter",
                value=readable(outside, "length"),
                example='outside_diameter = "80 mm"',
            )
        return self
