"""The internal geometry of a roller bearing: one row of rollers, or a set of rows on one shaft."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Final, cast, get_args

import numpy as np
from pydantic import ConfigDict, Field

from rolamento.case.arrangement import (
    Arrangement,
    BallCount,
    PreloadField,
    RollerRow,
    RowOfElements,
)
from rolamento.case.material import DEFAULT_MATERIAL, Material, MaterialField
from rolamento.case.parameters import RollerParameters, Rule
from rolamento.case.profile import Profile, ProfileField
from rolamento.case.quantity import Quantity, Replaces
from rolamento.case.rolling_bearing import (
    DISPLACED,
    MOST_ROWS,
    RULES_OF_THE_CIRCLE,
    Designation,
    RollingBearing,
    RowPlace,
    rows_about_centre,
)
from rolamento.errors import InputError
from rolamento.geometry import apex_half_angle, usual_end_radius
from rolamento.types import (
    PLAIN_ROLLER,
    ROLLER,
    BearingType,
    Ribs,
    RollerElement,
    RollerRings,
    type_of_element,
)
from rolamento.units import readable
from rolamento.words import said

__all__ = ["RollerBearing", "axis_angle", "below_axis", "roller_clearance_fits"]

USUAL_RIB_HEIGHT: Final = 0.1
"""Fraction of the roller's diameter: where a rib touches if the bearing does not say; general
knowledge of how high ribs are (a fifth of the diameter), not a figure of a source."""
_MOST_INTERFERENCE: Final = 0.02
"""Fraction of the roller diameter: beyond is no elastic contact."""
_ROUNDING: Final = 1e-12
_RIGHT: Final = 1e-9
"""rad: within it an angle is a right one."""
PROFILE_SHARE: Final = 0.97
"""Radius of the profile of barrel-shaped rollers over that of the outer race, if not given: what
other programs suppose; no standard says."""
MOST_CONFORMING: Final = 0.999
"""Beyond this part of a raceway's radius the contact is a line, and no ellipse."""


_Radius = Annotated[float, Quantity("length", above="0 mm", at_most="20 m", varies=True)]


def _required_unless_told(schema: dict[str, Any]) -> None:
    """In the JSON schema, require the geometry only where no designation and no row gives it."""
    own = schema.pop("required", [])
    angles = [*own, "contact_angle"]
    schema["anyOf"] = [
        {"required": names}
        for names in (["designation"], ["rows"], [*own, "diametral_clearance"], angles)
    ]


def _length_as_effective(told: dict[str, Any]) -> float:
    """The length of rollers of which only the effective one is given."""
    return float(told.get("effective_length", math.nan))


def _type_of(told: Mapping[str, Any]) -> BearingType | None:
    """The type by the rings and rollers that are given; None of what nobody knows."""
    element, kind = told.get("element"), told.get("kind")
    if element not in get_args(RollerElement):
        return None
    return type_of_element(str(element), str(kind) if kind in get_args(RollerRings) else None)


def _is_conical(told: Mapping[str, Any]) -> bool:
    kind = _type_of(told)
    return kind is not None and kind.conical


def _right_angle_of_washers(told: dict[str, Any]) -> float | None:
    """The contact angle that nobody gives: between washers."""
    kind = _type_of(told)
    return 0.5 * math.pi if kind is not None and kind.washers else None


def _half_angle_of_one_apex(told: dict[str, Any]) -> float | None:
    """φ of tapered rollers that roll along all their length; None of others."""
    names = ("roller_diameter", "pitch_diameter", "contact_angle")
    known, kind = [told.get(name) for name in names], _type_of(told)
    if kind is None or not kind.conical or not all(known):
        return None
    return float(apex_half_angle(*cast("list[float]", known), washers=kind.washers))


