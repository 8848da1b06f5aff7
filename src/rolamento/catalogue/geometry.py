"""From a designation to the inside of a bearing: each figure published, inferred or assumed."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from math import asin, cos, radians, sin, tan
from typing import Any, Final, Literal, TypeVar

from rolamento.catalogue.designation import Designation, folded
from rolamento.catalogue.inference import Candidate, inferred_geometry
from rolamento.catalogue.letters import ClearanceClass, Letters, Part, designation_data
from rolamento.catalogue.records import CatalogueBearing
from rolamento.catalogue.roller_inference import RollerCandidate, inferred_rollers, nominal_angle
from rolamento.catalogue.search import (
    Catalogue,
    Found,
    catalogue,
    catalogue_with,
    is_built_in,
    standard_width,
)
from rolamento.errors import InputError
from rolamento.geometry import apex_half_angle, usual_end_radius
from rolamento.io.data import toml_of
from rolamento.records import frozen
from rolamento.types import of_balls
from rolamento.units import MILLIMETRE, readable
from rolamento.words import Note, said

_C = TypeVar("_C", Candidate, RollerCandidate)
Origin = Literal["published", "inferred", "assumed", "designation"]

ASSUMED_CONFORMITY: Final = 0.52
"""Conformity of both races where nothing is published: what ISO 281 supposes of its ratings."""

_ROW_SPACING: Final = 0.42
"""Between the rows of a double row, over its width: NSK's and Schaeffler's lists have 0.36 to 0.46,
by where the contact lines meet the shaft."""
_FOUR_POINT_ANGLE: Final = radians(35.0)
"""Contact angle of four-point bearings whose maker gives none: NSK's and SKF's."""
_BALLS: Final = ("ball_count", "ball_diameter")
_ROLLERS: Final = ("roller_count", "roller_diameter", "effective_length")
_RIBS: Final = {  # inner, outer; those of one rib carry an axial load of the shaft toward +x
    "NU": ("none", "both"),
    "NJ": ("-", "both"),
    "NUP": ("both", "both"),
    "N": ("both", "none"),
    "NF": ("both", "+"),
    "NCF": ("both", "+"),
    "NJG": ("-", "both"),
    "NN": ("both", "none"),
    "NNU": ("none", "both"),
    "NA": ("none", "both"),
    "RNA": ("none", "both"),
}
"""Ends at which the rings of a type have ribs; a cage alone and a drawn cup have none."""
_WITHOUT_INNER: Final = ("RNA", "K", "HK", "BK")
_WRITTEN_TYPE: Final = r"NNU|NN(?=\s?\d)|NUP|NU|NJG|NJ|NCF|NF|N(?=\s?\d)|RNA|NA|HK|BK|K(?=\s?\d)"
_LEAST_ANGLE: Final = radians(1.0)
_HALF_MICROMETRES: Final = 2e6
"""In a metre."""
_ROUNDING: Final = 1e-9
GIVEN: Final = "given"
"""Source of the ratings that a user gives."""
_TAPERED: Final = "tapered bore"


@frozen(kw_only=True)
class InternalGeometry:
    """The inside of a bearing, with where each figure comes from.

    Attributes
    ----------
    bearing
        What the catalogue holds.
    designation
        What was asked for.
    fields
        Fields of a `rolamento.Bearing` in SI: balls, pitch diameter, conformities, the nominal
        contact angle or the diametral clearance where there is one, and what its kind has beside
        them: shim angle, arrangement, spacing of the rows.
    origins
        Of each field: ``"published"``, ``"inferred"`` from the ratings, ``"assumed"``, or
        ``"designation"``: its letters say so.
    candidates
        All insides that the ratings allow, the best first; empty if nothing was inferred. Of a
        roller bearing each is a `RollerCandidate`.
    records
        What has to be known beside the built-in catalogue to find the same again.
    sisters
        Of an angular-contact bearing whose balls are not published: those of the same boundary
        dimensions and about the same contact angle whose balls are.
    """

    bearing: CatalogueBearing
    designation: Designation
    fields: Mapping[str, Any]
    origins: Mapping[str, Origin]
    candidates: tuple[Candidate, ...] | tuple[RollerCandidate, ...] = ()
    records: tuple[CatalogueBearing, ...] = ()
    sisters: tuple[CatalogueBearing, ...] = ()

    @property
    def is_inferred(self) -> bool:
        """Whether the balls or rollers are inferred."""
        return "inferred" in (self.origins.get("ball_count"), self.origins.get("roller_count"))

    @property
    def has_elements(self) -> bool:
        """Whether it is known, or inferred, what rolls inside."""
        return "ball_count" in self.fields or "roller_count" in self.fields

    @property
    def bearing_type(self) -> str:
        """Type of a roller bearing as its designation names it, such as ``"NU"``; else empty."""
        return _type_of(self.bearing, self.designation)

    @property
    def from_given_ratings(self) -> bool:
        """Whether they are inferred from ratings that are the user's, not a list's."""
        return self.is_inferred and GIVEN in self.bearing.sources.values()

    @property
    def stands_in(self) -> bool:
        """Whether the catalogue has the bearing by another number than that of the designation."""
        number, listed = folded(self.designation.number), folded(self.bearing.designation)
        own = listed.removeprefix("hr").startswith(number)
        return bool(number) and not self.designation.insert and not own

    @property
    def idle(self) -> tuple[Part, ...]:
        """Parts of the designation that are understood and change no result."""
        idle = self.designation.letters.idle
        if self.bearing.type.class_table_of_tapered_bore is None:
            return idle
        return tuple(part for part in idle if part.meaning != _TAPERED)  # which has its clearance

    @property
    def notes(self) -> tuple[Note, ...]:
        """What of the letters the figures here do not have: stainless steel, a pair's clearance."""
        found, letters = [], self.designation.letters
        values = {"designation": self.designation.text}
        if letters.stainless is not None:
            low, high = designation_data()["stainless"]["share"]
            part = letters.stainless.text
            found.append(
                Note("stainless_rating", {**values, "part": part, "low": low, "high": high})
            )
        if letters.pair_clearance is not None:
            found.append(
                Note("pair_clearance_not_listed", {**values, "part": letters.pair_clearance.text})
            )
        return tuple(found)

    @property
    def width(self) -> float | None:
        """B in m, published or by ISO 15; None if neither has it."""
        bearing = self.bearing
        return bearing.width or standard_width(bearing.bore, bearing.outside_diameter)

    def spacing(self, arrangement: str) -> float | None:
        """Return the distance of neighbouring rows of equal bearings side by side, in m.

        Parameters
        ----------
        arrangement
            ``"DB"``, ``"DF"`` …

        Their width; of a pair of tapered bearings by the load centre a, which shows how far the
        middle of the rollers is from the cup's back face: x = a - ½(d_pw + D_we cos α) tan α. None
        if the width is not known.
        """
        width, centre = self.width, self.bearing.load_centre
        pitch, roller = (self.fields.get(name) for name in ("pitch_diameter", "roller_diameter"))
        if width is None or centre is None or arrangement not in ("DB", "DF"):
            return width
        if pitch is None or roller is None:
            return width
        angle = self.fields["contact_angle"]
        middle = centre - 0.5 * (pitch + roller * cos(angle)) * tan(angle)
        return float(2.0 * (middle if arrangement == "DB" else width - middle))

    @property
    def has_inner_ring(self) -> bool:
        """Whether the shaft itself is not the inner raceway."""
        return self.bearing_type not in _WITHOUT_INNER

    @property
    def lack_of_play(self) -> str:
        """What a user has to add if neither contact angle nor clearance is known, as a rule."""
        if not self.has_inner_ring:
            return said(
                "has no inner ring: its clearance follows from shaft and housing: give"
                " diametral_clearance"
            )
        if self.clearance_class is None:
            return said("does not define the contact angle: give contact_angle")
        return said(
            "has class {class_}, for which ISO 5753-1 has no range at a bore of {bore}: give"
            " diametral_clearance",
            class_=self.clearance_class,
            bore=readable(self.bearing.bore, "length"),
        )

    @property
    def is_on_a_taper(self) -> bool:
        """Whether its bore is tapered, and has clearance classes of its own."""
        own = self.bearing.type.class_table_of_tapered_bore is not None
        return own and _is_tapered(self.designation)

    @property
    def clearance_class(self) -> ClearanceClass | None:
        """The class of the designation, CN if a bearing that has one names none."""
        if self.bearing.type.class_table is None or not self.has_inner_ring:
            return None
        return _class_of(self.bearing, self.designation)


