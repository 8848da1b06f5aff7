"""The page of `static`: safeties, what makers recommend, hardness, launch loads and gaps."""

from __future__ import annotations

from math import isfinite, isinf
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento.pages.given import case_page, head, race_name
from rolamento.safety import rockwell_of_vickers
from rolamento.solved import RACES
from rolamento.words import ENDLESS, marked, said
from rolamento.words.sentences.static import OPERATIONS, REQUIREMENTS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rolamento.safety import StaticSafety

__all__ = ["static_page", "static_sections"]

_ALLOWED: Final = {
    "quiet": marked("mean pressure, has to run quietly afterwards"),
    "other": marked("mean pressure, need not run quietly"),
    "own": marked("maximum pressure, of the case"),
}
_MANY: Final = 1000.0
"""A safety from which on its size means nothing."""


def static_page(found: StaticSafety) -> doc.Document:
    """Return the static safety of one case.

    Parameters
    ----------
    found
        What `rolamento.safety.static_safety_of` gives, of a single case.
    """
    solved = found.solved
    notes = (*solved.notes[0], *found.notes)
    sections = static_sections(found) if solved.converged[0] else []
    return case_page(solved.case, head(solved), sections, "static", "static_safety", notes=notes)


def static_sections(found: StaticSafety, level: int = 2) -> list[doc.Section]:
    """Return the tables of the static safety of one case, for a page of its own or a report.

    Parameters
    ----------
    found
        As of `static_page`.
    level
        Of their headings.
    """
    return [
        doc.Section(said("Static safety"), _headline(found), "static", level),
        doc.Section("", (_contacts(found),), "static_contacts", level),
        *_bearings(found, level),
        _recommended(found, level),
        _launch(found, level),
        _hardening(found, level),
    ]


def _headline(found: StaticSafety) -> tuple[doc.Block, ...]:
    """State the minimum safety and where it is, beside what is recommended."""
    lowest = {by: float(found.minimum(by)[0]) for by in ("stress", "load")}
    row, race = _where(found)
    wanted = _wanted(found)
    tone: doc.Tone = "" if wanted is None else "good" if lowest["stress"] >= wanted else "warning"
    place = race_name(race)
    if len(found.limit) > 1:
        place = said("{race}, row {row}", race=place, row=row)
    entries = [
        doc.Entry(
            said("by stress"),
            said("{safety} ({place})", safety=_safety_text(lowest["stress"]), place=place),
            tone,
        )
    ]
    if isfinite(lowest["load"]):
        entries.append(doc.Entry(said("by load"), _safety_text(lowest["load"])))
    known = found.safety[0][np.isfinite(found.safety[0])]
    if known.size:
        entries.append(doc.Entry("C_0/P_0", _safety_text(float(known.min()))))
    if wanted is not None:
        name = next(one.maker for one in found.recommended if one.safety is not None)
        text = said(
            "{safety:.2} ({maker}: {operation}, {requirement})",
            safety=wanted,
            maker=name,
            operation=said(OPERATIONS[found.demands.operation]),
            requirement=said(REQUIREMENTS[found.demands.requirement]),
        )
        entries.append(doc.Entry(said("recommended"), text))
    if found.demands.load_factor != 1.0:
        factor = doc.Number(found.demands.load_factor, ".4")
        entries.append(doc.Entry(said("load factor"), factor))
    return (doc.KeyValues(tuple(entries)),)


def _wanted(found: StaticSafety) -> float | None:
    """Return the safety that the first maker recommends, of the kind that needs the most."""
    known = [one for one in found.recommended if one.safety is not None]
    first = [one.safety for one in known if one.maker == known[0].maker]
    return max((value for value in first if value is not None), default=None)


def _where(found: StaticSafety) -> tuple[int, str]:
    places = [
        (float(found.of_rows(race, "stress")[0, row]), row, race)
        for race in RACES
        for row in range(len(found.limit))
    ]
    _, row, race = min(places)
    return row, race


def _safety_text(value: float) -> str:
    if isinf(value):
        return ENDLESS
    return said("{value:.3}", value=value) if value < _MANY else said("more than 1000")