_SHAPE: Final = frozenset(
    {
        *("roller_diameter", "roller_length", "effective_length"),
        *("pitch_diameter", "contact_angle", "roller_half_angle"),
    }
)
"""Fields of tapered rollers: what the usual radius of their ends follows from."""
_CONES: Final = frozenset({"roller_diameter", "pitch_diameter", "contact_angle"})
"""What the angle of cones follows from that all have one apex."""


def _usual_end_radius(told: dict[str, Any]) -> float | None:
    """That of the tapered rollers of a designation; None of others."""
    known = [told.get(name) for name in ("roller_diameter", "roller_length", "roller_half_angle")]
    if told.get("designation") is None or not _is_conical(told) or not all(known):
        return None
    return float(usual_end_radius(*cast("list[float]", known)))


def _usual_outer_ribs(told: dict[str, Any]) -> Ribs:
    """Those of NU; the inner ring alone holds tapered rollers."""
    return "none" if _is_conical(told) else "both"


def _usual_inner_ribs(told: dict[str, Any]) -> Ribs:
    """A tapered roller leans on the rib at its large end."""
    return "-" if _is_conical(told) else "none"


def _cones_meet_the_axis(bearing: Any) -> Any:
    """Whether 0 < α - 2φ and α < 90°; rollers between washers stand at 90°."""
    if bearing.bearing_type.washers:
        return abs(bearing.contact_angle - 0.5 * math.pi) < _RIGHT
    if not bearing.bearing_type.conical:
        return True
    angle, half_angle = bearing.contact_angle, bearing.roller_half_angle
    return (angle < 0.5 * math.pi) & (angle - 2.0 * half_angle > 0.0) & (half_angle >= 0.0)


def _cones_do_not(bearing: "RollerBearing") -> InputError:
    if bearing.bearing_type.washers:
        return InputError(
            said("of rollers between washers is 90°"),
            field="contact_angle",
            value=readable(bearing.row_angle, "angle"),
            example='contact_angle = "90 deg"',
        )
    return InputError(
        said(
            "must be less than half the contact angle, {half}, and the contact angle less than 90°",
            half=readable(0.5 * bearing.row_angle, "angle"),
        ),
        field="roller_half_angle",
        value=readable(bearing.roller_half_angle or 0.0, "angle"),
        example='roller_half_angle = "2 deg", contact_angle = "14 deg"',
    )


def _elastic_play(bearing: Any) -> Any:
    play = bearing.diametral_clearance
    return True if play is None else roller_clearance_fits(play, bearing.roller_diameter)


def _play_beyond(bearing: "RollerBearing") -> InputError:
    limit = _MOST_INTERFERENCE * bearing.roller_diameter
    return InputError(
        said(
            "must be greater than {least} and less than {most} with these rollers",
            least=readable(float(f"{-limit:.4g}"), "length"),
            most=readable(bearing.roller_diameter, "length"),
        ),
        field="diametral_clearance",
        value=readable(bearing.diametral_clearance or 0.0, "length"),
        example='diametral_clearance = "0.03 mm"',
    )


def _too_short(bearing: "RollerBearing") -> InputError:
    return InputError(
        said(
            "must be at least the effective length, {effective_length}",
            effective_length=readable(bearing.effective_length, "length"),
        ),
        field="roller_length",
        value=readable(bearing.roller_length, "length"),
        example=f'roller_length = "{readable(bearing.effective_length, "length")}"',
    )


def _small_end(bearing: Any) -> Any:
    half_angle = 0.0 if bearing.roller_half_angle is None else bearing.roller_half_angle
    return bearing.roller_length * np.tan(half_angle) < bearing.roller_diameter


def _no_small_end(bearing: "RollerBearing") -> InputError:
    return InputError(
        said("leaves the rollers no small end; their length and diameter do not allow it"),
        field="roller_half_angle",
        value=readable(bearing.roller_half_angle or 0.0, "angle"),
        example='roller_half_angle = "2 deg"',
    )


def _contact_height(bearing: Any) -> Any:
    """Height of the contact with a rib above the edge of the raceway; m."""
    given = bearing.rib_height
    return USUAL_RIB_HEIGHT * bearing.roller_diameter if given is None else given


