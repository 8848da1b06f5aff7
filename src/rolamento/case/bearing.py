"""The internal geometry of a bearing: one row of balls, or a set of rows on one shaft."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Final, Literal, cast, get_args

import numpy as np
from pydantic import (
    ConfigDict,
    Field,
)

from rolamento.case.arrangement import (
    Arrangement,
    BallCount,
    BallRow,
    PreloadField,
    RowOfElements,
)
from rolamento.case.material import DEFAULT_MATERIAL, Material, MaterialField
from rolamento.case.parameters import BallParameters, Rule
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
from rolamento.geometry import free_contact_angle, ring_geometry, sphere_conformity
from rolamento.types import BALL, BearingType, Grooves, of_balls, type_of_element
from rolamento.units import from_si, readable
from rolamento.words import said

__all__ = ["Bearing", "RowPlace", "ball_bearing", "clearance_fits"]

_Conformity = Annotated[float, Quantity(at_least=0.501, at_most=1.0, varies=True)]

LEAST_THRUST_ANGLE: Final = math.radians(45.0)


_ShoulderHeight = Annotated[float, Quantity("length", above="0 mm", at_most="1 m")]


def _required_unless_told(schema: dict[str, Any]) -> None:
    """In the JSON schema, require the geometry only where no designation and no row gives it."""
    own = schema.pop("required", [])
    sphere = [*own, "kind"]  # its outer race follows
    schema["anyOf"] = [
        {"required": names}
        for names in (["designation"], ["rows"], [*own, "outer_conformity"], sphere)
    ]


def _grooves_of(told: Mapping[str, Any]) -> BearingType | None:
    """The type of grooves that a table names; None of plain ones, and of what nobody knows."""
    kind = told.get("kind")
    return type_of_element(BALL, str(kind)) if kind in get_args(Grooves) else None


def _right_angle_of_washers(told: dict[str, Any]) -> float | None:
    """The contact angle that nobody gives: of a thrust bearing."""
    grooves = _grooves_of(told)
    return 0.5 * math.pi if grooves is not None and grooves.washers else None


def _sphere_if_any(told: dict[str, Any]) -> float:
    """The outer conformity that nobody gives: of a self-aligning bearing, else NaN for missing."""
    grooves = _grooves_of(told)
    if grooves is None or not grooves.aligns:
        return math.nan
    angle, spacing = told.get("contact_angle"), told.get("spacing")
    if angle is None and spacing is None:
        return math.nan
    tangent = math.tan(angle) if angle is not None else spacing / told["pitch_diameter"]
    return float(sphere_conformity(told["ball_diameter"], told["pitch_diameter"], tangent))


def _angle_within(bearing: Any) -> Any:
    """Whether the angle is over 45° of washers, below 90° of others, over 0° in a sphere."""
    angle = bearing.contact_angle
    if angle is None:
        return True
    if bearing.bearing_type.washers:
        return angle > LEAST_THRUST_ANGLE
    return (angle < 0.5 * math.pi) & ((angle > 0.0) | (not bearing.bearing_type.aligns))


def _angle_beyond(bearing: "Bearing") -> InputError:
    assert bearing.contact_angle is not None
    if bearing.bearing_type.washers:
        rule, example = said("of a thrust bearing must be greater than 45°"), "90 deg"
    elif bearing.contact_angle == 0.0:
        rule, example = said("of a self-aligning bearing must be greater than 0°"), "10 deg"
    else:
        rule, example = said('must be less than 90°, unless kind = "thrust"'), "40 deg"
    return InputError(
        rule,
        field="contact_angle",
        value=readable(bearing.contact_angle, "angle"),
        example=f'contact_angle = "{example}"',
    )


def _reach(bearing: Any) -> Any:
    return bearing.ball_diameter * (bearing.inner_conformity + bearing.outer_conformity - 1.0)


def _elastic_play(bearing: Any) -> Any:
    """Whether cos α = 1 - P_d/(2BD) stays above 0, and an interference elastic."""
    if bearing.diametral_clearance is None:
        return True
    closed = 1.0 if bearing.shim_angle is None else np.cos(bearing.shim_angle)
    return clearance_fits(bearing.diametral_clearance, _reach(bearing), closed)


def _play_beyond(bearing: "Bearing") -> InputError:
    closed, distance = math.cos(bearing.shim_angle or 0.0), _reach(bearing)
    least, most = (_rounded_length(f * distance) for f in (-0.25, 2.0 * closed))
    assert bearing.diametral_clearance is not None
    return InputError(
        said(
            "must be greater than {least} and less than {most} with these balls and conformities",
            least=least,
            most=most,
        ),
        field="diametral_clearance",
        value=readable(bearing.diametral_clearance, "length"),
        example='diametral_clearance = "0.015 mm"',
    )


def _shoulder_rule(name: str) -> Rule:
    def low(bearing: Any) -> Any:
        height = getattr(bearing, name)
        return True if height is None else height < 0.5 * bearing.ball_diameter

    def too_high(bearing: "Bearing") -> InputError:
        return InputError(
            said(
                "must be less than the ball radius, {ball_diameter}",
                ball_diameter=_rounded_length(bearing.ball_diameter / 2),
            ),
            field=name,
            value=readable(getattr(bearing, name), "length"),
            example=f'{name} = "{_rounded_length(0.2 * bearing.ball_diameter)}"',
        )

    return Rule(low, too_high)


_RULES: Final = (
    *RULES_OF_THE_CIRCLE,
    Rule(_angle_within, _angle_beyond),
    Rule(_elastic_play, _play_beyond),
    _shoulder_rule("inner_shoulder_height"),
    _shoulder_rule("outer_shoulder_height"),
)


class Bearing(RollingBearing):
    """One or more rows of balls between two grooved rings, by their internal geometry.

    The fields are those of one row, or what several rows have in common; what is not given of the
    geometry is then that of the first of `rows`.

    Exactly one of `contact_angle` and `diametral_clearance` is given: the first for an
    angular-contact bearing, whose axial displacement then counts from first contact,
    the second for a deep-groove bearing, whose axial displacement counts from the
    centred position.

    Parameters
    ----------
    element
        What rolls in the rows: ``"ball"``.
    kind
        Of the grooves, where they are not those of a deep-groove or angular contact bearing:
        ``"four_point"``, both rings with two arcs (see `shim_angle`); ``"self_aligning"``, two rows
        in an outer ring that is a sphere about the bearing's centre; ``"thrust"``, one groove a
        washer, face to face.
    designation
        Of the catalogue, such as ``"6305/C3"``: it fills in what is not given of the fields
        from `ball_count` to `outer_conformity`, published or inferred; see `origins`.
    ball_count
        Z, balls in the row, 3 to 500.
    ball_diameter
        D, in m.
    pitch_diameter
        d_m, diameter of the circle of ball centres, in m.
    contact_angle
        α, free contact angle, in rad, 0 ≤ α < π/2; of a thrust bearing 45° to 90°, and 90° if not
        given.
    diametral_clearance
        P_d, in m; negative for an interference. A self-aligning bearing takes `spacing` with it.
    shim_angle
        α_s of a four-point bearing, in rad: the contact angle at which a ball without play would
        touch both arcs of a ring. The arcs' centres are offset by s = (f - ½) D sin α_s.
    inner_conformity, outer_conformity
        f_i, f_o, groove radius over ball diameter, 0.501 to 1. The outer race of a self-aligning
        bearing is not given: the sphere follows from the place of the rows.
    ring_material
        A `Material`, its name or its table; 100Cr6 if not given.
    ball_material
        Likewise; the rings' material if not given.
    inner_shoulder_height, outer_shoulder_height
        Height of the shoulder above the bottom of the groove, in m; without it the groove is
        taken as a half circle, whose edges are at a contact angle of 90°.
    arrangement
        Of a set of equal bearings that share the shaft: ``"DB"``, ``"DF"``, ``"DT"`` … (see
        `rolamento.case.arrangement.ARRANGEMENTS`); x = 0 is then in the middle of the set.
    spacing
        Axial distance between neighbouring rows of an arrangement, or between the rows of a
        self-aligning bearing that is given by its clearance, in m.
    rows
        Instead of an arrangement, the rows one by one.
    preload
        A `Preload`, for sets with rows that face each other; none if not given: the unloaded
        balls of every row just touch.

    Raises
    ------
    InputError
        If a value is missing or out of range, or the values contradict each other.
    """

    model_config = ConfigDict(json_schema_extra=_required_unless_told)

    FILLED_IN: ClassVar = (
        "ball_count", "ball_diameter", "pitch_diameter", "inner_conformity", "outer_conformity",
        "contact_angle", "diametral_clearance", "kind", "shim_angle", "arrangement", "spacing",
        "ball_material", "preload",
    )  # fmt: skip
    VARIES: ClassVar = (
        "ball_diameter",
        "pitch_diameter",
        "contact_angle",
        "diametral_clearance",
        "inner_conformity",
        "outer_conformity",
        "shim_angle",
    )
    STAYS: ClassVar = ("inner_shoulder_height", "outer_shoulder_height")
    INSIDE: ClassVar = ("ball_count", "ball_diameter", "pitch_diameter")
    PLAY: ClassVar = ("contact_angle", "diametral_clearance")
    RIVALS: ClassVar = PLAY
    ROLLS: ClassVar = BALL
    MATERIAL: ClassVar = "ball_material"
    ROW: ClassVar = BallRow
    PARAMETERS: ClassVar = BallParameters
    RULES: ClassVar = _RULES

    element: Literal["ball"] = Field("ball", examples=["ball"])
    kind: Grooves | None = Field(None, examples=[get_args(Grooves)[0]])
    designation: Annotated[Designation | None, Replaces(*DISPLACED)] = Field(
        None, examples=["6305/C3"]
    )
    ball_count: BallCount = Field(examples=[16])
    ball_diameter: Annotated[
        float, Quantity("length", at_least="0.01 mm", at_most="1 m", varies=True)
    ] = Field(examples=["22.23 mm"])
    pitch_diameter: Annotated[
        float, Quantity("length", at_least="0.01 mm", at_most="20 m", varies=True)
    ] = Field(examples=["125.26 mm"])
    contact_angle: Annotated[
        Annotated[float, Quantity("angle", at_least="0 deg", at_most="90 deg", varies=True)] | None,
        Replaces("diametral_clearance"),
    ] = Field(default_factory=_right_angle_of_washers, examples=["40 deg"])
    diametral_clearance: Annotated[
        Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m", varies=True)] | None,
        Replaces("contact_angle"),
    ] = Field(None, examples=["0.015 mm"])
    shim_angle: (
        Annotated[float, Quantity("angle", above="0 deg", below="90 deg", varies=True)] | None
    ) = Field(None, examples=["20 deg"])
    spacing: (
        Annotated[float, Quantity("length", above="0 mm", at_most="10 m", varies=True)] | None
    ) = Field(None, examples=["24 mm"])
    inner_conformity: _Conformity = Field(examples=[0.5232])
    outer_conformity: _Conformity = Field(default_factory=_sphere_if_any, examples=[0.5232])
    ring_material: MaterialField = Field(default_factory=lambda: Material.named(DEFAULT_MATERIAL))
    ball_material: MaterialField = Field(default_factory=lambda data: data["ring_material"])
    inner_shoulder_height: _ShoulderHeight | None = Field(None, examples=["4.5 mm"])
    outer_shoulder_height: _ShoulderHeight | None = Field(None, examples=["4.5 mm"])
    arrangement: Annotated[Arrangement | None, Replaces("rows")] = Field(None, examples=["DB"])
    rows: Annotated[tuple[RowOfElements, ...] | None, Replaces("arrangement", "spacing")] = Field(
        None,
        min_length=1,
        max_length=MOST_ROWS,
        examples=['[{ orientation = "+", position = "0 mm" }]'],
    )
    preload: PreloadField | None = Field(None, examples=["500 N"])

    @property
    def bearing_type(self) -> BearingType:
        """By its grooves, else by its contact angle."""
        if self.kind is not None:
            return type_of_element(BALL, self.kind)
        return of_balls(angled=self.contact_angle is not None)

    def _rows_by_kind(self) -> tuple[RowPlace, ...]:
        """Rows of contacts, each as it would be alone: one groove a ring, at its own angle.

        A four-point bearing has one row of balls, and is two rows of contacts at one place: that
        of the arcs which carry toward +x, and its mirror image.
        """
        alone = self.model_copy(
            update={
                "kind": None,
                "shim_angle": None,
                "spacing": None,
                "contact_angle": self.row_angle,
                "diametral_clearance": None,
            }
        )
        if self.bearing_type.has_arches:
            return RowPlace(alone, 1.0, 0.0, 0.0), RowPlace(alone, -1.0, 0.0, 0.0)
        return rows_about_centre(alone, self.row_angle)

    @property
    def carries_one_way(self) -> bool:
        """Whether the row carries axial load toward one side only."""
        return ring_geometry(self).one_sided

    @property
    def groove_bottom(self) -> float:
        """The contact angle of the grooves' deepest point, from which shoulders count; rad."""
        return self.row_angle if self.bearing_type.washers else 0.0

    @classmethod
    def _adjust(cls, given: Mapping[str, Any], found: dict[str, Any]) -> None:
        """The sphere of a self-aligning bearing follows."""
        grooves = _grooves_of({**given, **found})
        if grooves is not None and grooves.aligns:
            found.pop("outer_conformity", None)

    @property
    def _never_written(self) -> tuple[str, ...]:
        return ("outer_conformity",) if self.bearing_type.aligns else ()

    def _check_fields(self) -> None:
        of, angle, clearance = self.bearing_type, self.contact_angle, self.diametral_clearance
        if of.has_arches and self.shim_angle is None:
            raise InputError(
                said("is missing; a four-point bearing needs it"),
                field="shim_angle",
                example='shim_angle = "20 deg"',
            )
        if not of.has_arches and self.shim_angle is not None:
            raise InputError(
                said("is of four-point bearings only"),
                field="shim_angle",
                value=readable(self.shim_angle, "angle"),
                example='kind = "four_point"',
            )
        if of.aligns:
            self._check_sphere()
        elif math.isnan(self.outer_conformity):
            raise InputError(
                said("is missing"), field="outer_conformity", example="outer_conformity = 0.5232"
            )
        if of.washers and clearance is not None:
            raise InputError(
                said("is not a quantity of a thrust bearing"),
                field="diametral_clearance",
                value=readable(clearance, "length"),
                example='contact_angle = "90 deg"',
            )
        if angle is None and clearance is None:
            raise InputError(
                said("is missing: give the contact angle or the diametral clearance"),
                field="contact_angle",
                example='contact_angle = "40 deg" or diametral_clearance = "0.015 mm"',
            )
        if angle is not None and clearance is not None:
            raise InputError(
                said("cannot be combined with the contact angle: each follows from the other"),
                field="diametral_clearance",
                value=readable(clearance, "length"),
                example='diametral_clearance = "0.015 mm"',
            )

    def _check_sphere(self) -> None:
        if "outer_conformity" in self.model_fields_set:
            raise InputError(
                said("is not given of a self-aligning bearing: its outer race is a sphere"),
                field="outer_conformity",
                value=self.outer_conformity,
                example=said("leave it out"),
            )
        if self.outer_shoulder_height is not None:
            raise InputError(
                said("is not given of a self-aligning bearing: its outer race is a sphere"),
                field="outer_shoulder_height",
                value=from_si(self.outer_shoulder_height, "length"),
                example=said("leave it out"),
            )
        if self.diametral_clearance is not None and self.spacing is None:
            raise InputError(
                said("is missing; a self-aligning bearing given by its clearance needs it"),
                field="spacing",
                example='spacing = "9 mm"',
            )
        if self.contact_angle is not None and self.spacing is not None:
            raise InputError(
                said("cannot be combined with the contact angle: each follows from the other"),
                field="spacing",
                value=readable(self.spacing, "length"),
                example='contact_angle = "10 deg"',
            )

    @property
    def row_angle(self) -> float:
        """The free contact angle of each row as it is built; rad.

        Of a self-aligning bearing that in which its rows stand about the centre, of a four-point
        bearing that at which an axial load takes up the play; else the given or free one.
        """
        if self.contact_angle is not None:
            return self.contact_angle
        if self.bearing_type.aligns:
            return math.atan(self.spacing / self.pitch_diameter) if self.spacing else math.nan
        assert self.diametral_clearance is not None
        reach = self.ball_diameter * (self.inner_conformity + self.outer_conformity - 1.0)
        return float(free_contact_angle(self.diametral_clearance, reach, self.shim_angle or 0.0))


def ball_bearing(case: Any) -> Bearing:
    """Return the bearing of a case, for laws that are of balls only.

    Raises
    ------
    InputError
        If rollers roll in any of its rows.
    """
    bearing = case.bearing
    if any(place.bearing.bearing_type.has_rollers for place in bearing.places):
        raise InputError(
            said("is available for ball bearings only"),
            field="bearing.element",
            value=bearing.element,
            example='element = "ball"',
        )
    return cast("Bearing", bearing)


def clearance_fits(clearance: Any, groove_distance: Any, closed: Any = 1.0) -> Any:
    """Whether a clearance can be taken up, or an interference stay elastic; numbers or arrays.

    closed: cosine of the contact angle without clearance.
    """
    return (-groove_distance / 4 < clearance) & (clearance < 2 * groove_distance * closed)


def _rounded_length(value: float) -> str:
    return readable(float(f"{value:.4g}"), "length")
