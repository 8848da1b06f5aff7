"""What ball and roller bearings have in common: a designation that fills fields in, and rows."""

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext, suppress
from functools import lru_cache
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Final,
    NamedTuple,
    Self,
    cast,
    get_args,
)

from pydantic import (
    BeforeValidator,
    Field,
    ModelWrapValidatorHandler,
    PrivateAttr,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    ValidationInfo,
    model_serializer,
    model_validator,
)

from rolamento.case.arrangement import (
    ARRANGEMENTS,
    Arrangement,
    BallRow,
    Preload,
    RollerRow,
    RowOfElements,
    as_text,
    designation_of,
    element_by_designation,
    element_of_row,
)
from rolamento.case.parameters import Parameters, Rule
from rolamento.case.preload_classes import Level, listed_preload
from rolamento.case.quantity import AT_THE_BORDER, InSI, Line
from rolamento.case.record import Record, example_of
from rolamento.errors import InputError, phrase
from rolamento.types import BALL, ROLLER, BearingType, Grooves, RollerRings, type_of_element
from rolamento.units import readable
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.case.bearing import Bearing
    from rolamento.case.material import Material
    from rolamento.case.roller_bearing import RollerBearing
    from rolamento.catalogue import CatalogueBearing, InternalGeometry


__all__ = [
    "DISPLACED",
    "MOST_ROWS",
    "RULES_OF_THE_CIRCLE",
    "Designation",
    "RollingBearing",
    "RowPlace",
    "element_named",
    "rows_about_centre",
]

MOST_ROWS: Final = 32
SET_FIELDS: Final = ("arrangement", "spacing", "rows", "preload")
DISPLACED: Final = (
    "element",
    "ball_count",
    "ball_diameter",
    "roller_count",
    "roller_diameter",
    "roller_length",
    "effective_length",
    "roller_half_angle",
    "roller_end_radius",
    "roller_profile_radius",
    "inner_raceway_radius",
    "outer_raceway_radius",
    "inner_ribs",
    "outer_ribs",
    "pitch_diameter",
    *(f"{part}.{name}" for part in ("mounting", "film") for name in ("bore", "outside_diameter")),
    *(f"life.{name}" for name in ("dynamic_rating", "static_rating")),
)
"""Another bearing of the catalogue has other elements, another size and other ratings."""
_WRITTEN_ANGLE: Final = re.compile(r"\s*\d+deg$")
"""Pattern of designations that state their contact angle so, which lists of preloads do not."""
_ELSE_FROM: Final = {"spacing": "assumed", "preload": "designation"}
"""Where a field comes from that the catalogue gives only together with what is given."""


Designation = Annotated[
    Line,
    BeforeValidator(as_text, json_schema_input_type=Annotated[str, Field(max_length=200)] | int),
]


