"""Sets of bearings: which way each row faces, where it sits, and how the set is preloaded."""

from collections.abc import Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Literal, Self

from pydantic import BeforeValidator, Field, model_validator

from rolamento.case.preload_classes import Level, listed_preload
from rolamento.case.profile import ProfileField
from rolamento.case.quantity import Count, Line, Quantity, Replaces
from rolamento.case.record import ByElement, Record, elements_of, refuse_rivals, replaced
from rolamento.errors import InputError, UnitError
from rolamento.types import BALL, PLAIN_ROLLER, Ribs, RollerElement
from rolamento.units import Dimension, to_si
from rolamento.words import said

__all__ = [
    "ARRANGEMENTS",
    "PRELOAD_KINDS",
    "Arrangement",
    "BallCount",
    "BallRow",
    "Orientation",
    "Preload",
    "PreloadField",
    "RollerRow",
    "RowOfElements",
]

Orientation = Literal["+", "-"]
"""Toward which side the row carries axial load of the shaft."""

Arrangement = Literal["DB", "DF", "DT", "TBT", "TFT", "TT", "QBC", "QFC", "QBT", "QFT", "QT"]

ARRANGEMENTS: Final[dict[Arrangement, tuple[Orientation, ...]]] = {
    "DB": ("+", "-"),
    "DF": ("-", "+"),
    "DT": ("+", "+"),
    "TBT": ("+", "-", "-"),
    "TFT": ("-", "+", "+"),
    "TT": ("+", "+", "+"),
    "QBC": ("+", "+", "-", "-"),
    "QFC": ("-", "-", "+", "+"),
    "QBT": ("+", "-", "-", "-"),
    "QFT": ("-", "+", "+", "+"),
    "QT": ("+", "+", "+", "+"),
}
"""The rows of each arrangement along +x. Back to back (B, "O") the contact lines meet the shaft
outside the set, face to face (F, "X") inside; in tandem (T) all rows face one way."""

PRELOAD_KINDS: Final = ("force", "offset", "spring", "level")
"""The ways to give a preload, one at a time."""

BallCount = Annotated[int, Field(strict=True, ge=3, le=500), Count]
_Phase = Annotated[float, Quantity("angle", at_least="-360 deg", at_most="360 deg")]
_Offset = Annotated[float, Quantity("length", at_least="-10 mm", at_most="10 mm")]
_Shift = Annotated[float, Quantity("length", at_least="-10 m", at_most="10 m")]
_Diameter = Annotated[float, Quantity("length", at_least="0.01 mm", at_most="20 m")]
_Conformity = Annotated[float, Quantity(at_least=0.501, at_most=1.0)]


class _Row(Record):
    """What a row of any rolling elements has of its own."""

    if TYPE_CHECKING:
        element: str
        designation: str | None
        orientation: Orientation
        position: float
        phase: float
        offset: float | None

    @property
    def own(self) -> dict[str, Any]:
        """The geometry that the row has of its own, by field of the bearing.

        None for the bearing's angle or clearance where the row has the other.
        """
        shared = {"element", "orientation", "position", "phase", "offset"}
        record = type(self)
        own = {name: getattr(self, name) for name in record.model_fields if name not in shared}
        given = {name: value for name, value in own.items() if value is not None}
        ended = (other for name in given for other in replaced(record, name))
        return {**dict.fromkeys(ended), **given}

    @model_validator(mode="before")
    @classmethod
    def _with_element(cls, given: Any) -> Any:
        """Let a designation say what rolls."""
        if isinstance(given, Mapping) and "element" not in given:
            told = element_by_designation(given)
            if told in elements_of(cls):
                return {**given, "element": told}
        return given

    @model_validator(mode="after")
    def _angle_or_clearance(self) -> Self:
        refuse_rivals(self)
        return self