def geometry_of(
    designation: str,
    *,
    catalogue_of: Catalogue | None = None,
    rank: int = 1,
    with_balls: bool = True,
) -> InternalGeometry:
    """Return the inside of a bearing by its designation.

    Parameters
    ----------
    designation
        Such as ``"6305/C3"`` or ``"EX 70 25deg"``.
    catalogue_of
        Where to look; by default in `rolamento.catalogue.catalogue`.
    rank
        Which of the candidates to take, if the balls are inferred.
    with_balls
        Whether balls and pitch diameter are wanted at all; if not, they are left out.

    Raises
    ------
    InputError
        If the designation is not known, its balls are neither published nor to be inferred, or
        there is no such rank.

    >>> found = geometry_of("6310/C3").fields["ball_count"]
    >>> print(f"{found:d} balls")
    8 balls
    """
    return _geometry_in(catalogue_of or catalogue(), designation, rank, with_balls)


@lru_cache(maxsize=512)
def _geometry_in(
    known: Catalogue, designation: str, rank: int, with_balls: bool
) -> InternalGeometry:
    found = known.find(designation)
    bearing = found.bearing
    if bearing.has_rollers:
        return _roller_geometry(known, found, rank, with_balls)
    fields: dict[str, Any] = {}
    origins: dict[str, Origin] = {}
    candidates: tuple[Candidate, ...] = ()
    sisters = known.sisters(bearing, found.designation.letters.design)
    if with_balls:
        try:
            candidates = _add_inside(bearing, _BALLS, inferred_geometry, rank, fields, origins)
        except InputError as error:
            raise _without_balls(error, found, sisters) from None
    for name in ("inner_conformity", "outer_conformity"):
        if bearing.type.aligns and name == "outer_conformity":
            continue  # its race is a sphere
        own = getattr(bearing, name)
        fields[name] = own or bearing.type.conformity or ASSUMED_CONFORMITY
        origins[name] = "assumed" if own is None else "published"
    _add_play(bearing, found.designation, fields, origins)
    _add_kind(bearing, found.designation, fields, origins)
    _add_letters(bearing, found.designation, fields, origins)
    return InternalGeometry(
        bearing=bearing,
        designation=found.designation,
        fields=fields,
        origins=origins,
        candidates=candidates,
        records=() if known is catalogue_with(()) or is_built_in(bearing) else (bearing,),
        sisters=() if bearing.ball_count and bearing.ball_diameter else sisters,
    )