def _rib_too_high(bearing: "RollerBearing") -> InputError:
    return InputError(
        said(
            "must be less than half the roller diameter, {radius}",
            radius=readable(0.5 * bearing.roller_diameter, "length"),
        ),
        field="rib_height",
        value=readable(bearing.contact_height, "length"),
        example='rib_height = "0.8 mm"',
    )


def _end_reaches_rib(bearing: Any) -> Any:
    radius = bearing.roller_end_radius
    return True if radius is None else below_axis(bearing, _contact_height(bearing)) < radius


def _end_too_small(bearing: "RollerBearing") -> InputError:
    return InputError(
        said(
            "must be greater than {least}, the distance of the contact with the rib from "
            "the roller's axis",
            least=readable(float(below_axis(bearing, bearing.contact_height)), "length"),
        ),
        field="roller_end_radius",
        value=readable(bearing.roller_end_radius or 0.0, "length"),
        example='roller_end_radius = "120 mm"',
    )


def axis_angle(bearing: Any) -> Any:
    """Angle of the rollers' axes to the shaft: β = α - φ, between washers α; rad.

    bearing: a record or parameters.
    """
    angle = 0.0 if bearing.contact_angle is None else bearing.contact_angle
    kind = bearing.bearing_type
    return angle - bearing.roller_half_angle if kind.conical and not kind.washers else angle


def raceway_radii(bearing: Any) -> tuple[Any, Any, Any]:
    """Return r_r, r_i and R_o of barrel-shaped rollers and their raceways; m.

    bearing: a record or parameters. The sphere is about the bearing's centre.
    """
    angle = bearing.contact_angle
    cosine = 1.0 if angle is None else np.cos(angle)
    outer = bearing.outer_raceway_radius
    if outer is None:
        outer = 0.5 * bearing.pitch_diameter / cosine + 0.5 * bearing.roller_diameter
    inner = outer if bearing.inner_raceway_radius is None else bearing.inner_raceway_radius
    given = bearing.roller_profile_radius
    return PROFILE_SHARE * outer if given is None else given, inner, outer


def _arcs_are_open(bearing: Any) -> Any:
    """Whether the profile of barrel-shaped rollers is rounder than their raceways."""
    if not bearing.bearing_type.barrels:
        return True
    profile, inner, outer = raceway_radii(bearing)
    least = 0.5 * bearing.roller_diameter
    return (
        (profile < inner * MOST_CONFORMING)
        & (profile < outer * MOST_CONFORMING)
        & (profile > least)
    )


def _arcs_are_not(bearing: "RollerBearing") -> InputError:
    profile, inner, outer = raceway_radii(bearing)
    least = 0.5 * bearing.roller_diameter
    return InputError(
        said(
            "must be greater than half the roller diameter, {least}, and less than the radii of"
            " both raceways, {inner} and {outer}",
            least=readable(least, "length"),
            inner=readable(float(f"{float(inner):.6g}"), "length"),
            outer=readable(float(f"{float(outer):.6g}"), "length"),
        ),
        field="roller_profile_radius",
        value=readable(float(f"{float(profile):.6g}"), "length"),
        example=said("leave it out"),
    )