class BallRow(_Row):
    """One row of balls of a bearing: where it sits, and what it has of its own.

    Parameters
    ----------
    element
        What rolls in it: ``"ball"``.
    designation
        Of a bearing of one row, which then fills in what is not given of the geometry.
    orientation
        ``"+"`` for a row that carries axial load of the shaft toward +x, ``"-"`` for its mirror
        image. Without meaning for a row given by its clearance.
    position
        Of the balls' plane along x, from the point that the displacements and moments of the
        set refer to, in m.
    phase
        Azimuth of the row's first ball beyond the duty's, in rad.
    ball_count, ball_diameter, pitch_diameter, contact_angle, diametral_clearance
        As in `Bearing`; what is not given is the bearing's.
    inner_conformity, outer_conformity
        Likewise.
    offset
        How far the clamped rings press this row in axially, in m, counted as the offset of a
        `Preload`; in the place of that offset, or beside springs or no preload.

    Raises
    ------
    InputError
        If a value is missing or out of range.
    """

    element: Literal["ball"] = Field("ball", examples=["ball"])
    designation: Line | None = Field(None, examples=["6210"])
    orientation: Orientation = Field("+", examples=["+"])
    position: _Shift = Field(examples=["-12 mm"])
    phase: _Phase = Field(0.0, examples=["11.25 deg"])
    ball_count: BallCount | None = Field(None, examples=[16])
    ball_diameter: _Diameter | None = Field(None, examples=["22.23 mm"])
    pitch_diameter: _Diameter | None = Field(None, examples=["125.26 mm"])
    contact_angle: Annotated[
        Annotated[float, Quantity("angle", at_least="0 deg", below="90 deg")] | None,
        Replaces("diametral_clearance"),
    ] = Field(None, examples=["40 deg"])
    diametral_clearance: Annotated[
        Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m")] | None,
        Replaces("contact_angle"),
    ] = Field(None, examples=["0.015 mm"])
    inner_conformity: _Conformity | None = Field(None, examples=[0.5232])
    outer_conformity: _Conformity | None = Field(None, examples=[0.5232])
    offset: _Offset | None = Field(None, examples=["5 um"])


class RollerRow(_Row):
    """One row of rollers of a bearing: where it sits, and what it has of its own.

    Parameters
    ----------
    element
        What rolls in it: ``"cylindrical"``, ``"tapered"`` or ``"needle"``.
    designation
        Of a bearing of one row, which then fills in what is not given of the geometry.
    orientation
        As of a `BallRow`; a row of cylindrical rollers that faces ``"-"`` has its ribs mirrored.
    position
        Of the rollers' middle plane along x, from the point that the displacements and moments
        of the set refer to, in m.
    phase
        Azimuth of the row's first roller beyond the duty's, in rad.
    roller_count, roller_diameter, roller_length, effective_length, pitch_diameter
        As in `RollerBearing`; what is not given is the bearing's.
    contact_angle, roller_half_angle, roller_end_radius, diametral_clearance
        Likewise.
    inner_ribs, outer_ribs, axial_play, roller_profile, inner_profile, outer_profile
        Likewise.
    offset
        As of a `BallRow`.

    Raises
    ------
    InputError
        If a value is missing or out of range.
    """

    element: RollerElement = Field(PLAIN_ROLLER, examples=[PLAIN_ROLLER])
    designation: Line | None = Field(None, examples=["NU 210"])
    orientation: Orientation = Field("+", examples=["+"])
    position: _Shift = Field(examples=["-12 mm"])
    phase: _Phase = Field(0.0, examples=["11.25 deg"])
    roller_count: BallCount | None = Field(None, examples=[13])
    roller_diameter: _Diameter | None = Field(None, examples=["7.5 mm"])
    roller_length: _Diameter | None = Field(None, examples=["9 mm"])
    effective_length: _Diameter | None = Field(None, examples=["8.2 mm"])
    pitch_diameter: _Diameter | None = Field(None, examples=["38.5 mm"])
    contact_angle: Annotated[float, Quantity("angle", above="0 deg", below="90 deg")] | None = (
        Field(None, examples=["14 deg"])
    )
    roller_half_angle: (
        Annotated[float, Quantity("angle", at_least="0 deg", below="45 deg")] | None
    ) = Field(None, examples=["2 deg"])
    roller_end_radius: (
        Annotated[float, Quantity("length", above="0 mm", at_most="100 m")] | None
    ) = Field(None, examples=["120 mm"])
    diametral_clearance: (
        Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m")] | None
    ) = Field(None, examples=["0.03 mm"])
    inner_ribs: Ribs | None = Field(None, examples=["none"])
    outer_ribs: Ribs | None = Field(None, examples=["both"])
    axial_play: Annotated[float, Quantity("length", at_least="0 mm", at_most="1 m")] | None = Field(
        None, examples=["0.1 mm"]
    )
    roller_profile: ProfileField | None = Field(None, examples=["iso"])
    inner_profile: ProfileField | None = Field(None, examples=["none"])
    outer_profile: ProfileField | None = Field(None, examples=["none"])
    offset: _Offset | None = Field(None, examples=["5 um"])


def as_text(value: object) -> object:
    """Let a designation be written as a number."""
    if isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 10**9:
        return str(value)
    return value


def designation_of(given: Any) -> str | None:
    """The designation of a bearing or a row, as a record or as a table; None without one."""
    told = given if isinstance(given, Mapping) else getattr(given, "__dict__", {})
    designation = as_text(told.get("designation"))
    return designation if isinstance(designation, str) else None