def _roller_geometry(
    known: Catalogue, found: Found, rank: int, with_rollers: bool
) -> InternalGeometry:
    """The inside of a roller bearing: what rolls, the ribs, the play."""
    bearing, designation = found.bearing, found.designation
    fields: dict[str, Any] = {"element": bearing.type.element}
    origins: dict[str, Origin] = {"element": "published"}
    candidates: tuple[RollerCandidate, ...] = ()
    if with_rollers:
        try:
            candidates = _add_rollers(bearing, rank, fields, origins)
        except InputError as error:
            raise error.with_details(value=designation.text) from None
        if bearing.clearance_factor is not None and bearing.width is not None:
            centres = bearing.width / bearing.clearance_factor  # s²/(R_o + R_i - D_we), of C_r
            fields["outer_raceway_radius"] = 0.5 * (centres + fields["roller_diameter"])
            origins["outer_raceway_radius"] = "inferred"
    type_ = _type_of(bearing, designation)
    if bearing.type.grooves is not None:
        fields["kind"], origins["kind"] = bearing.type.grooves, "published"
    if bearing.type.conical or bearing.type.inclined or bearing.type.washers:
        angle = nominal_angle(bearing)
        fields["contact_angle"] = angle
        told = bearing.contact_angle is not None
        origins["contact_angle"] = "published" if told else "inferred"
        if with_rollers and bearing.type.conical:
            size = (fields["roller_diameter"], fields["pitch_diameter"])
            fields["roller_half_angle"] = float(
                apex_half_angle(*size, angle, washers=bearing.type.washers)
            )
            origins["roller_half_angle"] = "inferred"
            end = (
                fields["roller_diameter"],
                fields["effective_length"],
                fields["roller_half_angle"],
            )
            fields["roller_end_radius"] = float(usual_end_radius(*end))
            origins["roller_end_radius"] = "assumed"
    if bearing.type.straight and not bearing.type.washers:
        fields["inner_ribs"], fields["outer_ribs"] = _RIBS.get(type_, ("none", "none"))
        origins["inner_ribs"] = origins["outer_ribs"] = "published"
    if not bearing.type.conical:
        named = _class_of(bearing, designation)
        table = _class_table(bearing, designation)
        if type_ not in _WITHOUT_INNER and table is not None:
            clearance = middle_clearance(bearing.bore, named, table)
            if clearance is not None:
                fields["diametral_clearance"] = clearance
                origins["diametral_clearance"] = "assumed"
    if type_ == "NUP":
        play = _axial_play(designation)
        if play is not None:
            fields["axial_play"], origins["axial_play"] = play, "assumed"
    arrangement = designation.letters.arrangement
    if bearing.type.is_double_row:  # rows that face alike, with the same ribs
        fields["arrangement"], origins["arrangement"] = "DT", "published"
        pitch = fields.get("pitch_diameter", bearing.mean_diameter)
        fields["spacing"], origins["spacing"] = _row_spacing(bearing, fields, pitch)
    geometry = InternalGeometry(
        bearing=bearing,
        designation=designation,
        fields=fields,
        origins=origins,
        candidates=candidates,
        records=() if known is catalogue_with(()) or is_built_in(bearing) else (bearing,),
    )
    if arrangement is None or not bearing.type.conical:
        return geometry
    fields["arrangement"], origins["arrangement"] = arrangement, "designation"
    spacing = geometry.spacing(arrangement)
    if spacing is not None:
        fields["spacing"], origins["spacing"] = spacing, "assumed"
    return geometry


