"""Ratings of solved rows: as they are given, as a catalogue lists them, or from the geometry."""

from __future__ import annotations

from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Bearing
from rolamento.case.profile import Profile
from rolamento.case.rolling_bearing import RowPlace
from rolamento.contact.line import slice_places
from rolamento.contact.profile import drop
from rolamento.errors import InputError
from rolamento.life.conditions import LifeConditions
from rolamento.life.equivalent_load import MAXIMUM_ANGLE
from rolamento.life.hybrid import is_of_steel, static_share
from rolamento.life.iso281 import EXPONENT, ROLLER_EXPONENT
from rolamento.life.iso281_modified import (
    fatigue_load_limit,
    fatigue_load_limit_of_contacts,
    fatigue_load_limit_of_lines,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.ratings import (
    Rated,
    RatedType,
    dynamic_factor_of_open_grooves,
    dynamic_rating,
    rated_as,
    roller_dynamic_rating,
    roller_static_rating,
    static_factor_of_open_grooves,
    static_rating,
)
from rolamento.records import frozen
from rolamento.solved import Rows, Solved
from rolamento.types import ROLLER, type_of_element
from rolamento.words import said

_ROW_SHARE: Final = 0.7
"""C of i equal rows of balls is i^0.7 times that of one."""
_ROLLER_ROW_SHARE: Final = 7.0 / 9.0
_SAME: Final = 1e-9


class UnratedError(InputError):
    """A bearing that the standards do not rate: it has no life."""


@frozen(eq=False)
class Ratings:
    """C, C_0 and C_u of each row (cases, rows), and of all of them (cases,); N.

    kinds: what the rows are rated as; of thrust bearings the ratings are axial. A set of balls and
    rollers has no rating of all its rows: NaN. fatigue_by_contacts: where C_u is estimated, what
    the contacts of the interior would give for all rows; None elsewhere.
    """

    dynamic: FloatArray
    static: FloatArray
    fatigue: FloatArray
    dynamic_of_set: FloatArray
    static_of_set: FloatArray
    fatigue_of_set: FloatArray
    kinds: tuple[Rated, ...]
    fatigue_by_contacts: FloatArray | None = None
    static_share: float = 1.0
    """What the stiffness of the elements leaves of C_0 and C_u of a steel bearing."""

    @property
    def kind(self) -> Rated:
        """What the first row is rated as: all of them, but in a set of balls and rollers."""
        return self.kinds[0]

    @property
    def is_axial(self) -> bool:
        """Whether these are ratings for axial load."""
        return all(rated_as(kind)["axial"] for kind in self.kinds)

    @property
    def rollers(self) -> BoolArray:
        """Whether each row is of rollers; (rows,)."""
        return np.array([rated_as(kind)["rolls"] == ROLLER for kind in self.kinds])

    @property
    def mixed(self) -> bool:
        """Whether there are rows of balls and of rollers."""
        return len({rated_as(kind)["rolls"] for kind in self.kinds}) > 1

    @property
    def exponents(self) -> FloatArray:
        """Exponents of the load in the rating life of each row, 3 or 10/3; (rows,)."""
        return np.where(self.rollers, ROLLER_EXPONENT, EXPONENT)

    @property
    def fatigue_in_factor(self) -> FloatArray:
        """C_u as it stands in a_ISO: of thrust bearings a third (rollers: over 2.5); (cases,).

        ISO 281:2007, 9.3.3.
        """
        return np.asarray(self.fatigue_of_set / rated_as(self.kind)["fatigue_over"])

    @property
    def fatigue_of_rows_in_factor(self) -> FloatArray:
        """The same of each row; (cases, rows)."""
        return np.asarray(self.fatigue / [rated_as(kind)["fatigue_over"] for kind in self.kinds])


def ratings_of(solved: Solved, angle: FloatArray, given: LifeConditions) -> Ratings:
    """Ratings as given, or from the geometry.

    Parameters
    ----------
    solved
        Of `rolamento.solve`.
    angle
        As `nominal_contact_angle`, (cases, rows); rad.
    given
        Ratings that take the place of these.

    Raises
    ------
    InputError
        If the geometry is outside the standard's table, and no rating is given; or if one rating
        is given of rows of balls and rollers.
    """
    rows, kinds = solved.rows, row_kinds(solved)
    bearing = solved.case.bearing
    together = bearing.rows_of_one_bearing
    shape = rows.ball_diameter.shape
    dynamic, static, fatigue = (np.full(shape, np.nan) for _ in range(3))
    mixed, both = len(set(kinds)) > 1, (given.dynamic_rating, given.static_rating)
    for kind in dict.fromkeys(kinds) if mixed or any(one is None for one in both) else ():
        own = np.flatnonzero([one == kind for one in kinds])
        dynamic[:, own], static[:, own] = _by_geometry(solved, angle, kind, own)
    shares = np.array([static_share(place.bearing) for place in bearing.places])
    static = static * shares
    if mixed:
        _refuse_one_for_all(given)
        for index, place in enumerate(bearing.places):
            dynamic[:, index] = _listed(place, "dynamic_rating", dynamic[:, index])
            static[:, index] = _listed(
                place, "static_rating", static[:, index], static_share(place.bearing)
            )
    share = (
        _ROLLER_ROW_SHARE
        if all(type_of_element(e).has_rollers for e in rows.element)
        else _ROW_SHARE
    )
    dynamic = _rating_or(given.dynamic_rating, dynamic, together**share)
    static = _rating_or(given.static_rating, static, together)
    if dynamic.size and np.all(np.isnan(dynamic)):
        rollers = all(kind.startswith("roller") for kind in kinds)
        raise UnratedError(
            said(
                "is missing: the geometry is outside the table of the standard (D cos "
                "α/d_pw from 0.01 to 0.30)"
            )
            if rollers
            else said(
                "is missing: the geometry is outside the table of the standard (D cos "
                "α/d_m from 0.01 to 0.40)"
            ),
            field="dynamic_rating",
            example="dynamic_rating = 20600.0",
        )
    method = given.fatigue_load_limit
    by_contacts = np.full(shape, np.nan)
    if not isinstance(method, str):
        fatigue = _rating_or(method, static, together)
    else:
        for kind in dict.fromkeys(kinds):
            own = np.flatnonzero([one == kind for one in kinds])
            by_contacts[:, own] = _fatigue_by_contacts(solved, angle, kind, own)
            fatigue[:, own] = (
                by_contacts[:, own]
                if method == "contacts"
                else _fatigue_by_static(rows, static, kind, own)
            )
    nothing = np.nan if mixed else 1.0
    return Ratings(
        dynamic,
        static,
        fatigue,
        nothing * dynamic.sum(axis=1) * len(rows) ** (share - 1.0),
        nothing * static.sum(axis=1),
        nothing * fatigue.sum(axis=1),
        kinds,
        nothing * by_contacts.sum(axis=1)
        if isinstance(method, str) and method == "estimate"
        else None,
        static_share=float(shares.min()),
    )


def row_kinds(solved: Solved) -> tuple[Rated, ...]:
    """By which formula of the standards each row is rated."""
    bearing = solved.case.bearing
    if not any(type_of_element(one).has_rollers for one in solved.rows.element):
        return (bearing.bearing_type.rated,) * len(solved.rows)
    return tuple(_kind_of_place(place) for place in bearing.places)


def _kind_of_place(place: RowPlace) -> Rated:
    own = place.bearing
    steep = own.bearing_type.has_rollers and own.row_angle > MAXIMUM_ANGLE * (1.0 + _SAME)
    return "roller_thrust" if steep else own.bearing_type.rated


def nominal_contact_angle(solved: Solved) -> FloatArray:
    """Contact angle that standards rate the rows by, (cases, rows), rad: that before mounting.

    Of tapered rollers that of the outer raceway, between washers 90°. ISO 281:2007, 4;
    ISO/TS 16281:2008, 4. What fits, heat and speed make of it acts through the elements' loads.
    """
    delivered = solved.before_mounting
    angle = solved.rows.free_contact_angle if delivered is None else delivered.contact_angle
    return np.minimum(angle, 0.5 * np.pi)  # a conical washer leans beyond it


def nominal_conformities(solved: Solved) -> tuple[FloatArray, FloatArray]:
    """Conformities that standards rate the rows by, (cases, rows): those before mounting.

    A warm bearing with ceramic balls has more open grooves, and the same rating.
    """
    given = solved.rows if solved.before_mounting is None else solved.before_mounting
    return given.inner_conformity, given.outer_conformity


def within_rating(angle: FloatArray, kinds: tuple[Rated, ...]) -> FloatArray:
    """Nominal contact angle of radial rows, NaN beyond 45°, of thrust bearings as it is.

    Raises
    ------
    InputError
        If all cases have such a row of balls.
    """
    radial = np.array([not rated_as(kind)["axial"] for kind in kinds])
    steep = radial & (angle > MAXIMUM_ANGLE * (1.0 + _SAME))
    if steep.size and np.all(steep.any(axis=1)):
        raise UnratedError(
            said('is above 45°: such a bearing is rated for axial load; give it kind = "thrust"'),
            field="bearing.contact_angle",
            value=f"{float(np.degrees(angle.max())):.4g} deg",
            example='kind = "thrust"',
        )
    return np.where(steep, np.nan, angle)


def has_steel_elements(solved: Solved) -> bool:
    """Whether the elements of all rows are as stiff as the rings, within a tenth."""
    return all(is_of_steel(place.bearing) for place in solved.case.bearing.places)


def _by_geometry(
    solved: Solved, angle: FloatArray, kind: Rated, own: np.ndarray[tuple[int], np.dtype[np.intp]]
) -> tuple[FloatArray, FloatArray]:
    """C and C_0 of some rows of one kind, of steel, by their geometry; (cases, rows)."""
    rows = solved.rows
    inside = (rows.element_count[own], rows.ball_diameter[:, own])
    around = (rows.pitch_diameter[:, own], angle[:, own])
    if kind == "roller" or kind == "roller_thrust":
        thrust = kind == "roller_thrust"
        shape = (*inside, rows.effective_length[:, own], *around)
        static = roller_static_rating(*shape, thrust=thrust)
        names = [solved.case.bearing.places[index].bearing.listed_type.key for index in own]
        columns = [
            roller_dynamic_rating(*(np.asarray(v)[..., i] for v in shape), kind=name, thrust=thrust)
            for i, name in enumerate(names)
        ]
        return np.stack(columns, axis=1), static
    inner, outer = nominal_conformities(solved)
    grooves = inner[:, own], outer[:, own]
    factor = dynamic_factor_of_open_grooves(inside[1], around[0], grooves, around[1], kind)
    lower = static_factor_of_open_grooves(inside[1], around[0], grooves, around[1], kind)
    static = static_rating(*inside, *around, kind=kind, factor=lower)
    return dynamic_rating(*inside, *around, kind=kind, factor=factor), static


def _refuse_one_for_all(given: LifeConditions) -> None:
    for name in ("dynamic_rating", "static_rating"):
        if getattr(given, name) is not None:
            raise InputError(
                said(
                    "cannot hold for rows of balls and rows of rollers; give each row its"
                    " designation instead"
                ),
                field=f"life.{name}",
                example='rows = [{ designation = "6205" }, { designation = "NU 205" }]',
            )


def _listed(place: RowPlace, name: str, computed: FloatArray, share: float = 1.0) -> FloatArray:
    """A rating of a row by its designation; by the geometry where there is none.

    share: what its elements leave of that of a steel bearing.
    """
    published = place.bearing.published
    value = None if published is None else getattr(published, name)
    return computed if value is None else np.full_like(computed, value * share)


def _fatigue_by_contacts(
    solved: Solved, angle: FloatArray, kind: Rated, own: np.ndarray[tuple[int], np.dtype[np.intp]]
) -> FloatArray:
    rows = solved.rows
    count, pitch = rows.element_count[own], rows.pitch_diameter[:, own]
    diameter, modulus = rows.ball_diameter[:, own], rows.modulus[:, own]
    if kind != "roller" and kind != "roller_thrust":
        conformities = rows.inner_conformity[:, own], rows.outer_conformity[:, own]
        geometry = (diameter, pitch, *conformities, angle[:, own], modulus)
        if len(solved) > 1:
            return fatigue_load_limit_of_contacts(count, *geometry, kind=kind)
        numbers = (np.broadcast_to(count, diameter.shape), *geometry)
        return _fatigue_of_one(kind, *(tuple(one[0].tolist()) for one in numbers))
    places = [solved.case.bearing.places[index] for index in own]
    length = rows.effective_length[:, own]
    drops = [
        _drops(place, length[:, i], diameter[:, i], solved.case.model.slices)
        for i, place in enumerate(places)
    ]
    inner, outer, standard = (np.stack([one[k] for one in drops], axis=1) for k in range(3))
    shape = (count, diameter, length, pitch, angle[:, own], modulus)
    thrust = kind == "roller_thrust"
    # a straighter line peaks at its ends, of which slices know nothing: it gets no credit
    return np.minimum(
        fatigue_load_limit_of_lines(*shape, inner, outer, thrust=thrust),
        fatigue_load_limit_of_lines(*shape, standard, standard, thrust=thrust),
    )


@lru_cache(maxsize=128)
def _fatigue_of_one(kind: RatedType, *numbers: tuple[float, ...]) -> FloatArray:
    """The limit of the rows of one case; its duty may change again and again, they stay."""
    return fatigue_load_limit_of_contacts(*(np.asarray([one]) for one in numbers), kind=kind)


def _drops(
    place: RowPlace, length: FloatArray, diameter: FloatArray, slices: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Drops of roller and inner race, roller and outer race, and of the standard's profile.

    (cases, slices) each, m.
    """
    bearing = place.bearing
    assert not isinstance(bearing, Bearing)
    x = slice_places(length, slices)
    size = {"length": length[:, np.newaxis], "diameter": diameter[:, np.newaxis]}
    profiles = (bearing.roller_profile, bearing.inner_profile, bearing.outer_profile)
    roller, inner, outer, standard = (
        drop(profile, x, tapered=bearing.bearing_type.crowned_whole, **size)
        for profile in (*profiles, Profile(kind="iso"))
    )
    return roller + inner, roller + outer, standard


def _fatigue_by_static(
    rows: Rows,
    static: FloatArray,
    kind: Rated,
    own: np.ndarray[tuple[int], np.dtype[np.intp]],
) -> FloatArray:
    listed = static[:, own]
    known = np.where(np.isnan(listed), 1.0, listed)
    rollers = kind in ("roller", "roller_thrust")
    estimate = fatigue_load_limit(known, rows.pitch_diameter[:, own], rollers=rollers)
    return np.where(np.isnan(listed), np.nan, estimate)


def _rating_or(value: ArrayLike | None, computed: FloatArray, together: float) -> FloatArray:
    """A rating of each row as it is given, or as computed; (cases, rows).

    together: how much greater what is given is, where it is that of several rows.
    """
    if value is None:
        return computed
    array = np.asarray(value, dtype=np.float64) / together
    column = array.reshape(-1, 1) if array.ndim == 1 else array
    if column.ndim > 2 or (column.ndim == 2 and len(column) not in (1, len(computed))):
        raise InputError(said("must be one number, or one for each case"), field="rating")
    return np.broadcast_to(column, computed.shape).copy()
