"""The internal geometry of a bearing: one row of balls, or a set of rows on one shaft."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal, NamedTuple, Self

from pydantic import (
    BeforeValidator,
    ConfigDict,
    Field,
    ModelWrapValidatorHandler,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    ValidationInfo,
    model_serializer,
    model_validator,
)

from rolamento.case.arrangement import (
    ARRANGEMENTS,
    Arrangement,
    BallCount,
    BallRow,
    PreloadField,
    RowOfElements,
)
from rolamento.case.material import DEFAULT_MATERIAL, Material, MaterialField
from rolamento.case.quantity import Line, Quantity, Ratio, Replaces, at_the_border
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.units import Dimension, from_si
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.catalogue import CatalogueBearing

__all__ = ["Bearing", "RowPlace", "balls_fit", "clearance_fits"]

MOST_ROWS: Final = 32
_SET_FIELDS: Final = ("arrangement", "spacing", "rows", "preload")
_BALL_FIELDS: Final = ("ball_count", "ball_diameter", "pitch_diameter")
_PLAY: Final = ("contact_angle", "diametral_clearance")
_CATALOGUE_FIELDS: Final[Mapping[str, Dimension | None]] = {
    "ball_count": None,
    "ball_diameter": "length",
    "pitch_diameter": "length",
    "inner_conformity": None,
    "outer_conformity": None,
    "contact_angle": "angle",
    "diametral_clearance": "length",
}
"""What a designation fills in, by the dimension."""

_Conformity = Annotated[float, Ratio(at_least=0.501, at_most=1.0, varies=True)]


def _as_text(value: object) -> object:
    """Let a designation be written as a number."""
    if isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 10**9:
        return str(value)
    return value


_Designation = Annotated[
    Line,
    BeforeValidator(_as_text, json_schema_input_type=Annotated[str, Field(max_length=200)] | int),
]
_DISPLACED: Final = (
    *_BALL_FIELDS,
    *(f"{part}.{name}" for part in ("mounting", "film") for name in ("bore", "outside_diameter")),
    *(f"life.{name}" for name in ("dynamic_rating", "static_rating")),
)
"""Another bearing of the catalogue has other balls, another size and other ratings."""
_ShoulderHeight = Annotated[float, Quantity("length", above="0 mm", at_most="1 m")]


def _required_unless_told(schema: dict[str, Any]) -> None:
    """In the JSON schema, require the geometry only where no designation and no row tells it."""
    own = schema.pop("required", [])
    schema["anyOf"] = [{"required": names} for names in (["designation"], ["rows"], own)]


class Bearing(Record):
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
        α, free contact angle, in rad, 0 ≤ α < π/2.
    diametral_clearance
        P_d, in m; negative for an interference.
    inner_conformity, outer_conformity
        f_i, f_o, groove radius over ball diameter, 0.501 to 1.
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
        Axial distance between neighbouring rows of an arrangement, in m.
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

    element: Literal["ball"] = Field("ball", examples=["ball"])
    designation: Annotated[_Designation | None, Replaces(*_DISPLACED)] = Field(
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
        Annotated[float, Quantity("angle", at_least="0 deg", below="90 deg", varies=True)] | None,
        Replaces("diametral_clearance"),
    ] = Field(None, examples=["40 deg"])
    diametral_clearance: Annotated[
        Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m", varies=True)] | None,
        Replaces("contact_angle"),
    ] = Field(None, examples=["0.015 mm"])
    inner_conformity: _Conformity = Field(examples=[0.5232])
    outer_conformity: _Conformity = Field(examples=[0.5232])
    ring_material: MaterialField = Field(default_factory=lambda: Material.named(DEFAULT_MATERIAL))
    ball_material: MaterialField = Field(default_factory=lambda data: data["ring_material"])
    inner_shoulder_height: _ShoulderHeight | None = Field(None, examples=["4.5 mm"])
    outer_shoulder_height: _ShoulderHeight | None = Field(None, examples=["4.5 mm"])
    arrangement: Annotated[Arrangement | None, Replaces("rows")] = Field(None, examples=["DB"])
    spacing: (
        Annotated[float, Quantity("length", above="0 mm", at_most="10 m", varies=True)] | None
    ) = Field(None, examples=["24 mm"])
    rows: Annotated[tuple[RowOfElements, ...] | None, Replaces("arrangement", "spacing")] = Field(
        None,
        min_length=1,
        max_length=MOST_ROWS,
        examples=['[{ orientation = "+", position = "0 mm" }]'],
    )
    preload: PreloadField | None = Field(None, examples=["500 N"])

    @classmethod
    def named(cls, designation: str, **fields: Any) -> Self:
        """Return a bearing of the catalogue.

        Parameters
        ----------
        designation
            Such as ``"6305/C3"`` or ``"EX 70 25deg"``.
        fields
            Of the bearing, in the place of what the catalogue tells.

        Raises
        ------
        InputError
            If the designation is not known, or does not tell what is not given.
        """
        return cls(**{"designation": designation, **fields})

    @property
    def origins(self) -> Mapping[str, str]:
        """Where each field that a designation fills in comes from; empty without one.

        ``"given"`` by the user, ``"published"`` by a maker, ``"inferred"`` from the ratings,
        or ``"assumed"``: an ordinary conformity, the middle of the clearance class.
        """
        if self.designation is None:
            return {}
        from rolamento.catalogue import built_in_geometry

        own = self.model_fields_set
        told = built_in_geometry(self.designation, not own.issuperset(_BALL_FIELDS)).origins
        return {
            name: "given" if name in own else told[name]
            for name in _CATALOGUE_FIELDS
            if getattr(self, name) is not None
        }

    @property
    def published(self) -> CatalogueBearing | None:
        """What the catalogue holds of the designation; None without one."""
        if self.designation is None:
            return None
        from rolamento.catalogue import built_in_geometry

        return built_in_geometry(self.designation, False).bearing

    @property
    def clearance_class(self) -> str | None:
        """Class of ISO 5753-1 that the clearance is the middle of; None of any other clearance."""
        if self.origins.get("diametral_clearance") != "assumed" or self.designation is None:
            return None
        from rolamento.catalogue import built_in_geometry

        return built_in_geometry(self.designation, False).clearance_class

    @property
    def is_set(self) -> bool:
        """Whether the bearing is more than one plain row."""
        return self.arrangement is not None or self.rows is not None

    @property
    def places(self) -> tuple[RowPlace, ...]:
        """The rows of balls along +x, each as a bearing of one row; one if it is no set."""
        return _places(self)

    @model_validator(mode="wrap")
    @classmethod
    def _filled_in(
        cls, given: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo
    ) -> Self:
        """Fill in what a designation or the first row tells, without making it the user's own."""
        if not isinstance(given, Mapping):
            return handler(given)
        designation = _as_text(given.get("designation"))
        if isinstance(designation, str):
            found = _of_catalogue(designation, given, in_file=at_the_border(info.context))
        else:
            found = _of_first_row(given)
        bearing = handler({**given, **found})
        bearing.__pydantic_fields_set__.difference_update(found)
        return bearing

    @model_serializer(mode="wrap")
    def _without_what_is_filled_in(
        self, handler: SerializerFunctionWrapHandler, info: SerializationInfo
    ) -> dict[str, Any]:
        """Write to a file the user's own fields only, where others are filled in."""
        fields: dict[str, Any] = handler(self)
        if (self.designation or self.rows) is None or not at_the_border(info.context):
            return fields
        told = _CATALOGUE_FIELDS.keys() - self.model_fields_set
        return {name: value for name, value in fields.items() if name not in told}

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        self._check_that_balls_fit()
        self._check_angle_or_clearance()
        self._check_clearance()
        self._check_shoulders()
        self._check_set()
        return self

    def _check_that_balls_fit(self) -> None:
        """Neighbouring balls touch when D = d_m sin(π/Z)."""
        if self.pitch_diameter <= self.ball_diameter:
            raise InputError(
                said(
                    "must be greater than the ball diameter, {ball_diameter}",
                    ball_diameter=from_si(self.ball_diameter, "length"),
                ),
                field="pitch_diameter",
                value=from_si(self.pitch_diameter, "length"),
                example='pitch_diameter = "125.26 mm"',
            )
        if not balls_fit(self.ball_count, self.ball_diameter, self.pitch_diameter):
            ratio = self.ball_diameter / self.pitch_diameter
            room = math.floor(math.pi / math.asin(ratio))
            raise InputError(
                said(
                    "balls of {ball_diameter} do not fit on a pitch circle of "
                    "{pitch_diameter}: there is room for {room}",
                    ball_diameter=from_si(self.ball_diameter, "length"),
                    pitch_diameter=from_si(self.pitch_diameter, "length"),
                    room=room,
                ),
                field="ball_count",
                value=self.ball_count,
                example=f"ball_count = {room}" if room >= 3 else "",
            )

    def _check_angle_or_clearance(self) -> None:
        if self.contact_angle is None and self.diametral_clearance is None:
            raise InputError(
                said("is missing: give the contact angle or the diametral clearance"),
                field="contact_angle",
                example='contact_angle = "40 deg" or diametral_clearance = "0.015 mm"',
            )
        if self.contact_angle is not None and self.diametral_clearance is not None:
            raise InputError(
                said("cannot be combined with the contact angle: each follows from the other"),
                field="diametral_clearance",
                value=from_si(self.diametral_clearance, "length"),
                example='diametral_clearance = "0.015 mm" without contact_angle',
            )

    def _check_clearance(self) -> None:
        """Keep cos α = 1 − P_d/(2BD) above 0, and an interference elastic."""
        if self.diametral_clearance is None:
            return
        groove_distance = self.ball_diameter * (self.inner_conformity + self.outer_conformity - 1.0)
        if not clearance_fits(self.diametral_clearance, groove_distance):
            least, most = (_rounded_length(f * groove_distance) for f in (-0.25, 2.0))
            raise InputError(
                said(
                    "must be greater than {least} and less than {most} with these balls "
                    "and conformities",
                    least=least,
                    most=most,
                ),
                field="diametral_clearance",
                value=from_si(self.diametral_clearance, "length"),
                example='diametral_clearance = "0.015 mm"',
            )

    def _check_shoulders(self) -> None:
        for name in ("inner_shoulder_height", "outer_shoulder_height"):
            height = getattr(self, name)
            if height is not None and height >= self.ball_diameter / 2:
                raise InputError(
                    said(
                        "must be less than the ball radius, {ball_diameter}",
                        ball_diameter=_rounded_length(self.ball_diameter / 2),
                    ),
                    field=name,
                    value=from_si(height, "length"),
                    example=f'{name} = "{_rounded_length(0.2 * self.ball_diameter)}"',
                )

    def _check_set(self) -> None:
        if self.arrangement is not None and self.rows is not None:
            raise InputError(
                said("cannot be combined with rows listed one by one"),
                field="arrangement",
                value=self.arrangement,
                example='arrangement = "DB" without rows',
            )
        if (self.arrangement is None) != (self.spacing is None):
            missing, beside = (
                ("spacing", "arrangement") if self.spacing is None else ("arrangement", "spacing")
            )
            raise InputError(
                said("is missing; {beside} needs it", beside=beside),
                field=missing,
                example='arrangement = "DB" with spacing = "24 mm"',
            )
        signs = {place.sign for place in self.places}
        if self.preload is not None and len(signs) < 2:
            raise InputError(
                said("needs opposed rows: these all carry load in the same direction"),
                field="preload",
                example='arrangement = "DB"',
            )
        own = [index for index, place in enumerate(self.places) if place.offset is not None]
        clamped = self.preload is not None and self.preload.offset is None
        if own and clamped and self.preload is not None and self.preload.spring is None:
            raise InputError(
                said("cannot be combined with a preload given by its force: the row has its own"),
                field=f"rows.{own[0]}.offset",
                example='preload = { offset = "5 um" }',
            )
        if self.preload is not None:
            try:
                self.preload.pair_force(self.contact_angle)
            except InputError as error:
                raise error.with_details(field=f"preload.{error.field}") from None