def _type_of(bearing: CatalogueBearing, designation: Designation) -> str:
    """The type of a roller bearing by its designation, else by how its maker lists it."""
    if not bearing.type.straight:
        return ""
    listed = re.match(_WRITTEN_TYPE, bearing.designation)
    if designation.bearing_type or listed:
        return designation.bearing_type or str(listed and listed[0])
    inner, outer = bearing.inner_raceway_diameter, bearing.outer_raceway_diameter
    is_cage = inner == bearing.bore and outer == bearing.outside_diameter
    return bearing.type.usual_letters or ("K" if is_cage and bearing.type.as_a_cage else "")


def _class_of(bearing: CatalogueBearing, designation: Designation) -> ClearanceClass:
    """The class of the designation, the normal one of its bore if it names none."""
    if designation.clearance_class is not None:
        return designation.clearance_class
    return bearing.type.normal_class_of_tapered_bore if _is_tapered(designation) else "CN"


def _is_tapered(designation: Designation) -> bool:
    return any(meaning == _TAPERED for _, meaning in designation.meanings)


def _class_table(bearing: CatalogueBearing, designation: Designation) -> str | None:
    """Where the classes of its clearance stand, of a tapered bore where it has its own."""
    of_bore = bearing.type.class_table_of_tapered_bore if _is_tapered(designation) else None
    return of_bore or bearing.type.class_table


def _axial_play(designation: Designation) -> float | None:
    """The middle of the axial play of an NUP bearing between its ribs, in m; None if not listed."""
    listed = toml_of("axial_play")["NUP"].get(designation.series, {})
    pair = listed.get(designation.number[-2:])
    return sum(pair) / _HALF_MICROMETRES if pair else None


