"""Materials of rings and balls: named ones from a data file, or free values."""

from typing import Annotated, ClassVar, Final

from pydantic import BeforeValidator, Field

from rolamento.case.named import NamedRecord
from rolamento.case.quantity import Line, Quantity

__all__ = ["DEFAULT_MATERIAL", "Material", "MaterialField"]

DEFAULT_MATERIAL: Final = "100Cr6"


class Material(NamedRecord):
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

    data_file: ClassVar = "materials"
    usual: ClassVar = DEFAULT_MATERIAL

    name: Line = Field("custom", examples=["Si3N4, supplier's certificate"])
    youngs_modulus: Annotated[
        float, Quantity("stress", at_least="1 GPa", at_most="2000 GPa", varies=True)
    ] = Field(examples=["207 GPa"])
    poisson_ratio: Annotated[float, Quantity(at_least=0.0, at_most=0.49, varies=True)] = Field(
        examples=[0.3]
    )
    density: Annotated[
        float, Quantity("density", at_least="100 kg/m^3", at_most="25000 kg/m^3", varies=True)
    ] = Field(examples=["7810 kg/m^3"])
    source: Line = Field("", repr=False, examples=["supplier's certificate"])


MaterialField = Annotated[
    Material,
    BeforeValidator(Material.name_or_table, json_schema_input_type=Material | str),
    Field(description="a name or a table", examples=[DEFAULT_MATERIAL]),
]
"""Annotation of a field that takes a material, its name or its table."""
