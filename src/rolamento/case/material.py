"""Materials of rings and balls: named ones from a data file, or free values."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Annotated, Any, Final

from pydantic import (
    BeforeValidator,
    Field,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    model_serializer,
)

from rolamento._data import toml_of
from rolamento.case.quantity import Line, Quantity, Ratio, at_the_border
from rolamento.case.record import Record
from rolamento.errors import InputError, nearest

__all__ = ["DEFAULT_MATERIAL", "Material", "MaterialField", "material_names"]

DEFAULT_MATERIAL: Final = "100Cr6"


class Material(Record):
    """An isotropic elastic material.

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
    source
        Where the values come from.

    Raises
    ------
    InputError
        If a value is missing or out of range.
    """

    name: Line = Field("custom", examples=["Si3N4, supplier's certificate"])
    youngs_modulus: Annotated[float, Quantity("stress", at_least="1 GPa", at_most="2000 GPa")] = (
        Field(examples=["207 GPa"])
    )
    poisson_ratio: Annotated[float, Ratio(at_least=0.0, at_most=0.49)] = Field(examples=[0.3])
    density: Annotated[
        float, Quantity("density", at_least="100 kg/m^3", at_most="25000 kg/m^3")
    ] = Field(examples=["7810 kg/m^3"])
    source: Line = Field("", repr=False, examples=["supplier's certificate"])

    @classmethod
    def named(cls, name: str) -> Material:
        """Return a material of the data file by its name or an alias, in any case.

        Raises
        ------
        InputError
            If no material has that name; the message gives the nearest one.
        """
        found = _materials_by_name().get(_folded(name))
        if found is not None:
            return found
        near = nearest(name, material_names(with_aliases=True))
        guess = f"did you mean {near}?" if near else f"known: {', '.join(material_names())}"
        raise InputError(
            f"is not a known material; {guess}", value=name, example=f'"{DEFAULT_MATERIAL}"'
        )

    @model_serializer(mode="wrap")
    def _written(self, handler: SerializerFunctionWrapHandler, info: SerializationInfo) -> Any:
        """Write a material of the data file as its name, where a person reads."""
        if at_the_border(info.context) and _materials_by_name().get(_folded(self.name)) == self:
            return self.name
        return handler(self)


def material_names(*, with_aliases: bool = False) -> tuple[str, ...]:
    """Return the names of the materials in the data file, the default first."""
    return tuple(
        name
        for record in _records()
        for name in (record["name"], *(record["aliases"] if with_aliases else ()))
    )


def _looked_up(value: object) -> object:
    if isinstance(value, str):
        return Material.named(value)
    if isinstance(value, Material | Mapping):
        return value
    raise InputError("must be the name of a material, or a table", value=value)


MaterialField = Annotated[
    Material,
    BeforeValidator(_looked_up),
    Field(description="a name or a table", examples=[DEFAULT_MATERIAL]),
]
"""Annotation of a field that takes a material, its name or its table."""


def _folded(name: str) -> str:
    return "".join(name.split()).casefold()


def _records() -> list[dict[str, Any]]:
    records: list[dict[str, Any]] = toml_of("materials")["material"]
    return records


@lru_cache(maxsize=1)
def _materials_by_name() -> dict[str, Material]:
    found: dict[str, Material] = {}
    for record in _records():
        values = {key: value for key, value in record.items() if key != "aliases"}
        material = Material.from_mapping(values)
        for name in (record["name"], *record["aliases"]):
            found[_folded(name)] = material
    return found
