"""What the theories of life want to know beside the solved balls."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.life._figures import positive, within
from rolamento.life.contamination import ContaminationClass
from rolamento.life.ioannides_harris import FATIGUE_LIMIT, Depth
from rolamento.life.l_able import FactorTable
from rolamento.life.reliability import RATING_RELIABILITY, Edition, reliability_factor
from rolamento.lubrication.oil_state import oil_state

FatigueLoad = Literal["contacts", "estimate"]

_POSITIVE: Final = (
    "dynamic_rating",
    "static_rating",
    "viscosity",
    "viscosity_ratio",
    "temperature",
    "material_factor",
    "operation_factor",
    "nsk_cleanliness",
)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LifeConditions:
    """Ratings, lubrication and wishes; numbers, or arrays over cases, SI.

    Attributes
    ----------
    dynamic_rating, static_rating
        C_r and C_0r of one row, N; by ISO 281 and ISO 76 from the geometry if not given
    reliability
        S wanted, such as 0.9
    edition
        of ISO 281, for a_1
    viscosity
        of the lubricant (a grease's base oil) at the running temperature, kinematic; m²/s
    viscosity_ratio
        κ, in place of the viscosity
    contamination
        a class of `contamination`, or e_C itself; with κ it gives the modified lives
    additives
        whether the lubricant has effective extreme-pressure additives
    fatigue_load_limit
        C_u of one row, N; or "contacts", from Hertz, or "estimate", C_0/22
    temperature
        of the lubricant; K
    material_factor, operation_factor
        a_2 and a_3 of 1990; the adjusted life needs at least one of them
    fatigue_limit
        τ_u of the stress-volume theory, Pa
    depth
        "local" or "mean", of the stress-volume theory
    nsk_cleanliness
        a_c, for L_able
    nsk_table
        a_NSK as read off the maker's chart; without it a_ISO stands in
    inner_turning, outer_turning
        whether a ring turns against the load; by default those with a speed, and the inner where
        none has

    Raises
    ------
    InputError
        If a number is out of range, or two of them exclude each other.
    """

    dynamic_rating: ArrayLike | None = None
    static_rating: ArrayLike | None = None
    reliability: float = RATING_RELIABILITY
    edition: Edition = "2007"
    viscosity: ArrayLike | None = None
    viscosity_ratio: ArrayLike | None = None
    contamination: ContaminationClass | ArrayLike | None = None
    additives: bool = False
    fatigue_load_limit: FatigueLoad | ArrayLike = "contacts"
    temperature: ArrayLike | None = None
    material_factor: ArrayLike | None = None
    operation_factor: ArrayLike | None = None
    fatigue_limit: ArrayLike = FATIGUE_LIMIT
    depth: Depth = "local"
    nsk_cleanliness: ArrayLike | None = None
    nsk_table: FactorTable | None = None
    inner_turning: bool | None = None
    outer_turning: bool | None = None

    def __post_init__(self) -> None:
        reliability_factor(self.reliability, self.edition)
        for name in _POSITIVE:
            if getattr(self, name) is not None:
                positive(getattr(self, name), name)
        positive(self.fatigue_limit, "fatigue_limit", zero=True)
        if self.viscosity is not None and self.viscosity_ratio is not None:
            raise InputError(
                "is given beside the viscosity, from which it follows; give one",
                field="viscosity_ratio",
                example="viscosity_ratio = 1.5",
            )
        if not isinstance(self.contamination, ContaminationClass | None):
            within(self.contamination, "contamination", 0.0, 1.0, "contamination = 0.5")
        if isinstance(self.fatigue_load_limit, str):
            if self.fatigue_load_limit not in ("contacts", "estimate"):
                raise InputError(
                    "must be contacts, estimate or a load",
                    field="fatigue_load_limit",
                    value=self.fatigue_load_limit,
                    example='fatigue_load_limit = "contacts"',
                )
        else:
            positive(self.fatigue_load_limit, "fatigue_load_limit")


def with_lubricant(conditions: LifeConditions, case: Case) -> LifeConditions:
    """Fill in viscosity and temperature from the case's lubricant, where they are not given.

    Without a lubricant, or its temperature, or with a dry one, the conditions stay as they are.
    """
    if case.lubricant is None or case.lubricant.kind == "dry" or case.temperature is None:
        return conditions
    kelvin = case.temperature.lubricant
    filled = conditions
    if conditions.viscosity is None and conditions.viscosity_ratio is None:
        oil = oil_state(case.lubricant, np.array([kelvin]))
        filled = replace(filled, viscosity=float(oil.kinematic_viscosity[0]))
    if conditions.temperature is None:
        filled = replace(filled, temperature=kelvin)
    return filled
