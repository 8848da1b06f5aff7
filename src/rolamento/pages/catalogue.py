"""The pages of the catalogue: a list of bearings, and one with its internal geometry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from rolamento.catalogue import Candidate, CatalogueBearing, InternalGeometry, Origin, ball_name
from rolamento.document import (
    Block,
    CellContent,
    Column,
    Document,
    Entry,
    KeyValues,
    Number,
    Section,
    Statement,
    Table,
    Title,
    Tone,
)
from rolamento.words import manner, marked, said

__all__ = ["bearing_page", "search_page"]

_SHORT_NAMES: Final = {
    "dynamic_rating": "C", "static_rating": "C0", "f0": "f0",
    "axial_dynamic_rating": "Ca", "axial_static_rating": "C0a",
}  # fmt: skip
_KINDS: Final = {
    "deep_groove": marked("deep-groove ball bearing"),
    "angular_contact": marked("angular-contact ball bearing"),
    "double_row": marked("double-row angular-contact ball bearing"),
    "four_point": marked("four-point contact ball bearing"),
    "self_aligning": marked("self-aligning ball bearing"),
    "thrust": marked("single-direction thrust ball bearing"),
}
_OF_THRUST: Final = {
    "width": marked("height T"),
    "dynamic_rating": marked("dynamic axial load rating Ca"),
    "static_rating": marked("static axial load rating C0a"),
}
"""What the figures of a thrust bearing are called."""
_NAMES: Final = {
    "bore": marked("bore d"),
    "outside_diameter": marked("outside diameter D"),
    "width": marked("width B"),
    "contact_angle": marked("contact angle α"),
    "dynamic_rating": marked("dynamic load rating C"),
    "static_rating": marked("static load rating C0"),
    "axial_dynamic_rating": marked("dynamic axial load rating Ca"),
    "axial_static_rating": marked("static axial load rating C0a"),
    "load_centre_distance": marked("distance of the load centres"),
    "limiting_speed": marked("limiting speed, oil"),
    "f0": marked("factor f0"),
    "ball_count": marked("number of balls Z"),
    "ball_diameter": marked("ball diameter D"),
    "pitch_diameter": marked("pitch diameter d_m"),
    "inner_conformity": marked("inner conformity"),
    "outer_conformity": marked("outer conformity"),
    "diametral_clearance": marked("diametral clearance"),
    "ball_material": marked("material of the balls"),
    "shim_angle": marked("shim angle α_s"),
    "arrangement": marked("arrangement of the rows"),
    "spacing": marked("distance of the rows"),
}
_FORMS: Final = {  # figures and unit; of others a length
    "ball_count": (".5", ""),
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
_ORIGINS: Final[dict[Origin, str]] = {
    "published": marked("published"),
    "inferred": marked("inferred"),
    "assumed": marked("assumed"),
    "designation": marked("designation"),
}


def search_page(found: Sequence[CatalogueBearing], *, is_all: bool = True) -> Document:
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
        return Document(title, (Section(blocks=(Statement(said("no match")),)),), "catalogue")
    lengths = {"bore": "d", "outside_diameter": "D", "width": "B"}
    columns = (
        Column(head="", key="designation", values=[b.designation for b in found], tone="strong"),
        Column(head="", key="maker", values=[bearing.maker for bearing in found]),
        *(_column(found, name, head, "mm") for name, head in lengths.items()),
        _column(found, "contact_angle", "α", "°"),
        _column(found, "dynamic_rating", "C", "N"),
        _column(found, "static_rating", "C0", "N"),
        Column(head=said("balls"), key="balls", values=[_balls(b) for b in found], align="right"),
    )
    more = said("… and more: type more of the designation, or use --most")
    table = Table(columns=columns, key="bearings", legends=() if is_all else (more,))
    return Document(title, (Section(blocks=(table,), key="bearings"),), "catalogue")


def _column(found: Sequence[CatalogueBearing], name: str, head: str, unit: str) -> Column:
    values = [getattr(bearing, name) for bearing in found]
    return Column(head=head, key=name, values=values, unit=unit, form=f".5 [{unit}]", align="right")


def _balls(bearing: CatalogueBearing) -> str:
    if bearing.ball_count is None or bearing.ball_diameter is None:
        return ""
    diameter = manner().number(bearing.ball_diameter, ".5 mm")
    return f"{bearing.ball_count} × {diameter}"


def bearing_page(geometry: InternalGeometry) -> Document:
    """Return the page of one bearing.

    Parameters
    ----------
    geometry
        Its internal geometry; without balls if nothing is known of them.
    """
    bearing = geometry.bearing
    named = " ".join(part for part in (bearing.maker, bearing.designation) if part)
    title = f"{named}  {said(_KINDS[bearing.kind])}"
    head: list[Block] = [Title(title)]
    meanings = _meanings(geometry)
    entries = [Entry(said("designation"), "; ".join(meanings))] if meanings else []
    if geometry.idle:
        idle = ", ".join(part for part, _ in geometry.idle)
        entries.append(Entry(said("no effect on results"), idle))
    if entries:
        head.append(KeyValues(tuple(entries)))
    sections = [Section(blocks=tuple(head), key="head"), _published(bearing)]
    if "ball_count" not in geometry.fields:
        text = said(
            "Neither balls nor load ratings are published: give ball_count, ball_diameter and"
            " pitch_diameter, or the ratings with --dynamic and --static."
        )
        sections.append(Section(blocks=(Statement(text, "strong"),)))
    else:
        sections.append(_internal(geometry))
        if geometry.candidates:
            sections.append(_candidates(geometry.candidates))
    if geometry.sisters:
        sections.append(_sisters(geometry.sisters))
    return Document(named, tuple(sections), "catalogue")


def _sisters(sisters: Sequence[CatalogueBearing]) -> Section:
    """Bearings of the same size whose balls are published, and how to take one."""
    columns = (
        Column(head="", key="designation", values=[b.designation for b in sisters], tone="strong"),
        Column(head="", key="maker", values=[bearing.maker for bearing in sisters]),
        _column(sisters, "contact_angle", "α", "°"),
        Column(head="Z", key="ball_count", values=[b.ball_count for b in sisters], align="right"),
        _column(sisters, "ball_diameter", "D", "mm"),
        _column(sisters, "pitch_diameter", "d_m", "mm"),
        _column(sisters, "dynamic_rating", "C", "N"),
        _column(sisters, "static_rating", "C0", "N"),
    )
    legend = said(
        "Same bore, outside diameter and width, and about the same contact angle: to calculate with"
        ' one of them, give its designation, such as designation = "{name}".',
        name=sisters[0].designation,
    )
    table = Table(columns=columns, key="sisters", legends=(legend,))
    return Section(said("Bearings of the same size with published balls"), (table,), "sisters")


def _meanings(geometry: InternalGeometry) -> list[str]:
    """Say what the parts of the designation mean."""
    designation = geometry.designation
    parts = [f"{part}: {said(meaning)}" for part, meaning in designation.meanings]
    if geometry.clearance_class:
        parts.append(said("clearance class {name}", name=geometry.clearance_class))
    if designation.unknown:
        parts.append(said("not recognised: {parts}", parts=" ".join(designation.unknown)))
    return parts


def _published(bearing: CatalogueBearing) -> Section:
    names = _NAMES | _OF_THRUST if bearing.kind == "thrust" else _NAMES
    table = Table(
        columns=_named_figures(bearing.figures, names),
        key="published",
        headless=True,
        legends=tuple(dict.fromkeys(bearing.sources.values())),
    )
    return Section(said("Published data"), (table,), "published")


def _named_figures(
    figures: Mapping[str, float | str], names: Mapping[str, str] = _NAMES
) -> tuple[Column, ...]:
    """Return the columns of figures by their names: name, number, unit."""
    forms = [
        ("", "") if isinstance(value, str) else _FORMS.get(name, (".5", "mm"))
        for name, value in figures.items()
    ]
    numbers: list[CellContent] = [
        value if isinstance(value, str) else Number(value, f"{digits} [{unit}]" if unit else digits)
        for value, (digits, unit) in zip(figures.values(), forms, strict=True)
    ]
    return (
        Column(head="", key="quantity", values=[said(names[name]) for name in figures]),
        Column(head="", key="value", values=numbers, align="right"),
        Column(head="", key="unit", values=[unit for _, unit in forms], align="left"),
    )


def _internal(geometry: InternalGeometry) -> Section:
    told = {name: value for name, value in geometry.fields.items() if name != "kind"}
    origins = [geometry.origins[name] for name in told]
    tones: list[Tone] = ["" if origin == "published" else "warning" for origin in origins]
    sizes = [ball_name(value) if name == "ball_diameter" else "" for name, value in told.items()]
    columns = (
        *_named_figures(told),
        Column(head="", key="origin", values=[said(_ORIGINS[one]) for one in origins], tones=tones),
        Column(
            head="",
            key="size",
            values=["" if size.endswith("mm") else size for size in sizes],
            tone="faint",
        ),
    )
    blocks: list[Block] = [Table(columns=columns, key="internal_geometry", headless=True)]
    if geometry.is_inferred:
        first = geometry.candidates[0]
        figures = ", ".join(_SHORT_NAMES.get(name, name) for name in first.rests_on)
        text = said(
            "The internal geometry is inferred from {figures}, not published: carry the"
            " alternatives through every result that depends on it.",
            figures=figures,
        )
        blocks.append(Statement(text, "warning", indent=2))
        if not first.reproduces:
            text = said(
                "No standard ball size reproduces these ratings well: even the best candidates are"
                " doubtful."
            )
            blocks.append(Statement(text, "warning-strong", indent=2))
    return Section(said("Internal geometry"), tuple(blocks), "internal_geometry")


def _candidates(candidates: Sequence[Candidate]) -> Section:
    sizes = [ball_name(one.ball_diameter) for one in candidates]
    tones: list[Tone] = ["strong" if one.rank == 1 else "" for one in candidates]

    def column(
        head: str, key: str, values: Sequence[CellContent], form: str = "", unit: str = ""
    ) -> Column:
        own = f"{form} [{unit}]" if unit else form
        return Column(
            head=head, key=key, values=values, form=own, unit=unit, tones=tones, align="right"
        )

    def errors(head: str, key: str, form: str, unit: str = "") -> Column:
        return column(head, key, [getattr(one, key) for one in candidates], form, unit)

    low, high = zip(*(one.pitch_diameter_range for one in candidates), strict=True)
    misfits = [
        Number(one.misfit, ".1f", behind="" if one.reproduces else " ×") for one in candidates
    ]
    columns = (
        column("", "rank", [one.rank for one in candidates], ".5"),
        column("Z", "ball_count", [one.ball_count for one in candidates], ".5"),
        column("D", "ball_diameter", [one.ball_diameter for one in candidates], ".3f", "mm"),
        Column(
            head="",
            key="size",
            values=[size if size.endswith("in") else "" for size in sizes],
            tones=tones,
            align="left",
        ),
        column("d_m", "pitch_diameter", [one.pitch_diameter for one in candidates], ".1f", "mm"),
        column(said("from"), "pitch_diameter_low", [Number(x, ".1f [mm]") for x in low]),
        column(said("to"), "pitch_diameter_high", [Number(x, ".1f [mm]") for x in high]),
        column("f_i", "inner_conformity", [one.inner_conformity for one in candidates], ".4"),
        column("f_o", "outer_conformity", [one.outer_conformity for one in candidates], ".4"),
        errors("C", "dynamic_error", "+.1f", "%"),
        errors("C0", "static_error", "+.1f", "%"),
        errors("f0", "f0_error", "+.2f"),
        Column(head=said("misfit"), key="misfit", values=misfits, tones=tones, align="left"),
        column(said("share"), "weight", [one.weight for one in candidates], ".0f", "%"),
    )
    legend = said(
        "C, C0, f0: computed minus published; misfit up to 1: as good as the published digits; ×:"
        " one figure is off by more than three tolerances; share: of the likelihood; f_i, f_o: the"
        " most open grooves that the ratings allow."
    )
    table = Table(columns=columns, key="candidates", legends=(legend,), gap=1, units="behind")
    heading = said("Candidates that fit the ratings")
    return Section(heading, (table,), "candidates")