def _add_rollers(
    bearing: CatalogueBearing, rank: int, fields: dict[str, Any], origins: dict[str, Origin]
) -> tuple[RollerCandidate, ...]:
    """Add rollers and pitch diameter, published where both raceways are; as `_add_inside`."""
    candidates = _add_inside(bearing, _ROLLERS, inferred_rollers, rank, fields, origins)
    both = (bearing.inner_raceway_diameter, bearing.outer_raceway_diameter)
    if None not in both and bearing.type.straight:  # (E - F)/2 and (E + F)/2
        origins["roller_diameter"] = origins["pitch_diameter"] = "published"
    return candidates


def _without_balls(
    error: InputError, found: Found, sisters: Sequence[CatalogueBearing]
) -> InputError:
    """Say of what was asked for what it lacks, and what may stand in for it."""
    bearing, text = found.bearing, found.designation.text
    if error.field != "designation":
        return error
    if bearing.rated != (None, None):
        return error.with_details(value=text)
    if bearing.type.in_pairs and bearing.contact_angle is None:
        number = found.designation.number
        rule = said(
            "does not say its contact angle: write {number}C (15°), {number}AC (25°),"
            " {number}A (30°) or {number}B (40°)",
            number=number,
        )
        example = f'designation = "{number}C"'
    elif sisters:
        sister = sisters[0]
        rule = said(
            "has neither published balls nor load ratings here. {maker} {sister}, of the same bore"
            " and outside diameter and a contact angle of {angle:.0f °}, has {count} balls of"
            " {ball:.5 mm}: give it if it may stand in, or give `life.dynamic_rating` and"
            " `life.static_rating`, or ball_count, ball_diameter and pitch_diameter",
            maker=sister.maker,
            sister=sister.designation,
            angle=sister.contact_angle,
            count=sister.ball_count,
            ball=sister.ball_diameter,
        )
        example = f'designation = "{_with_letters(sister, found.designation.letters)}"'
    else:
        rule = said(
            "has no load rating to estimate the balls from: give `life.dynamic_rating` and"
            " `life.static_rating`, or ball_count, ball_diameter and pitch_diameter"
        )
        example = 'life.dynamic_rating = "14 kN"'
    return InputError(rule, field="designation", value=text, example=example)


def _with_letters(bearing: CatalogueBearing, letters: Letters) -> str:
    """A bearing's designation with what else was asked for: ceramic balls, arrangement, preload."""
    preload = letters.preload.text if letters.preload and letters.preload_level else ""
    in_set = f"{letters.arrangement or 'U'}{preload}" if letters.arrangement or preload else ""
    ceramic = "HC" if letters.ball_material else ""
    return " ".join(part for part in (bearing.designation, ceramic, in_set) if part)


def with_ratings(
    designation: str, dynamic_rating: float | None, static_rating: float | None
) -> tuple[CatalogueBearing, ...]:
    """Return the bearing of a designation with ratings that are given, to infer its balls from.

    Parameters
    ----------
    designation
        Such as ``"7014A5"``.
    dynamic_rating, static_rating
        C and C_0 of one row, in N; None is not given.

    Returns
    -------
    tuple
        For `rolamento.catalogue.listed`; empty where the catalogue has balls or ratings of its
        own, or nothing is given.

    Raises
    ------
    InputError
        If the designation is not known.
    """
    asked = {"dynamic_rating": dynamic_rating, "static_rating": static_rating}
    given = {name: value for name, value in asked.items() if value is not None}
    known = catalogue()
    if not given and known is catalogue_with(()):
        return ()
    bearing = known.find(designation).bearing
    own = (bearing.ball_count, *bearing.rated)
    before = GIVEN in bearing.sources.values()
    if not before and (not given or any(value is not None for value in own)):
        return ()
    sources = {**bearing.sources, **dict.fromkeys(given, GIVEN)}
    return (
        replace(
            bearing, dynamic_rating=dynamic_rating, static_rating=static_rating, sources=sources
        ),
    )