def element_by_designation(given: Mapping[str, Any]) -> str | None:
    """What rolls in a table's designation; None where there is none, or the catalogue lacks it."""
    designation = designation_of(given)
    if designation is not None:
        from rolamento.catalogue import catalogue

        with suppress(InputError):
            return catalogue().find(designation).bearing.type.element
    return None


def element_of_row(row: object, of_bearing: str | None = None) -> str:
    """What rolls in a row, as a record or as a table that nobody has checked.

    of_bearing: what rolls in its bearing, if that is said; balls otherwise.
    """
    if not isinstance(row, Mapping):
        return str(getattr(row, "element", BALL))
    if "element" in row:
        return str(row["element"])
    return element_by_designation(row) or of_bearing or BALL


RowOfElements = Annotated[BallRow | RollerRow, ByElement(element_by_designation)]
"""A row of any rolling elements, distinguished by `element`, else by the designation."""


class Preload(Record):
    """How the rows of a set press on each other when nothing else does: exactly one of these.

    Parameters
    ----------
    force
        Axial force at rest between the rows of either orientation, in N; the rings are then
        clamped: the offset that gives this force stays, the force changes with load and speed.
    offset
        By how much the clamped inner rings press each row in axially from first contact, in m;
        negative leaves play.
    spring
        Constant axial force, in N, by which springs push the outer rings of the rows that
        face ``-``, together and free to slide, into their balls.
    level
        ``"light"``, ``"medium"`` or ``"heavy"`` (of NSK also ``"extra_light"``, of SKF ``"A"`` to
        ``"D"``) as a maker lists it for pairs of the bearing named by `designation`; the rings are
        clamped with the offset of such a pair.
    designation
        In the makers' lists (`rolamento.case.preload_classes`), such as ``"S 6012 C"``; that of
        the bearing if not given.

    Raises
    ------
    InputError
        If none or several are given, or a value is out of range.
    """

    has_short_form: ClassVar = True

    force: Annotated[
        Annotated[float, Quantity("force", at_least="0 N", at_most="1e6 kN", varies=True)] | None,
        Replaces(*PRELOAD_KINDS, "designation"),
    ] = Field(None, examples=["500 N"])
    offset: Annotated[
        Annotated[float, Quantity("length", at_least="-10 mm", at_most="10 mm", varies=True)]
        | None,
        Replaces(*PRELOAD_KINDS, "designation"),
    ] = Field(None, examples=["5 um"])
    spring: Annotated[
        Annotated[float, Quantity("force", above="0 N", at_most="1e6 kN", varies=True)] | None,
        Replaces(*PRELOAD_KINDS, "designation"),
    ] = Field(None, examples=["500 N"])
    level: Annotated[Level | None, Replaces(*PRELOAD_KINDS)] = Field(None, examples=["light"])
    designation: Annotated[Line | None, Replaces("force", "offset", "spring")] = Field(
        None, examples=["S 6012 C"]
    )

    @model_validator(mode="after")
    def _one(self) -> Self:
        given = [name for name in PRELOAD_KINDS if getattr(self, name) is not None]
        if len(given) != 1:
            raise InputError(
                said(
                    "must give exactly one of {preload_kinds}",
                    preload_kinds=", ".join(PRELOAD_KINDS),
                ),
                value=", ".join(given) or "none",
                example='preload = { force = "500 N" }',
            )
        if self.level is None and self.designation is not None:
            raise InputError(
                said("is of a level of preload only"),
                field="designation",
                value=self.designation,
                example='preload = { level = "light", designation = "S 6012 C" }',
            )
        return self

    @classmethod
    def table_of_text(cls, text: str) -> dict[str, Any]:
        """Take "500 N" for a clamped force and "5 um" for a clamped offset."""
        kinds: dict[Dimension, str] = {"force": "force", "length": "offset"}
        for dimension, key in kinds.items():
            try:
                to_si(text, dimension)
            except UnitError:
                continue
            return {key: text}
        raise InputError(
            said("must be a force or an offset with its unit, or a table"),
            value=text,
            example='"500 N", "5 um" or { spring = "500 N" }',
        )

    @property
    def kind(self) -> str:
        """Which of `PRELOAD_KINDS` is given."""
        return next(name for name in PRELOAD_KINDS if getattr(self, name) is not None)

    def pair_force(self, contact_angle: float | None) -> float | None:
        """The listed force of a pair, in N; None where the preload is not given by its level.

        Raises
        ------
        InputError
            If no maker's list has the designation at this contact angle.
        """
        if self.level is None or self.designation is None:
            return None
        return listed_preload(self.designation, self.level, contact_angle)


PreloadField = Annotated[
    Preload,
    BeforeValidator(Preload.text_or_table, json_schema_input_type=Preload | str),
    Field(description="a table, a force or an offset"),
]
"""Annotation of a field that takes a preload, its table, or the force or offset as text."""
