"""Basic load ratings by the internal geometry: ISO 281 and ISO 76.

Of balls (`balls`) and of rollers (`rollers`); both take numbers or arrays that broadcast, in SI,
and give NaN where the standards give no number.
"""

from typing import Any

from rolamento.io.data import toml_of
from rolamento.ratings.balls import (
    INNER_GROOVE,
    MAXIMUM_GAMMA,
    SELF_ALIGNING_CONFORMITY,
    THRUST_CONFORMITY,
    RatedType,
    dynamic_factor,
    dynamic_factor_of_grooves,
    dynamic_factor_of_open_grooves,
    dynamic_rating,
    static_factor,
    static_factor_of_grooves,
    static_factor_of_open_grooves,
    static_rating,
    thrust_dynamic_factor,
    thrust_static_factor,
)
from rolamento.ratings.rollers import (
    RollerRated,
    roller_dynamic_factor,
    roller_dynamic_rating,
    roller_static_rating,
    roller_thrust_dynamic_factor,
)

Rated = RatedType | RollerRated
"""By which formula of the standards a row is rated."""


def rated_as(kind: Rated) -> dict[str, Any]:
    """Return what a formula of the standards differs in, from data/iso_ratings.toml."""
    found: dict[str, Any] = toml_of("iso_ratings")["rated"][kind]
    return found


__all__ = [
    "INNER_GROOVE",
    "MAXIMUM_GAMMA",
    "SELF_ALIGNING_CONFORMITY",
    "THRUST_CONFORMITY",
    "Rated",
    "RatedType",
    "RollerRated",
    "dynamic_factor",
    "dynamic_factor_of_grooves",
    "dynamic_factor_of_open_grooves",
    "dynamic_rating",
    "rated_as",
    "roller_dynamic_factor",
    "roller_dynamic_rating",
    "roller_static_rating",
    "roller_thrust_dynamic_factor",
    "static_factor",
    "static_factor_of_grooves",
    "static_factor_of_open_grooves",
    "static_rating",
    "thrust_dynamic_factor",
    "thrust_static_factor",
]