class RollingBearing(Record):
    """One or more rows of rolling elements between two rings; without fields of its own.

    Each kind of rolling element has its record: `Bearing` for balls, `RollerBearing` for rollers.
    """

    FILLED_IN: ClassVar[tuple[str, ...]] = ()
    """What a designation or the first row fills in."""
    INSIDE: ClassVar[tuple[str, ...]] = ()
    """Without which the catalogue is asked for the elements."""
    VARIES: ClassVar[tuple[str, ...]] = ()
    """The numbers of a row's geometry, in which cases solved together may differ."""
    STAYS: ClassVar[tuple[str, ...]] = ()
    """What else a row's geometry has."""
    ROLLS: ClassVar[str] = ""
    """``"ball"`` or ``"roller"``, with which the names of the elements' fields begin."""
    MATERIAL: ClassVar[str] = ""
    """The field of the rolling elements' material."""
    ROW: ClassVar[type[BallRow | RollerRow]]
    """A row of such a set."""
    PARAMETERS: ClassVar[type[Parameters]]
    """Its geometry in many cases."""
    RULES: ClassVar[tuple[Rule, ...]] = ()
    """What the geometry holds to, of one case and of many."""
    PLAY: ClassVar[tuple[str, ...]] = ()
    """What says where the elements touch."""
    RIVALS: ClassVar[tuple[str, ...]] = ()
    """Those of them of which one alone is given."""

    if TYPE_CHECKING:
        element: str
        designation: str | None
        pitch_diameter: float
        diametral_clearance: float | None
        contact_angle: float | None
        spacing: float | None
        arrangement: Arrangement | None
        rows: tuple[RowOfElements, ...] | None
        preload: Preload | None
        ring_material: Material

        @property
        def kind(self) -> Grooves | RollerRings | None:
            """Type of the grooves of balls."""

    _listed: "tuple[CatalogueBearing, ...]" = PrivateAttr(default=())
    """The records outside the built-in catalogue by which the designation was found."""

    @classmethod
    def named(cls, designation: str, **fields: Any) -> Self:
        """Return a bearing of the catalogue.

        Parameters
        ----------
        designation
            Such as ``"6305/C3"`` or ``"EX 70 25deg"``.
        fields
            Of the bearing, in place of those of the catalogue.

        Raises
        ------
        InputError
            If the designation is not known, or does not give what is not given.
        """
        return cls(**{"designation": designation, **fields})

    @property
    def bearing_type(self) -> BearingType:
        """What type of bearing it is by its own fields; of a set, that of its bearings."""
        raise NotImplementedError

    @property
    def listed_type(self) -> BearingType:
        """What type it is listed as: double rows and drawn cups have the rows of others."""
        own, published = self.bearing_type, self.published
        if published is None or published.type.element != own.element:
            return own
        return published.type if own.has_rollers or published.type.is_double_row else own

    @property
    def element_count(self) -> int:
        """Z, rolling elements in the row."""
        return cast("int", getattr(self, f"{self.ROLLS}_count"))

    @property
    def carries_one_way(self) -> bool:
        """Whether the row carries axial load toward one side only."""
        raise NotImplementedError

    @property
    def locates(self) -> bool:
        """Whether clamped rings can press the row in along x."""
        return True

    @property
    def element_diameter(self) -> float:
        """D of a ball, D_we of a roller, in the middle of a tapered one; m."""
        return cast("float", getattr(self, f"{self.ROLLS}_diameter"))

    @property
    def element_material(self) -> "Material":
        """Material of the rolling elements."""
        return cast("Material", getattr(self, self.MATERIAL))

    @property
    def elements_follow_rings(self) -> bool:
        """Whether the rolling elements are of the rings' material, for lack of one of their own.

        A material that a designation names ("HC": ceramic balls) is one of their own.
        """
        given = self.MATERIAL in self.model_fields_set
        return not given and self.element_material == self.ring_material

    @property
    def origins(self) -> Mapping[str, str]:
        """Where each field that a designation fills in comes from; empty without one.

        ``"given"`` by the user, ``"published"`` by a maker, ``"inferred"`` from the ratings,
        or ``"assumed"``: an ordinary conformity, the middle of the clearance class.
        """
        known = self.resolved
        if known is None:
            return {}
        own, resolved = self.model_fields_set, known.origins
        return {
            name: "given" if name in own else resolved.get(name) or _ELSE_FROM[name]
            for name in self.FILLED_IN
            if getattr(self, name) is not None
            and (name in own or name in resolved or name in _ELSE_FROM)
        }

    @property
    def resolved(self) -> "InternalGeometry | None":
        """What the designation says, and the catalogue of it; None without one.

        Without balls where the user gave them all.
        """
        if self.designation is None:
            return None
        from rolamento.catalogue import catalogue_with, geometry_of

        return geometry_of(
            self.designation,
            catalogue_of=catalogue_with(self._listed),
            with_balls=not self.model_fields_set.issuperset(self.INSIDE),
        )

    @property
    def published(self) -> "CatalogueBearing | None":
        """What the catalogue holds of the designation; None without one."""
        known = self.resolved
        return None if known is None else known.bearing

    @property
    def clearance_class(self) -> str | None:
        """Class of ISO 5753-1 that the clearance is the middle of; None of any other clearance."""
        known = self.resolved
        if known is None or self.origins.get("diametral_clearance") != "assumed":
            return None
        return known.clearance_class

    def replace(self, **changes: Any) -> Self:
        """Return a new bearing with the given fields changed; see `Record.replace`."""
        with self.looked_up():
            return super().replace(**changes)

    @property
    def from_given_ratings(self) -> bool:
        """Whether the balls are inferred from ratings of the case, not of a list."""
        known = self.resolved
        return known is not None and known.from_given_ratings

    def looked_up_again(self) -> Self:
        """Return the bearing of the same designation in the catalogue that now is asked."""
        return type(self)(**{name: getattr(self, name) for name in self.model_fields_set})

    def looked_up(self) -> AbstractContextManager[object]:
        """Return a block in which the designation is found where this bearing found it."""
        if not self._listed:
            return nullcontext()
        from rolamento.catalogue import listed

        return listed(self._listed)

    @property
    def element_rows(self) -> "tuple[RowPlace, ...]":
        """Those of the `places` that have elements of their own: one of a four-point bearing."""
        return self.places[:: 2 if self.bearing_type.has_arches else 1]

    @classmethod
    def __pydantic_init_subclass__(cls, **options: Any) -> None:
        """Register the kind of bearing by its elements."""
        field = cls.model_fields.get("element")
        for element in get_args(field.annotation) if field is not None else ():
            BY_ELEMENT[element] = cls

    @property
    def is_set(self) -> bool:
        """Whether the bearing is more than one plain row."""
        return self.arrangement is not None or self.rows is not None or self._set_by_kind

    @property
    def is_one_bearing(self) -> bool:
        """Whether all its rows lie between the same two rings, which fits change alike."""
        return self.arrangement is None and self.rows is None

    @property
    def _set_by_kind(self) -> bool:
        """Whether its rows follow from its kind."""
        kind = self.bearing_type
        return self.kind is not None and (kind.rows > 1 or kind.has_arches)

    @property
    def row_types(self) -> tuple[BearingType, ...]:
        """The type of each row: the bearing's own where its rings are not plain."""
        places = self.places
        if self.kind is not None:
            return (self.bearing_type,) * len(places)
        return tuple(place.bearing.bearing_type for place in places)

    @property
    def rows_of_one_bearing(self) -> int:
        """Rows that makers rate together: of a double-row, four-point or self-aligning bearing.

        1 for rows that are bearings of their own.
        """
        return len(self.places) if self.listed_type.rated_together else 1

    @property
    def places(self) -> "tuple[RowPlace, ...]":
        """The rows of elements along +x, each as a bearing of one row; one if it is no set."""
        return _places_of(self, frozenset(self.model_fields_set))

    def _rows_by_kind(self) -> "tuple[RowPlace, ...]":
        """The rows that follow from its kind, where any do."""
        raise NotImplementedError

    def own_fields(self, index: int) -> frozenset[str]:
        """Return the fields of its geometry that a row does not take from the set."""
        if self.rows is None:
            return frozenset()
        row = self.rows[index]
        if _takes_after(row, self):
            return frozenset(row.own)
        record = BY_ELEMENT[row.element]
        return frozenset({*record.VARIES, record.MATERIAL})

    def is_of_rows(self, field: str) -> bool:
        """Whether every row has a field of its own, so that the set's says nothing."""
        rows = range(len(self.rows or ()))
        return bool(rows) and all(field in self.own_fields(index) for index in rows)

    @model_validator(mode="wrap")
    @classmethod
    def _filled_in(
        cls, given: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo
    ) -> Self:
        """Fill in what a designation or the first row gives, without making it the user's own."""
        if not isinstance(given, Mapping):
            return handler(given)
        designation, rows = designation_of(given), _listed_rows(given)
        found: dict[str, Any] = {}
        records: tuple[CatalogueBearing, ...] = ()
        if rows:
            given = {**given, "rows": _with_elements(rows, given)}
        if designation is not None:
            geometry = cls._geometry(designation, given)
            given = {**given, **_preload_of_this(geometry, given)}
            found = cls._of_catalogue(geometry, given)
            records = geometry.records
        elif rows:
            found = cls._of_first_row(given)
        if found:
            cls._adjust(given, found)
        bearing = handler({**given, **found})
        bearing.__pydantic_fields_set__.difference_update(found)
        cast("dict[str, Any]", bearing.__pydantic_private__)["_listed"] = records
        return bearing

    @classmethod
    def _adjust(cls, given: Mapping[str, Any], found: dict[str, Any]) -> None:
        """Take away from what is filled in, by what both say together."""

    @classmethod
    def _geometry(cls, designation: str, given: Mapping[str, Any]) -> "InternalGeometry":
        from rolamento.catalogue import geometry_of

        inside = _own_fields(given).issuperset(cls.INSIDE)
        return geometry_of(designation, with_balls=not inside)

    @classmethod
    def _of_catalogue(
        cls, geometry: "InternalGeometry", given: Mapping[str, Any]
    ) -> dict[str, Any]:
        """Return the fields that a designation gives and the user does not."""
        own = _own_fields(given)
        missing = set(cls.FILLED_IN) - own
        if own.intersection(cls.RIVALS):
            missing -= set(cls.RIVALS)
        if "rows" in own:
            missing -= {"arrangement", "spacing", "preload"}
        if "contact_angle" in own and geometry.bearing.type.aligns:
            missing -= {"spacing"}
        play = {"diametral_clearance"} if geometry.bearing.type.inclined else set(cls.PLAY)
        if missing.issuperset(play) and not geometry.fields.keys() & play:
            raise InputError(
                geometry.lack_of_play, field="designation", value=geometry.designation.text
            )
        found: dict[str, Any] = {}
        told = dict(geometry.fields)
        arrangement = given.get("arrangement") or told.get("arrangement")
        if isinstance(arrangement, str):
            told = {"spacing": geometry.spacing(arrangement), **told}
            if len(set(ARRANGEMENTS.get(cast("Arrangement", arrangement), ()))) > 1:
                told["preload"] = _listed_preload(geometry, given)
        for name in missing & told.keys():
            value = told[name]
            if value is not None:
                found[name] = InSI(value) if isinstance(value, float) else value
        return found

    @classmethod
    def _of_first_row(cls, given: Mapping[str, Any]) -> dict[str, Any]:
        """Return the geometry that the first row of this kind gives and the bearing does not."""
        rows = (row for row in given["rows"] if BY_ELEMENT.get(element_of_row(row)) is cls)
        row = next(rows, None)
        told = row if isinstance(row, Mapping) else getattr(row, "own", {})
        own = _own_fields(given)
        designation = designation_of(told)
        if designation is not None:
            filled = {**given, **{name: v for name, v in told.items() if name in cls.FILLED_IN}}
            listed = cls._of_catalogue(cls._geometry(designation, filled), filled)
            told = {**listed, **told}
        play = set(cls.RIVALS) if own.intersection(cls.RIVALS) else set()
        missing = (name for name in cls.FILLED_IN if name not in own | play)
        return {name: told[name] for name in missing if told.get(name) is not None}

    @model_serializer(mode="wrap")
    def _without_what_is_filled_in(
        self, handler: SerializerFunctionWrapHandler, info: SerializationInfo
    ) -> dict[str, Any]:
        """Write to a file the user's own fields only, where others are filled in or follow."""
        fields: dict[str, Any] = handler(self)
        for name in self._never_written:
            fields.pop(name, None)
        if info.context != AT_THE_BORDER:
            return fields
        alone = (self.designation or self.rows) is None
        unsaid = {*((self.MATERIAL,) if alone else self.FILLED_IN)} - self.model_fields_set
        return {name: value for name, value in fields.items() if name not in unsaid}

    @property
    def _never_written(self) -> tuple[str, ...]:
        """Fields that follow from the others."""
        return ()

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        """Keep fields, geometry and rows to what such a bearing has."""
        for name in ("arrangement", "rows", "preload") if self.kind is not None else ():
            if getattr(self, name) is not None:
                raise InputError(
                    said('does not go with kind = "{kind}"', kind=self.kind),
                    field=name,
                    example=said("leave it out, or leave out kind"),
                )
        self._check_fields()
        for rule in self.RULES:
            if not rule.holds(self):
                raise rule.refusal(self)
        self._check_set()
        return self

    def _check_fields(self) -> None:
        """Keep the fields to those that such a bearing has."""

    def _check_set(self) -> None:
        """Keep arrangement, rows and preload to what goes together."""
        if self.arrangement is not None and self.rows is not None:
            raise InputError(
                said("cannot be combined with rows listed one by one"),
                field="arrangement",
                value=self.arrangement,
                example='arrangement = "DB"',
            )
        if self._set_by_kind:
            return
        if (self.arrangement is None) != (self.spacing is None):
            missing, beside = (
                ("spacing", "arrangement") if self.spacing is None else ("arrangement", "spacing")
            )
            raise InputError(
                phrase(marked("is missing; {beside} needs it"), beside=beside),
                field=missing,
                example='arrangement = "DB", spacing = "24 mm"',
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
        if self.preload is not None and self.preload.level and not self.preload.designation:
            raise InputError(
                said("is missing: a level of preload is that of a bearing in a maker's list"),
                field="preload.designation",
                example='preload = { level = "light", designation = "S 6012 C" }',
            )
        if self.preload is not None:
            try:
                self.preload.pair_force(self.contact_angle)
            except InputError as error:
                raise error.with_details(field=f"preload.{error.field}") from None


BY_ELEMENT: Final[dict[str, type[RollingBearing]]] = {}
"""The record of a bearing by what rolls in it."""


_TOO_LARGE: Final = {
    BALL: marked("must be greater than the ball diameter, {ball_diameter}"),
    ROLLER: marked("must be greater than the roller diameter, {roller_diameter}"),
}
_TOO_MANY: Final = {
    BALL: marked(
        "balls of {ball_diameter} do not fit on a pitch circle of "
        "{pitch_diameter}: there is room for {room}"
    ),
    ROLLER: marked(
        "rollers of {roller_diameter} do not fit on a pitch circle of "
        "{pitch_diameter}: there is room for {room}"
    ),
}


def _too_small_a_circle(bearing: RollingBearing) -> InputError:
    diameter = {f"{bearing.ROLLS}_diameter": readable(bearing.element_diameter, "length")}
    return InputError(
        said(_TOO_LARGE[bearing.ROLLS], **diameter),
        field="pitch_diameter",
        value=readable(bearing.pitch_diameter, "length"),
        example=example_of(type(bearing), ("pitch_diameter",)),
    )


def _elements_fit(bearing: Any) -> Any:
    """Whether neighbours on the pitch circle do not overlap: D ≤ d_m sin(π/Z)."""
    room = math.sin(math.pi / bearing.element_count)
    return bearing.element_diameter / bearing.pitch_diameter <= room


def _too_many(bearing: RollingBearing) -> InputError:
    count, diameter = f"{bearing.ROLLS}_count", bearing.element_diameter
    room = math.floor(math.pi / math.asin(diameter / bearing.pitch_diameter))
    sizes = {
        f"{bearing.ROLLS}_diameter": readable(diameter, "length"),
        "pitch_diameter": readable(bearing.pitch_diameter, "length"),
    }
    return InputError(
        said(_TOO_MANY[bearing.ROLLS], **sizes, room=room),
        field=count,
        value=bearing.element_count,
        example=f"{count} = {room}" if room >= 3 else "",
    )


RULES_OF_THE_CIRCLE: Final = (
    Rule(lambda b: b.pitch_diameter > b.element_diameter, _too_small_a_circle),
    Rule(_elements_fit, _too_many),
)
"""Elements have room on their pitch circle."""


def element_named(given: Mapping[str, Any]) -> str | None:
    """Return what rolls in a bearing of a table without `element`: by designation, rows or fields.

    Balls, if any row is of balls: a set of both has their record.
    """
    by_designation = element_by_designation(given)
    elements = [element_of_row(row, by_designation) for row in _listed_rows(given)]
    if elements:
        return BALL if BALL in elements else elements[0]
    if by_designation is not None:
        return by_designation
    if any(name.startswith("roller_") for name in given):
        raise InputError(
            said("is missing; a bearing of rollers needs it"),
            field="bearing.element",
            example='element = "cylindrical"',
        )
    return None


def _listed_rows(given: Mapping[str, Any]) -> Sequence[Any]:
    """The rows of a table that nobody has checked; none of what is no list."""
    rows = given.get("rows")
    return rows if isinstance(rows, list | tuple) else ()


def _with_elements(rows: Sequence[Any], given: Mapping[str, Any]) -> tuple[Any, ...]:
    """Rows of a table that say what rolls in them: what rolls in the bearing, where they do not."""
    element = given.get("element") or element_by_designation(given)
    return tuple(
        {**row, "element": element_of_row(row, element)} if isinstance(row, Mapping) else row
        for row in rows
    )


def _own_fields(given: Mapping[str, Any]) -> set[str]:
    return {name for name, value in given.items() if value is not None}


def _listed_preload(
    geometry: "InternalGeometry", given: Mapping[str, Any]
) -> dict[str, Any] | None:
    """Return the preload that the letters name, if a maker lists it for this bearing."""
    level = geometry.designation.letters.preload_level
    if level is None or given.get("contact_angle") is not None:
        return None
    name = _listed_for_preload(geometry, level)
    return None if name is None else {"level": level, "designation": name}


def _listed_for_preload(geometry: "InternalGeometry", level: str) -> str | None:
    """Return by which name a maker lists the preload of this bearing; None if none does."""
    angle = geometry.fields.get("contact_angle")
    listed = geometry.bearing.designation
    for name in (listed, _WRITTEN_ANGLE.sub("", listed)):
        with suppress(InputError):
            listed_preload(name, cast("Level", level), angle)
            return name
    return None


def _preload_of_this(geometry: "InternalGeometry", given: Mapping[str, Any]) -> dict[str, Any]:
    """Return a preload that gives a level alone as that of this bearing.

    Where no list has it, the message names the bearing that was looked for.
    """
    preload = given.get("preload")
    if isinstance(preload, Preload):
        preload = {name: getattr(preload, name) for name in preload.model_fields_set}
    if not isinstance(preload, Mapping) or "level" not in preload or preload.get("designation"):
        return {}
    name = _listed_for_preload(geometry, str(preload["level"]))
    named = _WRITTEN_ANGLE.sub("", geometry.bearing.designation)
    return {"preload": {**preload, "designation": name or named}}


class RowPlace(NamedTuple):
    """One row of a bearing: its geometry, +1 or -1 for the way it faces, its place.

    offset: how far it alone is pressed in; None where the preload says.
    """

    bearing: "Bearing | RollerBearing"
    sign: float
    position: float
    phase: float
    offset: float | None = None


def rows_about_centre(row: Any, angle: float) -> tuple[RowPlace, ...]:
    """Two rows that look at the bearing's centre, the elements of one between those of the other.

    row: each of them as a bearing.
    """
    place = 0.5 * row.pitch_diameter * math.tan(angle)
    half_pitch = math.pi / row.element_count
    return RowPlace(row, -1.0, -place, 0.0), RowPlace(row, 1.0, place, half_pitch)


@lru_cache(maxsize=1024)
def _places_of(bearing: RollingBearing, given: frozenset[str]) -> tuple[RowPlace, ...]:
    """The rows of a set that share the shaft, or the one of a bearing.

    given: the user's own fields, which bearings that are equal may differ in.
    """
    if bearing._set_by_kind:
        return bearing._rows_by_kind()
    rows = _rows(bearing)
    if rows is None:
        return (_placed(bearing, 1.0, 0.0, 0.0),)
    plain: dict[str, Any] = dict.fromkeys(SET_FIELDS)
    resolved = bearing.resolved
    if resolved is not None and "arrangement" in resolved.fields and bearing.rows is None:
        # a row alone is no such bearing, and the designation would fill the arrangement in again
        one = bearing.model_copy(update=plain)
        signs = ((row, 1.0 if row.orientation == "+" else -1.0) for row in rows)
        return tuple(_placed(one, sign, row.position, row.phase) for row, sign in signs)
    if resolved is None or "arrangement" in resolved.fields:
        names = set(bearing.FILLED_IN) - bearing.model_fields_set - plain.keys()
        if bearing.elements_follow_rings:
            names.discard(bearing.MATERIAL)
        values = {name: getattr(bearing, name) for name in names}
        plain.update({"designation": None, **values})  # of the first row
    places = []
    for index, row in enumerate(rows):
        try:
            alone = _alone(bearing, row, plain)
        except InputError as error:
            raise error.with_details(field=f"rows.{index}.{error.field}") from None
        sign = 1.0 if row.orientation == "+" else -1.0
        places.append(_placed(alone, sign, row.position, row.phase, row.offset))
    return tuple(places)


def _alone(
    bearing: RollingBearing, row: BallRow | RollerRow, plain: Mapping[str, Any]
) -> RollingBearing:
    """A row of a set as a bearing: the set's, but for what the row has of its own."""
    if _takes_after(row, bearing):
        return bearing.replace(**{**plain, **row.own, "element": row.element})
    shared = {"ring_material"} & bearing.model_fields_set
    materials = {name: getattr(bearing, name) for name in shared}
    given = {name: value for name, value in row.own.items() if value is not None}
    return BY_ELEMENT[row.element](**{**materials, **given, "element": row.element})


def _takes_after(row: RowOfElements, bearing: RollingBearing) -> bool:
    """Whether what a row has not of its own is the set's."""
    alike = type_of_element(row.element).conical == type_of_element(bearing.element).conical
    same_record = BY_ELEMENT[row.element] is type(bearing)
    return same_record and alike and row.designation is None


def _placed(bearing: RollingBearing, *place: Any) -> RowPlace:
    return RowPlace(cast("Bearing | RollerBearing", bearing), *place)


def _rows(bearing: RollingBearing) -> tuple[RowOfElements, ...] | None:
    if bearing.arrangement is None:
        return bearing.rows
    orientations = ARRANGEMENTS[bearing.arrangement]
    spacing = bearing.spacing or 0.0
    first = -0.5 * spacing * (len(orientations) - 1)
    return tuple(
        bearing.ROW(
            element=bearing.element, orientation=orientation, position=first + spacing * index
        )
        for index, orientation in enumerate(orientations)
    )
