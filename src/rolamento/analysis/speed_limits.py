"""How fast a bearing may run, and what load its balls or rollers need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property, lru_cache
from math import degrees, hypot, isfinite, nan, pi, prod
from typing import Any, Final, Literal

from rolamento.case import Case, case_of
from rolamento.case.bearing import Bearing
from rolamento.case.case import BearingLike, name_of
from rolamento.case.fields import Changes
from rolamento.case.preload_classes import level_of_force
from rolamento.case.roller_bearing import RollerBearing
from rolamento.catalogue import InternalGeometry, parse_designation
from rolamento.errors import InputError
from rolamento.friction.palmgren import constants_by_type, friction_load
from rolamento.io.json import plain
from rolamento.life.equivalent_load import equivalent_load
from rolamento.life.equivalent_load import minimum_axial_load as minimum_thrust_load
from rolamento.oil.state import oil_state
from rolamento.ratings import (
    dynamic_rating,
    rated_as,
    roller_dynamic_rating,
    roller_static_rating,
    static_rating,
)
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.speeds import (
    SpeedFactor,
    ceramic_factor,
    general_minimum_shares,
    heat_shares,
    minimum_axial_load,
    minimum_axial_load_of_thrust,
    minimum_load_factors,
    minimum_radial_load,
    minimum_radial_load_of_rollers,
    minimum_share,
    minimum_share_source,
    minimum_static_share,
    reference_coefficients,
    reference_heat_flow,
    roller_load_factor,
    set_factor,
    speed_class,
    speed_ratio,
    thermal_reference_speed,
)
from rolamento.speeds.permissible import LEAST_PRODUCT, HeatShares
from rolamento.speeds.reference import ReferenceCoefficients
from rolamento.types import of_balls
from rolamento.words import Note, said

__all__ = [
    "Boundary",
    "MinimumLoad",
    "SpeedLimit",
    "SpeedLimits",
    "limiting_speeds",
    "speed_limits",
]

_reference_speed: Final = lru_cache(maxsize=256)(thermal_reference_speed)
"""A bearing's own: found once for all its loads and speeds."""
LimitName = Literal["catalogue", "reference", "permissible", "grease", "oil_bath", "high_speed"]
_RPM: Final = 30.0 / pi
_ISO_SERIES: Final = {"60": "70", "62": "72", "63": "73", "69": "719", "68": "718"}
"""Angular-contact series of the same boundary dimensions as a deep-groove series (ISO 15)."""
_ROW_SHARE: Final = 0.7
"""C of i equal rows of balls is i^0.7 times that of one. ISO 281:2007, 5.1.1."""
_LIGHT_BALLS: Final = 0.5
"""Density of the balls over that of the rings below which they are ceramic."""
_LIGHT: Final = 1.0 / 12.0
_PURE: Final = 0.2
"""P/C and F_a/F_r up to which the maker's limiting speeds stand (NSK E1102, page A37)."""
_WEIGHTIEST: Final = (
    "speed_above_limits", "speed_class_leaves_out", "reference_speed_leaves_out",
    "no_series_for_speed", "no_reference_coefficients", "no_speed_class",
)  # fmt: skip
"""Notes without which the limits would be read as more than they are; they come first."""


def _weight(note: Note) -> int:
    known = note.key in _WEIGHTIEST
    return _WEIGHTIEST.index(note.key) if known else len(_WEIGHTIEST)


@frozen
class Boundary:
    """What of a bearing limits its speed; m, N, rad; None where it is not published.

    Attributes
    ----------
    designation
        empty without one
    series
        of the designation, or that of the catalogue's deep-groove or angular-contact ball bearings
        of this size; empty where neither is known
    bore, outside_diameter, width
        d, D and B, or T of tapered roller bearings
    contact_angle
        nominal, of angular-contact and tapered roller bearings
    dynamic_rating, static_rating
        C and C_0 of one bearing: of both rows of a double row, of both pairs of arcs of QJ
    rows
        bearings side by side
    """

    designation: str
    series: str
    bore: float | None
    outside_diameter: float | None
    width: float | None
    contact_angle: float | None
    dynamic_rating: float
    static_rating: float
    rows: int

    @property
    def mean_diameter(self) -> float | None:
        """(d + D)/2; m."""
        if self.bore is None or self.outside_diameter is None:
            return None
        return 0.5 * (self.bore + self.outside_diameter)

    @property
    def sizes(self) -> tuple[float, float, float] | None:
        """d, D and B, if all are known; m."""
        if self.bore is None or self.outside_diameter is None or self.width is None:
            return None
        return self.bore, self.outside_diameter, self.width