def _of_catalogue(designation: str, given: Mapping[str, Any], *, in_file: bool) -> dict[str, Any]:
    """Return the fields that a designation tells and the user does not."""
    from rolamento.catalogue import built_in_geometry

    own = {name for name, value in given.items() if value is not None}
    missing = _CATALOGUE_FIELDS.keys() - own
    if own.intersection(_PLAY):
        missing -= set(_PLAY)
    geometry = built_in_geometry(designation, not own.issuperset(_BALL_FIELDS))
    if missing.issuperset(_PLAY) and not geometry.fields.keys() & set(_PLAY):
        raise InputError(geometry.lack_of_play, field="designation", value=designation)
    found: dict[str, Any] = {}
    for name in missing & geometry.fields.keys():
        value, dimension = geometry.fields[name], _CATALOGUE_FIELDS[name]
        found[name] = from_si(value, dimension) if in_file and dimension else value
    return found


def _of_first_row(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the geometry that the first row tells and the bearing does not."""
    rows = given.get("rows")
    first = rows[0] if isinstance(rows, list | tuple) and rows else None
    told = first if isinstance(first, Mapping) else getattr(first, "own", {})
    own = {name for name, value in given.items() if value is not None}
    play = set(_PLAY) if own.intersection(_PLAY) else set()
    missing = (name for name in _CATALOGUE_FIELDS if name not in own | play)
    return {name: told[name] for name in missing if told.get(name) is not None}


def balls_fit(count: int, ball_diameter: Any, pitch_diameter: Any) -> Any:
    """Whether neighbouring balls on the pitch circle do not overlap; numbers or arrays."""
    return ball_diameter / pitch_diameter <= math.sin(math.pi / count)


def clearance_fits(clearance: Any, groove_distance: Any) -> Any:
    """Whether a clearance can be taken up, or an interference stay elastic; numbers or arrays."""
    return (-groove_distance / 4 < clearance) & (clearance < 2 * groove_distance)


class RowPlace(NamedTuple):
    """One row of a bearing: its geometry, +1 or -1 for the way it faces, its place.

    offset: how far it alone is pressed in; None where the preload says.
    """

    bearing: Bearing
    sign: float
    position: float
    phase: float
    offset: float | None = None


@lru_cache(maxsize=1024)
def _places(bearing: Bearing) -> tuple[RowPlace, ...]:
    rows = _rows(bearing)
    if rows is None:
        return (RowPlace(bearing, 1.0, 0.0, 0.0),)
    plain: dict[str, Any] = dict.fromkeys(_SET_FIELDS)
    if bearing.designation is None:  # of the first row
        told = _CATALOGUE_FIELDS.keys() - bearing.model_fields_set
        plain.update({name: getattr(bearing, name) for name in told})
    places = []
    for index, row in enumerate(rows):
        try:
            alone = bearing.replace(**{**plain, **row.own})
        except InputError as error:
            raise error.with_details(field=f"rows.{index}.{error.field}") from None
        sign = 1.0 if row.orientation == "+" else -1.0
        places.append(RowPlace(alone, sign, row.position, row.phase, row.offset))
    return tuple(places)


def _rows(bearing: Bearing) -> tuple[RowOfElements, ...] | None:
    if bearing.arrangement is None:
        return bearing.rows
    orientations = ARRANGEMENTS[bearing.arrangement]
    spacing = bearing.spacing or 0.0
    first = -0.5 * spacing * (len(orientations) - 1)
    return tuple(
        BallRow(orientation=orientation, position=first + spacing * index)
        for index, orientation in enumerate(orientations)
    )


def _rounded_length(value: float) -> str:
    return from_si(float(f"{value:.4g}"), "length")
