"""The head of the pages of a case: title, what was given, how the solution ended."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import nan
from typing import TYPE_CHECKING, Final

from rolamento.case import Case
from rolamento.case.arrangement import Preload
from rolamento.case.bearing import Bearing, RowPlace
from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.case.profile import Profile
from rolamento.case.roller_bearing import RollerBearing, raceway_radii
from rolamento.case.rolling_bearing import RollingBearing
from rolamento.document import Beside, Document, Entry, Figure, KeyValues, Section, Title
from rolamento.geometry import Race
from rolamento.pages.notes import cautions_section, notes_section
from rolamento.solved.notes import nothing_given
from rolamento.units import Dimension, readable
from rolamento.words import Note, manner, marked, said, said_in
from rolamento.words.headlines import parted
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Picture

    from rolamento.solved import Solved

__all__ = [
    "BOTH", "case_page", "facing", "head", "model_text", "no_load_text", "picture", "quantity",
    "race_name", "reason", "title_of",
]  # fmt: skip

BOTH: Final = "±"
_PLUS, _MINUS = "+", "−"


def case_page(
    case: Case,
    first: Section,
    sections: Iterable[Section | Beside],
    kind: str,
    main: str = "",
    *,
    notes: Iterable[Note] = (),
    cautions: Iterable[Note] = (),
    remarks: Iterable[Note] = (),
) -> Document:
    """Return the page of a case: its head, what qualifies it, its sections, its notes.

    Parameters
    ----------
    case
        Whose title it bears.
    first
        Its head, such as of `head`.
    sections, kind, main
        As of a `Document`.
    notes
        Of these those that qualify a headline stand below the head, the others at the end.
    cautions, remarks
        As notes, of which only the former or only the latter are shown.
    """
    found = tuple(notes)
    whole = (
        first,
        *cautions_section((*found, *cautions)),
        *sections,
        *notes_section((*parted(found)[1], *remarks)),
    )
    return Document(title_of(case), whole, kind=kind, main=main)


def picture(
    caption: str, draw: Callable[[], Picture | Axes], name: str, key: str = "figure"
) -> Section:
    """Return a section of a picture alone. name: of the picture; key: of the section."""
    return Section("", (Figure(caption, draw, name),), key)


def head(solved: Solved) -> Section:
    """Return the title, what was given, and how the solution ended."""
    case = solved.case
    delivered = _bearing(solved.delivered_case.bearing)
    mounted = [] if solved.before_mounting is None else _in_operation(solved)
    bearing = "\n".join((delivered, *mounted))
    entries = (
        Entry(said("bearing"), bearing),
        Entry(said("duty"), _duty(case.duty)),
        Entry(said("model"), model_text(case)),
        *_status(solved),
    )
    given = tuple(entry for entry in entries if entry.content)  # at rest no model matters
    return Section("", (Title(title_of(case)), KeyValues(given)), "given")


def title_of(case: Case) -> str:
    """Return the title of a case, or what one without is called: by what rolls in it."""
    if case.title:
        return case.title
    names = {one.untitled for one in case.bearing.row_types}
    return said(names.pop()) if len(names) == 1 else said("Set of bearings of several kinds")


def race_name(race: Race | str) -> str:
    """Return what a race is called in a line of its own."""
    return said("inner race") if race == "inner" else said("outer race")


def quantity(value: float, dimension: Dimension) -> str:
    """Write a value of a case with its unit, as in a case file; a computed one shorter."""
    return manner().localised(readable(value, dimension))


# --- bearing -----------------------------------------------------------------------------------


def _in_operation(solved: Solved) -> list[str]:
    """Say what mounting and heat make of the play of a bearing."""
    rows = [place.bearing for place in solved.case.bearing.places]
    plays = dict.fromkeys(
        said("contact angle {angle:.4 °}", angle=row.contact_angle)
        if row.contact_angle is not None
        else said("diametral clearance {clearance:.4 µm}", clearance=row.diametral_clearance or 0.0)
        for row in rows
        if not row.bearing_type.conical
    )
    if not plays:
        return []
    play = "; ".join(plays)
    if solved.delivered_case.temperature is None:
        return [said("mounted: {play}", play=play)]
    return [said("mounted and warm: {play}", play=play)]


def _bearing(bearing: Bearing | RollerBearing) -> str:
    if isinstance(bearing, RollerBearing):
        lines = [_rollers(bearing), _between_rings(bearing), *_profiles(bearing)]
    else:
        lines = _balls(bearing)
    return "\n".join((*lines, _materials(bearing), *_arrangement_lines(bearing)))


def _balls(bearing: Bearing) -> list[str]:
    """Number and size of the balls; their play, as it was given, and their grooves."""
    inner, ball = bearing.inner_conformity, quantity(bearing.ball_diameter, "length")
    if bearing.contact_angle is not None:
        play = said("contact angle {angle}", angle=quantity(bearing.contact_angle, "angle"))
    else:
        clearance = quantity(bearing.diametral_clearance or 0.0, "length")
        play = said("diametral clearance {clearance}", clearance=clearance)
    if bearing.bearing_type.aligns:
        radius = quantity(bearing.outer_conformity * bearing.ball_diameter, "length")
        grooves = said(
            "{play}, conformity {inner:.5} inner, outer race a sphere of radius {radius}",
            play=play,
            inner=inner,
            radius=radius,
        )
    else:
        grooves = said(
            "{play}, conformity {inner:.5} inner, {outer:.5} outer",
            play=play,
            inner=inner,
            outer=bearing.outer_conformity,
        )
    balls = said(
        "{count} balls of {ball}, pitch diameter {pitch}",
        count=bearing.ball_count,
        ball=ball,
        pitch=quantity(bearing.pitch_diameter, "length"),
    )
    return [balls, grooves]


def _rollers(bearing: RollerBearing) -> str:
    """Number and size of the rollers, and their pitch circle."""
    values = {
        "count": bearing.roller_count,
        "diameter": quantity(_short(bearing.roller_diameter), "length"),
        "length": quantity(_short(bearing.effective_length), "length"),
        "pitch": quantity(_short(bearing.pitch_diameter), "length"),
    }
    return said(bearing.bearing_type.described, **values)


def _between_rings(bearing: RollerBearing) -> str:
    """The angles of tapered rollers, or the clearance and the ribs of others."""
    half = bearing.roller_half_angle or 0.0
    if bearing.bearing_type.washers:
        angle = said("contact angle {angle:.5 °}", angle=bearing.row_angle)
        cones = said(
            "half angle of the rollers {half:.4 °}: the washers press at {inner:.5 °} and"
            " {outer:.5 °}",
            half=half,
            inner=bearing.inner_contact_angle,
            outer=bearing.outer_contact_angle,
        )
        return f"{angle}, {cones}" if bearing.bearing_type.conical else angle
    if bearing.bearing_type.conical:
        return said(
            "contact angle {angle:.5 °} at the outer race, half angle of the rollers {half:.4 °}",
            angle=bearing.row_angle,
            half=half,
        )
    play = quantity(_short(bearing.diametral_clearance or 0.0), "length")
    if bearing.bearing_type.barrels:
        return _arcs(bearing, play)
    ribs = {
        "none": said_in("ribs", "none"),
        "+": said_in("ribs", "toward +x"),
        "-": said_in("ribs", "toward −x"),
        "both": said_in("ribs", "both sides"),
    }
    return said(
        "diametral clearance {clearance}; ribs: inner ring {inner}, outer ring {outer}",
        clearance=play,
        inner=ribs[bearing.inner_ribs],
        outer=ribs[bearing.outer_ribs],
    )


def _arcs(bearing: RollerBearing, play: str) -> str:
    """The arcs of barrel-shaped rollers and of their races."""
    profile, inner, outer = (
        quantity(_short(float(radius)), "length") for radius in raceway_radii(bearing)
    )
    arcs = {"profile": profile, "inner": inner, "outer": outer, "play": play}
    if not bearing.bearing_type.aligns:
        return said(
            "diametral clearance {play}; profile radii: rollers {profile}, inner raceway {inner},"
            " outer raceway {outer}",
            **arcs,
        )
    return said(
        "contact angle {angle:.5 °}, diametral clearance {play}; profile radii: rollers {profile},"
        " inner raceway {inner}; outer raceway a sphere of radius {outer}",
        angle=bearing.row_angle,
        **arcs,
    )


def _profiles(bearing: RollerBearing) -> list[str]:
    """The profile of the rollers, and those of the races that have one."""
    if bearing.bearing_type.barrels:
        return []
    races = {"inner": bearing.inner_profile, "outer": bearing.outer_profile}
    own = {name: profile for name, profile in races.items() if profile.kind != "none"}
    lines = [said("rollers {profile}", profile=_profile(bearing.roller_profile))]
    if "inner" in own:
        lines.append(said("inner race {profile}", profile=_profile(own["inner"])))
    if "outer" in own:
        lines.append(said("outer race {profile}", profile=_profile(own["outer"])))
    return [", ".join(lines)]


def _profile(profile: Profile) -> str:
    """Say what a profile is, as it follows on what has it."""
    if profile.kind == "iso" and profile.factor is not None:
        return said(
            "with the logarithmic profile of ISO/TS 16281, factor {factor:.3}",
            factor=profile.factor,
        )
    if profile.kind in ("crowned", "tangential"):
        radius = quantity(profile.radius or nan, "length")
        if profile.kind == "crowned":
            return said("crowned, radius {radius}", radius=radius)
        return said(
            "straight over {flat}, with ends of radius {radius}",
            flat=quantity(profile.flat_length or 0.0, "length"),
            radius=radius,
        )
    if profile.kind == "logarithmic" and profile.amplitude is not None:
        return said(
            "with a logarithmic profile, amplitude {amplitude}",
            amplitude=quantity(profile.amplitude, "length"),
        )
    return {
        "none": said("straight"),
        "iso": said("with the logarithmic profile of ISO/TS 16281"),
        "logarithmic": said("with a logarithmic profile"),
        "table": said("with a profile as measured"),
    }[profile.kind]


def _materials(bearing: RollingBearing) -> str:
    rings, elements = bearing.ring_material, bearing.element_material
    rollers = bearing.element != "ball"
    if rings == elements:
        if rollers:
            return said("rings and rollers of {rings}", rings=rings.name)
        return said("rings and balls of {rings}", rings=rings.name)
    if rollers:
        return said(
            "rings of {rings}, rollers of {rollers}", rings=rings.name, rollers=elements.name
        )
    return said("rings of {rings}, balls of {balls}", rings=rings.name, balls=elements.name)


def facing(bearing: RollingBearing, place: RowPlace) -> str:
    """Return toward which side a row carries axial load: with clearance and no preload, both."""
    if place.bearing.contact_angle is None and bearing.preload is None:
        return BOTH
    return _PLUS if place.sign > 0.0 else _MINUS


def _arrangement_lines(bearing: RollingBearing) -> list[str]:
    """Say how the rows of a set are arranged and preloaded; nothing of a plain bearing."""
    if bearing.bearing_type.washers:
        return [said("thrust bearing: carries axial load toward +x")]
    if bearing.bearing_type.has_arches:
        return [
            said(
                "four-point contact, shim angle {angle}; rows 0 and 1 are the contacts of the same"
                " balls that carry axial load toward +x and toward −x",
                angle=quantity(getattr(bearing, "shim_angle", 0.0), "angle"),
            )
        ]
    if not bearing.is_set:
        return []
    preload = [] if _own_offsets(bearing) else _preload(bearing.preload, bearing.contact_angle)
    return [_arrangement(bearing), *preload]


def _own_offsets(bearing: RollingBearing) -> bool:
    """Whether clamped rows are pressed in each by an offset of its own."""
    clamped = bearing.preload is None or bearing.preload.offset is not None
    offsets = {place.offset for place in bearing.places}
    return clamped and None not in offsets and len(offsets) > 1


def _arrangement(bearing: RollingBearing) -> str:
    places = bearing.places
    if bearing.rows_of_one_bearing > 1 and len({place.sign for place in places}) == 1:
        return said(
            "{count} rows in one bearing, {spacing} between them",
            count=len(places),
            spacing=quantity(bearing.spacing or 0.0, "length"),
        )
    if bearing.arrangement is not None:
        return said(
            "{name}, {kind} ({faces}), {spacing} between rows",
            name=bearing.arrangement,
            kind=_kind(bearing.arrangement),
            faces=" ".join(facing(bearing, place) for place in places),
            spacing=quantity(bearing.spacing or 0.0, "length"),
        )
    rows = ", ".join(_place(bearing, place) for place in places)
    if len(places) == 1:
        return said("1 row: {rows}", rows=rows)
    return said("{count} rows: {rows}", count=len(places), rows=rows)


def _kind(arrangement: str) -> str:
    if "B" in arrangement:
        return said("back to back")
    return said("face to face") if "F" in arrangement else said("in tandem")


def _place(bearing: RollingBearing, place: RowPlace) -> str:
    """One row of a list: its side, its place, and what it has of its own."""
    row, own = place.bearing, []
    if row.element != bearing.element:
        own += [_rollers(row), _between_rings(row)] if isinstance(row, RollerBearing) else []
        own += _balls(row) if isinstance(row, Bearing) else []
    else:
        own += _own_sizes(bearing, row)
    if place.offset is not None and _own_offsets(bearing):
        own.append(said("pressed in by {offset:.4 µm}", offset=place.offset))
    if place.phase != 0.0:
        own.append(said("phase {angle}", angle=quantity(place.phase, "angle")))
    where = said(
        "{face} at {position}",
        face=facing(bearing, place),
        position=quantity(place.position, "length"),
    )
    return where + (f" ({'; '.join(own)})" if own else "")


_SIZES: Final = (
    ("ball_diameter", "D"),
    ("roller_diameter", "D_we"),
    ("effective_length", "L_we"),
    ("pitch_diameter", "d_m"),
)


def _own_sizes(bearing: RollingBearing, row: RollingBearing) -> list[str]:
    """What a row of a list has of its own, if its elements are of the same kind."""
    own = []
    if row.element_count != bearing.element_count:
        rollers, count = row.element != "ball", row.element_count
        own.append(
            said("{count} rollers", count=count) if rollers else said("{count} balls", count=count)
        )
    for name, symbol in _SIZES:
        value = getattr(row, name, None)
        if value is not None and value != getattr(bearing, name, None):
            own.append(f"{symbol} {quantity(_short(value), 'length')}")
    if row.contact_angle is not None and row.contact_angle != bearing.contact_angle:
        own.append(f"α {quantity(row.contact_angle, 'angle')}")
    elif row.contact_angle is None and row.diametral_clearance != bearing.diametral_clearance:
        own.append(f"P_d {quantity(_short(row.diametral_clearance or 0.0), 'length')}")
    for name, symbol in (("inner_conformity", "f_i"), ("outer_conformity", "f_o")):
        if getattr(row, name, None) != getattr(bearing, name, None):
            own.append(f"{symbol} {manner().short(getattr(row, name))}")
    return own


def _short(value: float) -> float:
    """To six figures: a size that temperatures have changed has fifteen."""
    return float(f"{value:.6g}")


def _preload(preload: Preload | None, contact_angle: float | None) -> list[str]:
    if preload is None:
        return []
    if preload.level is not None:
        level = {
            "extra_light": said("extra light"),
            "light": said("light"),
            "medium": said("medium"),
            "heavy": said("heavy"),
        }
        text = said(
            "preload class {level} of {name} ({force} in a pair), clamped",
            level=level[preload.level],
            name=preload.designation or "",
            force=quantity(preload.pair_force(contact_angle) or nan, "force"),
        )
    elif preload.offset is not None:
        text = said("clamped, each row pressed in by {offset:.5 µm}", offset=preload.offset)
    elif preload.spring is not None:
        text = said("preload by springs of {force}", force=quantity(preload.spring, "force"))
    else:
        text = said("preload {force}, clamped", force=quantity(preload.force or 0.0, "force"))
    return [text]


# --- duty, model, status -----------------------------------------------------------------------


def _duty(duty: Duty) -> str:
    """Speeds, loads and displacements, as they were given."""
    speeds = []
    if duty.inner_speed != 0.0:
        speed = quantity(duty.inner_speed, "angular_speed")
        speeds.append(said("inner ring {speed}", speed=speed))
    if duty.outer_speed != 0.0:
        speed = quantity(duty.outer_speed, "angular_speed")
        speeds.append(said("outer ring {speed}", speed=speed))
    swing = duty.oscillation
    if swing is not None:
        values = {"angle": swing.angle, "frequency": swing.frequency}
        speeds.append(
            said("oscillates by {angle:.5 °}", **values)
            if swing.frequency is None
            else said("oscillates by {angle:.5 °} at {frequency:.4 Hz}", **values)
        )
    given = speeds or [said("at rest")]
    for axis, load in zip(AXES, LOADS, strict=True):
        shift = len(axis) == 1
        kinds: tuple[tuple[str, float | None, Dimension], ...] = (
            (load, getattr(duty.load, load), "force" if shift else "moment"),
            (axis, getattr(duty.displacement, axis), "length" if shift else "angle"),
        )
        given += [
            f"{name} {quantity(value, dimension)}"
            for name, value, dimension in kinds
            if value is not None
        ]
    return ", ".join(given)


_CONTROLS: Final = {
    "outer": marked("outer raceway control"),
    "inner": marked("inner raceway control"),
    "jones": marked("raceway control by Jones's criterion"),
    "none": marked("no raceway control: the races share the gyroscopic moment"),
    "friction": marked("ball motion governed by friction alone"),
}
_CAGES: Final = {
    "loose": marked("loose cage: it drives only balls that no race controls"),
    "rigid": marked("rigid cage: all balls orbit with it"),
    "none": marked("no cage: raceway control alone drives the balls"),
}


def model_text(case: Case) -> str:
    """Return the choices that matter: at rest, none but how a line of contact carries."""
    model, kinds = case.model, {place.bearing.element for place in case.bearing.places}
    texts = [] if kinds == {"ball"} else [_line_contact(case)]
    if case.duty.inner_speed == case.duty.outer_speed == 0.0:
        return ", ".join(texts)
    balls = "ball" in kinds  # rollers have no choice of control
    if balls:
        texts.append(said(_CONTROLS[model.raceway_control]))
    # the default is not said, nor anything under friction control, where the cage is always rigid
    if balls and model.cage != "loose" and model.raceway_control != "friction":
        texts.append(said(_CAGES[model.cage]))
    if not model.centrifugal_force:
        texts.append(said("no centrifugal force"))
    if balls and not model.gyroscopic_moment:
        texts.append(said("no gyroscopic moment"))
    return ", ".join(texts)


def _line_contact(case: Case) -> str:
    """How a line of contact carries: it decides on the life of rollers."""
    slices = case.model.slices
    if all(place.bearing.bearing_type.barrels for place in case.bearing.places):
        return said(
            "elliptical contacts, cut off at the rollers' ends by {slices} slices", slices=slices
        )
    if case.model.roller_contact == "coupled":
        return said("{slices} slices coupled by the elastic half-space", slices=slices)
    return said("{slices} independent slices (ISO/TS 16281)", slices=slices)


def no_load_text() -> str:
    """Say in the place of a status that a case has no load; what to give is for the note on it."""
    return said("no load is given yet: nothing to calculate")


def _status(solved: Solved) -> list[Entry]:
    """Return the status, and the advice if there is any."""
    status = solved.status
    if solved.converged[0] and nothing_given(solved):
        return [Entry(said("status"), no_load_text(), "warning-strong")]
    if solved.converged[0]:
        text = said(
            "✓ converged in {iterations} iterations, residual {residual:.1e}",
            iterations=int(status.iterations[0]),
            residual=float(status.residual[0]),
        )
        return [Entry(said("status"), text, "good")]
    advice = solved.advice[0]
    failed = Entry(said("status"), f"✗ {reason(str(status.code[0]))}", "bad-strong")
    return [failed, *([Entry(said("advice"), str(advice))] if advice else [])]