def _safety_cell(value: float) -> doc.CellContent:
    if isinf(value):
        return ENDLESS
    return doc.Number(value, ".3") if value < _MANY else doc.Number(_MANY, ".4", before="> ")


def _contacts(found: StaticSafety) -> doc.Table:
    rows = len(found.limit)
    lines = [(row, race) for row in range(rows) for race in RACES]
    hardening = found.hardening
    columns = []
    if rows > 1:
        columns.append(doc.Column(said("row"), [row for row, _ in lines], "row"))
    columns += [
        doc.Column("", [race_name(race) for _, race in lines], "race"),
        doc.Column(
            "p",
            [float(hardening[race].max_pressure[0, row]) for row, race in lines],
            "max_pressure",
            "MPa",
        ),
        doc.Column("p_lim", [float(found.limit[row]) for row, _ in lines], "pressure_limit", "MPa"),
        doc.Column(
            "S_p",
            [_safety_cell(float(found.of_rows(r, "stress")[0, row])) for row, r in lines],
            "safety_by_stress",
            align="right",
        ),
        doc.Column("Q_0", [float(found.load_limit[0, row]) for row, _ in lines], "load_limit", "N"),
        doc.Column(
            "S_Q",
            [_safety_cell(float(found.of_rows(r, "load")[0, row])) for row, r in lines],
            "safety_by_load",
            align="right",
        ),
    ]
    legends = (
        said("p_lim maximum pressure under C_0 (ISO 76:2006); S_p by stress: (p_lim/p)³, of lines"
             " (p_lim/p)²"),
        said("Q_0 load of the contact with the most load under C_0; S_Q by load: Q_0/Q"),
    )  # fmt: skip
    return doc.Table(tuple(columns), "static_safety", legends=legends, rule=True)


def _bearings(found: StaticSafety, level: int) -> list[doc.Section]:
    known = np.isfinite(found.safety[0])
    if not known.any():
        return []
    bearings = np.flatnonzero(known)
    columns = []
    if len(found.safety[0]) > 1:
        columns.append(doc.Column(said("bearing"), bearings.tolist(), "bearing"))
    columns += [
        doc.Column("C_0", found.rating[0][bearings].tolist(), "rating", "N"),
        doc.Column("P_0", found.equivalent_load[0][bearings].tolist(), "equivalent_load", "N"),
        doc.Column(
            "S_0",
            [_safety_cell(value) for value in found.safety[0][bearings].tolist()],
            "safety",
            align="right",
        ),
    ]
    table = doc.Table(tuple(columns), "static_bearings", rule=True)
    return [doc.Section(said("Bearing as a whole"), (table,), "static_bearings", level)]


def _recommended(found: StaticSafety, level: int) -> doc.Section:
    ones = found.recommended
    values: list[doc.CellContent] = [
        None
        if one.safety is None
        else doc.Number(one.safety, ".2", before="≥ " if one.at_least else "")
        for one in ones
    ]
    sources = [
        one.source if one.checked else said("{source}; general knowledge", source=one.source)
        for one in ones
    ]
    columns = (
        doc.Column("", [one.maker for one in ones], "maker"),
        doc.Column("S_0", values, "safety", align="right"),
        doc.Column(said("source"), sources, "source", tone="faint"),
    )
    text = said(
        "{operation}, {requirement}",
        operation=said(OPERATIONS[found.demands.operation]),
        requirement=said(REQUIREMENTS[found.demands.requirement]),
    )
    blocks = (doc.Statement(text, indent=2), doc.Table(columns, "static_recommended", rule=True))
    return doc.Section(said("Recommended by makers"), blocks, "static_recommended", level)