@frozen
class SpeedLimit:
    """One limit of the speed.

    Attributes
    ----------
    name
        "catalogue" (of this bearing, with oil), "reference" (ISO 15312), "permissible" (DIN 732-2),
        or of the maker's class "grease", "oil_bath", "high_speed"
    speed
        rad/s
    share
        the case's speed over it; NaN where it stands still
    source
        where it comes from
    factors
        what makes of it a limit of the set, the preload and the balls of the case
    """

    name: LimitName
    speed: float
    share: float
    source: Note
    factors: tuple[SpeedFactor, ...] = ()


@frozen
class MinimumLoad:
    """One rule for the load that balls or rollers need.

    Attributes
    ----------
    name
        "share" (P ≥ 0.01 C of balls), "radial", "axial" or "thrust"; "general" of a maker's rule
        for all bearings
    load
        that is needed; N
    given
        that the case has; N
    source
        formula, factor, and where it comes from
    """

    name: str
    load: float
    given: float
    source: Note

    @property
    def enough(self) -> bool:
        """Whether the case has it."""
        return self.given >= self.load

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values in SI."""
        return {
            "name": self.name,
            "load": plain(self.load),
            "given": plain(self.given),
            "enough": self.enough,
            "source": self.source.to_mapping(),
        }


@frozen
class SpeedLimits:
    """How fast a bearing may run, and what load it needs.

    Attributes
    ----------
    title
        of the case, or the designation
    boundary
        what they rest on
    speed
        of the rings against each other; rad/s
    mean_diameter
        (d + D)/2, or the pitch diameter where the sizes are not known; m
    limits
        of the speed
    shares
        K_L and K_P of DIN 732-2; None without a permissible speed
    viscosity
        of the oil at its temperature; m²/s, None where the case does not say
    minimum_loads
        what the rolling elements need at this speed
    general_loads
        what makers ask of all bearings, side by side
    cage_slip
        how far the cage lags behind outer raceway control's, by the equilibrium of a case whose
        elements friction moves; None of others
    notes
        what is missing, and what to know
    """

    title: str
    boundary: Boundary
    speed: float
    mean_diameter: float
    limits: tuple[SpeedLimit, ...]
    shares: HeatShares | None
    viscosity: float | None
    minimum_loads: tuple[MinimumLoad, ...]
    general_loads: tuple[MinimumLoad, ...]
    cage_slip: float | None
    notes: tuple[Note, ...]

    @property
    def speed_factor(self) -> float:
        """N d_m as ω d_m; m/s."""
        return self.speed * self.mean_diameter

    @property
    def n_dm(self) -> float:
        """N d_m as people say it; mm · r/min."""
        return 1e3 * _RPM * self.speed_factor

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain values; SI, and n_dm in mm · r/min."""
        boundary = {name: getattr(self.boundary, name) for name in Boundary.__dataclass_fields__}
        return {
            "title": self.title,
            "bearing": plain(boundary),
            "speed": self.speed,
            "mean_diameter": self.mean_diameter,
            "n_dm": self.n_dm,
            "limits": [
                {
                    "name": limit.name,
                    "speed": plain(limit.speed),
                    "share": plain(limit.share),
                    "source": limit.source.to_mapping(),
                    "factors": [factor._asdict() for factor in limit.factors],
                }
                for limit in self.limits
            ],
            "heat_shares": None if self.shares is None else self.shares._asdict(),
            "viscosity": self.viscosity,
            "minimum_loads": [one.to_mapping() for one in self.minimum_loads],
            "general_minimum_loads": [one.to_mapping() for one in self.general_loads],
            "cage_slip": self.cage_slip,
            "notes": [note.to_mapping() for note in self.notes],
        }


