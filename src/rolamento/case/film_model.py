"""How the lubricant film is calculated: the [film] table of a case."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.units import readable
from rolamento.words import said

__all__ = ["FilmModel", "LineFilm", "Starvation", "Supply", "ThermalReduction"]

ThermalReduction = Literal["murch_wilson", "gupta_cheng", "none"]
Starvation = Literal["none", "inlet_distance", "replenishment"]
Supply = Literal["bath", "jet", "grease", "oil_air"]
LineFilm = Literal["pan_hamrock", "dowson_toyoda"]

_Diameter = Annotated[float, Quantity("length", at_least="0.1 mm", at_most="20 m")]


class FilmModel(Record):
    """Choices of the film's reductions, and what they need.

    Parameters
    ----------
    thermal
        Which reduction for the heat of shear in the inlet: ``"murch_wilson"``,
        ``"gupta_cheng"`` or ``"none"``.
    starvation
        ``"none"`` where the inlets are full of oil; ``"inlet_distance"`` where the oil is known
        to begin a given distance before the contact's centre; ``"replenishment"`` for a maker's
        factor of how well the track is refilled.
    inlet_distance
        From the contact's centre to where the oil begins, in m.
    supply
        How the lubricant is supplied: ``"bath"`` (low level), ``"jet"``, ``"grease"`` or
        ``"oil_air"``; for the replenishment, and for Palmgren's and SKF's friction models. If not
        given, these take a low bath for an oil.
    bore, outside_diameter
        Of the bearing, in m; for the replenishment.
    line
        Which formulas for the line contacts of rollers: ``"pan_hamrock"`` (the default) or
        ``"dowson_toyoda"``, whose minimum film is Dowson's.

    Raises
    ------
    InputError
        If a choice is not known, or what it needs is missing.
    """

    thermal: ThermalReduction = Field("murch_wilson", examples=["murch_wilson"])
    starvation: Starvation = Field("none", examples=["none"])
    inlet_distance: Annotated[float, Quantity("length", above="0 mm", at_most="100 mm")] | None = (
        Field(None, examples=["1 mm"])
    )
    supply: Supply | None = Field(None, examples=["bath"])
    bore: _Diameter | None = Field(None, examples=["25 mm"])
    outside_diameter: _Diameter | None = Field(None, examples=["62 mm"])
    line: LineFilm | None = Field(None, examples=["dowson_toyoda"])

    @model_validator(mode="after")
    def _complete(self) -> Self:
        needs = {
            "none": (),
            "inlet_distance": ("inlet_distance",),
            "replenishment": ("supply", "bore", "outside_diameter"),
        }
        for choice, names in needs.items():
            for name in names:
                given = getattr(self, name) is not None
                if given != (self.starvation == choice) and not (given and name == "supply"):
                    rule = (
                        said('belongs to starvation = "{choice}"', choice=choice)
                        if given
                        else said("is missing")
                    )
                    example = type(self).model_fields[name].examples
                    raise InputError(rule, field=name, example=f'{name} = "{(example or [""])[0]}"')
        self._check_diameters()
        return self

    def _check_diameters(self) -> None:
        bore, outside = self.bore, self.outside_diameter
        if bore is not None and outside is not None and bore >= outside:
            raise InputError(
                said("must be greater than the bore, {bore}", bore=readable(bore, "length")),
                field="outside_diameter",
                value=readable(outside, "length"),
                example='outside_diameter = "62 mm"',
            )