def ambiguity_axis(
    candidates: Sequence[Candidate] | Sequence[RollerCandidate], *, credible_only: bool = True
) -> dict[str, Any]:
    """Return the candidates as an axis of a study: any result becomes a band.

    Parameters
    ----------
    candidates
        Such as those of an `InternalGeometry`.
    credible_only
        Leave out those that miss a printed figure by more than three tolerances, the best
        excepted.

    Returns
    -------
    dict
        ``name`` and ``zipped`` with balls or rollers and pitch diameter in SI: the arguments of
        `rolamento.studies.Axis`.

    Raises
    ------
    InputError
        If there are no candidates.
    """
    kept = [one for one in candidates if one.reproduces or not credible_only]
    kept = kept or list(candidates[:1])
    if not kept:
        raise InputError(said("has no candidates"), field="candidates")
    of_rollers = isinstance(kept[0], RollerCandidate)
    names = (*(_ROLLERS if of_rollers else _BALLS), "pitch_diameter")
    return {
        "name": "internal geometry",
        "zipped": {f"bearing.{name}": [getattr(one, name) for one in kept] for name in names},
    }


def middle_clearance(bore: float, clearance_class: str, table: str = "") -> float | None:
    """Return the middle of a class's internal clearance in m; None without a range.

    Parameters
    ----------
    bore
        In m.
    clearance_class
        Of ISO 5753.
    table
        `BearingType.class_table`, or that of a tapered bore; of deep-groove bearings, if empty.
        The clearance of four-point bearings is axial, else radial.
    """
    data = toml_of("iso5753", "rolamento.clearance")
    data = data[table] if table else data
    limits = [MILLIMETRE * limit for limit in data["bore_mm"]]
    for step, (over, to) in enumerate(pairwise(limits)):
        if over * (1.0 + _ROUNDING) < bore <= to * (1.0 + _ROUNDING):
            pair = data["classes"].get(clearance_class, {step: None})[step]
            begin = MILLIMETRE * data.get("from_mm", {}).get(clearance_class, 0.0)
            if bore < begin * (1.0 - _ROUNDING):
                return None
            return sum(pair) / _HALF_MICROMETRES if pair else None
    return None


def _chosen(candidates: tuple[_C, ...], rank: int, bearing: CatalogueBearing) -> _C:
    if not candidates:
        raise InputError(
            said(
                "has ratings that no rollers of its section reproduce: give roller_count,"
                " roller_diameter, effective_length and pitch_diameter"
            )
            if bearing.has_rollers
            else said(
                "has ratings that no standard balls reproduce: give ball_count, "
                "ball_diameter and pitch_diameter"
            ),
            field="designation",
            value=bearing.designation,
        )
    if not 1 <= rank <= len(candidates):
        raise InputError(
            said("must be between 1 and {count}, the number of candidates", count=len(candidates)),
            field="rank",
            value=rank,
        )
    return candidates[rank - 1]


def _add_inside(
    bearing: CatalogueBearing,
    elements: tuple[str, ...],
    infer: Callable[[CatalogueBearing], tuple[_C, ...]],
    rank: int,
    fields: dict[str, Any],
    origins: dict[str, Origin],
) -> tuple[_C, ...]:
    """Add elements and pitch diameter; return what they were chosen from, if inferred.

    elements: what has to be known of them.
    """
    names = (*elements, "pitch_diameter")
    known = {name: getattr(bearing, name) for name in names}
    candidates: tuple[_C, ...] = ()
    otherwise: Origin = "assumed"
    if any(known[name] is None for name in elements):
        candidates, otherwise = infer(bearing), "inferred"
        chosen = _chosen(candidates, rank, bearing)
        fields.update({name: getattr(chosen, name) for name in names})
    else:
        fields.update(known)
        fields["pitch_diameter"] = known["pitch_diameter"] or bearing.mean_diameter
    for name in names:
        origins[name] = otherwise if known[name] is None else "published"
    return candidates


