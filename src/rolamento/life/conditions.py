"""What the theories of life need beside the solved balls, and where a case gives it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.life_model import LEVELS, LifeModel, TallianFactors
from rolamento.case.rolling_bearing import RollingBearing
from rolamento.errors import InputError
from rolamento.life.contamination import (
    ContaminationClass,
    ContaminationLevel,
    class_of_code,
    class_of_filter,
    class_of_grease,
    level_of,
)
from rolamento.life.hybrid import static_share
from rolamento.life.ioannides_harris import FATIGUE_LIMIT, Depth
from rolamento.life.l_able import FactorTable
from rolamento.life.reliability import RATING_RELIABILITY, Edition, reliability_factor
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.validate import positive, within
from rolamento.words import said

FatigueLoad = Literal["contacts", "estimate"]

_POSITIVE: Final = (
    "dynamic_rating",
    "static_rating",
    "viscosity",
    "viscosity_ratio",
    "temperature",
    "bearing_temperature",
    "material_factor",
    "operation_factor",
    "nsk_cleanliness",
    "required_life",
)


@frozen(kw_only=True, eq=False)
class LifeConditions:
    """Ratings, lubrication and wishes; numbers, or arrays over cases, SI.

    Attributes
    ----------
    dynamic_rating, static_rating
        C_r and C_0r of one row, N; by ISO 281 and ISO 76 from the geometry if not given
    reliability
        required S, such as 0.9
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
    bearing_temperature
        of the hottest of rings and balls; K
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
    tallian_subsurface, tallian_surface
        factors of Tallian's form, by the origin of the failure
    inner_turning, outer_turning
        whether a ring turns against the load; by default those with a speed, and the inner where
        none has
    required_life
        required life, s: the summary gives the reliability with which it is reached
    sources
        where ratings come from that are not the user's own, by name

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
    contamination: ContaminationClass | ContaminationLevel | ArrayLike | None = None
    additives: bool = False
    fatigue_load_limit: FatigueLoad | ArrayLike = "contacts"
    temperature: ArrayLike | None = None
    bearing_temperature: ArrayLike | None = None
    material_factor: ArrayLike | None = None
    operation_factor: ArrayLike | None = None
    fatigue_limit: ArrayLike = FATIGUE_LIMIT
    depth: Depth = "local"
    nsk_cleanliness: ArrayLike | None = None
    nsk_table: FactorTable | None = None
    tallian_subsurface: TallianFactors | None = None
    tallian_surface: TallianFactors | None = None
    inner_turning: bool | None = None
    outer_turning: bool | None = None
    required_life: float | None = None
    sources: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        reliability_factor(self.reliability, self.edition)
        for name in _POSITIVE:
            if getattr(self, name) is not None:
                positive(getattr(self, name), name)
        positive(self.fatigue_limit, "fatigue_limit", zero=True)
        if self.viscosity is not None and self.viscosity_ratio is not None:
            raise InputError(
                said("cannot be combined with the viscosity, from which it follows"),
                field="viscosity_ratio",
                example="viscosity_ratio = 1.5",
            )
        if not isinstance(self.contamination, ContaminationClass | ContaminationLevel | None):
            within(
                self.contamination,
                "contamination",
                "",
                0.0,
                1.0,
                example="contamination = 0.5",
                nan_too=False,
            )
        if isinstance(self.fatigue_load_limit, str):
            if self.fatigue_load_limit not in ("contacts", "estimate"):
                raise InputError(
                    said("must be contacts, estimate or a load"),
                    field="fatigue_load_limit",
                    value=self.fatigue_load_limit,
                    example='fatigue_load_limit = "contacts"',
                )
        else:
            positive(self.fatigue_load_limit, "fatigue_load_limit")


def conditions_of(source: Case | Solved) -> LifeConditions:
    """Return what a case says of its life: the [life] table, its designation, its lubricant.

    Parameters
    ----------
    source
        A case, or solved ones: of these, what varied is an array (cases,).

    Raises
    ------
    InputError
        If the lubricant is dirtier than all classes of the standard.
    """
    case, varied = _case_and_varied(source)
    model = case.life or LifeModel.model_construct()

    def number(name: str) -> Any:
        given = varied.get(f"life.{name}")
        return getattr(model, name) if given is None else np.asarray(given, np.float64)

    dirt = number("contamination")
    as_delivered = source.delivered_case if isinstance(source, Solved) else case
    published, origins = _published_ratings(as_delivered)
    if model.fatigue_load_method is not None:
        published.pop("fatigue_load_limit", None)
    taken = {name: value for name, value in published.items() if number(name) is None}
    sources = {name: origins.get(name, "catalogue") for name in taken}
    limit = taken.pop("fatigue_load_limit", number("fatigue_load_limit"))
    if limit is None:
        limit = model.fatigue_load_method or _fatigue_load_method(as_delivered)
    conditions = LifeConditions(
        **{**{name: number(name) for name in _NUMBERS}, **taken},
        sources=sources,
        reliability=model.reliability,
        required_life=model.required_life,
        edition=model.edition,
        contamination=_class_of(model) if dirt is None else dirt,
        additives=model.additives,
        fatigue_load_limit=limit,
        depth=model.depth,
        tallian_subsurface=model.tallian_subsurface,
        tallian_surface=model.tallian_surface,
        bearing_temperature=_hottest(case, varied),
        inner_turning=False if model.rotating_load else None,
        outer_turning=True if model.rotating_load else None,
    )
    return with_lubricant(conditions, source)


