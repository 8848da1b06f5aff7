"""Inputs of the life calculation: the [life] table of a case."""

from typing import Annotated, Any, Final, Literal, Self

from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from rolamento.case.former import with_current_names
from rolamento.case.quantity import Line, Quantity, Replaces
from rolamento.case.record import Record, refuse_rivals
from rolamento.errors import InputError, guess, phrase
from rolamento.io.columns import folded_name
from rolamento.iso4406 import cleanliness_numbers
from rolamento.words import marked, said

__all__ = ["CONTAMINATION_FIELDS", "LifeModel", "TallianFactors"]

LEVELS: Final = {
    "extreme": "extreme_cleanliness limpeza_extrema extrema",
    "high": "high_cleanliness limpeza_alta alta_limpeza limpeza_elevada alta",
    "normal": "normal_cleanliness limpeza_normal",
    "slight": "slight_contamination contaminacao_leve leve_contaminacao leve",
    "typical": "typical_contamination contaminacao_tipica tipica",
    "severe": "severe_contamination contaminacao_severa contaminacao_grave severa grave",
    "very_severe": (
        "very_severe_contamination contaminacao_muito_severa contaminacao_muito_grave"
        " muito_severa muito_grave"
    ),
}
"""Levels of cleanliness in words, and what else they are called; folded."""
_LEVEL_OF: Final = {
    name: level for level, names in LEVELS.items() for name in (level, *names.split())
}
CONTAMINATION_FIELDS: Final = ("contamination", "cleanliness", "filter_size", "grease_cleanliness")
"""Ways to say how dirty the lubricant is: a case takes one of them."""

_Rating = Annotated[float, Quantity("force", above="0 N", at_most="1e9 N", varies=True)]
_Factor = Annotated[float, Quantity(above=0.0, at_most=1000.0, varies=True)]
_TallianFactor = Annotated[float, Quantity(above=0.0, at_most=1e300)]


def _level(word: object) -> object:
    """Return the name of a level by what it is called in either language; else the word itself."""
    return _LEVEL_OF.get(folded_name(word), word) if isinstance(word, str) else word


def _a_code_or_level(text: str) -> str:
    """Return a code as it is, and a level of cleanliness by its name."""
    if _level(text) in LEVELS:
        return str(_level(text))
    if not any(sign.isdecimal() for sign in text):
        raise InputError(
            said(
                "is neither an ISO 4406 code nor a level of cleanliness; {guess}",
                guess=guess(folded_name(text), LEVELS),
            ),
            value=text,
            example='"-/17/14"',
        )
    try:
        cleanliness_numbers(text)
    except InputError as error:
        raise error.with_details(field="") from None  # the record tells which field it is
    return text


class TallianFactors(Record):
    """φ0 to φ4 of one origin of failure in Tallian's form, and the exponent s of the stress cycles.

    What is not given is as by Lundberg and Palmgren: see `rolamento.life.tallian`.

    Parameters
    ----------
    strength
        φ0, of the material; SI.
    defect_shape, defect_density
        φ1 and φ2.
    failure_rate, pressure_distribution
        φ3 and φ4: both, beside the strength, or none; SI.
    exponent
        s.

    Raises
    ------
    InputError
        If a factor is not above zero, or φ3 and φ4 are not given together with φ0.
    """

    strength: _TallianFactor | None = Field(None, examples=[1e-97])
    defect_shape: _TallianFactor = Field(1.0, examples=[1.0])
    defect_density: _TallianFactor = Field(1.0, examples=[0.5])
    failure_rate: _TallianFactor | None = Field(None, examples=[1.0])
    pressure_distribution: _TallianFactor | None = Field(None, examples=[1.0])
    exponent: Annotated[float, Quantity(at_least=0.1, at_most=10.0)] = Field(
        10.0 / 9.0, examples=[1.11]
    )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        given = self.failure_rate is not None
        if given != (self.pressure_distribution is not None):
            missing = "pressure_distribution" if given else "failure_rate"
            raise InputError(
                said("is missing; surface failures need both factors"), field=missing, example="1.0"
            )
        if given and self.strength is None:
            raise InputError(
                phrase(marked("is missing; {first} needs it"), first="failure_rate"),
                field="strength",
                example="1e-97",
            )
        return self