def speed_limits(
    bearing: BearingLike,
    changes: Changes = (),
    *,
    series: str | None = None,
    width: float | None = None,
    minimum_load_factor: float | None = None,
) -> SpeedLimits:
    """Find how fast a bearing may run, and what load its balls or rollers need.

    Parameters
    ----------
    bearing
        A designation, a case file, a bearing's record or a `Case`.
    changes
        What goes over the case, by dotted name, such as ``{"duty.load.fz": "5 kN"}``.
    series
        Such as ``"70"`` or ``"NU2"``, in place of what the designation or the size gives.
    width
        B, likewise; m.
    minimum_load_factor
        A of a thrust ball bearing, as its maker lists it; N.

    Raises
    ------
    InputError, FileError
        If there is no such bearing, different elements roll in its rows, or a number is not above
        zero.
    """
    for field, value in (("width", width), ("minimum_load_factor", minimum_load_factor)):
        if value is not None and not (isfinite(value) and value > 0.0):
            raise InputError(said("must be greater than zero"), field=field, value=value)
    case = case_of(bearing, changes)
    boundary = _boundary(case)
    if series is not None:
        boundary = replace(boundary, series=series.strip())
    if width is not None:
        boundary = replace(boundary, width=width)
    return _Asked(case, boundary, minimum_load_factor).answer(name_of(bearing, case))


def limiting_speeds(case: Case) -> tuple[SpeedLimit, ...]:
    """Return the limits that the load does not change: all of `speed_limits` but the permissible.

    Raises
    ------
    InputError
        If different elements roll in the rows.
    """
    return _limits_of_any_load(case.without_load, frozenset(case.bearing.model_fields_set))


@lru_cache(maxsize=64)
def _limits_of_any_load(case: Case, given: frozenset[str]) -> tuple[SpeedLimit, ...]:
    """Found once, while the load changes.

    given: the bearing's own fields, which cases that are equal may differ in.
    """
    return _Asked(case, _boundary(case), None).of_any_load()


def _boundary(case: Case) -> Boundary:
    """Sizes, series and ratings, from the designation, the mounting, the film and the life."""
    bearing, resolved = case.bearing, case.bearing.resolved
    elements = {place.bearing.element for place in bearing.places}
    if len(elements) > 1:
        raise InputError(
            said("is a set of different rolling elements: ask for each bearing alone"),
            field="bearing",
            value=", ".join(sorted(elements)),
            example='rolamento speed "NU 205"',
        )
    published = None if resolved is None else resolved.bearing
    sizes: dict[str, float | None] = {}
    for name in ("bore", "outside_diameter", "width"):
        given = [getattr(table, name, None) for table in (case.mounting, case.film, published)]
        sizes[name] = next((one for one in given if one is not None), None)
    row = bearing.places[0].bearing
    angle = None
    if resolved is not None:
        angle = resolved.bearing.contact_angle or resolved.designation.contact_angle
    if angle is None and row.contact_angle:
        angle = row.contact_angle
    series = _series(bearing, resolved, sizes["bore"], sizes["outside_diameter"], angle is not None)
    together = bearing.rows_of_one_bearing
    ratings = []
    for name in ("dynamic_rating", "static_rating"):
        own = None if case.life is None else getattr(case.life, name)
        listed = None if published is None else getattr(published, name)
        known = own if own is not None else listed
        if known is None:
            known = _rating(row, name, angle or 0.0)
            known *= together if name == "static_rating" else together**_ROW_SHARE
        ratings.append(known)
    return Boundary(
        bearing.designation or "",
        series,
        sizes["bore"],
        sizes["outside_diameter"],
        sizes["width"],
        angle,
        ratings[0],
        ratings[1],
        len(bearing.places) // together,
    )


def _rating(row: Bearing | RollerBearing, name: str, angle: float) -> float:
    """C or C_0 by the standards, NaN of balls on other grooves; N."""
    if isinstance(row, RollerBearing):
        sizes = (row.roller_count, row.roller_diameter, row.effective_length, row.pitch_diameter)
        kind = row.bearing_type
        thrust = bool(rated_as(kind.rated)["axial"])
        if name == "static_rating":
            return float(roller_static_rating(*sizes, angle, thrust=thrust))
        return float(roller_dynamic_rating(*sizes, angle, kind=kind.key, thrust=thrust))
    if row.kind is not None:
        return nan
    of_balls = dynamic_rating if name == "dynamic_rating" else static_rating
    return float(of_balls(row.ball_count, row.ball_diameter, row.pitch_diameter, angle))