def _case_and_varied(source: Case | Solved) -> tuple[Case, Mapping[str, FloatArray]]:
    """A case, and what varied from it of life and temperatures."""
    if isinstance(source, Case):
        return source, {}
    names = (name for name in source.varied if name.startswith(("life.", "temperature.")))
    return source.case, {name: source.field(name) for name in names}


_NUMBERS: Final = (
    "dynamic_rating",
    "static_rating",
    "viscosity_ratio",
    "material_factor",
    "operation_factor",
    "fatigue_limit",
    "nsk_cleanliness",
)


def _hottest(case: Case, varied: Mapping[str, FloatArray]) -> FloatArray | None:
    """Temperature of the hottest of rings and balls, K; None where none is given."""
    found = []
    for part in ("inner_ring", "outer_ring", "balls"):
        given = varied.get(f"temperature.{part}")
        if given is None and case.temperature is not None:
            given = getattr(case.temperature, part)
        if given is not None:
            found.append(np.asarray(given, np.float64))
    return np.asarray(np.max(np.broadcast_arrays(*found), axis=0)) if found else None


def _class_of(model: LifeModel) -> ContaminationClass | ContaminationLevel | None:
    """Class or level of cleanliness that the model names, if it does."""
    try:
        if model.cleanliness in LEVELS:
            return level_of(model.cleanliness)
        if model.cleanliness is not None and model.oil_supply is not None:
            return class_of_code(model.cleanliness, model.oil_supply)
        if model.filter_size is not None and model.filter_ratio is not None:
            return class_of_filter(model.filter_size, model.filter_ratio)
    except InputError as error:
        raise error.with_details(field=f"life.{error.field}") from None
    return None if model.grease_cleanliness is None else class_of_grease(model.grease_cleanliness)


def _published_ratings(case: Case) -> tuple[dict[str, float], Mapping[str, str]]:
    """Ratings of the catalogue and their sources; C_0 and C_u by the stiffness of the elements."""
    bearing = case.bearing
    published = bearing.published
    if published is None or bearing.rows is not None:
        return {}, {}
    share = static_share(bearing)
    shares = {"dynamic_rating": 1.0, "static_rating": share, "fatigue_load_limit": share}
    found = {name: (getattr(published, name), own) for name, own in shares.items()}
    known = {name: value * own for name, (value, own) in found.items() if value is not None}
    return known, published.sources


def _fatigue_load_method(case: Case) -> FatigueLoad:
    """How C_u is found where neither the user nor the maker gives it.

    From the contacts only where these are known: an interior that is inferred from the ratings
    shows C and C_0, not the conformities on which the pressure depends.
    """
    bearing = case.bearing
    rows = [bearing] if bearing.rows is None else [place.bearing for place in bearing.places]
    inferred = any(_is_inferred(row) for row in rows)
    return "estimate" if inferred else "contacts"


def _is_inferred(bearing: RollingBearing) -> bool:
    """Whether balls or rollers are inferred from the ratings, and not given or published."""
    return "inferred" in [bearing.origins.get(name) for name in bearing.INSIDE]


def with_lubricant(conditions: LifeConditions, source: Case | Solved) -> LifeConditions:
    """Fill in viscosity and temperature from the lubricant, where they are not given.

    Without a lubricant, or its temperature, or with a dry one, the conditions stay as they are.

    Parameters
    ----------
    conditions, source
        What is to be filled in, and from what: a case, or solved ones.
    """
    case, varied = _case_and_varied(source)
    warm = varied.get("temperature.lubricant", case.lubricant_temperature)
    if case.lubricant is None or case.lubricant.kind == "dry" or warm is None:
        return conditions
    kelvin = np.asarray(warm, dtype=np.float64)
    filled: dict[str, Any] = {}
    if conditions.viscosity is None and conditions.viscosity_ratio is None:
        from rolamento.oil.state import oil_state

        filled["viscosity"] = oil_state(case.lubricant, kelvin).kinematic_viscosity
    if conditions.temperature is None:
        filled["temperature"] = kelvin
    return replace(conditions, **filled) if filled else conditions