def _add_play(
    bearing: CatalogueBearing,
    designation: Designation,
    fields: dict[str, Any],
    origins: dict[str, Origin],
) -> None:
    """Add the nominal contact angle, or the middle of the clearance class."""
    angle = bearing.contact_angle
    if angle is None and bearing.type.in_pairs:
        angle = designation.contact_angle
    named = designation.clearance_class or "CN"
    if bearing.type.aligns:
        table = _class_table(bearing, designation) or ""
        clearance = middle_clearance(bearing.bore, named, table)
        if clearance is not None and angle is not None:
            fields["diametral_clearance"] = clearance
            origins["diametral_clearance"] = "assumed"
            return
    if bearing.type.has_arches and angle is None:
        fields["contact_angle"], origins["contact_angle"] = _FOUR_POINT_ANGLE, "assumed"
    elif angle is not None and angle >= _LEAST_ANGLE:
        fields["contact_angle"], origins["contact_angle"] = angle, "published"
    elif bearing.type == of_balls(angled=False):
        clearance = middle_clearance(bearing.bore, named)
        if clearance is not None:
            fields["diametral_clearance"] = clearance
            origins["diametral_clearance"] = "assumed"


def _add_letters(
    bearing: CatalogueBearing,
    designation: Designation,
    fields: dict[str, Any],
    origins: dict[str, Origin],
) -> None:
    """Add what the letters say: balls of another material, the arrangement."""
    letters = designation.letters
    if letters.ball_material is not None:
        fields["ball_material"], origins["ball_material"] = letters.ball_material, "designation"
    if bearing.type.grooves is not None or bearing.type.is_double_row:
        return
    if letters.arrangement is not None:
        fields["arrangement"], origins["arrangement"] = letters.arrangement, "designation"
        width = bearing.width or standard_width(bearing.bore, bearing.outside_diameter)
        if width is not None:  # of bearings side by side
            fields["spacing"], origins["spacing"] = width, "assumed"


def _add_kind(
    bearing: CatalogueBearing,
    designation: Designation,
    fields: dict[str, Any],
    origins: dict[str, Origin],
) -> None:
    """Add what a bearing other than a single row of one groove a ring has beside the rest."""
    kind = bearing.type
    if kind.grooves is not None:
        fields["kind"], origins["kind"] = kind.grooves, "published"
    pitch = fields.get("pitch_diameter", bearing.mean_diameter)
    if kind.is_double_row:
        fields["arrangement"], origins["arrangement"] = "DB", "published"
        fields["spacing"], origins["spacing"] = _row_spacing(bearing, fields, pitch)
    elif kind.aligns and "diametral_clearance" in fields:
        assert bearing.contact_angle is not None
        fields["spacing"] = pitch * tan(bearing.contact_angle)
        origins["spacing"] = "inferred"
    elif kind.washers and "contact_angle" not in fields:
        fields["contact_angle"], origins["contact_angle"] = radians(90.0), "published"
    elif kind.has_arches:
        shim = _shim_angle(bearing, designation.clearance_class or "CN", fields)
        if shim is not None:
            fields["shim_angle"], origins["shim_angle"] = shim, "assumed"


def _row_spacing(
    bearing: CatalogueBearing, fields: Mapping[str, Any], pitch: float
) -> tuple[float, Origin]:
    """Return the distance of the rows: by where their contact lines meet, else by the width."""
    angle, apart = fields.get("contact_angle"), bearing.load_centre_distance
    if angle is not None and apart is not None and apart > pitch * tan(angle):
        return apart - pitch * tan(angle), "inferred"
    return _ROW_SPACING * (bearing.width or bearing.section_height), "assumed"


def _shim_angle(
    bearing: CatalogueBearing, clearance_class: str, fields: Mapping[str, Any]
) -> float | None:
    """Return α_s so that the axial clearance is the middle of its class: sin α - G_a/(2BD).

    None without a range at this bore.
    """
    clearance = middle_clearance(bearing.bore, clearance_class, bearing.type.class_table or "")
    ball = fields.get("ball_diameter") or bearing.ball_diameter
    if ball is None:
        ball = _chosen(inferred_geometry(bearing), 1, bearing).ball_diameter
    if clearance is None:
        return None
    distance = ball * (fields["inner_conformity"] + fields["outer_conformity"] - 1.0)
    return asin(max(sin(fields["contact_angle"]) - 0.5 * clearance / distance, 0.0))