class LifeModel(Record):
    """Ratings, cleanliness and wishes for the life.

    Parameters
    ----------
    reliability
        S that the life is for, 0.01 to 0.999999.
    required_life
        How long the bearing is to run, in s; in files in h. The result then states with which
        reliability it does.
    dynamic_rating, static_rating
        C_r and C_0r of one row, in N; those of the designation, or by ISO 281 and ISO 76 from the
        geometry if not given.
    fatigue_load_limit
        C_u of one row, in N; if not given by
    fatigue_load_method
        ``"contacts"`` from the contact pressure, or ``"estimate"`` from the static rating. If not
        given, C_u is that which the maker lists; else the estimate where balls or rollers are
        inferred from the ratings, and from the contacts where they are known.
    contamination
        e_C, 0 (dirt decides) to 1 (clean); or
    cleanliness
        the oil's level in words, ``"extreme"``, ``"high"``, ``"normal"`` (cleanliness),
        ``"slight"``, ``"typical"``, ``"severe"`` or ``"very_severe"`` (contamination), in
        Portuguese too; or its ISO 4406 code, such as ``"-/17/14"``, with
    oil_supply
        ``"circulating"`` (filtered in the line before the bearing) or ``"bath"``; or
    filter_size, filter_ratio
        of circulating oil: particles in m for which the filter is rated, and its β for them; or
    grease_cleanliness
        ``"high"``, ``"normal"``, ``"slight"``, ``"severe"`` or ``"very_severe"``.
    additives
        Whether the lubricant has effective extreme-pressure additives.
    viscosity_ratio
        κ, in the place of that of the case's lubricant.
    rotating_load
        Whether the load turns with the inner ring, as an unbalance does.
    edition
        Of ISO 281, for a_1.
    material_factor, operation_factor
        a_2 and a_3 of 1990; the adjusted life needs at least one of them.
    fatigue_limit
        τ_u of the stress-volume theory, in Pa.
    depth
        ``"local"`` or ``"mean"``, of the stress-volume theory.
    nsk_cleanliness
        a_c, 0.05 to 1, for L_able.
    tallian_subsurface, tallian_surface
        factors of Tallian's form for failures from below the surface, and from the surface; of
        these φ0, φ3 and φ4 are needed, and φ1 is 1.

    Raises
    ------
    InputError
        If a value is out of range, or the values contradict each other.
    """

    @model_validator(mode="before")
    @classmethod
    def _current_names(cls, given: Any) -> Any:
        return with_current_names(given, {"wanted_life": "required_life"})

    reliability: Annotated[float, Quantity(at_least=0.01, at_most=0.999999)] = Field(
        0.9, examples=[0.95]
    )
    required_life: Annotated[float, Quantity("time", above="0 h", at_most="1e9 h")] | None = Field(
        None, examples=["20000 h"]
    )
    dynamic_rating: _Rating | None = Field(None, examples=["20.6 kN"])
    static_rating: _Rating | None = Field(None, examples=["11.2 kN"])
    fatigue_load_limit: _Rating | None = Field(None, examples=["475 N"])
    fatigue_load_method: Literal["contacts", "estimate"] | None = Field(None, examples=["contacts"])
    contamination: Annotated[
        Annotated[float, Quantity(at_least=0.0, at_most=1.0, varies=True)] | None,
        Replaces(*CONTAMINATION_FIELDS, "oil_supply", "filter_ratio"),
    ] = Field(None, examples=[0.5])
    cleanliness: Annotated[
        Annotated[Line, AfterValidator(_a_code_or_level)] | None,
        Replaces(*CONTAMINATION_FIELDS, "filter_ratio"),
    ] = Field(None, examples=["-/17/14"])
    oil_supply: Literal["circulating", "bath"] | None = Field(None, examples=["bath"])
    filter_size: Annotated[
        Annotated[float, Quantity("length", at_least="0.1 um", at_most="1 mm")] | None,
        Replaces(*CONTAMINATION_FIELDS, "oil_supply"),
    ] = Field(None, examples=["12 um"])
    filter_ratio: Annotated[float, Quantity(above=1.0, at_most=1e6)] | None = Field(
        None, examples=[200]
    )
    grease_cleanliness: Annotated[
        Literal["high", "normal", "slight", "severe", "very_severe"] | None,
        BeforeValidator(_level),
        Replaces(*CONTAMINATION_FIELDS, "oil_supply", "filter_ratio"),
    ] = Field(None, examples=["normal"])
    additives: bool = Field(False, strict=True, examples=[False])
    viscosity_ratio: Annotated[float, Quantity(above=0.0, at_most=1e6, varies=True)] | None = Field(
        None, examples=[1.5]
    )
    rotating_load: bool = Field(False, strict=True, examples=[True])
    edition: Literal["2007", "1990"] = Field("2007", examples=["2007"])
    material_factor: _Factor | None = Field(None, examples=[1.0])
    operation_factor: _Factor | None = Field(None, examples=[0.8])
    fatigue_limit: Annotated[
        float, Quantity("stress", at_least="0 Pa", at_most="100 GPa", varies=True)
    ] = Field(374e6, examples=["374 MPa"])
    depth: Literal["local", "mean"] = Field("local", examples=["local"])
    nsk_cleanliness: Annotated[float, Quantity(at_least=0.05, at_most=1.0, varies=True)] | None = (
        Field(None, examples=[0.8])
    )
    tallian_subsurface: TallianFactors | None = None
    tallian_surface: TallianFactors | None = None

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        surface = self.tallian_surface
        if surface is not None and (surface.failure_rate is None or surface.defect_shape != 1.0):
            missing = surface.failure_rate is None
            raise InputError(
                (
                    said("is missing; surface failures have no factors but those given")
                    if missing
                    else said("is 1 for surface failures")
                ),
                field="tallian_surface." + ("failure_rate" if missing else "defect_shape"),
                example="1.0",
            )
        refuse_rivals(self)
        if self.cleanliness not in LEVELS:  # which are the same however the oil is supplied
            self._check_pair("cleanliness", "oil_supply", 'oil_supply = "bath"', '"-/17/14"')
        self._check_pair("filter_size", "filter_ratio", "filter_ratio = 200", '"12 um"')
        return self

    def _check_pair(self, first: str, second: str, second_example: str, value: str) -> None:
        if (getattr(self, first) is None) == (getattr(self, second) is None):
            return
        if getattr(self, second) is None:
            raise InputError(
                phrase(marked("is missing; {first} needs it"), first=first),
                field=second,
                example=second_example,
            )
        raise InputError(
            phrase(marked("needs {first}"), first=first),
            field=second,
            example=f"{first} = {value}",
        )