def _series(
    bearing: Bearing | RollerBearing,
    told: InternalGeometry | None,
    bore: float | None,
    outside: float | None,
    angular: bool,
) -> str:
    """The series of the designation, of the bearing that it is listed as, or of its size.

    Only deep-groove and angular-contact bearings have a series by their size alone.
    """
    if told is not None:
        named, kind = told.designation, told.bearing.type
        if not named.series:  # found by its whole name: its letters were not taken apart
            listed = parse_designation(told.bearing.designation)
            named = listed if listed.is_angular_contact or listed.kind == kind.key else named
        if kind.in_pairs and not named.is_angular_contact:
            if named.series:  # GMN's S 6012 C has the size of a 7012
                return _ISO_SERIES.get(named.series, "")
        elif named.series:
            return f"{named.bearing_type}{named.series}"
        if kind not in (of_balls(angled=False), of_balls(angled=True)):
            return ""
    if isinstance(bearing, RollerBearing) or bearing.kind is not None:
        return ""
    return _series_of_size(bore, outside, angular)


def _series_of_size(bore: float | None, outside: float | None, angular: bool) -> str:
    """The series of the catalogue's deep-groove bearings of this size; empty without one."""
    if bore is None or outside is None:
        return ""
    from rolamento.catalogue import catalogue, parse_designation

    for one in catalogue().bearings:
        if one.type != of_balls(angled=False) or (one.bore, one.outside_diameter) != (
            bore,
            outside,
        ):
            continue
        found = parse_designation(one.designation).series
        if found and found != "160":
            return _ISO_SERIES.get(found, found) if angular else found
    return ""


