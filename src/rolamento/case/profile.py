"""How a roller or a raceway departs from a straight generator, so that its ends do not dig in."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Final, Literal, Self, get_args

from pydantic import BeforeValidator, Field, model_validator

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record
from rolamento.errors import InputError, nearest
from rolamento.words import said

__all__ = ["PROFILE_KINDS", "Profile", "ProfileField", "ProfileKind"]

ProfileKind = Literal["none", "iso", "logarithmic", "crowned", "tangential", "table"]

PROFILE_KINDS: Final[tuple[ProfileKind, ...]] = get_args(ProfileKind)

_NEEDS: Final[dict[ProfileKind, tuple[str, ...]]] = {
    "none": (),
    "iso": (),
    "logarithmic": (),
    "crowned": ("radius",),
    "tangential": ("radius", "flat_length"),
    "table": ("places", "drops"),
}
_MAY_HAVE: Final[dict[ProfileKind, tuple[str, ...]]] = {
    **_NEEDS,
    "iso": ("factor",),
    "logarithmic": ("amplitude", "crowned_length", "end_drop"),
}
_EXAMPLES: Final[dict[ProfileKind, str]] = {
    "none": '"none"',
    "iso": '{ kind = "iso", factor = 0.00035 }',
    "logarithmic": '{ kind = "logarithmic", amplitude = "3 um", crowned_length = "4 mm" }',
    "crowned": '{ kind = "crowned", radius = "1 m" }',
    "tangential": '{ kind = "tangential", radius = "500 mm", flat_length = "5 mm" }',
    "table": '{ kind = "table", places = ["0 mm", "4 mm"], drops = ["0 um", "3 um"] }',
}
_MOST_POINTS: Final = 2001


class Profile(Record):
    """The profile of a roller or a raceway: its drop below the straight generator.

    Parameters
    ----------
    kind
        ``"none"``, straight; ``"iso"``, the logarithmic profile that ISO/TS 16281 assumes where
        nothing is known; ``"logarithmic"``, one with its own amplitude; ``"crowned"``, an arc
        over the whole length; ``"tangential"``, a straight middle that runs into arcs at its
        ends; ``"table"``, as measured. If not given, that which has what is given.
    factor
        Of kind ``"iso"``: the drop's amplitude over the roller's diameter; by default the
        standard's for the kind of bearing and length.
    amplitude
        Of kind ``"logarithmic"``: A in A ln(1/(1 − s²)), in m; by default 0.00035 of the
        roller's diameter.
    crowned_length
        Of kind ``"logarithmic"``: the length at each end over which it drops, in m; by default
        half the effective length, which leaves nothing straight.
    end_drop
        Of kind ``"logarithmic"``: the drop at the end of the effective length, in m; by default
        without bound.
    radius
        Of kinds ``"crowned"`` and ``"tangential"``: of the arcs, in m.
    flat_length
        Of kind ``"tangential"``: the length of the straight middle, in m.
    places, drops
        Of kind ``"table"``: places along the roller from its middle, rising, and the drops there,
        in m, straight between them. From 0 on for a profile whose ends are alike; it has to reach
        to the end of the effective length.

    Raises
    ------
    InputError
        If a value is missing, out of range or of another kind.
    """

    has_short_form: ClassVar = True

    kind: ProfileKind = Field(examples=["iso"])
    factor: Annotated[float, Quantity(above=0.0, at_most=0.01)] | None = Field(
        None, examples=[0.00035]
    )
    amplitude: Annotated[float, Quantity("length", above="0 mm", at_most="10 mm")] | None = Field(
        None, examples=["3 um"]
    )
    crowned_length: Annotated[float, Quantity("length", above="0 mm", at_most="10 m")] | None = (
        Field(None, examples=["4 mm"])
    )
    end_drop: Annotated[float, Quantity("length", above="0 mm", at_most="10 mm")] | None = Field(
        None, examples=["20 um"]
    )
    radius: Annotated[float, Quantity("length", at_least="0.1 mm", at_most="1000 km")] | None = (
        Field(None, examples=["1 m"])
    )
    flat_length: Annotated[float, Quantity("length", at_least="0 mm", at_most="10 m")] | None = (
        Field(None, examples=["5 mm"])
    )
    places: (
        Annotated[
            tuple[Annotated[float, Quantity("length", at_least="-10 m", at_most="10 m")], ...],
            Field(min_length=2, max_length=_MOST_POINTS),
        ]
        | None
    ) = Field(None, examples=['["0 mm", "3 mm", "4 mm"]'])
    drops: (
        Annotated[
            tuple[Annotated[float, Quantity("length", at_least="-10 mm", at_most="10 mm")], ...],
            Field(min_length=2, max_length=_MOST_POINTS),
        ]
        | None
    ) = Field(None, examples=['["0 um", "1 um", "4 um"]'])

    @model_validator(mode="before")
    @classmethod
    def _kind_of_what_is_given(cls, given: Any) -> Any:
        """Let a factor alone be of the profile that has one, as where only it varies."""
        if not isinstance(given, Mapping) or "kind" in given or not given:
            return given
        kinds = (kind for kind, names in _MAY_HAVE.items() if given.keys() <= set(names))
        kind = next(kinds, None)
        return given if kind is None else {**given, "kind": kind}

    @model_validator(mode="after")
    def _of_its_kind(self) -> Self:
        example = f"roller_profile = {_EXAMPLES[self.kind]}"
        for name in type(self).model_fields:
            value = getattr(self, name)
            if name == "kind" or value is None:
                continue
            if name not in _MAY_HAVE[self.kind]:
                raise InputError(
                    said("does not apply to a profile of kind {kind}", kind=self.kind),
                    field=name,
                    example=example,
                )
        for name in _NEEDS[self.kind]:
            if getattr(self, name) is None:
                raise InputError(
                    said("is needed by a profile of kind {kind}", kind=self.kind),
                    field=name,
                    example=example,
                )
        return self

    @model_validator(mode="after")
    def _table_in_order(self) -> Self:
        if self.places is None or self.drops is None:
            return self
        example = f"roller_profile = {_EXAMPLES['table']}"
        if len(self.places) != len(self.drops):
            raise InputError(
                said("must be as many as there are places ({places})", places=len(self.places)),
                field="drops",
                value=len(self.drops),
                example=example,
            )
        if any(before >= after for before, after in pairwise(self.places)):
            raise InputError(said("must rise"), field="places", example=example)
        if self.places[0] > 0.0 or self.places[-1] <= 0.0:
            raise InputError(
                said("must reach from the middle (0) or from one end of the roller to its end"),
                field="places",
                example=example,
            )
        return self

    @classmethod
    def table_of_text(cls, text: str) -> dict[str, Any]:
        """Take the word of a kind that needs nothing else, such as "iso" or "none"."""
        kind = text.strip().casefold()
        if kind in PROFILE_KINDS:
            if _NEEDS[kind]:
                raise InputError(
                    said("needs {names} beside its kind", names=", ".join(_NEEDS[kind])),
                    value=text,
                    example=_EXAMPLES[kind],
                )
            return {"kind": kind}
        known = ", ".join(name for name in PROFILE_KINDS if not _NEEDS[name])
        near = nearest(kind, PROFILE_KINDS)
        raise InputError(
            said("must be {known}, or a table; did you mean {near}?", known=known, near=near)
            if near
            else said("must be {known}, or a table", known=known),
            value=text,
            example=f'"iso" or {_EXAMPLES["crowned"]}',
        )


ProfileField = Annotated[
    Profile,
    BeforeValidator(Profile.text_or_table, json_schema_input_type=Profile | str),
    Field(description="a kind (iso, logarithmic, none) or a table"),
]
"""Annotation of a field that takes a profile: its table, or the word of its kind."""