def _check_rings(bearing: "RollerBearing") -> None:
    """A sphere about the centre follows, a torus is given; angles are of spherical rows."""
    kind = bearing.bearing_type
    if bearing.element != kind.element:
        raise InputError(
            said('does not go with element = "{element}"', element=bearing.element),
            field="kind",
            value=bearing.kind,
            example=f'element = "{kind.element}"',
        )
    if kind.barrels and kind.aligns and bearing.outer_raceway_radius is not None:
        raise InputError(
            said("is not given of such a bearing: its outer race is a sphere about its centre"),
            field="outer_raceway_radius",
            value=readable(bearing.outer_raceway_radius, "length"),
            example=said("leave it out"),
        )
    if kind.barrels and not kind.aligns and bearing.outer_raceway_radius is None:
        raise InputError(
            said("is missing; a toroidal roller bearing needs it"),
            field="outer_raceway_radius",
            example='outer_raceway_radius = "150 mm"',
        )
    if bearing.kind is not None and kind.inclined and not bearing.contact_angle:
        raise InputError(
            said("is missing; a spherical roller bearing needs it"),
            field="contact_angle",
            example='contact_angle = "10 deg"',
        )
    if not kind.barrels:
        for name in ("roller_profile_radius", "inner_raceway_radius", "outer_raceway_radius"):
            value = getattr(bearing, name)
            if value is not None:
                raise InputError(
                    said("is of barrel-shaped rollers only"),
                    field=name,
                    value=readable(value, "length"),
                    example='element = "barrel"',
                )


_RULES: Final = (
    *RULES_OF_THE_CIRCLE,
    Rule(_cones_meet_the_axis, _cones_do_not),
    Rule(_elastic_play, _play_beyond),
    Rule(lambda b: b.effective_length <= b.roller_length * (1.0 + _ROUNDING), _too_short),
    Rule(_small_end, _no_small_end),
    # a rib touches a roller below its axis, and the sphere of its end reaches there
    Rule(lambda b: _contact_height(b) < 0.5 * b.roller_diameter, _rib_too_high),
    Rule(_end_reaches_rib, _end_too_small),
    Rule(_arcs_are_open, _arcs_are_not),
)