def _launch(found: StaticSafety, level: int) -> doc.Section:
    launch = found.launch
    blocks: list[doc.Block] = []
    if launch.allowables:
        ones = launch.allowables
        margins = [float(one.margin[0]) for one in ones]
        tones: list[doc.Tone] = ["good" if margin >= 0.0 else "bad" for margin in margins]
        pressures = [
            float((launch.max_pressure if one.key == "own" else launch.mean_pressure)[0])
            for one in ones
        ]
        columns = (
            doc.Column("", [said(_ALLOWED[one.key]) for one in ones], "limit"),
            doc.Column(said("pressure"), pressures, "pressure", "MPa"),
            doc.Column(said("allowable"), [one.pressure for one in ones], "allowable", "MPa"),
            doc.Column(
                "MoS",
                [doc.Number(margin, "+.2f") for margin in margins],
                "margin",
                tones=tones,
            ),
        )
        legends = [said("MoS margin of safety: allowable/pressure − 1")]
        if any(one.key != "own" for one in ones):
            legends.append(launch.source)
        blocks.append(doc.Table(columns, "static_launch", legends=tuple(legends), rule=True))
    blocks += _gaps(found)
    if not blocks:
        text = said("No allowable pressure is on file for this ring material; give"
                    " `static.allowable_pressure`.")  # fmt: skip
        blocks.append(doc.Statement(text, "faint", indent=2))
    return doc.Section(said("Allowable pressure and gaps"), tuple(blocks), "static_launch", level)


def _gaps(found: StaticSafety) -> list[doc.Block]:
    """Gaps of the rows, and at which multiple of the load a preloaded set opens."""
    solved, launch = found.solved, found.launch
    if len(found.limit) < 2:
        return []
    gaps: Sequence[float] = launch.gap[0].tolist()
    lost = [said("yes") if one else said("no") for one in launch.lost[0].tolist()]
    columns = (
        doc.Column(said("row"), list(range(len(gaps))), "row"),
        doc.Column(said("gap"), list(gaps), "gap", "µm", figures=3),
        doc.Column(said("all contact lost"), lost, "lost"),
    )
    legend = said("gap the maximum distance between a rolling element and its inner race")
    blocks: list[doc.Block] = [doc.Table(columns, "static_gaps", legends=(legend,), rule=True)]
    preload = solved.preload
    if preload is not None and preload.lift_factor is not None and isfinite(preload.lift_factor):
        text = said(
            "A rolling element first lifts off at {factor:.3} times this load.",
            factor=preload.lift_factor,
        )
        blocks.append(doc.Statement(text, indent=2))
    if preload is not None and preload.loss_factor is not None and isfinite(preload.loss_factor):
        text = said(
            "Row {row} loses all contact at {factor:.3} times this load.",
            row=preload.lost_row,
            factor=preload.loss_factor,
        )
        blocks.append(doc.Statement(text, indent=2))
    return blocks


def _hardening(found: StaticSafety, level: int) -> doc.Section:
    lines = [(row, race) for row in range(len(found.limit)) for race in RACES]
    own = found.hardening

    def column(name: str) -> list[float]:
        return [float(getattr(own[race], name)[0, row]) for row, race in lines]

    hardness = column("hardness")
    rockwell: list[doc.CellContent] = [
        value if isfinite(value) else None for value in rockwell_of_vickers(hardness).tolist()
    ]
    columns = []
    if len(found.limit) > 1:
        columns.append(doc.Column(said("row"), [row for row, _ in lines], "row"))
    columns += [
        doc.Column("", [race_name(race) for _, race in lines], "race"),
        doc.Column("τ_max", column("shear"), "max_shear", "MPa"),
        doc.Column(said("depth"), column("depth"), "max_shear_depth", "mm", figures=3, most=3),
        doc.Column("HV", hardness, "hardness", figures=3),
        doc.Column("HRC", rockwell, "rockwell", figures=3),
        doc.Column(said("case depth"), column("case_depth"), "case_depth", "mm", figures=3, most=3),
    ]
    legends = (
        said("HV, HRC hardness at which nothing yields at the depth of τ_max: 6 τ (Tabor, 1951;"
             " Tresca)"),
        said("case depth: there a core of {core:.3r} HV bears the stresses",
             core=own["inner"].core_hardness),
    )  # fmt: skip
    table = doc.Table(tuple(columns), "static_hardening", legends=legends, rule=True)
    return doc.Section(said("Hardness below the surface"), (table,), "static_hardening", level)
