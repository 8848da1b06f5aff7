"""The pages of the catalogue: a list of bearings, and one with its internal geometry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Final

from rolamento import document as doc
from rolamento.catalogue import (
    Candidate,
    CatalogueBearing,
    InternalGeometry,
    Origin,
    RollerCandidate,
    ball_name,
)
from rolamento.types import TYPES
from rolamento.words import manner, marked, said
from rolamento.words.quantities import CALLED

__all__ = ["KINDS", "bearing_page", "search_page"]

_SHORT_NAMES: Final = {
    "dynamic_rating": "C", "static_rating": "C_0", "f0": "f_0",
    "axial_dynamic_rating": "Ca", "axial_static_rating": "C0a",
    "inner_raceway_diameter": "F_w", "outer_raceway_diameter": "E_w", "axial_limit": "e",
}  # fmt: skip
KINDS: Final = {key: one.name for key, one in TYPES.items()}
_OF_THRUST: Final = {
    "width": marked("height T"),
    "dynamic_rating": CALLED["axial_dynamic_rating"],
    "static_rating": CALLED["axial_static_rating"],
}
"""What the figures of a thrust bearing are called."""
_OF_TAPERED: Final = {
    "width": marked("assembled width T"),
    "contact_angle": marked("contact angle α of the outer raceway"),
}
"""The same for a tapered roller bearing."""
_NAMES: Final = {
    "bore": marked("bore d"),
    "outside_diameter": marked("outside diameter D"),
    "width": marked("width B"),
    "contact_angle": marked("contact angle α"),
    "dynamic_rating": CALLED["dynamic_rating"],
    "static_rating": CALLED["static_rating"],
    "axial_dynamic_rating": CALLED["axial_dynamic_rating"],
    "axial_static_rating": CALLED["axial_static_rating"],
    "load_centre_distance": marked("distance of the load centres"),
    "limiting_speed": marked("limiting speed, oil"),
    "f0": marked("factor f_0"),
    "ball_count": marked("number of balls Z"),
    "ball_diameter": marked("ball diameter D"),
    "pitch_diameter": marked("pitch diameter d_m"),
    "inner_conformity": marked("inner conformity"),
    "outer_conformity": marked("outer conformity"),
    "inner_width": marked("width of the inner ring B"),
    "outer_width": marked("width of the outer ring C"),
    "inner_raceway_diameter": marked("inner raceway diameter F_w"),
    "outer_raceway_diameter": marked("outer raceway diameter E_w"),
    "axial_limit": marked("limit e"),
    "axial_factor": marked("axial factor Y"),
    "static_axial_factor": marked("static axial factor Y0"),
    "load_centre": marked("load centre a"),
    "fatigue_load_limit": CALLED["fatigue_load_limit"],
    "roller_count": marked("number of rollers Z"),
    "roller_diameter": marked("roller diameter D_we"),
    "effective_length": marked("effective roller length L_we"),
    "clearance_factor": marked("factor of the axial displacement k_2"),
    "outer_raceway_radius": marked("profile radius of the raceways"),
    "roller_half_angle": marked("half angle of the rollers φ"),
    "roller_end_radius": marked("radius of the roller ends"),
    "inner_ribs": marked("ribs of the inner ring"),
    "outer_ribs": marked("ribs of the outer ring"),
    "axial_play": marked("axial play between the ribs"),
    "diametral_clearance": marked("diametral clearance"),
    "ball_material": marked("material of the balls"),
    "shim_angle": marked("shim angle α_s"),
    "arrangement": marked("arrangement of the rows"),
    "spacing": marked("distance of the rows"),
}
_FORMS: Final = {  # figures and unit; of others a length
    "ball_count": (".5", ""),
    "roller_count": (".5", ""),
    "axial_limit": (".4", ""),
    "axial_factor": (".4", ""),
    "clearance_factor": (".4", ""),
    "static_axial_factor": (".4", ""),
    "fatigue_load_limit": (".5", "N"),
    "roller_half_angle": (".4", "°"),
    "roller_diameter": (".4", "mm"),
    "effective_length": (".4", "mm"),
    "contact_angle": (".4", "°"),
    "dynamic_rating": (".5", "N"),
    "static_rating": (".5", "N"),
    "axial_dynamic_rating": (".5", "N"),
    "axial_static_rating": (".5", "N"),
    "limiting_speed": (".5", "rpm"),
    "shim_angle": (".4", "°"),
    "spacing": (".4", "mm"),
    "f0": (".4", ""),
    "inner_conformity": (".4", ""),
    "outer_conformity": (".4", ""),
    "pitch_diameter": (".6", "mm"),
}
_RIBS: Final = {
    "none": marked("none"),
    "both": marked("at both ends"),
    "-": marked("at the end toward −x"),
    "+": marked("at the end toward +x"),
}
_ORIGINS: Final[dict[Origin, str]] = {
    "published": marked("published"),
    "inferred": marked("inferred"),
    "assumed": marked("assumed"),
    "designation": marked("designation"),
}


def search_page(found: Sequence[CatalogueBearing], *, is_all: bool = True) -> doc.Document:
    """Return the page of a list of bearings.

    Parameters
    ----------
    found
        Results of a search.
    is_all
        Whether the search found no more.
    """
    title = said("Bearings of the catalogue")
    if not found:
        return doc.Document(
            title, (doc.Section(blocks=(doc.Statement(said("no match")),)),), "catalogue"
        )
    lengths = {"bore": "d", "outside_diameter": "D", "width": "B"}
    columns = (
        doc.Column("", [b.designation for b in found], "designation", tone="strong"),
        doc.Column("", [bearing.maker for bearing in found], "maker"),
        *(_column(found, name, head, "mm") for name, head in lengths.items()),
        _column(found, "contact_angle", "α", "°"),
        _column(found, "dynamic_rating", "C", "N"),
        _column(found, "static_rating", "C_0", "N"),
        doc.Column(said("balls"), [_balls(b) for b in found], "balls", align="right"),
    )
    if all(bearing.has_rollers for bearing in found):
        names = {"inner_raceway_diameter": "F_w", "outer_raceway_diameter": "E_w"}
        raceways = [_column(found, name, head, "mm") for name, head in names.items()]
        told = [one for one in raceways if any(value is not None for value in one.values)]
        columns = (*columns[:5], *told, *columns[6:-1])
    more = said("… and more: type more of the designation, or use `most`")
    table = doc.Table(columns, "bearings", legends=() if is_all else (more,))
    return doc.Document(title, (doc.Section(blocks=(table,), key="bearings"),), "catalogue")


def _column(found: Sequence[CatalogueBearing], name: str, head: str, unit: str) -> doc.Column:
    values = [getattr(bearing, name) for bearing in found]
    return doc.Column(head, values, name, unit, form=f".5 [{unit}]", align="right")


def _balls(bearing: CatalogueBearing) -> str:
    if bearing.ball_count is None or bearing.ball_diameter is None:
        return ""
    diameter = manner().number(bearing.ball_diameter, ".5 mm")
    return f"{bearing.ball_count} × {diameter}"


def bearing_page(geometry: InternalGeometry) -> doc.Document:
    """Return the page of one bearing.

    Parameters
    ----------
    geometry
        Its internal geometry; without balls if nothing is known of them.
    """
    bearing = geometry.bearing
    named = " ".join(part for part in (bearing.maker, bearing.designation) if part)
    title = f"{named}  {said(KINDS[bearing.kind])}"
    head: list[doc.Block] = [doc.Title(title)]
    meanings = _meanings(geometry)
    entries = [doc.Entry(said("designation"), "; ".join(meanings))] if meanings else []
    if geometry.idle:
        idle = ", ".join(part for part, _ in geometry.idle)
        entries.append(doc.Entry(said("no effect on results"), idle))
    if entries:
        head.append(doc.KeyValues(tuple(entries)))
    head += [doc.Statement(note.text, "warning-strong") for note in geometry.notes]
    sections = [doc.Section(blocks=tuple(head), key="head"), _published(bearing)]
    if not geometry.has_elements and bearing.has_rollers:
        text = said(
            "Neither rollers nor load ratings are published: give roller_count, roller_diameter,"
            " effective_length and pitch_diameter, or the ratings with `dynamic` and `static`."
        )
        sections.append(doc.Section(blocks=(doc.Statement(text, "strong"),)))
    elif not geometry.has_elements:
        text = said(
            "Neither balls nor load ratings are published: give ball_count, ball_diameter and"
            " pitch_diameter, or the ratings with `dynamic` and `static`."
        )
        sections.append(doc.Section(blocks=(doc.Statement(text, "strong"),)))
    else:
        sections.append(_internal(geometry))
        rollers = [one for one in geometry.candidates if isinstance(one, RollerCandidate)]
        balls = [one for one in geometry.candidates if isinstance(one, Candidate)]
        if rollers:
            sections.append(_roller_candidates(rollers, tapered=bearing.type.conical))
        if balls:
            sections.append(_candidates(balls))
    if geometry.sisters:
        sections.append(_sisters(geometry.sisters))
    return doc.Document(named, tuple(sections), "catalogue")


def _sisters(sisters: Sequence[CatalogueBearing]) -> doc.Section:
    """Bearings of the same size whose balls are published, and how to take one."""
    columns = (
        doc.Column("", [b.designation for b in sisters], "designation", tone="strong"),
        doc.Column("", [bearing.maker for bearing in sisters], "maker"),
        _column(sisters, "contact_angle", "α", "°"),
        doc.Column("Z", [b.ball_count for b in sisters], "ball_count", align="right"),
        _column(sisters, "ball_diameter", "D", "mm"),
        _column(sisters, "pitch_diameter", "d_m", "mm"),
        _column(sisters, "dynamic_rating", "C", "N"),
        _column(sisters, "static_rating", "C_0", "N"),
    )
    legend = said(
        "Same bore, outside diameter and width, and about the same contact angle: to calculate with"
        ' one of them, give its designation, such as designation = "{name}".',
        name=sisters[0].designation,
    )
    table = doc.Table(columns, "sisters", legends=(legend,))
    return doc.Section(said("Bearings of the same size with published balls"), (table,), "sisters")


def _meanings(geometry: InternalGeometry) -> list[str]:
    """Say what the parts of the designation mean."""
    designation = geometry.designation
    parts = [f"{part}: {said(meaning)}" for part, meaning in designation.meanings]
    if geometry.clearance_class:
        parts.append(said("clearance class {name}", name=geometry.clearance_class))
    if designation.unknown:
        parts.append(said("not recognised: {parts}", parts=" ".join(designation.unknown)))
    return parts


def _published(bearing: CatalogueBearing) -> doc.Section:
    table = doc.Table(
        _named_figures(bearing.figures, _names_of(bearing)),
        "published",
        headless=True,
        legends=tuple(dict.fromkeys(bearing.sources.values())),
    )
    return doc.Section(said("Published data"), (table,), "published")


def _names_of(bearing: CatalogueBearing) -> Mapping[str, str]:
    if bearing.type.washers:
        return _NAMES | _OF_THRUST
    return _NAMES | _OF_TAPERED if bearing.type.conical else _NAMES


def _named_figures(
    figures: Mapping[str, float | str], names: Mapping[str, str] = _NAMES
) -> tuple[doc.Column, ...]:
    """Return the columns of figures by their names: name, number, unit."""
    forms = [
        ("", "") if isinstance(value, str) else _FORMS.get(name, (".5", "mm"))
        for name, value in figures.items()
    ]
    numbers: list[doc.CellContent] = [
        value
        if isinstance(value, str)
        else doc.Number(value, f"{digits} [{unit}]" if unit else digits)
        for value, (digits, unit) in zip(figures.values(), forms, strict=True)
    ]
    return (
        doc.Column("", [said(names[name]) for name in figures], "quantity"),
        doc.Column("", numbers, "value", align="right"),
        doc.Column("", [unit for _, unit in forms], "unit", align="left"),
    )


def _internal(geometry: InternalGeometry) -> doc.Section:
    hidden = ("kind", "element")
    told = {
        name: said(_RIBS[value]) if name.endswith("_ribs") else value
        for name, value in geometry.fields.items()
        if name not in hidden
    }
    origins = [geometry.origins[name] for name in told]
    tones: list[doc.Tone] = ["" if origin == "published" else "warning" for origin in origins]
    sizes = [ball_name(geometry.fields[name]) if name == "ball_diameter" else "" for name in told]
    columns = (
        *_named_figures(told, _names_of(geometry.bearing)),
        doc.Column("", [said(_ORIGINS[one]) for one in origins], "origin", tones=tones),
        doc.Column(
            "", ["" if size.endswith("mm") else size for size in sizes], "size", tone="faint"
        ),
    )
    blocks: list[doc.Block] = [doc.Table(columns, "internal_geometry", headless=True)]
    if geometry.is_inferred:
        first = geometry.candidates[0]
        figures = ", ".join(_SHORT_NAMES.get(name, name) for name in first.rests_on)
        text = said(
            "The internal geometry is inferred from {figures}, not published: carry the"
            " alternatives through every result that depends on it.",
            figures=figures,
        )
        blocks.append(doc.Statement(text, "warning", indent=2))
        if isinstance(first, RollerCandidate):
            blocks.append(doc.Statement(_how_sure(first), "faint", indent=2))
        elif not first.reproduces:
            text = said(
                "No standard ball size reproduces these ratings well: even the best candidates are"
                " doubtful."
            )
            blocks.append(doc.Statement(text, "warning-strong", indent=2))
    return doc.Section(said("Internal geometry"), tuple(blocks), "internal_geometry")


def _how_sure(first: RollerCandidate) -> str:
    """Say how far what is inferred of rollers holds."""
    if not first.reproduces:
        return said(
            "No standard roller size reproduces these ratings well: even the best candidates are"
            " doubtful."
        )
    if None in (first.dynamic_error, first.static_error):
        return said(
            "One rating alone does not tell the diameter of the rollers: it follows from the"
            " section, and their number from how full such bearings usually are."
        )
    return said(
        "C and C_0 tell the diameter of the rollers and the product Z·L_we within about a part in a"
        " hundred; the number of rollers follows from how full such bearings usually are."
    )


def _column_to_the_right(
    head: str,
    key: str,
    values: Sequence[doc.CellContent],
    form: str = "",
    unit: str = "",
    *,
    tones: Sequence[doc.Tone],
) -> doc.Column:
    own = f"{form} [{unit}]" if unit else form
    return doc.Column(head, values, key, unit, form=own, tones=tones, align="right")


def _roller_candidates(candidates: Sequence[RollerCandidate], *, tapered: bool) -> doc.Section:
    tones: list[doc.Tone] = ["strong" if one.rank == 1 else "" for one in candidates]

    column = partial(_column_to_the_right, tones=tones)

    def of(head: str, key: str, form: str, unit: str = "") -> doc.Column:
        return column(head, key, [getattr(one, key) for one in candidates], form, unit)

    def span(key: str) -> tuple[doc.Column, ...]:
        low, high = zip(*(getattr(one, f"{key}_range") for one in candidates), strict=True)
        return (
            column(said("from"), f"{key}_low", [doc.Number(x, ".2f [mm]") for x in low]),
            column(said("to"), f"{key}_high", [doc.Number(x, ".2f [mm]") for x in high]),
        )

    misfits = [
        doc.Number(one.misfit, ".1f", behind="" if one.reproduces else " ×") for one in candidates
    ]
    columns = (
        of("", "rank", ".5"),
        of("Z", "roller_count", ".5"),
        of("D_we", "roller_diameter", ".2f", "mm"),
        *(span("roller_diameter") if tapered else ()),
        of("L_we", "effective_length", ".2f", "mm"),
        *(span("effective_length") if tapered else ()),
        of("d_pw", "pitch_diameter", ".2f", "mm"),
        of(said("filling"), "filling", ".0f", "%"),
        of("C", "dynamic_error", "+.1f", "%"),
        of("C_0", "static_error", "+.1f", "%"),
        doc.Column(said("misfit"), misfits, "misfit", tones=tones, align="left"),
        of(said("share"), "weight", ".0f", "%"),
    )
    legend = said(
        "filling: part of the pitch circle that the rollers take; C, C_0: computed minus published;"
        " misfit up to 1: as good as usual; ×: one figure is off by more than three tolerances;"
        " share: of the likelihood."
    )
    table = doc.Table(columns, "candidates", legends=(legend,), gap=1, units="behind")
    return doc.Section(said("Candidates that fit the ratings"), (table,), "candidates")


def _candidates(candidates: Sequence[Candidate]) -> doc.Section:
    sizes = [ball_name(one.ball_diameter) for one in candidates]
    tones: list[doc.Tone] = ["strong" if one.rank == 1 else "" for one in candidates]

    column = partial(_column_to_the_right, tones=tones)

    def errors(head: str, key: str, form: str, unit: str = "") -> doc.Column:
        return column(head, key, [getattr(one, key) for one in candidates], form, unit)

    low, high = zip(*(one.pitch_diameter_range for one in candidates), strict=True)
    misfits = [
        doc.Number(one.misfit, ".1f", behind="" if one.reproduces else " ×") for one in candidates
    ]
    columns = (
        column("", "rank", [one.rank for one in candidates], ".5"),
        column("Z", "ball_count", [one.ball_count for one in candidates], ".5"),
        column("D", "ball_diameter", [one.ball_diameter for one in candidates], ".3f", "mm"),
        doc.Column(
            "",
            [size if size.endswith("in") else "" for size in sizes],
            "size",
            tones=tones,
            align="left",
        ),
        column("d_m", "pitch_diameter", [one.pitch_diameter for one in candidates], ".1f", "mm"),
        column(said("from"), "pitch_diameter_low", [doc.Number(x, ".1f [mm]") for x in low]),
        column(said("to"), "pitch_diameter_high", [doc.Number(x, ".1f [mm]") for x in high]),
        column("f_i", "inner_conformity", [one.inner_conformity for one in candidates], ".4"),
        column("f_o", "outer_conformity", [one.outer_conformity for one in candidates], ".4"),
        errors("C", "dynamic_error", "+.1f", "%"),
        errors("C_0", "static_error", "+.1f", "%"),
        errors("f_0", "f0_error", "+.2f"),
        doc.Column(said("misfit"), misfits, "misfit", tones=tones, align="left"),
        column(said("share"), "weight", [one.weight for one in candidates], ".0f", "%"),
    )
    legend = said(
        "C, C_0, f_0: computed minus published; misfit up to 1: as good as the published digits; ×:"
        " one figure is off by more than three tolerances; share: of the likelihood; f_i, f_o: the"
        " most open grooves that the ratings allow."
    )
    table = doc.Table(columns, "candidates", legends=(legend,), gap=1, units="behind")
    heading = said("Candidates that fit the ratings")
    return doc.Section(heading, (table,), "candidates")