@frozen(slots=False)
class _Asked:
    case: Case
    boundary: Boundary
    thrust_factor: float | None

    @property
    def element(self) -> str:
        """What rolls in the rows."""
        return self.case.bearing.places[0].bearing.element

    @property
    def told_of(self) -> dict[str, Any]:
        """Words by which the sentences distinguish rollers."""
        kind = self.case.bearing.places[0].bearing.bearing_type
        return {"element": kind.element, "paired": kind.conical} if kind.has_rollers else {}

    @property
    def speed(self) -> float:
        """Speed of the rings against each other; rad/s."""
        return abs(self.case.duty.inner_speed - self.case.duty.outer_speed)

    @property
    def mean_diameter(self) -> float:
        mean = self.boundary.mean_diameter
        return self.case.bearing.places[0].bearing.pitch_diameter if mean is None else mean

    @cached_property
    def viscosity(self) -> float | None:
        """ν at the lubricant's temperature, m²/s; None where the case does not say."""
        oil, warm = self.case.lubricant, self.case.lubricant_temperature
        if oil is None or oil.kind == "dry" or warm is None:
            return None
        return float(oil_state(oil, warm).kinematic_viscosity)

    @property
    def loads(self) -> tuple[float, float]:
        """F_r and F_a of the duty; N."""
        load = self.case.duty.load
        return hypot(load.fy or 0.0, load.fz or 0.0), abs(load.fx or 0.0)

    def answer(self, title: str) -> SpeedLimits:
        limits, notes = self._listed(), list[Note]()
        found = self._reference(limits, notes)
        shares = None if found is None else self._permissible(*found, limits, notes)
        self._of_maker(limits, notes)
        of_kind = self._minimum_loads if self.element == "ball" else self._minimum_of_rollers
        loads = tuple(of_kind(limits, notes))
        notes += self._excess(limits, loads)
        return SpeedLimits(
            title, self.boundary, self.speed, self.mean_diameter, tuple(limits), shares,
            self.viscosity, loads, self._general_loads(), self._cage_slip(),
            tuple(sorted(notes, key=_weight)),
        )  # fmt: skip

    def of_any_load(self) -> tuple[SpeedLimit, ...]:
        limits, notes = self._listed(), list[Note]()
        self._reference(limits, notes)
        self._of_maker(limits, notes)
        return tuple(limits)

    def _listed(self) -> list[SpeedLimit]:
        published = self.case.bearing.published
        listed = None if published is None else published.limiting_speed
        if published is None or listed is None:
            return []
        where = {"source": published.sources.get("limiting_speed", published.maker)}
        return [self._limit("catalogue", listed, Note("source_listed_speed", where))]

    def _limit(self, name: LimitName, speed: float, source: Note) -> SpeedLimit:
        share = self.speed / speed if self.speed and speed else nan
        return SpeedLimit(name, speed, share, source)

    # --- heat -----------------------------------------------------------------------------------

    def _reference(
        self, limits: list[SpeedLimit], notes: list[Note]
    ) -> tuple[ReferenceCoefficients, float] | None:
        """Reference speed, with its coefficients; None where there is none."""
        given = self.boundary
        type_ = self.case.bearing.bearing_type
        if type_.washers and not type_.has_rollers:
            notes.append(Note("no_reference_speed_of_thrust"))
            return None
        found = reference_coefficients(given.series)
        if found is None:
            if given.series:
                notes.append(Note("no_reference_coefficients", {"series": given.series}))
            return None
        if given.sizes is None:
            notes.append(Note("no_boundary_dimensions"))
            return None
        if not isfinite(given.static_rating):
            notes.append(Note("no_static_rating_for_speed"))
            return None
        speed = _reference_speed(*given.sizes, given.static_rating, found)
        values = {"f_0r": found.f_0r, "f_1r": found.f_1r}
        limits.append(self._limit("reference", speed, Note("source_reference_speed", values)))
        if not found.checked:
            notes.append(Note("reference_coefficients_unchecked", {"series": given.series}))
        left_out = {"rows": given.rows > 1, "ceramic": self._is_hybrid, "parts": self._parts}
        if any(left_out.values()):
            notes.append(Note("reference_speed_leaves_out", left_out))
        return found, speed

    def _permissible(
        self,
        found: ReferenceCoefficients,
        speed: float,
        limits: list[SpeedLimit],
        notes: list[Note],
    ) -> HeatShares | None:
        """Permissible speed, from that of reference; K_L and K_P."""
        given = self.boundary
        if self.viscosity is None:
            notes.append(Note("no_permissible_speed"))
            return None
        radial, axial = (load / given.rows for load in self.loads)
        kind = self.case.bearing.places[0].bearing.bearing_type
        if not kind.has_rollers:
            kind = of_balls(angled=given.contact_angle is not None)
        if kind.key not in constants_by_type() and axial:
            notes.append(Note("no_permissible_speed_under_axial_load"))
            return None
        load = radial
        if kind.key in constants_by_type():
            load = float(friction_load(radial, axial, kind.key, given.contact_angle or 0.0))
        assert given.sizes is not None  # the reference speed needs them
        shares = heat_shares(
            speed, self.mean_diameter, reference_heat_flow(*given.sizes),
            viscosity=self.viscosity, load=load, f_0=found.f_0r, f_1=found.f_1r,
        )  # fmt: skip
        permissible = speed * speed_ratio(*shares)
        values = {"viscosity": self.viscosity, "load": load}
        limits.append(
            self._limit("permissible", permissible, Note("source_permissible_speed", values))
        )
        if 1e6 * self.viscosity * permissible * _RPM < LEAST_PRODUCT:
            notes.append(Note("permissible_speed_of_thin_oil"))
        notes.append(Note("heat_flow_of_reference"))
        return shares

    # --- a maker's experience -------------------------------------------------------------------

    def _of_maker(self, limits: list[SpeedLimit], notes: list[Note]) -> None:
        given = self.boundary
        if not given.series:
            notes.append(Note("no_series_for_speed"))
            return
        found = speed_class(given.series, given.contact_angle)
        factors, left_out = self._factors()
        listed = any(one.name == "catalogue" for one in limits)
        if any(left_out.values()) and (listed or found is not None):
            notes.append(Note("speed_class_leaves_out", left_out))
        if found is None:
            if listed:
                return
            angle = None if given.contact_angle is None else degrees(given.contact_angle)
            notes.append(Note("no_speed_class", {"series": given.series, "angle": angle}))
            return
        share = prod(factor.value for factor in factors)
        for name in ("grease", "oil_bath", "high_speed"):
            product = share * getattr(found, name)
            if name == "high_speed" and (left_out["rows"] or left_out["preload"]):
                continue  # the maker allows it for single bearings only
            if isfinite(product):
                limit = self._limit(name, product / self.mean_diameter, found.source)
                limits.append(replace(limit, factors=factors))
        radial, axial = self.loads
        load = max(radial, axial) / given.rows
        if load > _LIGHT * given.dynamic_rating or axial > _PURE * max(radial, 1e-9):
            notes.append(Note("speed_class_of_light_load"))

    def _factors(self) -> tuple[tuple[SpeedFactor, ...], dict[str, Any]]:
        """Factors on the maker's class, and what of the bearing they leave out.

        They are of angular-contact ball bearings: of others a set and ceramic balls are left out.
        """
        given = self.boundary
        angular = self.element == "ball" and bool(given.contact_angle)
        left_out = {
            "rows": given.rows > 1 and not angular,
            "preload": False,
            "ceramic": self._is_hybrid and not angular,
            "parts": self._parts,
        }
        factors = []
        if given.rows > 1 and angular:
            factors.append(set_factor(given.rows, self._preload_kind))
            left_out["preload"] = factors[0].name == "matched"
        if self._is_hybrid and angular:
            factors.append(ceramic_factor())
        return tuple(factors), left_out

    @property
    def _is_hybrid(self) -> bool:
        """Whether balls of silicon nitride run between rings of steel."""
        row = self.case.bearing.places[0].bearing
        return row.element_material.density < _LIGHT_BALLS * row.ring_material.density

    @property
    def _preload_kind(self) -> str | None:
        """``"spring"``, or the level of the rigid preload; None where it is not known."""
        preload, given = self.case.bearing.preload, self.boundary
        if preload is None:
            return None
        if preload.force is not None and given.contact_angle is not None:
            return level_of_force(preload.force, given.dynamic_rating, given.contact_angle)
        return "spring" if preload.spring is not None else preload.level

    @property
    def _parts(self) -> list[list[str]]:
        """Letters of the designation that bear on its limiting speed, with their meanings."""
        resolved = self.case.bearing.resolved
        if resolved is None:
            return []
        return [list(part) for part in resolved.designation.letters.at_speed]

    # --- minimum load ---------------------------------------------------------------------------

    def _equivalent_load(self) -> float:
        """P of the duty's load by ISO 281; N, NaN beyond 45°."""
        given, (radial, axial) = self.boundary, self.loads
        angle = given.contact_angle or 0.0
        if angle > 0.25 * pi:
            return nan
        places = self.case.bearing.places
        row, facing = places[0].bearing, len({place.sign for place in places}) > 1
        carrying = 1.0 if facing and angle else float(given.rows)
        assert isinstance(row, Bearing)
        relative = axial / (carrying * row.ball_count * row.ball_diameter**2)
        found = equivalent_load(radial, axial, angle, relative, double_row=facing)
        return float(found.load)

    def _minimum_of_rollers(
        self, limits: Sequence[SpeedLimit], notes: list[Note]
    ) -> list[MinimumLoad]:
        given, (radial, _) = self.boundary, self.loads
        bearing = self.case.bearing
        if bearing.bearing_type.washers:  # the rules are for radial load
            return []
        is_full = bearing.published is not None and bearing.published.is_full_complement
        static_share = minimum_static_share(bearing.bearing_type.key, is_full)
        if static_share is not None:
            source = Note("source_minimum_static", {"share": static_share})
            return [MinimumLoad("radial", static_share * given.static_rating, radial, source)]
        share = minimum_share(self.element)
        if share is not None:
            source = Note(
                "source_minimum_of_rollers",
                {"share": share, "source": minimum_share_source(self.element)},
            )
            needed = share * given.dynamic_rating * given.rows
            return [MinimumLoad("radial", needed, radial, source)]
        found = roller_load_factor(given.series)
        reference = next((one.speed for one in limits if one.name == "reference"), None)
        if found is None or reference is None or not self.speed:
            return []
        if not found.checked:
            notes.append(Note("minimum_load_factors_unchecked"))
        needed = given.rows * minimum_radial_load_of_rollers(
            found.factor, self.speed, reference, self.mean_diameter
        )
        source = Note("source_minimum_of_cylindrical", {"factor": found.factor})
        return [MinimumLoad("radial", needed, radial, source)]

    def _minimum_loads(self, limits: Sequence[SpeedLimit], notes: list[Note]) -> list[MinimumLoad]:
        given, (radial, axial) = self.boundary, self.loads
        found = []
        share = minimum_share() or 0.0
        if isfinite(given.dynamic_rating) and not self.case.bearing.bearing_type.washers:
            needed = share * given.dynamic_rating * given.rows**_ROW_SHARE
            source = Note("source_minimum_share", {"share": share})
            found.append(MinimumLoad("share", needed, self._equivalent_load(), source))
        if self.case.bearing.bearing_type.washers and isfinite(given.static_rating):
            published = self.case.bearing.published
            listed = None if published is None else published.limiting_speed
            needed = float(minimum_thrust_load(given.static_rating, self.speed, listed))
            found.append(MinimumLoad("thrust", needed, axial, Note("source_minimum_of_maker")))
        if self.thrust_factor is not None:
            source = Note("source_minimum_thrust", {"factor": self.thrust_factor})
            needed = minimum_axial_load_of_thrust(self.thrust_factor, self.speed)
            found.append(MinimumLoad("thrust", needed, axial, source))
        factors = minimum_load_factors(given.series, given.contact_angle)
        unchecked = False
        if factors.radial is not None and self.viscosity is not None and self.speed:
            source = Note("source_minimum_radial", {"factor": factors.radial})
            needed = minimum_radial_load(
                factors.radial, self.viscosity, self.speed, self.mean_diameter
            )
            found.append(MinimumLoad("radial", needed * given.rows, radial, source))
            unchecked = True
        if factors.axial is not None and self.speed and isfinite(given.static_rating):
            source = Note("source_minimum_axial", {"factor": factors.axial})
            needed = minimum_axial_load(
                factors.axial, given.static_rating, self.speed, self.mean_diameter
            )
            found.append(MinimumLoad("axial", needed, axial, source))
            unchecked = True
        if unchecked:
            notes.append(Note("minimum_load_factors_unchecked"))
        return found

    def _general_loads(self) -> tuple[MinimumLoad, ...]:
        """What makers ask of all bearings: of balls of P, of rollers of F_r."""
        given, bearing = self.boundary, self.case.bearing
        if bearing.bearing_type.washers:
            return ()
        is_full = bearing.published is not None and bearing.published.is_full_complement
        balls = self.element == "ball"
        load = self._equivalent_load() if balls else self.loads[0]
        found = []
        for rule in general_minimum_shares(self.element, is_full):
            static = rule.of == "static"
            rating = given.static_rating if static else given.dynamic_rating
            power = 1.0 if static or not balls else _ROW_SHARE
            if isfinite(rating):
                key = f"source_minimum_general_{rule.of}"
                source = Note(key, rule._asdict())
                needed = rule.share * rating * given.rows**power
                found.append(MinimumLoad("general", needed, load, source))
        return tuple(found)

    def _cage_slip(self) -> float | None:
        """Slip of the cage where friction moves the elements, of a case with a load; else None."""
        case = self.case
        if case.model.raceway_control != "friction" or not self.speed or not any(self.loads):
            return None
        solved = solve(case)
        if solved.rolling is None or not solved.converged[0]:
            return None
        slip = float(solved.rolling.skid[0])
        return slip if isfinite(slip) else None

    def _excess(self, limits: Sequence[SpeedLimit], loads: Sequence[MinimumLoad]) -> list[Note]:
        """What the case exceeds, and what its load does not reach."""
        notes = []
        above = [one.name for one in limits if isfinite(one.share) and one.share > 1.0]
        if above:
            notes.append(Note("speed_above_limits", {"limits": above}))
        preloaded = self.case.bearing.preload is not None
        any_load = any(self.loads)
        if self.speed and not preloaded and any_load and any(not one.enough for one in loads):
            notes.append(Note("load_below_minimum", self.told_of))
        if preloaded and loads:
            notes.append(Note("preload_for_minimum_load"))
        if not any_load and not preloaded:
            notes.append(Note("no_load_to_compare", self.told_of))
        return notes