class RollerBearing(RollingBearing):
    """One or more rows of rollers between two rings, by their internal geometry.

    The fields are those of one row, or what several rows have in common; what is not given of the
    geometry is then that of the first of `rows`.

    Cylindrical and needle rollers have a `diametral_clearance`, and x counts from where the ring
    stands without load. Tapered rollers have a `contact_angle` and a `roller_half_angle`, and x
    counts from first contact.

    Parameters
    ----------
    element
        What rolls in the rows: ``"cylindrical"``, ``"tapered"``, ``"needle"`` or ``"barrel"``.
    designation
        Of the catalogue, such as ``"NU 205/C3"``: it fills in what is not given of the geometry,
        published or inferred; see `origins`.
    roller_count
        Z, rollers in the row, 3 to 500.
    roller_diameter
        D_we, of a tapered roller in the middle of its length, in m.
    roller_length
        L of the roller from end to end, in m; the effective length if not given.
    effective_length
        L_we, of the line of contact, in m.
    pitch_diameter
        d_pw, diameter of the circle of the rollers' middles, in m.
    contact_angle
        α of tapered rollers, that of the outer raceway's line of action, and of barrel-shaped ones;
        in rad.
    kind
        Of the rings. Of barrel-shaped rollers: ``"spherical"``, two rows at ± the contact angle in
        an outer ring that is a sphere about the bearing's centre; ``"toroidal"``, one row whose
        races are tori; one row in a sphere if not given. Of cylindrical and tapered ones:
        ``"thrust"``, between washers that are flat, or both cones.
    roller_half_angle
        φ of tapered rollers, half of the angle of their cone, in rad; the inner raceway's line of
        action is at α - 2φ. Between washers α = 90° is the angle of the rollers' axes, the washers'
        lines of action are at α ± φ. If not given, that of cones which all have one apex.
    roller_profile_radius
        r_r, of the profile of barrel-shaped rollers in m; 0.97 of the outer raceway's if not given.
    inner_raceway_radius, outer_raceway_radius
        r_i and R_o, of the profiles of the raceways of barrel-shaped rollers, in m. The outer
        raceway of a spherical or barrel roller bearing is a sphere about its centre, and not given;
        the inner one has the same radius if not given.
    diametral_clearance
        s of cylindrical and needle rollers, in m; negative for an interference.
    inner_ribs, outer_ribs
        At which ends of the rollers the ring has a rib: ``"none"``, ``"+"`` toward +x, ``"-"``
        toward -x, ``"both"``. NU: ``"none"`` and ``"both"``, the default; N: ``"both"`` and
        ``"none"``; NJ: one end and ``"both"``; NUP: ``"both"`` and ``"both"``. The rib of a
        tapered bearing stands at the rollers' large end, on the inner ring.
    axial_play
        Of cylindrical rollers between ribs that face each other, in m.
    rib_height
        Height of the point where a roller's end touches a rib above the edge of the raceway, in m;
        if not given, a tenth of the roller's diameter.
    roller_end_radius
        Of the sphere that ends a tapered roller, in m; with the height of the contact it gives the
        direction of the rib's force, and the film there. If not given, that of a designation is
        assumed, 0.95 of the distance from the apex (`rolamento.geometry.usual_end_radius`); without
        a designation the sphere is about the apex, and the film at the rib is not known.
    roller_profile
        A `Profile` of the rollers, or its kind: ``"iso"``, the logarithmic one of ISO/TS 16281 and
        the default, ``"none"`` …
    inner_profile, outer_profile
        Of the raceways, likewise; straight if not given.
    ring_material
        A `Material`, its name or its table; 100Cr6 if not given.
    roller_material
        Likewise; the rings' material if not given.
    arrangement
        Of a set of equal bearings that share the shaft, as of `Bearing`: ``"DB"`` (O), ``"DF"``
        (X), ``"DT"`` …
    spacing
        Axial distance between the middles of neighbouring rows of an arrangement, in m.
    rows
        Instead of an arrangement, the rows one by one.
    preload
        A `Preload`, for sets of tapered rows that face each other; none if not given: the unloaded
        rollers of every row just touch.

    Raises
    ------
    InputError
        If a value is missing or out of range, or the values contradict each other.
    """

    model_config = ConfigDict(json_schema_extra=_required_unless_told)

    FILLED_IN: ClassVar = (
        "element", "kind", "roller_count", "roller_diameter", "roller_length", "effective_length",
        "pitch_diameter", "contact_angle", "roller_half_angle", "roller_end_radius",
        "roller_profile_radius", "inner_raceway_radius", "outer_raceway_radius",
        "diametral_clearance", "inner_ribs", "outer_ribs", "axial_play", "arrangement", "spacing",
        "roller_material", "preload",
    )  # fmt: skip
    VARIES: ClassVar = (
        "roller_diameter",
        "effective_length",
        "roller_length",
        "pitch_diameter",
        "contact_angle",
        "roller_half_angle",
        "roller_profile_radius",
        "inner_raceway_radius",
        "outer_raceway_radius",
        "diametral_clearance",
        "axial_play",
        "rib_height",
        "roller_end_radius",
    )
    STAYS: ClassVar = (
        "inner_ribs",
        "outer_ribs",
        "roller_profile",
        "inner_profile",
        "outer_profile",
    )
    INSIDE: ClassVar = ("roller_count", "roller_diameter", "effective_length", "pitch_diameter")
    PLAY: ClassVar = ("contact_angle", "diametral_clearance")
    ROLLS: ClassVar = ROLLER
    MATERIAL: ClassVar = "roller_material"
    ROW: ClassVar = RollerRow
    PARAMETERS: ClassVar = RollerParameters
    RULES: ClassVar = _RULES

    element: RollerElement = Field(PLAIN_ROLLER, examples=[PLAIN_ROLLER])
    designation: Annotated[Designation | None, Replaces(*DISPLACED)] = Field(
        None, examples=["NU 205/C3"]
    )
    kind: RollerRings | None = Field(None, examples=[get_args(RollerRings)[0]])
    roller_count: BallCount = Field(examples=[13])
    roller_diameter: Annotated[
        float, Quantity("length", at_least="0.01 mm", at_most="1 m", varies=True)
    ] = Field(examples=["7.5 mm"])
    effective_length: Annotated[
        float, Quantity("length", at_least="0.01 mm", at_most="1 m", varies=True)
    ] = Field(examples=["8.2 mm"])
    roller_length: Annotated[
        float, Quantity("length", at_least="0.01 mm", at_most="1 m", varies=True)
    ] = Field(default_factory=_length_as_effective, examples=["9 mm"])
    pitch_diameter: Annotated[
        float, Quantity("length", at_least="0.01 mm", at_most="20 m", varies=True)
    ] = Field(examples=["38.5 mm"])
    contact_angle: (
        Annotated[float, Quantity("angle", at_least="0 deg", at_most="90 deg", varies=True)] | None
    ) = Field(default_factory=_right_angle_of_washers, examples=["14 deg"])
    roller_half_angle: (
        Annotated[float, Quantity("angle", at_least="0 deg", below="45 deg", varies=True)] | None
    ) = Field(default_factory=_half_angle_of_one_apex, examples=["2 deg"])
    roller_profile_radius: _Radius | None = Field(None, examples=["50 mm"])
    inner_raceway_radius: _Radius | None = Field(None, examples=["52 mm"])
    outer_raceway_radius: _Radius | None = Field(None, examples=["52 mm"])
    diametral_clearance: (
        Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m", varies=True)] | None
    ) = Field(None, examples=["0.03 mm"])
    inner_ribs: Ribs = Field(default_factory=_usual_inner_ribs, examples=["none"])
    outer_ribs: Ribs = Field(default_factory=_usual_outer_ribs, examples=["both"])
    axial_play: (
        Annotated[float, Quantity("length", at_least="0 mm", at_most="1 m", varies=True)] | None
    ) = Field(None, examples=["0.1 mm"])
    rib_height: (
        Annotated[float, Quantity("length", above="0 mm", at_most="1 m", varies=True)] | None
    ) = Field(None, examples=["0.8 mm"])
    roller_end_radius: (
        Annotated[float, Quantity("length", above="0 mm", at_most="100 m", varies=True)] | None
    ) = Field(default_factory=_usual_end_radius, examples=["120 mm"])
    roller_profile: ProfileField = Field(
        default_factory=lambda: Profile(kind="iso"), examples=["iso"]
    )
    inner_profile: ProfileField = Field(
        default_factory=lambda: Profile(kind="none"), examples=["none"]
    )
    outer_profile: ProfileField = Field(
        default_factory=lambda: Profile(kind="none"), examples=["none"]
    )
    ring_material: MaterialField = Field(default_factory=lambda: Material.named(DEFAULT_MATERIAL))
    roller_material: MaterialField = Field(default_factory=lambda data: data["ring_material"])
    arrangement: Annotated[Arrangement | None, Replaces("rows")] = Field(None, examples=["DB"])
    spacing: (
        Annotated[float, Quantity("length", above="0 mm", at_most="10 m", varies=True)] | None
    ) = Field(None, examples=["24 mm"])
    rows: Annotated[tuple[RowOfElements, ...] | None, Replaces("arrangement", "spacing")] = Field(
        None,
        min_length=1,
        max_length=MOST_ROWS,
        examples=['[{ element = "cylindrical", position = "0 mm" }]'],
    )
    preload: PreloadField | None = Field(None, examples=["500 N"])

    @classmethod
    def _adjust(cls, given: Mapping[str, Any], found: dict[str, Any]) -> None:
        """Rollers of another shape than the catalogue's have their own ends; washers are flat."""
        kind = _type_of({"element": PLAIN_ROLLER, **given, **found})
        if kind is not None and kind.washers:
            for name in ("contact_angle", "diametral_clearance"):
                found.pop(name, None)
        changed = {name for name in _SHAPE if given.get(name) is not None}
        if changed & _CONES:
            found.pop("roller_half_angle", None)
        if changed:
            found.pop("roller_end_radius", None)

    @property
    def bearing_type(self) -> BearingType:
        """By its rings where they are not plain, else by its rollers."""
        return type_of_element(self.element, self.kind)

    def _rows_by_kind(self) -> tuple[RowPlace, ...]:
        return rows_about_centre(self.model_copy(update={"kind": None}), self.row_angle)

    @property
    def carries_one_way(self) -> bool:
        """Whether the row carries axial load toward one side only."""
        return self.bearing_type.conical or self.row_angle > 0.0

    @property
    def locates(self) -> bool:
        """Whether clamped rings can press the row in along x."""
        return self.bearing_type.conical

    @property
    def row_angle(self) -> float:
        """α: that of the outer raceway of tapered rollers, 90° between washers, else 0; rad."""
        return self.contact_angle or 0.0

    @property
    def inner_contact_angle(self) -> float:
        """β - φ, of the inner raceway; rad."""
        return float(axis_angle(self)) - (self.roller_half_angle or 0.0)

    @property
    def outer_contact_angle(self) -> float:
        """β + φ, of the outer raceway: α, but of a conical washer; rad."""
        return float(axis_angle(self)) + (self.roller_half_angle or 0.0)

    @property
    def contact_height(self) -> float:
        """Height of the contact with a rib above the edge of the raceway; m."""
        return float(_contact_height(self))

    @property
    def _never_written(self) -> tuple[str, ...]:
        given = self.model_fields_set
        names = (
            "roller_length", "roller_half_angle", "roller_end_radius", "inner_ribs", "outer_ribs",
            "roller_profile", "inner_profile", "outer_profile",
        )  # fmt: skip
        return tuple(name for name in names if name not in given)

    def _check_fields(self) -> None:
        self._check_angles()
        _check_rings(self)
        self._check_play()

    def _check_angles(self) -> None:
        """Tapered rollers have their angles, others none."""
        examples = {
            "contact_angle": 'contact_angle = "14 deg"',
            "roller_half_angle": 'roller_half_angle = "2 deg"',
        }
        for name, example in examples.items():
            value = getattr(self, name)
            kind = self.bearing_type
            inclined = (kind.inclined or kind.washers) and name == "contact_angle"
            if self.bearing_type.conical and value is None:
                raise InputError(
                    said("is missing; tapered rollers need it"), field=name, example=example
                )
            if not self.bearing_type.conical and value and not inclined:
                raise InputError(
                    said("is of tapered rollers only"),
                    field=name,
                    value=readable(value, "angle"),
                    example='element = "tapered"',
                )

    def _check_play(self) -> None:
        """Cylindrical and needle rollers have a clearance, cones none."""
        play, conical = self.diametral_clearance, self.bearing_type.conical
        if self.bearing_type.washers:
            if play is not None:
                raise InputError(
                    said("is not a quantity of a thrust bearing"),
                    field="diametral_clearance",
                    value=readable(play, "length"),
                    example='contact_angle = "90 deg"',
                )
            return
        if conical and play is not None:
            raise InputError(
                said("is of cylindrical and needle rollers; a tapered row takes a preload offset"),
                field="diametral_clearance",
                value=readable(play, "length"),
                example='preload = { offset = "-10 um" }',
            )
        if not conical and play is None:
            raise InputError(
                said("is missing"),
                field="diametral_clearance",
                example='diametral_clearance = "0.03 mm"',
            )


def below_axis(bearing: Any, contact_height: Any) -> Any:
    """Where a rib touches the large end of a roller, from the roller's axis; m.

    bearing: attributes, numbers or arrays (cases,).
    """
    half_angle = 0.0 if bearing.roller_half_angle is None else bearing.roller_half_angle
    taper = 0.5 * bearing.roller_length * np.tan(half_angle)
    return 0.5 * bearing.roller_diameter + taper - contact_height


def roller_clearance_fits(clearance: Any, roller_diameter: Any) -> Any:
    """Whether a clearance is less than a roller, and an interference elastic; numbers or arrays."""
    least = -_MOST_INTERFERENCE * roller_diameter
    return (least < clearance) & (clearance < roller_diameter)
